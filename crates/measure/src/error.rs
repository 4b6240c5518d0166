//! What this room refuses as a whole; parts that cannot be measured are listed in the result.

/// A picture, or something said of it, from which nothing can be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeasureError {
    /// Too small, or not as many numbers as pixels.
    #[error(
        "the picture is {width} x {height} pixels of {numbers} numbers; allowed: 32 to 16384 pixels a side, 3 numbers each"
    )]
    Size {
        /// Pixels in a row.
        width: usize,
        /// Rows.
        height: usize,
        /// Numbers given.
        numbers: usize,
    },
    /// Light that is no number.
    #[error(
        "the picture is {value} at row {row}, column {column}; allowed: finite light, up to 1e6 in size"
    )]
    Light {
        /// The value as given.
        value: f32,
        /// Its row, from 0.
        row: usize,
        /// Its column, from 0.
        column: usize,
    },
    /// A white that is none.
    #[error(
        "white is {white:?}; allowed: linear RGB of a light that all three cones see, 1e-4 to 1e4"
    )]
    White {
        /// As given.
        white: [f64; 3],
    },
    /// Another number outside its range.
    #[error("{quantity} is {value}; allowed: {allowed}")]
    Number {
        /// What it is.
        quantity: &'static str,
        /// As given.
        value: f64,
        /// The range in words.
        allowed: &'static str,
    },
    /// A circle that lies outside.
    #[error(
        "the pearl's circle, centre ({x:.1}, {y:.1}), radius {radius:.1}, leaves the picture of {width} x {height} pixels; allowed: a pearl of 12 pixels and more in radius, whole"
    )]
    Outside {
        /// Centre.
        x: f64,
        /// Centre, downwards.
        y: f64,
        /// Radius.
        radius: f64,
        /// Pixels in a row.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// Nothing round to be seen.
    #[error(
        "no pearl: no round outline stands out (an edge in {percent:.0} % of all directions; wanted: 40 %)"
    )]
    NoPearl {
        /// Share of directions with an edge, in percent.
        percent: f64,
    },
    /// Seen in part.
    #[error(
        "the outline cannot be followed: about ({x:.0}, {y:.0}), radius {radius:.0}, an edge is seen on it in {percent:.0} % of all directions, with a gap of {degrees:.0} degrees; wanted: in 80 %, or in 40 % of an outline that is round to 3 %, and no gap of more than 27 degrees, 45 where it is round, 90 where it is both; a soft edge, as a shadow's, counts for none"
    )]
    NotFollowed {
        /// Middle.
        x: f64,
        /// Middle, downwards.
        y: f64,
        /// Mean radius.
        radius: f64,
        /// Share of directions with an edge, in percent.
        percent: f64,
        /// The longest gap between them.
        degrees: f64,
    },
    /// A ring.
    #[error(
        "no pearl: within the outline about ({x:.0}, {y:.0}), radius {radius:.0}, lies what is around it, as in a ring"
    )]
    Hollow {
        /// Middle.
        x: f64,
        /// Middle, downwards.
        y: f64,
        /// Mean radius.
        radius: f64,
    },
    /// More than one.
    #[error("more than one pearl: at ({:.0}, {:.0}), radius {:.0}, and at ({:.0}, {:.0}), radius {:.0}", first[0], first[1], first[2], second[0], second[1], second[2])]
    Several {
        /// x, y and radius.
        first: [f64; 3],
        /// x, y and radius.
        second: [f64; 3],
    },
}
