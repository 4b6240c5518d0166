use crate::{
    light::glow::Glow,
    rgb::Rgb,
    shape::{ball::Ball, neighbours::Neighbours},
    surroundings::{
        lamp::Lamp,
        light_map::LightMap,
        sky::Sky,
        table::Table,
        walls::{WallLight, Walls},
        window::Window,
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
    neighbours: Neighbours,
    /// Height of the table: that of the lowest ball's lowest point.
    pub(crate) table_y_mm: f64,
    /// Radiance of a white matt table under the sky alone; walls are taken to receive half of it.
    pub(crate) sky_on_table: Rgb,
    /// Soft light on the table, near and far, once it is settled.
    pub(crate) table_lights: Vec<LightMap>,
    /// Light on the walls, once it is settled.
    pub(crate) wall_light: Option<WallLight>,
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
        let lowest = balls.iter().map(|ball| ball.centre.y - ball.radius_mm).reduce(f64::min);
        let table_y_mm = lowest.unwrap_or(0.0);
        let (windows, neighbours) = (Vec::new(), Neighbours::new(&balls));
        Self {
            table,
            walls,
            sky,
            lamps,
            windows,
            balls,
            neighbours,
            table_y_mm,
            sky_on_table,
            table_lights: Vec::new(),
            wall_light: None,
        }
    }

    /// The same with windows.
    #[must_use]
    pub fn with_windows(self, windows: Vec<Window>) -> Self {
        Self { windows, ..self }
    }

    /// Tells how a pearl looks to its neighbours and to the table.
    pub fn set_glow(&mut self, ball: usize, glow: Glow) {
        self.balls[ball].glow = glow;
        self.table_lights.clear();
    }

    /// The balls that a cone of light may meet, the one left out that it comes from.
    pub(crate) fn balls_near(
        &self,
        ray: &Ray,
        spread_rad: f64,
        from: Option<usize>,
    ) -> impl Iterator<Item = &Ball> {
        let others = from.map(|ball| self.neighbours.near(ball, ray, spread_rad));
        let all = if from.is_some() { 0..0 } else { 0..self.balls.len() };
        others.into_iter().flatten().chain(all).map(|ball| &self.balls[ball])
    }
}
