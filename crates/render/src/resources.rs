//! What a recipe names and does not hold: the contents of files, read by whoever calls.

use std::{collections::BTreeMap, sync::Arc};

use nacreous_colour::{Illuminant, Spectrum};
use nacreous_image::{Panorama, grain::spectrum::GrainSpectrum};

use crate::RenderError;

/// The contents of the files that a recipe names, by the text that names them.
#[derive(Debug, Clone, Default)]
pub struct Resources {
    /// Measured lights.
    pub spectra: BTreeMap<String, Spectrum>,
    /// Panoramas.
    pub panoramas: BTreeMap<String, Arc<Panorama>>,
    /// Grains measured on photographs, by the number of the pearl.
    pub grains: BTreeMap<usize, GrainSpectrum>,
}

impl Resources {
    /// A light by its name, or by the file that was read.
    pub(crate) fn light(&self, name: &str) -> Result<Spectrum, RenderError> {
        match self.spectra.get(name) {
            Some(spectrum) => Ok(spectrum.clone()),
            None if name.to_lowercase().ends_with(".csv") => {
                Err(RenderError::Missing(name.to_owned()))
            }
            None => Ok(name.parse::<Illuminant>()?.spectrum()),
        }
    }
}
