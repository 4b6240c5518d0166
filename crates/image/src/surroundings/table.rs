//! What the table is covered with: share of light sent back by place.
//!
//! Square waves and a weave averaged over the footprint in closed form; the cloth by eye **(ours)**.
//! Left out: gloss and relief; every table is matt.

use std::f64::consts::PI;

use crate::rgb::{self, Rgb};

/// What the table is covered with. Colours are shares of light sent back, linear RGB.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Table {
    /// One colour.
    Plain(Rgb),
    /// Squares of two colours; the pearl stands on a corner.
    Checker {
        /// Squares where the two cell numbers are both even or both odd.
        colour: Rgb,
        /// The others.
        second_colour: Rgb,
        /// Side of a square.
        check_mm: f64,
    },
    /// Woven cloth: threads over and under, a stand-in without measured data.
    Cloth {
        /// Colour of the threads\' crowns.
        colour: Rgb,
        /// Colour between the threads.
        second_colour: Rgb,
        /// From thread to thread.
        weave_mm: f64,
    },
}

impl Table {
    /// Share of light sent back at (x, z), averaged over a footprint `footprint_mm` across, stretched
    /// along z by a line of sight that meets the table at a slant (`slant`, cosine to the table's normal).
    ///
    /// The stretch is along the viewer's depth, so it is right for azimuth 0 and an estimate elsewhere.
    pub fn albedo(&self, x: f64, z: f64, footprint_mm: f64, slant: f64) -> Rgb {
        let deep_mm = footprint_mm / slant.max(0.02);
        match *self {
            Self::Plain(colour) => colour,
            Self::Checker { colour, second_colour, check_mm } => {
                let product = square_wave(x / check_mm, footprint_mm / check_mm)
                    * square_wave(z / check_mm, deep_mm / check_mm);
                rgb::mix(colour, second_colour, 0.5 - 0.5 * product)
            }
            Self::Cloth { colour, second_colour, weave_mm } => {
                let widths = [footprint_mm / weave_mm, deep_mm / weave_mm];
                rgb::mix(colour, second_colour, weave([x / weave_mm, z / weave_mm], widths))
            }
        }
    }
}

/// +1 and -1 in turn with period 2, averaged over a box of `width` around `x`.
fn square_wave(x: f64, width: f64) -> f64 {
    /// The integral of the wave from 0: a triangle wave.
    fn integral(x: f64) -> f64 {
        // Exactly what the remainder is, without its loop.
        let phase = x - 2.0 * (0.5 * x).floor();
        if phase < 1.0 { phase } else { 2.0 - phase }
    }
    let width = width.max(1e-6);
    let average = (integral(x + 0.5 * width) - integral(x - 0.5 * width)) / width;
    // A box alone lets far squares flicker at even multiples of its width; what is finer than the
    // footprint fades out.
    average / (1.0 + (0.5 * width).powi(4))
}

/// Plain weave: depth between threads, 0 on a crown, 1 in a gap, mean 1/2, with period 2; averaged over a Gaussian as
/// wide as even discs of these widths along x and z.
///
/// With p = cos(pi x) cos(pi z) and c = cos(pi (x + z)) it is 1/2 - p |c| / 2, here by the cosines of its Fourier series,
/// each faded by the Gaussian; where all are kept, they are right to 0.02.
fn weave([x, z]: [f64; 2], widths: [f64; 2]) -> f64 {
    let exponent = widths.map(|width| 0.5 * (PI * 0.25 * width).powi(2));
    if exponent[0] + exponent[1] > FADED {
        return 0.5;
    }
    let [fade_x, fade_z] = exponent.map(|exponent| libm::exp(-exponent));
    let (wave_x, wave_z) = (Harmonics::new(PI * x, fade_x), Harmonics::new(PI * z, fade_z));
    let sum = |i, j| wave_x.cos[i] * wave_z.cos[j] - wave_x.sin[i] * wave_z.sin[j];
    let difference = wave_x.cos[0] * wave_z.cos[0] + wave_x.sin[0] * wave_z.sin[0];
    let mut depth = 0.5 - 0.5 / PI * difference;
    for (i, own) in OWN.iter().enumerate() {
        depth -= own * sum(i, i);
    }
    for (i, other) in OTHER.iter().enumerate() {
        depth -= other * (sum(i + 1, i) + sum(i, i + 1));
    }
    depth
}

/// Of cos t |cos t| / 4, the odd harmonics.
const OWN: [f64; 4] =
    [2.0 / (3.0 * PI), 2.0 / (15.0 * PI), -2.0 / (105.0 * PI), 2.0 / (315.0 * PI)];
/// Of |cos t| / 8, the even harmonics from the second on.
const OTHER: [f64; 3] = [0.5 / (3.0 * PI), -0.5 / (15.0 * PI), 0.5 / (35.0 * PI)];
/// Beyond this exponent of a Gaussian a weave is even: of its contrast a thousandth is left.
const FADED: f64 = 6.9;

/// Odd harmonics of an angle, each faded as a Gaussian fades it: the first, third, fifth and seventh.
struct Harmonics {
    cos: [f64; 4],
    sin: [f64; 4],
}

impl Harmonics {
    fn new(angle_rad: f64, fade: f64) -> Self {
        let (sin, cos) = libm::sincos(angle_rad);
        let (twice_cos, twice_sin) = (cos * cos - sin * sin, 2.0 * sin * cos);
        let mut harmonics = Self { cos: [cos; 4], sin: [sin; 4] };
        for i in 1..4 {
            let (cos, sin) = (harmonics.cos[i - 1], harmonics.sin[i - 1]);
            harmonics.cos[i] = cos * twice_cos - sin * twice_sin;
            harmonics.sin[i] = sin * twice_cos + cos * twice_sin;
        }
        for (i, order) in [1, 3, 5, 7].into_iter().enumerate() {
            let faded = fade.powi(order * order);
            harmonics.cos[i] *= faded;
            harmonics.sin[i] *= faded;
        }
        harmonics
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHECKER: Table =
        Table::Checker { colour: [0.8; 3], second_colour: [0.2; 3], check_mm: 3.0 };

    #[test]
    fn fine_footprints_see_squares_and_wide_ones_their_mean() {
        let close = |a: Rgb, b: f64| (a[0] - b).abs() < 1e-3;
        assert!(close(CHECKER.albedo(1.5, 1.5, 1e-3, 1.0), 0.8));
        assert!(close(CHECKER.albedo(4.5, 1.5, 1e-3, 1.0), 0.2));
        assert!(close(CHECKER.albedo(4.5, 1.5, 300.0, 1.0), 0.5));
    }

    #[test]
    fn averaging_over_a_footprint_keeps_the_mean_of_a_period() {
        for footprint_mm in [0.1, 1.0, 2.5, 7.0] {
            let cells = 60;
            let mut sum = 0.0;
            for i in 0..cells {
                for j in 0..cells {
                    let at = |k| f64::from(k) * 6.0 / f64::from(cells);
                    sum += CHECKER.albedo(at(i), at(j), footprint_mm, 1.0)[0];
                }
            }
            assert!((sum / f64::from(cells * cells) - 0.5).abs() < 1e-9);
        }
    }
    #[test]
    fn a_weave_under_a_footprint_is_its_mean_there() {
        let exact = |x: f64, z: f64| {
            let product = (PI * x).cos() * (PI * z).cos();
            0.5 - 0.5 * product * (PI * (x + z)).cos().abs()
        };
        for (width, deep) in [(1e-6, 1e-6), (0.3, 0.5), (1.0, 1.2), (1.5, 3.0)] {
            for (x, z) in [(0.0, 0.0), (0.3, 0.9), (1.0, 0.2), (0.5, 0.5)] {
                let (mut sum, mut weights) = (0.0, 0.0);
                for i in -40..=40 {
                    for j in -40..=40 {
                        let (u, v) = (0.1 * f64::from(i), 0.1 * f64::from(j));
                        let weight = (-0.5 * (u * u + v * v)).exp();
                        sum += weight * exact(x + 0.25 * width * u, z + 0.25 * deep * v);
                        weights += weight;
                    }
                }
                let found = weave([x, z], [width, deep]);
                assert!((found - sum / weights).abs() < 0.02, "{width} {x} {z}: {found}");
            }
        }
    }
}
