//! Where spots may be: discs that differ more from the pearl's course of colour than the ring around them does.

use std::f64::consts::PI;

use libm::sqrt;

use crate::face::{Face, SCALE, WIDTH};

/// Radii that are tried, in radians: the smallest, how many, and what one is of that before **(ours)**.
const LEAST: f64 = 0.03;
const COUNT: u32 = 10;
const STEP: f64 = 1.2;
/// Between a disc and the ring around it, and how wide that is, in radians: facets lean by 0.03 and more, which blurs
/// what they mirror by as much **(ours)**.
pub const GAP: f64 = 0.03;
pub const RING: f64 = 0.09;
/// Shares of a disc, and of its ring, that must be seen.
const SEEN: (f64, f64) = (0.9, 0.5);
/// Least difference by which a place is a candidate, in shares of that from which it counts.
const LEAST_DIFFERENCE: f64 = 0.85;

/// A disc on the map.
#[derive(Clone, Copy)]
pub struct Candidate {
    pub at: usize,
    /// In radians.
    pub radius: f64,
}

impl Candidate {
    /// How many places its ring would have.
    pub fn whole_ring(&self) -> f64 {
        let (inner, outer) = (self.radius + GAP, self.radius + GAP + RING);
        PI * SCALE * SCALE * (outer * outer - inner * inner)
    }
}

/// Radii that are tried.
fn radii() -> impl Iterator<Item = f64> {
    std::iter::successors(Some(LEAST), |radius| Some(STEP * radius)).take(COUNT as usize)
}

/// The largest of them.
pub fn largest() -> f64 {
    radii().fold(LEAST, f64::max)
}

/// At every radius, the places that differ most among those near them, and by more than a share of `least`.
pub fn candidates(face: &Face, residual: &[[f64; 3]], least: f64) -> Vec<Candidate> {
    let power: Vec<f64> = residual.iter().map(|[l, a, b]| l * l + a * a + b * b).collect();
    radii().flat_map(|radius| of_radius(face, &power, radius, LEAST_DIFFERENCE * least)).collect()
}

fn of_radius(face: &Face, power: &[f64], radius: f64, least: f64) -> Vec<Candidate> {
    let step = ((radius * SCALE / 3.0) as usize).max(1);
    let disc = offsets(0.0, radius);
    let mut ring = offsets(radius + GAP, radius + GAP + RING);
    // Every other place of a ring is enough, as on one colour of a chessboard.
    ring.retain(|(down, right, _)| (down + right) % 2 == 0);
    let columns = WIDTH / step;
    let contrast: Vec<f64> = (0..columns * columns)
        .map(|at| {
            let at = at / columns * step * WIDTH + at % columns * step;
            let (own, held) = mean(face, power, &disc, at);
            if held < SEEN.0 {
                return 0.0;
            }
            let (around, held) = mean(face, power, &ring, at);
            if held < SEEN.1 { 0.0 } else { sqrt((own - around).max(0.0)) }
        })
        .collect();
    let reach = ((0.5 * radius * SCALE).round() as usize / step).max(1).cast_signed();
    let is_most = |at: usize| {
        let (row, column) = ((at / columns).cast_signed(), (at % columns).cast_signed());
        (-reach..=reach).all(|down| {
            (-reach..=reach).all(|right| {
                let inside = |place: isize| (0..columns.cast_signed()).contains(&place);
                let (y, x) = (row + down, column + right);
                let near = y * columns.cast_signed() + x;
                !(inside(y) && inside(x)) || contrast[near.cast_unsigned()] <= contrast[at]
            })
        })
    };
    (0..contrast.len())
        .filter(|&at| contrast[at] > least && is_most(at))
        .map(|at| Candidate { at: at / columns * step * WIDTH + at % columns * step, radius })
        .collect()
}

/// Rows and columns from a middle, from one distance to another in radians, and how much of each lies between.
fn offsets(from: f64, to: f64) -> Vec<(isize, isize, f64)> {
    let reach = (to * SCALE).ceil() as isize + 1;
    let share = |down: isize, right: isize| {
        let away = sqrt((down * down + right * right) as f64);
        let beyond = if from > 0.0 { (away - from * SCALE + 0.5).clamp(0.0, 1.0) } else { 1.0 };
        beyond.min((to * SCALE - away + 0.5).clamp(0.0, 1.0))
    };
    (-reach..=reach)
        .flat_map(|down| (-reach..=reach).map(move |right| (down, right, share(down, right))))
        .filter(|(_, _, share)| *share > 0.0)
        .collect()
}

/// The mean over some offsets from a place, and the share of them that is held.
fn mean(face: &Face, of: &[f64], offsets: &[(isize, isize, f64)], at: usize) -> (f64, f64) {
    let (row, column) = ((at / WIDTH).cast_signed(), (at % WIDTH).cast_signed());
    let most = WIDTH.cast_signed();
    let (mut sum, mut held, mut all) = (0.0, 0.0, 0.0);
    for &(down, right, share) in offsets {
        all += share;
        let (y, x) = (row + down, column + right);
        if (0..most).contains(&y) && (0..most).contains(&x) {
            let near = (y * most + x).cast_unsigned();
            if face.held[near] {
                sum += share * of[near];
                held += share;
            }
        }
    }
    (sum / held.max(1e-9), held / all)
}
