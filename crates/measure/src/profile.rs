//! Light along lines from the lamp image's middle outwards, by the angle of the surface's normal.

use std::f64::consts::{PI, TAU};

use libm::{cos, sin, sqrt};

use crate::highlight::{FARTHEST, Highlight};
use crate::white::White;
use crate::{Circle, Picture};

/// Directions around the image's middle.
pub const AZIMUTHS: usize = 72;
/// How far off the half-level line haze is read, of the normal: 2.5 degrees are 5 of the mirrored light, as ASTM E430
/// has for haze.
pub const HAZE: f64 = 2.5 * PI / 180.0;

/// One direction from the image's middle outwards.
pub struct Profile {
    pub turn: f64,
    /// Luminance in equal steps of angle.
    light: Vec<f64>,
    step: f64,
}

impl Profile {
    /// Light so far from the middle.
    pub fn at(&self, away: f64) -> Option<f64> {
        let place = away / self.step;
        let first = place.max(0.0) as usize;
        let (one, other) = (self.light.get(first)?, self.light.get(first + 1)?);
        Some(one + (place.max(0.0) - first as f64) * (other - one))
    }

    /// Where light first falls below a level.
    pub fn falls_below(&self, level: f64) -> Option<f64> {
        let below = self.light.iter().position(|&light| light < level)?;
        let before = below.checked_sub(1)?;
        let part = (self.light[before] - level) / (self.light[before] - self.light[below]);
        Some(self.step * (before as f64 + part))
    }
}

/// The profiles in all directions, as far as the pearl goes.
pub fn profiles(
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

/// Degrees from the middle, and the mean light over directions, while half of all have some.
pub fn mean_profile(profiles: &[Profile]) -> Vec<[f64; 2]> {
    let mean = |count: usize| {
        let held: Vec<f64> =
            profiles.iter().filter_map(|one| one.light.get(count).copied()).collect();
        let light = held.iter().sum::<f64>() / held.len() as f64;
        (2 * held.len() >= profiles.len())
            .then(|| [profiles[0].step.to_degrees() * count as f64, light])
    };
    (0..).map_while(mean).collect()
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

/// The place, in pixels, so far from a normal in one direction.
pub fn place_of(circle: &Circle, normal: [f64; 3], turn: f64, away: f64) -> [f64; 2] {
    let [down, right] = across(normal);
    let (c, s, ca, sa) = (cos(turn), sin(turn), cos(away), sin(away));
    let (x, y) =
        circle.place([0, 1, 2].map(|i| ca * normal[i] + sa * (c * right[i] + s * down[i])));
    [x, y]
}
