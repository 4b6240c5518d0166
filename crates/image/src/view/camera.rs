use glam::DVec3;

use crate::view::{direction::direction, ray::Ray};

/// How the lines of sight run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Projection {
    /// All parallel, as if seen from afar: then view angles are the same around every ring.
    Orthographic,
    /// From one point, `distance_mm` from the origin.
    Perspective {
        /// Distance from the eye to the origin.
        distance_mm: f64,
    },
}

/// The eye. It looks at the origin, y points up, z towards the viewer at azimuth 0.
///
/// ```
/// use nacreous_image::{Camera, Projection};
/// let camera = Camera::new(Projection::Orthographic, 0.0, 0.0, 12.0);
/// let centre = camera.ray(0.0, 0.0);
/// assert!((centre.along.z + 1.0).abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    projection: Projection,
    back: DVec3,
    right: DVec3,
    up: DVec3,
    half_field_mm: f64,
    /// Where parallel lines of sight start.
    far_mm: f64,
}

impl Camera {
    /// `field_mm` is the width of the square view in the plane of the origin.
    pub fn new(
        projection: Projection,
        elevation_rad: f64,
        azimuth_rad: f64,
        field_mm: f64,
    ) -> Self {
        let back = direction(azimuth_rad, elevation_rad);
        let right = DVec3::new(libm::cos(azimuth_rad), 0.0, -libm::sin(azimuth_rad));
        let (up, half_field_mm) = (back.cross(right), 0.5 * field_mm);
        Self { projection, back, right, up, half_field_mm, far_mm: FAR_MM }
    }

    /// Starts parallel lines of sight in front of everything within `reach_mm` of the origin.
    #[must_use]
    pub fn in_front_of(self, reach_mm: f64) -> Self {
        Self { far_mm: self.far_mm.max(2.0 * reach_mm), ..self }
    }

    /// The line of sight through (x, y) of the view, both from -1 (left, bottom) to 1 (right, top).
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        let target = (self.right * x + self.up * y) * self.half_field_mm;
        match self.projection {
            Projection::Orthographic => {
                Ray { from: target + self.back * self.far_mm, along: -self.back }
            }
            Projection::Perspective { distance_mm } => {
                let eye = self.back * distance_mm;
                Ray { from: eye, along: (target - eye).normalize() }
            }
        }
    }

    /// Distance at which a cell of the view has its width; parallel lines never widen, so their angle is
    /// that seen from where they start.
    pub fn reach_mm(&self, ray: &Ray) -> f64 {
        ray.from.length()
    }

    /// How much wider a cell of the view is at `point` than at the origin; 0 and less behind the eye.
    pub fn scale_at(&self, point: DVec3) -> f64 {
        match self.projection {
            Projection::Orthographic => 1.0,
            Projection::Perspective { distance_mm } => 1.0 - point.dot(self.back) / distance_mm,
        }
    }

    /// Direction from `point` to the eye, and how far off it is.
    pub fn toward_eye(&self, point: DVec3) -> (DVec3, f64) {
        match self.projection {
            Projection::Orthographic => (self.back, f64::INFINITY),
            Projection::Perspective { distance_mm } => {
                let toward = self.back * distance_mm - point;
                (toward.normalize(), toward.length())
            }
        }
    }

    /// Distance of `point` from the plane of all lines of sight at the height `y` of the view.
    pub fn off_row_mm(&self, y: f64, point: DVec3) -> f64 {
        let ray = self.ray(0.0, y);
        (point - ray.from).dot(self.right.cross(ray.along)).abs()
    }

    /// Width of a cell of the view, `cells` of which make its whole width, at the origin.
    pub fn cell_mm(&self, cells: usize) -> f64 {
        2.0 * self.half_field_mm / cells as f64
    }
}

/// Where parallel lines of sight start: in front of everything near one pearl.
const FAR_MM: f64 = 1000.0;
