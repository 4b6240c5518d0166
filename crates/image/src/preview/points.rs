//! Points of pearls under the pixels of a preview, and what lies there whatever the weight of the grain's relief.
//!
//! One line of sight a pixel, coverage by its distance from the silhouette. Kept while that weight, film and light change.
//! Left out: pearls that stand before each other within one pixel, slopes too fine for one.

use glam::{DVec3, Vec3};

use crate::{
    coat::{local::Local, rulings::Rulings},
    grain::texture::Relief,
    parallel,
    pearl::skin::Skin,
    picture::reflections::pixels_mm,
    shape::ball::Ball,
    surroundings::lit::Lit,
    view::{camera::Camera, ray::Ray},
};

/// Points of pearls under the pixels of a preview.
#[derive(Debug)]
pub struct Points {
    pub(super) size_px: usize,
    rows: Vec<Row>,
}

/// Those of a row of pixels, from left to right.
#[derive(Debug, Default)]
struct Row {
    points: Vec<Point>,
    uneven: Vec<Uneven>,
}

/// What is under a pixel; in single precision, and of pixels that pearls cover only, for there are many: 52 bytes each.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub(super) column: u16,
    /// The pearl, by its number.
    pub(super) ball: u16,
    /// Share of the pixel that the pearl covers.
    pub(super) coverage: f32,
    /// Hue, value and chroma of the grain.
    pub(super) grain: [f32; 3],
    /// Of its value, as [`Relief`] has it.
    gradient: Vec3,
    seen: f32,
    /// Of the pearl itself, without coat and relief.
    normal: Vec3,
    /// Its number in the row, where there is more to say than of an even ball.
    uneven: Option<u16>,
}

/// What a pixel of no even ball has besides: 48 bytes in a browser, and those of rulings where terraces are fine.
#[derive(Debug)]
struct Uneven {
    outward: Vec3,
    away_mm: f32,
    slope: Vec3,
    fine_slope2: f32,
    thickness: f32,
    chalk: f32,
    inside: f32,
    rulings: Option<Box<Rulings>>,
}

/// What an even ball lacks at a point.
pub(super) struct Place {
    /// The direction from the pearl's middle, and how far off that is.
    pub(super) outward: DVec3,
    pub(super) away_mm: f64,
    /// Without the grain's relief.
    pub(super) coat: Local,
}

impl Points {
    /// Of the pearls before a camera, `skins[i]` being that of ball `i`.
    pub fn new(skins: &[&Skin], surroundings: &Lit, camera: &Camera, size_px: usize) -> Self {
        let pixel_mm = pixels_mm(surroundings, camera, size_px);
        let look = Look { skins, surroundings, camera, pixel_mm, size_px };
        Self { size_px, rows: parallel::map(size_px, |row| look.row(row)) }
    }

    /// Those of a row, each with what it lacks of an even ball.
    pub(super) fn row(&self, row: usize) -> impl Iterator<Item = (&Point, Option<Place>)> {
        let Row { points, uneven } = &self.rows[row];
        let place = |number: u16| uneven[usize::from(number)].place();
        points.iter().map(move |point| (point, point.uneven.map(place)))
    }
}

/// The line of sight through the middle of a pixel.
pub(super) fn line(camera: &Camera, size_px: usize, [column, row]: [usize; 2]) -> Ray {
    camera.ray(from_middle(size_px, column), -from_middle(size_px, row))
}

/// How far the middle of a pixel is from the picture's, from -1 to 1.
fn from_middle(size_px: usize, pixel: usize) -> f64 {
    let middle = 0.5 * size_px as f64;
    (pixel as f64 + 0.5 - middle) / middle
}

impl Point {
    pub(super) fn normal(&self) -> DVec3 {
        self.normal.as_dvec3()
    }

    pub(super) fn relief(&self) -> Relief {
        let (gradient, seen) = (self.gradient.as_dvec3(), f64::from(self.seen));
        Relief { value: self.grain, gradient, seen }
    }
}

impl Uneven {
    fn new(Place { outward, away_mm, coat }: &Place) -> Self {
        Self {
            outward: outward.as_vec3(),
            away_mm: *away_mm as f32,
            slope: coat.slope.as_vec3(),
            fine_slope2: coat.fine_slope2 as f32,
            thickness: coat.thickness as f32,
            chalk: coat.chalk as f32,
            inside: coat.inside as f32,
            rulings: coat.rulings.map(Box::new),
        }
    }

    fn place(&self) -> Place {
        let coat = Local {
            slope: self.slope.as_dvec3(),
            fine_slope2: f64::from(self.fine_slope2),
            thickness: f64::from(self.thickness),
            chalk: f64::from(self.chalk),
            inside: f64::from(self.inside),
            rulings: self.rulings.as_deref().copied(),
        };
        Place { outward: self.outward.as_dvec3(), away_mm: f64::from(self.away_mm), coat }
    }
}

/// Pearls before a camera.
struct Look<'a> {
    skins: &'a [&'a Skin],
    surroundings: &'a Lit,
    camera: &'a Camera,
    /// Width of a pixel at each ball.
    pixel_mm: Vec<f64>,
    size_px: usize,
}

impl Look<'_> {
    fn row(&self, row: usize) -> Row {
        let y = -from_middle(self.size_px, row);
        let reach_mm = |ball: usize| self.surroundings.balls[ball].reach_mm() + self.pixel_mm[ball];
        let near = |&ball: &usize| {
            self.camera.off_row_mm(y, self.surroundings.balls[ball].centre) < reach_mm(ball)
        };
        let balls: Vec<usize> = (0..self.skins.len()).filter(near).collect();
        let mut found = Row::default();
        for column in 0..self.size_px {
            let ray = line(self.camera, self.size_px, [column, row]);
            if let Some((ball, coverage)) = self.front(&ray, &balls) {
                self.add((ball, coverage), column, &ray, &mut found);
            }
        }
        found.points.shrink_to_fit();
        found.uneven.shrink_to_fit();
        found
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

    /// Adds the point of a pearl on a line of sight to a row.
    fn add(&self, (ball, coverage): (usize, f32), column: usize, ray: &Ray, row: &mut Row) {
        let (skin, pixel_mm) = (self.skins[ball], self.pixel_mm[ball]);
        let hit = self.surroundings.nearest(ball, ray);
        let outward = self.surroundings.outward(ball, &hit);
        let Ball { centre, radius_mm, .. } = self.surroundings.balls[ball];
        let away_mm = hit.point.distance(centre);
        let (coat, relief) = if skin.has_relief() {
            skin.layers((outward, hit.cos_view), radius_mm, [away_mm, pixel_mm])
        } else {
            (Local::EVEN, None)
        };
        let relief = relief.unwrap_or_else(|| {
            let grain = skin.grain_at(outward, pixel_mm / radius_mm);
            Relief::level(grain.map(|part| part as f32))
        });
        let is_round = self.surroundings.solid(ball).is_none();
        let uneven = (!is_round || coat != Local::EVEN).then_some(row.uneven.len() as u16);
        if uneven.is_some() {
            row.uneven.push(Uneven::new(&Place { outward, away_mm, coat }));
        }
        row.points.push(Point {
            column: column as u16,
            ball: ball as u16,
            coverage,
            grain: relief.value,
            gradient: relief.gradient.as_vec3(),
            seen: relief.seen as f32,
            normal: hit.normal.as_vec3(),
            uneven,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_as_small_as_is_said() {
        assert_eq!(size_of::<Point>(), 52);
        assert!(size_of::<Uneven>() <= 48 + size_of::<usize>());
    }

    #[test]
    fn a_place_is_kept_as_it_was() {
        let coat = Local { slope: DVec3::new(0.1, -0.2, 0.3), chalk: 0.4, ..Local::EVEN };
        let place = Uneven::new(&Place { outward: DVec3::Y, away_mm: 4.1, coat }).place();
        assert!(
            (place.coat.slope - coat.slope).length() + (place.coat.chalk - coat.chalk).abs() < 1e-6
        );
        assert_eq!(Local { slope: coat.slope, chalk: coat.chalk, ..place.coat }, coat);
        assert!(place.outward == DVec3::Y && (place.away_mm - 4.1).abs() < 1e-6);
    }
}
