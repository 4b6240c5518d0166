//! The stretch of a line across a pixel on which a ball is seen.
//!
//! The square of the view angle's cosine as a parabola through three places.
//! Left out: perspective within a pixel, which bends the parabola by less than its width over the eye's distance.

use crate::picture::tent::share_left_of;

/// So many parts of a piece are weighed for its mean.
const PARTS: usize = 4;

/// A ball along a line across a pixel; places are in pixels from the pixel's middle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Chord {
    /// Coefficients of the square of the cosine of the view angle.
    square: [f64; 3],
    /// Where the line meets the silhouette.
    pub(crate) from: f64,
    pub(crate) to: f64,
}

/// A piece of a chord that one sample stands for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    /// Its share of the line, by the tent.
    pub(crate) share: f64,
    /// Where the sample is taken.
    pub(crate) place: f64,
    /// Standard deviation of the cosine of the view angle over the piece.
    pub(crate) cosine_spread: f64,
}

impl Chord {
    /// `square_at` gives the square of the cosine of the view angle at a place, below 0 beside the ball.
    pub(crate) fn new(square_at: impl Fn(f64) -> f64) -> Option<Self> {
        let [left, middle, right] = [-1.0, 0.0, 1.0].map(square_at);
        let slope = 0.5 * (right - left);
        // A chord is one piece, however little the parabola is bent.
        let bend = (0.5 * (right + left) - middle).min(-1e-12);
        let root = slope * slope - 4.0 * bend * middle;
        if root <= 0.0 {
            return None;
        }
        let sum = -0.5 * (slope + root.sqrt().copysign(slope));
        let ends = [sum / bend, middle / sum];
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        (from < 1.0 && to > -1.0).then_some(Self { square: [middle, slope, bend], from, to })
    }

    /// Where the line passes nearest to the ball's middle.
    pub(crate) fn middle(&self) -> f64 {
        0.5 * (self.from + self.to)
    }

    /// Cuts the stretch between two places, on one side of the middle, into pieces over which the mirrored ray turns by
    /// the same angle. The sample of each shows the mean of that angle.
    pub(crate) fn pieces(self, from: f64, to: f64, count: usize) -> impl Iterator<Item = Piece> {
        let (first, last) = (self.cosine(from), self.cosine(to));
        let change = last * last - first * first;
        // The cosine's square changes evenly along the line.
        let place = move |part: f64| {
            let cosine = first + (last - first) * part;
            let even = change.abs() < 1e-12;
            let part = if even { part } else { (cosine * cosine - first * first) / change };
            from + (to - from) * part.clamp(0.0, 1.0)
        };
        (0..count).map(move |i| {
            let ends = [i, i + 1].map(|i| place(i as f64 / count as f64));
            self.piece(ends)
        })
    }

    fn piece(self, [from, to]: [f64; 2]) -> Piece {
        let (mut share, mut sum, mut squares, mut at) = (0.0, 0.0, 0.0, 0.0);
        let step = (to - from) / PARTS as f64;
        for part in 0..PARTS {
            let left = from + step * part as f64;
            let middle = left + 0.5 * step;
            let weight = share_left_of(left + step) - share_left_of(left);
            let cosine = self.cosine(middle);
            share += weight;
            sum += weight * cosine;
            squares += weight * cosine * cosine;
            at += weight * middle;
        }
        let mean = sum / share;
        let cosine_spread = (squares / share - mean * mean).max(0.0).sqrt();
        Piece { share, place: self.place_of(mean, [from, to]).unwrap_or(at / share), cosine_spread }
    }

    /// Where in a piece the cosine has a value.
    fn place_of(&self, cosine: f64, [from, to]: [f64; 2]) -> Option<f64> {
        let (first, last) = (self.cosine(from), self.cosine(to));
        let part = (cosine * cosine - first * first) / (last * last - first * first);
        (0.0..=1.0).contains(&part).then_some(from + (to - from) * part)
    }

    fn cosine(&self, x: f64) -> f64 {
        let [middle, slope, bend] = self.square;
        (middle + x * (slope + x * bend)).max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball of some radius in pixels whose middle lies aside, along a line that passes at a height.
    fn chord(radius: f64, aside: f64, height: f64) -> Option<Chord> {
        Chord::new(|x| 1.0 - ((x - aside).powi(2) + height * height) / (radius * radius))
    }

    #[test]
    fn a_chord_of_a_circle_ends_on_it() {
        for (radius, aside, height) in [(40.0, 40.2, 3.0), (0.4, 0.1, 0.2), (7.0, -6.9, 0.0)] {
            let chord = chord(radius, aside, height).unwrap();
            let half = (radius * radius - height * height).sqrt();
            assert!((chord.from - (aside - half)).abs() < 1e-9, "{chord:?}");
            assert!((chord.to - (aside + half)).abs() < 1e-9, "{chord:?}");
        }
        assert!(chord(5.0, 0.0, 5.1).is_none() && chord(5.0, 8.0, 0.0).is_none());
    }

    #[test]
    fn pieces_make_up_the_stretch_and_its_mean_cosine() {
        let chord = chord(30.0, 29.5, 4.0).unwrap();
        let (from, to) = (chord.from.max(-1.0), 1.0);
        let pieces: Vec<Piece> = chord.pieces(from, to, 5).collect();
        let share: f64 = pieces.iter().map(|piece| piece.share).sum();
        assert!((share - (share_left_of(to) - share_left_of(from))).abs() < 1e-12);
        let seen = |x| chord.cosine(x);
        let mean: f64 = pieces.iter().map(|piece| piece.share * seen(piece.place)).sum();
        let step = (to - from) / 1e5;
        let places = (0..100_000).map(|i| from + step * (f64::from(i) + 0.5));
        let exact: f64 = places.map(|x| seen(x) * (1.0 - x.abs()) * step).sum();
        assert!((mean / exact - 1.0).abs() < 2e-3, "{mean} {exact}");
    }
}
