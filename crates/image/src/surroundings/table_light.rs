//! The soft light on a table around the pearls, as a light map.
//!
//! What `incident` tells at the nodes of two grids, a fine one near and a coarse one far off.
//! Left out: the shadows of lamps, whose edges are sharper than a grid.

use glam::DVec3;

use crate::{rgb::Rgb, shape::ball::Ball, surroundings::light_map::LightMap};

/// How finely the light on a table is worked out around the pearls, and how far.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reach {
    /// Steps for each radius of the smallest pearl.
    steps: f64,
    /// Around the pearls, in radii of the largest.
    radii: f64,
    /// Where straight lines over two or more steps are right to this share of the light, no point between is worked out.
    tolerance: f64,
}

/// Near the pearls: the contact shadow, which is as wide as a radius, is met within 0.8 % of the light, at its
/// darkest.
const NEAR: Reach = Reach { steps: 10.0, radii: 3.0, tolerance: TOLERANCE };
/// Farther off shadows are wide and weak: within 0.3 % of the light (the test below).
const FAR: Reach = Reach { steps: 2.0, radii: 40.0, tolerance: TOLERANCE };

/// A quarter of it is left then, far less than a step between 8-bit codes.
const TOLERANCE: f64 = 5e-4;

/// As a picture needs it, near and far.
pub(crate) const FINE: [Reach; 2] = [NEAR, FAR];
/// As a preview needs it, whose colours move by less than CIEDE2000 0.1 for it **(ours)**.
pub(crate) const ROUGH: [Reach; 2] =
    [Reach { steps: 5.0, tolerance: 2e-3, ..NEAR }, Reach { steps: 0.5, tolerance: 2e-3, ..FAR }];

/// A grid over pearls of very unlike sizes stays this small, 10 MB **(ours)**.
const MOST_CELLS: f64 = 400_000.0;

/// A light map of the table by x and z; `None` without pearls. `light` works out a point of the table.
pub(crate) fn light_map(
    balls: &[Ball],
    table_y_mm: f64,
    reach: Reach,
    light: impl Fn(DVec3) -> Rgb + Sync,
) -> Option<LightMap> {
    let least_mm = balls.iter().map(|ball| ball.radius_mm).reduce(f64::min)?;
    let margin_mm = reach.radii * balls.iter().map(|ball| ball.radius_mm).fold(0.0, f64::max);
    let end = |sign: f64, axis: fn(DVec3) -> f64| {
        let ends = balls.iter().map(|ball| sign * axis(ball.centre) + margin_mm);
        sign * ends.fold(f64::NEG_INFINITY, f64::max)
    };
    let axes: [fn(DVec3) -> f64; 2] = [|point| point.x, |point| point.z];
    let (corner, opposite) = (axes.map(|axis| end(-1.0, axis)), axes.map(|axis| end(1.0, axis)));
    let widths_mm = [0, 1].map(|i| opposite[i] - corner[i]);
    let finest_mm = (widths_mm[0] * widths_mm[1] / MOST_CELLS).sqrt();
    let step_mm = (least_mm / reach.steps).max(finest_mm);
    let counts = widths_mm.map(|width_mm| (width_mm / step_mm) as usize + 1);
    let at = |[x, z]: [f64; 2]| light(DVec3::new(x, table_y_mm, z));
    Some(LightMap::adaptive(corner, opposite, counts, reach.tolerance, at))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contact_shadows_are_met_near_and_far() {
        let ball = Ball::alone(4.0);
        let exact = |point: DVec3| [ball.sky_past(point), 1.0, 0.0];
        let near = light_map(&[ball], -4.0, NEAR, exact).unwrap();
        let far = light_map(&[ball], -4.0, FAR, exact).unwrap();
        let error = |chart: &LightMap, x: f64, z: f64| {
            (chart.at([x, z]).unwrap()[0] - exact(DVec3::new(x, -4.0, z))[0]).abs()
        };
        for i in 0..160 {
            let t = f64::from(i);
            assert!(error(&near, 0.07 * t, 0.031 * t) < 0.008, "{i}");
            assert!(error(&far, 8.0 + 0.9 * t, 12.0) < 0.003, "{i}");
        }
        assert_eq!(near.at([30.0, 0.0]), None);
        assert!(light_map(&[], 0.0, NEAR, exact).is_none());
    }
}
