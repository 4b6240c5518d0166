//! A pearl's form: how far its surface is from its middle, in every direction.
//!
//! An ovoid, lumps and grooves, multiplied; closed forms, smooth to the second derivative everywhere, poles included.
//! Left out: overhangs, which no such form has.

use glam::{DMat3, DVec3};
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;

use crate::{
    grain::normal::uniform,
    shape::{bent::Bent, lumps::Lumps, ovoid::Ovoid},
};

/// What a form is made from; lengths are shares of half the pearl's width. Zeros, with a length of 1, are a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FormParameters {
    /// Length along the axis of growth over the width across it.
    pub length: f64,
    /// How much narrower a drop's end is.
    pub taper: f64,
    /// How much nearer to the middle a button's flat side is.
    pub flattening: f64,
    /// How much wider the pearl is in one direction across its axis than in the other, as a share of the width.
    pub out_of_round: f64,
    /// Standard deviation of the lumps of a baroque pearl.
    pub lumps: f64,
    /// Size of a lump, from top to foot as an angle at the middle.
    pub lump_rad: f64,
    /// Grooves about the axis of growth.
    pub circles: usize,
    /// Depth of a groove.
    pub circle_depth: f64,
    /// What draws lumps and grooves.
    pub seed: u64,
}

impl FormParameters {
    /// A ball.
    pub const ROUND: Self = Self {
        length: 1.0,
        taper: 0.0,
        flattening: 0.0,
        out_of_round: 0.0,
        lumps: 0.0,
        lump_rad: 1.0,
        circles: 0,
        circle_depth: 0.0,
        seed: 0,
    };

    /// Whether it is a ball.
    pub fn is_round(&self) -> bool {
        let is_smooth = self.circles == 0 || self.circle_depth <= 0.0;
        let ovoid = Self { lump_rad: 1.0, circles: 0, circle_depth: 0.0, seed: 0, ..*self };
        is_smooth && ovoid == Self::ROUND
    }
}

/// A form, over half of the pearl's width; its pole, z, is the axis of growth.
#[derive(Debug, Clone)]
pub(crate) struct Form {
    ovoid: Ovoid,
    lumps: Option<Lumps>,
    grooves: Vec<Groove>,
}

/// A hollow about the axis: depth times (1 - ((z - height) / half width)^2)^3.
#[derive(Debug, Clone, Copy)]
struct Groove {
    height: f64,
    depth: f64,
    per_half_width: f64,
}

/// Grooves lie between these heights, as sines of the latitude **(ours)**.
const GROOVES_WITHIN: f64 = 0.72;
/// Spacing and depth of grooves vary by this share, to either side **(ours)**.
const UNEVEN: f64 = 0.25;

impl Form {
    /// Same parameters, same form, on every machine.
    pub(crate) fn new(from: &FormParameters) -> Self {
        let across = 0.5 * from.out_of_round;
        let axes = DVec3::new(1.0 + across, 1.0 - across, from.length);
        let mut random = ChaCha8Rng::from_seed(key(from.seed));
        let is_lumpy = from.lumps > 0.0;
        Self {
            ovoid: Ovoid::new(axes, from.taper, from.flattening),
            lumps: is_lumpy.then(|| Lumps::new(from.lumps, from.lump_rad, &mut random)),
            grooves: grooves(from, &mut random),
        }
    }

    /// Distance of the surface in a direction, and its gradient along the sphere of directions.
    pub(crate) fn at(&self, towards: DVec3) -> (f64, DVec3) {
        self.below(towards, towards)
    }

    /// The same where a point in that direction is known before the direction is.
    #[inline]
    pub(super) fn below(&self, towards: DVec3, point: DVec3) -> (f64, DVec3) {
        let (ovoid, along_ovoid) = self.ovoid.at(towards);
        let mut rise = 1.0;
        let mut along_rise = DVec3::ZERO;
        if let Some(lumps) = &self.lumps {
            let (amount, gradient) = lumps.at(towards, point);
            (rise, along_rise) = (rise + amount, along_rise + gradient);
        }
        for groove in &self.grooves {
            let from = (towards.z - groove.height) * groove.per_half_width;
            let left = 1.0 - from * from;
            if left > 0.0 {
                rise -= groove.depth * left * left * left;
                along_rise.z += groove.depth * 6.0 * left * left * from * groove.per_half_width;
            }
        }
        let gradient = along_ovoid * rise + along_rise * ovoid;
        (ovoid * rise, gradient - towards * gradient.dot(towards))
    }

    /// The same with second derivatives, by the direction's coordinates.
    pub(super) fn bent(&self, towards: DVec3) -> Bent {
        let flat = Bent { height: 0.0, slope: DVec3::ZERO, change: DMat3::ZERO };
        let mut rise = self.lumps.as_ref().map_or(flat, |lumps| lumps.bent(towards));
        rise.height += 1.0;
        for groove in &self.grooves {
            let from = (towards.z - groove.height) * groove.per_half_width;
            let left = 1.0 - from * from;
            if left > 0.0 {
                let depth = groove.depth * groove.per_half_width;
                rise.height -= groove.depth * left * left * left;
                rise.slope.z += 6.0 * depth * left * left * from;
                rise.change.z_axis.z +=
                    6.0 * depth * groove.per_half_width * left * (left - 4.0 * from * from);
            }
        }
        self.ovoid.bent(towards).times(&rise)
    }
}

/// Grooves from one end to the other.
fn grooves(from: &FormParameters, random: &mut ChaCha8Rng) -> Vec<Groove> {
    let spacing = 2.0 * GROOVES_WITHIN / from.circles.max(1) as f64;
    let mut uneven = || 1.0 + UNEVEN * (2.0 * uniform(random) - 1.0);
    let groove = |number: usize| {
        let place = number as f64 + 0.5 * uneven();
        Groove {
            height: spacing * place - GROOVES_WITHIN,
            depth: from.circle_depth * uneven(),
            per_half_width: 1.0 / (0.42 * spacing.min(0.5)),
        }
    };
    (0..from.circles).map(groove).collect()
}

fn key(seed: u64) -> [u8; 32] {
    let mut key = *b"-------- nacreous form of pearls";
    key[..8].copy_from_slice(&seed.to_le_bytes());
    key
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::shape::directions::even_directions;

    /// A form of every kind.
    pub(crate) fn kinds() -> Vec<FormParameters> {
        let round = FormParameters::ROUND;
        vec![
            FormParameters { length: 1.3, ..round },
            FormParameters { length: 0.75, flattening: 0.5, ..round },
            FormParameters { length: 1.4, taper: 1.2, ..round },
            FormParameters { out_of_round: 0.05, ..round },
            FormParameters { lumps: 0.08, lump_rad: 0.9, seed: 3, ..round },
            FormParameters { length: 1.2, lumps: 0.15, lump_rad: 0.7, seed: 4, ..round },
            FormParameters { length: 1.1, circles: 4, circle_depth: 0.07, seed: 5, ..round },
        ]
    }

    #[test]
    fn a_round_form_is_a_ball() {
        let form = Form::new(&FormParameters::ROUND);
        for towards in even_directions(50) {
            let (radius, gradient) = form.at(towards);
            assert!((radius - 1.0).abs() < 1e-12 && gradient.length() < 1e-12);
        }
    }

    #[test]
    fn gradients_are_those_of_differences() {
        for from in kinds() {
            let form = Form::new(&from);
            for towards in even_directions(200).chain([DVec3::Z, DVec3::NEG_Z, DVec3::X]) {
                let (_, gradient) = form.at(towards);
                let (u, v) = towards.any_orthonormal_pair();
                for along in [u, v] {
                    let radius = |step: f64| form.at((towards + along * step).normalize()).0;
                    let numeric = (radius(1e-5) - radius(-1e-5)) / 2e-5;
                    let slope = gradient.dot(along);
                    assert!(
                        (slope - numeric).abs() < 1e-7,
                        "{from:?} {towards}: {slope} {numeric}"
                    );
                }
            }
        }
    }

    #[test]
    fn second_derivatives_are_those_of_differences() {
        for from in kinds() {
            let form = Form::new(&from);
            for towards in even_directions(200).chain([DVec3::Z, DVec3::NEG_Z, DVec3::X]) {
                let bent = form.bent(towards);
                let (radius, gradient) = form.at(towards);
                let level = bent.slope - towards * bent.slope.dot(towards);
                assert!((bent.height - radius).abs() < 1e-12 && level.distance(gradient) < 1e-12);
                for axis in DMat3::IDENTITY.to_cols_array_2d().map(DVec3::from) {
                    let slope = |step: f64| form.bent(towards + axis * step).slope;
                    let numeric = (slope(1e-5) - slope(-1e-5)) / 2e-5;
                    let change = bent.change * axis;
                    assert!(
                        change.distance(numeric) < 1e-6 * (1.0 + change.length()),
                        "{from:?} {towards}: {change} {numeric}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_form_is_as_wide_and_as_long_as_it_shall_be() {
        let kinds =
            [(1.3, 0.0, 0.0), (1.5, 1.0, 0.0), (2.5, 3.0, 1.5), (0.7, 0.0, 0.0), (0.7, 0.0, 0.9)];
        for (length, taper, flattening) in kinds {
            let from = FormParameters { length, taper, flattening, ..FormParameters::ROUND };
            let form = Form::new(&from);
            let places: Vec<DVec3> = even_directions(20_000)
                .chain([DVec3::Z, DVec3::NEG_Z])
                .map(|to| to * form.at(to).0)
                .collect();
            let widest = places.iter().map(|at| at.truncate().length()).fold(0.0, f64::max);
            let top = places.iter().map(|at| at.z).fold(0.0, f64::max);
            let bottom = places.iter().map(|at| -at.z).fold(0.0, f64::max);
            assert!((widest - 1.0).abs() < 1e-3, "{from:?}: {widest}");
            assert!((0.5 * (top + bottom) - length).abs() < 1e-3, "{from:?}: {top} {bottom}");
        }
    }

    #[test]
    fn lumps_spread_as_they_shall() {
        let lumps = FormParameters { lumps: 0.1, lump_rad: 0.8, seed: 9, ..FormParameters::ROUND };
        let form = Form::new(&lumps);
        let radii: Vec<f64> = even_directions(5000).map(|to| form.at(to).0).collect();
        let mean = radii.iter().sum::<f64>() / 5000.0;
        let square = radii.iter().map(|r| (r - mean).powi(2)).sum::<f64>() / 5000.0;
        assert!((mean - 1.0).abs() < 2e-3 && (square.sqrt() - 0.1).abs() < 2e-3);
    }
}
