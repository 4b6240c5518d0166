use glam::DVec3;

use crate::{
    camera::Ray,
    facet::Facets,
    grain::texture::Texture,
    irradiance::Irradiance,
    rgb::{self, Rgb},
    rings::Rings,
    sphere::Hit,
    surroundings::Surroundings,
};

/// How strongly the grain's textures act, per unit of texture and of lightness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grain {
    /// Radians of hue.
    pub hue_rad: f64,
    /// Relative chroma.
    pub chroma: f64,
    /// Relative brightness of what is mirrored.
    pub value: f64,
}

/// How the pearl answers to light, all of it known before the first pixel.
#[derive(Debug)]
pub struct Pearl<'a> {
    /// Interference colour by view angle.
    pub rings: Rings,
    /// Share of interference against body colour.
    pub mixing: f64,
    /// Share of light that the body sends back, linear RGB.
    pub body_colour: Rgb,
    /// Light of the surroundings, lamps apart, on every side of the pearl.
    pub irradiance: Irradiance,
    /// The surface.
    pub facets: Facets,
    /// Share of the mirrored surroundings that the surface leaves clear.
    pub mirror_weight: f64,
    /// Distance over which a mirrored thing fades to 1/e of its contrast with the backdrop.
    pub falloff_mm: f64,
    /// The grain over the sphere, if any.
    pub texture: Option<&'a Texture>,
    /// How strongly it acts.
    pub grain: Grain,
}

/// The light of one point of the pearl, in parts.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Shade {
    /// From the rings; depends on the view angle alone.
    pub interference: Rgb,
    /// From the body.
    pub diffuse: Rgb,
    /// Lamps and surroundings mirrored.
    pub mirror: Rgb,
    /// Grain in hue, value, chroma.
    pub texture: Rgb,
}

impl Pearl<'_> {
    /// What goes from `hit` towards `view`. `pixel_mm` is the width that it stands for on the pearl.
    pub fn shade(
        &self,
        surroundings: &Surroundings,
        hit: &Hit,
        view: DVec3,
        pixel_mm: f64,
    ) -> Shade {
        let radius_mm = surroundings.pearl.radius_mm;
        let texture = self.texture.map_or([0.0; 3], |texture| {
            texture.at(hit.normal, pixel_mm / radius_mm).map(f64::from)
        });
        Shade {
            interference: rgb::scaled(self.rings.colour(hit.cos_view), self.mixing),
            diffuse: rgb::scaled(self.body(surroundings, hit), 1.0 - self.mixing),
            mirror: self.mirror(surroundings, hit, view, pixel_mm),
            texture,
        }
    }

    /// Lambert's law in the body colour.
    fn body(&self, surroundings: &Surroundings, hit: &Hit) -> Rgb {
        let mut light = self.irradiance.at(hit.normal);
        for lamp in &surroundings.lamps {
            rgb::add(&mut light, lamp.matt(hit.point, hit.normal));
        }
        rgb::times(self.body_colour, light)
    }

    /// Lamps by their images in the facets, all else by one mirrored ray that fades with distance.
    fn mirror(&self, surroundings: &Surroundings, hit: &Hit, view: DVec3, pixel_mm: f64) -> Rgb {
        let along = 2.0 * hit.cos_view * hit.normal - view;
        // A pixel's width on the ball turns the normal by that over the radius, and the ray by twice that;
        // a slanted surface turns it faster.
        let spread_rad = 2.0 * pixel_mm / surroundings.pearl.radius_mm / hit.cos_view.max(0.02);
        let seen = surroundings.seen(&Ray { from: hit.point, along }, spread_rad);
        let clear = libm::exp(-seen.distance_mm / self.falloff_mm);
        let faded = if clear < 1.0 && seen.distance_mm.is_finite() {
            rgb::mix(surroundings.backdrop(along, spread_rad), seen.radiance, clear)
        } else {
            seen.radiance
        };
        let mut mirrored =
            rgb::scaled(faded, self.mirror_weight * self.facets.reflectance(hit.cos_view));
        for lamp in &surroundings.lamps {
            let facets = &self.facets;
            let reflected = |cos_half| [facets.reflectance(cos_half); 3];
            let image = lamp.image(&facets.relief, hit.point, hit.normal, view, reflected);
            rgb::add(&mut mirrored, rgb::times(lamp.brightness, image));
        }
        mirrored
    }
}
