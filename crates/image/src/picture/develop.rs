//! From linear light to codes of a screen.
//!
//! Change of primaries, gamut and transfer function by `nacreous-colour`; IEC 61966-2-1.
//! Left out: tone curves and dither; a code is the nearest one.

use nacreous_colour::{Gamut, RgbSpace, encode, in_gamut};

use crate::parallel;

/// A picture ready for the screen or a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Developed {
    /// Codes 0 to 65535, three a pixel.
    pub codes: Vec<u16>,
    /// Share of pixels whose colour the screen cannot show; the gamut handling changed them.
    pub out_of_gamut: f64,
}

/// Turns linear light, three numbers a pixel in the primaries of sRGB, into codes of `space`: change
/// of primaries, gamut handling, then the transfer function of sRGB, which Display P3 shares.
pub fn develop(linear: &[f32], space: RgbSpace, gamut: Gamut) -> Developed {
    let mut codes = vec![0; linear.len()];
    let one = |codes: &mut [u16], pixel: &[f32]| {
        let rgb = space.rgb_from(RgbSpace::Srgb, std::array::from_fn(|i| f64::from(pixel[i])));
        for (code, channel) in codes.iter_mut().zip(gamut.map(space, rgb)) {
            *code = (encode(channel) * 65535.0).round() as u16;
        }
        usize::from(!in_gamut(rgb))
    };
    let outside = parallel::map_chunks(&mut codes, AT_ONCE, |i, codes| {
        let pixels = linear[i * AT_ONCE..].chunks(3);
        codes.chunks_mut(3).zip(pixels).map(|(codes, pixel)| one(codes, pixel)).sum::<usize>()
    });
    let outside: usize = outside.iter().sum();
    Developed { out_of_gamut: outside as f64 / (linear.len() / 3).max(1) as f64, codes }
}

/// Numbers that one thread takes in one go: a thousand pixels.
const AT_ONCE: usize = 3 * 1024;

/// The nearest 8-bit codes.
pub fn eight_bit(codes: &[u16]) -> Vec<u8> {
    codes.iter().map(|&code| eight_bit_of(code)).collect()
}

/// The nearest 8-bit code.
pub(crate) fn eight_bit_of(code: u16) -> u8 {
    ((u32::from(code) + 128) / 257) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_bit_codes_are_the_nearest() {
        for code in 0..=u16::MAX {
            let nearest = (f64::from(code) / 257.0).round() as u8;
            assert_eq!(eight_bit(&[code]), [nearest]);
        }
    }

    #[test]
    fn middle_grey_meets_the_srgb_standard_and_gamut_is_counted() {
        let developed =
            develop(&[0.214_041, 0.214_041, 0.214_041, 1.5, 0.0, 0.0], RgbSpace::Srgb, Gamut::Clip);
        assert!((f64::from(developed.codes[0]) - 0.5 * 65535.0).abs() <= 1.0);
        assert!((developed.out_of_gamut - 0.5).abs() < 1e-15);
    }
}
