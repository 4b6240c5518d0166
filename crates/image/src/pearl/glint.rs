//! A lamp's image in the facets, over all normals that a line of sight stands for.
//!
//! Points along the way that the rim turns them, each with facets that lean so much more. Terraces too fine to be seen apart
//! split it into the orders of a grating, by colour.
//! Left out: how the film's colour changes between them, which the lobe hides.

use crate::{
    coat::rulings::Rulings,
    pearl::sight::Sight,
    rgb::{self, Rgb},
    shape::ball::Hit,
    surface::facets::Facets,
    surroundings::lamp::Lamp,
};

/// So many standard deviations of the facets' lean may lie between two points; by eye **(ours)**.
const STEP: f64 = 1.5;
/// The most points.
const MOST: f64 = 8.0;
/// Length of an even line that spreads as an even disc of width 1.
const LINE: f64 = 0.866;

/// The wavelengths that stand for the colours of a lamp's image in orders: the dominant ones of the primaries of sRGB.
const WAVELENGTHS_MM: [f64; 3] = [6.11e-4, 5.49e-4, 4.64e-4];

/// [`Lamp::image`] as `sight` stands for it.
pub(crate) fn glint(
    lamp: &Lamp,
    facets: &Facets<'_>,
    sight: &Sight,
    reflected: impl Fn(f64) -> Rgb,
) -> Rgb {
    let whole = smooth_glint(lamp, facets, sight, &reflected);
    match &sight.local.rulings {
        None => whole,
        Some(rulings) => {
            let split = ordered_glint(lamp, facets, sight, rulings, &reflected);
            rgb::mix(whole, split, rulings.unseen)
        }
    }
}

/// In the orders of rulings, each colour by its wavelength.
fn ordered_glint(
    lamp: &Lamp,
    facets: &Facets<'_>,
    sight: &Sight,
    rulings: &Rulings,
    reflected: impl Fn(f64) -> Rgb,
) -> Rgb {
    let Sight { hit, view, .. } = *sight;
    let spread = sight.spread.less_slopes(rulings.fine_slope2);
    let half = (view + lamp.toward(hit.point)).normalize_or(hit.normal);
    let cosine = half.dot(view);
    let image = |lean: f64| {
        let normal = (hit.normal + rulings.up * lean).normalize();
        let cos_view = normal.dot(view);
        if cos_view <= 0.0 {
            return [0.0; 3];
        }
        let hit = Hit { normal, cos_view, ..hit };
        smooth_glint(lamp, facets, &Sight { hit, spread, ..*sight }, &reflected)
    };
    let mut sum = [0.0; 3];
    for (channel, wavelength_mm) in WAVELENGTHS_MM.into_iter().enumerate() {
        for order in rulings.orders(wavelength_mm, cosine) {
            sum[channel] += order.share * image(order.lean)[channel];
        }
    }
    sum
}

/// Where nothing splits it.
fn smooth_glint(
    lamp: &Lamp,
    facets: &Facets<'_>,
    sight: &Sight,
    reflected: impl Fn(f64) -> Rgb,
) -> Rgb {
    let (hit, view) = (&sight.hit, sight.view);
    // A ray turns by twice what the normal does.
    let length_rad = 0.5 * LINE * sight.spread.outward_rad;
    let count = (length_rad / (STEP * facets.spread_rad())).ceil().clamp(1.0, MOST);
    if count <= 1.0 {
        let facets = facets.over(sight.spread.normals_rad());
        return lamp.image(&facets, hit.point, hit.normal, view, reflected);
    }
    let step_rad = length_rad / count;
    let facets = facets.over(0.29 * step_rad);
    let outward = (hit.normal * hit.cos_view - view).normalize_or_zero();
    let mut sum = [0.0; 3];
    for i in 0..count as usize {
        let (sin, cos) = libm::sincos((i as f64 + 0.5) * step_rad - 0.5 * length_rad);
        let normal = hit.normal * cos + outward * sin;
        let image = lamp.image(&facets, hit.point, normal, view, &reflected);
        rgb::add(&mut sum, rgb::scaled(image, 1.0 / count));
    }
    sum
}
