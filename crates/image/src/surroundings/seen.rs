//! What a ray meets of the surroundings.
//!
//! From front to back, each thing covers its share of the ray's cone.
//! Left out: where within the cone a thing lies, so that two that cover half each never hide each other.

use glam::DVec3;

use crate::{
    rgb::Rgb,
    surroundings::{lit::Lit, viewpoint::Viewpoint, weave::LANES},
    view::{cone::Cone, ray::Ray},
};

impl Lit {
    /// What `ray` meets, the pearl `from` left out that it comes from. `cone` is what
    /// the ray stands for: finer patterns are averaged away, not aliased, and balls and windows have
    /// soft edges.
    pub fn seen(&self, ray: &Ray, cone: &Cone, from: Option<usize>) -> Rgb {
        Viewpoint::new(self, &self.windows, ray.from, from).seen(ray.along, cone)
    }

    /// The same, where each thing but sky and windows fades into the backdrop with its own distance, to 1/e of the contrast
    /// over `falloff_mm`.
    pub(crate) fn faded(
        &self,
        ray: &Ray,
        cone: &Cone,
        from: Option<usize>,
        falloff_mm: f64,
    ) -> Rgb {
        Viewpoint::new(self, &self.windows, ray.from, from).faded(ray.along, cone, falloff_mm)
    }

    /// What the middle of a ball would see, were there no windows.
    pub(crate) fn seen_without_windows(&self, ball: usize, along: DVec3, spread_rad: f64) -> Rgb {
        let centre = self.balls[ball].centre;
        let cone = Cone::round(spread_rad);
        Viewpoint::new(self, &[], centre, Some(ball)).seen(along, &cone)
    }

    /// What windows add to that, at points all over them: (direction, solid angle, radiance). For sums over
    /// all directions, whose grid may be coarse against a window.
    pub(crate) fn window_points(&self, ball: usize) -> impl Iterator<Item = (DVec3, f64, Rgb)> {
        let from = self.balls[ball].centre;
        self.windows.iter().flat_map(move |window| {
            let this = Viewpoint::new(self, std::slice::from_ref(window), from, Some(ball));
            window.directions(from, WINDOW_RAD).map(move |(along, solid)| {
                let with = this.seen(along, &Cone::round(FINE_RAD));
                let without = self.seen_without_windows(ball, along, WINDOW_RAD);
                (along, solid, std::array::from_fn(|i| with[i] - without[i]))
            })
        })
    }

    /// What `ray` meets of windows, table, walls and sky.
    pub fn scenery(&self, ray: &Ray, spread_rad: f64) -> Rgb {
        let windows = self.windows.iter().filter(|window| !window.is_clear_of(ray, spread_rad));
        Viewpoint::new(self, windows, ray.from, None).scenery(ray.along, &Cone::round(spread_rad))
    }

    /// Hands out with its number what each ray meets, which is given with its own: what [`Self::scenery`] says of it, to the bit.
    pub(crate) fn each_scenery(
        &self,
        rays: impl Iterator<Item = (usize, Ray, f64)>,
        mut hand: impl FnMut(usize, Rgb),
    ) {
        let mut rays = rays.fuse();
        while let Some(first) = rays.next() {
            // Where fewer are left, the first stands in for those that are missing.
            let mut several = [first; LANES];
            let mut count = 1;
            for next in rays.by_ref().take(LANES - 1) {
                several[count] = next;
                count += 1;
            }
            let seen = self.sceneries(&several.map(|one| one.1), several.map(|one| one.2));
            for ((number, ..), light) in several.into_iter().zip(seen).take(count) {
                hand(number, light);
            }
        }
    }

    /// What several rays meet.
    fn sceneries(&self, rays: &[Ray; LANES], spreads_rad: [f64; LANES]) -> [Rgb; LANES] {
        let each = || rays.iter().zip(spreads_rad);
        let is_bare = self
            .windows
            .iter()
            .all(|window| each().all(|(ray, spread_rad)| window.is_clear_of(ray, spread_rad)));
        let table = if is_bare { self.bare_table(rays, spreads_rad) } else { None };
        table.unwrap_or_else(|| std::array::from_fn(|i| self.scenery(&rays[i], spreads_rad[i])))
    }
}

/// Between points of a window, and how finely each is looked at; by eye **(ours)**.
const WINDOW_RAD: f64 = 0.05;
const FINE_RAD: f64 = 1e-6;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        light::glow::Glow,
        shape::ball::Ball,
        surroundings::{environment::Surroundings, sky::Sky, table::Table},
    };

    const WHITE: Option<Table> = Some(Table::Plain([1.0; 3]));
    const EVEN: Sky = Sky::Gradient { horizon: [1.0; 3], zenith: [1.0; 3] };

    fn glowing(centre: DVec3, radius_mm: f64) -> Ball {
        Ball { centre, glow: Glow::from_fn(|_| [1.0; 3]), ..Ball::alone(radius_mm) }
    }

    #[test]
    fn balls_that_glow_like_the_sky_leave_a_white_table_even() {
        for balls in [
            vec![glowing(DVec3::ZERO, 4.0)],
            vec![glowing(DVec3::ZERO, 4.0), glowing(DVec3::new(8.0, -1.0, 0.0), 3.0)],
        ] {
            let surroundings = Surroundings::new(WHITE, None, EVEN, vec![], balls).settled(false);
            for x in [0.0, 0.5, 3.0, 4.0, 9.0, 40.0] {
                let light = surroundings.light_on_table(DVec3::new(x, -4.0, 1e-3));
                assert!((light[0] - 1.0).abs() < 1e-3, "{x}: {light:?}");
                let down = DVec3::new(0.3, -1.0, 0.2).normalize();
                let ray = Ray { from: DVec3::new(x, 9.0, 0.0), along: down };
                let seen = surroundings.seen(&ray, &Cone::round(0.2), None)[0];
                assert!((seen - 1.0).abs() < 1e-3, "{x}: {seen}");
            }
        }
    }

    #[test]
    fn a_ball_does_not_meet_itself_but_its_neighbour() {
        let balls = vec![Ball::alone(4.0), glowing(DVec3::new(20.0, 0.0, 0.0), 4.0)];
        let night = Sky::Gradient { horizon: [0.0; 3], zenith: [0.0; 3] };
        let surroundings = Surroundings::new(None, None, night, vec![], balls).settled(false);
        let ray = Ray { from: DVec3::ZERO, along: DVec3::X };
        let seen = surroundings.seen(&ray, &Cone::round(0.01), Some(0));
        assert!((seen[0] - 1.0).abs() < 1e-9);
        assert!(surroundings.seen(&ray, &Cone::round(0.01), Some(1))[0] < 1e-9);
    }

    #[test]
    fn rays_side_by_side_meet_what_each_meets_alone() {
        let cloth =
            Table::Cloth { colour: [0.9; 3], second_colour: [0.5, 0.6, 0.7], weave_mm: 0.4 };
        let ball = glowing(DVec3::ZERO, 4.0);
        for table in [Some(cloth), WHITE, None] {
            let lit = Surroundings::new(table, None, EVEN, vec![], vec![ball]).settled(true);
            // Some of the last look above the table.
            for i in 0..60 {
                let along = |k: usize| DVec3::new(0.1 * k as f64, 0.02 * f64::from(i) - 1.0, -0.5);
                let rays = std::array::from_fn(|k| Ray {
                    from: DVec3::new(0.0, 9.0, 40.0),
                    along: along(k).normalize(),
                });
                let spreads_rad = [1e-4, 1e-3, 2e-3, 1e-2];
                let alone = std::array::from_fn(|k| lit.scenery(&rays[k], spreads_rad[k]));
                assert_eq!(lit.sceneries(&rays, spreads_rad), alone, "{table:?} {i}");
            }
        }
    }
}
