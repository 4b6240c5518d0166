//! Light that has been inside a pearl: enters through the film, wanders, leaves through the film.
//!
//! Waves on the sphere that fade as heat would **(ours)**, with the film's factors by Funk and Hecke.
//! Left out: the true paths of light in nacre and nucleus, and detail finer than degree 40.

use std::{f64::consts::PI, sync::Arc};

use glam::DVec3;
use multiversion::multiversion;
use nacreous_colour::matrix::apply;

use crate::{
    harmonics::{
        CHANNELS, Coefficients, Place, analyse, directions_of_grid, from_grid, knots, point,
        synthesise, to_grid,
    },
    light::bands::{BANDS, Bands},
    parallel,
    pearl::{
        beam::Beam,
        films::FilmAt,
        passage::{Passage, TOP_AROUND, row},
        response::Response,
        solid_light::{LEAST_ROWS, SolidLight, entering},
    },
    rgb::Rgb,
    surface::coating::legendre,
    surroundings::{lamp::Lamp, lit::Lit},
};

/// Light that has been inside, ready to be looked at.
///
/// Enters through the film, wanders over the ball as heat would **(ours)**, leaves through the film:
/// its colour in a direction depends on the angle to the normal by the film, on the place by the light.
#[derive(Debug, Clone)]
pub struct Subsurface {
    /// By direction of the normal, in rows: light about to leave, by band, and what would leave of it
    /// through a film without colour, in linear RGB.
    places: Vec<[f32; PLACE]>,
    rows: usize,
    passage: Arc<Passage>,
}

/// Rows from pole to pole, enough that lines between them miss waves up to degree `top` that fade as they wander
/// by less than half a step between 8-bit codes.
fn rows(top: usize) -> usize {
    match top {
        0..=12 => 32,
        13..=18 => 48,
        _ => 64,
    }
}

/// The bands, RGB and one number to fill the registers.
const PLACE: usize = BANDS + 4;

impl Subsurface {
    /// Lets the light of `surroundings`, whose lamps are those of `response`, into ball `ball`.
    pub fn of(response: &Response, surroundings: &Lit, ball: usize) -> Self {
        let centre = surroundings.balls[ball].centre;
        let beam = |(lamp, power): (&Lamp, &Bands)| Beam {
            direction: lamp.toward(centre),
            angular_radius_rad: lamp.angular_radius_rad(),
            // Neighbours shade the whole pearl as they shade its middle.
            power: power.map(|power| power * surroundings.lamp_past(lamp, centre, Some(ball))),
        };
        let beams: Vec<Beam> = surroundings.lamps.iter().zip(response.powers()).map(beam).collect();
        Self::new(response.passage(), surroundings, ball, &beams)
    }

    /// Lets in the light of `surroundings` around ball `ball`, and that of the lamps.
    fn new(passage: Arc<Passage>, surroundings: &Lit, ball: usize, beams: &[Beam]) -> Self {
        let solid = surroundings.solid(ball);
        let rows = match solid {
            None => rows(passage.top()),
            Some(_) => rows(passage.top()).max(LEAST_ROWS),
        };
        let outside = Outside::new((&passage, rows), surroundings, ball, beams);
        let light = solid.map(|solid| SolidLight::new(&passage, solid, rows));
        let hidden = |outward: DVec3, beam: &Beam| {
            let width_rad = 2.0 * beam.angular_radius_rad;
            surroundings.hidden_by_itself(ball, outward, beam.direction, width_rad)
        };
        let mut places = vec![[0.0_f32; PLACE]; 2 * rows * rows];
        let mut grid = vec![[0.0_f64; CHANNELS]; 2 * rows * rows];
        for first in (0..BANDS).step_by(CHANNELS) {
            let bands: [usize; CHANNELS] = std::array::from_fn(|i| (first + i).min(BANDS - 1));
            match &light {
                None => {
                    let waves = outside.waves(bands);
                    let size = (rows, 2 * rows);
                    synthesise(&waves, passage.top(), size, |texel| texel, &mut grid);
                }
                Some(light) => {
                    let around = entering(&passage, &outside.around, bands);
                    grid = light.leaving(bands, &around, beams, hidden);
                }
            }
            for (place, values) in places.iter_mut().zip(&grid) {
                for (value, band) in values.iter().zip(bands) {
                    // A cut-off sum of waves swings below zero beside a lamp's terminator.
                    place[band] = value.max(0.0) as f32;
                }
            }
        }
        for place in &mut places {
            let plain = dots(passage.leaving_plain(), place);
            place[BANDS..BANDS + 3].copy_from_slice(&plain);
        }
        Self { places, rows, passage }
    }

    /// Linear RGB of the light that leaves at a place, at an angle to its normal, through a film, and what it
    /// would be if the film let through the same everywhere.
    pub(crate) fn radiance(&self, outward: DVec3, cos_view: f64, film: FilmAt) -> (Rgb, Rgb) {
        let light = self.light(Place::towards(to_grid(outward)));
        let at = row(cos_view);
        let whole = self
            .passage
            .leaving()
            .between(film, |leaving| dots(&leaving[at], &light).map(f64::from));
        (whole, [0, 1, 2].map(|channel| f64::from(light[BANDS + channel])))
    }

    /// The second of these alone, in a direction from the middle.
    pub(crate) fn plain(&self, outward: DVec3) -> Rgb {
        let light = self.light(Place::towards(to_grid(outward)));
        [0, 1, 2].map(|channel| f64::from(light[BANDS + channel]))
    }

    /// Between the four nearest places.
    #[inline]
    fn light(&self, place: Place) -> [f32; PLACE] {
        let mut sum = [0.0; PLACE];
        for (knot, share) in knots(self.rows, place) {
            for (sum, value) in sum.iter_mut().zip(&self.places[knot]) {
                *sum += share * value;
            }
        }
        sum
    }
}

/// What a place's bands come to in three channels.
#[multiversion(targets("x86_64+avx2"))]
fn dots(weights: &[[f32; BANDS]; 3], place: &[f32; PLACE]) -> [f32; 3] {
    let mut sums = [[0.0_f32; 8]; 3];
    for first in (0..BANDS).step_by(8) {
        for channel in 0..3 {
            for lane in 0..8 {
                sums[channel][lane] += weights[channel][first + lane] * place[first + lane];
            }
        }
    }
    let mut wholes = [0.0; 3];
    for channel in 0..3 {
        wholes[channel] = sums[channel][0];
        for lane in 1..8 {
            wholes[channel] += sums[channel][lane];
        }
    }
    wholes
}

/// The light around a pearl in waves on the sphere of directions, before it enters.
struct Outside<'a> {
    passage: &'a Passage,
    /// As amounts of the palette's curves.
    around: Coefficients,
    beams: &'a [Beam],
    /// Unit light from each lamp's direction.
    lamps: Vec<Coefficients>,
}

impl<'a> Outside<'a> {
    fn new(
        (passage, rows): (&'a Passage, usize),
        surroundings: &Lit,
        ball: usize,
        beams: &'a [Beam],
    ) -> Self {
        let unit = |beam: &Beam| point(to_grid(beam.direction), passage.top());
        let top = surroundings.solid(ball).map_or(passage.top(), |_| TOP_AROUND);
        let around = around((passage, rows, top), surroundings, ball);
        Self { passage, around, beams, lamps: beams.iter().map(unit).collect() }
    }

    /// The waves of some bands when they are about to leave.
    fn waves(&self, bands: [usize; CHANNELS]) -> Coefficients {
        let top = self.passage.top();
        let mut waves = Coefficients::zero(top);
        for l in 0..=top {
            let shares = bands.map(|band| self.passage.share(l)[band]);
            for m in 0..=l {
                *waves.at_mut(l, m) = std::array::from_fn(|channel| {
                    self.wave((l, m), bands[channel]).map(|part| part * shares[channel])
                });
            }
        }
        waves
    }

    /// One wave of one band.
    fn wave(&self, (l, m): (usize, usize), band: usize) -> [f64; 2] {
        let amounts = self.around.at(l, m);
        let curves = self.passage.palette().curves_of_white(band);
        let mut sum = [0, 1].map(|part| (0..3).map(|i| curves[i] * amounts[i][part]).sum::<f64>());
        for (beam, lamp) in self.beams.iter().zip(&self.lamps) {
            // Unit light on a surface that faces it is pi of radiance times solid angle.
            let factor = PI * beam.power[band] * disc(beam.angular_radius_rad, l);
            for (sum, part) in sum.iter_mut().zip(lamp.at(l, m)[0]) {
                *sum += factor * part;
            }
        }
        sum
    }
}

/// The light around in waves, as amounts of the palette's curves.
fn around(
    (passage, rows, top): (&Passage, usize, usize),
    surroundings: &Lit,
    ball: usize,
) -> Coefficients {
    let step_rad = PI / rows as f64;
    let directions: Vec<DVec3> =
        directions_of_grid(rows).map(|(direction, _)| from_grid(direction)).collect();
    let amounts = |seen: Rgb| apply(passage.palette().amounts(), seen);
    let values = parallel::map(directions.len(), |i| {
        amounts(surroundings.seen_without_windows(ball, directions[i], step_rad))
    });
    let mut waves = analyse(rows, &values, top);
    for (along, solid_angle, more) in surroundings.window_points(ball) {
        let amounts = amounts(more).map(|amount| amount * solid_angle);
        waves.add(&point(to_grid(along), top), amounts);
    }
    waves
}

/// What a disc of an angular radius leaves of a wave of degree l, against a point.
fn disc(radius_rad: f64, l: usize) -> f64 {
    let cosine = libm::cos(radius_rad);
    if l == 0 || 1.0 - cosine < 1e-9 {
        return 1.0;
    }
    let mut two = legendre(cosine).skip(l - 1).step_by(2);
    let (below, above) = (two.next().unwrap_or(1.0), two.next().unwrap_or(1.0));
    (below - above) / ((2 * l + 1) as f64 * (1.0 - cosine))
}
