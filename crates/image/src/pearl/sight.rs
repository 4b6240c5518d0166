//! A point of a pearl under the eye.
//!
//! Filled in by whoever looks.
//! Left out: the light there, which is the shade.

use glam::DVec3;

use crate::{
    coat::local::Local, pearl::reflection_cache::Arounds, rgb::Rgb, shape::ball::Hit,
    view::cone::Cone,
};

/// A point of a pearl under the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// The pearl's number among the balls.
    pub ball: usize,
    /// The point, with the normal of its relief.
    pub hit: Hit,
    /// The direction from the pearl's middle to the point.
    pub outward: DVec3,
    /// What the outer layers are like there.
    pub local: Local,
    /// Grain in hue, value, chroma there, where it is known already.
    pub grain: Option<Rgb>,
    /// Towards the eye.
    pub view: DVec3,
    /// The width on the pearl that a pixel stands for.
    pub pixel_mm: f64,
    /// What the line of sight stands for once it is mirrored.
    pub spread: Spread,
    /// Which part of the light around this sample looks at, of how many: a pixel's samples share it out.
    pub part: (usize, usize),
    /// What all facets show of the surroundings, where that is known.
    pub around: Arounds,
}

/// A cone whose solid angles, as wide and as narrow as it, differ by less than this ratio is round; by eye **(ours)**.
const ROUND: f64 = 1.3;

/// Full angle of a cone, over the standard deviation of the normals that mirror it.
const FULL_ANGLE: f64 = 8.0;

/// Full angles of the directions that an even pearl mirrors to some width of the picture.
///
/// A ball spreads all of its disc evenly over all directions, so a pixel gets the same solid angle everywhere, at the
/// rim as a long thin stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// In the plane of view and normal.
    pub outward_rad: f64,
    /// Across that plane.
    pub around_rad: f64,
}

impl Spread {
    /// Of a square `width` wide, in units of the ball's radius, around a point of a view angle.
    ///
    /// A mirrored ray turns by twice the normal's angle, whose sine is the place on the disc: between depths below the rim
    /// of half the width more and less, no less than none, the cosine's square differs by twice the width.
    pub fn of_square(width: f64, cos_view: f64) -> Self {
        Self::of_bent(width, cos_view, [1.0; 2])
    }

    /// The same where the surface is `bend` times as curved as a ball's, outward and around.
    pub(crate) fn of_bent(width: f64, cos_view: f64, [outward, around]: [f64; 2]) -> Self {
        let (square, width_outward) = (cos_view * cos_view, width * outward);
        let outward_rad =
            2.0 * ((square + width_outward).sqrt() - (square - width_outward).max(0.0).sqrt());
        Self { outward_rad, around_rad: 2.0 * (width * around) * cos_view }
    }

    /// The same in all directions.
    pub fn round(spread_rad: f64) -> Self {
        Self { outward_rad: spread_rad, around_rad: spread_rad }
    }

    /// Wider by unresolved slopes of a mean square, which turn normals as directions of half the angle do.
    pub(crate) fn over_slopes(self, slope2: f64) -> Self {
        // Half of them in either direction; a cone's full angle is eight standard deviations of its normals.
        let more = 0.5 * slope2 * FULL_ANGLE * FULL_ANGLE;
        let wider = |rad: f64| (rad * rad + more).sqrt();
        Self { outward_rad: wider(self.outward_rad), around_rad: wider(self.around_rad) }
    }

    /// The way back.
    pub(crate) fn less_slopes(self, slope2: f64) -> Self {
        let less = 0.5 * slope2 * FULL_ANGLE * FULL_ANGLE;
        let narrower = |rad: f64| (rad * rad - less).max(0.0).sqrt();
        Self { outward_rad: narrower(self.outward_rad), around_rad: narrower(self.around_rad) }
    }

    /// The cone around a mirrored ray, made wider by a round one of `share_rad2`, its angle squared, all around; `level` is
    /// the unit vector across the plane of view and normal.
    #[inline]
    pub(crate) fn cone(self, share_rad2: f64, along: DVec3, level: DVec3) -> Cone {
        let around2 = self.around_rad * self.around_rad + share_rad2;
        let outward2 = self.outward_rad * self.outward_rad + share_rad2;
        if outward2 < ROUND * around2 && around2 < ROUND * outward2 {
            return Cone::round((around2 * outward2).sqrt().sqrt());
        }
        let outward = level.cross(along).normalize_or_zero();
        Cone::stretched(around2.sqrt(), outward2.sqrt(), outward)
    }

    /// Standard deviation of the normals that mirror it, each by half of what the ray turns.
    pub(crate) fn normals_rad(self) -> f64 {
        self.mean_rad() / FULL_ANGLE
    }

    /// The angle of a round cone of the same solid angle.
    pub(crate) fn mean_rad(self) -> f64 {
        (self.outward_rad * self.around_rad).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_mirrors_each_part_of_its_disc_to_the_same_solid_angle() {
        for width in [0.001, 0.02] {
            for cos_view in [1.0, 0.7, 0.3] {
                let spread = Spread::of_square(width, cos_view);
                let angle = spread.outward_rad * spread.around_rad / (4.0 * width * width);
                assert!((angle - 1.0).abs() < 0.02, "{width} {cos_view}: {angle}");
            }
        }
    }
}
