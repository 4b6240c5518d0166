use crate::{shape::ball::Ball, view::ray::Ray};

/// Who lies near whom among the balls on a table, so that light on its way up or down need not be asked about
/// those that it cannot reach.
#[derive(Debug, Clone)]
pub(crate) struct Neighbours {
    /// All balls lie between these heights.
    low_mm: f64,
    high_mm: f64,
    /// For each ball, all others with the gap to them, the nearest first.
    others: Vec<Vec<(f64, usize)>>,
}

impl Neighbours {
    pub(crate) fn new(balls: &[Ball]) -> Self {
        let gap_mm = |a: &Ball, b: &Ball| a.centre.distance(b.centre) - a.radius_mm - b.radius_mm;
        let others = |(this, ball)| {
            let all = balls.iter().enumerate().filter(|(i, _)| *i != this);
            let mut found: Vec<_> = all.map(|(i, other)| (gap_mm(ball, other), i)).collect();
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            found
        };
        let low = balls.iter().map(|ball| ball.centre.y - ball.radius_mm);
        let high = balls.iter().map(|ball| ball.centre.y + ball.radius_mm);
        Self {
            low_mm: low.fold(f64::INFINITY, f64::min),
            high_mm: high.fold(f64::NEG_INFINITY, f64::max),
            others: balls.iter().enumerate().map(others).collect(),
        }
    }

    /// The balls that a cone of full angle `spread_rad` around `ray` may meet, which comes from within the
    /// ball of number `from` or from its surface.
    pub(crate) fn near(
        &self,
        from: usize,
        ray: &Ray,
        spread_rad: f64,
    ) -> impl Iterator<Item = usize> {
        let others = &self.others[from];
        let reach_mm = self.reach_mm(ray, spread_rad);
        let count = others.partition_point(|(gap_mm, _)| *gap_mm <= reach_mm);
        others[..count].iter().map(|(_, ball)| *ball)
    }

    /// How far a cone goes before all of it has left the heights of the balls. Its flattest ray rises at
    /// least by the sine of the middle one less half the angle.
    fn reach_mm(&self, ray: &Ray, spread_rad: f64) -> f64 {
        let rise = ray.along.y.abs() - 0.5 * spread_rad;
        let left_mm =
            if ray.along.y > 0.0 { self.high_mm - ray.from.y } else { ray.from.y - self.low_mm };
        if rise > 0.0 { left_mm.max(0.0) / rise } else { f64::INFINITY }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::view::direction::directions;

    #[test]
    fn nobody_whom_a_cone_meets_is_left_out() {
        let place = |i: usize| DVec3::new((i % 5) as f64 * 9.0, 0.0, (i / 5) as f64 * 10.0);
        let size = |i: usize| 4.0 - 0.5 * (i % 3) as f64;
        let balls: Vec<Ball> = (0..20)
            .map(|i| {
                let low = DVec3::new(0.0, size(i) - 4.0, 0.0);
                Ball { centre: place(i) + low, ..Ball::alone(size(i)) }
            })
            .collect();
        let neighbours = Neighbours::new(&balls);
        let mut spared = 0;
        for (from, (along, _)) in (0..20).cycle().zip(directions(24)) {
            for spread_rad in [1e-3, 0.1, 0.6] {
                let ray = Ray { from: balls[from].centre + along * balls[from].radius_mm, along };
                let near: Vec<usize> = neighbours.near(from, &ray, spread_rad).collect();
                spared += 19 - near.len();
                for (i, ball) in balls.iter().enumerate().filter(|(i, _)| *i != from) {
                    assert!(near.contains(&i) || ball.stops(&ray, spread_rad).is_none(), "{i}");
                }
            }
        }
        assert!(spared > 20_000, "{spared}");
    }
}
