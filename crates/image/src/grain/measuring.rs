//! How a photograph's grain is measured, and what cannot be.
//!
//! The highest frequencies are the camera's noise and the lowest the pearl's shading, so the band begins at 2 cycles per
//! patch and ends at three quarters of the highest frequency that the pixels carry, unless it is given **(ours)**.

use thiserror::Error;

use crate::grain::{
    crop::{NoPatch, Photograph},
    spectrum::GrainError,
    waves::Band,
};

/// The most light either way: white has 1, and no surface reaches 10. What is in codes from 0 to 255 is beyond it.
const MOST_LIGHT: f64 = 10.0;

/// How a photograph's grain is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measuring {
    /// Side of the patches, 8 to 1024.
    pub side_px: usize,
    /// Size of the photograph's pixels on the pearl; where left out, a patch counts as 1 mm.
    pub mm_per_pixel: Option<f64>,
    /// Lower limit of the band.
    pub low_per_mm: Option<f64>,
    /// Upper limit of the band.
    pub high_per_mm: Option<f64>,
}

/// Why a photograph's grain cannot be measured.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PhotographError {
    /// Patches of a size that is not taken.
    #[error("texture: side_px is {0}; allowed: 8 to 1024")]
    Side(usize),
    /// Pixels without a sensible size.
    #[error("texture: mm_per_pixel is {0}; allowed: greater than 0")]
    Scale(f64),
    /// A photograph smaller than a patch.
    #[error(
        "texture: the photograph has {rows} x {columns} pixels; allowed: at least side_px = {side_px} each way"
    )]
    Small {
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
        /// A patch's side.
        side_px: usize,
    },
    /// Numbers that are no picture of so many pixels.
    #[error(
        "texture: the photograph has {numbers} numbers for {rows} x {columns} pixels; allowed: three a pixel"
    )]
    Numbers {
        /// How many there are.
        numbers: usize,
        /// Rows.
        rows: usize,
        /// Columns.
        columns: usize,
    },
    /// A number that is none.
    #[error(
        "texture: the photograph is not a number at ({row}, {column}, {channel}); allowed: finite"
    )]
    NotFinite {
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
        /// Red, green or blue.
        channel: usize,
    },
    /// Light in other units.
    #[error(
        "texture: the photograph is {light} at ({row}, {column}, {channel}); allowed: -{MOST_LIGHT} to {MOST_LIGHT} (1 is \
         white, and no surface reaches 10)"
    )]
    Light {
        /// The light.
        light: f64,
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
        /// Red, green or blue.
        channel: usize,
    },
    /// No corners, though they were to be given.
    #[error("texture: corners is empty; allowed: at least one (row, column)")]
    NoCorners,
    /// A patch that is not in the photograph.
    #[error(
        "texture: corner ({}, {}) puts a patch outside the photograph; allowed: (0, 0) to ({}, {})",
        corner.0, corner.1, last.0, last.1
    )]
    Corner {
        /// Row and column.
        corner: (i64, i64),
        /// The last corner.
        last: (usize, usize),
    },
    /// Limits that are none.
    #[error(
        "texture: the band is {} to {} cycles per {unit}; allowed: 0 <= low < high <= {}",
        general(*low), general(*high), general(*highest)
    )]
    Band {
        /// The lower limit.
        low: f64,
        /// The upper one.
        high: f64,
        /// Half a cycle a pixel.
        highest: f64,
        /// mm, or patch.
        unit: &'static str,
    },
    /// No patch in the pearl that was found.
    #[error(transparent)]
    Patch(#[from] NoPatch),
    /// Numbers that are no spectrum.
    #[error(transparent)]
    Spectrum(#[from] GrainError),
}

/// Six digits, as Python's `:g` writes numbers of this kind.
fn general(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// What is measured and how, before patches are looked for.
pub(super) fn check(photograph: &Photograph<'_>, how: &Measuring) -> Result<(), PhotographError> {
    let (side, rows, columns) = (how.side_px, photograph.height, photograph.width);
    if !(8..=1024).contains(&side) {
        return Err(PhotographError::Side(side));
    }
    if let Some(scale) = how.mm_per_pixel
        && !(scale > 0.0 && scale.is_finite())
    {
        return Err(PhotographError::Scale(scale));
    }
    let numbers = photograph.numbers();
    if rows.saturating_mul(columns).saturating_mul(3) != numbers {
        return Err(PhotographError::Numbers { numbers, rows, columns });
    }
    if rows.min(columns) < side {
        return Err(PhotographError::Small { rows, columns, side_px: side });
    }
    photograph.not_finite().map_or(Ok(()), |place| {
        let (row, column) = (place / 3 / columns, place / 3 % columns);
        Err(PhotographError::NotFinite { row, column, channel: place % 3 })
    })
}

/// Corners that were given, if their patches lie in the photograph.
pub(super) fn inside(
    photograph: &Photograph<'_>,
    side: usize,
    given: &[(i64, i64)],
) -> Result<Vec<(usize, usize)>, PhotographError> {
    let last = (photograph.height - side, photograph.width - side);
    let one = |&corner: &(i64, i64)| {
        let within = |value: i64, last| usize::try_from(value).ok().filter(|&first| first <= last);
        let found = within(corner.0, last.0).zip(within(corner.1, last.1));
        found.ok_or(PhotographError::Corner { corner, last })
    };
    if given.is_empty() {
        return Err(PhotographError::NoCorners);
    }
    given.iter().map(one).collect()
}

/// Patches are of light, as colour takes it; a lamp's image beside them may be as bright as it is.
pub(super) fn check_light(
    photograph: &Photograph<'_>,
    (top, left): (usize, usize),
    side: usize,
) -> Result<(), PhotographError> {
    for (row, column) in
        (top..top + side).flat_map(|row| (left..left + side).map(move |at| (row, at)))
    {
        let light = photograph.at(row, column);
        if let Some(channel) = light.iter().position(|light| light.abs() > MOST_LIGHT) {
            return Err(PhotographError::Light { light: light[channel], row, column, channel });
        }
    }
    Ok(())
}

/// The limits in cycles per patch.
pub(super) fn band(how: &Measuring, patch_mm: f64) -> Result<Band, PhotographError> {
    let highest = how.side_px as f64 / 2.0 / patch_mm;
    let low = how.low_per_mm.unwrap_or(2.0 / patch_mm);
    let high = how.high_per_mm.unwrap_or(0.75 * highest);
    if 0.0 <= low && low < high && high <= highest {
        return Ok(Band { low: low * patch_mm, high: high * patch_mm });
    }
    let unit = if how.mm_per_pixel.is_some() { "mm" } else { "patch" };
    Err(PhotographError::Band { low, high, highest, unit })
}
