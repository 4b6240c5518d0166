//! The pearl's pixels, in a copy small enough, with colours relative to the white.

use crate::contour::Contour;
use crate::white::White;
use crate::{Circle, Picture};

/// Beyond so many mean radii from the middle no pearl reaches.
const FARTHEST: f64 = 2.0;

/// The pearl in a picture of blocks.
pub struct Disc {
    /// Pixels in a row of the copy.
    pub width: usize,
    /// Original pixels to one of the copy, along a side.
    pub factor: usize,
    /// [row, column], None outside the pearl.
    pub pixels: Vec<Option<Pixel>>,
}

/// A pixel on the pearl.
#[derive(Clone, Copy)]
pub struct Pixel {
    /// Its middle, in original pixels.
    pub place: (f64, f64),
    /// Distance from the middle; the outline has 1.
    pub away: f64,
    /// XYZ relative to the white.
    pub xyz: [f64; 3],
    /// Whether a code of the file may have ended before the light did.
    pub clipped: bool,
}

impl Disc {
    /// A copy in which the pearl has a radius of `most_px` pixels at the most.
    pub fn of(
        picture: &Picture<'_>,
        white: &White,
        contour: &Contour,
        clipped_at: f64,
        most_px: f64,
    ) -> Self {
        let Circle { radius_px, .. } = contour.middle;
        let factor = (radius_px / most_px).ceil().max(1.0) as usize;
        // Of a small pearl in a large picture nothing else is copied.
        let part = |middle: f64, side: usize| {
            let ends = [middle - FARTHEST * radius_px, middle + FARTHEST * radius_px];
            let [first, last] =
                ends.map(|end| ((end.max(0.0) / factor as f64) as usize).min(side / factor));
            first..(last + 1).min(side / factor)
        };
        let (columns, rows) = (
            part(contour.middle.x_px, picture.width()),
            part(contour.middle.y_px, picture.height()),
        );
        let (left, top) = (columns.start, rows.start);
        let small = picture.reduced_part(factor, columns, rows);
        let share = contour.share();
        let pixel = |at: usize| {
            let (row, column) = (top + at / small.width, left + at % small.width);
            let place = ((column as f64 + 0.5) * factor as f64, (row as f64 + 0.5) * factor as f64);
            let far =
                (place.0 - contour.middle.x_px).abs().max((place.1 - contour.middle.y_px).abs());
            let away = if far > FARTHEST * radius_px { far } else { share(place.0, place.1) };
            (away < 1.0).then(|| {
                let rgb = small.light[at];
                let clipped = rgb.iter().any(|&channel| channel >= clipped_at);
                Pixel { place, away, xyz: white.xyz(rgb), clipped }
            })
        };
        let pixels = (0..small.light.len()).map(pixel).collect();
        Self { width: small.width, factor, pixels }
    }
}
