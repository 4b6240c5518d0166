//! Whether a closed region is a spot: it differs from what its surroundings, carried on over it, would have there.

use std::f64::consts::{PI, TAU};

use libm::{atan2, fabs, sqrt};

use crate::solve::{inverse, product, times};
use crate::value::{median, quantile};
use crate::window::Window;

/// How far to both sides of a border it is compared, in radii: facets lean by 0.03 radians and more, which
/// blurs what they mirror by as many radii **(ours)**.
const ASIDE: f64 = 0.03;
/// Width of the ring of surroundings beyond, in radii **(ours)**.
const RING: f64 = 0.09;
/// A spot is about round: 4 pi area / border^2 is this at the least **(ours)**.
const LEAST_ROUND: f64 = 0.5;
/// The share of its difference that is lost across its border, on the mean and in each eighth **(ours)**.
const LEAST_FALL: (f64, f64) = (0.55, 0.3);
/// Times what its surroundings differ from their own course, in the direction of colour in which it is clearest, that it differs; and the same where less than `WHOLE`
/// of the ring can be seen or the spot is under `SMALL_PX` in radius, where texture passes for spots **(ours)**.
const STANDS_OUT: f64 = 4.5;
const STANDS_OUT_IN_DOUBT: f64 = 8.0;
const WHOLE: f64 = 0.95;
const SMALL_PX: f64 = 3.0;
/// The same against means over twelfths of the ring, in which texture is averaged and mirrored tables are not **(ours)**.
const STANDS_OUT_OF_SECTORS: f64 = 7.0;
const SECTORS: usize = 12;
/// Scatter of surroundings is never taken for less than this, in CIELAB **(ours)**.
const FLOOR: f64 = 0.1;
/// A place belongs to a spot from this share of its difference on: where a sharp border is.
const BELONGS: f64 = 0.5;
/// Of the ring, this share differs less than what counts as its difference.
const USUAL: f64 = 0.75;
/// The ring's share that must be seen.
const LEAST_SEEN: f64 = 0.5;
/// Of the ring about so many pixels are taken.
const ENOUGH: usize = 400;
/// A course over the ring: 1, x, y, x^2, x y, y^2.
const TERMS: usize = 6;

/// A course of each channel.
type Course = [Vec<f64>; 3];

/// A map of differences from the pearl's own course, in CIELAB.
pub struct Map<'a> {
    pub residual: &'a [[f64; 3]],
    pub held: &'a [bool],
    /// What lies on the pearl and is not looked at: the lamp's image, clipped light.
    pub hidden: &'a [bool],
    pub width: usize,
    /// The pearl's radius, in pixels of the map.
    pub radius: f64,
}

/// A region that may be a spot.
pub struct Spot {
    /// Where at least `BELONGS` of its difference is.
    pub places: Vec<usize>,
    /// Its difference, in CIELAB.
    pub contrast: f64,
    /// The same, in what is wanted by what its surroundings differ.
    pub clearness: f64,
    /// By which of regions over each other the clearest is taken.
    pub sharpness: f64,
    /// Of the region, in pixels of the map.
    pub radius: f64,
}

/// A window with the ring of surroundings in it.
struct Ring<'a> {
    map: &'a Map<'a>,
    window: Window,
    aside: f64,
    /// Numbers of places in the window.
    own: Vec<usize>,
    around: Vec<usize>,
    /// The region's middle, and what the ring reaches, in pixels.
    middle: (f64, f64),
    reach: f64,
    /// The share of the ring that is looked at.
    seen: f64,
}

/// What a region differs by, if it is closed, about round and sharp; whether it stands out is left open.
pub fn spot(map: &Map<'_>, region: &[usize]) -> Option<Spot> {
    let ring = Ring::around(map, region)?;
    let (course, rest) = ring.course()?;
    let differs: Vec<[f64; 3]> =
        (0..ring.window.places.len()).map(|at| ring.less(at, &course)).collect();
    let middle = [0, 1, 2]
        .map(|i| median(&mut ring.own.iter().map(|&at| differs[at][i]).collect::<Vec<f64>>()));
    let contrast = length(middle);
    let axis = clearest(&rest, middle)?;
    let along: Vec<f64> = differs.iter().map(|one| product(one, &axis)).collect();
    let own = product(&middle, &axis);
    let fall = ring.fall(&along, own)?;
    let belongs = |at: &usize| {
        let place = ring.window.places[*at];
        ring.window.away[*at] <= ring.aside && map.held[place] && along[*at] >= BELONGS * own
    };
    let places = (0..along.len()).filter(belongs).map(|at| ring.window.places[at]).collect();
    let clearness = own / ring.needed(&rest, &axis).max(1e-9);
    let radius = ring.radius();
    Some(Spot { places, contrast, clearness, sharpness: contrast * fall, radius })
}

/// What a spot of such places would have to differ by, in CIELAB and in the channel that tells it best; None where
/// none could be told.
pub fn needed(map: &Map<'_>, region: &[usize]) -> Option<f64> {
    let ring = Ring::around(map, region)?;
    let (_, rest) = ring.course()?;
    let in_channel = |channel: usize| {
        let mut difference = [0.0; 3];
        difference[channel] = 1.0;
        let axis = clearest(&rest, difference)?;
        Some(ring.needed(&rest, &axis) / axis[channel])
    };
    (0..3).filter_map(in_channel).min_by(f64::total_cmp)
}

impl<'a> Ring<'a> {
    /// None where the region is not round, lies at what is hidden, or has too little around it.
    fn around(map: &'a Map<'a>, region: &[usize]) -> Option<Self> {
        let step = (ASIDE * map.radius).round().max(1.0);
        let wide = (RING * map.radius).round().max(2.0);
        let height = map.held.len() / map.width;
        let window = Window::around(region, (step + wide) as usize + 1, map.width, height);
        let border = window.border as f64;
        if 4.0 * PI * (window.area as f64) < LEAST_ROUND * border * border {
            return None;
        }
        // Half a step more, for distances go from pixel to pixel.
        let aside = step + 0.3;
        let all = || 0..window.places.len();
        if all().any(|at| window.away[at] <= aside && map.hidden[window.places[at]]) {
            return None;
        }
        let beyond = |at: &usize| (aside..=aside + wide).contains(&window.away[*at]);
        let shell = all().filter(beyond).count();
        let around: Vec<usize> =
            all().filter(beyond).filter(|&at| map.held[window.places[at]]).collect();
        let seen = around.len() as f64 / shell.max(1) as f64;
        if seen < LEAST_SEEN || around.len() < 2 * TERMS {
            return None;
        }
        let own: Vec<usize> = all().filter(|&at| window.away[at] < 0.0).collect();
        let mean = |of: &dyn Fn(usize) -> usize| {
            own.iter().map(|&at| of(window.places[at]) as f64).sum::<f64>() / own.len() as f64
        };
        let middle = (mean(&|at| at % map.width), mean(&|at| at / map.width));
        let reach = sqrt(window.area as f64 / PI) + step + wide;
        Some(Self { map, window, aside, own, around, middle, reach, seen })
    }

    /// Of the region, in pixels of the map.
    fn radius(&self) -> f64 {
        sqrt(self.window.area as f64 / PI)
    }

    /// What a difference along an axis of colour must be to stand out of what is left of the surroundings.
    fn needed(&self, rest: &[[f64; 3]], axis: &[f64]) -> f64 {
        let doubt = self.seen < WHOLE || self.radius() < SMALL_PX;
        let wanted = if doubt { STANDS_OUT_IN_DOUBT } else { STANDS_OUT };
        let along: Vec<f64> = rest.iter().map(|one| product(one, axis)).collect();
        let usual = quantile(&mut along.iter().map(|one| fabs(*one)).collect::<Vec<f64>>(), USUAL);
        (wanted * usual).max(STANDS_OUT_OF_SECTORS * self.of_sectors(&along))
    }

    /// Where a place of the window lies from the region's middle, in reaches.
    fn offset(&self, at: usize) -> (f64, f64) {
        let place = self.window.places[at];
        let (x, y) = ((place % self.map.width) as f64, (place / self.map.width) as f64);
        ((x - self.middle.0) / self.reach, (y - self.middle.1) / self.reach)
    }

    fn terms(&self, at: usize) -> [f64; TERMS] {
        let (x, y) = self.offset(at);
        [1.0, x, y, x * x, x * y, y * y]
    }

    fn less(&self, at: usize, course: &Course) -> [f64; 3] {
        let terms = self.terms(at);
        let own = self.map.residual[self.window.places[at]];
        [0, 1, 2].map(|i| own[i] - product(&terms, &course[i]))
    }

    /// The course of the surroundings, robustly, and what is left of them.
    fn course(&self) -> Option<(Course, Vec<[f64; 3]>)> {
        let taken: Vec<usize> = self
            .around
            .iter()
            .copied()
            .step_by(self.around.len().div_ceil(ENOUGH).max(1))
            .collect();
        let mut weights = vec![1.0; taken.len()];
        let mut course = [Vec::new(), Vec::new(), Vec::new()];
        for _ in 0..3 {
            let mut matrix = vec![vec![0.0; TERMS]; TERMS];
            let mut sides = [vec![0.0; TERMS], vec![0.0; TERMS], vec![0.0; TERMS]];
            for (&at, weight) in taken.iter().zip(&weights) {
                let terms = self.terms(at);
                let light = self.map.residual[self.window.places[at]];
                for one in 0..TERMS {
                    for other in 0..TERMS {
                        matrix[one][other] += weight * terms[one] * terms[other];
                    }
                    for channel in 0..3 {
                        sides[channel][one] += weight * terms[one] * light[channel];
                    }
                }
            }
            let inverse = inverse(&matrix)?;
            course = sides.map(|side| times(&inverse, &side));
            let sizes: Vec<f64> = taken.iter().map(|&at| length(self.less(at, &course))).collect();
            let spread = median(&mut sizes.clone()).max(0.05);
            weights = sizes.iter().map(|size| 1.0 / (size / spread).max(1.0)).collect();
        }
        let rest = self.around.iter().map(|&at| self.less(at, &course)).collect();
        Some((course, rest))
    }

    /// What the means over sectors of the ring differ from its course.
    fn of_sectors(&self, rest: &[f64]) -> f64 {
        let mut sums = [(0.0, 0.0); SECTORS];
        for (&at, rest) in self.around.iter().zip(rest) {
            let (sum, count) = &mut sums[self.sector(at, SECTORS)];
            *sum += rest;
            *count += 1.0;
        }
        let held = sums.iter().filter(|(_, count)| *count > 2.0);
        let mut means: Vec<f64> = held.map(|(sum, count)| fabs(*sum) / count).collect();
        quantile(&mut means, USUAL)
    }

    fn sector(&self, at: usize, of: usize) -> usize {
        let (x, y) = self.offset(at);
        (((atan2(y, x) / TAU).rem_euclid(1.0) * of as f64) as usize).min(of - 1)
    }

    /// The share of the difference that is lost across the border; None where that is too little.
    fn fall(&self, along: &[f64], contrast: f64) -> Option<f64> {
        let depth = (self.radius() / 2.0).round().clamp(1.0, self.aside.floor());
        let within = |at: &&usize| (depth + 0.3..=depth + 1.5).contains(&-self.window.away[**at]);
        let mut inside: Vec<f64> = self.own.iter().filter(within).map(|&at| along[at]).collect();
        let mut own: Vec<f64> = self.own.iter().map(|&at| along[at]).collect();
        if inside.len() < 3 {
            let least = quantile(&mut own, 0.7);
            inside = own.iter().copied().filter(|one| *one >= least).collect();
        }
        let inside = inside.iter().sum::<f64>() / inside.len() as f64;
        let (mut sums, mut whole) = ([(0.0, 0.0); 8], (0.0, 0.0));
        for at in 0..along.len() {
            let near =
                self.window.away[at] > self.aside - 1.0 && self.window.away[at] <= self.aside;
            if near && self.window.away[at] > 0.0 && self.map.held[self.window.places[at]] {
                let sum = &mut sums[self.sector(at, 8)];
                *sum = (sum.0 + along[at], sum.1 + 1.0);
                whole = (whole.0 + along[at], whole.1 + 1.0);
            }
        }
        let most = quantile(&mut own, 0.9).max(contrast);
        let fall = (inside - whole.0 / whole.1) / most;
        let held = sums.iter().filter(|(_, count)| *count > 0.0);
        let least = held.map(|(sum, count)| (inside - sum / count) / contrast).fold(2.0, f64::min);
        (fall >= LEAST_FALL.0 && least >= LEAST_FALL.1).then_some(fall)
    }
}

/// The direction of colour, of length 1, in which a difference is clearest against what is left of its surroundings:
/// texture is lighter and darker, relief of another colour, or the other way round.
fn clearest(rest: &[[f64; 3]], difference: [f64; 3]) -> Option<Vec<f64>> {
    let mut scatter = vec![vec![0.0; 3]; 3];
    for one in rest {
        for (row, line) in scatter.iter_mut().enumerate() {
            for (column, sum) in line.iter_mut().enumerate() {
                *sum += one[row] * one[column] / rest.len() as f64;
            }
        }
    }
    for (at, line) in scatter.iter_mut().enumerate() {
        line[at] += FLOOR * FLOOR;
    }
    let axis = times(&inverse(&scatter)?, &difference);
    let size = sqrt(product(&axis, &axis));
    Some(axis.iter().map(|part| part / size).collect())
}

fn length([l, a, b]: [f64; 3]) -> f64 {
    sqrt(l * l + a * a + b * b)
}
