//! One blemish: its outline, its relief, what it does to the layers.
//!
//! Smooth profiles on discs and on strips with round ends, as wide as they are stated.
//! Left out: cracks, holes to the nucleus, colour of their own.

use glam::DVec3;

use crate::coat::local::Local;

/// What blemishes there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A round hollow.
    Pit,
    /// A round rise.
    Bump,
    /// A narrow groove.
    Scratch,
    /// A long rise.
    Wrinkle,
    /// Matt and white, where tablets are missing.
    Chalk,
}

/// How many blemishes of each kind a pearl has, and how large they are.
#[derive(Debug, Clone, PartialEq)]
pub struct Blemishes {
    /// How many of each kind.
    pub counts: Vec<(Kind, usize)>,
    /// Mean diameter of pits, bumps and chalky spots; strips go by it.
    pub size_mm: f64,
    /// Mean depth or height of pits, bumps and wrinkles.
    pub depth_mm: f64,
    /// Share of the pearl that they cover together, which makes all larger or smaller, depths with them, where it is given.
    pub area: Option<f64>,
    /// What places them.
    pub seed: u64,
}

/// A blemish in its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Blemish {
    pub(crate) kind: Kind,
    /// Its middle, as a direction from the pearl's.
    pub(crate) middle: DVec3,
    /// The direction in which a strip goes there.
    pub(crate) along: DVec3,
    /// Half the length of a strip between its round ends; 0 of what is round.
    pub(crate) half_length_mm: f64,
    /// Half its width.
    pub(crate) radius_mm: f64,
    /// How deep or high it is.
    pub(crate) depth_mm: f64,
}

impl Kind {
    /// Length between the round ends, and width, over the stated size; depth over the stated depth **(ours)**.
    pub(crate) fn proportions(self) -> (f64, f64, f64) {
        match self {
            Self::Pit | Self::Bump | Self::Chalk => (0.0, 1.0, 1.0),
            Self::Scratch => (6.0, 0.15, 0.15),
            Self::Wrinkle => (4.0, 0.6, 1.0),
        }
    }

    /// Whether it rises (1) or sinks (-1).
    fn sense(self) -> f64 {
        match self {
            Self::Pit | Self::Scratch => -1.0,
            Self::Bump | Self::Wrinkle => 1.0,
            Self::Chalk => 0.0,
        }
    }
}

/// How much thicker layers are on the top of a rise, and thinner in a hollow: a front that grew faster **(ours)**.
pub(crate) const THICKER: f64 = 0.06;

/// Share of its radius over which chalk fades into nacre, beyond what a footprint blurs.
const FADE: f64 = 0.25;

impl Blemish {
    /// How far its outline reaches from its middle.
    pub(crate) fn reach_mm(&self) -> f64 {
        self.half_length_mm + self.radius_mm
    }

    /// The area within its outline.
    pub(crate) fn area_mm2(&self) -> f64 {
        self.radius_mm * (std::f64::consts::PI * self.radius_mm + 4.0 * self.half_length_mm)
    }

    /// What it makes of a place in a direction from the middle of a pearl of `pearl_mm`; nothing beyond its outline.
    pub(crate) fn at(&self, direction: DVec3, pearl_mm: f64, footprint_mm: f64) -> Option<Local> {
        let aside = self.aside_mm(direction, pearl_mm);
        let square = aside.length_squared() / (self.radius_mm * self.radius_mm);
        if square >= 1.0 {
            return None;
        }
        if self.kind == Kind::Chalk {
            let fade_mm = (FADE * self.radius_mm).max(footprint_mm);
            let inside = ((self.radius_mm - aside.length()) / fade_mm).min(1.0);
            return Some(Local { chalk: inside * inside * (3.0 - 2.0 * inside), ..Local::EVEN });
        }
        // Height depth (1 - r^2)^2.
        let (below, sense) = (1.0 - square, self.kind.sense());
        let steep = -4.0 * sense * self.depth_mm * below / (self.radius_mm * self.radius_mm);
        let slope = aside.reject_from_normalized(direction) * steep;
        // What a pixel as wide as the blemish does not tell apart is lean.
        let seen = 1.0 / (1.0 + (footprint_mm / self.radius_mm).powi(2));
        Some(Local {
            slope: slope * seen,
            fine_slope2: slope.length_squared() * (1.0 - seen * seen),
            thickness: 1.0 + sense * THICKER * below * below,
            ..Local::EVEN
        })
    }

    /// From the nearest point of its middle line to a place, straight.
    fn aside_mm(&self, direction: DVec3, pearl_mm: f64) -> DVec3 {
        if self.half_length_mm <= 0.0 {
            return (direction - self.middle) * pearl_mm;
        }
        let angle = libm::atan2(direction.dot(self.along), direction.dot(self.middle));
        let most = self.half_length_mm / pearl_mm;
        (direction - self.point(angle.clamp(-most, most))) * pearl_mm
    }

    /// The point of its middle line at an angle from its middle, as a direction.
    pub(crate) fn point(&self, angle_rad: f64) -> DVec3 {
        let (sin, cos) = libm::sincos(angle_rad);
        self.middle * cos + self.along * sin
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn blemish(kind: Kind) -> Blemish {
        let (length, width, depth) = kind.proportions();
        Blemish {
            kind,
            middle: DVec3::Z,
            along: DVec3::X,
            half_length_mm: 0.5 * length * 0.3,
            radius_mm: 0.5 * width * 0.3,
            depth_mm: 0.01 * depth,
        }
    }

    #[test]
    fn slopes_are_those_of_the_height() {
        for (kind, sense) in [(Kind::Pit, -1.0), (Kind::Bump, 1.0), (Kind::Wrinkle, 1.0)] {
            let blemish = blemish(kind);
            let at = |y: f64| DVec3::new(0.0, y / 4.0, 1.0).normalize();
            let height = |y: f64| {
                let square = (blemish.aside_mm(at(y), 4.0).length() / blemish.radius_mm).powi(2);
                sense * blemish.depth_mm * (1.0 - square).max(0.0).powi(2)
            };
            for y in [0.01, 0.04, 0.07] {
                let slope = blemish.at(at(y), 4.0, 0.0).unwrap().slope.y;
                let law = (height(y + 1e-5) - height(y - 1e-5)) / 2e-5;
                assert!((slope - law).abs() < 0.01 * law.abs(), "{kind:?} {y}: {slope} {law}");
            }
        }
    }

    #[test]
    fn nothing_is_beyond_its_outline() {
        for kind in [Kind::Pit, Kind::Scratch, Kind::Chalk] {
            let blemish = blemish(kind);
            let reach = (blemish.reach_mm() + 0.01) / 4.0;
            let beyond = DVec3::new(reach.sin(), 0.0, reach.cos());
            assert_eq!(blemish.at(beyond, 4.0, 0.02), None);
            assert!(blemish.at(DVec3::Z, 4.0, 0.0).is_some());
        }
    }
}
