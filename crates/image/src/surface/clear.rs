//! A pearl's smooth surface as light goes through it, to layers that lean against it and back.
//!
//! Snell; radiance over the square of the index is kept along a ray, so solid angles change as n^2 cos (Nicodemus 1963).
//! Left out: dispersion of the directions, and the two directions of one in a crystal (n_o stands for both).

use glam::DVec3;

use crate::surface::{film, microfacets::Glint, sampling::Facet};

/// The boundary between air and nacre, through which light comes to what lies below.
///
/// Light that the layers mirror so obliquely that the boundary mirrors it whole is taken to enter the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Clear {
    index: f64,
    /// Share that it lets through, by the cosine in air.
    passing: Vec<f64>,
}

impl Clear {
    /// Above nacre of `index`; it lets `passing` through, by the cosine in air, evenly from 0 (grazing) to 1.
    pub(crate) fn new(index: f64, passing: Vec<f64>) -> Self {
        Self { index, passing }
    }

    /// Of nacre over air's.
    pub(crate) fn index(&self) -> f64 {
        self.index
    }

    /// Share of light that gets through, at a cosine in air.
    pub(crate) fn passing(&self, cosine: f64) -> f64 {
        let (i, share) = film::place(cosine);
        self.passing[i] + (self.passing[i + 1] - self.passing[i]) * share
    }

    /// The cosine in nacre for one in air.
    pub(crate) fn cos_inside(&self, cosine: f64) -> f64 {
        (1.0 - (1.0 - cosine * cosine).max(0.0) / (self.index * self.index)).sqrt()
    }

    /// The cosine in air for one in nacre, if light gets out there.
    fn cos_outside(&self, cos_inside: f64) -> Option<f64> {
        let square = 1.0 - self.index * self.index * (1.0 - cos_inside * cos_inside);
        (square > 0.0).then(|| square.sqrt().min(1.0))
    }

    /// Where a direction in air, outward, goes on in nacre: the same place aside, less of it.
    pub(crate) fn inside(&self, normal: DVec3, outside: DVec3) -> DVec3 {
        let cosine = normal.dot(outside);
        (outside - normal * cosine) / self.index + normal * self.cos_inside(cosine)
    }

    /// What a facet below sends to `cos_view` from light at `cos_light`, both in air.
    pub(crate) fn glint(&self, below: Glint, cos_view: f64, cos_light: f64) -> Glint {
        let wider = self.index * self.index * self.cos_inside(cos_light) / cos_light;
        let share = below.share * self.passing(cos_view) * self.passing(cos_light) / wider;
        Glint { share, cos_half: self.cos_half(below.cos_half) }
    }

    /// A facet seen below, in the frame where z is the normal, as the eye sees it at `passing` of its own way;
    /// `None` where its light does not come from outside.
    pub(crate) fn facet(&self, below: Facet, passing: f64) -> Option<Facet> {
        let cos_light = self.cos_outside(below.light.z)?;
        let aside = below.light * self.index;
        Some(Facet {
            light: DVec3::new(aside.x, aside.y, cos_light),
            weight: below.weight * passing * self.passing(cos_light),
            cos_half: self.cos_half(below.cos_half),
            density: below.density * cos_light / (self.index * self.index * below.light.z),
        })
    }

    /// The cosine in air of light that comes to a facet below as if it lay level.
    fn cos_half(&self, inside: f64) -> f64 {
        self.cos_outside(inside).unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clear() -> Clear {
        Clear::new(1.683, vec![1.0; film::STEPS + 1])
    }

    #[test]
    fn light_bends_by_snells_law_and_comes_back_the_same_way() {
        let clear = clear();
        for step in 1..=20 {
            let cosine = f64::from(step) / 20.0;
            let outside = DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
            let inside = clear.inside(DVec3::Z, outside);
            assert!((inside.length() - 1.0).abs() < 1e-12);
            assert!((inside.x * 1.683 - outside.x).abs() < 1e-12);
            assert!((clear.cos_outside(inside.z).unwrap() - cosine).abs() < 1e-12);
        }
        assert_eq!(clear.cos_outside(0.7), None);
    }

    #[test]
    fn solid_angles_fill_the_hemisphere_once() {
        // The cone inside that light from the whole hemisphere fills, projected: pi / n^2.
        let clear = clear();
        let below = |cosine: f64| Facet {
            light: DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine),
            weight: 1.0,
            cos_half: 1.0,
            density: 1.0,
        };
        let steps = 20_000;
        let mut projected = 0.0;
        for step in 0..steps {
            let cosine = (f64::from(step) + 0.5) / f64::from(steps);
            if let Some(facet) = clear.facet(below(cosine), 1.0) {
                let ring = 2.0 * std::f64::consts::PI / f64::from(steps);
                projected += facet.light.z * ring / facet.density;
            }
        }
        assert!((projected - std::f64::consts::PI).abs() < 1e-3, "{projected}");
    }
}
