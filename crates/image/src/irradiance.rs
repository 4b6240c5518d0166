use glam::DVec3;

use crate::{
    camera::Ray,
    rgb::{self, Rgb},
    sky::{GRID_RAD, directions},
    surroundings::Surroundings,
};

/// The light of the surroundings, lamps apart, that falls on a matt surface by its normal: nine
/// spherical harmonics, exact to 3 % for any surroundings (Ramamoorthi and Hanrahan 2001).
///
/// Taken at the pearl's centre: that the pearl itself hides part of the table from its own flanks is
/// left out, but its shadow on the table is not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Irradiance {
    coefficients: [Rgb; 9],
}

/// Rows of directions to sum over.
const ROWS: u32 = 48;

impl Irradiance {
    /// Sums up the light of `surroundings`.
    pub fn new(surroundings: &Surroundings) -> Self {
        let mut coefficients = [[0.0; 3]; 9];
        for (along, share) in directions(ROWS) {
            let seen = surroundings.seen(&Ray { from: DVec3::ZERO, along }, GRID_RAD);
            for (sum, basis) in coefficients.iter_mut().zip(harmonics(along)) {
                rgb::add(sum, rgb::scaled(seen.radiance, 4.0 * basis * share));
            }
        }
        Self { coefficients }
    }

    /// Radiance of a white matt surface with this normal.
    pub fn at(&self, normal: DVec3) -> Rgb {
        let mut light = [0.0; 3];
        for ((coefficient, basis), cosine) in
            self.coefficients.iter().zip(harmonics(normal)).zip(COSINE)
        {
            rgb::add(&mut light, rgb::scaled(*coefficient, basis * cosine));
        }
        light.map(|channel| channel.max(0.0))
    }
}

/// A cosine lobe's weight by degree: pi, 2 pi / 3, pi / 4, over pi for a matt surface's radiance, and
/// times pi for the harmonics below, which lack their factor 1 / sqrt(pi).
const COSINE: [f64; 9] = [1.0, 2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 0.25, 0.25, 0.25, 0.25, 0.25];

/// Real spherical harmonics of degree 0 to 2, times sqrt(pi).
fn harmonics(d: DVec3) -> [f64; 9] {
    let (a, b) = (3.0_f64.sqrt() / 2.0, 15.0_f64.sqrt() / 2.0);
    [
        0.5,
        a * d.x,
        a * d.y,
        a * d.z,
        b * d.x * d.y,
        b * d.y * d.z,
        b * d.z * d.x,
        0.5 * b * (d.x * d.x - d.z * d.z),
        5.0_f64.sqrt() / 4.0 * (3.0 * d.y * d.y - 1.0),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{sky::Sky, sphere::Sphere};

    fn under(sky: Sky) -> Irradiance {
        Irradiance::new(&Surroundings::new(None, None, sky, vec![], Sphere { radius_mm: 4.0 }))
    }

    #[test]
    fn an_even_sky_lights_all_sides_alike() {
        let even = under(Sky::Gradient { horizon: [0.6; 3], zenith: [0.6; 3] });
        for normal in [DVec3::X, DVec3::Y, DVec3::NEG_Z] {
            assert!((even.at(normal)[0] - 0.6).abs() < 1e-3);
        }
    }

    #[test]
    fn nine_harmonics_agree_with_the_sum_over_all_directions() {
        let sky = Sky::Gradient { horizon: [0.2; 3], zenith: [1.0; 3] };
        let nine = under(sky.clone());
        for normal in [DVec3::Y, DVec3::X, DVec3::NEG_Y, DVec3::new(0.6, 0.8, 0.0)] {
            let full: f64 = directions(96)
                .map(|(along, share)| {
                    4.0 * share * along.dot(normal).max(0.0) * sky.radiance(along, 0.0)[0]
                })
                .sum();
            assert!((nine.at(normal)[0] - full).abs() < 0.03, "{} {full}", nine.at(normal)[0]);
        }
    }
}
