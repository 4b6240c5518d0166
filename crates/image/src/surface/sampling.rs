use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use crate::surface::microfacets::{Microfacets, Shape, ggx_density, smith_over_cosine};

/// Where a sample of the facets falls, wherever the eye is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacetSample {
    /// Grooves: the facet's normal. GGX: a point of the unit disc.
    place: DVec3,
    /// Grooves: facets by solid angle there.
    density: f64,
}

/// A facet that the eye sees, sampled from all those it sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facet {
    /// Where the mirrored light comes from, in the frame of [`FacetsSeen`].
    pub light: DVec3,
    /// How much it counts; its mean over all samples is the share that leaves after one facet.
    pub weight: f64,
    /// Cosine of the angle of incidence on the facet.
    pub cos_half: f64,
    /// Samples for each unit of solid angle of `light`, over the number of samples.
    pub density: f64,
}

impl Microfacets {
    /// `count` samples for [`FacetsSeen::facet`], even over all facets in whole and nearly so in runs.
    pub fn samples(&self, count: usize) -> Vec<FacetSample> {
        self.sampled((0..count).map(even))
    }

    /// The same, evener in whole (Fibonacci's lattice) and not in runs.
    pub fn lattice(&self, count: usize) -> Vec<FacetSample> {
        const GOLDEN: f64 = 0.618_033_988_749_894_8;
        let point = |i: usize| [(i as f64 + 0.5) / count as f64, (i as f64 * GOLDEN).fract()];
        self.sampled((0..count).map(point))
    }

    /// Samples at points of the unit square.
    fn sampled(&self, points: impl Iterator<Item = [f64; 2]>) -> Vec<FacetSample> {
        let lean = self.leans();
        let sample = |[u, v]: [f64; 2]| {
            let (sin, cos) = libm::sincos(2.0 * PI * v);
            match self.shape {
                Shape::Grooves { .. } => {
                    let (across, along) = libm::sincos(lean(u));
                    let place = DVec3::new(across * cos, across * sin, along);
                    FacetSample { place, density: self.density(along) }
                }
                Shape::Ggx { .. } => {
                    FacetSample { place: DVec3::new(cos, sin, 0.0) * u.sqrt(), density: 0.0 }
                }
            }
        };
        points.map(sample).collect()
    }

    /// The lean below which a share of the facets' projected area lies, by the share.
    fn leans(&self) -> impl Fn(f64) -> f64 {
        const STEPS: usize = 1024;
        let step = FRAC_PI_2.min(6.0 * self.spread_rad()) / STEPS as f64;
        let mut below = vec![0.0];
        for i in 0..STEPS {
            let (sin, cos) = libm::sincos((i as f64 + 0.5) * step);
            below.push(below[i] + self.density(cos) * cos * sin);
        }
        move |share| {
            let wanted = share * below[STEPS];
            let i = below.partition_point(|sum| *sum <= wanted).clamp(1, STEPS) - 1;
            let part = (wanted - below[i]) / (below[i + 1] - below[i]);
            (i as f64 + part) * step
        }
    }

    /// The facets as an eye at `cos_view` above 0 sees them.
    pub fn seen_at(&self, cos_view: f64) -> FacetsSeen {
        let view = DVec3::new((1.0 - cos_view * cos_view).max(0.0).sqrt(), 0.0, cos_view);
        let (stretched, masking) = match self.shape {
            Shape::Grooves { .. } => (view, 1.0),
            Shape::Ggx { alpha } => (
                DVec3::new(alpha * view.x, 0.0, view.z).normalize(),
                smith_over_cosine(alpha, cos_view),
            ),
        };
        FacetsSeen { shape: self.shape, view, stretched, masking }
    }
}

/// Facets from one angle, in the frame where z is the normal and the eye stands over the x axis.
#[derive(Debug, Clone, Copy)]
pub struct FacetsSeen {
    shape: Shape,
    view: DVec3,
    /// GGX: the view where facets lean all ways alike.
    stretched: DVec3,
    /// GGX: what the eye reaches of the facets, over its cosine.
    masking: f64,
}

impl FacetsSeen {
    /// The facet of one of the [`Microfacets::samples`], if light comes to it from outside.
    #[inline]
    pub fn facet(&self, sample: FacetSample) -> Option<Facet> {
        let (view, cos_view) = (self.view, self.view.z);
        let lean = match self.shape {
            Shape::Grooves { .. } => sample.place,
            Shape::Ggx { alpha } => visible(alpha, sample.place, self.stretched),
        };
        let cos_half = view.dot(lean);
        let light = 2.0 * cos_half * lean - view;
        if cos_half <= 1e-6 || light.z <= 0.0 {
            return None;
        }
        Some(match self.shape {
            Shape::Grooves { .. } => Facet {
                weight: (cos_half / (cos_view * lean.z)).min(2.0).min(2.0 * light.z / cos_view),
                density: sample.density * lean.z / (4.0 * cos_half),
                light,
                cos_half,
            },
            Shape::Ggx { alpha } => Facet {
                weight: smith_over_cosine(alpha, light.z) * light.z,
                density: 0.25 * ggx_density(alpha, lean.z) * self.masking,
                light,
                cos_half,
            },
        })
    }
}

/// A facet among those seen, from a point of the unit disc (Heitz 2018); `stretched` lies over the x axis.
#[inline]
fn visible(alpha: f64, DVec3 { x, y, .. }: DVec3, stretched: DVec3) -> DVec3 {
    let half = 0.5 * (1.0 + stretched.z);
    let bent = (1.0 - half) * (1.0 - x * x).max(0.0).sqrt() + half * y;
    let rest = (1.0 - x * x - bent * bent).max(0.0).sqrt();
    // The axis across is y, the third one z turned by the view.
    let along = rest * stretched.x - bent * stretched.z;
    let up = rest * stretched.z + bent * stretched.x;
    DVec3::new(alpha * along, alpha * x, up.max(1e-9)).normalize()
}

/// The i-th of points that fill the unit square evenly, in runs too (Roberts 2018, R2).
pub(crate) fn even(i: usize) -> [f64; 2] {
    const PLASTIC: f64 = 1.324_717_957_244_746;
    let step = |power: f64| (0.5 + (i as f64 + 1.0) / power).fract();
    [step(PLASTIC), step(PLASTIC * PLASTIC)]
}

#[cfg(test)]
mod tests {
    use rand_chacha::ChaCha8Rng;
    use rand_core::{Rng, SeedableRng};

    use super::*;

    const MICROFACETS: [fn(f64) -> Microfacets; 2] = [Microfacets::grooves, Microfacets::ggx];

    /// The integral over all light of what mirrors show to `view`.
    fn albedo(microfacets: &Microfacets, view: DVec3) -> f64 {
        let (rings, spokes) = (600, 1200);
        let mut sum = 0.0;
        for i in 0..rings {
            let theta = (f64::from(i) + 0.5) * FRAC_PI_2 / f64::from(rings);
            for j in 0..spokes {
                let phi = (f64::from(j) + 0.5) * 2.0 * PI / f64::from(spokes);
                let light =
                    DVec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos());
                sum += microfacets.mirrored(DVec3::Z, view, light).map_or(0.0, |g| g.share)
                    * theta.sin();
            }
        }
        sum * (FRAC_PI_2 / f64::from(rings)) * (2.0 * PI / f64::from(spokes))
    }

    fn towards(cosine: f64) -> DVec3 {
        DVec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine)
    }

    #[test]
    fn facets_sampled_agree_with_the_integral_over_all_light() {
        for make in MICROFACETS {
            for spread in [0.05, 0.2, 0.5] {
                let microfacets = make(spread);
                let samples = microfacets.samples(4096);
                for cosine in [1.0, 0.7, 0.3] {
                    let seen = microfacets.seen_at(cosine);
                    let facets = samples.iter().filter_map(|sample| seen.facet(*sample));
                    let sampled = facets.map(|facet| facet.weight).sum::<f64>() / 4096.0;
                    let exact = albedo(&microfacets, towards(cosine));
                    assert!(
                        (sampled - exact).abs() < 0.01,
                        "{microfacets:?} {cosine}: {sampled} {exact}"
                    );
                    assert!(exact < 1.002, "{microfacets:?} {cosine}: {exact}");
                }
            }
        }
    }

    #[test]
    fn samples_are_as_dense_as_they_say() {
        // The mean of 1 / density over the samples is the solid angle that they can reach: for narrow
        // facets weight times density is what `mirrored` states.
        for make in MICROFACETS {
            let microfacets = make(0.2);
            for sample in microfacets.samples(64) {
                let Some(facet) = microfacets.seen_at(0.6).facet(sample) else { continue };
                let stated = microfacets.mirrored(DVec3::Z, towards(0.6), facet.light).unwrap();
                assert!((stated.share / (facet.weight * facet.density) - 1.0).abs() < 1e-6);
                assert!((stated.cos_half - facet.cos_half).abs() < 1e-9);
            }
        }
    }

    /// Where facets throw light that comes from a patch of directions: the flux into another patch, and
    /// how well it is known, by random starts and the facets that are sampled for them.
    fn flux(microfacets: &Microfacets, from: (f64, f64), to: (f64, f64), seed: u64) -> (f64, f64) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut uniform = || (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
        let samples = microfacets.samples(40_000);
        let (mut sum, mut squares) = (0.0, 0.0);
        for sample in &samples {
            // Patches: a range of the cosine, all around.
            let cos_view = from.0 + (from.1 - from.0) * uniform();
            let thrown = microfacets.seen_at(cos_view).facet(*sample);
            let hit = thrown.filter(|facet| to.0 <= facet.light.z && facet.light.z < to.1);
            let flux = hit.map_or(0.0, |facet| cos_view * facet.weight) * (from.1 - from.0);
            sum += flux;
            squares += flux * flux;
        }
        let count = samples.len() as f64;
        let mean = sum / count;
        (mean, ((squares / count - mean * mean) / count).sqrt())
    }

    #[test]
    fn as_much_light_goes_one_way_as_the_other() {
        // Helmholtz's reciprocity of what is sampled, statistically: within four standard errors.
        for (i, make) in MICROFACETS.iter().enumerate() {
            for spread in [0.1, 0.3] {
                let microfacets = make(spread);
                for (one, other) in [((0.9, 1.0), (0.6, 0.8)), ((0.3, 0.5), (0.5, 0.9))] {
                    let seed = i as u64;
                    let (there, error) = flux(&microfacets, one, other, seed);
                    let (back, error_back) = flux(&microfacets, other, one, seed + 9);
                    let allowed = 4.0 * error.hypot(error_back);
                    assert!(
                        there > 0.0 && (there - back).abs() < allowed,
                        "{there} {back} {error}"
                    );
                }
            }
        }
    }

    #[test]
    fn light_and_view_may_change_places() {
        // Helmholtz, on directions all over the hemisphere: radiance over the cosine of incidence is the same.
        for make in [Microfacets::grooves, Microfacets::ggx] {
            let microfacets = make(0.3);
            for i in 0..400 {
                let direction = |k: usize| {
                    let [u, v] = even(2 * i + k);
                    let (sin, cos) = (2.0 * PI * v).sin_cos();
                    let across = (1.0 - u * u).sqrt();
                    DVec3::new(across * cos, across * sin, u.max(0.01)).normalize()
                };
                let (a, b) = (direction(0), direction(1));
                let there = microfacets.mirrored(DVec3::Z, a, b).unwrap().share / b.z;
                let back = microfacets.mirrored(DVec3::Z, b, a).unwrap().share / a.z;
                assert!((there - back).abs() <= 1e-12 * there, "{a} {b}: {there} {back}");
            }
        }
    }
}
