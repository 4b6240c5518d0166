//! How a pearl is turned in its place.
//!
//! A turn about the upright, then a tilt towards the eye, then a spin about the pearl's own axis.
//! Left out: where the pearl lies.

use glam::{DMat3, DVec3};

/// How a pearl is turned in its place: from the scene's directions to those that it had before it was turned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose(DMat3);

impl Pose {
    /// The axis of growth leans `tilt_rad` from the upright, towards the eye at azimuth 0 turned by `turn_rad`; about it
    /// the pearl is turned by `spin_rad`.
    pub fn new(turn_rad: f64, tilt_rad: f64, spin_rad: f64) -> Self {
        let turn = |angle: f64, axis: DVec3| {
            let (sin, cos) = libm::sincos(angle);
            about(axis, sin, cos)
        };
        let pose = turn(turn_rad, DVec3::Y) * turn(tilt_rad, DVec3::X) * turn(spin_rad, DVec3::Y);
        Self(pose.transpose())
    }

    /// A direction of the scene as it was before the turn, as the grain has it.
    pub(crate) fn unturned(&self, direction: DVec3) -> DVec3 {
        self.0 * direction
    }

    /// The way back.
    pub(crate) fn turned(&self, direction: DVec3) -> DVec3 {
        self.0.transpose() * direction
    }

    /// A direction of the scene, seen from the pearl: its pole is the axis of growth.
    pub(crate) fn own(&self, direction: DVec3) -> DVec3 {
        let before = self.unturned(direction);
        DVec3::new(before.z, before.x, before.y)
    }

    /// A direction of the pearl, in the scene.
    pub(crate) fn scene(&self, own: DVec3) -> DVec3 {
        self.turned(DVec3::new(own.y, own.z, own.x))
    }
}

/// A turn about an axis, counterclockwise against it.
fn about(axis: DVec3, sin: f64, cos: f64) -> DMat3 {
    let (x, y, z) = (axis.x, axis.y, axis.z);
    let cross =
        DMat3::from_cols(DVec3::new(0.0, z, -y), DVec3::new(-z, 0.0, x), DVec3::new(y, -x, 0.0));
    DMat3::IDENTITY + cross * sin + cross * cross * (1.0 - cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn the_axis_stands_upright_and_leans_towards_the_eye() {
        let near = |a: DVec3, b: DVec3| assert!((a - b).length() < 1e-12, "{a} {b}");
        near(Pose::new(0.0, 0.0, 0.7).scene(DVec3::Z), DVec3::Y);
        near(Pose::new(0.0, FRAC_PI_2, 0.0).scene(DVec3::Z), DVec3::Z);
        near(Pose::new(FRAC_PI_2, FRAC_PI_2, 0.0).scene(DVec3::Z), DVec3::X);
        let pose = Pose::new(0.3, 0.5, -0.8);
        let direction = DVec3::new(0.3, -0.5, 0.8);
        near(pose.scene(pose.own(direction)), direction);
    }
}
