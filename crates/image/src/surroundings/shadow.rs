//! How much darker pearls make the table, for laying a picture's pearls on another ground.
//!
//! The light that falls on the table over that which would fall there without pearls, as luminance: what they take from
//! sky, lamps and windows, less what they send there.
//! Left out: windows between eye and table, and shadows on walls, which pearls throw none on.

use glam::DVec3;

use crate::{
    rgb::{self, Rgb},
    surroundings::{environment::Surroundings, lit::Lit},
    view::ray::Ray,
};

impl Lit {
    /// Share of its light that the table lacks where a ray meets it, the pearls before it looked through, from 0 to 1;
    /// 0 where the ray meets no table.
    pub(crate) fn shadow(&self, ray: &Ray) -> f64 {
        let Some((_, distance_mm)) = self.table_ahead(ray) else { return 0.0 };
        let wall = self.walls.and_then(|walls| walls.ahead(ray, self.table_y_mm));
        if wall.is_some_and(|(wall_mm, _)| wall_mm <= distance_mm) {
            return 0.0;
        }
        let point = ray.from + ray.along * distance_mm;
        let bare = rgb::luminance(self.bare_light_on_table(point));
        if bare <= 0.0 {
            return 0.0;
        }
        (1.0 - rgb::luminance(self.light_on_table(point)) / bare).clamp(0.0, 1.0)
    }
}

impl Surroundings {
    /// Radiance of a white matt table at `point` without any pearl.
    fn bare_light_on_table(&self, point: DVec3) -> Rgb {
        let mut light = self.sky_on_table;
        rgb::add(&mut light, self.windows_on(point, DVec3::Y, false));
        for lamp in &self.lamps {
            rgb::add(&mut light, rgb::scaled(lamp.brightness, lamp.toward(point).y.max(0.0)));
        }
        light
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        shape::ball::Ball,
        surroundings::{
            lamp::{Lamp, Place},
            sky::Sky,
            table::Table,
        },
    };

    const NIGHT: Sky = Sky::Gradient { horizon: [0.0; 3], zenith: [0.0; 3] };
    const DAY: Sky = Sky::Gradient { horizon: [1.0; 3], zenith: [1.0; 3] };

    fn shadow(sky: Sky, lamps: Vec<Lamp>, x: f64) -> f64 {
        let table = Some(Table::Plain([0.3; 3]));
        let lit = Surroundings::new(table, None, sky, lamps, vec![Ball::alone(4.0)]).settled(false);
        lit.shadow(&Ray { from: DVec3::new(x, 9.0, 0.0), along: DVec3::NEG_Y })
    }

    #[test]
    fn a_dark_ball_under_an_even_sky_hides_its_form_factor() {
        // Cosine of the way to its centre, times the squared sine of its disc's radius: each is radius over distance.
        for x in [0.5, 4.0, 9.0, 40.0] {
            let factor = 64.0 / (x * x + 16.0_f64).powf(1.5);
            assert!((shadow(DAY, vec![], x) - factor).abs() < 1e-9, "{x}");
        }
    }

    #[test]
    fn a_lamp_overhead_is_hidden_below_the_ball_and_nowhere_else() {
        let lamp = || vec![Lamp::new(Place::Direction(DVec3::Y), 0.01, [1.0; 3])];
        assert!((shadow(NIGHT, lamp(), 1.0) - 1.0).abs() < 1e-9);
        assert!(shadow(NIGHT, lamp(), 6.0) < 1e-9);
        assert!(shadow(NIGHT, vec![], 1.0) < 1e-9); // of no light nothing is taken
    }
}
