//! Body colour: nacre that scatters and absorbs, over the nucleus (Kubelka and Munk 1931).

use nacreous_colour::{SAMPLES, Spectrum, reflectance_from_rgb};
use nacreous_image::Body;
use nacreous_nacre::Pigment;
use nacreous_optics::kubelka_munk;

use super::{knobs::spread_of, nacre::stack_of};
use crate::{RenderError, spec::pearl::TransportSpec};

/// What a pearl's body does with light that has entered.
///
/// # Errors
/// [`RenderError`] for a pigment or layers that cannot be.
pub fn body_of(pearl: &TransportSpec) -> Result<Body, RenderError> {
    let of_layers_mm = match pearl.body.nacre_mm {
        Some(nacre_mm) => nacre_mm,
        None => 1e-3 * stack_of(&pearl.nacre)?.total_um(),
    };
    Ok(Body::new(&reflectance_of(pearl, of_layers_mm)?, spread_of(pearl)))
}

/// Reflectance of a pearl's body by wavelength, for light that is inside.
///
/// `of_layers_mm` is the thickness of its layers, for a pearl that leaves `body.nacre_mm` out; more than
/// the pearl's radius counts as the radius.
///
/// # Errors
/// [`RenderError::OutOfRange`] for an unknown pigment.
pub fn reflectance_of(
    pearl: &TransportSpec,
    of_layers_mm: f64,
) -> Result<[f64; SAMPLES], RenderError> {
    let body = &pearl.body;
    let pigment = Pigment::named(&body.pigment).ok_or_else(|| {
        RenderError::out_of_range("body.pigment", &body.pigment, Pigment::NAMES.join(", "))
    })?;
    let absorption = Spectrum::from_fn(|nm| body.pigment_strength * pigment.absorption_per_mm(nm));
    let nacre_mm = body.nacre_mm.unwrap_or_else(|| of_layers_mm.min(0.5 * pearl.diameter_mm));
    let nucleus = reflectance_from_rgb(body.nucleus.0);
    // Half of the bead is as light as its colour, half darker.
    let mean = 1.0 - 0.5 * body.nucleus_bands;
    Ok(std::array::from_fn(|i| {
        let (absorbed, below) = (absorption.values()[i], mean * nucleus.values()[i]);
        kubelka_munk(body.scattering_per_mm, absorbed, nacre_mm, below)
    }))
}

/// Share by which the bands of a pearl's nucleus make light from inside more or less: what is left of them above the
/// nacre, at the green of 550 nm. `of_layers_mm` as for [`reflectance_of`].
///
/// # Errors
/// As [`reflectance_of`].
pub(crate) fn bands_left(pearl: &TransportSpec) -> Result<f64, RenderError> {
    const GREEN: usize = 550 - 380;
    if pearl.body.nucleus_bands <= 0.0 {
        return Ok(0.0);
    }
    let of_layers_mm = 1e-3 * stack_of(&pearl.nacre)?.total_um();
    let by = |bands: f64| {
        let mut other = pearl.clone();
        other.body.nucleus_bands = bands;
        reflectance_of(&other, of_layers_mm).map(|reflectance| reflectance[GREEN])
    };
    // As if all of it were light, and all as dark as its dark bands.
    let (light, dark) = (by(0.0)?, by(2.0 * pearl.body.nucleus_bands)?);
    Ok((light - dark) / (light + dark))
}
