//! Where on a ball the lamp is mirrored.

use std::f64::consts::TAU;

use libm::{acos, sqrt};

use crate::Circle;
use crate::circle::angle;
use crate::disc::Pixel;

/// Beyond this share of the radius the rim's own mirroring is taken for no lamp.
pub const FARTHEST: f64 = 0.93;

/// Where the lamp is mirrored: what colours and blemishes leave out.
#[derive(Clone, Copy, Debug)]
pub struct Highlight {
    /// The normal at its middle.
    pub normal: [f64; 3],
    /// Radius of a cap as large as what is brighter than half.
    pub half_width: f64,
}

impl Highlight {
    /// The cap of the ball as large as some pixels of it, around their middle.
    pub fn cap(pixels: &[&Pixel], circle: &Circle, factor: usize) -> Option<Self> {
        let (mut sum, mut area) = ([0.0; 3], 0.0);
        for normal in pixels.iter().filter_map(|pixel| circle.normal(pixel.place.0, pixel.place.1))
        {
            let share = 1.0 / normal[2].max(0.1);
            area += share;
            for axis in 0..3 {
                sum[axis] += share * normal[axis];
            }
        }
        let length = sqrt(sum.iter().map(|part| part * part).sum());
        let side = factor as f64 / circle.radius_px;
        let half_width = acos((1.0 - area * side * side / TAU).max(-1.0));
        (length > 0.0).then(|| Self { normal: sum.map(|part| part / length), half_width })
    }

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
