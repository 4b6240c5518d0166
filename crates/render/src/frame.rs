//! Where a window stands.

use glam::DVec3;
use nacreous_image::direction;

use crate::spec::lights::WindowSpec;

/// Where a window stands whose distance is left out **(ours)**.
const FAR_MM: f64 = 1000.0;

/// Where a window is: its middle, and from there to its right and its upper edge. It shines along right x up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Its middle.
    pub centre_mm: DVec3,
    /// To the middle of its right edge; level.
    pub right_mm: DVec3,
    /// To the middle of its upper edge.
    pub up_mm: DVec3,
}

impl Frame {
    /// Of a window, given the height of the pearls' lowest point.
    pub fn of(window: &WindowSpec, lowest_mm: f64) -> Self {
        let (centre_mm, facing) = if let Some(below_mm) = window.below_mm {
            (DVec3::new(0.0, lowest_mm - below_mm, 0.0), DVec3::Y)
        } else if let Some(position_mm) = window.position_mm {
            let position_mm = DVec3::from(position_mm);
            (position_mm, window.facing.map_or(-position_mm, DVec3::from))
        } else {
            let azimuth_rad = window.azimuth_deg.unwrap_or(0.0).to_radians();
            let elevation_rad = window.elevation_deg.unwrap_or(0.0).to_radians();
            let toward = direction(azimuth_rad, elevation_rad);
            (toward * window.distance_mm.unwrap_or(FAR_MM), -toward)
        };
        Self::facing(centre_mm, facing, 0.5 * window.width_mm, 0.5 * window.height_mm)
    }

    /// A level width, and a height at right angles to it and to the direction of the light.
    fn facing(centre_mm: DVec3, facing: DVec3, half_width_mm: f64, half_height_mm: f64) -> Self {
        let facing = facing.normalize_or(DVec3::Y);
        let level = libm::hypot(facing.x, facing.z);
        // A window that lies flat has its width along x.
        let right = if level > 1e-9 {
            DVec3::new(facing.z / level, 0.0, -facing.x / level)
        } else {
            DVec3::X
        };
        let up = facing.cross(right);
        Self { centre_mm, right_mm: right * half_width_mm, up_mm: up * half_height_mm }
    }

    /// Distance from a point to the nearest point of the window.
    pub fn distance_mm(&self, point_mm: DVec3) -> f64 {
        let mut away_mm = point_mm - self.centre_mm;
        for edge_mm in [self.right_mm, self.up_mm] {
            let share = away_mm.dot(edge_mm) / edge_mm.length_squared();
            away_mm -= share.clamp(-1.0, 1.0) * edge_mm;
        }
        away_mm.length()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_point_may_be_a_corner_an_edge_or_within() {
        let frame = Frame {
            centre_mm: DVec3::new(0.0, 0.0, -9.0),
            right_mm: DVec3::new(3.0, 0.0, 0.0),
            up_mm: DVec3::new(0.0, 2.0, 0.0),
        };
        for (point_mm, distance_mm) in
            [([7.0, 0.0, -6.0], 5.0), ([1.0, 1.0, 0.0], 9.0), ([6.0, 6.0, -9.0], 5.0)]
        {
            assert!((frame.distance_mm(point_mm.into()) - distance_mm).abs() < 1e-12);
        }
    }

    #[test]
    fn a_window_shines_where_it_faces_and_its_width_is_level() {
        for facing in [DVec3::new(1.0, 2.0, -3.0), DVec3::Y, DVec3::NEG_Z] {
            let frame = Frame::facing(DVec3::ZERO, facing, 2.0, 3.0);
            let shines = frame.right_mm.cross(frame.up_mm).normalize();
            assert!((shines - facing.normalize()).length() < 1e-12, "{facing}");
            assert!(frame.right_mm.y.abs() < 1e-12);
        }
    }
}
