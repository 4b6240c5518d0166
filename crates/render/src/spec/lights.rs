//! The lamps and windows of a scene.

use serde::Deserialize;

/// A round lamp, by its direction or by its position.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LampSpec {
    /// Direction seen from the pearl, 0 towards the viewer, positive to the right.
    pub azimuth_deg: Option<f64>,
    /// Height above the horizon.
    pub elevation_deg: Option<f64>,
    /// Position from the origin, in place of a direction.
    pub position_mm: Option<[f64; 3]>,
    /// Radius as seen from the pearl.
    pub angular_radius_deg: f64,
    /// The light: an illuminant, a colour temperature, or a key of the spectra handed over.
    pub spectrum: String,
    /// Irradiance on a surface that faces the lamp.
    pub intensity: f64,
}

/// A rectangle of even light.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WindowSpec {
    /// Direction seen from the pearl.
    pub azimuth_deg: Option<f64>,
    /// Height above the horizon.
    pub elevation_deg: Option<f64>,
    /// Distance of its middle, with a direction.
    pub distance_mm: Option<f64>,
    /// Position of its middle, in place of a direction.
    pub position_mm: Option<[f64; 3]>,
    /// Where it shines, with a position; towards the pearl where left out.
    pub facing: Option<[f64; 3]>,
    /// It lies flat, so far below the pearls' lowest point, in place of direction and position.
    pub below_mm: Option<f64>,
    /// Its width.
    pub width_mm: f64,
    /// Its height.
    pub height_mm: f64,
    /// The light, as a lamp's.
    pub spectrum: String,
    /// Radiance, in units of white paper that faces a lamp of intensity 1.
    pub luminance: f64,
}
