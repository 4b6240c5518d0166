use glam::DVec3;

use crate::camera::Ray;

/// How far inside the silhouette a line of sight that grazes it is taken to hit.
const RIM: f64 = 1.0 - 1e-9;

/// The pearl's shape: a ball around the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Radius in mm.
    pub radius_mm: f64,
}

/// Where a line of sight meets the pearl.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Point on the surface, mm.
    pub point: DVec3,
    /// Outward normal there.
    pub normal: DVec3,
    /// Cosine of the view angle theta_0, between normal and line of sight.
    pub cos_view: f64,
    /// The share of the line's cell that the pearl covers, 0..1.
    pub coverage: f64,
}

impl Sphere {
    /// The pearl along `ray`, or nothing. `cell_mm` is the width of the cell that the ray stands for:
    /// a cell on the silhouette is covered in part, and the part that is covered shows the rim.
    ///
    /// The silhouette is taken as straight within a cell.
    pub fn hit(&self, ray: &Ray, cell_mm: f64) -> Option<Hit> {
        let along_mm = ray.from.dot(ray.along);
        let closest = ray.from - ray.along * along_mm;
        let passing_mm = closest.length();
        let coverage = ((self.radius_mm - passing_mm) / cell_mm + 0.5).clamp(0.0, 1.0);
        if coverage == 0.0 || along_mm >= 0.0 {
            return None;
        }
        let sin_view = (passing_mm / self.radius_mm).min(RIM);
        let cos_view = (1.0 - sin_view * sin_view).sqrt();
        let aside = if passing_mm > 0.0 { closest * (sin_view / passing_mm) } else { DVec3::ZERO };
        let normal = aside - ray.along * cos_view;
        Some(Hit { point: normal * self.radius_mm, normal, cos_view, coverage })
    }

    /// The share of a small disc of light, of angular radius `disc_rad` towards `toward`, that a point
    /// outside the pearl still sees past it.
    ///
    /// The pearl's edge is taken as straight across the disc, good while the disc is the smaller.
    pub fn light_past(&self, point: DVec3, toward: DVec3, disc_rad: f64) -> f64 {
        let distance_mm = point.length();
        let pearl_rad = libm::asin((self.radius_mm / distance_mm).min(1.0));
        let apart_rad = libm::acos((-point.dot(toward) / distance_mm).clamp(-1.0, 1.0));
        let x = ((apart_rad - pearl_rad) / disc_rad).clamp(-1.0, 1.0);
        1.0 - (libm::acos(x) - x * (1.0 - x * x).sqrt()) / std::f64::consts::PI
    }

    /// The share of an even sky that a point on the table still receives beside the pearl that lies on
    /// it. Exact: the form factor of a sphere wholly above a plane.
    pub fn sky_past(&self, point_on_table: DVec3) -> f64 {
        1.0 - (self.radius_mm / point_on_table.length()).min(1.0).powi(3)
    }
}
