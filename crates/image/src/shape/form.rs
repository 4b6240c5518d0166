//! A pearl's form: how far its surface is from its middle, in every direction.
//!
//! An ovoid, lumps and grooves, multiplied; closed forms, smooth to the second derivative everywhere, poles included.
//! Left out: overhangs, which no such form has.

use glam::DVec3;
use multiversion::multiversion;
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;

use crate::grain::normal::{normal_pair, uniform};

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
    /// One over the squares of the half axes.
    squares: DVec3,
    taper: f64,
    flattening: f64,
    /// Makes it as wide as it shall be.
    scale: f64,
    lumps: Vec<Lumps>,
    /// What the lumps add on average.
    lumps_mean: f64,
    grooves: Vec<Groove>,
}

/// Rises and hollows about directions, side by side: amount times (1 - (1 - cos) / foot)^4 each.
#[derive(Debug, Clone, Copy)]
struct Lumps {
    middle: [[f64; LANES]; 3],
    amount: [f64; LANES],
    per_foot: f64,
}

/// So many lumps share registers.
const LANES: usize = 8;

/// A hollow about the axis: depth times (1 - ((z - height) / half width)^2)^3.
#[derive(Debug, Clone, Copy)]
struct Groove {
    height: f64,
    depth: f64,
    per_half_width: f64,
}

/// Lumps overlap so often at each place that they add up to an even landscape **(ours)**.
const OVERLAP: f64 = 6.0;
/// More lumps than this are none that one would see apart.
const MOST_LUMPS: usize = 160;
/// Directions by which a form's mean, spread and width are taken.
const POINTS: usize = 2000;
/// Grooves lie between these heights, as sines of the latitude **(ours)**.
const GROOVES_WITHIN: f64 = 0.72;
/// Spacing and depth of grooves vary by this share, to either side **(ours)**.
const UNEVEN: f64 = 0.25;

impl Form {
    /// Same parameters, same form, on every machine.
    pub(crate) fn new(from: &FormParameters) -> Self {
        let axes = [1.0 + 0.5 * from.out_of_round, 1.0 - 0.5 * from.out_of_round, from.length];
        let mut random = ChaCha8Rng::from_seed(key(from.seed));
        let lumps = if from.lumps > 0.0 { lumps(from, &mut random) } else { Vec::new() };
        let mut form = Self {
            squares: DVec3::from(axes.map(|axis| 1.0 / (axis * axis))),
            taper: from.taper,
            flattening: from.flattening,
            scale: 1.0,
            lumps,
            lumps_mean: 0.0,
            grooves: grooves(from, &mut random),
        };
        form.level_lumps(from.lumps);
        form.fit(from.length);
        form
    }

    /// Distance of the surface in a direction, and its gradient along the sphere of directions.
    pub(crate) fn at(&self, towards: DVec3) -> (f64, DVec3) {
        let (ovoid, along_ovoid) = self.ovoid(towards);
        let mut rise = 1.0;
        let mut along_rise = DVec3::ZERO;
        if !self.lumps.is_empty() {
            let (amount, gradient) = self.lumps_at(towards);
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

    /// The ovoid: x^2/a^2 W^2 + y^2/b^2 W^2 + z^2/c^2 F^2 = 1, with W = 1 + taper ((1 + z)/2)^2 and
    /// F = 1 + flattening ((1 - z)/2)^2.
    fn ovoid(&self, towards: DVec3) -> (f64, DVec3) {
        let (above, below) = (0.5 * (1.0 + towards.z), 0.5 * (1.0 - towards.z));
        let narrow = 1.0 + self.taper * above * above;
        let flat = 1.0 + self.flattening * below * below;
        let across =
            self.squares.x * towards.x * towards.x + self.squares.y * towards.y * towards.y;
        let along = self.squares.z * towards.z * towards.z;
        let sum = across * narrow * narrow + along * flat * flat;
        let radius = self.scale / sum.sqrt();
        let half = DVec3::new(
            self.squares.x * towards.x * narrow * narrow,
            self.squares.y * towards.y * narrow * narrow,
            across * narrow * self.taper * above + self.squares.z * towards.z * flat * flat
                - along * flat * self.flattening * below,
        );
        (radius, half * (-radius / sum))
    }

    /// What all lumps add, and its gradient.
    fn lumps_at(&self, towards: DVec3) -> (f64, DVec3) {
        let [amount, x, y, z] = lumps_at(&self.lumps, towards.to_array());
        (amount - self.lumps_mean, DVec3::new(x, y, z))
    }

    /// Makes the lumps' mean 0 and their standard deviation `spread`.
    fn level_lumps(&mut self, spread: f64) {
        if self.lumps.is_empty() {
            return;
        }
        let amounts: Vec<f64> = even_directions(POINTS).map(|to| self.lumps_at(to).0).collect();
        let mean = amounts.iter().sum::<f64>() / POINTS as f64;
        let square = amounts.iter().map(|amount| (amount - mean).powi(2)).sum::<f64>();
        let factor = spread / (square / POINTS as f64).sqrt().max(f64::MIN_POSITIVE);
        for lumps in &mut self.lumps {
            lumps.amount = lumps.amount.map(|amount| amount * factor);
        }
        self.lumps_mean = mean * factor;
    }

    /// Makes the ovoid's half width 1, on average around the axis, and its half length `length`: taper and flattening move
    /// both.
    fn fit(&mut self, length: f64) {
        const TRIES: usize = 40;
        for _ in 0..TRIES {
            let [half_width, half_length] = self.extents();
            self.scale /= half_width;
            let short = length * half_width / half_length;
            if (short - 1.0).abs() < 1e-12 {
                return;
            }
            self.squares.z /= short * short;
        }
    }

    /// Half the width of the ovoid at its widest, on average around the axis, and half its length.
    fn extents(&self) -> [f64; 2] {
        const STEPS: usize = 512;
        let (mut width, mut top, mut bottom) = (0.0_f64, 0.0_f64, 0.0_f64);
        for step in 0..=STEPS {
            let (sin, cos) = libm::sincos(std::f64::consts::PI * step as f64 / STEPS as f64);
            let sides = [DVec3::new(sin, 0.0, cos), DVec3::new(0.0, sin, cos)];
            let [x, y] = sides.map(|towards| self.ovoid(towards).0);
            width = width.max(0.5 * sin * (x + y));
            (top, bottom) = (top.max(x * cos), bottom.max(-x * cos));
        }
        [width, 0.5 * (top + bottom)]
    }
}

/// What lumps add up to in a direction, and the gradient of that.
#[multiversion(targets("x86_64+avx2", "x86_64+avx512f+avx512vl"))]
fn lumps_at(lumps: &[Lumps], [x, y, z]: [f64; 3]) -> [f64; 4] {
    let mut sums = [[0.0; LANES]; 4];
    for lumps in lumps {
        for lane in 0..LANES {
            let [mx, my, mz] = [0, 1, 2].map(|axis| lumps.middle[axis][lane]);
            let cosine = x * mx + y * my + z * mz;
            let left = (1.0 - (1.0 - cosine) * lumps.per_foot).max(0.0);
            let cube = lumps.amount[lane] * left * left * left;
            let slope = 4.0 * cube * lumps.per_foot;
            sums[0][lane] += cube * left;
            sums[1][lane] += mx * slope;
            sums[2][lane] += my * slope;
            sums[3][lane] += mz * slope;
        }
    }
    sums.map(|lanes| {
        let [a, b, c, d, e, f, g, h] = lanes;
        ((a + b) + (c + d)) + ((e + f) + (g + h))
    })
}

/// Rises and hollows at even directions, turned at random.
fn lumps(from: &FormParameters, random: &mut ChaCha8Rng) -> Vec<Lumps> {
    let foot = 1.0 - libm::cos(from.lump_rad);
    let count = (libm::ceil(2.0 * OVERLAP / foot) as usize).min(MOST_LUMPS);
    let turn = std::f64::consts::TAU * uniform(random);
    let axis = DVec3::new(
        2.0 * uniform(random) - 1.0,
        2.0 * uniform(random) - 1.0,
        2.0 * uniform(random) - 1.0,
    );
    let turn = glam::DQuat::from_axis_angle(axis.normalize_or(DVec3::X), turn);
    let middles: Vec<DVec3> = even_directions(count).map(|middle| turn * middle).collect();
    // Beyond two standard deviations a lump would be a horn.
    let amounts: Vec<f64> =
        middles.iter().map(|_| normal_pair(random)[0].clamp(-2.0, 2.0)).collect();
    let lumps = |(middles, amounts): (&[DVec3], &[f64])| {
        let lane = |axis: usize| std::array::from_fn(|i| middles.get(i).map_or(0.0, |m| m[axis]));
        Lumps {
            middle: [lane(0), lane(1), lane(2)],
            amount: std::array::from_fn(|i| amounts.get(i).copied().unwrap_or(0.0)),
            per_foot: 1.0 / foot,
        }
    };
    middles.chunks(LANES).zip(amounts.chunks(LANES)).map(lumps).collect()
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

/// Directions that share out the sphere evenly (Fibonacci's spiral).
pub(crate) fn even_directions(count: usize) -> impl Iterator<Item = DVec3> {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..count).map(move |i| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = libm::sincos(golden * i as f64);
        let aside = (1.0 - z * z).sqrt();
        DVec3::new(aside * cos, aside * sin, z)
    })
}

fn key(seed: u64) -> [u8; 32] {
    let mut key = *b"-------- nacreous form of pearls";
    key[..8].copy_from_slice(&seed.to_le_bytes());
    key
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

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
