//! How a pearl comes to rest: how high its middle of mass lies above the table, by how it is turned.
//!
//! The lowest middle of mass is the steadiest rest; the nucleus is taken to be as dense as the nacre.
//! Left out: that a pearl rolls on to the nearest hollow, and what holds it there.

use glam::DVec3;

use crate::{
    coat::pose::Pose,
    shape::{
        directions::even_directions,
        form::{Form, FormParameters},
    },
};

/// A pearl's surface and middle of mass, for weighing one rest against another.
#[derive(Debug)]
pub struct Rest {
    places: Vec<DVec3>,
    middle: DVec3,
}

/// Places of the surface; lumps are wider than the way between them.
const POINTS: usize = 1500;

impl Rest {
    /// Of a form.
    pub fn new(from: &FormParameters) -> Self {
        let form = Form::new(from);
        let (mut places, mut moment, mut volume) = (Vec::new(), DVec3::ZERO, 0.0);
        for towards in even_directions(POINTS) {
            let radius = form.at(towards).0;
            places.push(towards * radius);
            moment += towards * (radius.powi(4) / 4.0);
            volume += radius.powi(3) / 3.0;
        }
        Self { places, middle: moment / volume }
    }

    /// Height of the middle of mass above the table in a pose, over half the pearl's width.
    pub fn height(&self, pose: &Pose) -> f64 {
        let height = |place: DVec3| pose.scene(place).y;
        let lowest = self.places.iter().map(|place| height(*place)).fold(f64::INFINITY, f64::min);
        height(self.middle) - lowest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steadiest(form: &FormParameters) -> f64 {
        let rest = Rest::new(form);
        let height = |tilt: i32| rest.height(&Pose::new(0.0, f64::from(tilt).to_radians(), 0.0));
        f64::from((0..=180).min_by(|a, b| height(*a).total_cmp(&height(*b))).unwrap())
    }

    #[test]
    fn an_oval_lies_and_a_button_sits_on_its_flat_side() {
        let round = FormParameters::ROUND;
        let oval = FormParameters { length: 1.4, ..round };
        assert!((steadiest(&oval) - 90.0).abs() < 3.0);
        let button = FormParameters { length: 0.8, flattening: 0.5, ..round };
        assert!(steadiest(&button) < 3.0);
        // A drop lies on its side, its narrow end lower than its middle.
        let drop = FormParameters { length: 1.5, taper: 1.0, ..round };
        assert!((95.0..125.0).contains(&steadiest(&drop)), "{}", steadiest(&drop));
    }
}
