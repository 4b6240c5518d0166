//! Where a pearl hides itself: how high its own surface stands above each place, by azimuth.
//!
//! Horizon maps (Max 1988) over the sphere of directions, each place with axes of its own.
//! Left out: grooves finer than the map, and light that comes through below an overhang, which no form has.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::{
    harmonics::{Place, directions_of_grid, knots},
    parallel,
    shape::form::Form,
};

/// The horizon above each place of a form.
#[derive(Debug)]
pub(crate) struct Horizon {
    spots: Vec<Spot>,
}

/// What a place sees of its own pearl.
#[derive(Debug, Clone, Copy)]
struct Spot {
    normal: DVec3,
    across: [DVec3; 2],
    /// Sine of the horizon's elevation by azimuth; 0 where nothing rises.
    rise: [f32; AZIMUTHS],
    highest: f32,
}

/// Rows from pole to pole, and twice as many columns.
const ROWS: usize = 40;
const AZIMUTHS: usize = 16;
/// Steps of the walk away from a place: from the first to the last, over half of the pearl's width.
const WALK: usize = 16;
const WALK_FROM: f64 = 0.04;
const WALK_TO: f64 = 2.5;
/// A horizon lower than this is that of a bulge between two steps, and none.
const LOWEST: f32 = 0.015;
/// An edge of a shadow is at least this wide, in sines of elevation: the map is no finer **(ours)**.
const EDGE: f64 = 0.1;

impl Horizon {
    /// Of a form; `None` where it hides itself nowhere.
    pub(crate) fn of(form: &Form) -> Option<Self> {
        let towards: Vec<DVec3> = directions_of_grid(ROWS).map(|(towards, _)| towards).collect();
        let spots = parallel::map(towards.len(), |i| Spot::of(form, towards[i]));
        spots.iter().any(|place| place.highest > 0.0).then_some(Self { spots })
    }

    /// The share of light towards a direction, `width` wide as a sine, that the pearl itself hides from a place; place and
    /// direction as the form has them.
    pub(crate) fn hidden(&self, place: DVec3, along: DVec3, width: f64) -> f64 {
        self.between(place, |place| place.hidden(along, width.max(EDGE)))
    }

    /// The share of the light on a matt surface that the pearl leaves it, from an even sky all around.
    pub(crate) fn open(&self, place: DVec3) -> f64 {
        self.between(place, Spot::open)
    }

    /// Between the four nearest places.
    fn between(&self, place: DVec3, value: impl Fn(&Spot) -> f64) -> f64 {
        let knots = knots(ROWS, Place::towards(place));
        knots.iter().map(|&(knot, share)| f64::from(share) * value(&self.spots[knot])).sum()
    }
}

impl Spot {
    /// The horizon in a direction from the middle.
    fn of(form: &Form, towards: DVec3) -> Self {
        let (radius, gradient) = form.at(towards);
        let (point, normal) = (towards * radius, (towards - gradient / radius).normalize());
        let (x, y) = normal.any_orthonormal_pair();
        let growth = libm::pow(WALK_TO / WALK_FROM, 1.0 / (WALK - 1) as f64);
        let mut rise = [0.0_f32; AZIMUTHS];
        for (azimuth, rise) in rise.iter_mut().enumerate() {
            let (sin, cos) = libm::sincos(azimuth as f64 * TAU / AZIMUTHS as f64);
            let (away, mut step) = (x * cos + y * sin, WALK_FROM);
            for _ in 0..WALK {
                let towards = (point + away * step).normalize();
                let there = towards * form.at(towards).0 - point;
                let sine = (there.dot(normal) / there.length()) as f32;
                *rise = if sine > LOWEST { rise.max(sine) } else { *rise };
                step *= growth;
            }
        }
        let highest = rise.iter().copied().fold(0.0, f32::max);
        Self { normal, across: [x, y], rise, highest }
    }

    /// The share of light towards a direction that is hidden.
    fn hidden(&self, along: DVec3, width: f64) -> f64 {
        if self.highest <= 0.0 {
            return 0.0;
        }
        let [x, y] = self.across.map(|axis| axis.dot(along));
        let turn = (libm::atan2(y, x) + TAU) * (AZIMUTHS as f64 / TAU);
        let (before, part) = (turn as usize, turn - libm::floor(turn));
        let rise = |azimuth: usize| f64::from(self.rise[azimuth % AZIMUTHS]);
        let rise = rise(before) * (1.0 - part) + rise(before + 1) * part;
        let below = ((rise - along.dot(self.normal)) / width + 0.5).clamp(0.0, 1.0);
        // What hardly rises hides no more than it rises.
        below * below * (3.0 - 2.0 * below) * (rise / width).min(1.0)
    }

    /// The mean of 1 less the sine's square, which is what is left of a matt surface's light above the horizon.
    fn open(&self) -> f64 {
        let hidden: f64 = self.rise.iter().map(|&rise| f64::from(rise).powi(2)).sum();
        1.0 - hidden / AZIMUTHS as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::form::FormParameters;

    #[test]
    fn a_pearl_that_bulges_everywhere_hides_nothing_of_itself() {
        let long = FormParameters { length: 1.4, ..FormParameters::ROUND };
        assert!(Horizon::of(&Form::new(&long)).is_none());
    }

    #[test]
    fn a_groove_is_hidden_from_light_along_the_axis_and_open_across_it() {
        let from = FormParameters { circles: 1, circle_depth: 0.15, ..FormParameters::ROUND };
        let form = Form::new(&from);
        let horizon = Horizon::of(&form).unwrap();
        // The groove's middle, by its depth.
        let deepest = (0..400).map(|i| f64::from(i) / 200.0 - 1.0);
        let deepest = deepest.map(|z| DVec3::new((1.0 - z * z).max(0.0).sqrt(), 0.0, z));
        let place = deepest.min_by(|a, b| form.at(*a).0.total_cmp(&form.at(*b).0)).unwrap();
        let along_axis = horizon.hidden(place, DVec3::Z, 0.0);
        assert!(along_axis > 0.7, "{place}: {along_axis}");
        assert!(horizon.hidden(place, DVec3::X, 0.0) < 1e-9);
        assert!((0.5..0.97).contains(&horizon.open(place)), "{}", horizon.open(place));
    }
}
