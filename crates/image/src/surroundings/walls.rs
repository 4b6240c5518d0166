use glam::DVec3;

use crate::{rgb::Rgb, surroundings::light_map::LightMap, view::ray::Ray};

/// Upright walls around the pearls, a square room open to the sky.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Walls {
    /// From the middle to each wall.
    pub half_width_mm: f64,
    /// Height above the table.
    pub height_mm: f64,
    /// Share of light that the walls send back, linear RGB.
    pub colour: Rgb,
}

impl Walls {
    /// Distance along `ray` to the wall that it leaves the room through, if it does so below the walls'
    /// top, and the direction from there into the room.
    pub(crate) fn ahead(&self, ray: &Ray, table_y_mm: f64) -> Option<(f64, DVec3)> {
        let exit = |from: f64, along: f64| {
            if along == 0.0 {
                f64::INFINITY
            } else {
                (self.half_width_mm.copysign(along) - from) / along
            }
        };
        let (x_mm, z_mm) = (exit(ray.from.x, ray.along.x), exit(ray.from.z, ray.along.z));
        let distance_mm = x_mm.min(z_mm);
        let top_mm = self.height_mm + table_y_mm;
        let height_mm = ray.from.y + ray.along.y * distance_mm;
        if !(distance_mm > 0.0 && distance_mm.is_finite() && height_mm <= top_mm) {
            return None;
        }
        let inward = if x_mm < z_mm {
            DVec3::new(-ray.along.x.signum(), 0.0, 0.0)
        } else {
            DVec3::new(0.0, 0.0, -ray.along.z.signum())
        };
        Some((distance_mm, inward))
    }
}

/// Steps of a light map of a wall, along it and up.
const STEPS: [usize; 2] = [96, 96];

/// Light on each wall, by the direction from it into the room; the walls themselves, and as far below the
/// table as a wall is wide, for boxes without a table.
#[derive(Debug, Clone)]
pub(crate) struct WallLight([LightMap; 4]);

impl WallLight {
    /// `light` works out a point of a wall, the direction into the room given.
    pub(crate) fn new(
        walls: &Walls,
        table_y_mm: f64,
        light: impl Fn(DVec3, DVec3) -> Rgb + Sync,
    ) -> Self {
        let wide_mm = walls.half_width_mm;
        let top_mm = table_y_mm + walls.height_mm.min(8.0 * wide_mm);
        let low_mm = table_y_mm - 2.0 * wide_mm;
        Self(INWARD.map(|inward| {
            let corner = [-wide_mm, low_mm];
            LightMap::new(corner, [wide_mm, top_mm], STEPS, |[along, y]| {
                let across = DVec3::new(inward.z.abs(), 0.0, inward.x.abs());
                light(-wide_mm * inward + along * across + y * DVec3::Y, inward)
            })
        }))
    }

    /// The light at a point of a wall, if it is mapped.
    pub(crate) fn at(&self, point: DVec3, inward: DVec3) -> Option<Rgb> {
        let wall = INWARD.iter().position(|direction| *direction == inward)?;
        let along = if inward.x == 0.0 { point.x } else { point.z };
        self.0[wall].at([along, point.y])
    }
}

const INWARD: [DVec3; 4] = [DVec3::X, DVec3::NEG_X, DVec3::Z, DVec3::NEG_Z];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_wall_has_its_own_light_at_its_own_place() {
        let walls = Walls { half_width_mm: 50.0, height_mm: 80.0, colour: [1.0; 3] };
        let light = |point: DVec3, inward: DVec3| {
            assert!((point.dot(inward) + 50.0).abs() < 1e-9);
            [point.x, point.y, point.z + inward.x]
        };
        let mapped = WallLight::new(&walls, -4.0, light);
        for inward in INWARD {
            let point = -50.0 * inward + 13.0 * inward.cross(DVec3::Y) + 21.0 * DVec3::Y;
            let (found, put) = (mapped.at(point, inward).unwrap(), light(point, inward));
            assert!((0..3).all(|i| (found[i] - put[i]).abs() < 1e-9), "{inward}");
            assert_eq!(mapped.at(point + 90.0 * DVec3::Y, inward), None);
        }
    }
}
