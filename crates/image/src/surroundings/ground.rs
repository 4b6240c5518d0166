//! What lies behind everything: table, walls and sky, along one ray.
//!
//! Exact intersections; patterns averaged over the footprint of the ray's cone.
//! Left out: the rims of walls and table, which are sharp.

use glam::DVec3;

use crate::{
    rgb::{self, Rgb},
    surroundings::{
        lit::Lit,
        table::{Spot, Table},
        weave::LANES,
    },
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

    /// What several rays meet of the table, where nothing stands before it: what [`Self::ground`] says of each, to the bit.
    pub(super) fn bare_table(
        &self,
        rays: &[Ray; LANES],
        spreads_rad: [f64; LANES],
    ) -> Option<[Rgb; LANES]> {
        let table = self.table.as_ref()?;
        let (mut points, mut spots) = ([DVec3::ZERO; LANES], [Spot::default(); LANES]);
        for (i, ray) in rays.iter().enumerate() {
            let distance_mm = distance_down(ray, self.table_y_mm)?;
            let wall = self.walls.and_then(|walls| walls.ahead(ray, self.table_y_mm));
            if wall.is_some_and(|(wall_mm, _)| wall_mm <= distance_mm) {
                return None;
            }
            (points[i], spots[i]) = spot(ray, distance_mm, spreads_rad[i]);
        }
        let albedos = table.albedos(&spots);
        Some(std::array::from_fn(|i| rgb::times(albedos[i], self.light_on_table(points[i]))))
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
        let (point, Spot { x, z, footprint_mm, slant }) = spot(ray, distance_mm, spread_rad);
        let albedo = table.albedo(x, z, footprint_mm, slant);
        rgb::times(albedo, self.light_on_table(point))
    }
}

/// Where a ray meets the table so far off, and how.
fn spot(ray: &Ray, distance_mm: f64, spread_rad: f64) -> (DVec3, Spot) {
    let point = ray.from + ray.along * distance_mm;
    let footprint_mm = distance_mm.min(FOOTPRINT_LIMIT_MM) * spread_rad;
    (point, Spot { x: point.x, z: point.z, footprint_mm, slant: -ray.along.y })
}

/// Beyond this a flat table is one colour; it keeps a ray along the horizon finite.
const FOOTPRINT_LIMIT_MM: f64 = 1e6;

/// Distance along `ray` to the plane y = `height_mm`, if it goes down to it.
fn distance_down(ray: &Ray, height_mm: f64) -> Option<f64> {
    let distance_mm = (height_mm - ray.from.y) / ray.along.y;
    (ray.along.y < 0.0 && distance_mm > 0.0 && distance_mm < FOOTPRINT_LIMIT_MM)
        .then_some(distance_mm)
}
