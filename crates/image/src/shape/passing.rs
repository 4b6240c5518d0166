//! How near a line of sight passes a pearl that is not round, as silhouettes want it.
//!
//! Places along the line, then secants of the change.
//! Left out: a second pass that is as near.

use glam::DVec3;

use crate::shape::{crossing::Line, solid::Solid};

/// The nearest that a line of sight comes to a solid, as a ball's would.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passing {
    /// How far along.
    pub(super) at: f64,
    /// One less the square of its distance from the middle over the surface's.
    square: f64,
    /// How that changes along the line.
    change: f64,
}

/// Steps along a line of sight on the way to the nearest place; by eye **(ours)**.
const STEPS: usize = 14;
/// Steps to the nearest pass once it is known roughly: its square is then right to 1e-9.
const REFINEMENTS: usize = 5;
/// None of them is longer than this, over half of the pearl's width.
const LONGEST_STEP: f64 = 0.2;
/// Nor is the pass taken for flatter than this.
const LEAST_BEND_OF_PASS: f64 = -0.2;

impl Solid {
    /// As the square of the cosine of the view angle is for a ball: 1 less the square of the distance at which a line of
    /// sight passes the middle, over the surface's there; below 0 where it passes by.
    pub fn square(&self, from: DVec3, along: DVec3) -> f64 {
        self.passing(&self.line(from, along)).square
    }

    /// How far along a line of sight comes nearest to the surface.
    pub(crate) fn nearest_pass(&self, from: DVec3, along: DVec3) -> f64 {
        self.passing(&self.line(from, along)).at
    }

    /// [`Self::square`] of a line beside one whose nearest pass is known.
    pub(crate) fn square_near(&self, from: DVec3, along: DVec3, pass: f64) -> f64 {
        let line = self.line(from, along);
        self.nearer(&line, self.passing_at(&line, pass)).square
    }

    /// The nearest pass of a line.
    pub(super) fn passing(&self, line: &Line) -> Passing {
        let [from, to] = line.within(self.greatest).unwrap_or_else(|| {
            let middle = -line.from.dot(line.along);
            [middle - self.greatest, middle + self.greatest]
        });
        let step = (to - from) / STEPS as f64;
        let coarse = (0..=STEPS).map(|i| self.passing_at(line, from + step * i as f64));
        let best = coarse.max_by(|a, b| a.square.total_cmp(&b.square));
        best.map_or(Passing { at: from, square: 0.0, change: 0.0 }, |best| self.nearer(line, best))
    }

    /// The nearest pass next to one that is known, by secants of the change.
    fn nearer(&self, line: &Line, known: Passing) -> Passing {
        let (mut best, mut last) = (known, known);
        // That of a ball.
        let mut bend = -2.0;
        for _ in 0..REFINEMENTS {
            let step = (-last.change / bend).clamp(-LONGEST_STEP, LONGEST_STEP);
            if step.abs() < 1e-7 {
                break;
            }
            let next = self.passing_at(line, last.at + step);
            bend = ((next.change - last.change) / step).min(LEAST_BEND_OF_PASS);
            last = next;
            if next.square > best.square {
                best = next;
            }
        }
        best
    }

    fn passing_at(&self, line: &Line, at: f64) -> Passing {
        let point = line.point(at);
        let far = point.length();
        let towards = point / far;
        let (radius, gradient) = self.form.at(towards);
        let share = far / radius;
        let change = line.along.dot(towards) - share * gradient.dot(line.along) / far;
        Passing { at, square: 1.0 - share * share, change: -2.0 * share / radius * change }
    }
}
