use std::f64::consts::PI;

use glam::DVec3;

use crate::{
    harmonics::second_order::SecondOrder,
    rgb::Rgb,
    surroundings::{environment::Surroundings, sky::GRID_RAD},
    view::direction::directions,
};

/// The light of the surroundings, lamps apart, that falls on a matt surface by its normal: nine
/// spherical harmonics, exact to 3 % for any surroundings (Ramamoorthi and Hanrahan 2001).
///
/// Taken at the pearl's centre: that the pearl itself hides part of the table from its own flanks is
/// left out, but its shadow on the table is not. Other pearls hide what is behind them, and glow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Irradiance(SecondOrder);

/// Rows of directions to sum over.
const ROWS: u32 = 48;

impl Irradiance {
    /// Sums up the light of `surroundings` around the ball of number `ball`.
    pub fn new(surroundings: &Surroundings, ball: usize) -> Self {
        let bare = directions(ROWS).map(|(along, share)| {
            (along, share, surroundings.seen_without_windows(ball, along, GRID_RAD))
        });
        let windows = surroundings.window_points(ball);
        let windows = windows.map(|(along, solid, more)| (along, solid / (4.0 * PI), more));
        Self(SecondOrder::nearest_to(bare.chain(windows)))
    }

    /// Radiance of a white matt surface with this normal.
    pub fn at(&self, normal: DVec3) -> Rgb {
        self.0.at(normal, &COSINE).map(|channel| channel.max(0.0))
    }
}

/// A cosine lobe's weight by degree: pi, 2 pi / 3, pi / 4, over pi for a matt surface's radiance, and
/// times pi for the harmonics, which lack their factor 1 / sqrt(pi).
const COSINE: [f64; 9] = [1.0, 2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 0.25, 0.25, 0.25, 0.25, 0.25];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        light::glow::Glow,
        shape::ball::Ball,
        surroundings::{sky::Sky, table::Table, window::Window},
    };

    fn under(sky: Sky) -> Irradiance {
        Irradiance::new(&Surroundings::new(None, None, sky, vec![], vec![Ball::alone(4.0)]), 0)
    }

    #[test]
    fn an_even_sky_lights_all_sides_alike() {
        let even = under(Sky::Gradient { horizon: [0.6; 3], zenith: [0.6; 3] });
        for normal in [DVec3::X, DVec3::Y, DVec3::NEG_Z] {
            assert!((even.at(normal)[0] - 0.6).abs() < 1e-3);
        }
    }

    #[test]
    fn a_window_as_bright_as_the_sky_behind_it_changes_nothing() {
        let right = DVec3::new(9.0, 0.0, 0.0);
        let window = |at, up| Window::new(at, right, up, [1.0; 3]);
        let windows = vec![
            window(DVec3::new(2.0, 14.0, 1.0), DVec3::new(0.0, 0.0, 6.0)),
            window(DVec3::new(0.0, 3.0, -30.0), DVec3::new(0.0, 7.0, 0.0)),
        ];
        let balls = vec![Ball { glow: Glow::from_fn(|_| [1.0; 3]), ..Ball::alone(4.0) }];
        let white = Some(Table::Plain([1.0; 3]));
        let even_sky = Sky::Gradient { horizon: [1.0; 3], zenith: [1.0; 3] };
        let bare = Surroundings::new(white, None, even_sky, vec![], balls);
        let surroundings = bare.with_windows(windows);
        for x in [0.0, 5.0, 30.0] {
            let light = surroundings.light_on_table(DVec3::new(x, -4.0, 0.1));
            assert!((light[0] - 1.0).abs() < 1e-3, "{x}: {light:?}");
        }
        let even = Irradiance::new(&surroundings, 0);
        for normal in [DVec3::Y, DVec3::NEG_Z, DVec3::X] {
            assert!((even.at(normal)[0] - 1.0).abs() < 2e-3, "{normal}: {:?}", even.at(normal));
        }
    }

    #[test]
    fn a_small_window_lights_like_its_form_factor() {
        let night = Sky::Gradient { horizon: [0.0; 3], zenith: [0.0; 3] };
        let (right, up) = (DVec3::new(2.0, 0.0, 0.0), DVec3::new(0.0, 0.0, 3.0));
        let window = Window::new(DVec3::new(0.0, 60.0, 0.0), right, up, [5.0; 3]);
        let bare = Surroundings::new(None, None, night, vec![], vec![Ball::alone(4.0)]);
        let light = Irradiance::new(&bare.with_windows(vec![window]), 0);
        let facing = 5.0 * window.facing_factor(DVec3::ZERO);
        let towards = light.at(DVec3::Y)[0];
        // Nine harmonics of a cosine lobe: 1/4 + 1/2 + 5/16 = 17/16 of its peak.
        assert!((towards / facing - 17.0 / 16.0).abs() < 1e-3, "{towards} {facing}");
    }

    #[test]
    fn second_order_harmonics_agree_with_the_sum_over_all_directions() {
        let sky = Sky::Gradient { horizon: [0.2; 3], zenith: [1.0; 3] };
        let second_order = under(sky.clone());
        for normal in [DVec3::Y, DVec3::X, DVec3::NEG_Y, DVec3::new(0.6, 0.8, 0.0)] {
            let full: f64 = directions(96)
                .map(|(along, share)| {
                    4.0 * share * along.dot(normal).max(0.0) * sky.radiance(along, 0.0)[0]
                })
                .sum();
            assert!(
                (second_order.at(normal)[0] - full).abs() < 0.03,
                "{} {full}",
                second_order.at(normal)[0]
            );
        }
    }
}
