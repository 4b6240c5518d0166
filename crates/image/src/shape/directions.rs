//! Directions that share out the sphere evenly.
//!
//! Fibonacci's spiral.
//! Left out: directions at random.

use glam::DVec3;

/// So many, from one pole to the other.
pub(crate) fn even_directions(count: usize) -> impl Iterator<Item = DVec3> {
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..count).map(move |i| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = libm::sincos(golden * i as f64);
        let aside = (1.0 - z * z).sqrt();
        DVec3::new(aside * cos, aside * sin, z)
    })
}
