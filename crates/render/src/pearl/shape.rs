//! A pearl's shape and how it lies: what stands in place of values left open.

use nacreous_image::{Dimensions, FormParameters, Pose, Rest, Solid};

use crate::spec::pearl::{PearlSpec, PoseSpec, TransportSpec};

/// What a pearl that is not round is made from.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SolidKey {
    pub(crate) form: FormParameters,
    pub(crate) pose: Pose,
    pub(crate) radius_mm: f64,
}

impl SolidKey {
    /// Makes it.
    pub(crate) fn solid(&self) -> Solid {
        Solid::new(&self.form, self.pose, self.radius_mm)
    }
}

/// A pearl lies down only where that brings its middle lower by more than this share of half its width: one that is
/// round to the eye stays as it is **(ours)**.
const LEAST_DROP: f64 = 0.01;
/// Size of a lump left open, over the pearl's width: a dozen lumps all around **(ours)**.
const LUMP: f64 = 0.6;

/// Heights over half the width that differ by less are the same.
const SAME_HEIGHT: f64 = 0.002;

/// Of a pearl that is not round.
pub(crate) fn solid_key(pearl: &PearlSpec) -> Option<SolidKey> {
    let PearlSpec::Transport(pearl) = pearl else { return None };
    let form = form_of(pearl);
    let radius_mm = 0.5 * pearl.diameter_mm;
    (!form.is_round()).then(|| SolidKey { form, pose: pose_of(pearl), radius_mm })
}

/// Whether a pearl is a ball.
pub(crate) fn is_round(pearl: &TransportSpec) -> bool {
    form_of(pearl).is_round()
}

fn form_of(pearl: &TransportSpec) -> FormParameters {
    let shape = &pearl.shape;
    FormParameters {
        length: shape.length,
        taper: shape.taper,
        flattening: shape.flattening,
        out_of_round: shape.out_of_round,
        lumps: shape.lumps,
        lump_rad: lump_mm_of(pearl) / (0.5 * pearl.diameter_mm),
        circles: shape.circles,
        circle_depth: shape.circle_depth,
        seed: shape.seed.unwrap_or_else(|| pearl.nacre.seed()),
    }
}

/// Size of a lump: the file's, or a share of the pearl's width, so that a pearl of another size has the same form.
pub(crate) fn lump_mm_of(pearl: &TransportSpec) -> f64 {
    pearl.shape.lump_mm.unwrap_or(LUMP * pearl.diameter_mm)
}

/// What a gauge reads of a pearl: the numbers that the trade's words for shapes stand for.
pub fn dimensions_of(pearl: &TransportSpec) -> Dimensions {
    Dimensions::of(&form_of(pearl))
}

/// How a pearl is turned. Left open, a pearl that is not round lies at rest with its axis across the view.
pub(crate) fn pose_of(pearl: &TransportSpec) -> Pose {
    let PoseSpec { turn_deg, tilt_deg, spin_deg } = pearl.pose;
    let posed = |turn_deg: f64, tilt_deg: f64| {
        let [turn, tilt, spin] = [turn_deg, tilt_deg, spin_deg].map(f64::to_radians);
        Pose::new(turn, tilt, spin)
    };
    if let Some(tilt_deg) = tilt_deg {
        return posed(turn_deg, tilt_deg);
    }
    let form = form_of(pearl);
    if form.is_round() {
        return posed(turn_deg, 0.0);
    }
    match tilt_at_rest_deg(&form, |tilt_deg| posed(0.0, tilt_deg)) {
        None => posed(turn_deg, 0.0),
        Some(tilt_deg) => posed(turn_deg + 90.0, tilt_deg),
    }
}

/// The whole degree at which a form's middle of mass is lowest; `None` where lying down brings it hardly lower.
fn tilt_at_rest_deg(form: &FormParameters, posed: impl Fn(f64) -> Pose) -> Option<f64> {
    let rest = Rest::new(form);
    let heights: Vec<f64> = (0..=180).map(|tilt| rest.height(&posed(f64::from(tilt)))).collect();
    let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
    if heights[0] - lowest < LEAST_DROP {
        return None;
    }
    // A pearl that is alike at both ends lies level: what its height differs by next to that is of the places looked at.
    if heights[90] - lowest < SAME_HEIGHT {
        return Some(90.0);
    }
    heights.iter().position(|height| *height <= lowest).map(|tilt| tilt as f64)
}
