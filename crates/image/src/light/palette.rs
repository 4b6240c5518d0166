use nacreous_colour::{
    Matrix, Observer, Spectrum,
    matrix::{apply, inverse},
};

use crate::{
    light::bands::{BANDS, Bands, samples, sums, times},
    rgb::{self, Rgb},
};

/// How linear RGB becomes light in bands, and light in bands RGB, in one scene.
///
/// Surroundings are known as RGB alone. Their spectrum is taken **(ours)** as that of the scene's white
/// times a sum of three smooth curves that add up to 1: white stays exactly white, and every colour comes
/// back as it was. A colour as pure as the screen's primaries may have a little less than no light in
/// some band.
#[derive(Debug, Clone)]
pub struct Palette {
    /// Linear RGB of unit power in each band.
    rgb: [Rgb; BANDS],
    white: Bands,
    curves: [Bands; 3],
    /// From RGB to amounts of the curves.
    amounts: Matrix,
}

/// Where the curves of blue and green, green and red cross, and how softly.
const CROSSINGS_NM: [f64; 2] = [492.0, 580.0];
const SOFTNESS_NM: f64 = 12.0;

impl Palette {
    /// `white` has luminance 1; `to_display` leads from XYZ relative to it to RGB in which it is 1, 1, 1.
    pub(crate) fn new(white: &Spectrum, observer: Observer, to_display: &Matrix) -> Self {
        let functions = observer.matching_functions();
        let colour = |band: usize| {
            let light = &white.values()[samples(band)];
            let power: f64 = light.iter().sum();
            let xyz = functions.each_ref().map(|function| {
                let seen = function[samples(band)].iter();
                if power > 0.0 {
                    seen.zip(light).map(|(eye, part)| eye * part).sum::<f64>() / power
                } else {
                    seen.sum::<f64>() / light.len() as f64
                }
            });
            apply(to_display, xyz)
        };
        let rgb = std::array::from_fn(colour);
        let power = sums(white.values());
        let curves = curves();
        let column = |curve: &Bands| rgb_of(&rgb, &times(curve, &power));
        let [red, green, blue] = curves.each_ref().map(column);
        let amounts = inverse(&[0, 1, 2].map(|i| [red[i], green[i], blue[i]]));
        Self { rgb, white: power, curves, amounts }
    }

    /// Linear RGB of light in bands.
    pub fn rgb(&self, light: &Bands) -> Rgb {
        rgb_of(&self.rgb, light)
    }

    /// Light in bands of a linear RGB.
    pub fn bands(&self, colour: Rgb) -> Bands {
        let amounts = apply(&self.amounts, colour);
        std::array::from_fn(|band| {
            let sum: f64 = (0..3).map(|i| amounts[i] * self.curves[i][band]).sum();
            self.white[band] * sum
        })
    }

    /// From linear RGB to amounts of the three curves.
    pub(crate) fn amounts(&self) -> &Matrix {
        &self.amounts
    }

    /// The three curves times white in one band.
    pub(crate) fn curves_of_white(&self, band: usize) -> [f64; 3] {
        self.curves.each_ref().map(|curve| curve[band] * self.white[band])
    }

    /// The scene's white behind a filter.
    pub(crate) fn bands_of_white(&self, filter: &Bands) -> Bands {
        times(&self.white, filter)
    }

    /// Linear RGB of unit power in each band.
    pub(crate) fn band_rgb(&self) -> &[Rgb; BANDS] {
        &self.rgb
    }

    /// What a filter makes of linear RGB.
    pub(crate) fn filtered(&self, filter: &Bands) -> Matrix {
        let column = |i: usize| {
            let unit = std::array::from_fn(|k| f64::from(u8::from(k == i)));
            self.rgb(&times(&self.bands(unit), filter))
        };
        let columns = [0, 1, 2].map(column);
        [0, 1, 2].map(|row| columns.map(|column| column[row]))
    }
}

fn rgb_of(unit: &[Rgb; BANDS], light: &Bands) -> Rgb {
    let mut sum = [0.0; 3];
    for (colour, power) in unit.iter().zip(light) {
        rgb::add(&mut sum, rgb::scaled(*colour, *power));
    }
    sum
}

/// Red, green and blue.
fn curves() -> [Bands; 3] {
    let rise = |nm: f64, middle_nm: f64| 1.0 / (1.0 + libm::exp((middle_nm - nm) / SOFTNESS_NM));
    let middle_nm = |band: usize| {
        let part = samples(band);
        nacreous_colour::FIRST_NM + 0.5 * (part.start + part.end - 1) as f64
    };
    let red: Bands = std::array::from_fn(|band| rise(middle_nm(band), CROSSINGS_NM[1]));
    let blue: Bands = std::array::from_fn(|band| 1.0 - rise(middle_nm(band), CROSSINGS_NM[0]));
    [red, std::array::from_fn(|band| 1.0 - red[band] - blue[band]), blue]
}

#[cfg(test)]
mod tests {
    use nacreous_colour::{Illuminant, RgbSpace, adaptation, xyz};

    use super::*;
    use crate::light::bands::unit;

    fn palette(name: &str) -> Palette {
        let observer = Observer::Cie1931;
        let white = unit(&name.parse::<Illuminant>().unwrap().spectrum(), observer).unwrap();
        let to_display = adaptation(xyz(&white, observer), RgbSpace::Srgb.white_xyz()).unwrap();
        let to_rgb = |i: usize| {
            let unit = std::array::from_fn(|k| f64::from(u8::from(k == i)));
            RgbSpace::Srgb.rgb_from_xyz(apply(&to_display, unit))
        };
        let columns = [0, 1, 2].map(to_rgb);
        Palette::new(&white, observer, &[0, 1, 2].map(|row| columns.map(|column| column[row])))
    }

    #[test]
    fn every_colour_comes_back() {
        for name in ["E", "D65", "A", "F11"] {
            let Ok(_) = name.parse::<Illuminant>() else { continue };
            let palette = palette(name);
            for colour in [[1.0; 3], [0.2, 0.5, 0.9], [1.0, 0.0, 0.0], [0.0; 3]] {
                let back = palette.rgb(&palette.bands(colour));
                assert!((0..3).all(|i| (back[i] - colour[i]).abs() < 1e-9), "{name} {colour:?}");
            }
        }
    }

    #[test]
    fn white_has_the_spectrum_of_white_and_a_grey_filter_keeps_every_colour() {
        let palette = palette("D65");
        let light = palette.bands([1.0; 3]);
        assert!(light.iter().zip(&palette.white).all(|(a, b)| (a - b).abs() < 1e-12));
        let grey = apply(&palette.filtered(&[0.5; BANDS]), [0.9, 0.2, 0.4]);
        assert!((0..3).all(|i| (grey[i] - [0.45, 0.1, 0.2][i]).abs() < 1e-9));
    }
}
