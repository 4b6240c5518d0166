//! What differs from place to place on a pearl, and how many films tell it apart.

use nacreous_image::{BlemishKind, Blemishes, CoatParameters, Drill, NucleusBands, Pose};

use super::{body::bands_left, shape::pose_of};
use crate::{
    RenderError,
    spec::pearl::{CoatSpec, PearlSpec, TransportSpec},
};

/// Films for layers of different thickness lie so far apart, as a share of it **(ours)**: 11 nm at green, a quarter of
/// the width of a band in the colours of ordered nacre.
pub(crate) const FILM_STEP: f64 = 0.02;

/// How many films a pearl's thickness takes: an odd number, the middle one of layers as thick as on average.
pub(crate) fn films_of(pearl: &TransportSpec) -> usize {
    let range = coat_of(pearl, Pose::new(0.0, 0.0, 0.0)).thickness_range();
    1 + 2 * libm::ceil(range / FILM_STEP - 1e-9) as usize
}

/// The thickness of the layers of each of so many films, over the middle one's.
pub(crate) fn thickness_of(films: usize) -> impl Iterator<Item = f64> {
    let middle = (films / 2) as f64;
    (0..films).map(move |film| 1.0 + FILM_STEP * (film as f64 - middle))
}

/// What a pearl's coat is made from; `None` where it is the same everywhere and turned as it grew.
///
/// # Errors
/// [`RenderError`] for a body or layers that cannot be.
pub(crate) fn parameters_of(pearl: &PearlSpec) -> Result<Option<CoatParameters>, RenderError> {
    let PearlSpec::Transport(pearl) = pearl else { return Ok(None) };
    let mut coat = coat_of(pearl, pose_of(pearl));
    coat.nucleus.contrast = bands_left(pearl)?;
    let is_turned = coat.pose != Pose::new(0.0, 0.0, 0.0);
    Ok((!coat.is_even() || is_turned).then_some(coat))
}

fn coat_of(pearl: &TransportSpec, pose: Pose) -> CoatParameters {
    let CoatSpec { thickness_spread, patch_mm, banding, liveliness, .. } = pearl.coat;
    let (coat, blemishes) = (&pearl.coat, &pearl.blemishes);
    let seed = |given: Option<u64>| given.unwrap_or_else(|| pearl.nacre.seed());
    CoatParameters {
        radius_mm: 0.5 * pearl.diameter_mm,
        pose,
        seed: seed(coat.seed),
        thickness_spread,
        patch_mm,
        banding,
        liveliness,
        hammering_rad: coat.hammering_rad,
        dent_mm: coat.dent_mm,
        terrace_mm: 1e-3 * coat.terrace_um,
        step_mm: 1e-6 * coat.terrace_step_nm,
        blemishes: Blemishes {
            counts: vec![
                (BlemishKind::Pit, blemishes.pits),
                (BlemishKind::Bump, blemishes.bumps),
                (BlemishKind::Scratch, blemishes.scratches),
                (BlemishKind::Wrinkle, blemishes.wrinkles),
                (BlemishKind::Chalk, blemishes.chalky_spots),
            ],
            size_mm: blemishes.size_mm,
            depth_mm: 1e-3 * blemishes.depth_um,
            area: blemishes.area,
            seed: seed(blemishes.seed),
        },
        drill: Drill { radius_mm: 0.5 * pearl.shape.drill_mm, wear_mm: pearl.shape.drill_wear_mm },
        nucleus: NucleusBands { contrast: 0.0, band_mm: pearl.body.nucleus_band_mm },
    }
}
