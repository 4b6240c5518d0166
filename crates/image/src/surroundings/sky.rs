//! What is behind everything, as radiance by direction.
//!
//! A gradient with the root of the height **(ours)**, or a panorama.
//! Left out: sun, clouds and the colours of a real sky, which a panorama brings.

use std::{f64::consts::PI, sync::Arc};

use glam::DVec3;

use crate::{
    rgb::{self, Rgb},
    surroundings::panorama::Panorama,
    view::{cone::Cone, direction::directions},
};

/// What is behind everything, as radiance by direction.
#[derive(Debug, Clone)]
pub enum Sky {
    /// From the horizon's colour to the zenith's; below the horizon the horizon's goes on.
    Gradient {
        /// Linear RGB at and below the horizon.
        horizon: Rgb,
        /// Linear RGB overhead.
        zenith: Rgb,
    },
    /// A photographed or painted panorama.
    Panorama {
        /// The picture.
        picture: Arc<Panorama>,
        /// Turned about the upright axis.
        rotation_rad: f64,
        /// Factor on the picture's values.
        intensity: f64,
    },
}

/// Rows of the grid over which the sky's light is summed up; the columns are twice as many.
const ROWS: u32 = 48;

impl Sky {
    /// Radiance from the direction `along`, averaged over about `cone`.
    pub(crate) fn radiance_over(&self, along: DVec3, cone: &Cone) -> Rgb {
        match self {
            Self::Gradient { .. } => self.radiance(along, cone.mean_rad()),
            Self::Panorama { .. } => {
                let mut sum = [0.0; 3];
                let (parts, share) = cone.round_parts(along);
                for (along, spread_rad) in parts {
                    rgb::add(&mut sum, rgb::scaled(self.radiance(along, spread_rad), share));
                }
                sum
            }
        }
    }

    /// Radiance from the direction `along`, averaged over about `spread_rad`.
    pub fn radiance(&self, along: DVec3, spread_rad: f64) -> Rgb {
        self.radiance_within(along, || spread_rad)
    }

    /// The same, where the angle is worked out if it counts.
    pub(crate) fn radiance_within(&self, along: DVec3, spread_rad: impl FnOnce() -> f64) -> Rgb {
        match self {
            Self::Gradient { horizon, zenith } => {
                rgb::mix(*horizon, *zenith, along.y.max(0.0).sqrt())
            }
            Self::Panorama { picture, rotation_rad, intensity } => {
                rgb::scaled(picture.radiance(along, *rotation_rad, spread_rad()), *intensity)
            }
        }
    }

    /// Radiance of a white matt table under the whole sky: the cosine-weighted mean of the upper half.
    pub fn on_table(&self) -> Rgb {
        self.mean(|along| along.y.max(0.0) * 4.0)
    }

    /// Luminance on average over all directions.
    pub fn mean_luminance(&self) -> f64 {
        rgb::luminance(self.mean(|_| 1.0)).max(0.0)
    }

    fn mean(&self, weight: impl Fn(DVec3) -> f64) -> Rgb {
        let mut sum = [0.0; 3];
        for (along, share) in directions(ROWS) {
            rgb::add(&mut sum, rgb::scaled(self.radiance(along, GRID_RAD), weight(along) * share));
        }
        sum
    }
}

/// Distance between neighbours of that grid.
pub(crate) const GRID_RAD: f64 = PI / ROWS as f64;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_even_sky_makes_a_white_table_as_bright_as_itself() {
        let sky = Sky::Gradient { horizon: [0.7; 3], zenith: [0.7; 3] };
        assert!((sky.on_table()[0] - 0.7).abs() < 1e-3);
        assert!((sky.mean_luminance() - 0.7).abs() < 1e-12);
    }
}
