use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

/// The pearl's surface as small mirrors that lean about the normal: Torrance and Sparrow 1967.
///
/// Facets lean by an angle alpha with density proportional to exp(-alpha^2 / (2 spread^2)), shadow and
/// mask each other as V-shaped grooves, and reflect by [`Self::reflectance`].
///
/// The paper has Fresnel's reflectance alone; the layers below return light in the mirror direction
/// too, which `layer_reflectance` adds **(ours)**, at 0 the paper exactly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facets {
    spread_rad: f64,
    index: f64,
    layer_reflectance: f64,
    density_at_normal: f64,
}

impl Facets {
    /// `spread_rad` from 0.002 to 0.7: the standard deviation of the lean. `index` is that of the outermost
    /// layer, `layer_reflectance` (0..1) the share of what enters that the layers return.
    pub fn new(spread_rad: f64, index: f64, layer_reflectance: f64) -> Self {
        let mut facets = Self { spread_rad, index, layer_reflectance, density_at_normal: 1.0 };
        facets.density_at_normal = 1.0 / facets.projected_area();
        facets
    }

    /// Standard deviation of the facets' lean.
    pub fn spread_rad(&self) -> f64 {
        self.spread_rad
    }

    /// Share of natural light mirrored at an angle whose cosine is given: Fresnel's share R1, and the
    /// layers' share of the rest.
    pub fn reflectance(&self, cosine: f64) -> f64 {
        let surface = fresnel_reflectance(self.index, cosine);
        surface + (1.0 - surface) * self.layer_reflectance
    }

    /// Radiance towards `view` of light of unit irradiance from `light`, both unit vectors outward.
    ///
    /// D F G / (4 cos_view): the cosine of incidence of Torrance and Sparrow's formula cancels against
    /// that of the irradiance.
    pub fn mirrored(&self, normal: DVec3, view: DVec3, light: DVec3) -> f64 {
        let (cos_view, cos_light) = (normal.dot(view), normal.dot(light));
        if cos_view <= 0.0 || cos_light <= 0.0 {
            return 0.0;
        }
        let half = (view + light).normalize();
        let (cos_lean, cos_half) = (normal.dot(half).min(1.0), view.dot(half).max(1e-12));
        // Shadowing and masking over cos_view in one, so that grazing views do not divide by zero.
        let masked = 2.0 * cos_lean / cos_half;
        let seen = (1.0 / cos_view).min(masked).min(masked * cos_light / cos_view);
        0.25 * self.density(cos_lean) * self.reflectance(cos_half) * seen
    }

    /// The lean beyond which [`Self::mirrored`] is under a millionth of its peak.
    pub fn reach_rad(&self) -> f64 {
        5.3 * self.spread_rad
    }

    /// Facets by solid angle, such that their areas projected on the surface add up to it.
    fn density(&self, cos_lean: f64) -> f64 {
        let lean = libm::acos(cos_lean) / self.spread_rad;
        self.density_at_normal * libm::exp(-0.5 * lean * lean)
    }

    /// The integral of density cos(alpha) over the hemisphere, by the midpoint rule in alpha.
    fn projected_area(&self) -> f64 {
        const STEPS: u32 = 4096;
        let end = FRAC_PI_2.min(8.0 * self.spread_rad);
        let step = end / f64::from(STEPS);
        let ring = |i| {
            let (sin, cos) = libm::sincos((f64::from(i) + 0.5) * step);
            self.density(cos) * cos * sin
        };
        2.0 * PI * step * (0..STEPS).map(ring).sum::<f64>()
    }
}

/// Equation (1) for light from air into a lossless medium, in the closed form without angles.
fn fresnel_reflectance(index: f64, cosine: f64) -> f64 {
    let c = cosine.clamp(0.0, 1.0);
    let g = (index * index - 1.0 + c * c).max(0.0).sqrt();
    let s = ((g - c) / (g + c)).powi(2);
    let p = ((c * (g + c) - 1.0) / (c * (g - c) + 1.0)).powi(2);
    0.5 * s * (1.0 + p)
}

#[cfg(test)]
mod tests {
    use nacreous_nacre::Index;
    use nacreous_optics::fresnel;

    use super::*;

    /// The integral over all directions of light of what `facets` mirrors towards `view`, times cosine.
    fn albedo(facets: &Facets, view: DVec3) -> f64 {
        let (rings, spokes) = (800, 1600);
        let mut sum = 0.0;
        for i in 0..rings {
            let theta = (f64::from(i) + 0.5) * FRAC_PI_2 / f64::from(rings);
            for j in 0..spokes {
                let phi = (f64::from(j) + 0.5) * 2.0 * PI / f64::from(spokes);
                let light =
                    DVec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos());
                // `mirrored` is for unit irradiance across the light: per unit radiance it is that.
                sum += facets.mirrored(DVec3::Z, view, light) * theta.sin();
            }
        }
        sum * (FRAC_PI_2 / f64::from(rings)) * (2.0 * PI / f64::from(spokes))
    }

    #[test]
    fn narrow_facets_mirror_exactly_their_reflectance() {
        let view = DVec3::new(0.6, 0.0, 0.8);
        let facets = Facets::new(0.03, 1.53, 0.1);
        let energy = albedo(&facets, view);
        assert!((energy / facets.reflectance(0.8) - 1.0).abs() < 5e-3, "{energy}");
    }

    #[test]
    fn no_facets_mirror_more_than_they_get() {
        for spread_rad in [0.05, 0.2, 0.6] {
            for cosine in [1.0, 0.5, 0.1_f64] {
                let view = DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
                assert!(albedo(&Facets::new(spread_rad, 1.53, 1.0), view) <= 1.002);
            }
        }
    }

    #[test]
    fn light_and_view_may_change_places() {
        let facets = Facets::new(0.2, 1.53, 0.05);
        let a = DVec3::new(0.3, 0.1, 0.9).normalize();
        let b = DVec3::new(-0.6, 0.4, 0.4).normalize();
        // Helmholtz: radiance over the cosine of incidence is the same both ways.
        let there = facets.mirrored(DVec3::Z, a, b) / b.z;
        let back = facets.mirrored(DVec3::Z, b, a) / a.z;
        assert!((there / back - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_closed_form_is_fresnels_equation_1() {
        let (air, aragonite) =
            (Index::new("air", 1.0, 0.0).unwrap(), Index::new("aragonite", 1.53, 0.0).unwrap());
        for step in 0..=100 {
            let angle = f64::from(step) * 0.0157;
            let exact = fresnel(air, aragonite, angle).unwrap().R();
            assert!((fresnel_reflectance(1.53, angle.cos()) - exact).abs() < 1e-12);
        }
    }
}
