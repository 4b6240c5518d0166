//! What lies behind everything: table, walls and sky, along one ray.
//!
//! Exact intersections; patterns averaged over the footprint of the ray's cone.
//! Left out: the rims of walls and table, which are sharp.

use glam::DVec3;

use crate::{
    rgb::{self, Rgb},
    surroundings::{lit::Lit, table::Table},
    view::{cone::Cone, ray::Ray},
};

/// What a ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen {
    /// Linear RGB.
    pub radiance: Rgb,
    /// How far off it is; infinite for the sky, and for windows, whose light does not fade.
    pub distance_mm: f64,
}

impl Lit {
    /// What `ray` meets of table, walls and sky.
    pub(crate) fn ground(&self, ray: &Ray, cone: &Cone) -> Seen {
        let table = self.table_ahead(ray);
        let wall = self.walls.and_then(|walls| {
            let (distance_mm, inward) = walls.ahead(ray, self.table_y_mm)?;
            Some((walls.colour, distance_mm, inward))
        });
        match (table, wall) {
            (Some((table, distance_mm)), wall)
                if wall.is_none_or(|(_, wall_mm, _)| distance_mm < wall_mm) =>
            {
                let radiance = self.table_radiance(table, ray, distance_mm, cone.mean_rad());
                Seen { radiance, distance_mm }
            }
            (_, Some((colour, distance_mm, inward))) => {
                let point = ray.from + ray.along * distance_mm;
                Seen {
                    radiance: rgb::times(colour, self.light_of_wall(point, inward)),
                    distance_mm,
                }
            }
            _ => Seen {
                radiance: self.sky.radiance_over(ray.along, cone),
                distance_mm: f64::INFINITY,
            },
        }
    }

    /// The table and how far off a ray meets it, were there no walls.
    pub(super) fn table_ahead(&self, ray: &Ray) -> Option<(&Table, f64)> {
        Some((self.table.as_ref()?, distance_down(ray, self.table_y_mm)?))
    }

    /// Radiance far away in a direction, which distant things fade into.
    pub fn backdrop(&self, along: DVec3, cone: &Cone) -> Rgb {
        self.sky.radiance_over(DVec3::new(along.x, along.y.max(0.0), along.z), cone)
    }

    fn table_radiance(&self, table: &Table, ray: &Ray, distance_mm: f64, spread_rad: f64) -> Rgb {
        let point = ray.from + ray.along * distance_mm;
        let footprint_mm = distance_mm.min(FOOTPRINT_LIMIT_MM) * spread_rad;
        let albedo = table.albedo(point.x, point.z, footprint_mm, -ray.along.y);
        rgb::times(albedo, self.light_on_table(point))
    }
}

/// Beyond this a flat table is one colour; it keeps a ray along the horizon finite.
const FOOTPRINT_LIMIT_MM: f64 = 1e6;

/// Distance along `ray` to the plane y = `height_mm`, if it goes down to it.
fn distance_down(ray: &Ray, height_mm: f64) -> Option<f64> {
    let distance_mm = (height_mm - ray.from.y) / ray.along.y;
    (ray.along.y < 0.0 && distance_mm > 0.0 && distance_mm < FOOTPRINT_LIMIT_MM)
        .then_some(distance_mm)
}
