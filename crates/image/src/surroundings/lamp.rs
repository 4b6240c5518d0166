//! A round lamp: its light on matt surfaces and its image in facets.
//!
//! A parabola for a disc behind the horizon; the microfacets' lobe summed over points of the disc.
//! Left out: that a near lamp is stronger on the side that faces it **(ours)**.

use glam::DVec3;

use crate::{
    rgb::{self, Rgb},
    surface::facets::Facets,
};

/// Where a lamp stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// So far away that its light comes from one direction (unit vector towards it).
    Direction(DVec3),
    /// At a point in mm. Its light is stated at the pearl's centre and taken as equally strong
    /// everywhere near it **(ours)**, so that moving a lamp changes no interference colour.
    Position(DVec3),
}

/// A round lamp: an evenly bright disc in the sky.
#[derive(Debug, Clone, PartialEq)]
pub struct Lamp {
    place: Place,
    angular_radius_rad: f64,
    /// Its sine and cosine.
    disc: (f64, f64),
    /// Linear RGB of a white matt surface that faces the lamp.
    pub brightness: Rgb,
    /// Points of equal weight over the unit disc that stand for the lamp in highlights.
    points: Vec<[f64; 2]>,
    /// Whether facets' leans spread by the lamp's width, for which then one point stands.
    blurs: bool,
}

impl Lamp {
    /// `angular_radius_rad` above 0, up to 0.6, seen from the pearl.
    pub fn new(place: Place, angular_radius_rad: f64, brightness: Rgb) -> Self {
        let disc = libm::sincos(angular_radius_rad);
        Self { place, angular_radius_rad, disc, brightness, points: vec![[0.0; 2]], blurs: false }
    }

    /// Chooses as many points as facets this even need for a smooth image of the lamp: mirrored, they
    /// lie half as far apart, and a lobe hides spacings up to two thirds of its standard deviation.
    #[must_use]
    pub fn resolved_for(mut self, facets: &Facets<'_>) -> Self {
        let rings = (0.75 * self.angular_radius_rad / facets.spread_rad()).ceil().max(1.0) as usize;
        self.points =
            disc(if self.angular_radius_rad > 0.2 * facets.spread_rad() { rings + 1 } else { 1 });
        self
    }

    /// Lets facets whose lobe is nearly as wide as the lamp, or wider, take it for a point and lean by its width more.
    #[must_use]
    pub(crate) fn blurred_for(self, facets: &Facets<'_>) -> Self {
        if self.angular_radius_rad > 1.3 * facets.spread_rad() {
            return self.resolved_for(facets);
        }
        Self { points: vec![[0.0; 2]], blurs: true, ..self }
    }

    /// Angular radius of the disc.
    pub fn angular_radius_rad(&self) -> f64 {
        self.angular_radius_rad
    }

    /// Sine and cosine of that.
    pub(crate) fn disc(&self) -> (f64, f64) {
        self.disc
    }

    /// Unit vector from `point` to the middle of the lamp.
    pub fn toward(&self, point: DVec3) -> DVec3 {
        match self.place {
            Place::Direction(direction) => direction,
            Place::Position(position) => (position - point).normalize(),
        }
    }

    /// Linear RGB of a white matt surface at `point`. Where the surface's horizon cuts the disc, light
    /// fades over the disc's width: a parabola in place of the exact integral, right to 0.03 of the
    /// lamp's radius.
    pub fn matt(&self, point: DVec3, normal: DVec3) -> Rgb {
        let cosine = self.toward(point).dot(normal);
        let width = libm::sin(self.angular_radius_rad);
        let lit = if cosine.abs() < width {
            (cosine + width).powi(2) / (4.0 * width)
        } else {
            cosine.max(0.0)
        };
        rgb::scaled(self.brightness, lit)
    }

    /// Radiance of the lamp's image in facets at `point`, for a lamp whose white matt surface has
    /// radiance 1, that is of irradiance pi. A facet mirrors `reflected` of the cosine of incidence.
    pub fn image(
        &self,
        facets: &Facets<'_>,
        point: DVec3,
        normal: DVec3,
        view: DVec3,
        reflected: impl Fn(f64) -> Rgb,
    ) -> Rgb {
        let mut sum = [0.0; 3];
        let middle = self.toward(point);
        let facets = if self.blurs {
            facets.over(self.half_vectors_rad((view + middle).length()))
        } else {
            *facets
        };
        if facets.miss(normal, view, middle, self.angular_radius_rad) {
            return sum;
        }
        let (a, b) = middle.any_orthonormal_pair();
        let radius = libm::tan(self.angular_radius_rad);
        for [x, y] in &self.points {
            let light = (middle + (a * *x + b * *y) * radius).normalize();
            if let Some(glint) = facets.mirrored(normal, view, light) {
                rgb::add(&mut sum, rgb::scaled(reflected(glint.cos_half), glint.share));
            }
        }
        rgb::scaled(sum, std::f64::consts::PI / self.points.len() as f64)
    }

    /// How far half vectors spread over the disc, the root of the mean square of two directions, where their sum has
    /// a length: half as far as a disc's points, in the plane of light and view, and more across it.
    fn half_vectors_rad(&self, length: f64) -> f64 {
        let across = 2.0 / length.max(0.1);
        0.25 * self.angular_radius_rad * (0.5 + 0.5 * across * across).sqrt()
    }
}

/// Points of equal area over the unit disc: a middle and rings of six, twelve, eighteen ...
fn disc(rings: usize) -> Vec<[f64; 2]> {
    let mut points = vec![[0.0; 2]];
    // Ring k of n holds the area between (k - 1/2) / (n - 1/2) and (k + 1/2) / (n - 1/2): equal areas
    // to each of 1 + 3 n (n - 1) points come of the count 6 k growing like the area.
    let total = (1 + 3 * rings * (rings - 1)) as f64;
    let mut inside = 1.0;
    for ring in 1..rings {
        let count = 6 * ring;
        let radius = ((inside + 0.5 * count as f64) / total).sqrt();
        inside += count as f64;
        points.extend((0..count).map(|i| {
            let turn = (i as f64 + 0.5 * (ring % 2) as f64) / count as f64;
            let (sin, cos) = libm::sincos(2.0 * std::f64::consts::PI * turn);
            [radius * cos, radius * sin]
        }));
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{clear::Clear, microfacets::Microfacets};

    #[test]
    fn points_have_the_second_moment_of_an_even_disc() {
        for rings in 2..12 {
            let points = disc(rings);
            let moment =
                points.iter().map(|[x, y]| x * x + y * y).sum::<f64>() / points.len() as f64;
            assert!((moment - 0.5).abs() < 0.5 / points.len() as f64, "{rings}: {moment}");
        }
    }

    #[test]
    fn a_matt_surface_meets_the_integral_over_the_disc() {
        let lamp = Lamp::new(Place::Direction(DVec3::Y), 0.2, [1.0; 3]);
        for step in 0..40 {
            let turn = 1.2 + f64::from(step) * 0.02;
            let normal = DVec3::new(turn.sin(), turn.cos(), 0.0);
            let cosines = disc(80).into_iter().map(|[x, z]| {
                DVec3::new(x * 0.2_f64.tan(), 1.0, z * 0.2_f64.tan())
                    .normalize()
                    .dot(normal)
                    .max(0.0)
            });
            let exact = cosines.sum::<f64>() / disc(80).len() as f64;
            let got = lamp.matt(DVec3::ZERO, normal)[0];
            assert!((got - exact).abs() < 0.03 * 0.2 + 0.005, "{turn}: {got} {exact}");
        }
    }

    #[test]
    fn a_lamp_narrower_than_the_lobe_may_be_a_point_in_a_wider_one() {
        let clear = Clear::new(1.683, vec![1.0; 129]);
        for below in [None, Some(&clear)] {
            let facets = Facets::new(Microfacets::grooves(0.1), below);
            let lamp = Lamp::new(Place::Direction(DVec3::Y), 0.12, [1.0; 3]);
            let mut brute = lamp.clone();
            brute.points = disc(40);
            let lamp = lamp.blurred_for(&facets);
            let image = |lamp: &Lamp, normal| {
                lamp.image(&facets, DVec3::ZERO, normal, DVec3::Z, |_| [1.0; 3])[0]
            };
            let peak = image(&brute, (DVec3::Z + DVec3::Y).normalize());
            for step in -30..=30 {
                let turn = std::f64::consts::FRAC_PI_4 + f64::from(step) * 0.02;
                let normal = DVec3::new(0.02, turn.sin(), turn.cos()).normalize();
                let (one, many) = (image(&lamp, normal), image(&brute, normal));
                assert!((one - many).abs() < 0.025 * peak, "{turn}: {one} {many} of {peak}");
            }
        }
    }

    #[test]
    fn points_chosen_for_the_facets_agree_with_brute_force() {
        let facets = Facets::new(Microfacets::grooves(0.03), None);
        let lamp = Lamp::new(Place::Direction(DVec3::Y), 0.1, [1.0; 3]).resolved_for(&facets);
        let image = |lamp: &Lamp, normal, view| {
            lamp.image(&facets, DVec3::ZERO, normal, view, |_| [1.0; 3])[0]
        };
        let mut brute = lamp.clone();
        brute.points = disc(60);
        let view = DVec3::Z;
        let peak = image(&brute, (view + DVec3::Y).normalize(), view);
        for step in -40..=40 {
            let turn = std::f64::consts::FRAC_PI_4 + f64::from(step) * 0.005;
            let normal = DVec3::new(0.02, turn.sin(), turn.cos()).normalize();
            let (few, many) = (image(&lamp, normal, view), image(&brute, normal, view));
            assert!((few - many).abs() < 0.015 * peak, "{few} {many}");
        }
    }
}
