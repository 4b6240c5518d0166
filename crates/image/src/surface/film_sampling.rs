//! How densely a film is asked: at which wavelengths, by which columns, at which angles.
//!
//! Cubics between angles (Catmull and Rom 1974), straight on beyond the ends of the wavelengths.
//! Left out: fringes finer than what is asked, which columns side by side blur.

use nacreous_colour::SAMPLES;

use crate::{
    light::bands::{BANDS, Bands},
    surface::film::{STEPS, cosines},
};

/// At which wavelengths and angles a film's columns are asked, in groups of columns that share the wavelengths out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FilmSampling {
    /// Each group is asked every so many nanometres, each at an offset of its own.
    every_nm: usize,
    /// With fewer columns a group, all columns are asked everywhere.
    fewest: usize,
    /// Samples of a spectrum that are asked; beyond, it goes on as it ends.
    asked: (usize, usize),
    /// Of the steps of the cosine, each of so many.
    every_step: usize,
}

impl FilmSampling {
    /// What a picture is made with: a band is the mean over all groups, and no fringe of a column that is finer than 4 nm
    /// leaves a pattern.
    pub const WHOLE: Self = Self { every_nm: 4, fewest: 2, asked: (0, SAMPLES), every_step: 1 };

    /// For the first picture after a change: a sixteenth of the wavelengths, a quarter of the angles. Of `akoya-rg` and four films like it, colours differ
    /// by CIEDE2000 0.3 to 0.4 in 95 of 100 pixels **(ours)**; 400 to 720 nm.
    pub const QUICK: Self = Self { every_nm: 16, fewest: 0, asked: (20, 341), every_step: 4 };

    /// Groups of wavelengths for so many columns.
    pub(crate) fn groups(&self, columns: usize) -> usize {
        if columns < self.fewest * self.every_nm { 1 } else { self.every_nm }
    }

    /// The columns of a group, by the first and the step from one to the next.
    pub(crate) fn columns(&self, group: usize, columns: usize) -> (usize, usize) {
        let shares = self.groups(columns).min(columns).max(1);
        (group % shares, shares)
    }

    /// The wavelengths of a group, as samples of a spectrum.
    pub(crate) fn samples(&self, group: usize, columns: usize) -> impl Iterator<Item = usize> {
        let (every, (first, end)) = (self.groups(columns), self.asked);
        (first..end).filter(move |sample| sample % every == group)
    }

    /// The cosines that are asked, from 0 up.
    pub(crate) fn cosines(&self) -> impl Iterator<Item = f64> {
        cosines().step_by(self.every_step)
    }

    /// How many.
    pub(crate) fn angles(&self) -> usize {
        STEPS / self.every_step + 1
    }

    /// A spectrum as it goes on beyond what was asked.
    pub(crate) fn ended(&self, mut spectrum: [f64; SAMPLES]) -> [f64; SAMPLES] {
        let (first, end) = self.asked;
        let (low, high) = (spectrum[first], spectrum[end - 1]);
        spectrum[..first].fill(low);
        spectrum[end..].fill(high);
        spectrum
    }

    /// Rows for all steps of the cosine, of those that were asked.
    pub(crate) fn all_rows(&self, asked: &[Bands]) -> Vec<Bands> {
        if self.every_step == 1 {
            return asked.to_vec();
        }
        let row = |step: usize| {
            let (i, on) = (step / self.every_step, step % self.every_step);
            between(asked, i, on as f64 / self.every_step as f64)
        };
        (0..=STEPS).map(row).collect()
    }
}

/// A share of the way from row `i` to the next, by a cubic.
fn between(rows: &[Bands], i: usize, share: f64) -> Bands {
    if share <= 0.0 {
        return rows[i];
    }
    let last = rows.len() - 1;
    let slope = |i: usize, band: usize| {
        let (below, above) = (i.saturating_sub(1), (i + 1).min(last));
        (rows[above][band] - rows[below][band]) / (above - below) as f64
    };
    let (t2, t3) = (share * share, share * share * share);
    std::array::from_fn::<f64, BANDS, _>(|band| {
        let (from, to) = (rows[i][band], rows[i + 1][band]);
        let straight = from * (2.0 * t3 - 3.0 * t2 + 1.0) + to * (3.0 * t2 - 2.0 * t3);
        let bent = slope(i, band) * (t3 - 2.0 * t2 + share) + slope(i + 1, band) * (t3 - t2);
        (straight + bent).clamp(0.0, 1.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_share_all_wavelengths_and_all_columns_out() {
        for (sampling, columns) in [
            (FilmSampling::WHOLE, 64),
            (FilmSampling::WHOLE, 3),
            (FilmSampling::QUICK, 64),
            (FilmSampling::QUICK, 7),
        ] {
            let groups = sampling.groups(columns);
            let mut samples: Vec<usize> =
                (0..groups).flat_map(|group| sampling.samples(group, columns)).collect();
            samples.sort_unstable();
            assert_eq!(samples, (sampling.asked.0..sampling.asked.1).collect::<Vec<_>>());
            let mut of_all: Vec<usize> = (0..groups)
                .map(|group| sampling.columns(group, columns))
                .flat_map(|(first, step)| (first..columns).step_by(step))
                .collect();
            of_all.sort_unstable();
            of_all.dedup();
            assert_eq!(of_all, (0..columns).collect::<Vec<_>>());
        }
    }

    #[test]
    fn between_angles_lies_what_a_parabola_would_be() {
        let quick = FilmSampling::QUICK;
        let law = |cosine: f64| [0.9 - 1.2 * cosine + 0.5 * cosine * cosine; BANDS];
        let rows: Vec<Bands> = quick.cosines().map(law).collect();
        for (found, cosine) in quick.all_rows(&rows).iter().zip(cosines()) {
            // At both ends slopes are one-sided.
            let bound = if (0.04..0.96).contains(&cosine) { 1e-12 } else { 1e-4 };
            assert!((found[3] - law(cosine)[3]).abs() < bound, "{cosine}");
        }
    }
}
