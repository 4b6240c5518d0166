//! A pearl in its place: its model, its grain, its light by place and as a whole.
//!
//! Whichever model it has; its glow is the mean over the disc.
//! Left out: light between two places of one pearl's surface.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    coat::{local::Local, outer::Coat},
    grain::texture::{Relief, Texture},
    light::glow::{self, DISC_POINTS, Glow},
    pearl::{
        illuminant::IlluminantPearl,
        reflection_cache::{Arounds, ReflectionCache},
        shade::Shade,
        sight::{Sight, Spread},
        transport::Transport,
    },
    rgb::{self, Rgb},
    shape::ball::Hit,
    surroundings::lit::Lit,
    view::camera::Camera,
};

/// How strongly the grain's textures act, per unit of texture and of lightness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grain {
    /// Radians of hue.
    pub hue_rad: f64,
    /// Relative chroma.
    pub chroma: f64,
    /// Relative brightness of what is mirrored.
    pub value: f64,
    /// Standard deviation of its slopes, in any one direction.
    pub relief_rad: f64,
}

/// A pearl in its place and light, all of it known before the first pixel.
#[derive(Debug, Clone)]
pub struct Pearl {
    /// What it does with light.
    pub model: Arc<Model>,
    /// The grain over the sphere, if any.
    pub texture: Option<Arc<Texture>>,
    /// How strongly it acts.
    pub grain: Grain,
    /// What differs from place to place, if anything does.
    pub coat: Option<Arc<Coat>>,
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
    pub(crate) fn reflection_caches(
        &self,
        surroundings: &Lit,
        ball: usize,
        camera: &Camera,
        pixel_mm: f64,
    ) -> Vec<Option<ReflectionCache>> {
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
    /// Whether its outer layers differ from place to place.
    pub(crate) fn has_relief(&self) -> bool {
        self.grain.relief_rad > 0.0 || self.coat.as_ref().is_some_and(|coat| !coat.is_even())
    }

    /// Whether they may have edges as fine as a pixel.
    pub(crate) fn has_fine_relief(&self) -> bool {
        self.coat.as_ref().is_some_and(|coat| coat.has_edges())
    }

    /// What its outer layers are like in a direction from its middle, `away_mm` from there, seen at a cosine of the view
    /// angle, as wide as `footprint_mm`; and the grain there, where its relief tells it too.
    pub(crate) fn local(
        &self,
        (outward, cos_view): (DVec3, f64),
        radius_mm: f64,
        [away_mm, footprint_mm]: [f64; 2],
    ) -> (Local, Option<Rgb>) {
        let coat = self
            .coat
            .as_ref()
            .map_or(Local::EVEN, |coat| coat.at(outward, [away_mm, footprint_mm], cos_view));
        match &self.texture {
            Some(texture) if self.grain.relief_rad > 0.0 => {
                let (local, grain) = self.grained(texture, outward, footprint_mm / radius_mm);
                (coat.and(local), Some(grain))
            }
            _ => (coat, None),
        }
    }

    /// The grain's relief, as steep as its brightness changes, and the grain itself.
    fn grained(&self, texture: &Texture, outward: DVec3, footprint_rad: f64) -> (Local, Rgb) {
        let relief = texture.with_relief(self.unturned(outward), footprint_rad);
        let Relief { value, gradient, seen } = relief;
        let slope = gradient * self.grain.relief_rad;
        let slope = self.coat.as_ref().map_or(slope, |coat| coat.pose().turned(slope));
        let fine_slope2 = 2.0 * self.grain.relief_rad.powi(2) * (1.0 - seen);
        (Local { slope, fine_slope2, ..Local::EVEN }, value.map(f64::from))
    }

    /// A direction of the scene as it was before the pearl was turned.
    fn unturned(&self, outward: DVec3) -> DVec3 {
        self.coat.as_ref().map_or(outward, |coat| coat.pose().unturned(outward))
    }

    /// What goes from the point towards the eye.
    pub fn shade(&self, surroundings: &Lit, sight: &Sight) -> Shade {
        let radius_mm = surroundings.balls[sight.ball].radius_mm;
        let grain = |texture: &Arc<Texture>| {
            texture.at(self.unturned(sight.outward), sight.pixel_mm / radius_mm).map(f64::from)
        };
        let texture = sight.grain.or_else(|| self.texture.as_ref().map(grain)).unwrap_or_default();
        Shade { texture, ..self.model.shade(surroundings, sight) }
    }
}
