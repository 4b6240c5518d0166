//! The lamp's image: how bright, how wide, how it stands out, how its edge falls.

use std::f64::consts::{PI, TAU};

use libm::{acos, sqrt};
use serde::Serialize;

use crate::circle::angle;
use crate::disc::{Disc, Pixel};
use crate::highlight::{FARTHEST, Highlight};
use crate::profile::{AZIMUTHS, HAZE, Profile, mean_profile, place_of, profiles};
use crate::value::{jackknife, median};
use crate::white::White;
use crate::{Circle, Picture, Value};

/// The half of the box over which light is averaged before its peak is sought, in radii.
const SMOOTH: f64 = 0.02;
/// A peak below this many times the light around is no lamp's image **(ours)**.
const LEAST_CONTRAST: f64 = 1.25;
/// The widest image, half-width of the normal; wider is shading.
const WIDEST: f64 = 35.0 * PI / 180.0;
/// The narrowest image, from its middle to half level, in pixels: at half of that, in a picture of half the size, width and
/// peak are off by 9 to 18 %; from here on by less than 5 (`tests/measure/changes.py`).
const NARROWEST_PX: f64 = 3.5;
/// Groups of directions that the jackknife leaves out.
const GROUPS: usize = 12;
/// Off the half-level line, to both sides, distinctness compares: of the normal.
const DISTINCT: f64 = PI / 180.0;

/// The lamp's image in a pearl. Angles are those of the surface's normal.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LampImage {
    /// Its middle, in pixels.
    pub x_px: f64,
    /// Its middle, downwards.
    pub y_px: f64,
    /// The view angle of its middle, in degrees.
    pub view_deg: f64,
    /// Luminance at its brightest; a white matt surface as light as the stated white has 1.
    pub peak: f64,
    /// Luminance around it, where the lamp is not mirrored.
    pub around: Value,
    /// From its middle to half of the peak above what is around: root mean square over directions.
    pub half_width_deg: Value,
    /// 1 - around / peak, in percent (Hunter's contrast gloss).
    pub contrast_gloss: Value,
    /// Light 2.5 degrees beyond the half-level line, in percent of the peak above what is around.
    pub haze: Option<Value>,
    /// Fall within a degree to both sides of the half-level line, in percent of the same.
    pub distinctness: Option<Value>,
    /// Places of the half-level line, in pixels.
    pub line: Vec<[f64; 2]>,
    /// From its middle outwards: degrees, and the mean luminance over directions; as far as the pearl goes in half of them.
    pub profile: Vec<[f64; 2]>,
}

/// What the search for the image finds, measured or not.
pub struct Found {
    /// Where it is, if anywhere.
    pub highlight: Option<Highlight>,
    /// The image, or why it is not measured.
    pub image: Result<LampImage, String>,
}

/// Finds the lamp's image on a ball and measures it.
pub fn lamp_image(picture: &Picture<'_>, white: &White, disc: &Disc, circle: &Circle) -> Found {
    let refused = |reason: &str| Found { highlight: None, image: Err(reason.to_owned()) };
    let reach = (SMOOTH * circle.radius_px / disc.factor as f64).round().max(1.0) as usize;
    let light = smoothed(&luminance(disc), disc.width, reach);
    let mut all: Vec<f64> = light.iter().flatten().copied().collect();
    let around = median(&mut all);
    let brightest = (0..light.len()).filter(|&at| light[at].is_some());
    let Some(top) = brightest.max_by(|&one, &other| {
        light[one].partial_cmp(&light[other]).unwrap_or(std::cmp::Ordering::Equal)
    }) else {
        return refused("the pearl is too small");
    };
    // What the box takes off a peak, it takes off again when it is laid on twice.
    let twice = smoothed(&light, disc.width, reach);
    let peak = 2.0 * light[top].unwrap_or(0.0) - twice[top].unwrap_or(0.0);
    if !(peak > LEAST_CONTRAST * around.max(0.0) && peak > 0.0) {
        return refused("no lamp's image stands out from the light around it");
    }
    let patch = patch(&light, disc.width, top, f64::midpoint(peak, around));
    let pixels: Vec<&Pixel> = patch.iter().filter_map(|&at| disc.pixels[at].as_ref()).collect();
    let Some(highlight) = Highlight::cap(&pixels, circle, disc.factor) else {
        return refused("no lamp's image stands out from the light around it");
    };
    let clipped = pixels.iter().filter(|pixel| pixel.clipped).count();
    let percent = (100 * clipped).div_ceil(pixels.len());
    let ends = format!("the highlight is clipped in {percent} % of its pixels");
    let on_rim = pixels.iter().filter(|pixel| pixel.away > FARTHEST - 0.04).count();
    if highlight.half_width > WIDEST || 5 * on_rim > pixels.len() {
        let runs = "the brightest light runs into the outline, or over much of the pearl";
        return refused(if clipped > 0 { &ends } else { runs });
    }
    if clipped > 0 {
        return Found { highlight: Some(highlight), image: Err(ends) };
    }
    let image = measured(picture, white, disc, circle, &highlight, peak, around);
    Found { highlight: Some(highlight), image }
}

/// Luminance where the lamp may be mirrored.
fn luminance(disc: &Disc) -> Vec<Option<f64>> {
    let light =
        |pixel: &Option<Pixel>| pixel.filter(|one| one.away < FARTHEST).map(|one| one.xyz[1]);
    disc.pixels.iter().map(light).collect()
}

/// Means over a box of `2 reach + 1` places a side, along rows and then along columns; holes stay.
fn smoothed(light: &[Option<f64>], width: usize, reach: usize) -> Vec<Option<f64>> {
    let along = |light: &[Option<f64>], step: usize| -> Vec<Option<f64>> {
        let mean = |at: usize| {
            light[at]?;
            let (mut sum, mut count) = (0.0, 0.0);
            // The disc lies clear of the picture's border by more than it is averaged over, or ends there.
            for place in 0..=2 * reach {
                let near = (at + place * step).checked_sub(reach * step);
                if let Some(one) = near.and_then(|near| *light.get(near)?) {
                    sum += one;
                    count += 1.0;
                }
            }
            Some(sum / count)
        };
        (0..light.len()).map(mean).collect()
    };
    along(&along(light, 1), width)
}

/// The pixels around `top` that hang together and are brighter than `level`.
fn patch(light: &[Option<f64>], width: usize, top: usize, level: f64) -> Vec<usize> {
    let mut taken = vec![false; light.len()];
    let (mut found, mut next) = (Vec::new(), vec![top]);
    taken[top] = true;
    while let Some(at) = next.pop() {
        found.push(at);
        for near in [at.wrapping_sub(1), at + 1, at.wrapping_sub(width), at + width] {
            if light.get(near).is_some_and(|one| one.is_some_and(|one| one > level)) && !taken[near]
            {
                taken[near] = true;
                next.push(near);
            }
        }
    }
    found
}

/// Light between three and four half-widths from the middle, where enough of the pearl lies there.
fn light_around(disc: &Disc, circle: &Circle, highlight: &Highlight, otherwise: f64) -> Value {
    let mut groups = vec![Vec::new(); GROUPS];
    let (near, far) = (3.0 * highlight.half_width, 4.0 * highlight.half_width);
    let near = near.max(highlight.half_width + 2.0 * HAZE);
    let far = far.max(near + 2.0 * HAZE);
    for pixel in disc.pixels.iter().flatten().filter(|pixel| pixel.away < FARTHEST) {
        let Some(normal) = circle.normal(pixel.place.0, pixel.place.1) else { continue };
        if (near..far).contains(&angle(normal, highlight.normal)) {
            let (right, down) = (normal[0] - highlight.normal[0], normal[1] - highlight.normal[1]);
            let turn = (libm::atan2(down, right) / TAU).rem_euclid(1.0);
            groups[((turn * GROUPS as f64) as usize).min(GROUPS - 1)].push(pixel.xyz[1]);
        }
    }
    let held = groups.iter().filter(|group| group.len() > 5).count();
    if held < GROUPS / 3 {
        return Value { value: otherwise, error: None };
    }
    let all = |left_out: usize| {
        let kept = groups.iter().enumerate().filter(|(at, _)| *at != left_out);
        median(&mut kept.flat_map(|(_, group)| group.iter().copied()).collect::<Vec<f64>>())
    };
    let left_out: Vec<f64> = (0..GROUPS).map(all).collect();
    Value::new(all(GROUPS), jackknife(&left_out))
}

fn measured(
    picture: &Picture<'_>,
    white: &White,
    disc: &Disc,
    circle: &Circle,
    highlight: &Highlight,
    peak: f64,
    otherwise: f64,
) -> Result<LampImage, String> {
    let around = light_around(disc, circle, highlight, otherwise);
    if peak - around.value <= (LEAST_CONTRAST - 1.0) * around.value {
        return Err("no lamp's image stands out from the light around it".to_owned());
    }
    let profiles = profiles(picture, white, circle, highlight);
    let read = Readings::of(&profiles, around.value, peak);
    if 10 * read.half_level.len() < 7 * AZIMUTHS {
        return Err("the lamp's image runs into the outline".to_owned());
    }
    let pixel = 1.0 / circle.radius_px;
    let half_width_deg = read.half_width_deg(circle)?;
    let (x_px, y_px) = circle.place(highlight.normal);
    let gloss = 100.0 * (1.0 - around.value / peak);
    let gloss_error = around.error.map_or(f64::NAN, |error| 100.0 * error / peak);
    let on_line = |&(turn, away): &(f64, f64)| place_of(circle, highlight.normal, turn, away);
    Ok(LampImage {
        x_px,
        y_px,
        view_deg: acos(highlight.normal[2].min(1.0)).to_degrees(),
        peak,
        around,
        half_width_deg,
        contrast_gloss: Value::new(gloss, gloss_error),
        haze: percent(&read.hazes),
        // Less than a pixel to both sides would measure the camera.
        distinctness: if pixel <= DISTINCT { percent(&read.falls) } else { None },
        line: read.half_level.iter().map(on_line).collect(),
        profile: mean_profile(&profiles),
    })
}

/// Numbers by groups of directions.
type Groups = Vec<Vec<f64>>;

/// What the profiles show, by groups of directions that the jackknife leaves out.
struct Readings {
    /// Squares of angles from the middle to half level.
    widths: Groups,
    /// Falls across that level, and light beyond it, in shares of the peak above what is around.
    falls: Groups,
    hazes: Groups,
    /// Directions, and how far half level lies away in them.
    half_level: Vec<(f64, f64)>,
}

impl Readings {
    fn of(profiles: &[Profile], around: f64, peak: f64) -> Self {
        let empty = || vec![Vec::new(); GROUPS];
        let mut read =
            Self { widths: empty(), falls: empty(), hazes: empty(), half_level: Vec::new() };
        let above = peak - around;
        for (number, profile) in profiles.iter().enumerate() {
            let group = number * GROUPS / AZIMUTHS;
            let Some(width) = profile.falls_below(around + 0.5 * above) else { continue };
            read.widths[group].push(width * width);
            let of_peak = |away: f64| Some((profile.at(away)? - around) / above);
            let aside = (of_peak(width - DISTINCT), of_peak(width + DISTINCT));
            if let (Some(inside), Some(outside)) = aside {
                read.falls[group].push(inside - outside);
            }
            read.hazes[group].extend(of_peak(width + HAZE));
            read.half_level.push((profile.turn, width));
        }
        read
    }

    /// Root mean square over directions; refused where it is so few pixels that they would be measured.
    fn half_width_deg(&self, circle: &Circle) -> Result<Value, String> {
        let half_width_deg = mean_of(&self.widths, |mean| sqrt(mean).to_degrees());
        let wide_px = half_width_deg.value.to_radians() * circle.radius_px;
        if wide_px < NARROWEST_PX {
            return Err(format!(
                "the lamp's image is {wide_px:.1} pixels wide from its middle to half level; wanted: {NARROWEST_PX} or more, in a larger picture"
            ));
        }
        Ok(half_width_deg)
    }
}

/// The mean of shares in percent, where half of all directions have one.
fn percent(groups: &Groups) -> Option<Value> {
    let enough = 2 * groups.iter().map(Vec::len).sum::<usize>() > AZIMUTHS;
    enough.then(|| mean_of(groups, |mean| 100.0 * mean))
}

/// What follows from the mean of some groups, with its jackknife over them.
fn mean_of(groups: &[Vec<f64>], then: impl Fn(f64) -> f64) -> Value {
    let mean = |left_out: usize| {
        let kept = groups.iter().enumerate().filter(|(at, _)| *at != left_out);
        let (sum, count) = kept
            .flat_map(|(_, group)| group)
            .fold((0.0, 0.0), |(sum, count), one| (sum + one, count + 1.0));
        then(sum / count)
    };
    let held = (0..groups.len()).filter(|&at| !groups[at].is_empty());
    let left_out: Vec<f64> = held.map(mean).collect();
    Value::new(mean(groups.len()), jackknife(&left_out))
}
