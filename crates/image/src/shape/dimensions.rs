//! What a gauge would read of a form: by these numbers the trade's words for shapes are told.
//!
//! Left out: that a figure of revolution lying askew to the form's own axes might be nearer than those about them.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use crate::shape::{
    directions::even_directions,
    form::{Form, FormParameters},
};

/// What a gauge reads of a pearl's form; of a ball all are 0 but the height over the width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dimensions {
    /// The greatest distance of two parallel planes that hold the pearl between them, less the least, over their mean.
    pub diameter_variation: f64,
    /// Total run-out: how far the surface leaves the nearest figure of revolution, outward and inward together, over the
    /// mean diameter.
    pub asymmetry: f64,
    /// Along the axis of that figure over the mean across it.
    pub height_over_width: f64,
    /// How much less wide it is a quarter of the height from one end than from the other, as a share of the wider.
    pub taper: f64,
    /// Grooves all around.
    pub grooves: usize,
}

/// Directions in which planes are laid against the surface, and places of the surface they may touch.
const PLANES: usize = 400;
const POINTS: usize = 6000;
/// Places along an axis from pole to pole, and around it.
const ALONG: usize = 90;
const AROUND: usize = 48;

impl Dimensions {
    /// Of a form.
    pub fn of(from: &FormParameters) -> Self {
        if from.is_round() {
            return Self {
                diameter_variation: 0.0,
                asymmetry: 0.0,
                height_over_width: 1.0,
                taper: 0.0,
                grooves: 0,
            };
        }
        let form = Form::new(from);
        let surface: Vec<DVec3> =
            even_directions(POINTS).map(|towards| towards * form.at(towards).0).collect();
        let ways = even_directions(PLANES).chain([DVec3::X, DVec3::Y, DVec3::Z]);
        let widths: Vec<f64> = ways.map(|way| width(&surface, way)).collect();
        let mean = widths.iter().sum::<f64>() / widths.len() as f64;
        let least = widths.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = widths.iter().copied().fold(0.0, f64::max);
        let figures = [DVec3::Z, DVec3::X, DVec3::Y].map(|axis| Figure::about(&form, axis));
        let [first, second, third] = &figures;
        let nearer = |a, b| if Figure::run_out(b) < Figure::run_out(a) { b } else { a };
        let figure = nearer(nearer(first, second), third);
        Self {
            diameter_variation: (greatest - least) / mean,
            asymmetry: figure.run_out() / mean,
            height_over_width: width(&surface, figure.axis) / width_across(&surface, figure.axis),
            taper: figure.taper(),
            grooves: if from.circle_depth > 0.0 { from.circles } else { 0 },
        }
    }
}

/// The figure of revolution about an axis that a form is nearest to: the mean distance from the middle by latitude.
struct Figure {
    axis: DVec3,
    /// Mean distance from the middle, by equal steps of the angle from the axis.
    radii: Vec<f64>,
    /// The farthest that the form lies outside and inside of it.
    outside: f64,
    inside: f64,
}

impl Figure {
    fn about(form: &Form, axis: DVec3) -> Self {
        let (x, y) = axis.any_orthonormal_pair();
        let (mut radii, mut outside, mut inside) = (Vec::new(), 0.0_f64, 0.0_f64);
        for along in 0..=ALONG {
            let (sin, cos) = libm::sincos(PI * along as f64 / ALONG as f64);
            let around: Vec<f64> = (0..AROUND)
                .map(|i| libm::sincos(TAU * i as f64 / AROUND as f64))
                .map(|(s, c)| form.at(axis * cos + (x * c + y * s) * sin).0)
                .collect();
            let mean = around.iter().sum::<f64>() / AROUND as f64;
            for radius in around {
                outside = outside.max(radius - mean);
                inside = inside.max(mean - radius);
            }
            radii.push(mean);
        }
        Self { axis, radii, outside, inside }
    }

    fn run_out(&self) -> f64 {
        self.outside + self.inside
    }

    fn taper(&self) -> f64 {
        let (top, bottom) = (self.radii[0], -self.radii[ALONG]);
        let [upper, lower] =
            [0.75, 0.25].map(|share| self.half_width_at(bottom + share * (top - bottom)));
        1.0 - upper.min(lower) / upper.max(lower)
    }

    /// The widest place of the figure's outline at a height.
    fn half_width_at(&self, height: f64) -> f64 {
        let place = |along: usize| {
            let (sin, cos) = libm::sincos(PI * along as f64 / ALONG as f64);
            [self.radii[along] * cos, self.radii[along] * sin]
        };
        let crossing = |along: usize| {
            let [[above, wide], [below, next]] = [place(along), place(along + 1)];
            let part = (above - height) / (above - below);
            (0.0..=1.0).contains(&part).then_some(wide + part * (next - wide))
        };
        (0..ALONG).filter_map(crossing).fold(f64::MIN_POSITIVE, f64::max)
    }
}

/// Distance of two planes across a direction that hold a surface between them.
fn width(surface: &[DVec3], way: DVec3) -> f64 {
    let (low, high) = surface
        .iter()
        .map(|place| place.dot(way))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    high - low
}

/// The mean of the widths across an axis.
fn width_across(surface: &[DVec3], axis: DVec3) -> f64 {
    const WAYS: usize = 16;
    let (x, y) = axis.any_orthonormal_pair();
    let widths = (0..WAYS).map(|i| {
        let (sin, cos) = libm::sincos(PI * i as f64 / WAYS as f64);
        width(surface, x * cos + y * sin)
    });
    widths.sum::<f64>() / WAYS as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROUND: FormParameters = FormParameters::ROUND;

    fn near(value: f64, wanted: f64) {
        assert!((value - wanted).abs() < 3e-3, "{value}, not {wanted}");
    }

    #[test]
    fn an_ellipsoids_numbers_are_those_of_its_axes() {
        let oval = Dimensions::of(&FormParameters { length: 1.3, ..ROUND });
        near(oval.height_over_width, 1.3);
        near(oval.asymmetry, 0.0);
        near(oval.taper, 0.0);
        // Over the mean of the widths, which are the roots of 1 + 0.69 z^2, z even from -1 to 1.
        near(oval.diameter_variation, 0.3 / 1.1043);
        let flat = Dimensions::of(&FormParameters { length: 0.8, ..ROUND });
        near(flat.height_over_width, 0.8);
    }

    #[test]
    fn a_near_rounds_widths_differ_by_what_its_key_says() {
        for out_of_round in [0.02, 0.05] {
            let found = Dimensions::of(&FormParameters { out_of_round, ..ROUND });
            near(found.diameter_variation, out_of_round);
        }
    }

    #[test]
    fn a_figure_of_revolution_has_no_run_out_about_whichever_axis_it_is() {
        // An ellipsoid whose axes are 1.1, 0.9 and 0.9: round about x.
        let across = FormParameters { out_of_round: 0.2, length: 0.9, ..ROUND };
        let found = Dimensions::of(&across);
        near(found.asymmetry, 0.0);
        near(found.height_over_width, 1.1 / 0.9);
        let drop = Dimensions::of(&FormParameters { length: 1.35, taper: 0.6, ..ROUND });
        near(drop.asymmetry, 0.0);
        assert!(drop.taper > 0.1);
    }

    #[test]
    fn grooves_without_depth_are_none() {
        let flat = FormParameters { circles: 3, circle_depth: 0.0, length: 1.1, ..ROUND };
        assert_eq!(Dimensions::of(&flat).grooves, 0);
        assert_eq!(Dimensions::of(&FormParameters { circle_depth: 0.04, ..flat }).grooves, 3);
    }
}
