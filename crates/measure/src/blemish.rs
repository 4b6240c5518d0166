//! Blemishes: spots that differ from the pearl around them.

use libm::{fabs, sqrt};
use serde::Serialize;

use crate::candidate::{Candidate, candidates};
use crate::course::residuals;
use crate::face::{Face, SCALE, WIDTH, offset, share_of_half};
use crate::spot::{DIFFERENCE, Spot, spot};
use crate::value::median;
use crate::{Circle, Value};

/// The least share of the half of the ball that must be looked at.
const LEAST_LOOKED_AT: f64 = 0.1;
/// Radius of the spots, and how far apart they lie, in radians, by which it is tried what could be told.
const TRIED: (f64, f64) = (0.062, 0.15);
/// Shares of what lies within this, in radians, between which spots become a pattern, mirrored **(ours)**.
const NEAR: f64 = 0.3;
const PATTERN: (f64, f64) = (0.2, 0.4);
/// What counts less than this does not count.
const LEAST_SHARE: f64 = 0.05;

/// Spots found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Blemishes {
    /// Their area on the ball, in percent of what was looked at; its error: half of what wanting differences, closed and
    /// sharp borders a quarter less or more changes.
    pub area: Value,
    /// How many there are.
    pub count: usize,
    /// Share of the visible half of the ball that was looked at.
    pub looked_at: f64,
    /// The least difference that comes to count, in L*: 0.7, or what a spot of 0.06 radians needs to be told from texture and
    /// mirrored light here, the median of places tried.
    pub threshold: f64,
    /// Middles, and radii of discs as large as they are on the ball, in pixels, the largest first.
    pub spots: Vec<Circle>,
}

/// Looks for spots on a ball; None where too little of it is left.
pub fn blemishes(face: &Face) -> Option<Blemishes> {
    let whole = face.looked.iter().filter(|looked| **looked).count();
    let looked_at = share_of_half(whole);
    if looked_at < LEAST_LOOKED_AT {
        return None;
    }
    let residual = residuals(face)?;
    let known: Vec<Spot> = candidates(face, &residual, DIFFERENCE.0)
        .iter()
        .filter_map(|one| spot(face, &residual, one))
        .collect();
    let percent = |shares: &[f64]| 100.0 * shares.iter().sum::<f64>() / whole as f64;
    let shares = shares(face, &known, 1.0);
    let change = [0.75, 1.25].map(|factor| percent(&self::shares(face, &known, factor)));
    let area = Value::new(percent(&shares), 0.5 * fabs(change[0] - change[1]));
    let spots = spots(face, &shares);
    let threshold = DIFFERENCE.0.max(told_from(face, &residual));
    Some(Blemishes { area, count: spots.len(), looked_at, threshold, spots })
}

/// How far each place that is looked at belongs to a spot, 0 to 1, with differences wanted that are larger by a factor.
fn shares(face: &Face, known: &[Spot], factor: f64) -> Vec<f64> {
    let mut shares = vec![0.0_f64; face.held.len()];
    for spot in known {
        let weight = spot.weight(factor);
        for &(at, share) in &spot.places {
            shares[at] = shares[at].max(weight * share);
        }
    }
    let filled = filled(face, &shares);
    let own = |at: usize| {
        let alone = 1.0 - ((filled(at) - PATTERN.0) / (PATTERN.1 - PATTERN.0)).clamp(0.0, 1.0);
        let share = shares[at] * alone;
        if face.looked[at] { ((share - LEAST_SHARE) / (1.0 - LEAST_SHARE)).max(0.0) } else { 0.0 }
    };
    (0..shares.len()).map(|at| if shares[at] > 0.0 { own(at) } else { 0.0 }).collect()
}

/// How much of what lies near a place belongs to spots.
fn filled<'a>(face: &'a Face, shares: &'a [f64]) -> impl Fn(usize) -> f64 + 'a {
    // Every other place is enough.
    let reach = (NEAR * SCALE / 2.0) as isize;
    let steps: Vec<(isize, isize)> = (-reach..=reach)
        .flat_map(|down| (-reach..=reach).map(move |right| (2 * down, 2 * right)))
        .filter(|(down, right)| sqrt((down * down + right * right) as f64) <= NEAR * SCALE)
        .collect();
    move |at| {
        let most = WIDTH.cast_signed();
        let (row, column) = (at.cast_signed() / most, at.cast_signed() % most);
        let (mut all, mut sum) = (0.0, 0.0);
        for (down, right) in &steps {
            let (y, x) = (row + down, column + right);
            if (0..most).contains(&y) && (0..most).contains(&x) {
                let near = (y * most + x).cast_unsigned();
                all += f64::from(u8::from(face.held[near]));
                sum += shares[near];
            }
        }
        sum / f64::max(all, 1.0)
    }
}

/// What hangs together, the largest first.
fn spots(face: &Face, shares: &[f64]) -> Vec<Circle> {
    let mut free: Vec<bool> = shares.iter().map(|share| *share > 0.0).collect();
    let mut spots = Vec::new();
    for first in 0..free.len() {
        if !free[first] {
            continue;
        }
        free[first] = false;
        let (mut next, mut count, mut middle) = (vec![first], 0.0, (0.0, 0.0));
        while let Some(at) = next.pop() {
            let (right, down) = offset(at);
            middle = (middle.0 + right, middle.1 + down);
            count += 1.0;
            for near in [at.wrapping_sub(1), at + 1, at.wrapping_sub(WIDTH), at + WIDTH] {
                if free.get(near).copied().unwrap_or(false) {
                    free[near] = false;
                    next.push(near);
                }
            }
        }
        spots.push(face.seen((middle.0 / count, middle.1 / count), count));
    }
    spots.sort_by(|one, other| other.radius_px.total_cmp(&one.radius_px));
    spots
}

/// What spots would have to differ by, tried over the pearl: the median; NaN where none could be told.
fn told_from(face: &Face, residual: &[[f64; 3]]) -> f64 {
    let step = (TRIED.1 * SCALE) as usize;
    let on_grid =
        |at: &usize| (at % WIDTH).is_multiple_of(step) && (at / WIDTH).is_multiple_of(step);
    let tried = (0..face.looked.len()).filter(|&at| face.looked[at]).filter(on_grid);
    let needed = |at: usize| Some(spot(face, residual, &Candidate { at, radius: TRIED.0 })?.needed);
    median(&mut tried.filter_map(needed).collect::<Vec<f64>>())
}
