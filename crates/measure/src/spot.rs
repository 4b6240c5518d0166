//! How far a disc is a spot: it differs from what its surroundings, carried on over it, would have there.

use std::f64::consts::{PI, TAU};

use libm::{atan2, exp, pow, sqrt};

use crate::candidate::{Candidate, GAP, RING};
use crate::face::{Face, SCALE, WIDTH};
use crate::solve::{inverse, product, times};
use crate::value::{median, quantile};

/// Differences between which a spot comes to count, in L* **(ours)**.
pub const DIFFERENCE: (f64, f64) = (0.7, 1.6);
/// It is wanted to differ by this much times what its ring does (three quarters of which differ less), and of what the
/// ring's twelfths do, in which texture is averaged and mirrored tables are not **(ours)**.
const STANDS_OUT: f64 = 2.5;
const STANDS_OUT_OF_SECTORS: f64 = 3.0;
const SECTORS: usize = 12;
const USUAL: f64 = 0.75;
/// What is wanted is never taken for less.
const FLOOR: f64 = 0.45;
/// Shares of what is wanted between which it comes to count.
const CLEAR: (f64, f64) = (0.8, 1.3);
/// Shares of its difference that are lost across its border: all around, and in the eighth where least is **(ours)**.
const FALL: (f64, f64) = (0.55, 0.8);
const LEAST_FALL: (f64, f64) = (0.2, 0.5);
/// Shares of the ring that are seen, and of the disc that are not.
const SEEN: (f64, f64) = (0.55, 0.8);
const HIDDEN: (f64, f64) = (0.0, 0.15);
/// Shares of a spot's difference, where three quarters of its disc differ by no more, between which a place comes to belong
/// to it: averaged, half of it reaches beyond the border **(ours)**.
const BELONGS: (f64, f64) = (0.45, 0.9);
/// Share of its mean power above which a place of the disc is the spot's own.
const OWN: f64 = 0.25;
/// A place's difference is averaged with this standard deviation, in radians: relief is lighter on one side and darker
/// on the other, and has a line between on which it does not differ.
const AVERAGED: f64 = 0.02;
/// What a border is found too far in, of large spots, and what small ones are found too large by, at their own radius: in
/// radians, fitted to discs of 0.04 to 0.13 radians, 30 % darker than a matt ball (`test_the_area_of_dark_spots_is_theirs`).
const INWARD: f64 = 0.016;
const OUTWARD: f64 = 1.42e-4;
/// No area is made smaller than by this factor **(ours)**: below 0.065 radians, as found, the correction would soon leave
/// nothing of a spot.
const LEAST_FACTOR: f64 = 0.55;
/// The least that a ring differs from its own course, for weights, in L*.
const LEAST_SPREAD: f64 = 0.05;
/// A course over the ring: 1, x, y, x^2, x y, y^2, in reaches.
const TERMS: usize = 6;

/// A disc that may be a spot.
pub struct Spot {
    /// Its root mean square difference, in L*, less that of the ring around it.
    pub contrast: f64,
    /// What it is wanted to differ by here.
    pub needed: f64,
    /// How far it is closed, sharp and in sight, 0 to 1.
    shape: f64,
    /// Places, and how far they belong to it, 0 to 1.
    pub places: Vec<(usize, f64)>,
}

impl Spot {
    /// How far it counts, 0 to 1, with differences wanted that are larger by a factor; what is in part closed and sharp counts
    /// less with a larger one: JPEG moved such a spot of a dark pearl from a half to all, and the area by 17 %.
    pub fn weight(&self, factor: f64) -> f64 {
        pow(self.shape, factor * factor)
            * rise(self.contrast / factor, DIFFERENCE)
            * rise(self.contrast / (factor * self.needed), CLEAR)
    }
}

/// From 0 to 1 between two values, with no corner.
fn rise(value: f64, (from, to): (f64, f64)) -> f64 {
    let share = ((value - from) / (to - from)).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// A place of the map near a disc.
struct Near {
    at: usize,
    right: f64,
    down: f64,
    away: f64,
    /// Squared difference from the ring's course.
    power: f64,
    /// Around the disc, 0 to 1.
    turn: f64,
}

/// What a disc differs by; None where too little of it, or of its ring, is seen.
pub fn spot(face: &Face, residual: &[[f64; 3]], disc: &Candidate) -> Option<Spot> {
    let (all, held) = whole_disc(face, disc);
    let hidden = 1.0 - held / all;
    if hidden >= HIDDEN.1 {
        return None;
    }
    let (near, seen) = around(face, residual, disc)?;
    let radius = disc.radius;
    let is_ring = |one: &&Near| is_ring(one.away, radius);
    let mut ring: Vec<f64> = near.iter().filter(is_ring).map(|one| one.power).collect();
    let noise = median(&mut ring);
    let own = mean_power(&near, |one| one.away <= radius);
    let contrast = sqrt((own? - noise).max(1e-6));
    let mut sectors = parts(&near, SECTORS, |one| is_ring(&one));
    let needed = (STANDS_OUT * sqrt(quantile(&mut ring, USUAL)))
        .max(STANDS_OUT_OF_SECTORS * sqrt(quantile(&mut sectors, USUAL)))
        .max(FLOOR);
    let border =
        parts(&near, 8, |one| (radius + 0.5 * GAP..radius + 1.5 * GAP).contains(&one.away));
    let falls: Vec<f64> =
        border.iter().map(|power| 1.0 - sqrt((power - noise).max(0.0)) / contrast).collect();
    let fall = falls.iter().sum::<f64>() / falls.len() as f64;
    let least = falls.iter().copied().fold(1.0, f64::min);
    let shape = rise(fall, FALL)
        * rise(least, LEAST_FALL)
        * rise(seen, SEEN)
        * (1.0 - rise(hidden, HIDDEN));
    let places = if shape > 0.0 { members(&near, disc, noise) } else { Vec::new() };
    Some(Spot { contrast, needed, shape, places })
}

fn is_ring(away: f64, radius: f64) -> bool {
    away > radius + GAP && away < radius + GAP + RING
}

/// The disc's and its border's places, all and those held.
fn whole_disc(face: &Face, disc: &Candidate) -> (f64, f64) {
    let (mut all, mut held) = (0.0, 0.0);
    for (at, right, down) in window(disc) {
        if sqrt(right * right + down * down) < disc.radius + GAP {
            all += 1.0;
            held += f64::from(u8::from(at.is_some_and(|at| face.held[at])));
        }
    }
    (all, held)
}

/// Places around a disc, its ring included, with how far they lie to the right and down; None off the map.
fn window(disc: &Candidate) -> impl Iterator<Item = (Option<usize>, f64, f64)> + use<> {
    let reach = ((disc.radius + GAP + RING) * SCALE).ceil() as isize + 1;
    let (row, column) = ((disc.at / WIDTH).cast_signed(), (disc.at % WIDTH).cast_signed());
    let most = WIDTH.cast_signed();
    (-reach..=reach).flat_map(move |down| {
        (-reach..=reach).map(move |right| {
            let (y, x) = (row + down, column + right);
            let inside = (0..most).contains(&y) && (0..most).contains(&x);
            let at = inside.then(|| (y * most + x).cast_unsigned());
            (at, right as f64 / SCALE, down as f64 / SCALE)
        })
    })
}

/// What is held around a disc, less the course of its ring, and the share of the ring that is seen.
fn around(face: &Face, residual: &[[f64; 3]], disc: &Candidate) -> Option<(Vec<Near>, f64)> {
    let reach = disc.radius + GAP + RING;
    let mut near: Vec<Near> = window(disc)
        .filter_map(|(at, right, down)| {
            let at = at.filter(|&at| face.held[at])?;
            let away = sqrt(right * right + down * down);
            let turn = atan2(down, right) / TAU + 0.5;
            (away < reach).then_some(Near { at, right, down, away, power: 0.0, turn })
        })
        .collect();
    let terms = |one: &Near| {
        let (x, y) = (one.right / reach, one.down / reach);
        [1.0, x, y, x * x, x * y, y * y]
    };
    let ring: Vec<([f64; TERMS], [f64; 3])> = near
        .iter()
        .filter(|one| is_ring(one.away, disc.radius))
        .map(|one| (terms(one), residual[one.at]))
        .collect();
    let seen = ring.len() as f64 / disc.whole_ring();
    if seen < 0.5 || ring.len() < 4 * TERMS {
        return None;
    }
    // Every other place is enough.
    let course = course(&ring.iter().copied().step_by(2).collect::<Vec<_>>())?;
    for one in &mut near {
        one.power = power(residual[one.at], &terms(one), &course);
    }
    Some((near, seen))
}

fn power(colour: [f64; 3], terms: &[f64; TERMS], course: &[Vec<f64>; 3]) -> f64 {
    (0..3).map(|i| colour[i] - product(terms, &course[i])).map(|rest| rest * rest).sum()
}

/// The robust course of colour over a ring, by Huber's weights in three rounds.
fn course(ring: &[([f64; TERMS], [f64; 3])]) -> Option<[Vec<f64>; 3]> {
    let mut weights = vec![1.0; ring.len()];
    let mut course = [Vec::new(), Vec::new(), Vec::new()];
    for _ in 0..3 {
        let mut matrix = vec![vec![0.0; TERMS]; TERMS];
        let mut sides = [vec![0.0; TERMS], vec![0.0; TERMS], vec![0.0; TERMS]];
        for ((terms, colour), weight) in ring.iter().zip(&weights) {
            for one in 0..TERMS {
                for other in 0..TERMS {
                    matrix[one][other] += weight * terms[one] * terms[other];
                }
                for channel in 0..3 {
                    sides[channel][one] += weight * terms[one] * colour[channel];
                }
            }
        }
        let inverse = inverse(&matrix)?;
        course = sides.map(|side| times(&inverse, &side));
        let sizes: Vec<f64> =
            ring.iter().map(|(terms, colour)| sqrt(power(*colour, terms, &course))).collect();
        let spread = median(&mut sizes.clone()).max(LEAST_SPREAD);
        weights = sizes.iter().map(|size| 1.0 / (size / spread).max(1.0)).collect();
    }
    Some(course)
}

/// The mean squared difference of some places; None of none.
fn mean_power(near: &[Near], is_one: impl Fn(&Near) -> bool) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0.0);
    for one in near.iter().filter(|one| is_one(one)) {
        sum += one.power;
        count += 1.0;
    }
    (count > 0.0).then(|| sum / count)
}

/// The mean squared difference in each of some parts around the middle, of those that have any.
fn parts(near: &[Near], count: usize, is_one: impl Fn(&Near) -> bool) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0); count];
    for one in near.iter().filter(|one| is_one(one)) {
        let (sum, held) = &mut sums[((one.turn * count as f64) as usize).min(count - 1)];
        *sum += one.power;
        *held += 1.0;
    }
    sums.iter().filter(|(_, held)| *held > 0.0).map(|(sum, held)| sum / held).collect()
}

/// Places that differ as a disc does, within its border.
fn members(near: &[Near], disc: &Candidate, noise: f64) -> Vec<(usize, f64)> {
    let border = (disc.radius + 0.5 * GAP, disc.radius + 1.5 * GAP);
    let inner: Vec<&Near> =
        near.iter().filter(|one| one.away < border.1 + 3.0 * AVERAGED).collect();
    let averaged = averaged(&inner, noise);
    // Of a disc that is larger than the spot, what is beside the spot does not count: its mean is weighed by itself.
    let within = || inner.iter().zip(&averaged).filter(|(one, _)| one.away <= disc.radius);
    let (sum, squares) = within()
        .fold((0.0, 0.0), |(sum, squares), (_, power)| (sum + power, squares + power * power));
    let mean = squares / f64::max(sum, 1e-9);
    let own = within().map(|(_, power)| *power).filter(|&power| power > OWN * mean);
    let full = quantile(&mut own.collect::<Vec<f64>>(), 0.5);
    let mut places: Vec<(usize, f64)> = inner
        .iter()
        .zip(averaged)
        .filter(|(one, _)| one.away < border.1)
        .map(|(one, power)| {
            let share = (sqrt(power / full.max(1e-9)) - BELONGS.0) / (BELONGS.1 - BELONGS.0);
            (one.at, share.clamp(0.0, 1.0) * (1.0 - rise(one.away, border)))
        })
        .filter(|(_, share)| *share > 0.0)
        .collect();
    let factor = unblurred(places.iter().map(|(_, share)| share).sum());
    for (_, share) in &mut places {
        *share *= factor;
    }
    places
}

/// What so many places are to be multiplied by: light is averaged before spots are looked for.
fn unblurred(places: f64) -> f64 {
    let radius = sqrt(places / PI) / SCALE;
    let own = (radius + INWARD - OUTWARD / (radius * radius)).max(0.0) / radius.max(1e-9);
    (own * own).max(LEAST_FACTOR)
}

/// Squared differences beyond noise, averaged by a Gaussian, first along rows and then along columns.
fn averaged(near: &[&Near], noise: f64) -> Vec<f64> {
    let spread = AVERAGED * SCALE;
    let reach = (3.5 * spread) as isize;
    let weights: Vec<f64> = (-reach..=reach)
        .map(|step| exp(-0.5 * (step as f64 / spread) * (step as f64 / spread)))
        .collect();
    let sum: f64 = weights.iter().sum();
    let mut map: Vec<f64> = vec![0.0; WIDTH * WIDTH];
    for one in near {
        map[one.at] = (one.power - noise).max(0.0);
    }
    for stride in [1, WIDTH.cast_signed()] {
        let along = |at: usize| {
            let place = |step: usize| at.checked_add_signed((step.cast_signed() - reach) * stride);
            let part = |(step, weight): (usize, &f64)| {
                place(step).and_then(|at| map.get(at)).map_or(0.0, |one| weight * one / sum)
            };
            weights.iter().enumerate().map(part).sum::<f64>()
        };
        let means: Vec<f64> = near.iter().map(|one| along(one.at)).collect();
        for (one, mean) in near.iter().zip(means) {
            map[one.at] = mean;
        }
    }
    near.iter().map(|one| map[one.at]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::face::offset;

    #[test]
    fn a_rise_has_its_ends_and_middle() {
        for (value, risen) in [(0.0, 0.0), (1.0, 0.0), (2.0, 0.5), (3.0, 1.0), (4.0, 1.0)] {
            assert!((rise(value, (1.0, 3.0)) - risen).abs() < 1e-12);
        }
    }

    #[test]
    fn offsets_of_a_window_are_those_of_the_map() {
        let disc = Candidate { at: 80 * WIDTH + 60, radius: 0.1 };
        let (x, y) = offset(disc.at);
        for (at, right, down) in window(&disc) {
            let (other_x, other_y) = offset(at.unwrap());
            assert!((other_x - x - right).abs() + (other_y - y - down).abs() < 1e-12);
        }
    }
}
