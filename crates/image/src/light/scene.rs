use nacreous_colour::{
    ColourError, Illuminant, Matrix, Observer, RgbSpace, SAMPLES, Spectrum, adaptation,
    matrix::apply, xyz_from_spectrum,
};

use crate::{
    light::{
        bands::{self, Bands, unit},
        palette::Palette,
    },
    rgb::{self, Rgb},
};

/// A light of the scene: its spectrum and its strength.
#[derive(Debug, Clone, PartialEq)]
pub struct Source {
    /// Relative power by wavelength; only its shape counts.
    pub spectrum: Spectrum,
    /// Luminance that it gives to a white matt surface facing it.
    pub intensity: f64,
}

/// All light of a scene: its colours as the camera sees them, and the mixture that gets into the pearl.
#[derive(Debug, Clone)]
pub struct Light {
    /// Of unit luminance by wavelength, observer and the light inside together.
    weights: [[f64; SAMPLES]; 3],
    white: Spectrum,
    observer: Observer,
    amount: f64,
    to_display: Matrix,
}

/// A lamp lights half the pearl; a matt ball facing it is on average half as bright as a matt plane.
const LAMP_SHARE_INSIDE: f64 = 0.5;

impl Light {
    /// The light of `lamps`, windows among them, and of a sky of mean luminance `sky`, which has the spectrum of the scene's
    /// white. `white` is what shall look white; without it, the lamps' own mixture, and without lamps E.
    ///
    /// How much of a lamp's light gets into the pearl does not depend on where it stands: the ball takes
    /// in the same from all sides.
    ///
    /// # Errors
    /// A lamp or a white without visible light, or a white that is too far from white.
    pub fn new(
        lamps: &[Source],
        sky: f64,
        white: Option<Spectrum>,
        observer: Observer,
    ) -> Result<Self, ColourError> {
        let equal_energy = Illuminant::E.spectrum();
        let lamps_mixture = mixture(lamps, observer)?;
        let white =
            unit(&white.unwrap_or_else(|| lamps_mixture.clone()), observer).or_else(|error| {
                if lamps.is_empty() { unit(&equal_energy, observer) } else { Err(error) }
            })?;
        let inside = &(&lamps_mixture * LAMP_SHARE_INSIDE) + &(&white * sky);
        let lamps_amount: f64 = lamps.iter().map(|lamp| lamp.intensity).sum();
        let amount = LAMP_SHARE_INSIDE * lamps_amount + sky;
        let weights = observer.weights(if amount > 0.0 { &inside } else { &white })?;
        let white_xyz = xyz_from_spectrum(&observer.weights(&white)?, equal_energy.values());
        let to_display = adaptation(white_xyz, RgbSpace::Srgb.white_xyz())?;
        Ok(Self { weights, white, observer, amount, to_display })
    }

    /// Linear RGB of a white matt surface that faces a lamp, seen by a camera adapted to the scene.
    ///
    /// # Errors
    /// A lamp without visible light.
    pub fn brightness(&self, lamp: &Source) -> Result<Rgb, ColourError> {
        let weights = self.observer.weights(&lamp.spectrum)?;
        let xyz = xyz_from_spectrum(&weights, Illuminant::E.spectrum().values());
        Ok(rgb::scaled(self.rgb_from_xyz(xyz), lamp.intensity))
    }

    /// How much light spreads inside the pearl, as luminance of a white matt ball on average.
    pub fn amount(&self) -> f64 {
        self.amount
    }

    /// Linear RGB of the light inside after `spectrum` has acted on it; 1 everywhere has luminance 1.
    pub fn rgb_inside(&self, spectrum: &[f64; SAMPLES]) -> Rgb {
        self.rgb_from_xyz(xyz_from_spectrum(&self.weights, spectrum))
    }

    /// How RGB becomes light in bands and back.
    pub fn palette(&self) -> Palette {
        let column =
            |i: usize| self.rgb_from_xyz(std::array::from_fn(|k| f64::from(u8::from(k == i))));
        let columns = [0, 1, 2].map(column);
        let to_rgb = [0, 1, 2].map(|row| columns.map(|column| column[row]));
        Palette::new(&self.white, self.observer, &to_rgb)
    }

    /// Light of a lamp in bands, as sent back by a white matt surface that faces it.
    ///
    /// # Errors
    /// A lamp without visible light.
    pub fn bands(&self, lamp: &Source) -> Result<Bands, ColourError> {
        let spectrum = unit(&lamp.spectrum, self.observer)?;
        Ok(bands::sums(spectrum.values()).map(|power| power * lamp.intensity))
    }

    fn rgb_from_xyz(&self, xyz: [f64; 3]) -> Rgb {
        RgbSpace::Srgb.rgb_from_xyz(apply(&self.to_display, xyz))
    }
}

/// The lamps' light added up by their intensities.
fn mixture(lamps: &[Source], observer: Observer) -> Result<Spectrum, ColourError> {
    let mut sum = Spectrum::from_fn(|_| 0.0);
    for lamp in lamps {
        sum = &sum + &(&unit(&lamp.spectrum, observer)? * lamp.intensity);
    }
    Ok(sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lamp(name: &str, intensity: f64) -> Source {
        Source { spectrum: name.parse::<Illuminant>().unwrap().spectrum(), intensity }
    }

    #[test]
    fn the_lamps_own_mixture_looks_white() {
        for name in ["A", "D50", "E", "8000K"] {
            let light = Light::new(&[lamp(name, 2.0)], 0.3, None, Observer::Cie1931).unwrap();
            let white = light.rgb_inside(&[1.0; SAMPLES]);
            assert!(white.iter().all(|channel| (channel - 1.0).abs() < 1e-9), "{name}: {white:?}");
            let faced = light.brightness(&lamp(name, 2.0)).unwrap();
            assert!(faced.iter().all(|channel| (channel - 2.0).abs() < 1e-9), "{name}: {faced:?}");
            assert!((light.amount() - 1.3).abs() < 1e-12);
        }
    }

    #[test]
    fn a_bulb_looks_warm_to_a_camera_set_to_daylight() {
        let daylight = Some(Illuminant::D65.spectrum());
        let light = Light::new(&[lamp("A", 1.0)], 0.0, daylight, Observer::Cie1931).unwrap();
        let [r, g, b] = light.rgb_inside(&[1.0; SAMPLES]);
        assert!(r > g && g > b, "{r} {g} {b}");
    }

    #[test]
    fn a_lamp_without_visible_light_is_refused() {
        let dark = Source { spectrum: Spectrum::from_fn(|_| 0.0), intensity: 1.0 };
        assert!(Light::new(&[dark], 0.0, None, Observer::Cie1931).is_err());
    }

    #[test]
    fn no_light_at_all_is_black_not_nan() {
        let light = Light::new(&[], 0.0, None, Observer::Cie1964).unwrap();
        assert_eq!(light.amount().to_bits(), 0.0_f64.to_bits());
        assert!(light.rgb_inside(&[1.0; SAMPLES]).iter().all(|channel| channel.is_finite()));
    }
}
