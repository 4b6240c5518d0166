//! Where the blemishes of a pearl lie: at random places, beside each other.
//!
//! Darts at even directions (Archimedes); one that meets another is thrown again.
//! Left out: that blemishes gather, as they do about the poles of real pearls.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;

use crate::{
    coat::blemish::{Blemish, Blemishes},
    grain::normal::uniform,
};

/// Sizes and depths lie within this share of the stated ones, to either side **(ours)**.
const UNEVEN: f64 = 0.4;

/// Darts for each blemish before it may lie on another.
const DARTS: usize = 400;

/// The blemishes of a pearl of `pearl_mm`, its radius; none that have no area.
pub(crate) fn layout(blemishes: &Blemishes, pearl_mm: f64) -> Vec<Blemish> {
    let mut random = ChaCha8Rng::from_seed(key(blemishes.seed));
    let mut all: Vec<Blemish> = Vec::new();
    for &(kind, count) in &blemishes.counts {
        let (length, width, depth) = kind.proportions();
        for _ in 0..count {
            let mut uneven = |mean: f64| mean * (1.0 + UNEVEN * (2.0 * uniform(&mut random) - 1.0));
            let (size_mm, depth_mm) = (uneven(blemishes.size_mm), uneven(blemishes.depth_mm));
            all.push(Blemish {
                kind,
                middle: DVec3::Z,
                along: DVec3::X,
                half_length_mm: 0.5 * length * size_mm,
                radius_mm: 0.5 * width * size_mm,
                depth_mm: depth * depth_mm,
            });
        }
    }
    if let Some(share) = blemishes.area {
        let now: f64 = all.iter().map(Blemish::area_mm2).sum();
        let factor = (share * 4.0 * PI * pearl_mm * pearl_mm / now.max(f64::MIN_POSITIVE)).sqrt();
        for blemish in &mut all {
            blemish.half_length_mm *= factor;
            blemish.radius_mm *= factor;
            blemish.depth_mm *= factor; // slopes stay, and with them how clearly each is seen
        }
    }
    all.retain(|blemish| blemish.radius_mm > 0.0);
    // The largest find their place first.
    all.sort_by(|a, b| b.reach_mm().total_cmp(&a.reach_mm()));
    for i in 0..all.len() {
        for _ in 0..DARTS {
            let (middle, along) = dart(&mut random);
            (all[i].middle, all[i].along) = (middle, along);
            let (placed, rest) = all.split_at(i);
            if placed.iter().all(|other| are_apart(other, &rest[0], pearl_mm)) {
                break;
            }
        }
    }
    all
}

/// A direction, each as likely as any other, and one across it.
fn dart(random: &mut ChaCha8Rng) -> (DVec3, DVec3) {
    let (z, turn) = (2.0 * uniform(random) - 1.0, TAU * uniform(random));
    let (sin, cos) = libm::sincos(turn);
    let aside = (1.0 - z * z).max(0.0).sqrt();
    let middle = DVec3::new(aside * cos, aside * sin, z);
    let (x, y) = middle.any_orthonormal_pair();
    let (sin, cos) = libm::sincos(TAU * uniform(random));
    (middle, x * cos + y * sin)
}

/// Whether two outlines do not meet: strips as chains of discs along their middle lines.
fn are_apart(a: &Blemish, b: &Blemish, pearl_mm: f64) -> bool {
    let between = (a.middle - b.middle).length() * pearl_mm;
    if between > a.reach_mm() + b.reach_mm() {
        return true;
    }
    let least = a.radius_mm + b.radius_mm;
    let points = |blemish: &Blemish| -> Vec<DVec3> {
        let count = (blemish.half_length_mm / blemish.radius_mm.max(1e-6)).ceil().min(24.0);
        let steps = count as i32;
        (-steps..=steps)
            .map(|i| f64::from(i) / f64::from(steps.max(1)))
            .map(|share| blemish.point(blemish.half_length_mm / pearl_mm * share) * pearl_mm)
            .collect()
    };
    let others = points(b);
    points(a).iter().all(|p| others.iter().all(|q| p.distance(*q) > least))
}

fn key(seed: u64) -> [u8; 32] {
    let mut key = *b"-------- nacreous blemish places";
    key[..8].copy_from_slice(&seed.to_le_bytes());
    key
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        coat::{blemish::Kind, spots::Spots},
        view::direction::directions,
    };

    fn of(counts: &[(Kind, usize)], area: Option<f64>, seed: u64) -> Vec<Blemish> {
        let counts = counts.to_vec();
        let blemishes = Blemishes { counts, size_mm: 0.3, depth_mm: 0.01, area, seed };
        layout(&blemishes, 4.0)
    }

    #[test]
    fn blemishes_cover_the_area_that_was_asked_for() {
        let mixed = [(Kind::Pit, 20), (Kind::Bump, 20), (Kind::Wrinkle, 5), (Kind::Chalk, 10)];
        for (counts, area) in [(&mixed[..], 0.05), (&mixed[..], 0.2), (&[(Kind::Pit, 30)][..], 0.1)]
        {
            let spots = Spots::new(of(counts, Some(area), 3), 4.0);
            let covered: f64 = directions(400)
                .filter(|(direction, _)| {
                    spots.near(*direction).any(|b| b.at(*direction, 4.0, 0.0).is_some())
                })
                .map(|(_, share)| share)
                .sum();
            assert!((covered / area - 1.0).abs() < 0.03, "{area}: {covered}");
        }
    }

    #[test]
    fn an_area_keeps_the_slopes_of_every_blemish() {
        let counts = [(Kind::Pit, 20), (Kind::Wrinkle, 5)];
        let slopes = |area| {
            let mut slopes: Vec<f64> =
                of(&counts, area, 3).iter().map(|one| one.depth_mm / one.radius_mm).collect();
            slopes.sort_by(f64::total_cmp);
            slopes
        };
        for (one, as_stated) in slopes(Some(0.1)).iter().zip(slopes(None)) {
            assert!((one / as_stated - 1.0).abs() < 1e-12, "{one}: {as_stated}");
        }
    }

    #[test]
    fn blemishes_without_an_area_are_none() {
        assert!(of(&[(Kind::Pit, 5), (Kind::Scratch, 2)], Some(0.0), 1).is_empty());
    }

    #[test]
    fn same_seed_same_places_and_another_seed_others() {
        let counts = [(Kind::Pit, 6), (Kind::Scratch, 2)];
        assert_eq!(of(&counts, None, 1), of(&counts, None, 1));
        assert_ne!(of(&counts, None, 1), of(&counts, None, 2));
    }
}
