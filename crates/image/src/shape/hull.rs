//! The ellipsoid that stands for a pearl that is not round, where others see it or stand in its shadow.
//!
//! As long as the pearl along each of its own axes; seen as a ball after a stretch of space.
//! Left out: all finer form, which soft shadows and wide lobes hide.

use glam::{DMat3, DVec3};

use crate::{
    coat::pose::Pose,
    shape::{directions::even_directions, form::Form},
};

/// An ellipsoid about a pearl.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hull {
    /// From the pearl's middle to its own.
    offset_mm: DVec3,
    /// To where it is a ball of radius 1.
    stretch: DMat3,
    /// One over the product of the half axes.
    per_mm3: f64,
    /// So many times as large it holds all of the pearl.
    room: f64,
    /// The farthest that the pearl reaches from its middle.
    reach_mm: f64,
    /// How far below its middle the pearl reaches.
    below_mm: f64,
}

/// What lies between the directions that were looked at.
const ROOM: f64 = 1.02;
/// Directions by which extents are taken; lumps move by less than a pixel between them.
const POINTS: usize = 8000;

impl Hull {
    /// Around a form in a pose, `radius_mm` half its width.
    pub(crate) fn around(form: &Form, pose: &Pose, radius_mm: f64) -> Self {
        let (mut low, mut high) = (DVec3::ZERO, DVec3::ZERO);
        let (mut reach, mut below) = (0.0_f64, 0.0_f64);
        for towards in even_directions(POINTS) {
            let radius = form.at(towards).0;
            let place = towards * radius;
            (low, high) = (low.min(place), high.max(place));
            reach = reach.max(radius);
            below = below.max(-pose.scene(place).y);
        }
        let half = 0.5 * (high - low) * radius_mm;
        let middle = 0.5 * (high + low);
        let beyond =
            |towards: DVec3| ((towards * form.at(towards).0 - middle) * radius_mm / half).length();
        let room = ROOM * even_directions(POINTS / 4).map(beyond).fold(1.0, f64::max);
        let own = DMat3::from_cols(pose.own(DVec3::X), pose.own(DVec3::Y), pose.own(DVec3::Z));
        Self {
            offset_mm: pose.scene(middle * radius_mm),
            stretch: DMat3::from_diagonal(half.recip()) * own,
            per_mm3: 1.0 / (half.x * half.y * half.z),
            room,
            reach_mm: reach * radius_mm,
            below_mm: below * radius_mm,
        }
    }

    /// The farthest that the pearl reaches from its middle.
    pub fn reach_mm(&self) -> f64 {
        self.reach_mm
    }

    /// How far below its middle it reaches.
    pub fn below_mm(&self) -> f64 {
        self.below_mm
    }

    /// A place seen from the pearl's middle and a direction there, stretched to where the hull is a ball of radius 1
    /// about the origin; and by how much lengths along the direction grow, and angles across it.
    pub(crate) fn stretched(&self, from: DVec3, along: DVec3) -> (DVec3, DVec3, [f64; 2]) {
        let stretched = self.stretch * along;
        let length = stretched.length();
        let across = (self.per_mm3 / length).sqrt();
        (self.stretch * (from - self.offset_mm), stretched / length, [length, across / length])
    }

    /// From where to where a line from a place seen from the pearl's middle may be inside of the pearl.
    pub(crate) fn within(&self, from: DVec3, along: DVec3) -> Option<[f64; 2]> {
        let (from, along, [length, _]) = self.stretched(from, along);
        let middle = -from.dot(along);
        let half2 = self.room * self.room - (from + along * middle).length_squared();
        (half2 > 0.0).then(|| [middle - half2.sqrt(), middle + half2.sqrt()].map(|t| t / length))
    }

    /// Whether a line from a place seen from the pearl's middle surely passes the pearl by more than `aside_mm`.
    pub(crate) fn is_passed(&self, from: DVec3, along: DVec3, aside_mm: f64) -> bool {
        let (from, along, [length, angle]) = self.stretched(from, along);
        // Lengths across the line are stretched by as much as angles are, times that of lengths along it.
        from.reject_from_normalized(along).length() > self.room + aside_mm * length * angle * ROOM
    }

    /// The share of an even sky that a level place, seen from the pearl's middle, still receives beside it.
    pub(crate) fn sky_past(&self, from: DVec3) -> f64 {
        let toward = self.offset_mm - from;
        let distance_mm = toward.length();
        let toward = toward / distance_mm;
        // The area that it fills, as seen from there, over pi.
        let area_mm2 = (self.stretch * toward).length() / self.per_mm3;
        1.0 - (toward.y * area_mm2 / (distance_mm * distance_mm)).clamp(0.0, 1.0)
    }
}
