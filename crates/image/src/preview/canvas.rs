//! What each pixel of a preview sees of a pearl: a place in its net, with relief and grain.
//!
//! One line of sight a pixel, coverage by its distance from the silhouette. Kept while film and light change.
//! Left out: pearls that stand before each other within one pixel, slopes too fine for one.

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
    preview::{dyes, glimpses::Glimpses, veil::fine_net},
    shape::ball::Hit,
    surface::facets::Facets,
    surroundings::{lamp::Lamp, lit::Lit},
    view::{camera::Camera, ray::Ray},
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
    /// Of `sitters[i]` as ball `i`.
    pub fn new(
        sitters: &[Sitter<'_>],
        surroundings: &Lit,
        camera: &Camera,
        size_px: usize,
    ) -> Self {
        let pixel_mm = pixels_mm(surroundings, camera, size_px);
        let view = View { sitters, surroundings, camera, pixel_mm, size_px };
        let mut spots = vec![Spot::default(); size_px * size_px];
        let glints = parallel::map_chunks(&mut spots, size_px, |row, spots| view.fill(row, spots));
        Self { size_px, spots, glints }
    }
}

/// Pearls before a camera.
struct View<'a> {
    sitters: &'a [Sitter<'a>],
    surroundings: &'a Lit,
    camera: &'a Camera,
    /// Width of a pixel at each ball.
    pixel_mm: Vec<f64>,
    size_px: usize,
}

impl View<'_> {
    /// One row, and the images of lamps in it.
    fn fill(&self, row: usize, spots: &mut [Spot]) -> Vec<Glint> {
        let mut glints = Vec::new();
        let middle = 0.5 * self.size_px as f64;
        let y = (middle - row as f64 - 0.5) / middle;
        let reach_mm = |ball: usize| self.surroundings.balls[ball].reach_mm() + self.pixel_mm[ball];
        let near = |&ball: &usize| {
            self.camera.off_row_mm(y, self.surroundings.balls[ball].centre) < reach_mm(ball)
        };
        let balls: Vec<usize> = (0..self.sitters.len()).filter(near).collect();
        for (column, spot) in spots.iter_mut().enumerate() {
            let ray = self.camera.ray((column as f64 + 0.5 - middle) / middle, y);
            if let Some((ball, coverage)) = self.front(&ray, &balls) {
                let point = self.point(ball, &ray);
                *spot = self.spot(coverage, &point);
                self.add_glints(column, &point, &mut glints);
            }
        }
        glints
    }

    /// The nearest of the pearls that a pixel shows, and the share that it covers.
    #[inline]
    fn front(&self, ray: &Ray, balls: &[usize]) -> Option<(usize, f32)> {
        let covered = |&ball: &usize| {
            let pixel_mm = self.pixel_mm[ball];
            let inside_mm = match self.surroundings.solid(ball) {
                None => self.inside_round_mm(ball, ray)?,
                Some(_) if self.surroundings.is_passed(ball, ray, pixel_mm) => return None,
                Some(_) => self.surroundings.inside_mm(ball, ray, 2.0 * pixel_mm).0,
            };
            let coverage = (inside_mm / pixel_mm + 0.5).clamp(0.0, 1.0);
            (coverage > 0.0).then_some((ball, coverage as f32))
        };
        let far_mm = |ball: usize| self.surroundings.balls[ball].centre.distance_squared(ray.from);
        let all = balls.iter().filter_map(covered);
        all.min_by(|a, b| far_mm(a.0).total_cmp(&far_mm(b.0)))
    }

    /// How far inside a ball's silhouette a line of sight passes; `None` well beside it.
    #[inline]
    fn inside_round_mm(&self, ball: usize, ray: &Ray) -> Option<f64> {
        let place = &self.surroundings.balls[ball];
        let from = ray.from - place.centre;
        let ahead_mm = from.dot(ray.along);
        let passing2 = from.length_squared() - ahead_mm * ahead_mm;
        let reach_mm = place.radius_mm + self.pixel_mm[ball];
        (passing2 < reach_mm * reach_mm).then(|| place.radius_mm - passing2.max(0.0).sqrt())
    }

    /// The point of a pearl on a line of sight, with its relief.
    fn point(&self, ball: usize, ray: &Ray) -> Sight {
        let (skin, pixel_mm, view) = (self.sitters[ball].skin, self.pixel_mm[ball], -ray.along);
        let hit = self.surroundings.nearest(ball, ray);
        let outward = self.surroundings.outward(ball, &hit);
        let place = &self.surroundings.balls[ball];
        let lengths_mm = [hit.point.distance(place.centre), pixel_mm];
        let (local, grain) = if skin.has_relief() {
            skin.local((outward, hit.cos_view), place.radius_mm, lengths_mm)
        } else {
            (Local::EVEN, None)
        };
        let grain = grain.unwrap_or_else(|| skin.grain_at(outward, pixel_mm / place.radius_mm));
        let normal = local.normal(hit.normal, view);
        let spread = Spread::of_square(pixel_mm / place.radius_mm, hit.cos_view);
        let spread = spread.over_slopes(local.fine_slope2);
        let hit = Hit { normal, cos_view: normal.dot(view), ..hit };
        let (part, around) = ((0, 1), Arounds::default());
        Sight {
            ball,
            hit,
            outward,
            local,
            grain: Some(grain),
            view,
            pixel_mm,
            spread,
            part,
            around,
        }
    }

    /// What a pixel shows of a pearl.
    fn spot(&self, coverage: f32, point: &Sight) -> Spot {
        let Sight { ball, hit, outward, local, .. } = point;
        let at = |normal: DVec3| self.sitters[*ball].net.place_in_single(normal);
        let normal = at(hit.normal);
        let is_round = self.surroundings.solid(*ball).is_none();
        Spot {
            ball: *ball as u16,
            row: dyes::row(hit.cos_view),
            coverage,
            normal,
            outward: (!is_round).then(|| at(*outward)),
            thickness: local.thickness as f32,
            chalk: local.chalk as f32,
            inside: local.inside as f32,
            grain: point.grain.unwrap_or_default().map(|part| part as f32),
        }
    }

    /// The images of lamps at a point.
    fn add_glints(&self, column: usize, point: &Sight, glints: &mut Vec<Glint>) {
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
                    column: column as u16,
                    lobe: lobe as u8,
                    lamp: number as u8,
                    row: dyes::row(half.dot(*view)),
                    strength: (image * past) as f32,
                });
            }
        }
    }
}
