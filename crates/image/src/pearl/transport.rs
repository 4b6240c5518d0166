use std::f64::consts::PI;

use nacreous_colour::{Matrix, matrix::apply};

use crate::{
    light::{
        bands::{self, Bands},
        palette::Palette,
    },
    pearl::{
        reflection_cache::{Around, ReflectionCache},
        shade::Shade,
        sight::Sight,
        subsurface::{Beam, Body, Subsurface},
    },
    rgb::{self, Rgb},
    surface::{
        coating::{Surface, upsampled},
        film::STEPS,
        sampling::FacetSample,
    },
    surroundings::{environment::Surroundings, lamp::Lamp},
    view::{camera::Camera, ray::Ray},
};

/// A pearl by the transport model (Ozaki and others 2021): what one sees is light that the film mirrors,
/// and light that has been inside and leaves through the film in the complementary colour.
#[derive(Debug, Clone)]
pub struct Transport {
    surface: Surface,
    /// Facets sampled once for all pixels, shared out among the samples along a pixel's side.
    samples: Vec<FacetSample>,
    facets_per_sample: usize,
    /// What the film mirrors of surroundings, from RGB to RGB, by the cosine of incidence.
    mirrored: Vec<Matrix>,
    /// What all facets together mirror of even surroundings, by the cosine of the view angle.
    mirrored_by_all: Vec<Matrix>,
    lamps: Vec<Mirrored>,
    subsurface: Subsurface,
}

/// A lamp, and the colour that the film mirrors of it by the cosine of incidence.
#[derive(Debug, Clone)]
struct Mirrored {
    lamp: Lamp,
    colour: Vec<Rgb>,
}

const COSINES: usize = 8 * STEPS;

impl Transport {
    /// Lets the light of `surroundings` into ball `ball`. `lamps` holds the power by band of each lamp, as
    /// light of a white matt surface that faces it; `samples_side` samples stand along a pixel's side.
    pub fn new(
        surface: Surface,
        body: &Body,
        palette: &Palette,
        surroundings: &Surroundings,
        ball: usize,
        lamps: &[Bands],
        samples_side: usize,
    ) -> Self {
        let microfacets = surface.microfacets;
        let facets_per_sample = facets_per_sample(microfacets.spread_rad());
        let at = |step: usize| surface.film.reflectance(step as f64 / COSINES as f64);
        let kept_out = |entering: &Bands| palette.filtered(&entering.map(|share| 1.0 - share));
        let mirrored_by_all = upsampled(&surface, COSINES).iter().map(kept_out).collect();
        let mirrored = (0..=COSINES).map(|step| palette.filtered(&at(step))).collect();
        let colours = |power: &Bands| {
            (0..=COSINES).map(|step| palette.rgb(&bands::times(&at(step), power))).collect()
        };
        let pairs = surroundings.lamps.iter().zip(lamps);
        let centre = surroundings.balls[ball].centre;
        let beams: Vec<Beam> = pairs
            .clone()
            .map(|(lamp, power)| Beam {
                direction: lamp.toward(centre),
                angular_radius_rad: lamp.angular_radius_rad(),
                // Neighbours shade the whole pearl as they shade its middle.
                power: power.map(|power| power * surroundings.lamp_past(lamp, centre, Some(ball))),
            })
            .collect();
        let subsurface = Subsurface::new(&surface, body, palette, surroundings, ball, &beams);
        let lamps = pairs
            .map(|(lamp, power)| Mirrored {
                lamp: lamp.clone().resolved_for(&microfacets),
                colour: colours(power),
            })
            .collect();
        let samples = microfacets.samples(samples_side * facets_per_sample);
        Self { surface, samples, facets_per_sample, mirrored, mirrored_by_all, lamps, subsurface }
    }

    /// What goes from the point towards the eye, without the grain.
    pub(crate) fn shade(&self, surroundings: &Surroundings, sight: &Sight) -> Shade {
        let hit = &sight.hit;
        let (whole, plain) = self.subsurface.radiance(hit.normal, hit.cos_view);
        let around = sight.around.unwrap_or_else(|| self.around(surroundings, sight));
        let mut mirror = apply(&self.mirrored_by_all[row(hit.cos_view)], around.light);
        rgb::add(&mut mirror, around.rest);
        for Mirrored { lamp, colour } in &self.lamps {
            let (microfacets, reflected) =
                (&self.surface.microfacets, |cos_half| colour[row(cos_half)]);
            let image = lamp.image(microfacets, hit.point, hit.normal, sight.view, reflected);
            if image.iter().any(|part| *part > 0.0) {
                let past = surroundings.lamp_past(lamp, hit.point, Some(sight.ball));
                rgb::add(&mut mirror, rgb::scaled(image, past));
            }
        }
        let interference = std::array::from_fn(|i| whole[i] - plain[i]);
        Shade { interference, diffuse: plain, mirror, ..Shade::default() }
    }

    /// The surroundings in some of the facets that the eye sees, each standing for its part of the lobe:
    /// what is finer is averaged where it is looked up.
    fn around(&self, surroundings: &Surroundings, sight: &Sight) -> Around {
        let first = sight.part * self.facets_per_sample;
        let all = self.samples.iter().cycle().skip(first % self.samples.len());
        let some = all.take(self.facets_per_sample).copied();
        self.gathered(surroundings, sight, some, (self.samples.len(), LOBE))
    }

    /// The cache of what the facets show `camera`, if pixels are finer.
    pub(crate) fn reflection_cache(
        &self,
        surroundings: &Surroundings,
        ball: usize,
        camera: &Camera,
        pixel_mm: f64,
    ) -> Option<ReflectionCache> {
        let microfacets = &self.surface.microfacets;
        let place = &surroundings.balls[ball];
        let pixels = PI * (place.radius_mm / pixel_mm).powi(2);
        let facets = pixels * self.samples.len() as f64;
        ReflectionCache::new(place, camera, microfacets, facets, |hit, view, samples| {
            let sight = Sight { ball, hit, view, pixel_mm, part: 0, around: None };
            self.gathered(surroundings, &sight, samples.iter().copied(), (samples.len(), KNOT_LOBE))
        })
    }

    /// The surroundings in the facets of some samples, of which `count` stand for all facets, each
    /// looked up with `lobe_width` of what it stands for.
    fn gathered(
        &self,
        surroundings: &Surroundings,
        sight: &Sight,
        samples: impl Iterator<Item = FacetSample>,
        (count, lobe_width): (usize, f64),
    ) -> Around {
        let Sight { ball, hit, view, pixel_mm, .. } = *sight;
        let (normal, cos_view) = (hit.normal, hit.cos_view);
        let aside = view - normal * cos_view;
        // Straight from above, what is left of the view aside is rounding.
        let x = if aside.length_squared() > 1e-12 {
            aside.normalize()
        } else {
            normal.any_orthonormal_vector()
        };
        let y = normal.cross(x);
        // A pixel's width on the ball turns the normal by that over the radius, and the ray by twice that;
        // a slanted surface turns it faster.
        let radius_mm = surroundings.balls[ball].radius_mm;
        let pixel_rad = 2.0 * pixel_mm / radius_mm / cos_view.max(0.02);
        let (mut lobe, facets) = (Lobe::default(), self.surface.microfacets.seen_at(cos_view));
        for sample in samples {
            let Some(facet) = facets.facet(sample) else { continue };
            let along = facet.light.x * x + facet.light.y * y + facet.light.z * normal;
            let share_rad2 = lobe_width / (facet.density * count as f64);
            let spread_rad = (pixel_rad * pixel_rad + share_rad2).sqrt();
            let seen = surroundings.seen(&Ray { from: hit.point, along }, spread_rad, Some(ball));
            lobe.add(facet.weight, &self.mirrored[row(facet.cos_half)], seen.radiance);
        }
        lobe.around(&self.mirrored_by_all[row(cos_view)])
    }
}

/// Some facets' view of the surroundings.
#[derive(Debug, Default)]
struct Lobe {
    weight: f64,
    /// Sum of what the film mirrors, from RGB to RGB.
    film: Matrix,
    /// Sum of the surroundings' light, before the film and after it.
    light: Rgb,
    mirrored: Rgb,
}

impl Lobe {
    fn add(&mut self, weight: f64, film: &Matrix, light: Rgb) {
        self.weight += weight;
        for (sum, row) in self.film.iter_mut().zip(film) {
            rgb::add(sum, rgb::scaled(*row, weight));
        }
        rgb::add(&mut self.light, rgb::scaled(light, weight));
        rgb::add(&mut self.mirrored, rgb::scaled(apply(film, light), weight));
    }

    /// Few facets give the surroundings' colours; `all` of them how much is mirrored: exactly where the
    /// surroundings are even (a control variate).
    fn around(&self, all: &Matrix) -> Around {
        let of_white = |film: &Matrix| rgb::luminance(apply(film, [1.0; 3]));
        let some = of_white(&self.film);
        if some <= 0.0 {
            return Around::default();
        }
        let share = of_white(all) / some;
        let light = rgb::scaled(self.light, 1.0 / self.weight);
        let even = apply(&self.film, light);
        Around { light, rest: std::array::from_fn(|i| (self.mirrored[i] - even[i]) * share) }
    }
}

/// Squared width of what a sample is looked up with, in units of its solid angle: neighbours overlap, so that an
/// edge that moves across them leaves no steps.
const LOBE: f64 = 4.0;

/// The same for the knots of a cache, whose many samples need overlap less.
const KNOT_LOBE: f64 = 2.0;

/// A mirror needs few facets, satin more.
fn facets_per_sample(spread_rad: f64) -> usize {
    match spread_rad {
        spread if spread < 0.02 => 4,
        spread if spread < 0.08 => 8,
        _ => 16,
    }
}

fn row(cosine: f64) -> usize {
    (cosine.clamp(0.0, 1.0) * COSINES as f64 + 0.5) as usize
}
