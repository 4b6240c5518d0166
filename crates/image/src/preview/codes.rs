//! Codes for a screen of a preview's light, in single precision.
//!
//! The soft gamut map and the transfer function of `picture/develop.rs`, by a table.
//! Left out: the share of colours that the screen cannot show.

use nacreous_colour::{Gamut, RgbSpace, encode};

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

    /// Codes of a light, opaque.
    #[inline]
    pub(super) fn of(&self, light: [f32; 3]) -> [u8; 4] {
        let rgb =
            self.primaries.map(|row| row[0] * light[0] + row[1] * light[1] + row[2] * light[2]);
        let shown = match self.gamut {
            Gamut::Clip => rgb,
            Gamut::Soft => self.soft(rgb),
        };
        let [red, green, blue] = shown.map(|channel| {
            self.table[(channel.clamp(0.0, 1.0).sqrt() * STEPS as f32 + 0.5) as usize]
        });
        [red, green, blue, u8::MAX]
    }

    #[inline]
    fn soft(&self, rgb: [f32; 3]) -> [f32; 3] {
        let luminance = (0..3).map(|i| self.luminance[i] * rgb[i]).sum::<f32>();
        if luminance <= 0.0 {
            return [0.0; 3];
        }
        let grey = knee(luminance).min(WHITE);
        let away = rgb.map(|channel| channel * (grey / luminance) - grey);
        let of_room = |step: f32| if step > 0.0 { step / (1.0 - grey) } else { -step / grey };
        let excess = away.into_iter().map(of_room).fold(0.0, f32::max);
        let keep = if excess > KNEE { knee(excess) / excess } else { 1.0 };
        away.map(|step| grey + step * keep)
    }
}

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
                    let found = codes.of(light);
                    for (found, expected) in found.iter().zip(expected) {
                        assert!(found.abs_diff(expected) <= 1, "{light:?}: {found} {expected}");
                    }
                }
            }
        }
    }
}
