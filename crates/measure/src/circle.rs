//! A circle in the picture, and directions on the ball behind it.

use libm::{acos, sqrt};
use serde::Serialize;

/// A circle in pixels from the outer corner of the first one, y down.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Circle {
    /// Its middle, to the right.
    pub x_px: f64,
    /// Its middle, downwards.
    pub y_px: f64,
    /// Its radius.
    pub radius_px: f64,
}

impl Circle {
    /// The surface's normal [right, down, towards the eye] at a place of the picture, if on the ball.
    pub(crate) fn normal(&self, x: f64, y: f64) -> Option<[f64; 3]> {
        let right = (x - self.x_px) / self.radius_px;
        let down = (y - self.y_px) / self.radius_px;
        let depth = 1.0 - right * right - down * down;
        (depth > 0.0).then(|| [right, down, sqrt(depth)])
    }

    /// Where a normal is seen.
    pub(crate) fn place(&self, normal: [f64; 3]) -> (f64, f64) {
        (self.x_px + self.radius_px * normal[0], self.y_px + self.radius_px * normal[1])
    }
}

/// The angle between two unit vectors.
pub fn angle(first: [f64; 3], second: [f64; 3]) -> f64 {
    let cosine = first[0] * second[0] + first[1] * second[1] + first[2] * second[2];
    acos(cosine.clamp(-1.0, 1.0))
}
