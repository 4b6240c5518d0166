//! Microfacets: how they lean, which of them mirrors light to the eye, and how much they hide of each other.
//!
//! Torrance and Sparrow 1967; Walter and others 2007, equations 33 and 34.
//! Left out: light that meets two facets, and waves that the facets' edges bend.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

/// The surface's microfacets: they lean about the normal and mirror, each by itself.
///
/// What a facet mirrors is up to whoever asks: shares here are those of perfect mirrors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Microfacets {
    pub(crate) shape: Shape,
    /// Density at the normal, for facets whose areas projected on the surface add up to it.
    density_at_normal: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    /// Torrance and Sparrow 1967: leans spread as a Gaussian, V-shaped grooves shadow and mask.
    Grooves { spread_rad: f64 },
    /// Walter and others 2007: GGX with Smith's shadowing and masking, each direction by itself.
    Ggx { alpha: f64 },
}

/// A facet that shows a direction of light to the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Glint {
    /// Radiance towards the eye for light of unit irradiance across itself, were facets perfect mirrors.
    pub share: f64,
    /// Cosine of the angle of incidence on the facet.
    pub cos_half: f64,
}

impl Microfacets {
    /// Torrance and Sparrow's facets; `spread_rad` from 0.002 to 0.7 is the standard deviation of the lean.
    pub fn grooves(spread_rad: f64) -> Self {
        let mut microfacets = Self { shape: Shape::Grooves { spread_rad }, density_at_normal: 1.0 };
        microfacets.density_at_normal = 1.0 / microfacets.projected_area();
        microfacets
    }

    /// GGX facets; `alpha` from 0.002 to 1 is about the root of two times the slopes' spread.
    pub fn ggx(alpha: f64) -> Self {
        Self { shape: Shape::Ggx { alpha }, density_at_normal: 1.0 / (PI * alpha * alpha) }
    }

    /// Facets that lean by so much more, a standard deviation of some normals that are looked at together.
    #[must_use]
    pub(crate) fn over(self, normals_rad: f64) -> Self {
        let more = normals_rad * normals_rad;
        if more < NEGLIGIBLE * self.spread_rad() * self.spread_rad() {
            return self;
        }
        let (shape, lower) = match self.shape {
            Shape::Grooves { spread_rad } => {
                let square = spread_rad * spread_rad + more;
                (Shape::Grooves { spread_rad: square.sqrt() }, spread_rad * spread_rad / square)
            }
            Shape::Ggx { alpha } => {
                let square = alpha * alpha + 2.0 * more;
                (Shape::Ggx { alpha: square.sqrt() }, alpha * alpha / square)
            }
        };
        Self { shape, density_at_normal: self.density_at_normal * lower }
    }

    /// The lean that stands for the width of a lobe.
    pub fn spread_rad(&self) -> f64 {
        match self.shape {
            Shape::Grooves { spread_rad } => spread_rad,
            Shape::Ggx { alpha } => alpha * std::f64::consts::FRAC_1_SQRT_2,
        }
    }

    /// The lean beyond which [`Self::mirrored`] is under a millionth (GGX: a thousandth) of its peak.
    pub fn reach_rad(&self) -> f64 {
        match self.shape {
            Shape::Grooves { spread_rad } => 5.3 * spread_rad,
            // (tan / alpha)^2 + 1 = sqrt(1000) or so
            Shape::Ggx { alpha } => libm::atan(5.5 * alpha),
        }
    }

    /// The facet that mirrors `light` to `view`, both unit vectors outward; `None` behind the surface.
    ///
    /// D G / (4 cos_view): the cosine of incidence of the microfacet formula cancels against that of the
    /// irradiance.
    pub fn mirrored(&self, normal: DVec3, view: DVec3, light: DVec3) -> Option<Glint> {
        let (cos_view, cos_light) = (normal.dot(view), normal.dot(light));
        if cos_view <= 0.0 || cos_light <= 0.0 {
            return None;
        }
        let half = (view + light).normalize();
        let (cos_lean, cos_half) = (normal.dot(half).min(1.0), view.dot(half).max(1e-12));
        let seen = match self.shape {
            // Shadowing and masking over cos_view in one, so that grazing views do not divide by zero.
            Shape::Grooves { .. } => {
                let masked = 2.0 * cos_lean / cos_half;
                (1.0 / cos_view).min(masked).min(masked * cos_light / cos_view)
            }
            Shape::Ggx { alpha } => {
                smith_over_cosine(alpha, cos_view) * smith_over_cosine(alpha, cos_light) * cos_light
            }
        };
        Some(Glint { share: 0.25 * self.density(cos_lean) * seen, cos_half })
    }

    /// Facets by solid angle.
    pub(crate) fn density(&self, cos_lean: f64) -> f64 {
        match self.shape {
            Shape::Grooves { spread_rad } => {
                let lean = libm::acos(cos_lean) / spread_rad;
                self.density_at_normal * libm::exp(-0.5 * lean * lean)
            }
            Shape::Ggx { alpha } => ggx_density(alpha, cos_lean),
        }
    }

    /// The integral of density cos(lean) over the hemisphere, by the midpoint rule in the lean.
    fn projected_area(&self) -> f64 {
        const STEPS: u32 = 4096;
        let end = FRAC_PI_2.min(8.0 * self.spread_rad());
        let step = end / f64::from(STEPS);
        let ring = |i| {
            let (sin, cos) = libm::sincos((f64::from(i) + 0.5) * step);
            self.density(cos) * cos * sin
        };
        2.0 * PI * step * (0..STEPS).map(ring).sum::<f64>()
    }
}

/// More variance than this share of a lobe's own shows in no code; by eye **(ours)**.
const NEGLIGIBLE: f64 = 0.002;

/// GGX facets by solid angle (Walter 2007, equation 33).
#[inline]
pub(crate) fn ggx_density(alpha: f64, cos_lean: f64) -> f64 {
    let narrow = 1.0 - cos_lean * cos_lean * (1.0 - alpha * alpha);
    alpha * alpha / (PI * narrow * narrow)
}

/// Smith's share of facets that a direction reaches (Walter 2007, equation 34), over its cosine.
pub(crate) fn smith_over_cosine(alpha: f64, cosine: f64) -> f64 {
    let square = cosine * cosine;
    2.0 / (cosine + (square + alpha * alpha * (1.0 - square)).sqrt())
}
