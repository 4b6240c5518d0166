//! What is seen from one point in several directions.
//!
//! Pearls and windows before table, walls and sky, each a layer that lets part of a cone of light through.
//! Left out: that two layers may hide the same part of a cone.

use std::cell::Cell;

use glam::DVec3;

use crate::{
    rgb::{self, Rgb},
    surroundings::{ground::Seen, lit::Lit, pane::Pane, sky::Sky, window::Window},
    view::{cone::Cone, ray::Ray},
};

/// A point among the surroundings from which one looks in several directions.
pub(crate) struct Viewpoint<'a> {
    surroundings: &'a Lit,
    panes: Vec<Pane>,
    point: DVec3,
    /// The pearl that is not seen, for the point lies on it or in it.
    on: Option<usize>,
}

/// Something before table, walls and sky that a cone of light meets with a share of its width.
#[derive(Debug, Clone, Copy)]
struct Layer {
    distance_mm: f64,
    share: f64,
    radiance: Rgb,
    fades: bool,
}

impl<'a> Viewpoint<'a> {
    /// Among `surroundings` as if `windows` were theirs.
    pub(crate) fn new(
        surroundings: &'a Lit,
        windows: impl IntoIterator<Item = &'a Window>,
        point: DVec3,
        on: Option<usize>,
    ) -> Self {
        let panes = windows.into_iter().filter_map(|window| window.before(point)).collect();
        Self { surroundings, panes, point, on }
    }

    /// The light from a direction; the ray stands for `cone`.
    pub(crate) fn seen(&self, along: DVec3, cone: &Cone) -> Rgb {
        self.seen_as(along, cone, |radiance, _| radiance)
    }

    /// The same, where each thing but sky and windows fades into the backdrop with its own distance, to 1/e of the contrast
    /// over `falloff_mm`.
    pub(crate) fn faded(&self, along: DVec3, cone: &Cone, falloff_mm: f64) -> Rgb {
        let backdrop = self.surroundings.backdrop(along, cone);
        self.seen_as(along, cone, |radiance, distance_mm| {
            if distance_mm.is_finite() {
                rgb::mix(backdrop, radiance, libm::exp(-distance_mm / falloff_mm))
            } else {
                radiance
            }
        })
    }

    /// The light from a direction, each thing's as `looks` says of its radiance and distance; that of windows and sky is
    /// infinite.
    fn seen_as(&self, along: DVec3, cone: &Cone, looks: impl Fn(Rgb, f64) -> Rgb) -> Rgb {
        if self.surroundings.balls.len() == usize::from(self.on.is_some()) {
            let ray = Ray { from: self.point, along };
            return through(self.windows(along, cone), self.surroundings.ground(&ray, cone), looks);
        }
        let ray = Ray { from: self.point, along };
        let (ground, spread_rad) = (self.surroundings.ground(&ray, cone), cone.mean_rad());
        let (neighbours, balls) = (&self.surroundings.neighbours, &self.surroundings.balls);
        // Nothing is seen behind the ground, nor behind a ball that fills the cone.
        let end_mm = Cell::new(ground.distance_mm);
        let slices = neighbours.slices(&ray, 0.5 * spread_rad, self.on.is_some());
        let slices = slices.take_while(|slice| slice.least_mm <= end_mm.get());
        let balls = slices.flat_map(|slice| slice.balls).filter_map(|&number| {
            if Some(number as usize) == self.on {
                return None;
            }
            let ball = &balls[number as usize];
            let (distance_mm, share) = ball.stops(&ray, spread_rad)?;
            if distance_mm >= ground.distance_mm {
                return None;
            }
            if share >= 1.0 {
                end_mm.set(distance_mm.min(end_mm.get()));
            }
            let radiance = ball.glow.at((self.point - ball.centre).normalize());
            Some(Layer { distance_mm, share, radiance, fades: true })
        });
        through(balls.chain(self.windows(along, cone)), ground, looks)
    }

    /// Whether the edge of a window may lie within an angle of a direction.
    pub(crate) fn may_meet_window_edge(&self, along: DVec3, within_rad: f64) -> bool {
        self.panes.iter().any(|pane| pane.has_edge_within(along, within_rad))
    }

    /// Whether something bright with an edge, a window or what a panorama shows, may lie within an angle of
    /// a direction, or the table's horizon within half of it, whose contrast is less.
    pub(crate) fn may_meet_edge(&self, along: DVec3, within_rad: f64) -> bool {
        matches!(self.surroundings.sky, Sky::Panorama { .. })
            || (self.surroundings.table.is_some() && along.y.abs() < 0.5 * within_rad)
            || self.panes.iter().any(|pane| pane.is_within(along, within_rad))
    }

    /// The light from a direction without the pearls.
    pub(crate) fn scenery(&self, along: DVec3, cone: &Cone) -> Rgb {
        let ray = Ray { from: self.point, along };
        let ground = self.surroundings.ground(&ray, cone);
        through(self.windows(along, cone), ground, |radiance, _| radiance)
    }

    fn windows(&self, along: DVec3, cone: &Cone) -> impl Iterator<Item = Layer> {
        self.panes.iter().filter_map(move |pane| {
            let (distance_mm, share) = pane.seen(along, cone)?;
            Some(Layer { distance_mm, share, radiance: pane.radiance, fades: false })
        })
    }
}

/// What is seen through layers in any order.
fn through(
    mut layers: impl Iterator<Item = Layer>,
    ground: Seen,
    looks: impl Fn(Rgb, f64) -> Rgb,
) -> Rgb {
    // Hardly a ray meets more than one, and most of the time of a picture is spent here.
    match (layers.next(), layers.next()) {
        (None, _) => looks(ground.radiance, ground.distance_mm),
        (Some(one), None) => before(&[one], ground, looks),
        (Some(one), Some(two)) => {
            let mut all: Vec<Layer> = [one, two].into_iter().chain(layers).collect();
            all.sort_by(|a, b| a.distance_mm.total_cmp(&b.distance_mm));
            before(&all, ground, looks)
        }
    }
}

/// From front to back, each layer lets the rest of the light through.
fn before(layers: &[Layer], ground: Seen, looks: impl Fn(Rgb, f64) -> Rgb) -> Rgb {
    let (mut radiance, mut left) = ([0.0; 3], 1.0);
    for layer in layers.iter().filter(|layer| layer.distance_mm < ground.distance_mm) {
        let distance_mm = if layer.fades { layer.distance_mm } else { f64::INFINITY };
        let light = looks(layer.radiance, distance_mm);
        rgb::add(&mut radiance, rgb::scaled(light, left * layer.share));
        left *= 1.0 - layer.share;
    }
    let light = looks(ground.radiance, ground.distance_mm);
    rgb::add(&mut radiance, rgb::scaled(light, left));
    radiance
}
