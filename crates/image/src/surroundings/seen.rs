use glam::DVec3;

use crate::{
    rgb::{self, Rgb},
    surroundings::{environment::Surroundings, table::Table, window::Window},
    view::ray::Ray,
};

/// What a ray meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seen {
    /// Linear RGB.
    pub radiance: Rgb,
    /// How far off it is; infinite for the sky, and for windows, whose light does not fade.
    pub distance_mm: f64,
}

/// Something before table, walls and sky that a cone of light meets with a share of its width.
#[derive(Debug, Clone, Copy)]
struct Layer {
    distance_mm: f64,
    share: f64,
    radiance: Rgb,
    fades: bool,
}

fn panes<'a>(
    windows: &'a [Window],
    ray: &'a Ray,
    spread_rad: f64,
) -> impl Iterator<Item = Layer> + 'a {
    windows.iter().filter_map(move |window| {
        let (distance_mm, share) = window.seen(ray, spread_rad)?;
        Some(Layer { distance_mm, share, radiance: window.radiance, fades: false })
    })
}

impl Surroundings {
    /// What `ray` meets, the pearl `from` left out that it comes from. `spread_rad` is the angle that
    /// the ray stands for: finer patterns are averaged away, not aliased, and balls and windows have
    /// soft edges.
    pub fn seen(&self, ray: &Ray, spread_rad: f64, from: Option<usize>) -> Seen {
        self.seen_with(&self.windows, ray, spread_rad, from)
    }

    /// What the middle of a ball would see, were there no windows.
    pub(crate) fn seen_without_windows(&self, ball: usize, along: DVec3, spread_rad: f64) -> Rgb {
        let ray = Ray { from: self.balls[ball].centre, along };
        self.seen_with(&[], &ray, spread_rad, Some(ball)).radiance
    }

    /// What windows add to that, at points all over them: (direction, solid angle, radiance). For sums over
    /// all directions, whose grid may be coarse against a window.
    pub(crate) fn window_points(&self, ball: usize) -> impl Iterator<Item = (DVec3, f64, Rgb)> {
        let from = self.balls[ball].centre;
        self.windows.iter().flat_map(move |window| {
            window.directions(from, WINDOW_RAD).map(move |(along, solid)| {
                let (ray, this) = (Ray { from, along }, std::slice::from_ref(window));
                let with = self.seen_with(this, &ray, FINE_RAD, Some(ball)).radiance;
                let without = self.seen_without_windows(ball, along, WINDOW_RAD);
                (along, solid, std::array::from_fn(|i| with[i] - without[i]))
            })
        })
    }

    /// The same as if these were the windows.
    pub(crate) fn seen_with(
        &self,
        windows: &[Window],
        ray: &Ray,
        spread_rad: f64,
        from: Option<usize>,
    ) -> Seen {
        let balls = self.balls_near(ray, spread_rad, from).filter_map(|ball| {
            let (distance_mm, share) = ball.stops(ray, spread_rad)?;
            let radiance = ball.glow.at((ray.from - ball.centre).normalize());
            Some(Layer { distance_mm, share, radiance, fades: true })
        });
        self.layered(balls.chain(panes(windows, ray, spread_rad)).collect(), ray, spread_rad)
    }

    /// What `ray` meets of windows, table, walls and sky.
    pub fn scenery(&self, ray: &Ray, spread_rad: f64) -> Seen {
        self.layered(panes(&self.windows, ray, spread_rad).collect(), ray, spread_rad)
    }

    /// From front to back, each layer lets the rest of the light through.
    fn layered(&self, mut layers: Vec<Layer>, ray: &Ray, spread_rad: f64) -> Seen {
        if layers.is_empty() {
            return self.ground(ray, spread_rad);
        }
        layers.sort_by(|a, b| a.distance_mm.total_cmp(&b.distance_mm));
        let ground = self.ground(ray, spread_rad);
        let (mut radiance, mut nearness, mut left) = ([0.0; 3], 0.0, 1.0);
        for layer in layers.iter().filter(|layer| layer.distance_mm < ground.distance_mm) {
            rgb::add(&mut radiance, rgb::scaled(layer.radiance, left * layer.share));
            if layer.fades {
                nearness += left * layer.share / layer.distance_mm.max(1e-9);
            }
            left *= 1.0 - layer.share;
        }
        rgb::add(&mut radiance, rgb::scaled(ground.radiance, left));
        nearness += left / ground.distance_mm;
        Seen { radiance, distance_mm: 1.0 / nearness }
    }

    /// What `ray` meets of table, walls and sky.
    fn ground(&self, ray: &Ray, spread_rad: f64) -> Seen {
        let table = self
            .table
            .as_ref()
            .and_then(|table| Some((table, distance_down(ray, self.table_y_mm)?)));
        let wall = self.walls.and_then(|walls| {
            let (distance_mm, inward) = walls.ahead(ray, self.table_y_mm)?;
            Some((walls.colour, distance_mm, inward))
        });
        match (table, wall) {
            (Some((table, distance_mm)), wall)
                if wall.is_none_or(|(_, wall_mm, _)| distance_mm < wall_mm) =>
            {
                let radiance = self.table_radiance(table, ray, distance_mm, spread_rad);
                Seen { radiance, distance_mm }
            }
            (_, Some((colour, distance_mm, inward))) => {
                let point = ray.from + ray.along * distance_mm;
                let mapped = self.wall_light.as_ref().and_then(|light| light.at(point, inward));
                let light = mapped.unwrap_or_else(|| self.light_on_wall(point, inward));
                Seen { radiance: rgb::times(colour, light), distance_mm }
            }
            _ => Seen {
                radiance: self.sky.radiance(ray.along, spread_rad),
                distance_mm: f64::INFINITY,
            },
        }
    }

    /// Radiance far away in a direction, which distant things fade into.
    pub fn backdrop(&self, along: DVec3, spread_rad: f64) -> Rgb {
        self.sky.radiance(DVec3::new(along.x, along.y.max(0.0), along.z), spread_rad)
    }

    fn table_radiance(&self, table: &Table, ray: &Ray, distance_mm: f64, spread_rad: f64) -> Rgb {
        let point = ray.from + ray.along * distance_mm;
        let footprint_mm = distance_mm.min(FOOTPRINT_LIMIT_MM) * spread_rad;
        let albedo = table.albedo(point.x, point.z, footprint_mm, -ray.along.y);
        rgb::times(albedo, self.light_on_table(point))
    }
}

/// Between points of a window, and how finely each is looked at.
const WINDOW_RAD: f64 = 0.05;
const FINE_RAD: f64 = 1e-6;

/// Beyond this a flat table is one colour; it keeps a ray along the horizon finite.
const FOOTPRINT_LIMIT_MM: f64 = 1e6;

/// Distance along `ray` to the plane y = `height_mm`, if it goes down to it.
fn distance_down(ray: &Ray, height_mm: f64) -> Option<f64> {
    let distance_mm = (height_mm - ray.from.y) / ray.along.y;
    (ray.along.y < 0.0 && distance_mm > 0.0 && distance_mm < FOOTPRINT_LIMIT_MM)
        .then_some(distance_mm)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{light::glow::Glow, shape::ball::Ball, surroundings::sky::Sky};

    const WHITE: Option<Table> = Some(Table::Plain([1.0; 3]));
    const EVEN: Sky = Sky::Gradient { horizon: [1.0; 3], zenith: [1.0; 3] };

    fn glowing(centre: DVec3, radius_mm: f64) -> Ball {
        Ball { centre, radius_mm, glow: Glow::from_fn(|_| [1.0; 3]) }
    }

    #[test]
    fn balls_that_glow_like_the_sky_leave_a_white_table_even() {
        for balls in [
            vec![glowing(DVec3::ZERO, 4.0)],
            vec![glowing(DVec3::ZERO, 4.0), glowing(DVec3::new(8.0, -1.0, 0.0), 3.0)],
        ] {
            let surroundings = Surroundings::new(WHITE, None, EVEN, vec![], balls);
            for x in [0.0, 0.5, 3.0, 4.0, 9.0, 40.0] {
                let light = surroundings.light_on_table(DVec3::new(x, -4.0, 1e-3));
                assert!((light[0] - 1.0).abs() < 1e-3, "{x}: {light:?}");
                let down = DVec3::new(0.3, -1.0, 0.2).normalize();
                let ray = Ray { from: DVec3::new(x, 9.0, 0.0), along: down };
                let seen = surroundings.seen(&ray, 0.2, None).radiance[0];
                assert!((seen - 1.0).abs() < 1e-3, "{x}: {seen}");
            }
        }
    }

    #[test]
    fn a_ball_does_not_meet_itself_but_its_neighbour() {
        let balls = vec![Ball::alone(4.0), glowing(DVec3::new(20.0, 0.0, 0.0), 4.0)];
        let night = Sky::Gradient { horizon: [0.0; 3], zenith: [0.0; 3] };
        let surroundings = Surroundings::new(None, None, night, vec![], balls);
        let ray = Ray { from: DVec3::ZERO, along: DVec3::X };
        let seen = surroundings.seen(&ray, 0.01, Some(0));
        assert!((seen.radiance[0] - 1.0).abs() < 1e-9 && (seen.distance_mm - 16.0).abs() < 1e-9);
        assert!(surroundings.seen(&ray, 0.01, Some(1)).radiance[0] < 1e-9);
    }
}
