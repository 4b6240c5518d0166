//! A panorama: light from all around, as a picture in latitude and longitude.
//!
//! Coarser copies by halves, straight lines between pixels and between copies.
//! Left out: the stretch of pixels near the poles, and lobes that are not round.

use std::f64::consts::PI;

use glam::DVec3;

use crate::{
    harmonics::Place,
    rgb::{self, Rgb},
};

/// A panorama around the scene in latitude and longitude (width twice the height), linear RGB, with coarser copies of
/// itself so that a wide lobe costs as much as a narrow one.
#[derive(Debug, Clone)]
pub struct Panorama {
    levels: Vec<Level>,
}

#[derive(Debug, Clone)]
struct Level {
    width: usize,
    height: usize,
    pixels: Vec<[f32; 3]>,
}

impl Panorama {
    /// `pixels` row by row from the zenith down, each row clockwise as seen from above: from the viewer's side
    /// (azimuth 0) by the left to straight ahead (azimuth 180 degrees), the middle of the picture, and by the right
    /// back. At least one row and one column, `width * height` pixels, all finite: the readers of picture files see
    /// to that.
    pub fn new(width: usize, height: usize, pixels: Vec<[f32; 3]>) -> Self {
        let mut levels = vec![Level { width, height, pixels }];
        while let Some(finest) = levels.last()
            && (finest.width > 1 || finest.height > 1)
        {
            levels.push(finest.halved());
        }
        Self { levels }
    }

    /// Radiance from `along`, the picture turned by `rotation_rad`, over about `spread_rad`.
    pub(crate) fn radiance(&self, along: DVec3, rotation_rad: f64, spread_rad: f64) -> Rgb {
        let place = Place::towards(DVec3::new(-along.z, along.x, along.y));
        let turns = (f64::from(place.longitude) + rotation_rad) / (2.0 * PI) + 0.5;
        let u = turns - turns.floor();
        let v = f64::from(place.colatitude) / PI;
        let pixel_rad = PI / self.levels[0].height as f64;
        let level = octaves((spread_rad / pixel_rad).max(1.0));
        let last = self.levels.len() - 1;
        let fine = (level as usize).min(last);
        let coarse = (fine + 1).min(last);
        let share = (level - fine as f64).min(1.0);
        let (fine, coarse) = (&self.levels[fine], &self.levels[coarse]);
        if share > 0.0 { rgb::mix(fine.at(u, v), coarse.at(u, v), share) } else { fine.at(u, v) }
    }
}

/// The binary logarithm of a number from 1 up, by straight lines between powers of two: nothing between two
/// levels is so sharp that they would show.
fn octaves(x: f64) -> f64 {
    let bits = x.to_bits();
    let mantissa = f64::from_bits(bits & ((1 << 52) - 1) | 1.0_f64.to_bits());
    (bits >> 52) as f64 - 1024.0 + mantissa
}

impl Level {
    /// Two by two pixels become one; an odd last column or row counts twice.
    fn halved(&self) -> Self {
        let (width, height) = (self.width.div_ceil(2), self.height.div_ceil(2));
        let quarter = |row: usize, column: usize| {
            let (row, column) = (row.min(self.height - 1), column.min(self.width - 1));
            self.pixels[row * self.width + column].map(|channel| 0.25 * channel)
        };
        let pixels = (0..height * width)
            .map(|i| {
                let (row, column) = (2 * (i / width), 2 * (i % width));
                let four =
                    [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(r, c)| quarter(row + r, column + c));
                std::array::from_fn(|i| four.iter().map(|pixel| pixel[i]).sum())
            })
            .collect();
        Self { width, height, pixels }
    }

    /// Bilinear, round in longitude, ending at the poles. `u`, `v` from 0 to 1.
    fn at(&self, u: f64, v: f64) -> Rgb {
        // One column is added so that conversion to whole numbers rounds down.
        let x = u * self.width as f64 + 0.5;
        let y = (v * self.height as f64 - 0.5).clamp(0.0, (self.height - 1) as f64);
        let (right, top) = (x as usize, y as usize);
        let (share_x, share_y) = (x - right as f64, y - top as f64);
        let left = if right == 0 { self.width - 1 } else { right - 1 };
        let right = if right >= self.width { 0 } else { right };
        let left = left.min(self.width - 1);
        let (upper, lower) = (top * self.width, (top + 1).min(self.height - 1) * self.width);
        let (x, y) = (share_x as f32, share_y as f32);
        let weights = [(1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y];
        let places = [upper + left, upper + right, lower + left, lower + right];
        let four = places.map(|place| self.pixels[place]);
        std::array::from_fn(|i| {
            let sum: f32 = four.iter().zip(weights).map(|(pixel, weight)| pixel[i] * weight).sum();
            f64::from(sum)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Brighter to the right, darker downward.
    fn slope() -> Panorama {
        let (width, height) = (64, 32);
        let pixel = |i: usize| [(i % width) as f32, (i / width) as f32, 1.0];
        Panorama::new(width, height, (0..width * height).map(pixel).collect())
    }

    #[test]
    fn octaves_are_exact_at_powers_of_two_and_rise_between() {
        for power in 0..20 {
            let x = f64::from(1 << power);
            assert!((octaves(x) - f64::from(power)).abs() < 1e-15);
            assert!((octaves(1.5 * x) - (1.5 * x).log2()).abs() < 0.09);
        }
    }

    #[test]
    fn a_wide_lobe_sees_the_mean() {
        let mean = slope().radiance(DVec3::Z, 0.0, 4.0 * PI);
        assert!((mean[0] - 31.5).abs() < 1e-6 && (mean[1] - 15.5).abs() < 1e-6);
    }

    #[test]
    fn straight_ahead_is_the_middle_and_the_right_hand_is_to_the_right() {
        let narrow = |along| slope().radiance(along, 0.0, 0.0);
        // From azimuth 0, on the side of +z, one looks along -z.
        assert!((narrow(DVec3::NEG_Z)[0] - 31.5).abs() < 1e-4);
        assert!((narrow(DVec3::X)[0] - 47.5).abs() < 1e-4);
        assert!(narrow(DVec3::Y)[1] < 1e-4);
    }

    #[test]
    fn turning_the_picture_is_turning_the_view() {
        let turned = slope().radiance(DVec3::NEG_Z, PI / 2.0, 0.0);
        assert!((turned[0] - 47.5).abs() < 1e-4);
    }
}
