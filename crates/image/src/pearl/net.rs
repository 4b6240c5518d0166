//! A net over the side of a pearl that the eye sees, even in angle.
//!
//! Knots by the normal's angle to the eye and its turn about that axis, in a square grid whose inner disc is what is seen.
//! Left out: what lies at the knots, and how it goes on between them.

use glam::DVec3;

use crate::harmonics::angle;

/// Knots by normals, of which the eye sees those within an angle of an axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Net {
    /// From the ball's centre to the eye, and two directions across.
    axis: DVec3,
    across: [DVec3; 2],
    /// Angle between the axis and the last points that the eye sees.
    reach_rad: f64,
    /// Knots from the middle to the edge of what is seen.
    half: usize,
}

/// Knots beyond the edge on each side, for cubics.
const BORDER: usize = 2;

impl Net {
    /// So that the eye sees normals within `reach_rad` of `axis`, with `half` steps from the middle to the edge.
    pub(crate) fn new((axis, reach_rad): (DVec3, f64), half: usize) -> Self {
        let (u, v) = axis.any_orthonormal_pair();
        Self { axis, across: [u, v], reach_rad, half }
    }

    /// Knots along a side.
    pub(crate) fn side(&self) -> usize {
        2 * (self.half + BORDER) + 1
    }

    /// Where the middle is, in knots.
    pub(crate) fn middle(&self) -> f64 {
        (self.half + BORDER) as f64
    }

    /// How far the edge of what is seen is from there.
    pub(crate) fn half(&self) -> f64 {
        self.half as f64
    }

    /// Angle from one knot to the next.
    pub(crate) fn step_rad(&self) -> f64 {
        self.reach_rad / self.half as f64
    }

    /// The normal at a knot, by its number in rows. Beyond the edge, where cubics need knots, the edge's goes on; `None`
    /// where none is needed.
    pub(crate) fn normal(&self, knot: usize) -> Option<DVec3> {
        let (column, row) = (knot % self.side(), knot / self.side());
        if !self.is_needed(column, row) {
            return None;
        }
        let at = |i: usize| (i as f64 - self.middle()) / self.half as f64;
        let (x, y) = (at(column), at(row));
        let radius = (x * x + y * y).sqrt();
        let (sin, cos) = libm::sincos(radius.min(1.0) * self.reach_rad);
        let outward = (self.across[0] * x + self.across[1] * y) / radius.max(1e-12);
        Some(self.axis * cos + outward * sin)
    }

    /// Whether a cubic for any place within the edge asks for a knot: it takes two to either side, aside and down.
    fn is_needed(&self, column: usize, row: usize) -> bool {
        let beyond = |i: usize| ((i as f64 - self.middle()).abs() - BORDER as f64).max(0.0);
        let (aside, down) = (beyond(column), beyond(row));
        (aside * aside + down * down).sqrt() < self.half() + 1e-6
    }

    /// Where a normal lies in the net, in knots aside and down.
    pub(crate) fn place(&self, normal: DVec3) -> [f64; 2] {
        let [u, v] = self.across.map(|axis| normal.dot(axis));
        let radius = libm::acos(normal.dot(self.axis).clamp(-1.0, 1.0)) / self.reach_rad;
        let scale = radius.min(1.0) * self.half as f64 / (u * u + v * v).sqrt().max(1e-12);
        let middle = self.middle();
        [middle + u * scale, middle + v * scale]
    }

    /// The same to 2e-7 rad, for many: libm's arc cosine works square roots out bit by bit in WebAssembly.
    pub(crate) fn place_in_single(&self, normal: DVec3) -> [f32; 2] {
        let [u, v] = self.across.map(|axis| normal.dot(axis) as f32);
        let sine = (u * u + v * v).sqrt();
        let radius = angle(sine, normal.dot(self.axis) as f32) / self.reach_rad as f32;
        let scale = radius.min(1.0) * self.half as f32 / (sine + f32::MIN_POSITIVE);
        let middle = self.middle() as f32;
        [middle + u * scale, middle + v * scale]
    }
}

/// Weights of four neighbours at a place between the middle two (Catmull and Rom 1974).
pub(crate) fn cubic(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [
        0.5 * (2.0 * t2 - t3 - t),
        0.5 * (3.0 * t3 - 5.0 * t2 + 2.0),
        0.5 * (4.0 * t2 - 3.0 * t3 + t),
        0.5 * (t3 - t2),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_knots_normal_lies_at_the_knot() {
        let net = Net::new((DVec3::new(0.6, 0.0, 0.8), 1.4), 12);
        for knot in 0..net.side() * net.side() {
            let Some(normal) = net.normal(knot) else { continue };
            if normal.dot(DVec3::new(0.6, 0.0, 0.8)) < libm::cos(1.4) + 1e-9 {
                continue; // the edge goes on
            }
            let [x, y] = net.place(normal);
            let (column, row) = (knot % net.side(), knot / net.side());
            assert!((x - column as f64).abs() < 1e-9 && (y - row as f64).abs() < 1e-9, "{knot}");
            let [x, y] = net.place_in_single(normal).map(f64::from);
            assert!((x - column as f64).abs() < 1e-4 && (y - row as f64).abs() < 1e-4, "{knot}");
        }
    }

    #[test]
    fn all_knots_that_a_cubic_asks_for_have_normals() {
        let net = Net::new((DVec3::Z, 1.4), 12);
        for i in 0..20_000 {
            let (sin, cos) = libm::sincos(f64::from(i));
            // To the edge and beyond it.
            let (aside, along) = libm::sincos(1.5 * f64::from(i % 100) / 99.0);
            let place = net.place(DVec3::new(aside * cos, aside * sin, along));
            let [left, top] = place.map(|x| x as usize);
            for (row, column) in (0..16).map(|k| (top + k / 4 - 1, left + k % 4 - 1)) {
                assert!(net.normal(row * net.side() + column).is_some(), "{place:?}");
            }
        }
    }
}
