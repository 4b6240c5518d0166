//! The side of a ball that is seen, as a map on which its area is true, always drawn to the same scale: what a picture's
//! pixels are does not matter to it.

use libm::{exp, floor, sqrt};

use crate::contour::Contour;
use crate::highlight::Highlight;
use crate::white::{White, lab};
use crate::{Circle, Picture};

/// Places of the map to a radian of the ball, at its middle.
pub const SCALE: f64 = 64.0;
/// Out to here, in radii as seen, the pearl is looked at: nearer to the rim, spots are seen too obliquely; and out to here
/// surroundings are.
const LOOKED: f64 = 0.85;
const HELD: f64 = 0.96;
/// Places from the map's middle to its border: `HELD` is at 1.2 radians' chord.
const HALF: usize = 78;
/// Places in a row.
pub const WIDTH: usize = 2 * HALF + 1;
/// Light is averaged by a Gaussian of this standard deviation, in radii as seen, at places so many to a radius **(ours)**.
const BLUR: f64 = 0.025;
const GRID: usize = 64;
/// Larger pearls are made smaller, in whole pixels, to this radius at the most.
const MOST_PX: f64 = 256.0;
/// What is left out around the lamp's image: half-widths, and degrees of the normal.
const CLEAR: (f64, f64) = (1.6, 8.0);
/// A place of which more than this is clipped is not looked at.
const CLIPPED: f64 = 0.05;
/// What a difference of a* or b* counts, in those of L*: JPEG keeps an eighth of colour's detail **(ours)**.
pub const COLOUR: f64 = 0.3;

/// The map, by Lambert's azimuthal projection; [row, column].
pub struct Face {
    /// L*, and a*, b* times `COLOUR`.
    pub lab: Vec<[f64; 3]>,
    /// What is looked at, and what counts as surroundings.
    pub looked: Vec<bool>,
    pub held: Vec<bool>,
    /// The ball in the picture.
    circle: Circle,
}

impl Face {
    pub fn of(
        picture: &Picture<'_>,
        white: &White,
        contour: &Contour,
        clipped_at: f64,
        highlight: Option<Highlight>,
    ) -> Self {
        let circle = contour.middle;
        let grid = sampled(picture, &circle, clipped_at);
        let colours: Vec<[f64; 4]> = grid
            .iter()
            .map(|&[r, g, b, clipped]| {
                let [l, a, b] = lab(white.xyz([r, g, b]));
                [l, COLOUR * a, COLOUR * b, clipped]
            })
            .collect();
        let share = contour.share();
        let count = WIDTH * WIDTH;
        let (mut colour, mut looked, mut held) =
            (vec![[0.0; 3]; count], vec![false; count], vec![false; count]);
        for at in 0..count {
            let Some(normal) = normal(offset(at)) else { continue };
            let (x, y) = circle.place(normal);
            let away = share(x, y);
            if away >= HELD {
                continue;
            }
            let [l, a, b, clipped] = between(&colours, normal);
            let lamp = highlight.is_some_and(|lamp| lamp.covers(&circle, (x, y), CLEAR.0, CLEAR.1));
            colour[at] = [l, a, b];
            held[at] = !lamp && clipped <= CLIPPED;
            looked[at] = held[at] && away < LOOKED;
        }
        Self { lab: colour, looked, held, circle }
    }

    /// The circle in the picture of so many places around one.
    pub fn seen(&self, (right, down): (f64, f64), count: f64) -> Circle {
        let normal = normal((right, down)).unwrap_or([0.0, 0.0, 1.0]);
        let (x_px, y_px) = self.circle.place(normal);
        let radius = sqrt(count / std::f64::consts::PI) / SCALE;
        Circle { x_px, y_px, radius_px: radius * self.circle.radius_px }
    }
}

/// Where a place of the map lies from its middle, in radians at the middle.
pub fn offset(at: usize) -> (f64, f64) {
    let along = |place: usize| (place as f64 - HALF as f64) / SCALE;
    (along(at % WIDTH), along(at / WIDTH))
}

/// The normal there; None beyond the half of the ball that is seen.
fn normal((right, down): (f64, f64)) -> Option<[f64; 3]> {
    let square = right * right + down * down;
    let flat = sqrt((1.0 - square / 4.0).max(0.0));
    (square < 2.0).then_some([right * flat, down * flat, 1.0 - square / 2.0])
}

/// The grid's colour between its places, where a normal is seen.
fn between(grid: &[[f64; 4]], [right, down, _]: [f64; 3]) -> [f64; 4] {
    let place = |share: f64| (share + 1.0) * GRID as f64;
    let (x, y) = (place(right), place(down));
    let (left, top) = (floor(x), floor(y));
    let (right, down) = (x - left, y - top);
    let row = 2 * GRID + 1;
    let first = top as usize * row + left as usize;
    [0, 1, 2, 3].map(|i| {
        let line = |at: usize| (1.0 - right) * grid[at][i] + right * grid[at + 1][i];
        (1.0 - down) * line(first) + down * line(first + row)
    })
}

/// The Gaussian's means of linear RGB, and of what is clipped, on a square grid over the circle.
fn sampled(picture: &Picture<'_>, circle: &Circle, clipped_at: f64) -> Vec<[f64; 4]> {
    let factor = (circle.radius_px / MOST_PX).ceil().max(1.0);
    let reach = circle.radius_px * (1.0 + 4.0 * BLUR) / factor;
    let part = |middle: f64, side: usize| {
        let most = side / factor as usize;
        let first = floor(middle / factor - reach).max(0.0) as usize;
        first..((middle / factor + reach).ceil() as usize).min(most)
    };
    let (columns, rows) = (part(circle.x_px, picture.width()), part(circle.y_px, picture.height()));
    let kernel = |middle: f64, pixels: &std::ops::Range<usize>| {
        let place = |step: usize| (step as f64 / GRID as f64 - 1.0) * circle.radius_px + middle;
        let spread = BLUR * circle.radius_px / factor;
        (0..=2 * GRID)
            .map(|step| Shares::around(place(step) / factor - 0.5, spread, pixels))
            .collect::<Vec<_>>()
    };
    let (across, along) = (kernel(circle.x_px, &columns), kernel(circle.y_px, &rows));
    let small = picture.reduced_part(factor as usize, columns.clone(), rows);
    let light: Vec<[f64; 4]> = small
        .light
        .iter()
        .map(|&[r, g, b]| {
            let clipped = [r, g, b].iter().any(|&channel| channel >= clipped_at);
            [r, g, b, f64::from(u8::from(clipped))]
        })
        .collect();
    let lines: Vec<[f64; 4]> = light
        .chunks_exact(columns.len())
        .flat_map(|line| across.iter().map(|shares| shares.mean(|at| line[at])))
        .collect();
    along
        .iter()
        .flat_map(|shares| {
            (0..across.len()).map(|column| shares.mean(|at| lines[at * across.len() + column]))
        })
        .collect()
}

/// What each of some pixels in a line counts.
struct Shares {
    first: usize,
    shares: Vec<f64>,
}

impl Shares {
    /// By a Gaussian about a place; pixels are numbered from the range's first.
    fn around(place: f64, spread: f64, pixels: &std::ops::Range<usize>) -> Self {
        let reach = 3.5 * spread + 1.0;
        let last = pixels.end as f64 - 1.0;
        let first = (place - reach).ceil().clamp(pixels.start as f64, last) as usize;
        let last = floor(place + reach).clamp(first as f64, last) as usize;
        let mut shares: Vec<f64> = (first..=last)
            .map(|at| {
                let away = (at as f64 - place) / spread;
                exp(-0.5 * away * away)
            })
            .collect();
        let sum: f64 = shares.iter().sum();
        for share in &mut shares {
            *share /= sum;
        }
        Self { first: first - pixels.start, shares }
    }

    fn mean(&self, of: impl Fn(usize) -> [f64; 4]) -> [f64; 4] {
        let mut mean = [0.0; 4];
        for (at, share) in self.shares.iter().enumerate() {
            let own = of(self.first + at);
            mean = [0, 1, 2, 3].map(|i| mean[i] + share * own[i]);
        }
        mean
    }
}

/// How much of the half of the ball that is seen a number of places is.
pub fn share_of_half(count: usize) -> f64 {
    count as f64 / (SCALE * SCALE) / std::f64::consts::TAU
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_map_has_the_area_of_the_ball() {
        let turn = 1.0_f64;
        let cap = (0..WIDTH * WIDTH)
            .filter_map(|at| normal(offset(at)))
            .filter(|normal| normal[2] > libm::cos(turn))
            .count();
        assert!((share_of_half(cap) - (1.0 - libm::cos(turn))).abs() < 2e-3);
        let [right, _, _] = normal((2.0 * libm::sin(turn / 2.0), 0.0)).unwrap();
        assert!((right - libm::sin(turn)).abs() < 1e-12);
    }
}
