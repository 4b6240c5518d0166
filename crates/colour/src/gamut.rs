//! Colours that a screen cannot show, brought into the cube 0..1.
//!
//! *Clip* cuts each channel. It is exact inside, but strong colours change hue and highlights lose
//! their shape.
//!
//! *Soft* bends both luminance and saturation with one knee, the identity up to k = 0.8 **(ours)**:
//!
//! ```text
//! knee(x) = x                              x <= k
//!         = 1 - (1 - k)^2 / (1 + x - 2k)   x >  k     slope 1 at k, increasing, below 1
//! ```
//!
//! 1. Luminance Y becomes Y' = knee(Y), and the colour scales with it: c = rgb Y'/Y. What is brighter
//!    than white runs smoothly into white, because near Y' = 1 step 2 leaves no room for colour.
//! 2. From the grey of luminance Y' the colour lies at Y' + d, with d = c - Y'. Its excess
//!    e = max over channels of d/(1 - Y') where d > 0 and -d/Y' where d < 0 is 1 on the surface of
//!    the cube. The result is Y' + d knee(e)/e: same luminance Y', same direction d, inside the cube.
//!
//! Colours with Y <= 0 become black.

use std::str::FromStr;

use crate::{ColourError, RgbSpace};

/// Up to here soft mapping changes nothing.
const KNEE: f64 = 0.8;
/// Less than a step of 16 bits: rounding does not count as leaving the gamut.
const TOLERANCE: f64 = 1e-6;

/// How linear RGB is brought into the cube 0..1; read from `clip` and `soft`.
///
/// ```
/// use nacreous_colour::{Gamut, RgbSpace};
/// let green = [-0.2, 0.7, 0.1];
/// assert_eq!(Gamut::Clip.map(RgbSpace::Srgb, green), [0.0, 0.7, 0.1]);
/// let soft = Gamut::Soft.map(RgbSpace::Srgb, green);
/// let change = RgbSpace::Srgb.luminance(soft) - RgbSpace::Srgb.luminance(green);
/// assert!(soft[0] > 0.0 && change.abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Gamut {
    /// Each channel is cut at 0 and 1.
    #[default]
    Clip,
    /// Hue direction is kept, and luminance up to 0.8; saturation and highlights bend smoothly.
    Soft,
}

impl Gamut {
    /// The colour within 0..1 that stands for a finite linear colour of `space`.
    pub fn map(self, space: RgbSpace, rgb: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Clip => rgb.map(|channel| channel.clamp(0.0, 1.0)),
            Self::Soft => soft(rgb, space.luminance(rgb)),
        }
    }
}

fn soft(rgb: [f64; 3], luminance: f64) -> [f64; 3] {
    if luminance <= 0.0 {
        return [0.0; 3];
    }
    let grey = knee(luminance);
    if grey >= 1.0 {
        return [1.0; 3]; // so bright that the knee rounds to white
    }
    let dim = grey / luminance; // 1 below the knee, to the last bit
    let away = rgb.map(|channel| channel * dim - grey);
    let excess = away
        .iter()
        .map(|&step| if step > 0.0 { step / (1.0 - grey) } else { -step / grey })
        .fold(0.0, f64::max);
    let keep = if excess > KNEE { knee(excess) / excess } else { 1.0 };
    // The clamp takes off rounding only.
    away.map(|step| (grey + step * keep).clamp(0.0, 1.0))
}

fn knee(x: f64) -> f64 {
    if x <= KNEE { x } else { 1.0 - (1.0 - KNEE) * (1.0 - KNEE) / (1.0 + x - 2.0 * KNEE) }
}

/// Whether a screen can show this linear colour as it is.
///
/// ```
/// use nacreous_colour::in_gamut;
/// assert!(in_gamut([0.0, 0.5, 1.0]) && !in_gamut([0.0, 0.5, 1.1]));
/// ```
pub fn in_gamut(rgb: [f64; 3]) -> bool {
    rgb.iter().all(|channel| (-TOLERANCE..=1.0 + TOLERANCE).contains(channel))
}

/// The share, 0 to 1, of colours that a screen cannot show; 0 for no colours at all.
///
/// ```
/// use nacreous_colour::out_of_gamut_share;
/// assert_eq!(out_of_gamut_share([[0.5; 3], [2.0; 3]]), 0.5);
/// ```
pub fn out_of_gamut_share(pixels: impl IntoIterator<Item = [f64; 3]>) -> f64 {
    let (mut all, mut outside) = (0_usize, 0_usize);
    for rgb in pixels {
        all += 1;
        outside += usize::from(!in_gamut(rgb));
    }
    if all == 0 { 0.0 } else { outside as f64 / all as f64 }
}

impl FromStr for Gamut {
    type Err = ColourError;

    fn from_str(name: &str) -> Result<Self, ColourError> {
        match name {
            "clip" => Ok(Self::Clip),
            "soft" => Ok(Self::Soft),
            _ => Err(ColourError::Name {
                quantity: "gamut",
                value: name.to_owned(),
                allowed: "clip, soft",
            }),
        }
    }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exact where nothing is computed")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const SPACES: [RgbSpace; 2] = [RgbSpace::Srgb, RgbSpace::DisplayP3];

    fn any_rgb() -> impl Strategy<Value = [f64; 3]> {
        prop_oneof![
            prop::array::uniform3(-0.5..2.0_f64),
            prop::array::uniform3(-1e12..1e12_f64),
            prop::array::uniform3(-1e-12..1e-12_f64),
        ]
    }

    /// Colour at a distance from the grey of its luminance, along a direction of luminance 0.
    fn away_from_grey(space: RgbSpace, luminance: f64, hue: f64, distance: f64) -> [f64; 3] {
        let direction = [hue.cos(), (hue + 2.0).cos(), (hue + 4.0).cos()];
        let own = space.luminance(direction);
        direction.map(|channel| luminance + distance * (channel - own))
    }

    proptest! {
        #[test]
        fn every_map_ends_inside_the_cube(rgb in any_rgb(), p3 in any::<bool>()) {
            for gamut in [Gamut::Clip, Gamut::Soft] {
                let mapped = gamut.map(SPACES[usize::from(p3)], rgb);
                prop_assert!(mapped.iter().all(|channel| (0.0..=1.0).contains(channel)));
            }
        }

        #[test]
        fn clip_keeps_what_is_inside(rgb in prop::array::uniform3(0.0..=1.0_f64)) {
            prop_assert_eq!(Gamut::Clip.map(RgbSpace::Srgb, rgb), rgb);
        }

        #[test]
        fn soft_keeps_luminance_and_hue_direction(
            luminance in 0.01..0.8_f64, hue in 0.0..6.3_f64, distance in 0.0..3.0_f64,
        ) {
            for space in SPACES {
                let rgb = away_from_grey(space, luminance, hue, distance);
                let mapped = Gamut::Soft.map(space, rgb);
                prop_assert!((space.luminance(mapped) - luminance).abs() < 1e-12);
                let before = rgb.map(|channel| channel - luminance);
                let after = mapped.map(|channel| channel - luminance);
                for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                    prop_assert!((before[i] * after[j] - before[j] * after[i]).abs() < 1e-12);
                }
            }
        }

        #[test]
        fn soft_is_the_identity_well_inside(
            luminance in 0.01..0.8_f64, hue in 0.0..6.3_f64, share in 0.0..0.8_f64,
        ) {
            let unit = away_from_grey(RgbSpace::Srgb, luminance, hue, 1.0);
            let to_surface = unit.map(|channel| {
                if channel > luminance {
                    (1.0 - luminance) / (channel - luminance)
                } else {
                    luminance / (luminance - channel)
                }
            });
            let distance = share * to_surface.iter().fold(f64::INFINITY, |a, &b| a.min(b));
            let rgb = away_from_grey(RgbSpace::Srgb, luminance, hue, distance);
            let mapped = Gamut::Soft.map(RgbSpace::Srgb, rgb);
            for (before, after) in rgb.iter().zip(mapped) {
                prop_assert!((before - after).abs() < 1e-14);
            }
        }

        #[test]
        fn soft_never_reverses_saturation_or_luminance(
            luminance in 0.01..3.0_f64, hue in 0.0..6.3_f64,
            distance in 0.0..2.0_f64, further in 1e-3..1.0_f64,
        ) {
            let space = RgbSpace::Srgb;
            let mapped = |luminance, distance| {
                Gamut::Soft.map(space, away_from_grey(space, luminance, hue, distance))
            };
            let saturation = |rgb: [f64; 3]| {
                let grey = space.luminance(rgb);
                rgb.iter().map(|channel| (channel - grey).abs()).sum::<f64>()
            };
            prop_assert!(
                saturation(mapped(luminance, distance + further))
                    >= saturation(mapped(luminance, distance)) - 1e-12
            );
            prop_assert!(
                space.luminance(mapped(luminance + further, distance))
                    > space.luminance(mapped(luminance, distance))
            );
        }

        #[test]
        fn knee_is_smooth(x in 0.0..4.0_f64) {
            let step = 1e-5;
            let slope = |x: f64| (knee(x + step) - knee(x - step)) / (2.0 * step);
            // Its curvature is at most 2 / (1 - k) = 10, also where the two branches meet.
            prop_assert!((slope(x + 1e-3) - slope(x)).abs() < 1.1e-2);
            prop_assert!((0.0..=1.0 + 1e-9).contains(&slope(x)));
        }
    }

    #[test]
    fn brighter_than_white_runs_into_white() {
        let warm = |strength: f64| {
            Gamut::Soft.map(RgbSpace::Srgb, [1.2 * strength, strength, 0.8 * strength])
        };
        let spread = |rgb: [f64; 3]| rgb[0] - rgb[2];
        assert!(spread(warm(2.0)) < spread(warm(0.9)));
        assert!(spread(warm(50.0)) < 0.02 && warm(50.0)[2] > 0.98);
        assert_eq!(warm(1e300), [1.0; 3]);
    }

    #[test]
    fn unknown_maps_are_refused_with_the_names_that_exist() {
        let error = "hard".parse::<Gamut>().unwrap_err();
        assert_eq!(error.to_string(), "gamut is \"hard\"; allowed: clip, soft");
    }
}
