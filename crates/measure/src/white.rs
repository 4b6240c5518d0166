//! Colours relative to a stated white.

use nacreous_colour::matrix::{Matrix, apply};
use nacreous_colour::{RgbSpace, adaptation, lab_from_xyz};

use crate::MeasureError;

/// What the picture shows as white, and the way from there to CIELAB.
pub struct White {
    xyz_from_rgb: Matrix,
}

impl White {
    /// Of the linear RGB of a white matt thing in the picture: 1, 1, 1 leaves colours as they are.
    ///
    /// Adapted by Bradford's cones, and scaled by the white's luminance.
    pub fn new(white: [f64; 3]) -> Result<Self, MeasureError> {
        let wrong = || MeasureError::White { white };
        if white.iter().any(|channel| !(1e-4..=1e4).contains(channel)) {
            return Err(wrong());
        }
        let xyz = RgbSpace::Srgb.xyz_from_rgb(white);
        let adapted = adaptation(xyz.map(|part| part / xyz[1]), RgbSpace::Srgb.white_xyz())
            .map_err(|_| wrong())?;
        let mut columns = [[0.0; 3]; 3];
        for channel in 0..3 {
            let mut rgb = [0.0; 3];
            rgb[channel] = 1.0;
            let seen = apply(&adapted, RgbSpace::Srgb.xyz_from_rgb(rgb));
            for row in 0..3 {
                columns[row][channel] = seen[row] / xyz[1];
            }
        }
        Ok(Self { xyz_from_rgb: columns })
    }

    /// XYZ relative to the white, as seen under D65.
    pub fn xyz(&self, rgb: [f64; 3]) -> [f64; 3] {
        apply(&self.xyz_from_rgb, rgb)
    }

    /// Luminance relative to the white.
    pub fn luminance(&self, rgb: [f64; 3]) -> f64 {
        let row = self.xyz_from_rgb[1];
        row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2]
    }
}

/// L*, a*, b* of XYZ relative to white (CIE 015).
pub fn lab(xyz: [f64; 3]) -> [f64; 3] {
    lab_from_xyz(xyz, RgbSpace::Srgb.white_xyz())
}
