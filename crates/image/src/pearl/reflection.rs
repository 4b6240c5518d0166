//! What one lobe of a pearl mirrors of lamps and surroundings.
//!
//! Facets sampled, with a control variate for what all of them mirror; lamps by their images.
//! Left out: polarisation between film and surroundings, and light that meets two facets.

use std::{f64::consts::PI, sync::Arc};

use glam::DVec3;
use nacreous_colour::matrix::apply;

use crate::{
    coat::local::Local,
    light::glow::DISC_POINTS,
    pearl::{
        films::FilmAt,
        gathered::Gathered,
        glint::glint,
        lobe_colours::LobeColours,
        reflection_cache::{Around, Arounds, CachePlan},
        response::Response,
        sight::{Sight, Spread},
    },
    rgb::{self, Rgb},
    shape::ball::Hit,
    surface::{facets::Facets, sampling::FacetSample},
    surroundings::{lamp::Lamp, lit::Lit, viewpoint::Viewpoint},
    view::camera::Camera,
};

/// One lobe of a pearl, and the facets by which it looks at its surroundings.
#[derive(Debug, Clone)]
pub(crate) struct Reflection {
    response: Arc<Response>,
    /// The lobe, by its number in the response.
    number: usize,
    samples_side: usize,
    /// Sets of facets sampled once for all pixels, each twice as fine as the one before and shared out among
    /// the samples along a pixel's side.
    samples: Vec<Vec<FacetSample>>,
    /// Facets for where the lobe meets the edge of a window, shared out among all samples of a pixel.
    at_edges: Vec<FacetSample>,
    /// Facets for the pearl from afar, shared out among so many points of it.
    far_samples: Vec<FacetSample>,
    lamps: Vec<Lamp>,
}

impl Reflection {
    /// Lobe `number` of `response` under `lamps`, which are the response's; `samples_side` samples stand along
    /// a pixel's side.
    pub(crate) fn new(
        response: Arc<Response>,
        number: usize,
        lamps: &[Lamp],
        samples_side: usize,
    ) -> Self {
        let facets = response.films().middle()[number].facets();
        let lamps = seen_in(&facets, lamps);
        let finest = facets_per_sample(facets.spread_rad()).ilog2();
        let samples = (0..=finest).map(|set| facets.samples(samples_side << set)).collect();
        let pixel = samples_side.max(2).pow(2);
        let at_edges = facets.samples(AT_EDGES.div_ceil(pixel) * pixel);
        let far_samples = facets.samples(DISC_POINTS * far_facets(facets.spread_rad()));
        Self { response, number, samples_side, samples, at_edges, far_samples, lamps }
    }

    /// Its colours where the layers are as thick as on average.
    fn colours(&self) -> &LobeColours {
        &self.response.films().middle()[self.number]
    }

    fn facets(&self) -> Facets<'_> {
        self.colours().facets()
    }

    /// What the lobe mirrors towards the eye.
    pub(crate) fn light(&self, surroundings: &Lit, sight: &Sight, film: FilmAt) -> Rgb {
        let (hit, colours) = (&sight.hit, self.colours());
        let films = self.response.films();
        let around = sight.around[self.number].unwrap_or_else(|| self.around(surroundings, sight));
        let around = self.past_itself(surroundings, sight, around);
        let mirrored = |lobes: &Vec<LobeColours>| {
            apply(lobes[self.number].mirrored_by_all(hit.cos_view), around.light)
        };
        let mut mirror = films.between(film, mirrored);
        rgb::add(&mut mirror, around.rest);
        for (number, lamp) in self.lamps.iter().enumerate() {
            let reflected = |cos_half| {
                films.between(film, |lobes| lobes[self.number].lamp_mirrored(number, cos_half))
            };
            let image = glint(lamp, &colours.facets(), sight, reflected);
            if image.iter().any(|part| *part > 0.0) {
                let past = surroundings.lamp_past(lamp, hit.point, Some(sight.ball));
                let (toward, width_rad) = (lamp.toward(hit.point), 2.0 * lamp.angular_radius_rad());
                let hidden =
                    surroundings.hidden_by_itself(sight.ball, sight.outward, toward, width_rad);
                rgb::add(&mut mirror, rgb::scaled(image, past * (1.0 - hidden)));
            }
        }
        mirror
    }

    /// The surroundings past the pearl's own bulges, which show their glow in place of what they hide.
    fn past_itself(&self, surroundings: &Lit, sight: &Sight, around: Around) -> Around {
        let (mirrored, width_rad) = self.lobe(sight, LOBE_WIDTH);
        let Sight { ball, outward, .. } = *sight;
        let hidden = surroundings.hidden_by_itself(ball, outward, mirrored, width_rad);
        if hidden <= 0.0 {
            return around;
        }
        let own = surroundings.balls[ball].glow.at(-mirrored);
        Around {
            light: rgb::mix(around.light, own, hidden),
            rest: rgb::scaled(around.rest, 1.0 - hidden),
        }
    }

    /// The surroundings in some of the facets that the eye sees, each standing for its part of the lobe:
    /// what is finer is averaged where it is looked up.
    fn around(&self, surroundings: &Lit, sight: &Sight) -> Around {
        let viewpoint = viewpoint(surroundings, sight);
        let (number, parts) = sight.part;
        let is_fine = sight.spread.mean_rad() < FINE * self.facets().spread_rad();
        if is_fine && self.meets_window_edge(&viewpoint, sight) {
            let each = self.at_edges.len() / parts;
            let run = &self.at_edges[number % parts * each..][..each];
            let share = (self.share_needed(sight) * WIDE_AT_EDGES).min(1.0);
            let needed = libm::ceil(share * each as f64) as usize;
            return self.gathered(&viewpoint, sight, &run[..needed], (needed * parts, LOBE));
        }
        let (set, side) = (&self.samples[self.set_needed(&viewpoint, sight)], self.samples_side);
        let each = set.len() / side;
        let run = &set[(number / side + number) % side * each..][..each];
        self.gathered(&viewpoint, sight, run, (set.len(), LOBE))
    }

    /// Whether a pixel, for which `sight` stands as a whole, shows edges of mirrored windows or lamps that its facets blur by
    /// little more than its own width.
    pub(crate) fn has_edges(&self, surroundings: &Lit, sight: &Sight) -> bool {
        let lean_rad = self.facets().spread_rad();
        let mean_rad = sight.spread.mean_rad();
        if mean_rad < lean_rad || mean_rad > 2.0 * FINE * lean_rad.max(USUAL_LEAN_RAD) {
            return false;
        }
        let (mirrored, within_rad) = self.lobe(sight, LOBE_REACH);
        let is_near = |lamp: &Lamp| {
            let reach_rad = (lamp.angular_radius_rad() + within_rad).min(PI);
            lamp.toward(sight.hit.point).dot(mirrored) > libm::cos(reach_rad)
        };
        (mean_rad > 2.0 * lean_rad && self.lamps.iter().any(is_near))
            || self.meets_window_edge(&viewpoint(surroundings, sight), sight)
    }

    /// The mirrored ray, and how far from it the lobe reaches, to so many standard deviations of the facets' lean.
    fn lobe(&self, sight: &Sight, reach: f64) -> (DVec3, f64) {
        let lean_rad = self.facets().spread_rad();
        let mirrored = 2.0 * sight.hit.cos_view * sight.hit.normal - sight.view;
        (mirrored, reach * 2.0 * lean_rad + sight.spread.outward_rad)
    }

    /// Whether the lobe of a line of sight meets the edge of a window.
    fn meets_window_edge(&self, viewpoint: &Viewpoint, sight: &Sight) -> bool {
        let (mirrored, within_rad) = self.lobe(sight, EDGE_REACH);
        viewpoint.may_meet_window_edge(mirrored, within_rad)
    }

    /// The same for one of the [`DISC_POINTS`] that stand for the pearl from afar.
    pub(crate) fn around_from_afar(&self, surroundings: &Lit, sight: &Sight) -> Around {
        let each = self.far_samples.len() / DISC_POINTS;
        let run = &self.far_samples[sight.part.0 * each..][..each];
        let count = self.far_samples.len();
        self.gathered(&viewpoint(surroundings, sight), sight, run, (count, LOBE))
    }

    /// Which set of samples shows what all facets do. The wider the cone is against the lobe, the fewer are needed,
    /// unless the lobe may meet something bright with an edge.
    fn set_needed(&self, viewpoint: &Viewpoint, sight: &Sight) -> usize {
        let finest = self.samples.len() - 1;
        let (mirrored, within_rad) = self.lobe(sight, LOBE_REACH);
        if viewpoint.may_meet_edge(mirrored, within_rad) {
            return finest;
        }
        finest.saturating_sub(libm::log2(self.share_needed(sight).recip()) as usize)
    }

    /// The share of a lobe's facets that shows what all do, for a line of sight that stands for a cone; may be more than all.
    fn share_needed(&self, sight: &Sight) -> f64 {
        let lean_rad = self.facets().spread_rad();
        (3.0 * lean_rad / sight.spread.mean_rad()).powi(2) / sight.hit.cos_view.max(0.02)
    }

    /// The cache of what the facets show `camera`, if pixels are finer.
    pub(crate) fn cache<'a>(
        &'a self,
        surroundings: &'a Lit,
        ball: usize,
        camera: &'a Camera,
        pixel_mm: f64,
    ) -> Option<CachePlan<'a>> {
        let facets = self.facets();
        let place = &surroundings.balls[ball];
        let pixels = PI * (place.radius_mm / pixel_mm).powi(2);
        let at_edges = if surroundings.windows.is_empty() { 0 } else { self.at_edges.len() };
        let usual = self.samples.last().map_or(0, Vec::len) as f64;
        let looked_at = pixels * (usual + NEAR_EDGES * at_edges as f64);
        let at_edges = facets.lattice(KNOT_AT_EDGES);
        let (axis, far_mm) = camera.toward_eye(place.centre);
        let least_mm = surroundings.least_mm(ball);
        if far_mm <= least_mm {
            return None;
        }
        let seen = (axis, libm::acos(least_mm / far_mm));
        CachePlan::new(seen, &facets, looked_at, move |normal, samples| {
            let point = surroundings.farthest(ball, normal);
            let view = camera.toward_eye(point).0;
            let hit = Hit { point, normal, cos_view: normal.dot(view).max(0.02) };
            let spread = Spread::of_square(pixel_mm / place.radius_mm, hit.cos_view);
            let sight = Sight {
                ball,
                hit,
                outward: surroundings.outward(ball, &hit),
                local: Local::EVEN,
                grain: None,
                view,
                pixel_mm,
                spread,
                part: (0, 1),
                around: Arounds::default(),
            };
            let viewpoint = viewpoint(surroundings, &sight);
            let edge = samples.len() < at_edges.len() && self.meets_window_edge(&viewpoint, &sight);
            let samples = if edge { &at_edges } else { samples };
            self.gathered(&viewpoint, &sight, samples, (samples.len(), KNOT_LOBE))
        })
    }

    /// The surroundings in the facets of some samples, of which `count` stand for all facets, each
    /// looked up with `lobe_width` of what it stands for.
    fn gathered(
        &self,
        viewpoint: &Viewpoint,
        sight: &Sight,
        samples: &[FacetSample],
        (count, lobe_width): (usize, f64),
    ) -> Around {
        let Sight { hit, view, spread, .. } = *sight;
        let (normal, cos_view) = (hit.normal, hit.cos_view);
        let aside = view - normal * cos_view;
        // Straight from above, what is left of the view aside is rounding.
        let x = if aside.length_squared() > 1e-12 {
            aside.normalize()
        } else {
            normal.any_orthonormal_vector()
        };
        let y = normal.cross(x);
        let (mut lobe, facets) = (Gathered::default(), self.facets().seen_at(cos_view));
        for sample in samples {
            let Some(facet) = facets.facet(*sample) else { continue };
            let along = facet.light.x * x + facet.light.y * y + facet.light.z * normal;
            let share_rad2 = lobe_width / (facet.density * count as f64);
            let seen = viewpoint.seen(along, &spread.cone(share_rad2, along, y));
            lobe.add(facet.weight, self.colours().mirrored(facet.cos_half), seen);
        }
        lobe.around(self.colours().mirrored_by_all(cos_view))
    }
}

/// Lamps as finely as facets show them.
pub(crate) fn seen_in(facets: &Facets<'_>, lamps: &[Lamp]) -> Vec<Lamp> {
    let seen = |lamp: &Lamp| match lamp.clone() {
        lamp if facets.are_below() => lamp.blurred_for(facets),
        lamp => lamp.resolved_for(facets),
    };
    lamps.iter().map(seen).collect()
}

fn viewpoint<'a>(surroundings: &'a Lit, sight: &Sight) -> Viewpoint<'a> {
    Viewpoint::new(surroundings, &surroundings.windows, sight.hit.point, Some(sight.ball))
}

/// Squared width of what a sample is looked up with, in units of its solid angle: neighbours overlap, so that an
/// edge that moves across them leaves no steps; by eye **(ours)**.
const LOBE: f64 = 4.0;

/// The same for the knots of a cache, whose many samples need overlap less; by eye **(ours)**.
const KNOT_LOBE: f64 = 2.0;

/// Facets of a pixel whose lobe meets the edge of a window, and of a cache's knot there **(ours)**: an edge that is twice
/// as bright as white then shows in a picture as in one four times as fine, to 0.02 (`tests/picture/test_finer.py`).
const AT_EDGES: usize = 256;
const KNOT_AT_EDGES: usize = 384;

/// The wider the cone that a sample stands for, the fewer facets show it the edge of a window; against even surroundings
/// so many **(ours)**.
const WIDE_AT_EDGES: f64 = 0.45;

/// Edges are looked at with care where a sample stands for a cone of less than so many standard deviations of the facets'
/// lean **(ours)**: of a usual pearl, where it is more than some 30 pixels wide.
const FINE: f64 = 3.0;

/// Facets that lean less than a usual pearl's have edges looked at as if they leaned so much: where a pixel mirrors many
/// times their lean, one sample in each row and column would show an edge in steps **(ours)**.
const USUAL_LEAN_RAD: f64 = 0.055;

/// Share of a pearl's disc whose lobes meet the edge of a window, about, where there is one **(ours)**.
const NEAR_EDGES: f64 = 0.25;

/// So many standard deviations of the facets' lean from an edge it shows in the lobe **(ours)**: beyond is half a percent.
const EDGE_REACH: f64 = 2.5;

/// Facets for a point that stands for a 64th of the pearl from afar. Its ray's cone is so wide that one shows what
/// all of a lobe do, unless the lobe is wider.
fn far_facets(spread_rad: f64) -> usize {
    (libm::ceil((spread_rad / 0.1).powi(2)) as usize).min(16)
}

/// A lobe is about so many standard deviations of its facets' lean wide, to either side, as an edge moves across it.
const LOBE_WIDTH: f64 = 2.0;

/// So many standard deviations of the facets' lean a lobe reaches, as far as the edge of a window shows in it: with
/// fewer facets beyond, no 8-bit code of 70 small pictures moves by more than 1 **(ours)**.
const LOBE_REACH: f64 = 3.0;

/// A mirror needs few facets, satin more: few agree with the integral over all light to 2 %
/// (`docs/transport.md`).
fn facets_per_sample(spread_rad: f64) -> usize {
    match spread_rad {
        spread if spread < 0.02 => 4,
        spread if spread < 0.08 => 8,
        _ => 16,
    }
}
