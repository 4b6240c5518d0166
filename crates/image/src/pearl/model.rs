//! A pearl in its place: its model, its skin, its light by place and as a whole.
//!
//! Whichever model it has; its glow is the mean over the disc.
//! Left out: light between two places of one pearl's surface.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    coat::local::Local,
    light::glow::{self, DISC_POINTS, Glow},
    pearl::{
        illuminant::IlluminantPearl,
        reflection_cache::{Arounds, CachePlan},
        shade::Shade,
        sight::{Sight, Spread},
        skin::Skin,
        transport::Transport,
    },
    rgb::{self, Rgb},
    shape::ball::Hit,
    surroundings::lit::Lit,
    view::camera::Camera,
};

/// A pearl in its place and light, all of it known before the first pixel.
#[derive(Debug, Clone)]
pub struct Pearl {
    /// What it does with light.
    pub model: Arc<Model>,
    /// What differs from place to place.
    pub skin: Skin,
}

/// The two models of a pearl's light.
#[derive(Debug)]
pub enum Model {
    /// The paper's of 1996.
    Illuminant(Box<IlluminantPearl>),
    /// Light through the film, into the pearl and out again.
    Transport(Box<Transport>),
}

impl Model {
    /// Whether it lights its table: the paper's pearl of 1996 does not.
    pub fn gives_light(&self) -> bool {
        matches!(self, Self::Transport(_))
    }

    /// Whether its light has no detail that is finer than a pixel.
    pub(crate) fn is_smooth(&self) -> bool {
        matches!(self, Self::Transport(_))
    }

    /// Whether a pixel, for which `sight` stands as a whole, shows edges of what is mirrored.
    pub(crate) fn has_edges(&self, surroundings: &Lit, sight: &Sight) -> bool {
        match self {
            Self::Illuminant(_) => true,
            Self::Transport(model) => model.has_edges(surroundings, sight),
        }
    }

    /// Whether a pixel, for which `sight` stands as a whole, shows the edge of a mirrored window that no facets blur.
    pub(crate) fn has_sharp_edges(&self, surroundings: &Lit, sight: &Sight) -> bool {
        match self {
            Self::Illuminant(_) => IlluminantPearl::has_window_edges(surroundings, sight),
            Self::Transport(_) => false,
        }
    }

    /// The light that interference adds at a view angle, of a model in which it depends on nothing else.
    pub(crate) fn rings(&self, cos_view: f64) -> Option<Rgb> {
        match self {
            Self::Illuminant(model) => Some(model.interference(cos_view)),
            Self::Transport(_) => None,
        }
    }

    /// The caches of what the facets of its lobes show the camera, where there shall be one.
    pub(crate) fn reflection_caches<'a>(
        &'a self,
        surroundings: &'a Lit,
        ball: usize,
        camera: &'a Camera,
        pixel_mm: f64,
    ) -> Vec<Option<CachePlan<'a>>> {
        match self {
            Self::Illuminant(_) => Vec::new(),
            Self::Transport(model) => model.reflection_caches(surroundings, ball, camera, pixel_mm),
        }
    }

    /// What goes from the point towards the eye, without the grain.
    pub fn shade(&self, surroundings: &Lit, sight: &Sight) -> Shade {
        match self {
            Self::Illuminant(model) => model.shade(surroundings, sight),
            Self::Transport(model) => model.shade(surroundings, sight),
        }
    }

    /// The mean light of the pearl's disc as its neighbours see it, from all around.
    pub fn glow(&self, surroundings: &Lit, ball: usize) -> Glow {
        let radius_mm = surroundings.balls[ball].radius_mm;
        Glow::from_fn(|towards| {
            // Mirrored scenes shall have mirrored glows.
            let y = (DVec3::Y - towards * towards.y).normalize_or(DVec3::X);
            let x = y.cross(towards);
            let mut sum = [0.0; 3];
            for number in 0..DISC_POINTS {
                let [across, up] = glow::on_disc(number);
                let part = (number, DISC_POINTS);
                let cos_view = (1.0 - across * across - up * up).sqrt();
                let normal = x * across + y * up + towards * cos_view;
                let point = surroundings.farthest(ball, normal);
                let hit = Hit { point, normal, cos_view };
                let pixel_mm = 0.2 * radius_mm;
                let spread = Spread::round(0.4 / cos_view);
                let (view, around) = (towards, Arounds::default());
                let outward = surroundings.outward(ball, &hit);
                let (local, grain) = (Local::EVEN, None);
                let mut sight = Sight {
                    ball,
                    hit,
                    outward,
                    local,
                    grain,
                    view,
                    pixel_mm,
                    spread,
                    part,
                    around,
                };
                if let Self::Transport(model) = self {
                    sight.around = model.around_from_afar(surroundings, &sight);
                }
                let shade = self.shade(surroundings, &sight);
                for light in [shade.interference, shade.diffuse, shade.mirror] {
                    rgb::add(&mut sum, rgb::scaled(light, 1.0 / DISC_POINTS as f64));
                }
            }
            sum
        })
    }
}

impl Pearl {
    /// What goes from the point towards the eye.
    pub fn shade(&self, surroundings: &Lit, sight: &Sight) -> Shade {
        let radius_mm = surroundings.balls[sight.ball].radius_mm;
        let grain = || self.skin.grain_at(sight.outward, sight.pixel_mm / radius_mm);
        let texture = sight.grain.unwrap_or_else(grain);
        Shade { texture, ..self.model.shade(surroundings, sight) }
    }
}
