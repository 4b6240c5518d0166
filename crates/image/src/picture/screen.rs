//! From linear light to 8-bit codes of a screen, to the bit those of a developed picture.
//!
//! The transfer function turned round once: where each code begins, and a table of which begins near.
//! Left out: codes of 16 bits, which files have.

use std::sync::LazyLock;

use nacreous_colour::{Gamut, RgbSpace, encode, in_gamut};

use crate::{parallel, picture::develop::eight_bit_of};

/// A picture ready for a canvas.
#[derive(Debug, Clone, PartialEq)]
pub struct Screened {
    /// RGBA, the last 255.
    pub codes: Vec<u8>,
    /// Share of pixels whose colour the screen cannot show; the gamut handling changed them.
    pub out_of_gamut: f64,
}

/// As [`develop`](crate::develop) and [`eight_bit`](crate::eight_bit), of light given pixel by pixel in sRGB's primaries.
pub fn screen(
    pixels: usize,
    light: impl Fn(usize) -> [f64; 3] + Sync,
    space: RgbSpace,
    gamut: Gamut,
) -> Screened {
    let mut codes = vec![u8::MAX; 4 * pixels];
    let one = |code: &mut [u8], light: [f64; 3]| {
        let rgb = space.rgb_from(RgbSpace::Srgb, light);
        for (code, channel) in code.iter_mut().zip(gamut.map(space, rgb)) {
            *code = TABLE.code(channel);
        }
        usize::from(!in_gamut(rgb))
    };
    let outside = parallel::map_chunks(&mut codes, 4 * AT_ONCE, |i, codes| {
        let pixels = codes.chunks_exact_mut(4).enumerate();
        pixels.map(|(k, code)| one(code, light(i * AT_ONCE + k))).sum::<usize>()
    });
    let outside: usize = outside.iter().sum();
    Screened { out_of_gamut: outside as f64 / pixels.max(1) as f64, codes }
}

/// Pixels that one thread takes in one go.
const AT_ONCE: usize = 1024;

static TABLE: LazyLock<Table> = LazyLock::new(Table::new);

/// Steps of the square root of a channel: a code is at least a dozen wide.
const STEPS: usize = 4096;

/// Which code each linear channel has.
struct Table {
    /// The least channel of each code.
    begins: [f64; 256],
    /// The code of the channel where each step of its square root begins.
    near: Vec<u8>,
}

impl Table {
    fn new() -> Self {
        let begins: [f64; 256] = std::array::from_fn(begin);
        let code = |channel: f64| begins.partition_point(|begin| *begin <= channel) - 1;
        let near = |step: usize| {
            let root = step.saturating_sub(1) as f64 / STEPS as f64;
            code(root * root) as u8
        };
        Self { near: (0..=STEPS).map(near).collect(), begins }
    }

    /// Of a channel from 0 to 1.
    #[inline]
    fn code(&self, channel: f64) -> u8 {
        let mut code = self.near[((channel.sqrt() * STEPS as f64) as usize).min(STEPS)];
        while code < u8::MAX && channel >= self.begins[code as usize + 1] {
            code += 1;
        }
        code
    }
}

/// The least channel that has a code, by halving the numbers between 0 and 1.
fn begin(code: usize) -> f64 {
    let has =
        |channel: f64| eight_bit_of((encode(channel) * 65535.0).round() as u16) as usize >= code;
    let (mut low, mut high) = (0_u64, 1.0_f64.to_bits());
    if has(0.0) {
        return 0.0;
    }
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if has(f64::from_bits(middle)) { high = middle } else { low = middle }
    }
    f64::from_bits(high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::develop::{develop, eight_bit};

    #[test]
    fn codes_are_to_the_bit_those_of_a_developed_picture() {
        let mut light: Vec<f32> =
            (0..30_000).map(|i: i32| (i * 7919 % 10_007) as f32 / 9000.0 - 0.03).collect();
        // Both sides of where codes begin.
        for begin in TABLE.begins {
            light.extend([begin as f32; 3]);
            light.extend([(begin as f32).next_down(); 3]);
        }
        for space in [RgbSpace::Srgb, RgbSpace::DisplayP3] {
            for gamut in [Gamut::Soft, Gamut::Clip] {
                let developed = develop(&light, space, gamut);
                let pixel = |i: usize| [0, 1, 2].map(|k| f64::from(light[3 * i + k]));
                let screened = screen(light.len() / 3, pixel, space, gamut);
                assert!((screened.out_of_gamut - developed.out_of_gamut).abs() < 1e-15);
                let expected = eight_bit(&developed.codes);
                for (found, expected) in screened.codes.chunks(4).zip(expected.chunks(3)) {
                    assert_eq!((&found[..3], found[3]), (expected, u8::MAX));
                }
            }
        }
    }
}
