//! What a recipe names and does not hold: the contents of files, read by whoever calls.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use nacreous_colour::{Illuminant, Spectrum};
use nacreous_image::{Panorama, grain::spectrum::GrainSpectrum};

use crate::{
    RenderError,
    lights::{is_lit, is_on},
    spec::{Recipe, pearl::PROCEDURAL},
};

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
            None if names_file(name) => Err(RenderError::Missing(name.to_owned())),
            None => Ok(name.parse::<Illuminant>()?.spectrum()),
        }
    }
}

/// Which files a recipe needs the contents of, as the texts that name them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Needs {
    /// Measured lights, of lamps and windows that are on.
    pub spectra: BTreeSet<String>,
    /// Panoramas.
    pub panoramas: BTreeSet<String>,
    /// Photographs whose grain is to be measured, by the number of the pearl.
    pub photographs: BTreeMap<usize, String>,
}

impl Needs {
    /// Of a recipe.
    pub fn of(recipe: &Recipe) -> Self {
        let scene = &recipe.scene;
        let lamps = scene.lamps.iter().filter(|lamp| is_on(lamp)).map(|lamp| &lamp.spectrum);
        let windows = scene.windows.iter().filter(|pane| is_lit(pane)).map(|pane| &pane.spectrum);
        let sources = recipe.pearls.iter().map(|pearl| &pearl.common().texture.source).enumerate();
        Self {
            spectra: lamps.chain(windows).filter(|name| names_file(name)).cloned().collect(),
            panoramas: scene.sky.path.iter().cloned().collect(),
            photographs: sources
                .filter(|(_, source)| *source != PROCEDURAL)
                .map(|(pearl, source)| (pearl, source.clone()))
                .collect(),
        }
    }
}

/// Whether the name of a light is that of a file.
fn names_file(name: &str) -> bool {
    name.to_lowercase().ends_with(".csv")
}
