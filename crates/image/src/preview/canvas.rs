//! What each pixel of a preview sees of a pearl: a place in its net, with relief and grain.
//!
//! From the points under the pixels, each tilted by the grain's relief. Kept while film and light change.
//! Left out: what pixels see beside pearls, which is the backdrop.

use glam::DVec3;

use crate::{
    coat::local::Local,
    parallel,
    pearl::{
        glint::glint,
        lobe_colours::LobeColours,
        net::Net,
        reflection::seen_in,
        reflection_cache::Arounds,
        response::Response,
        sight::{Sight, Spread},
        skin::Skin,
    },
    picture::reflections::pixels_mm,
    preview::{
        dyes,
        glimpses::Glimpses,
        points::{Place, Point, Points, line},
        veil::fine_net,
    },
    shape::ball::{Ball, Hit},
    surface::facets::Facets,
    surroundings::{lamp::Lamp, lit::Lit},
    view::camera::Camera,
};

/// Pixels of a preview, row by row.
#[derive(Debug)]
pub struct Canvas {
    pub(super) size_px: usize,
    pub(super) spots: Vec<Spot>,
    /// Images of lamps, by rows of pixels.
    pub(super) glints: Vec<Vec<Glint>>,
}

/// An image of a lamp in one pixel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Glint {
    pub(super) column: u16,
    /// The lobe and the lamp, by their numbers.
    pub(super) lobe: u8,
    pub(super) lamp: u8,
    /// The row of tables by the cosine of incidence.
    pub(super) row: u16,
    /// Radiance where all of the lamp's light is mirrored.
    pub(super) strength: f32,
}

/// A pearl before a canvas.
pub struct Sitter<'a> {
    skin: &'a Skin,
    net: Net,
    /// The facets of each lobe, and the lamps as they show them.
    lobes: Vec<(Facets<'a>, Vec<Lamp>)>,
}

impl<'a> Sitter<'a> {
    /// With what its lobes see of `surroundings`, whose lamps are those of `response`.
    pub fn new(
        skin: &'a Skin,
        glimpses: &'a Glimpses,
        response: &'a Response,
        surroundings: &Lit,
    ) -> Self {
        let lobe = |colours: &'a LobeColours| {
            let facets = colours.facets();
            (facets, seen_in(&facets, &surroundings.lamps))
        };
        let lobes = response.films().middle().iter().map(lobe).collect();
        Self { skin, net: fine_net(glimpses), lobes }
    }
}

/// What a pixel shows.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Spot {
    /// The pearl, by its number.
    pub(super) ball: u16,
    /// The row of tables by angle.
    pub(super) row: u16,
    /// Share of the pixel that the pearl covers.
    pub(super) coverage: f32,
    /// Where the net has the normal, in knots.
    pub(super) normal: [f32; 2],
    /// Where it has the direction from the middle of a pearl that is not round; relief turns the normal by too little for
    /// light inside.
    pub(super) outward: Option<[f32; 2]>,
    /// Factor on the layers' thickness, share of chalk, factor on light from inside.
    pub(super) thickness: f32,
    pub(super) chalk: f32,
    pub(super) inside: f32,
    /// Hue, value and chroma of the grain.
    pub(super) grain: [f32; 3],
}

impl Canvas {
    /// Of `sitters[i]` as ball `i`, whose points are given.
    pub fn new(
        points: &Points,
        sitters: &[Sitter<'_>],
        surroundings: &Lit,
        camera: &Camera,
    ) -> Self {
        let size_px = points.size_px;
        let pixel_mm = pixels_mm(surroundings, camera, size_px);
        let view = View { points, sitters, surroundings, camera, pixel_mm };
        let mut spots = vec![Spot::default(); size_px * size_px];
        let glints = parallel::map_chunks(&mut spots, size_px, |row, spots| view.fill(row, spots));
        Self { size_px, spots, glints }
    }
}

/// Pearls before a camera.
struct View<'a> {
    points: &'a Points,
    sitters: &'a [Sitter<'a>],
    surroundings: &'a Lit,
    camera: &'a Camera,
    /// Width of a pixel at each ball.
    pixel_mm: Vec<f64>,
}

/// A point with its relief.
struct Tilted<'a> {
    point: &'a Point,
    place: Place,
    /// Coat and relief together.
    local: Local,
    normal: DVec3,
    /// Towards the eye.
    view: DVec3,
}

impl View<'_> {
    /// One row, and the images of lamps in it.
    fn fill(&self, row: usize, spots: &mut [Spot]) -> Vec<Glint> {
        let mut glints = Vec::new();
        for (point, uneven) in self.points.row(row) {
            let column = usize::from(point.column);
            let view = -line(self.camera, self.points.size_px, [column, row]).along;
            let tilted = self.tilted(point, uneven, view);
            spots[column] = self.spot(&tilted);
            if !self.surroundings.lamps.is_empty() {
                self.add_glints(point.column, &self.sight(&tilted), &mut glints);
            }
        }
        glints
    }

    /// A point with its relief.
    #[inline]
    fn tilted<'a>(&self, point: &'a Point, uneven: Option<Place>, view: DVec3) -> Tilted<'a> {
        let (ball, own) = (usize::from(point.ball), point.normal());
        let away_mm = self.surroundings.balls[ball].radius_mm;
        let place = uneven.unwrap_or(Place { outward: own, away_mm, coat: Local::EVEN });
        let local = self.sitters[ball].skin.tilted(place.coat, &point.relief());
        Tilted { point, place, local, normal: local.normal(own, view), view }
    }

    /// What a pixel shows of a pearl.
    #[inline]
    fn spot(&self, tilted: &Tilted<'_>) -> Spot {
        let Tilted { point, place, local, normal, view } = tilted;
        let ball = usize::from(point.ball);
        let at = |normal: DVec3| self.sitters[ball].net.place_in_single(normal);
        let is_round = self.surroundings.solid(ball).is_none();
        Spot {
            ball: point.ball,
            row: dyes::row(normal.dot(*view)),
            coverage: point.coverage,
            normal: at(*normal),
            outward: (!is_round).then(|| at(place.outward)),
            thickness: local.thickness as f32,
            chalk: local.chalk as f32,
            inside: local.inside as f32,
            grain: point.grain,
        }
    }

    /// The same for lamps.
    fn sight(&self, tilted: &Tilted<'_>) -> Sight {
        let &Tilted { point, ref place, local, normal, view } = tilted;
        let ball = usize::from(point.ball);
        let (Ball { centre, radius_mm, .. }, pixel_mm) =
            (self.surroundings.balls[ball], self.pixel_mm[ball]);
        let spread = Spread::of_square(pixel_mm / radius_mm, point.normal().dot(view).max(0.0));
        let point = centre + place.outward * place.away_mm;
        Sight {
            ball,
            hit: Hit { point, normal, cos_view: normal.dot(view) },
            outward: place.outward,
            local,
            grain: None,
            view,
            pixel_mm,
            spread: spread.over_slopes(local.fine_slope2),
            part: (0, 1),
            around: Arounds::default(),
        }
    }

    /// The images of lamps at a point.
    fn add_glints(&self, column: u16, point: &Sight, glints: &mut Vec<Glint>) {
        let Sight { ball, hit, view, .. } = point;
        for (lobe, (facets, lamps)) in self.sitters[*ball].lobes.iter().enumerate() {
            for (number, lamp) in lamps.iter().enumerate() {
                let [image, ..] = glint(lamp, facets, point, |_| [1.0; 3]);
                if image <= 0.0 {
                    continue;
                }
                let past = self.surroundings.lamp_past(lamp, hit.point, Some(*ball));
                let half = (*view + lamp.toward(hit.point)).normalize_or(hit.normal);
                glints.push(Glint {
                    column,
                    lobe: lobe as u8,
                    lamp: number as u8,
                    row: dyes::row(half.dot(*view)),
                    strength: (image * past) as f32,
                });
            }
        }
    }
}
