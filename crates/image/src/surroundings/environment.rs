//! What a pearl stands in: table, walls, sky, lamps, windows and the other pearls.
//!
//! Only what is stated, and the sky's light on the table.
//! Left out: balls that overlap, and windows that hide one another.

use std::sync::Arc;

use crate::{
    light::glow::Glow,
    rgb::Rgb,
    shape::{ball::Ball, neighbours::Neighbours, solid::Solid},
    surroundings::{
        clusters::ClusterTree, lamp::Lamp, sky::Sky, table::Table, walls::Walls, window::Window,
    },
    view::ray::Ray,
};

/// Everything a pearl stands in and mirrors: table, walls, sky, the lamps that light them, and the
/// other pearls.
///
/// Lamps themselves are not seen here: their images in the pearl are the facets' work. Windows are.
#[derive(Debug, Clone)]
pub struct Surroundings {
    /// What the pearls lie on, if anything.
    pub table: Option<Table>,
    /// Upright walls, if any.
    pub walls: Option<Walls>,
    /// What is behind all.
    pub sky: Sky,
    /// The lamps.
    pub lamps: Vec<Lamp>,
    /// Rectangles of light; taken not to hide one another, nor to be hidden by walls from the table.
    pub windows: Vec<Window>,
    /// The pearls, which throw shadows and give light.
    pub balls: Vec<Ball>,
    /// The forms of those that are not round, in the order of the balls; empty where all are.
    pub(crate) solids: Vec<Option<Arc<Solid>>>,
    pub(crate) neighbours: Neighbours,
    pub(crate) clusters: ClusterTree,
    /// Height of the table: that of the lowest ball's lowest point.
    pub(crate) table_y_mm: f64,
    /// Radiance of a white matt table under the sky alone; walls are taken to receive half of it.
    pub(crate) sky_on_table: Rgb,
}

impl Surroundings {
    /// Puts the pieces together; the sky's light on the table is computed here, once. The balls are
    /// taken to lie on one plane and not to overlap.
    pub fn new(
        table: Option<Table>,
        walls: Option<Walls>,
        sky: Sky,
        lamps: Vec<Lamp>,
        balls: Vec<Ball>,
    ) -> Self {
        let sky_on_table = sky.on_table();
        let lowest = balls.iter().map(|ball| ball.centre.y - ball.below_mm()).reduce(f64::min);
        let table_y_mm = lowest.unwrap_or(0.0);
        Self {
            table,
            walls,
            sky,
            lamps,
            windows: Vec::new(),
            neighbours: Neighbours::new(&balls),
            clusters: ClusterTree::new(&balls),
            balls,
            solids: Vec::new(),
            table_y_mm,
            sky_on_table,
        }
    }

    /// The same with windows.
    #[must_use]
    pub fn with_windows(self, windows: Vec<Window>) -> Self {
        Self { windows, ..self }
    }

    /// The same with the forms of the pearls that are not round, in the order of the balls, which have their hulls.
    #[must_use]
    pub fn with_solids(self, solids: Vec<Option<Arc<Solid>>>) -> Self {
        Self { solids, ..self }
    }

    /// The same with the light that each ball sends out.
    #[must_use]
    pub(crate) fn with_glows(mut self, glows: Vec<Glow>) -> Self {
        for (ball, glow) in self.balls.iter_mut().zip(glows) {
            ball.glow = glow;
        }
        self.clusters = ClusterTree::new(&self.balls);
        self
    }

    /// The balls that a cone of light may meet, the one left out that it comes from; roughly from front to back.
    pub(crate) fn balls_near(
        &self,
        ray: &Ray,
        spread_rad: f64,
        from: Option<usize>,
    ) -> impl Iterator<Item = &Ball> {
        let few = self.balls.len() <= FEW;
        let all = few.then(|| (0..self.balls.len()).filter(move |&ball| Some(ball) != from));
        let near = (!few).then(|| self.neighbours.near(ray, spread_rad, from));
        let numbers = all.into_iter().flatten().chain(near.into_iter().flatten());
        numbers.map(|ball| &self.balls[ball])
    }
}

/// So many balls are all asked about: that costs less than to look for those nearby.
const FEW: usize = 3;
