//! Linear RGB as three numbers, and the little arithmetic that light needs.
//!
//! Primaries and luminance of sRGB, IEC 61966-2-1.
//! Left out: other primaries, which `nacreous-colour` knows, and any clipping; channels may be negative.

/// Linear light in the primaries of sRGB; may be negative for colours outside its gamut.
pub type Rgb = [f64; 3];

/// Channel by channel.
pub(crate) fn times(a: Rgb, b: Rgb) -> Rgb {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// All channels by one factor.
pub(crate) fn scaled(a: Rgb, factor: f64) -> Rgb {
    a.map(|channel| channel * factor)
}

/// Adds `b` to `a`.
pub(crate) fn add(a: &mut Rgb, b: Rgb) {
    for (sum, channel) in a.iter_mut().zip(b) {
        *sum += channel;
    }
}

/// From `a` to `b` as `share` goes from 0 to 1.
pub(crate) fn mix(a: Rgb, b: Rgb, share: f64) -> Rgb {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * share)
}

/// Y of linear sRGB (IEC 61966-2-1, rounded as there).
pub(crate) fn luminance([r, g, b]: Rgb) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}
