//! What the lobes of a pearl see of its surroundings, at the knots of a net, before any film.
//!
//! Few facets a knot, each kept with its light, for any film to colour.
//! Left out: how the way out through another film would turn them.

use glam::DVec3;

use crate::{
    parallel,
    pearl::{
        gathered::Gathered, lobe_colours::LobeColours, net::Net, reflection_cache::Around,
        response::Response, sight::Spread,
    },
    surface::{facets::Facets, sampling::FacetSample},
    surroundings::{lit::Lit, viewpoint::Viewpoint},
    view::camera::Camera,
};

/// How finely a preview looks at what pearls mirror.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fineness {
    /// Knots of the sharpest lobe's net from the middle of a pearl to its edge, at the most.
    pub knots: usize,
    /// Facets of that lobe at each of them; broader lobes have fewer knots and more facets.
    pub facets: usize,
}

/// What lobes see at the knots of nets over a pearl.
#[derive(Debug)]
pub struct Glimpses {
    /// The side of the pearl that the camera sees: normals within an angle of an axis.
    pub(super) seen: (DVec3, f64),
    pub(super) lobes: Vec<LobeGlimpses>,
}

/// What one lobe sees.
#[derive(Debug)]
pub(super) struct LobeGlimpses {
    pub(super) net: Net,
    /// Facets of one knot after the other.
    facets: Vec<Glimpse>,
    each: usize,
}

/// What a facet sees; none of the light counts of one that the eye does not see.
#[derive(Debug, Clone, Copy, Default)]
struct Glimpse {
    weight: f32,
    cos_half: f32,
    light: [f32; 3],
}

/// Squared width of what a facet is looked up with, in units of its solid angle; by eye **(ours)**.
const WIDTH: f64 = 2.0;

impl Glimpses {
    /// Of ball `ball` before a camera; `None` from within it.
    pub fn new(
        response: &Response,
        surroundings: &Lit,
        ball: usize,
        camera: &Camera,
        fineness: Fineness,
    ) -> Option<Self> {
        let place = &surroundings.balls[ball];
        let (axis, far_mm) = camera.toward_eye(place.centre);
        if far_mm <= place.radius_mm {
            return None;
        }
        let seen = (axis, libm::acos(place.radius_mm / far_mm));
        let lobe = |colours: &LobeColours| {
            let facets = colours.facets();
            let knots = libm::ceil(seen.1 * STEPS_PER_SPREAD / facets.spread_rad()) as usize;
            let knots = knots.clamp(FEWEST_KNOTS, fineness.knots);
            let each = (fineness.facets * fineness.knots / knots).min(MOST_FACETS);
            let look = Look { surroundings, ball, camera, facets: &facets };
            look.glimpses(Net::new(seen, knots), &facets.lattice(each))
        };
        let lobes = response.films().middle().iter().map(lobe).collect();
        Some(Self { seen, lobes })
    }
}

/// Knots for each standard deviation of the facets' lean, as in `reflection_cache.rs`.
const STEPS_PER_SPREAD: f64 = 1.4;
/// By eye **(ours)**.
const FEWEST_KNOTS: usize = 8;
const MOST_FACETS: usize = 96;

impl LobeGlimpses {
    /// What the lobe of a film mirrors at a knot, seen at a cosine of the view angle.
    pub(super) fn around(&self, knot: usize, colours: &LobeColours, cos_view: f64) -> Around {
        let mut gathered = Gathered::default();
        for Glimpse { weight, cos_half, light } in &self.facets[knot * self.each..][..self.each] {
            if *weight > 0.0 {
                let film = colours.mirrored(f64::from(*cos_half));
                gathered.add(f64::from(*weight), film, light.map(f64::from));
            }
        }
        gathered.around(colours.mirrored_by_all(cos_view))
    }
}

/// One lobe of a pearl before a camera.
struct Look<'a> {
    surroundings: &'a Lit,
    ball: usize,
    camera: &'a Camera,
    facets: &'a Facets<'a>,
}

impl Look<'_> {
    fn glimpses(&self, net: Net, samples: &[FacetSample]) -> LobeGlimpses {
        let (place, each) = (&self.surroundings.balls[self.ball], samples.len());
        let mut facets = vec![Glimpse::default(); net.side() * net.side() * each];
        parallel::map_chunks(&mut facets, each, |knot, glimpses| {
            let Some(normal) = net.normal(knot) else { return };
            let point = place.centre + normal * place.radius_mm;
            let view = self.camera.toward_eye(point).0;
            let windows = &self.surroundings.windows;
            let viewpoint = Viewpoint::new(self.surroundings, windows, point, Some(self.ball));
            let cone_rad = (net.step_rad(), self.facets);
            glimpse(&viewpoint, (normal, view), cone_rad, samples, glimpses);
        });
        LobeGlimpses { net, facets, each }
    }
}

/// What facets see from one point of the pearl.
fn glimpse(
    viewpoint: &Viewpoint<'_>,
    (normal, view): (DVec3, DVec3),
    (step_rad, facets): (f64, &Facets<'_>),
    samples: &[FacetSample],
    glimpses: &mut [Glimpse],
) {
    let cos_view = normal.dot(view).max(LEAST_COSINE);
    let aside = view - normal * normal.dot(view);
    let x = if aside.length_squared() > 1e-12 {
        aside.normalize()
    } else {
        normal.any_orthonormal_vector()
    };
    let y = normal.cross(x);
    let seen = facets.seen_at(cos_view);
    let spread = Spread::of_square(step_rad * cos_view, cos_view);
    for (glimpse, sample) in glimpses.iter_mut().zip(samples) {
        let Some(facet) = seen.facet(*sample) else { continue };
        let along = facet.light.x * x + facet.light.y * y + facet.light.z * normal;
        let share_rad2 = WIDTH / (facet.density * samples.len() as f64);
        let light = viewpoint.seen(along, &spread.cone(share_rad2, along, y));
        *glimpse = Glimpse {
            weight: facet.weight as f32,
            cos_half: facet.cos_half as f32,
            light: light.map(|channel| channel as f32),
        };
    }
}

/// What is seen at a still flatter angle counts as seen at this one.
pub(super) const LEAST_COSINE: f64 = 0.02;
