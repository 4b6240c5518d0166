use std::f64::consts::PI;

use glam::DVec3;

/// The unit vector towards an azimuth (0 is the viewer's side, positive to the right) and elevation.
pub fn direction(azimuth_rad: f64, elevation_rad: f64) -> DVec3 {
    let (sin_a, cos_a) = libm::sincos(azimuth_rad);
    let (sin_e, cos_e) = libm::sincos(elevation_rad);
    DVec3::new(sin_a * cos_e, sin_e, cos_a * cos_e)
}

/// Directions over the whole sphere, each with its share of it.
pub(crate) fn directions(rows: u32) -> impl Iterator<Item = (DVec3, f64)> {
    let step = PI / f64::from(rows);
    (0..rows).flat_map(move |row| {
        let elevation = (f64::from(row) + 0.5) * step - 0.5 * PI;
        let share = libm::cos(elevation) * libm::sin(0.5 * step) / f64::from(2 * rows);
        (0..2 * rows)
            .map(move |column| (direction((f64::from(column) + 0.5) * step, elevation), share))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_grid_covers_the_sphere_once() {
        let whole: f64 = directions(48).map(|(_, share)| share).sum();
        assert!((whole - 1.0).abs() < 1e-12, "{whole}");
    }
}
