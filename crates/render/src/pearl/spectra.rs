//! What the film of a pearl mirrors, by angle and wavelength.

use std::sync::atomic::AtomicBool;

use nacreous_optics::{Ensemble, TransferModel};

use super::{columns::columns_of, knobs::outer_um_of};
use crate::{RenderError, spec::pearl::TransportSpec};

/// R and T of a pearl's film by exact optics, unpolarised: the mean over its columns, those of its pictures.
///
/// `angle_rad` from 0 to pi / 2, in air; `wavelength_nm` in vacuum. Tables `[angle, wavelength]`, flat and
/// row-major.
///
/// # Errors
/// [`RenderError`] for layers that cannot be, and for angles and wavelengths out of range.
///
/// ```
/// use nacreous_render::{film_spectra, spec::{Recipe, pearl::PearlSpec}};
/// # let json = include_str!("../../../../tests/golden/recipes/akoya-rg-north-window-white.json");
/// let recipe = Recipe::from_json(json)?;
/// let PearlSpec::Transport(pearl) = &recipe.pearls[0] else { panic!("of the other model") };
/// let film = film_spectra(pearl, &[0.0, 0.8], &[450.0, 550.0, 650.0])?;
/// assert_eq!(film.reflectance().len(), 6);
/// assert!(film.reflectance().iter().zip(film.transmittance()).all(|(r, t)| (r + t - 1.0).abs() < 1e-12));
/// # Ok::<(), nacreous_render::RenderError>(())
/// ```
pub fn film_spectra(
    pearl: &TransportSpec,
    angle_rad: &[f64],
    wavelength_nm: &[f64],
) -> Result<Ensemble, RenderError> {
    let columns = columns_of(&pearl.nacre, &pearl.film, outer_um_of(pearl))?;
    let (model, never) = (TransferModel::default(), AtomicBool::new(false));
    let empty = Ensemble::empty(angle_rad.len() * wavelength_nm.len());
    let mean = empty.with(model, &columns, angle_rad, wavelength_nm, &never)?;
    // Nobody can set the flag.
    Ok(mean.unwrap_or_else(|| Ensemble::empty(0)))
}
