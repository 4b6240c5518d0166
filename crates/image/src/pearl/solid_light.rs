//! Light inside a pearl that is not round, about to leave: by place, where a ball's is by normal.
//!
//! Light enters by the normal and past the pearl's own bulges. It wanders over the directions from the middle as in a ball;
//! weights on the places (Sinkhorn 1964) make that even again: as much leaves as enters, both ways between two places alike.
//! Left out: that the way is shorter through a thin part, and which part of a bulge hides a window.

use glam::DVec3;

use crate::{
    harmonics::{
        CHANNELS, Coefficients, Place, analyse, directions_of_grid, from_grid, knots, synthesise,
        to_grid,
    },
    light::bands::Bands,
    parallel,
    pearl::{
        beam::Beam,
        passage::{Passage, TOP_AROUND, row},
    },
    shape::solid::Solid,
};

/// The places of a solid on a grid, and how light wanders between them.
pub(crate) struct SolidLight<'a> {
    passage: &'a Passage,
    rows: usize,
    spots: Vec<Spot>,
}

/// A spot of a solid's surface.
#[derive(Debug, Clone, Copy)]
struct Spot {
    outward: DVec3,
    normal: DVec3,
    /// Its area over the solid angle that it fills.
    area: f64,
    /// Share of the light around that the pearl itself leaves it.
    open: f64,
    /// Its weight.
    weight: f64,
}

/// After so many steps the weights are right to 1e-4 for a pearl of twice the length of its width.
const WEIGHT_STEPS: usize = 12;

impl<'a> SolidLight<'a> {
    /// Of a solid on a grid of `rows` rows.
    pub(crate) fn new(passage: &'a Passage, solid: &Solid, rows: usize) -> Self {
        let directions: Vec<DVec3> =
            directions_of_grid(rows).map(|(direction, _)| from_grid(direction)).collect();
        let place = |i: usize| {
            let outward = directions[i];
            let open = solid.horizon().map_or(1.0, |horizon| horizon.open(solid.own(outward)));
            let (_, normal) = solid.surface(outward);
            Spot { outward, normal, area: solid.area_per_angle(outward), open, weight: 1.0 }
        };
        let mut light = Self { passage, rows, spots: parallel::map(directions.len(), place) };
        for _ in 0..WEIGHT_STEPS {
            let spread = light.wandered(|place| [place.weight * place.area; CHANNELS]);
            for (place, spread) in light.spots.iter_mut().zip(spread) {
                place.weight = (place.weight / spread[0].max(LEAST)).sqrt();
            }
        }
        light
    }

    /// Some bands' light at each place when it is about to leave. `around` holds the waves of the light around as the
    /// surface lets it in, by normal; `hidden` says what the pearl hides from a place of a beam.
    pub(crate) fn leaving(
        &self,
        bands: [usize; CHANNELS],
        around: &Coefficients,
        beams: &[Beam],
        hidden: impl Fn(DVec3, &Beam) -> f64 + Sync,
    ) -> Vec<[f64; CHANNELS]> {
        let by_normal = self.synthesised(around);
        let entered = parallel::map(self.spots.len(), |i| {
            let place = &self.spots[i];
            let mut light = self.between(&by_normal, place.normal).map(|light| light * place.open);
            for beam in beams {
                let cosine = place.normal.dot(beam.direction);
                if cosine > 0.0 {
                    let past = cosine * (1.0 - hidden(place.outward, beam));
                    let enters = &self.passage.entering()[row(cosine)];
                    for (light, band) in light.iter_mut().zip(bands) {
                        *light += beam.power[band] * enters[band] * past;
                    }
                }
            }
            // What it sees of itself is as bright as it is: its own light again and again.
            let returned = bands.map(|band| (1.0 - place.open) * self.passage.albedo()[band]);
            std::array::from_fn::<f64, CHANNELS, _>(|i| light[i].max(0.0) / (1.0 - returned[i]))
        });
        let spread = self
            .wandered_each(|i, place| entered[i].map(|light| light * place.weight * place.area));
        let leaving = |(spread, place): ([f64; CHANNELS], &Spot)| {
            std::array::from_fn(|i| {
                spread[i] * place.weight * self.passage.leaving_evenly()[bands[i]]
            })
        };
        spread.into_iter().zip(&self.spots).map(leaving).collect()
    }

    fn wandered(&self, value: impl Fn(&Spot) -> [f64; CHANNELS]) -> Vec<[f64; CHANNELS]> {
        self.wandered_each(|_, place| value(place))
    }

    /// Values at the places after they wandered as heat would.
    fn wandered_each(
        &self,
        value: impl Fn(usize, &Spot) -> [f64; CHANNELS],
    ) -> Vec<[f64; CHANNELS]> {
        let values: Vec<[f64; CHANNELS]> =
            self.spots.iter().enumerate().map(|(i, place)| value(i, place)).collect();
        let top = self.passage.top();
        let mut waves = analyse(self.rows, &values, top);
        for l in 0..=top {
            let fading = self.passage.fading(l);
            for m in 0..=l {
                let wave = waves.at_mut(l, m);
                *wave = wave.map(|parts| parts.map(|part| part * fading));
            }
        }
        self.synthesised(&waves)
    }

    fn synthesised(&self, waves: &Coefficients) -> Vec<[f64; CHANNELS]> {
        let rows = self.rows;
        let mut grid = vec![[0.0; CHANNELS]; 2 * rows * rows];
        synthesise(waves, waves.band_limit(), (rows, 2 * rows), |texel| texel, &mut grid);
        grid
    }

    /// A field of the grid in a direction of the scene, between its four nearest knots.
    fn between(&self, grid: &[[f64; CHANNELS]], direction: DVec3) -> [f64; CHANNELS] {
        let mut sum = [0.0; CHANNELS];
        for (knot, share) in knots(self.rows, Place::towards(to_grid(direction))) {
            for (sum, value) in sum.iter_mut().zip(grid[knot]) {
                *sum += value * f64::from(share);
            }
        }
        sum
    }
}

/// Keeps weights finite where a cut-off sum of waves swings to nothing.
const LEAST: f64 = 1e-3;

/// The waves of light that enters, of some bands: amounts of the palette's curves by wave, as the surface lets them in.
pub(crate) fn entering(
    passage: &Passage,
    around: &Coefficients,
    bands: [usize; CHANNELS],
) -> Coefficients {
    let top = around.band_limit();
    let curves = bands.map(|band| passage.palette().curves_of_white(band));
    let moments: &[Bands] = passage.entering_moments();
    let mut waves = Coefficients::zero(top);
    for l in 0..=top {
        for m in 0..=l {
            let amounts = around.at(l, m);
            *waves.at_mut(l, m) = std::array::from_fn(|channel| {
                let enters = moments[l][bands[channel]];
                [0, 1].map(|part| {
                    enters * (0..3).map(|i| curves[channel][i] * amounts[i][part]).sum::<f64>()
                })
            });
        }
    }
    waves
}

/// Rows of a grid that holds the light around.
pub(crate) const LEAST_ROWS: usize = 2 * TOP_AROUND;
