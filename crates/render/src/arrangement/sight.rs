//! What a line of sight meets among the pearls in their places.

use glam::DVec3;

use super::{Arrangement, Solids};

/// What a line of sight meets, relief left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sighted {
    /// The pearl's number among those given.
    pub pearl: usize,
    /// The angle between the surface's normal and the line of sight.
    pub view_rad: f64,
}

impl Arrangement {
    /// The pearl that is met through (x, y) of the view, both from -1 (left, bottom) to 1 (right, top).
    pub(crate) fn sight(&self, (x, y): (f64, f64), solids: &Solids) -> Option<Sighted> {
        let ray = self.camera().ray(x, y);
        let met = self.places.iter().zip(self.balls()).filter_map(|(place, ball)| {
            let (middle, hit) = match &solids[place.pearl] {
                Some(solid) => (ball.centre, solid.hit(ray.from - ball.centre, ray.along)?),
                None => (DVec3::ZERO, ball.hit(&ray)?),
            };
            let far_mm = (middle + hit.point - ray.from).dot(ray.along);
            let view_rad = libm::acos(hit.cos_view.clamp(0.0, 1.0));
            Some((far_mm, Sighted { pearl: place.pearl, view_rad }))
        });
        met.min_by(|one, other| one.0.total_cmp(&other.0)).map(|(_, sighted)| sighted)
    }
}
