//! The lamp's image: how bright, how wide, how it stands out, how its edge falls.

use std::f64::consts::{PI, TAU};

use libm::{acos, cos, sin, sqrt};
use serde::Serialize;

use crate::circle::angle;
use crate::disc::{Disc, Pixel};
use crate::value::{jackknife, median};
use crate::white::White;
use crate::{Circle, Picture, Value};

/// Beyond this share of the radius the rim's own mirroring is taken for no lamp.
const FARTHEST: f64 = 0.93;
/// The half of the box over which light is averaged before its peak is sought, in radii.
const SMOOTH: f64 = 0.02;
/// A peak below this many times the light around is no lamp's image **(ours)**.
const LEAST_CONTRAST: f64 = 1.25;
/// The widest image, half-width of the normal; wider is shading.
const WIDEST: f64 = 35.0 * PI / 180.0;
/// Directions around the image's middle, and groups of them that the jackknife leaves out.
const AZIMUTHS: usize = 72;
const GROUPS: usize = 12;
/// Off the half-level line: where distinctness compares, and where haze is read, of the normal.
/// 2.5 degrees are 5 of the mirrored light, as ASTM E430 has for haze.
const DISTINCT: f64 = PI / 180.0;
const HAZE: f64 = 2.5 * PI / 180.0;

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
}

/// Where the lamp is mirrored: what colours and blemishes leave out.
#[derive(Clone, Copy, Debug)]
pub struct Highlight {
    /// The normal at its middle.
    pub normal: [f64; 3],
    /// Radius of a cap as large as what is brighter than half.
    pub half_width: f64,
}

impl Highlight {
    /// Whether a place lies within the image and so many half-widths, or so many degrees, around it.
    pub fn covers(
        &self,
        circle: &Circle,
        (x, y): (f64, f64),
        widths: f64,
        beside_deg: f64,
    ) -> bool {
        let reach = (widths * self.half_width).max(self.half_width + beside_deg.to_radians());
        circle.normal(x, y).is_some_and(|normal| angle(normal, self.normal) < reach)
    }
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
    let Some(highlight) = cap(&pixels, circle, disc.factor) else {
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

/// The cap of the ball as large as some pixels of it, around their middle.
fn cap(pixels: &[&Pixel], circle: &Circle, factor: usize) -> Option<Highlight> {
    let (mut sum, mut area) = ([0.0; 3], 0.0);
    for normal in pixels.iter().filter_map(|pixel| circle.normal(pixel.place.0, pixel.place.1)) {
        let share = 1.0 / normal[2].max(0.1);
        area += share;
        for axis in 0..3 {
            sum[axis] += share * normal[axis];
        }
    }
    let length = sqrt(sum.iter().map(|part| part * part).sum());
    let side = factor as f64 / circle.radius_px;
    let half_width = acos((1.0 - area * side * side / TAU).max(-1.0));
    (length > 0.0).then(|| Highlight { normal: sum.map(|part| part / length), half_width })
}

/// One direction from the image's middle outwards.
struct Profile {
    turn: f64,
    /// Luminance in equal steps of angle.
    light: Vec<f64>,
    step: f64,
}

impl Profile {
    fn at(&self, away: f64) -> Option<f64> {
        let place = away / self.step;
        let first = place.max(0.0) as usize;
        let (one, other) = (self.light.get(first)?, self.light.get(first + 1)?);
        Some(one + (place.max(0.0) - first as f64) * (other - one))
    }

    /// Where light first falls below a level.
    fn falls_below(&self, level: f64) -> Option<f64> {
        let below = self.light.iter().position(|&light| light < level)?;
        let before = below.checked_sub(1)?;
        let part = (self.light[before] - level) / (self.light[before] - self.light[below]);
        Some(self.step * (before as f64 + part))
    }
}

fn profiles(
    picture: &Picture<'_>,
    white: &White,
    circle: &Circle,
    highlight: &Highlight,
) -> Vec<Profile> {
    let normal = highlight.normal;
    let [down, right] = across(normal);
    let step = 0.5 / circle.radius_px;
    let farthest = (3.0 * highlight.half_width + HAZE).min(1.2);
    (0..AZIMUTHS)
        .map(|at| {
            let turn = TAU * at as f64 / AZIMUTHS as f64;
            let (c, s) = (cos(turn), sin(turn));
            let mut light = Vec::new();
            for count in 0..(farthest / step) as usize {
                let (ca, sa) = (cos(step * count as f64), sin(step * count as f64));
                let one = [0, 1, 2].map(|i| ca * normal[i] + sa * (c * right[i] + s * down[i]));
                if one[2] <= 0.0 || one[0] * one[0] + one[1] * one[1] > FARTHEST * FARTHEST {
                    break;
                }
                let (x, y) = circle.place(one);
                light.push(white.luminance(picture.at(x, y)));
            }
            Profile { turn, light, step }
        })
        .collect()
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
    let above = peak - around.value;
    if above <= (LEAST_CONTRAST - 1.0) * around.value {
        return Err("no lamp's image stands out from the light around it".to_owned());
    }
    let profiles = profiles(picture, white, circle, highlight);
    let level = around.value + 0.5 * above;
    let mut widths = vec![Vec::new(); GROUPS];
    let mut falls = vec![Vec::new(); GROUPS];
    let mut hazes = vec![Vec::new(); GROUPS];
    let mut line = Vec::new();
    for (number, profile) in profiles.iter().enumerate() {
        let group = number * GROUPS / AZIMUTHS;
        let Some(width) = profile.falls_below(level) else { continue };
        widths[group].push(width * width);
        let of_peak = |away: f64| Some((profile.at(away)? - around.value) / above);
        if let (Some(inside), Some(outside)) =
            (of_peak(width - DISTINCT), of_peak(width + DISTINCT))
        {
            falls[group].push(inside - outside);
        }
        if let Some(light) = of_peak(width + HAZE) {
            hazes[group].push(light);
        }
        line.push(place_of(circle, highlight, profile.turn, width));
    }
    let found = widths.iter().map(Vec::len).sum::<usize>();
    if 10 * found < 7 * AZIMUTHS {
        return Err("the lamp's image runs into the outline".to_owned());
    }
    let percent = |groups: &[Vec<f64>]| {
        let enough = 2 * groups.iter().map(Vec::len).sum::<usize>() > AZIMUTHS;
        enough.then(|| mean_of(groups, |mean| 100.0 * mean))
    };
    let pixel = 1.0 / circle.radius_px;
    let (x_px, y_px) = circle.place(highlight.normal);
    let gloss = 100.0 * (1.0 - around.value / peak);
    let gloss_error = around.error.map_or(f64::NAN, |error| 100.0 * error / peak);
    Ok(LampImage {
        x_px,
        y_px,
        view_deg: acos(highlight.normal[2].min(1.0)).to_degrees(),
        peak,
        around,
        half_width_deg: mean_of(&widths, |mean| sqrt(mean).to_degrees()),
        contrast_gloss: Value::new(gloss, gloss_error),
        haze: percent(&hazes),
        // Less than a pixel to both sides would measure the camera.
        distinctness: if pixel <= DISTINCT { percent(&falls) } else { None },
        line,
    })
}

/// Two directions across a normal; which way they turn does not matter.
fn across(normal: [f64; 3]) -> [[f64; 3]; 2] {
    let flat = sqrt(normal[1] * normal[1] + normal[2] * normal[2]);
    let down = [0.0, normal[2] / flat, -normal[1] / flat];
    let right = [
        normal[1] * down[2] - normal[2] * down[1],
        normal[2] * down[0] - normal[0] * down[2],
        normal[0] * down[1] - normal[1] * down[0],
    ];
    [down, right]
}

fn place_of(circle: &Circle, highlight: &Highlight, turn: f64, away: f64) -> [f64; 2] {
    let normal = highlight.normal;
    let [down, right] = across(normal);
    let (c, s, ca, sa) = (cos(turn), sin(turn), cos(away), sin(away));
    let (x, y) =
        circle.place([0, 1, 2].map(|i| ca * normal[i] + sa * (c * right[i] + s * down[i])));
    [x, y]
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
