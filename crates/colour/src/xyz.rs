//! CIE tristimulus values.

use crate::{Observer, SAMPLES, Spectrum};

/// White of illuminant C for the 2-degree observer (x = 0.31006, y = 0.31616, CIE 015): the white
/// of the Munsell renotation.
pub const WHITE_C: [f64; 3] = xyz_from_xy([0.310_06, 0.316_16]);

/// XYZ with Y = 1 of the chromaticity x, y; y must not be 0.
///
/// ```
/// use nacreous_colour::xyz_from_xy;
/// let [x, y, z] = xyz_from_xy([1.0 / 3.0, 1.0 / 3.0]);
/// assert!((x - 1.0).abs() < 1e-15 && y == 1.0 && (z - 1.0).abs() < 1e-15);
/// ```
pub const fn xyz_from_xy([x, y]: [f64; 2]) -> [f64; 3] {
    [x / y, 1.0, (1.0 - x - y) / y]
}

/// The chromaticity x, y of XYZ; NaN of black.
///
/// ```
/// use nacreous_colour::{xy_from_xyz, xyz_from_xy};
/// let [x, y] = xy_from_xyz(xyz_from_xy([0.31, 0.33]));
/// assert!((x - 0.31).abs() < 1e-15 && (y - 0.33).abs() < 1e-15);
/// ```
pub fn xy_from_xyz(xyz: [f64; 3]) -> [f64; 2] {
    let sum: f64 = xyz.iter().sum();
    [xyz[0] / sum, xyz[1] / sum]
}

/// The plain integral of a spectrum over the matching functions, in steps of 1 nm, unscaled.
///
/// For colours relative to a light, where white has Y = 1, see [`xyz_from_spectrum`].
///
/// ```
/// use nacreous_colour::{Illuminant, Observer, xyz};
/// let [x, y, z] = xyz(&Illuminant::E.spectrum(), Observer::Cie1931);
/// assert!((x / y - 1.0).abs() < 1e-3 && (z / y - 1.0).abs() < 1e-3); // equal energy is white
/// ```
pub fn xyz(spectrum: &Spectrum, observer: Observer) -> [f64; 3] {
    xyz_from_spectrum(observer.matching_functions(), spectrum.values())
}

/// XYZ of a reflectance or another relative spectrum, with weights from [`Observer::weights`].
///
/// ```
/// use nacreous_colour::{Illuminant, Observer, SAMPLES, xyz_from_spectrum};
/// let weights = Observer::Cie1931.weights(&Illuminant::D50.spectrum())?;
/// let grey = xyz_from_spectrum(&weights, &[0.18; SAMPLES]);
/// assert!((grey[1] - 0.18).abs() < 1e-12);
/// # Ok::<(), nacreous_colour::ColourError>(())
/// ```
pub fn xyz_from_spectrum(weights: &[[f64; SAMPLES]; 3], values: &[f64; SAMPLES]) -> [f64; 3] {
    weights.each_ref().map(|channel| channel.iter().zip(values).map(|(w, value)| w * value).sum())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::Illuminant;

    #[test]
    fn whites_of_the_standard_illuminants_are_the_published_ones() {
        // CIE 015, table of chromaticities; integrals over 380 to 780 nm agree to 1e-4.
        for (illuminant, observer, xy) in [
            (Illuminant::A, Observer::Cie1931, [0.447_58, 0.407_45]),
            (Illuminant::D50, Observer::Cie1931, [0.345_67, 0.358_51]),
            (Illuminant::D65, Observer::Cie1931, [0.312_72, 0.329_03]),
            (Illuminant::E, Observer::Cie1931, [1.0 / 3.0, 1.0 / 3.0]),
            (Illuminant::A, Observer::Cie1964, [0.451_17, 0.405_94]),
            (Illuminant::D65, Observer::Cie1964, [0.313_81, 0.330_98]),
        ] {
            let [x, y, z] = xyz(&illuminant.spectrum(), observer);
            let sum = x + y + z;
            assert!((x / sum - xy[0]).abs() < 1e-4, "{illuminant} {observer} {}", x / sum);
            assert!((y / sum - xy[1]).abs() < 1e-4, "{illuminant} {observer} {}", y / sum);
        }
    }

    proptest! {
        #[test]
        fn integration_is_linear(strength in 0.0..10.0_f64, edge_nm in 380.0..780.0) {
            let light = Illuminant::D65.spectrum();
            let long_pass = Spectrum::from_fn(|nm| if nm < edge_nm { 0.0 } else { 1.0 });
            let mixed = &light + &(&long_pass * strength);
            let parts = [&light, &long_pass].map(|part| xyz(part, Observer::Cie1931));
            let whole = xyz(&mixed, Observer::Cie1931);
            for channel in 0..3 {
                let sum = parts[0][channel] + strength * parts[1][channel];
                prop_assert!((whole[channel] - sum).abs() < 1e-9 * whole[1]);
            }
        }
    }
}
