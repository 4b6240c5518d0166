//! The light that table and walls receive, past the pearls.
//!
//! Form factors in closed form, shadows as the shares of discs that balls hide.
//! Left out: that hidden parts overlap, light from table to wall and back, and shadows on walls.

use glam::DVec3;

use crate::{
    rgb::{self, Rgb},
    shape::ball::Ball,
    surroundings::{
        clusters::Hidden,
        environment::Surroundings,
        lamp::Lamp,
        window::{Patch, Window},
    },
    view::ray::Ray,
};

impl Surroundings {
    /// The share of a lamp that a point sees past all pearls; `on` is the pearl that the point lies on,
    /// whose own horizon is no business of this.
    pub fn lamp_past(&self, lamp: &Lamp, point: DVec3, on: Option<usize>) -> f64 {
        if self.balls.len() == usize::from(on.is_some()) {
            return 1.0;
        }
        let (toward, disc_rad) = (lamp.toward(point), lamp.angular_radius_rad());
        let disc = lamp.disc();
        if let [ball] = &self.balls[..] {
            // The usual picture, asked for at every place of its table.
            let clear = ball.is_clear_of(point, toward, disc);
            return if clear { 1.0 } else { ball.light_past(point, toward, disc_rad) };
        }
        let ray = Ray { from: point, along: toward };
        // Twice the disc: its cone's angle, which a tangent makes a little wider.
        let others = self.balls_near(&ray, 2.2 * disc_rad, on);
        let hiding = others.filter(|ball| !ball.is_clear_of(point, toward, disc));
        hiding.map(|ball| ball.light_past(point, toward, disc_rad)).product()
    }

    /// Radiance of a white matt table at `point` without lamps: the sky beside the pearls, where they hide it
    /// their own glow, and the windows.
    pub(crate) fn soft_light_on_table(&self, point: DVec3) -> Rgb {
        let mut light = self.sky_and_glow_on_table(point);
        rgb::add(&mut light, self.windows_on(point, DVec3::Y, true));
        light
    }

    /// Light of all windows on a white matt surface, in place of the sky behind them. `shadows` says
    /// whether pearls throw theirs.
    pub(super) fn windows_on(&self, point: DVec3, normal: DVec3, shadows: bool) -> Rgb {
        let mut light = [0.0; 3];
        for window in &self.windows {
            let factor = window.form_factor(point, normal);
            if factor > 0.0 {
                let behind =
                    self.sky.radiance_within(window.toward(point), || window.cone(point).1);
                let past = if shadows { self.window_past(window, point, normal) } else { 1.0 };
                for i in 0..3 {
                    light[i] += (window.radiance[i] - behind[i]) * factor * past;
                }
            }
        }
        light
    }

    /// The share of a window's light that a point receives past all pearls, patch by patch, each a disc
    /// as large.
    fn window_past(&self, window: &Window, point: DVec3, normal: DVec3) -> f64 {
        let (toward, cone_rad) = window.cone(point);
        let cone = libm::sincos(cone_rad);
        let hides = |ball: &&Ball| !ball.is_clear_of(point, toward, cone);
        let slope = if cone.1 > 1e-3 { cone.0 / cone.1 } else { 1e3 };
        let middle = Ray { from: point, along: toward };
        let in_cone = self.balls_near(&middle, 2.0 * slope, None);
        let some: Vec<&Ball> = in_cone.filter(hides).take(FEW + 1).collect();
        if some.is_empty() {
            return 1.0;
        }
        let (mut past, mut whole) = (0.0, 0.0);
        for Patch { toward, disc_rad, light } in window.patches(point, normal) {
            let ray = Ray { from: point, along: toward };
            past += light
                * if some.len() <= FEW {
                    passing(&ray, 2.0 * disc_rad, some.iter().copied())
                } else {
                    let near = self.balls_near(&ray, 2.0 * disc_rad, None);
                    passing(&ray, 2.0 * disc_rad, near.filter(hides))
                };
            whole += light;
        }
        if whole > 0.0 { past / whole } else { 1.0 }
    }

    /// Each ball hides its share of the sky, exactly; that they hide them independently of each other is
    /// an approximation **(ours)**, and their glows share in all that is hidden.
    fn sky_and_glow_on_table(&self, point: DVec3) -> Rgb {
        let Hidden { past, shares, glow } = self.clusters.hidden(&self.balls, point);
        let mut light = rgb::scaled(self.sky_on_table, past);
        if shares > 0.0 {
            rgb::add(&mut light, rgb::scaled(glow, (1.0 - past) / shares));
        }
        light
    }

    /// Radiance of a white matt wall at `point`, which takes half of the sky's light on a table, and no
    /// shadow.
    pub(crate) fn light_on_wall(&self, point: DVec3, inward: DVec3) -> Rgb {
        let mut light = rgb::scaled(self.sky_on_table, 0.5);
        for lamp in &self.lamps {
            rgb::add(
                &mut light,
                rgb::scaled(lamp.brightness, lamp.toward(point).dot(inward).max(0.0)),
            );
        }
        rgb::add(&mut light, self.windows_on(point, inward, false));
        light
    }
}

/// The share of a cone's light that passes balls, each of which stops its own share of what the others leave.
fn passing<'a>(ray: &Ray, spread_rad: f64, balls: impl Iterator<Item = &'a Ball>) -> f64 {
    let mut past = 1.0;
    for ball in balls {
        past *= 1.0 - ball.stops(ray, spread_rad).map_or(0.0, |(_, stopped)| stopped);
        if past < DARK {
            break;
        }
    }
    past
}

/// So many balls before a window are asked about each of its patches; more are looked for patch by patch.
const FEW: usize = 6;

/// Of a patch of which less is left, no further shadow counts: a tenth of a step between 8-bit codes at most.
const DARK: f64 = 1e-4;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surroundings::{lamp::Place, sky::Sky, table::Table};

    const WHITE: Option<Table> = Some(Table::Plain([1.0; 3]));
    const EVEN: Sky = Sky::Gradient { horizon: [1.0; 3], zenith: [1.0; 3] };

    #[test]
    fn a_balls_shadow_from_a_wide_window_is_that_of_its_points() {
        let night = Sky::Gradient { horizon: [0.0; 3], zenith: [0.0; 3] };
        let half = (DVec3::new(12.0, 0.0, 0.0), DVec3::new(0.0, 0.0, 8.0));
        let window = Window::new(DVec3::new(6.0, 25.0, 3.0), half.1, half.0, [1.0; 3]);
        let balls = vec![Ball::alone(4.0)];
        let lit = Surroundings::new(WHITE, None, night, vec![], balls)
            .with_windows(vec![window])
            .settled(false);
        for x in [-12.0, -7.0, -3.0, -1.0, 0.5, 4.0, 9.0] {
            let point = DVec3::new(x, -4.0, -0.5);
            let sees = |along: DVec3| lit.balls[0].passing_mm(&Ray { from: point, along }) > 4.0;
            let exact: f64 = window
                .directions(point, 0.01)
                .filter(|(along, _)| sees(*along))
                .map(|(along, solid)| along.y * solid / std::f64::consts::PI)
                .sum();
            let got = lit.light_on_table(point)[0];
            assert!((got - exact).abs() < 0.006, "{x}: {got} {exact}");
        }
    }

    #[test]
    fn a_neighbour_throws_its_shadow() {
        let balls =
            vec![Ball::alone(4.0), Ball { centre: DVec3::new(9.0, 0.0, 0.0), ..Ball::alone(4.0) }];
        let lamp = Lamp::new(Place::Direction(DVec3::X), 0.05, [1.0; 3]);
        let surroundings = Surroundings::new(None, None, EVEN, vec![lamp.clone()], balls);
        let past = |point| surroundings.lamp_past(&lamp, point, Some(0));
        assert!(past(DVec3::new(4.0, 0.0, 0.0)) < 1e-12);
        assert!((past(DVec3::new(0.0, 4.0, 0.0)) - 0.5).abs() < 0.01);
        assert!((past(DVec3::new(0.0, 0.0, 4.0)) - 0.5).abs() < 0.01);
    }
}
