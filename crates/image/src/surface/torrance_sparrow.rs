use crate::surface::microfacets::Microfacets;

/// The pearl's surface as small mirrors that lean about the normal: Torrance and Sparrow 1967.
///
/// Facets lean by an angle alpha with density proportional to exp(-alpha^2 / (2 spread^2)), shadow and
/// mask each other as V-shaped grooves ([`Microfacets`]), and reflect by [`Self::reflectance`].
///
/// The paper has Fresnel's reflectance alone; the layers below return light in the mirror direction
/// too, which `layer_reflectance` adds **(ours)**, at 0 the paper exactly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorranceSparrow {
    /// How the facets lean.
    pub microfacets: Microfacets,
    index: f64,
    layer_reflectance: f64,
}

impl TorranceSparrow {
    /// `spread_rad` from 0.002 to 0.7: the standard deviation of the lean. `index` is that of the outermost
    /// layer, `layer_reflectance` (0..1) the share of what enters that the layers return.
    pub fn new(spread_rad: f64, index: f64, layer_reflectance: f64) -> Self {
        Self { microfacets: Microfacets::grooves(spread_rad), index, layer_reflectance }
    }

    /// Share of natural light mirrored at an angle whose cosine is given: Fresnel's share R1, and the
    /// layers' share of the rest.
    pub fn reflectance(&self, cosine: f64) -> f64 {
        let surface = fresnel_reflectance(self.index, cosine);
        surface + (1.0 - surface) * self.layer_reflectance
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
