//! Which balls a cone of light may meet.
//!
//! A uniform grid over the plane that the balls lie on, swept along the cone until it has left their heights.
//! Left out: heights within the grid; all balls lie on one table.

use std::ops::Range;

use glam::DVec3;

use crate::{shape::ball::Ball, view::ray::Ray};

/// An index in space of balls on a table, so that light on its way up or down need not be asked about those
/// that it cannot reach.
#[derive(Debug, Clone)]
pub(crate) struct Neighbours {
    /// All balls lie between these heights, and none has a greater radius.
    low_mm: f64,
    high_mm: f64,
    greatest_mm: f64,
    /// Where the cells begin by x and z, how wide they are, and how many there are.
    corner_mm: [f64; 2],
    cell_mm: f64,
    counts: [usize; 2],
    /// The balls by cell, once for sweeps along x and once along z.
    along: [Cells; 2],
}

/// Balls by their cells, slice after slice across one axis.
#[derive(Debug, Clone)]
struct Cells {
    /// Where each cell's balls begin among `balls`, and where the last ones end.
    starts: Vec<u32>,
    balls: Vec<u32>,
}

/// A slice of the grid across a sweep: balls that a cone may meet, none nearer than a distance.
pub(crate) struct Slice<'a> {
    /// From where the cone starts to the nearest point of any of the balls, at least.
    pub(crate) least_mm: f64,
    pub(crate) balls: &'a [u32],
}

impl Neighbours {
    pub(crate) fn new(balls: &[Ball]) -> Self {
        let places = balls.iter().map(|ball| [ball.centre.x, ball.centre.z]);
        let places: Vec<[f64; 2]> = places.collect();
        let least = |of: &dyn Fn(usize) -> f64| {
            (0..balls.len()).map(of).reduce(f64::min).unwrap_or_default()
        };
        let greatest_mm = -least(&|i| -balls[i].reach_mm());
        let corner_mm = [0, 1].map(|axis| least(&|i| places[i][axis]));
        let widths_mm = [0, 1].map(|axis| -least(&|i| -places[i][axis]) - corner_mm[axis]);
        // About one ball to a cell.
        let area_mm2 =
            widths_mm.map(|width_mm| width_mm + greatest_mm).into_iter().product::<f64>();
        let cell_mm = (area_mm2 / balls.len().max(1) as f64).sqrt().max(greatest_mm).max(1e-9);
        let counts = widths_mm.map(|width_mm| (width_mm / cell_mm) as usize + 1);
        let cell = |place: &[f64; 2]| {
            [0, 1].map(|axis| {
                (((place[axis] - corner_mm[axis]) / cell_mm) as usize).min(counts[axis] - 1)
            })
        };
        let cells: Vec<[usize; 2]> = places.iter().map(cell).collect();
        Self {
            low_mm: least(&|i| balls[i].centre.y - balls[i].reach_mm()),
            high_mm: -least(&|i| -balls[i].centre.y - balls[i].reach_mm()),
            greatest_mm,
            corner_mm,
            cell_mm,
            counts,
            along: [0, 1].map(|axis| Cells::new(&cells, axis, counts)),
        }
    }

    /// The balls that a cone of full angle `spread_rad` around `ray` may meet, the one left out that it comes
    /// from; roughly from front to back.
    pub(crate) fn near(
        &self,
        ray: &Ray,
        spread_rad: f64,
        from: Option<usize>,
    ) -> impl Iterator<Item = usize> {
        let slices = self.slices(ray, 0.5 * spread_rad, from.is_some());
        let balls = slices.flat_map(|slice| slice.balls).map(|&ball| ball as usize);
        balls.filter(move |&ball| Some(ball) != from)
    }

    /// The same in slices, for a cone whose radius grows by `slope` for each mm; `on_ball` says that it comes
    /// from a ball, which is then among those found.
    pub(crate) fn slices(
        &self,
        ray: &Ray,
        slope: f64,
        on_ball: bool,
    ) -> impl Iterator<Item = Slice<'_>> {
        let sweep = (self.along[0].balls.len() > usize::from(on_ball))
            .then(|| Sweep::new(self, ray, slope, self.reach_mm(ray, slope)));
        let lines = sweep.map(|sweep| (sweep, sweep.lines(self)));
        lines.into_iter().flat_map(move |(sweep, lines)| {
            let count = lines.len();
            (0..count).filter_map(move |i| {
                let line = if sweep.step > 0.0 { lines.start + i } else { lines.end - 1 - i };
                sweep.slice(self, line)
            })
        })
    }

    /// How far a cone goes before all of it has left the heights of the balls. Its flattest ray rises at
    /// least by the sine of the middle one less half the angle.
    fn reach_mm(&self, ray: &Ray, slope: f64) -> f64 {
        let rise = ray.along.y.abs() - slope;
        let left_mm =
            if ray.along.y > 0.0 { self.high_mm - ray.from.y } else { ray.from.y - self.low_mm };
        if rise > 0.0 { left_mm.max(0.0) / rise } else { f64::INFINITY }
    }
}

impl Cells {
    /// Of balls in `cells`, in slices across `axis`.
    fn new(cells: &[[usize; 2]], axis: usize, counts: [usize; 2]) -> Self {
        let number = |ball: &u32| {
            let cell = cells[*ball as usize];
            cell[axis] * counts[1 - axis] + cell[1 - axis]
        };
        let mut balls: Vec<u32> = (0..cells.len() as u32).collect();
        balls.sort_by_key(number);
        let start = |cell: usize| balls.partition_point(|ball| number(ball) < cell) as u32;
        let starts = (0..=counts[0] * counts[1]).map(start).collect();
        Self { starts, balls }
    }
}

/// A cone over the plane of the grid, in whose axis along which it goes farther lines of cells are looked at in
/// turn.
///
/// At a distance a from its start its middle has gone `step` a along that axis and `aside` a across it, and balls
/// have their middles within `room_mm` + `slope` a of it.
#[derive(Debug, Clone, Copy)]
struct Sweep {
    axis: usize,
    /// In cells from the grid's corner, along and across.
    start: [f64; 2],
    step: f64,
    aside: f64,
    slope: f64,
    room: f64,
    reach: f64,
}

impl Sweep {
    fn new(grid: &Neighbours, ray: &Ray, slope: f64, reach_mm: f64) -> Self {
        let axis = usize::from(ray.along.z.abs() > ray.along.x.abs());
        let pair = |at: DVec3| if axis == 0 { [at.x, at.z] } else { [at.z, at.x] };
        let cells = |mm: f64| mm / grid.cell_mm;
        let ([step, aside], from) = (pair(ray.along), pair(ray.from));
        let corner = [grid.corner_mm[axis], grid.corner_mm[1 - axis]];
        let start = [0, 1].map(|i| cells(from[i] - corner[i]));
        let counts = [grid.counts[axis], grid.counts[1 - axis]].map(|count| count as f64);
        // No ball's middle is farther off.
        let far = |i: usize| start[i].abs().max((counts[i] - start[i]).abs());
        let height_mm = (ray.from.y - grid.low_mm).abs().max((grid.high_mm - ray.from.y).abs());
        let farthest = far(0) + far(1) + cells(height_mm);
        Self {
            axis,
            start,
            step,
            aside,
            slope,
            // Rounding may not lose a ball.
            room: cells(grid.greatest_mm) + 1e-6,
            reach: cells(reach_mm + grid.greatest_mm).min(farthest),
        }
    }

    /// The lines of cells that the sweep passes; none is an empty range.
    fn lines(&self, grid: &Neighbours) -> Range<usize> {
        let end = self.start[0] + self.step * self.reach;
        let wide = self.room + self.slope * self.reach;
        let low = (self.start[0] - self.room).min(end - wide);
        let high = (self.start[0] + self.room).max(end + wide);
        clamped(low, high, grid.counts[self.axis])
    }

    /// The part of a line that the cone passes over.
    fn slice<'a>(&self, grid: &'a Neighbours, line: usize) -> Option<Slice<'a>> {
        let (first, last) = self.passing(line as f64)?;
        let across = |a: f64| self.start[1] + self.aside * a;
        let wide = |a: f64| self.room + self.slope * a;
        let low = (across(first) - wide(first)).min(across(last) - wide(last));
        let high = (across(first) + wide(first)).max(across(last) + wide(last));
        let count = grid.counts[1 - self.axis];
        let cells = clamped(low, high, count);
        if cells.is_empty() {
            return None;
        }
        let Cells { starts, balls } = &grid.along[self.axis];
        let start = |cell: usize| starts[line * count + cell] as usize;
        let balls = &balls[start(cells.start)..start(cells.end)];
        Some(Slice { least_mm: first * grid.cell_mm - grid.greatest_mm, balls })
    }

    /// Between which distances from its start the cone is over a line of cells.
    fn passing(&self, line: f64) -> Option<(f64, f64)> {
        // Towards the line's nearer and farther edge, as the sweep goes.
        let ahead = if self.step < 0.0 { self.start[0] - line - 1.0 } else { line - self.start[0] };
        let (fastest, slowest) = (self.step.abs() + self.slope, self.step.abs() - self.slope);
        let first = if fastest > 0.0 { ((ahead - self.room) / fastest).max(0.0) } else { 0.0 };
        let beyond = ahead + 1.0 + self.room;
        let last = if slowest > 1e-9 { (beyond / slowest).min(self.reach) } else { self.reach };
        (first <= last).then_some((first, last))
    }
}

/// The cells from one place to another; none is an empty range.
fn clamped(low: f64, high: f64, count: usize) -> Range<usize> {
    if high < 0.0 || low >= count as f64 {
        return 0..0;
    }
    (low.max(0.0) as usize)..(high as usize + 1).min(count)
}

#[cfg(test)]
mod tests {
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
            for spread_rad in [1e-3, 0.1, 0.6, 2.5] {
                let on = balls[from].centre + along * balls[from].radius_mm;
                let aside = DVec3::new(on.x - 60.0, -3.0, on.z);
                for (point, from) in
                    [(on, Some(from)), (balls[from].centre, Some(from)), (aside, None)]
                {
                    let ray = Ray { from: point, along };
                    let near: Vec<usize> = neighbours.near(&ray, spread_rad, from).collect();
                    spared += 20 - near.len();
                    for (i, ball) in balls.iter().enumerate().filter(|(i, _)| Some(*i) != from) {
                        assert!(near.contains(&i) || ball.stops(&ray, spread_rad).is_none(), "{i}");
                    }
                }
            }
        }
        assert!(spared > 60_000, "{spared}");
    }

    #[test]
    fn slices_say_from_where_on_their_balls_lie() {
        let place = |i: usize| DVec3::new((i % 7) as f64 * 9.0, 0.0, (i / 7) as f64 * 10.0);
        let balls: Vec<Ball> =
            (0..49).map(|i| Ball { centre: place(i), ..Ball::alone(4.0) }).collect();
        let neighbours = Neighbours::new(&balls);
        for (along, _) in directions(24) {
            let ray = Ray { from: balls[24].centre, along };
            for slice in neighbours.slices(&ray, 0.1, true) {
                for &i in slice.balls {
                    let met = balls[i as usize].stops(&ray, 0.2).filter(|_| i != 24);
                    assert!(met.is_none_or(|(distance_mm, _)| distance_mm >= slice.least_mm));
                }
            }
        }
    }
}
