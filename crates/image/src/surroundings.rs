use glam::DVec3;

use crate::{
    camera::Ray,
    lamp::Lamp,
    rgb::{self, Rgb},
    sky::Sky,
    sphere::Sphere,
    table::Table,
};

/// Upright walls around the pearl, a square room open to the sky.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Walls {
    /// From the pearl's centre to each wall.
    pub half_width_mm: f64,
    /// Height above the table.
    pub height_mm: f64,
    /// Share of light that the walls send back, linear RGB.
    pub colour: Rgb,
}

/// Everything the pearl stands in and mirrors: table, walls, sky, and the lamps that light them.
///
/// Lamps themselves are not seen here: their images in the pearl are the facets' work.
#[derive(Debug, Clone)]
pub struct Surroundings {
    /// What the pearl lies on, if anything.
    pub table: Option<Table>,
    /// Upright walls, if any.
    pub walls: Option<Walls>,
    /// What is behind all.
    pub sky: Sky,
    /// The lamps.
    pub lamps: Vec<Lamp>,
    /// The pearl, which throws its shadow.
    pub pearl: Sphere,
    /// Radiance of a white matt table under the sky alone; walls are taken to receive half of it.
    sky_on_table: Rgb,
}

/// What a ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen {
    /// Linear RGB.
    pub radiance: Rgb,
    /// How far off it is; infinite for the sky.
    pub distance_mm: f64,
}

impl Surroundings {
    /// Puts the pieces together; the sky's light on the table is computed here, once.
    pub fn new(
        table: Option<Table>,
        walls: Option<Walls>,
        sky: Sky,
        lamps: Vec<Lamp>,
        pearl: Sphere,
    ) -> Self {
        let sky_on_table = sky.on_table();
        Self { table, walls, sky, lamps, pearl, sky_on_table }
    }

    /// What `ray` meets, the pearl left out. `spread_rad` is the angle that the ray stands for: finer
    /// patterns are averaged away, not aliased.
    pub fn seen(&self, ray: &Ray, spread_rad: f64) -> Seen {
        let table = self
            .table
            .as_ref()
            .and_then(|table| Some((table, distance_down(ray, -self.pearl.radius_mm)?)));
        let walls = self.walls.and_then(|walls| self.wall_ahead(&walls, ray));
        match (table, walls) {
            (Some((table, distance_mm)), wall)
                if wall.is_none_or(|(_, wall_mm)| distance_mm < wall_mm) =>
            {
                let radiance = self.table_radiance(table, ray, distance_mm, spread_rad);
                Seen { radiance, distance_mm }
            }
            (_, Some((radiance, distance_mm))) => Seen { radiance, distance_mm },
            _ => Seen {
                radiance: self.sky.radiance(ray.along, spread_rad),
                distance_mm: f64::INFINITY,
            },
        }
    }

    /// Radiance far away in a direction, which distant things fade into.
    pub fn backdrop(&self, along: DVec3, spread_rad: f64) -> Rgb {
        self.sky.radiance(DVec3::new(along.x, along.y.max(0.0), along.z), spread_rad)
    }

    fn table_radiance(&self, table: &Table, ray: &Ray, distance_mm: f64, spread_rad: f64) -> Rgb {
        let point = ray.from + ray.along * distance_mm;
        let footprint_mm = distance_mm.min(FOOTPRINT_LIMIT_MM) * spread_rad;
        let albedo = table.albedo(point.x, point.z, footprint_mm, -ray.along.y);
        rgb::times(albedo, self.light_on_table(point))
    }

    /// Radiance of a white matt table at `point`: lamps past the pearl, and the sky beside it.
    fn light_on_table(&self, point: DVec3) -> Rgb {
        let mut light = rgb::scaled(self.sky_on_table, self.pearl.sky_past(point));
        for lamp in &self.lamps {
            let toward = lamp.toward(point);
            if toward.y > 0.0 {
                let past = self.pearl.light_past(point, toward, lamp.angular_radius_rad());
                rgb::add(&mut light, rgb::scaled(lamp.brightness, toward.y * past));
            }
        }
        light
    }

    /// The wall that the ray leaves the room through, if it does so below the walls' top.
    fn wall_ahead(&self, walls: &Walls, ray: &Ray) -> Option<(Rgb, f64)> {
        let exit = |from: f64, along: f64| {
            if along == 0.0 {
                f64::INFINITY
            } else {
                (walls.half_width_mm.copysign(along) - from) / along
            }
        };
        let (x_mm, z_mm) = (exit(ray.from.x, ray.along.x), exit(ray.from.z, ray.along.z));
        let distance_mm = x_mm.min(z_mm);
        let top_mm = walls.height_mm - self.pearl.radius_mm;
        let height_mm = ray.from.y + ray.along.y * distance_mm;
        if !(distance_mm > 0.0 && distance_mm.is_finite() && height_mm <= top_mm) {
            return None;
        }
        let inward = if x_mm < z_mm {
            DVec3::new(-ray.along.x.signum(), 0.0, 0.0)
        } else {
            DVec3::new(0.0, 0.0, -ray.along.z.signum())
        };
        let point = ray.from + ray.along * distance_mm;
        let mut light = rgb::scaled(self.sky_on_table, 0.5);
        for lamp in &self.lamps {
            rgb::add(
                &mut light,
                rgb::scaled(lamp.brightness, lamp.toward(point).dot(inward).max(0.0)),
            );
        }
        Some((rgb::times(walls.colour, light), distance_mm))
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
