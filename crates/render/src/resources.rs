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

/// The most numbers of a panorama's pixels, as for a file of one.
const MOST_NUMBERS: usize = 3 << 26;

impl Resources {
    /// Adds a panorama, linear RGB row by row from the zenith down; what is below zero becomes zero.
    ///
    /// # Errors
    /// [`RenderError::OutOfRange`] for a picture without pixels, too large or of another size than said, and
    /// for values that are not finite.
    pub fn add_panorama(
        &mut self,
        name: &str,
        (width, height): (usize, usize),
        rgb: &[f32],
    ) -> Result<(), RenderError> {
        let numbers = width.saturating_mul(height).saturating_mul(3);
        if !(1..=MOST_NUMBERS).contains(&numbers) || rgb.len() != numbers {
            let given = format!("{} numbers for {width} x {height} pixels", rgb.len());
            let allowed = format!("three numbers a pixel, 3 to {MOST_NUMBERS}");
            return Err(RenderError::OutOfRange {
                quantity: format!("panorama {name}"),
                value: given,
                allowed,
            });
        }
        if let Some(value) = rgb.iter().find(|value| !value.is_finite()) {
            let quantity = format!("panorama {name}: a value");
            return Err(RenderError::out_of_range(quantity, value, "finite numbers"));
        }
        let (pixels, _) = rgb.as_chunks::<3>();
        let pixels = pixels.iter().map(|pixel| pixel.map(|channel| channel.max(0.0))).collect();
        let panorama = Arc::new(Panorama::new(width, height, pixels));
        self.panoramas.insert(name.to_owned(), panorama);
        Ok(())
    }

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
