//! Whether what is seen within an outline is what lies around it: a ring, not a pearl.

use std::f64::consts::TAU;

use libm::{cos, sin};

use crate::Picture;
use crate::contour::Contour;
use crate::edge::{distance, shade};

/// Directions, and where is looked in each, in shares of the outline's distance: within, near the rim, and beyond.
const RAYS: usize = 48;
const WITHIN: [f64; 4] = [0.0, 0.15, 0.3, 0.45];
const RIM: [f64; 4] = [0.75, 0.85, 0.92, 0.96];
const BEYOND: f64 = 1.12;
/// The least difference of shade between rim and surroundings that tells a ring, and the share of it up to which the inside
/// counts as the surroundings; in how much of the inside **(ours)**: a ball has shading, if not a lamp's image.
const LEAST: f64 = 0.05;
const SAME: f64 = 0.15;
const MOST_OF_IT: f64 = 0.97;

/// Whether it is.
pub fn is_hollow(picture: &Picture<'_>, contour: &Contour) -> bool {
    let at = |turn: f64, share: f64| {
        let away = share * contour.radius(turn);
        let (x, y) = (contour.middle.x_px, contour.middle.y_px);
        shade(picture.at(x + away * cos(turn), y + away * sin(turn)))
    };
    let turns = || (0..RAYS).map(|at| TAU * at as f64 / RAYS as f64);
    let mut around = [0.0; 3];
    for turn in turns() {
        let one = at(turn, BEYOND);
        for channel in 0..3 {
            around[channel] += one[channel] / RAYS as f64;
        }
    }
    let off = |turn: f64, share: f64| distance(at(turn, share), around);
    let rim = |turn: f64| RIM.iter().map(|share| off(turn, *share)).fold(0.0, f64::max);
    let contrast = turns().map(rim).sum::<f64>() / RAYS as f64;
    let same = turns()
        .flat_map(|turn| WITHIN.map(|share| off(turn, share)))
        .filter(|off| *off < SAME * contrast)
        .count();
    contrast > LEAST && same as f64 > MOST_OF_IT * (RAYS * WITHIN.len()) as f64
}
