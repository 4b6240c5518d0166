//! Codes for a screen of a preview's light, in single precision.
//!
//! The soft gamut map and the transfer function of `picture/develop.rs`, by a table.
//! Left out: the share of colours that the screen cannot show.

use nacreous_colour::{Gamut, RgbSpace, encode};

use crate::preview::lanes::{LANES, Lanes, larger};

/// From linear light in the primaries of sRGB to 8-bit codes.
pub(super) struct Codes {
    /// To the primaries of the screen.
    primaries: [[f32; 3]; 3],
    luminance: [f32; 3],
    gamut: Gamut,
    /// By the square root of a linear channel.
    table: Vec<u8>,
}

/// Steps of the table; a code is at least a dozen wide.
const STEPS: usize = 4095;
/// As in the gamut's own soft map.
const KNEE: f32 = 0.8;
/// The most that a grey is brought to: colours need some room.
const WHITE: f32 = 0.999_999;
/// The least luminance that counts as light.
const LEAST: f32 = 1e-9;
/// All places of the table, a power of two.
const MASK: usize = STEPS;

impl Codes {
    pub(super) fn new(space: RgbSpace, gamut: Gamut) -> Self {
        let unit = |i: usize| std::array::from_fn(|k| f64::from(u8::from(k == i)));
        let columns = [0, 1, 2].map(|i| space.rgb_from(RgbSpace::Srgb, unit(i)));
        let code = |step: usize| {
            let root = step as f64 / STEPS as f64;
            (encode(root * root) * 255.0).round() as u8
        };
        Self {
            primaries: [0, 1, 2].map(|row| columns.map(|column| column[row] as f32)),
            luminance: [0, 1, 2].map(|i| space.luminance(unit(i)) as f32),
            gamut,
            table: (0..=STEPS).map(code).collect(),
        }
    }

    /// Brings light to the primaries of the screen and into what it can show.
    pub(super) fn bring_in(&self, light: &mut [Lanes; 3]) {
        for lane in 0..LANES {
            let [r, g, b] = [0, 1, 2].map(|i| light[i][lane]);
            let rgb = self.primaries.map(|row| row[0] * r + row[1] * g + row[2] * b);
            let shown = match self.gamut {
                Gamut::Clip => rgb,
                Gamut::Soft => self.soft(rgb),
            };
            for i in 0..3 {
                light[i][lane] = shown[i].clamp(0.0, 1.0).sqrt();
            }
        }
    }

    /// Codes of a pixel, opaque, by the square roots of its channels.
    #[inline]
    pub(super) fn code(&self, roots: [f32; 3]) -> [u8; 4] {
        let code = |root: f32| self.table[(root * STEPS as f32 + 0.5) as usize & MASK];
        let [red, green, blue] = roots.map(code);
        [red, green, blue, u8::MAX]
    }

    /// Without branches, for pixels side by side.
    #[inline]
    fn soft(&self, rgb: [f32; 3]) -> [f32; 3] {
        let [r, g, b] = self.luminance;
        let luminance = larger(r * rgb[0] + g * rgb[1] + b * rgb[2], LEAST);
        let grey = knee(luminance).clamp(0.0, WHITE);
        let dim = grey / luminance;
        let (above, below) = (1.0 / (1.0 - grey), -1.0 / grey);
        let away = rgb.map(|channel| channel * dim - grey);
        let of_room = |step: f32| larger(step * above, step * below);
        let room = larger(of_room(away[0]), of_room(away[1]));
        let excess = larger(larger(room, of_room(away[2])), KNEE);
        let keep = knee(excess) / excess;
        away.map(|step| grey + step * keep)
    }
}

#[inline]
fn knee(x: f32) -> f32 {
    if x <= KNEE { x } else { 1.0 - (1.0 - KNEE) * (1.0 - KNEE) / (1.0 + x - 2.0 * KNEE) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::develop::{develop, eight_bit};

    #[test]
    fn codes_are_those_of_the_picture() {
        for space in [RgbSpace::Srgb, RgbSpace::DisplayP3] {
            for gamut in [Gamut::Soft, Gamut::Clip] {
                let codes = Codes::new(space, gamut);
                for i in 0..4000_u32 {
                    let light = [7, 11, 13].map(|k| ((i * k) % 97) as f32 / 60.0 - 0.05);
                    let expected = eight_bit(&develop(&light, space, gamut).codes);
                    let mut lanes = light.map(|channel| [channel; LANES]);
                    codes.bring_in(&mut lanes);
                    let found = codes.code(lanes.map(|channel| channel[3]));
                    for (found, expected) in found.iter().zip(expected) {
                        assert!(found.abs_diff(expected) <= 1, "{light:?}: {found} {expected}");
                    }
                }
            }
        }
    }
}
