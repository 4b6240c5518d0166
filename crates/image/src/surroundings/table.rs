//! What the table is covered with: share of light sent back by place.
//!
//! Square waves and a weave averaged over the footprint in closed form; the cloth by eye **(ours)**.
//! Left out: gloss and relief; every table is matt.

use crate::{
    rgb::{self, Rgb},
    surroundings::weave::{LANES, weave, weaves},
};

/// Where a line of sight meets a table, and how.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Spot {
    pub(super) x: f64,
    pub(super) z: f64,
    pub(super) footprint_mm: f64,
    pub(super) slant: f64,
}

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
        let deep_mm = deep_mm(footprint_mm, slant);
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

    /// [`Self::albedo`] at several places, to the bit.
    pub(super) fn albedos(&self, spots: &[Spot; LANES]) -> [Rgb; LANES] {
        let Self::Cloth { colour, second_colour, weave_mm } = *self else {
            return spots.map(|spot| self.albedo(spot.x, spot.z, spot.footprint_mm, spot.slant));
        };
        let (mut places, mut widths) = ([[0.0; LANES]; 2], [[0.0; LANES]; 2]);
        for (i, Spot { x, z, footprint_mm, slant }) in spots.iter().enumerate() {
            (places[0][i], places[1][i]) = (x / weave_mm, z / weave_mm);
            widths[0][i] = footprint_mm / weave_mm;
            widths[1][i] = deep_mm(*footprint_mm, *slant) / weave_mm;
        }
        weaves(places, widths).map(|depth| rgb::mix(colour, second_colour, depth))
    }
}

/// A footprint as a line of sight at a slant stretches it.
fn deep_mm(footprint_mm: f64, slant: f64) -> f64 {
    footprint_mm / slant.max(0.02)
}

/// +1 and -1 in turn with period 2, averaged over a box of `width` around `x`.
fn square_wave(x: f64, width: f64) -> f64 {
    /// The integral of the wave from 0: a triangle wave.
    fn integral(x: f64) -> f64 {
        // Exactly what the remainder is, without its loop.
        let phase = x - 2.0 * floor(0.5 * x);
        if phase < 1.0 { phase } else { 2.0 - phase }
    }
    let width = width.max(1e-6);
    let average = (integral(x + 0.5 * width) - integral(x - 0.5 * width)) / width;
    // A box alone lets far squares flicker at even multiples of its width; what is finer than the
    // footprint fades out.
    average / (1.0 + (0.5 * width).powi(4))
}

/// As `f64::floor`, which calls a function on processors without an instruction for it; far below 2^63.
fn floor(x: f64) -> f64 {
    let towards_zero = x as i64 as f64;
    if towards_zero > x { towards_zero - 1.0 } else { towards_zero }
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
}
