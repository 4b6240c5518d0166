//! What the lobes of a pearl see of its surroundings, at the knots of a net, before any film.
//!
//! Few facets a knot. How the light leans over them, from the flatter to the steeper, stands in for what a film whose colour
//! changes with the angle makes of it: the first term of a series in the cosine of incidence.
//! Left out: the second.

use glam::DVec3;

use crate::{
    parallel,
    pearl::{net::Net, response::Response, sight::Spread},
    rgb::{self, Rgb},
    surface::{facets::Facets, sampling::FacetSample},
    surroundings::{lit::Lit, viewpoint::Viewpoint},
    view::camera::Camera,
};

/// How finely a preview looks at what pearls mirror.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fineness {
    /// Knots of a net from the middle of a pearl to its edge.
    pub knots: usize,
    /// Facets of each lobe at each of them.
    pub facets: usize,
}

/// What lobes see at the knots of a net over a pearl.
#[derive(Debug)]
pub struct Glimpses {
    pub(super) net: Net,
    pub(super) knots: Vec<[Glimpse; 2]>,
}

/// What a lobe sees.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Glimpse {
    /// The mean light in its facets.
    pub(super) light: Rgb,
    /// The mean of light times cosine of incidence, beyond the product of both means.
    pub(super) lean: Rgb,
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
        let net = Net::new((axis, libm::acos(place.radius_mm / far_mm)), fineness.knots);
        let lobes: Vec<(Facets<'_>, Vec<FacetSample>)> = response
            .films()
            .middle()
            .iter()
            .map(|lobe| (lobe.facets(), lobe.facets().lattice(fineness.facets)))
            .collect();
        let step_rad = net.step_rad();
        let knot = |number: usize| {
            let normal = net.normal(number)?;
            let point = place.centre + normal * place.radius_mm;
            let view = camera.toward_eye(point).0;
            let viewpoint = Viewpoint::new(surroundings, &surroundings.windows, point, Some(ball));
            let mut seen = [Glimpse::default(); 2];
            for (glimpse, (facets, samples)) in seen.iter_mut().zip(&lobes) {
                *glimpse = glimpsed(&viewpoint, (normal, view), facets, samples, step_rad);
            }
            Some(seen)
        };
        let knots = parallel::map(net.side() * net.side(), |i| knot(i).unwrap_or_default());
        Some(Self { net, knots })
    }
}

/// What facets see from one point of the pearl.
fn glimpsed(
    viewpoint: &Viewpoint<'_>,
    (normal, view): (DVec3, DVec3),
    facets: &Facets<'_>,
    samples: &[FacetSample],
    step_rad: f64,
) -> Glimpse {
    let cos_view = normal.dot(view).max(0.02);
    let aside = view - normal * normal.dot(view);
    let x = if aside.length_squared() > 1e-12 {
        aside.normalize()
    } else {
        normal.any_orthonormal_vector()
    };
    let y = normal.cross(x);
    let seen = facets.seen_at(cos_view);
    let spread = Spread::of_square(step_rad * cos_view, cos_view);
    let (mut weight, mut cosines, mut light, mut leaning) = (0.0, 0.0, [0.0; 3], [0.0; 3]);
    for sample in samples {
        let Some(facet) = seen.facet(*sample) else { continue };
        let along = facet.light.x * x + facet.light.y * y + facet.light.z * normal;
        let share_rad2 = WIDTH / (facet.density * samples.len() as f64);
        let radiance = viewpoint.seen(along, &spread.cone(share_rad2, along, y));
        weight += facet.weight;
        cosines += facet.weight * facet.cos_half;
        rgb::add(&mut light, rgb::scaled(radiance, facet.weight));
        rgb::add(&mut leaning, rgb::scaled(radiance, facet.weight * facet.cos_half));
    }
    if weight <= 0.0 {
        return Glimpse::default();
    }
    let (light, cosine) = (rgb::scaled(light, 1.0 / weight), cosines / weight);
    let lean = std::array::from_fn(|i| leaning[i] / weight - cosine * light[i]);
    Glimpse { light, lean }
}
