use glam::DVec3;

use crate::{camera::Ray, rgb::Rgb};

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
