//! Linear light [row, column, rgb], looked up between pixels.

use std::ops::Range;

use libm::floor;

use crate::MeasureError;

/// Fewest and most pixels a side.
const SIDES: std::ops::RangeInclusive<usize> = 32..=16_384;
/// Beyond this in size, light is taken for a mistake.
const BRIGHTEST: f32 = 1e6;

/// A picture in linear-light sRGB, checked.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    light: &'a [f32],
    width: usize,
    height: usize,
}

impl<'a> Picture<'a> {
    /// Linear light, `3 * width * height` numbers in the order [row, column, rgb].
    ///
    /// # Errors
    /// Other numbers of numbers, fewer than 32 pixels a side, and what is not finite.
    pub fn new(light: &'a [f32], width: usize, height: usize) -> Result<Self, MeasureError> {
        let numbers = light.len();
        if !SIDES.contains(&width) || !SIDES.contains(&height) || numbers != 3 * width * height {
            return Err(MeasureError::Size { width, height, numbers });
        }
        if let Some(at) = light.iter().position(|value| !(-BRIGHTEST..=BRIGHTEST).contains(value)) {
            let (row, column) = (at / 3 / width, at / 3 % width);
            return Err(MeasureError::Light { value: light[at], row, column });
        }
        Ok(Self { light, width, height })
    }

    /// Pixels in a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// The light of a pixel; the border goes on for ever.
    pub(crate) fn pixel(&self, column: isize, row: isize) -> [f64; 3] {
        let column = column.clamp(0, self.width.cast_signed() - 1) as usize;
        let row = row.clamp(0, self.height.cast_signed() - 1) as usize;
        let first = 3 * (row * self.width + column);
        [0, 1, 2].map(|channel| f64::from(self.light[first + channel]))
    }

    /// The light at a place, linear between the middles of pixels.
    pub(crate) fn at(&self, x: f64, y: f64) -> [f64; 3] {
        let (left, top) = (floor(x - 0.5), floor(y - 0.5));
        let (right, down) = (x - 0.5 - left, y - 0.5 - top);
        let (column, row) = (left as isize, top as isize);
        let corners = [
            ((1.0 - right) * (1.0 - down), self.pixel(column, row)),
            (right * (1.0 - down), self.pixel(column + 1, row)),
            ((1.0 - right) * down, self.pixel(column, row + 1)),
            (right * down, self.pixel(column + 1, row + 1)),
        ];
        [0, 1, 2].map(|channel| corners.iter().map(|(share, rgb)| share * rgb[channel]).sum())
    }

    /// Means over blocks of `factor` x `factor` pixels; what is left over is left out.
    pub(crate) fn reduced(&self, factor: usize) -> Reduced {
        self.reduced_part(factor, 0..self.width / factor, 0..self.height / factor)
    }

    /// The same of some columns and rows of blocks alone.
    pub(crate) fn reduced_part(
        &self,
        factor: usize,
        columns: Range<usize>,
        rows: Range<usize>,
    ) -> Reduced {
        let (width, height) = (columns.len(), rows.len());
        let mut light = vec![[0.0; 3]; width * height];
        let share = 1.0 / (factor * factor) as f64;
        for row in 0..height * factor {
            for column in 0..width * factor {
                let (x, y) = (columns.start * factor + column, rows.start * factor + row);
                let first = 3 * (y * self.width + x);
                let block = &mut light[row / factor * width + column / factor];
                for channel in 0..3 {
                    block[channel] += share * f64::from(self.light[first + channel]);
                }
            }
        }
        Reduced { light, width, height }
    }
}

/// A smaller picture that owns its light.
pub struct Reduced {
    pub light: Vec<[f64; 3]>,
    pub width: usize,
    pub height: usize,
}
