use nacreous_nacre::LayerStack;
use nacreous_optics::{IlluminantModel, OpticsError};

use crate::{
    iridescence::{
        by_angle::ByAngle,
        colours::{interference_spectra, interference_steps},
    },
    light::scene::Light,
    progress::Progress,
    rgb::{self, Rgb},
};

/// The interference colour by view angle: concentric rings on a ball.
///
/// Normalised **(ours)** so that on the disc of a pearl seen from afar the mean luminance is that of
/// the light inside; the illuminant model states no absolute scale, and depth mixes the rings with the
/// body colour.
#[derive(Debug, Clone)]
pub struct Rings(ByAngle);

impl Rings {
    /// Computes spectra by view angle and turns them into colours under the scene's light; `None` once
    /// `progress` says to stop.
    ///
    /// # Errors
    /// What [`IlluminantModel::spectra_unless`] refuses.
    pub fn new(
        stack: &LayerStack,
        model: &IlluminantModel,
        light: &Light,
        progress: &Progress,
    ) -> Result<Option<Self>, OpticsError> {
        let steps = interference_steps(stack, model)?;
        let stop = progress.stop_flag();
        let Some(spectra) = interference_spectra(stack, model, steps, stop)? else {
            return Ok(None);
        };
        let colours: Vec<Rgb> = spectra.iter().map(|row| light.rgb_inside(row)).collect();
        let luminance = mean_over_disc(&colours);
        let scale = if luminance > 0.0 { light.amount() / luminance } else { 0.0 };
        Ok(Some(Self(ByAngle::new(colours).scaled(scale))))
    }

    /// Linear RGB at a view angle, given by its cosine (0 at the rim, 1 in the middle).
    pub fn colour(&self, cos_view: f64) -> Rgb {
        self.0.at(cos_view)
    }
}

/// Mean luminance over the disc of a ball seen from afar, where rings have area 2 c dc.
fn mean_over_disc(colours: &[Rgb]) -> f64 {
    let steps = (colours.len() - 1) as f64;
    let ring = |i: usize| {
        let middle = rgb::mix(colours[i], colours[i + 1], 0.5);
        rgb::luminance(middle) * 2.0 * (i as f64 + 0.5) / steps
    };
    (0..colours.len() - 1).map(ring).sum::<f64>() / steps
}
