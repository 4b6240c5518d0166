use nacreous_colour::{ColourError, Observer, SAMPLES, Spectrum};

/// Bands of 10 nm that carry light inside a pearl. Interference colours of an ensemble are wider than
/// 50 nm: bands change them by less than CIEDE2000 0.1.
pub const BANDS: usize = 40;

/// One number for each band.
pub type Bands = [f64; BANDS];

/// The samples of a spectrum that make a band; the last one has 780 nm too.
pub(crate) fn samples(band: usize) -> std::ops::Range<usize> {
    let end = if band + 1 == BANDS { SAMPLES } else { (band + 1) * (SAMPLES - 1) / BANDS };
    band * (SAMPLES - 1) / BANDS..end
}

/// The mean of a spectrum over each band.
pub(crate) fn means(spectrum: &[f64]) -> Bands {
    std::array::from_fn(|band| {
        let part = &spectrum[samples(band)];
        part.iter().sum::<f64>() / part.len() as f64
    })
}

/// Power in each band.
pub(crate) fn sums(spectrum: &[f64; SAMPLES]) -> Bands {
    std::array::from_fn(|band| spectrum[samples(band)].iter().sum())
}

/// Band by band.
pub(crate) fn times(a: &Bands, b: &Bands) -> Bands {
    std::array::from_fn(|band| a[band] * b[band])
}

/// From `a` to `b` as `share` goes from 0 to 1.
pub(crate) fn mix(a: &Bands, b: &Bands, share: f64) -> Bands {
    std::array::from_fn(|band| a[band] + (b[band] - a[band]) * share)
}

/// The spectrum scaled to luminance 1.
pub(crate) fn unit(spectrum: &Spectrum, observer: Observer) -> Result<Spectrum, ColourError> {
    let [_, y, _] = nacreous_colour::xyz(spectrum, observer);
    observer.weights(spectrum)?;
    Ok(spectrum * (1.0 / y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_hold_every_sample_once() {
        let counted: usize = (0..BANDS).map(|band| samples(band).len()).sum();
        assert_eq!((samples(0).start, samples(BANDS - 1).end, counted), (0, SAMPLES, SAMPLES));
    }
}
