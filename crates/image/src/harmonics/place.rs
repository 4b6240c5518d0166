//! Where a direction points: colatitude and longitude.
//!
//! A minimax polynomial for the arctangent, to 2e-7 rad.
//! Left out: more digits; a texel is 10 000 times as wide.

use std::f32;

use glam::DVec3;

/// Where a direction points: colatitude and longitude in radians.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    pub colatitude: f32,
    pub longitude: f32,
}

impl Place {
    #[inline]
    pub fn towards(direction: DVec3) -> Self {
        let [x, y, z] = direction.to_array().map(|part| part as f32);
        Self { colatitude: angle((x * x + y * y).sqrt(), z), longitude: angle(y, x) }
    }
}

/// A direction of the scene as grids have it: their pole is the scene's zenith.
pub(crate) fn to_grid(direction: DVec3) -> DVec3 {
    DVec3::new(direction.z, direction.x, direction.y)
}

/// The way back.
pub(crate) fn from_grid(direction: DVec3) -> DVec3 {
    DVec3::new(direction.y, direction.z, direction.x)
}

/// The angle of (x, y) from the x axis, like atan2, to 2e-7 rad: a texel is 10 000 times as wide.
///
/// Without branches, since a picture asks for millions. The polynomial is the minimax fit of degree 15.
#[inline]
pub(crate) fn angle(y: f32, x: f32) -> f32 {
    let steep = y.abs() > x.abs();
    let (low, high) = if steep { (x.abs(), y.abs()) } else { (y.abs(), x.abs()) };
    let slope = low / (high + f32::MIN_POSITIVE);
    let square = slope * slope;
    let octant = ARCTANGENT.into_iter().rev().fold(0.0, |sum, c| sum * square + c) * slope;
    let quadrant = if steep { f32::consts::FRAC_PI_2 - octant } else { octant };
    let half = if x < 0.0 { f32::consts::PI - quadrant } else { quadrant };
    half.copysign(y)
}

/// Coefficients of t, t^3, t^5, ... in arctan(t) for t in 0..1.
const ARCTANGENT: [f32; 8] = [
    0.999_999_34,
    -0.333_298_6,
    0.199_465_6,
    -0.139_086_04,
    0.096_421_34,
    -0.055_911_49,
    0.021_862_392,
    -0.004_054_415,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angle_agrees_with_the_arctangent_of_libm() {
        for i in 0..720 {
            let (y, x) = (f64::from(i) * 0.5 + 0.25).to_radians().sin_cos();
            let error = f64::from(angle(y as f32, x as f32)) - libm::atan2(y, x);
            assert!(error.abs() < 4e-7, "at {y}, {x}: {error}");
        }
        assert!(angle(0.0, 0.0).abs() < 1e-30);
    }
}
