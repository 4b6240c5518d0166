//! A pearl by the transport model: light mirrored by the film, and light that has been inside.
//!
//! Ozaki and others 2021; one or two lobes mirror, and what neither does enters.
//! Left out: polarisation between film and surroundings.

use std::sync::Arc;

use crate::{
    pearl::{
        reflection::Reflection,
        reflection_cache::{Arounds, CachePlan},
        response::Response,
        shade::Shade,
        sight::Sight,
        subsurface::Subsurface,
    },
    rgb,
    surroundings::lit::Lit,
    view::camera::Camera,
};

/// A pearl by the transport model (Ozaki and others 2021): what one sees is light that the film mirrors,
/// and light that has been inside and leaves through the film in the complementary colour.
#[derive(Debug, Clone)]
pub struct Transport {
    /// The surface's, and the layers' where they wave.
    reflections: Vec<Reflection>,
    response: Arc<Response>,
    subsurface: Subsurface,
}

impl Transport {
    /// Lets the light of `surroundings`, whose lamps are those of `response`, into ball `ball`;
    /// `samples_side` samples stand along a pixel's side.
    pub fn new(
        response: &Arc<Response>,
        surroundings: &Lit,
        ball: usize,
        samples_side: usize,
    ) -> Self {
        let subsurface = Subsurface::of(response, surroundings, ball);
        let reflection = |number| {
            Reflection::new(Arc::clone(response), number, &surroundings.lamps, samples_side)
        };
        let reflections = (0..response.films().middle().len()).map(reflection).collect();
        Self { reflections, response: Arc::clone(response), subsurface }
    }

    /// What goes from the point towards the eye, without the grain.
    pub(crate) fn shade(&self, surroundings: &Lit, sight: &Sight) -> Shade {
        let film = self.response.films().place(sight.local.thickness);
        let (whole, plain) = self.subsurface.radiance(sight.outward, sight.hit.cos_view, film);
        let [whole, plain] = [whole, plain].map(|light| rgb::scaled(light, sight.local.inside));
        let mut mirror = [0.0; 3];
        for reflection in &self.reflections {
            rgb::add(&mut mirror, reflection.light(surroundings, sight, film));
        }
        let interference = std::array::from_fn(|i| whole[i] - plain[i]);
        let shade = Shade { interference, diffuse: plain, mirror, ..Shade::default() };
        if sight.local.chalk > 0.0 { self.chalked(&shade, sight.local.chalk) } else { shade }
    }

    /// With a share of chalk, which mirrors nothing and lets out all that there is.
    fn chalked(&self, shade: &Shade, chalk: f64) -> Shade {
        let nacre = 1.0 - chalk;
        let plain = nacre + chalk / self.response.passage().plain();
        Shade {
            interference: rgb::scaled(shade.interference, nacre),
            diffuse: rgb::scaled(shade.diffuse, plain),
            mirror: rgb::scaled(shade.mirror, nacre),
            ..*shade
        }
    }

    /// Whether a pixel, for which `sight` stands as a whole, shows edges of mirrored windows or lamps that the surface's
    /// facets blur by little more than its own width. The layers' lobe is wider.
    pub(crate) fn has_edges(&self, surroundings: &Lit, sight: &Sight) -> bool {
        self.reflections.first().is_some_and(|sharpest| sharpest.has_edges(surroundings, sight))
    }

    /// The surroundings as the facets show them to one of the points that stand for the pearl from afar.
    pub(crate) fn around_from_afar(&self, surroundings: &Lit, sight: &Sight) -> Arounds {
        let mut around = Arounds::default();
        for (known, reflection) in around.iter_mut().zip(&self.reflections) {
            *known = Some(reflection.around_from_afar(surroundings, sight));
        }
        around
    }

    /// The caches of what the facets of each lobe show `camera`, where pixels are finer.
    pub(crate) fn reflection_caches<'a>(
        &'a self,
        surroundings: &'a Lit,
        ball: usize,
        camera: &'a Camera,
        pixel_mm: f64,
    ) -> Vec<Option<CachePlan<'a>>> {
        let cache =
            |reflection: &'a Reflection| reflection.cache(surroundings, ball, camera, pixel_mm);
        self.reflections.iter().map(cache).collect()
    }
}
