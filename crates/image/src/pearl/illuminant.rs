//! A pearl by the model of 1996: rings, matt body, mirroring surface.
//!
//! The paper, equations 1 to 4 and section 4; Lambert; Torrance and Sparrow.
//! Left out: light that goes through the film and out again, and what the pearl gives its table.

use std::sync::Arc;

use crate::{
    iridescence::rings::Rings,
    pearl::{glint::glint, shade::Shade, sight::Sight},
    rgb::{self, Rgb},
    surface::{facets::Facets, torrance_sparrow::TorranceSparrow},
    surroundings::{irradiance::Irradiance, lit::Lit},
    view::{cone::Cone, ray::Ray},
};

/// A pearl by the model of 1996: rings of interference colour by the view angle alone, a matt body, and a
/// mirroring surface.
#[derive(Debug)]
pub struct IlluminantPearl {
    /// Interference colour by view angle.
    pub rings: Arc<Rings>,
    /// Share of interference against body colour.
    pub mixing: f64,
    /// Share of light that the body sends back, linear RGB.
    pub body_colour: Rgb,
    /// Light of the surroundings, lamps apart, on every side of the pearl where it lies.
    pub irradiance: Irradiance,
    /// The surface.
    pub facets: TorranceSparrow,
    /// Share of the mirrored surroundings that the surface leaves clear.
    pub mirror_weight: f64,
    /// Distance over which a mirrored thing fades to 1/e of its contrast with the backdrop.
    pub falloff_mm: f64,
}

impl IlluminantPearl {
    /// What goes from the point towards the eye, without the grain.
    pub(crate) fn shade(&self, surroundings: &Lit, sight: &Sight) -> Shade {
        Shade {
            interference: self.interference(sight.hit.cos_view),
            diffuse: rgb::scaled(self.body(surroundings, sight), 1.0 - self.mixing),
            mirror: self.mirror(surroundings, sight),
            ..Shade::default()
        }
    }

    /// The rings' share of the light, by the view angle alone.
    pub(crate) fn interference(&self, cos_view: f64) -> Rgb {
        rgb::scaled(self.rings.colour(cos_view), self.mixing)
    }

    /// Lambert's law in the body colour.
    fn body(&self, surroundings: &Lit, sight: &Sight) -> Rgb {
        let Sight { ball, hit, .. } = sight;
        let mut light = self.irradiance.at(hit.normal);
        for lamp in &surroundings.lamps {
            let past = surroundings.lamp_past(lamp, hit.point, Some(*ball));
            rgb::add(&mut light, rgb::scaled(lamp.matt(hit.point, hit.normal), past));
        }
        rgb::times(self.body_colour, light)
    }

    /// Whether what a line of sight stands for may show the edge of a mirrored window.
    pub(crate) fn has_window_edges(surroundings: &Lit, sight: &Sight) -> bool {
        let along = 2.0 * sight.hit.cos_view * sight.hit.normal - sight.view;
        let panes = surroundings.windows.iter().filter_map(|w| w.before(sight.hit.point));
        panes.into_iter().any(|pane| pane.has_edge_within(along, sight.spread.outward_rad))
    }

    /// Lamps by their images in the facets, all else by one mirrored ray that fades with distance.
    fn mirror(&self, surroundings: &Lit, sight: &Sight) -> Rgb {
        let Sight { ball, hit, view, spread, .. } = *sight;
        let along = 2.0 * hit.cos_view * hit.normal - view;
        let outward = view.cross(hit.normal).cross(along).normalize_or_zero();
        let cone = Cone::stretched(spread.around_rad, spread.outward_rad, outward);
        let ray = Ray { from: hit.point, along };
        let faded = surroundings.faded(&ray, &cone, Some(ball), self.falloff_mm);
        let mut mirrored =
            rgb::scaled(faded, self.mirror_weight * self.facets.reflectance(hit.cos_view));
        for lamp in &surroundings.lamps {
            let reflected = |cos_half| [self.facets.reflectance(cos_half); 3];
            let facets = Facets::new(self.facets.microfacets, None);
            let image = glint(lamp, &facets, sight, reflected);
            if image[0] > 0.0 {
                let past = surroundings.lamp_past(lamp, hit.point, Some(ball));
                rgb::add(&mut mirrored, rgb::times(lamp.brightness, rgb::scaled(image, past)));
            }
        }
        mirrored
    }
}
