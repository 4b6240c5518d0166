//! A pixel that the rim of a pearl crosses.
//!
//! Line samples (Jones and Perry 2000): what each ball covers of a line across the pixel is exact.
//! Left out: edges that are no pearl's, which are seen as sharply as samples lie.

use crate::{
    pearl::{model::Model, sight::Spread},
    picture::{
        chord::{Chord, Piece},
        sampler::Sampler,
        tent::{place, share_left_of, tent_of_full_width},
        view::View,
    },
    view::ray::Ray,
};

/// Directions that a sample mirrors to the eye, over the standard deviation of the view angle's cosine: the ray
/// turns by twice its angle, and an even cone is four standard deviations wide.
const FULL_ANGLE: f64 = 8.0;

/// What a line stands for, over the mean distance of lines, which lie two pixels wide.
const BETWEEN: f64 = 2.0;

/// So many times the lines where a pearl mirrors the edge of a window **(ours)**.
const AT_EDGES: f64 = 1.5;

/// The stretch of a line between two edges.
struct Stretch<'a> {
    from: f64,
    to: f64,
    /// What is seen there of balls, the nearest: its place in the view, and its chord.
    ball: Option<(usize, &'a Chord)>,
}

impl Sampler {
    /// Lines across the pixel, each cut where it meets a silhouette. At the rim the ray that a pearl mirrors turns the faster the
    /// nearer it is: by samples over even parts of its turn each stands for directions that lie together.
    pub(super) fn lines(&self, at: (usize, usize), view: &mut View) {
        let middle = self.ray(at, 0.0, 0.0);
        let edges = |&ball: &usize| self.shows(ball, &middle, Model::has_sharp_edges);
        let more = if view.balls.iter().any(edges) { AT_EDGES } else { 1.0 };
        let lines = (self.samples_side().max(2) as f64 * more) as usize;
        let width_px = BETWEEN / lines as f64;
        view.passes.clear();
        view.passes
            .extend(view.balls.iter().map(|&ball| self.surroundings.nearest_pass(ball, &middle)));
        let upright = self.is_upright(at, view);
        for (line, across) in tent_of_full_width(lines).into_iter().enumerate() {
            // Each line begins with other facets, so that none are always looked at next to the rim.
            let mut part = line * lines;
            let ray_at = |along: f64| {
                let (down, aside) = if upright { (along, across) } else { (across, along) };
                self.ray(at, down, aside)
            };
            let chords = self.chords(view, ray_at);
            for stretch in self.stretches(&chords, view, ray_at) {
                let (left, right) = (share_left_of(stretch.from), share_left_of(stretch.to));
                let count = ((right - left) * lines as f64).ceil() as usize;
                if let Some((place, chord)) = stretch.ball {
                    for piece in chord.pieces(stretch.from, stretch.to, count) {
                        let ray = ray_at(piece.place);
                        self.piece(&ray, place, &piece, (lines, (part, lines * lines)), view);
                        part += 1;
                    }
                } else {
                    let step = (right - left) / count as f64;
                    for i in 0..count {
                        let ray = ray_at(place(left + step * (i as f64 + 0.5)));
                        self.behind(&ray, step / lines as f64, width_px, view);
                    }
                }
            }
        }
    }

    /// Adds what a piece of a line shows of a ball.
    fn piece(
        &self,
        ray: &Ray,
        place: usize,
        piece: &Piece,
        (lines, part): (usize, (usize, usize)),
        view: &mut View,
    ) {
        let ball = view.balls[place];
        let hit = self.surroundings.nearest(ball, ray);
        let width =
            BETWEEN / lines as f64 * self.pixel_mm[ball] / self.surroundings.balls[ball].radius_mm;
        let bend = self.surroundings.bend(ball, &hit, -ray.along);
        let spread = Spread {
            // Next to the rim the square of the cosine grows as fast as the surface is bent.
            outward_rad: FULL_ANGLE * piece.cosine_spread * bend[0].sqrt(),
            ..Spread::of_bent(width, hit.cos_view, bend)
        };
        let weight = piece.share / lines as f64;
        let sight = self.sight((ball, hit), -ray.along, spread, part);
        let shade = self.pearls[ball].shade(&self.surroundings, &sight);
        view.parts[place].add(&shade, weight);
    }

    /// Whether lines upright cross the nearest rim more steeply than level ones.
    fn is_upright(&self, at: (usize, usize), view: &View) -> bool {
        let square = |(ball, pass): (usize, f64), down, aside| {
            self.surroundings.view_square(ball, &self.ray(at, down, aside), pass)
        };
        let middle = |seen: &(usize, f64)| square(*seen, 0.0, 0.0).abs();
        let seen = view.balls.iter().copied().zip(view.passes.iter().copied());
        let nearest = seen.min_by(|a, b| middle(a).total_cmp(&middle(b)));
        nearest.is_some_and(|ball| {
            let across = |down, aside| square(ball, down, aside) - square(ball, -down, -aside);
            across(1.0, 0.0).abs() > across(0.0, 1.0).abs()
        })
    }

    /// The balls that a line meets, by place in the view.
    fn chords(&self, view: &View, ray_at: impl Fn(f64) -> Ray) -> Vec<(usize, Chord)> {
        let chord = |(place, &ball): (usize, &usize)| {
            let pass = view.passes[place];
            let chord = Chord::new(|x| self.surroundings.view_square(ball, &ray_at(x), pass))?;
            let is_ahead = self.surroundings.balls[ball].is_ahead(&ray_at(0.0));
            is_ahead.then_some((place, chord))
        };
        view.balls.iter().enumerate().filter_map(chord).collect()
    }

    /// A line in stretches, each of one ball or of what lies behind them all.
    fn stretches<'a>(
        &self,
        chords: &'a [(usize, Chord)],
        view: &View,
        ray_at: impl Fn(f64) -> Ray,
    ) -> Vec<Stretch<'a>> {
        let mut cuts = vec![-1.0, 1.0];
        cuts.extend(chords.iter().flat_map(|(_, chord)| [chord.from, chord.middle(), chord.to]));
        cuts.retain(|x| (-1.0..=1.0).contains(x));
        cuts.sort_by(f64::total_cmp);
        let stretch = |ends: &[f64]| {
            let (from, to) = (ends[0], ends[1]);
            let middle = 0.5 * (from + to);
            let ray = ray_at(middle);
            let far_mm = |(place, _): &(usize, &Chord)| {
                let hit = self.surroundings.nearest(view.balls[*place], &ray);
                hit.point.distance_squared(ray.from)
            };
            let covering = chords.iter().filter(|(_, c)| c.from < middle && middle < c.to);
            let ball = covering
                .map(|(place, chord)| (*place, chord))
                .min_by(|a, b| far_mm(a).total_cmp(&far_mm(b)));
            Stretch { from, to, ball }
        };
        let long = |ends: &&[f64]| ends[1] - ends[0] > 1e-9;
        cuts.windows(2).filter(long).map(stretch).collect()
    }
}
