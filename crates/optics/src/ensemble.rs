//! Means over many stacks: what an eye sees of columns of tablets side by side.

use std::sync::atomic::{AtomicBool, Ordering};

use nacreous_nacre::LayerStack;

use crate::{
    OpticsError, Polarisation,
    incidence::{self, Block, Use},
    lanes::LANES,
    media::Table,
    tablets::{Columns, Tablets},
    transfer::{Origin, Precision, TransferModel, table},
};

/// R and T over stacks alike in statistics, each on its own: light of different columns is added by
/// energy. Tables `[angle, wavelength]`, flat and row-major; more columns can be added at any time.
#[derive(Debug, Clone, PartialEq)]
pub struct Ensemble {
    columns: usize,
    /// Means of R and T, sums of squared differences from them, one after the other.
    tables: Vec<f64>,
}

impl Ensemble {
    /// No column yet, for so many angles times wavelengths.
    pub fn empty(values: usize) -> Self {
        Self { columns: 0, tables: vec![0.0; 4 * values] }
    }

    /// Goes on after so many columns from what [`Self::into_flat`] gave.
    pub fn resumed(columns: usize, tables: Vec<f64>) -> Self {
        Self { columns, tables }
    }

    /// Mean reflectance.
    pub fn reflectance(&self) -> &[f64] {
        &self.tables[..self.tables.len() / 4]
    }

    /// Mean transmittance.
    pub fn transmittance(&self) -> &[f64] {
        let values = self.tables.len() / 4;
        &self.tables[values..2 * values]
    }

    /// `[means of R and T, sums of squared differences from them; angle, wavelength]`.
    pub fn into_flat(self) -> Vec<f64> {
        self.tables
    }

    /// Adds stacks of the same media, in their order; the result does not depend on how they are
    /// shared out among calls. `None`, and no table to use, once `stop` is set.
    ///
    /// # Errors
    /// [`OpticsError`] as [`TransferModel::energies`], for stacks of different media, and for angles and
    /// wavelengths of another table.
    ///
    /// ```
    /// use nacreous_nacre::{Index, LayerStack};
    /// use nacreous_optics::{Ensemble, TransferModel};
    /// let n = |n| Index::new("medium", n, 0.0).unwrap();
    /// let stack = |nm| LayerStack::new(vec![nm; 50], 20.0, n(1.53), n(1.43), n(1.0), n(1.53)).unwrap();
    /// let (model, never) = (TransferModel::default(), Default::default());
    /// let ensemble = Ensemble::empty(1);
    /// let ensemble = ensemble.with(model, &[stack(400.0), stack(410.0)], &[0.0], &[550.0], &never)?.unwrap();
    /// let alone = |nm| model.energies(&stack(nm), &[0.0], &[550.0], &never).unwrap().unwrap().reflectance()[0];
    /// assert!((ensemble.reflectance()[0] - 0.5 * (alone(400.0) + alone(410.0))).abs() < 1e-15);
    /// # Ok::<(), nacreous_optics::OpticsError>(())
    /// ```
    pub fn with(
        mut self,
        model: TransferModel,
        stacks: &[LayerStack],
        angle_rad: &[f64],
        wavelength_nm: &[f64],
        stop: &AtomicBool,
    ) -> Result<Option<Self>, OpticsError> {
        let Some(first) = stacks.first() else { return Ok(Some(self)) };
        let media = table(first, model.origin, angle_rad, wavelength_nm)?;
        if stacks.iter().any(|stack| !stack.has_media_of(first)) {
            return Err(OpticsError::DifferentMedia);
        }
        let values = angle_rad.len() * wavelength_nm.len();
        if self.tables.len() != 4 * values {
            return Err(OpticsError::DifferentTable { values, before: self.tables.len() / 4 });
        }
        let (means, squares) = self.tables.split_at_mut(2 * values);
        let (r, t) = means.split_at_mut(values);
        let (r_squares, t_squares) = squares.split_at_mut(values);
        let tables = [r, t, r_squares, t_squares];
        let columns = columns_of(stacks, &media, model.precision);
        let means = Means { before: self.columns, columns };
        incidence::fill(model, &media, angle_rad, tables, &means, stop);
        self.columns += stacks.len();
        Ok((!stop.load(Ordering::Relaxed)).then_some(self))
    }
}

/// What stacks alike in statistics mirror on average: of natural light, and of light in s and in p that comes from
/// aragonite above the first protein layer ([`Origin::Aragonite`]). Tables `[angle, wavelength]`, in single precision, to the
/// bit those of [`Ensemble::with`] three times, for little more than the time of one.
///
/// # Errors
/// As [`Ensemble::with`].
///
/// [`Origin::Aragonite`]: crate::Origin::Aragonite
pub fn reflectances(
    stacks: &[LayerStack],
    angle_rad: &[f64],
    wavelength_nm: &[f64],
    stop: &AtomicBool,
) -> Result<Option<[Vec<f64>; 3]>, OpticsError> {
    let mut tables = [(); 3].map(|()| vec![0.0; angle_rad.len() * wavelength_nm.len()]);
    let Some(first) = stacks.first() else { return Ok(Some(tables)) };
    let precision = Precision::Single;
    let model = TransferModel {
        polarisation: Polarisation::Unpolarised,
        precision,
        origin: Origin::Ambient,
    };
    let media = table(first, model.origin, angle_rad, wavelength_nm)?;
    if stacks.iter().any(|stack| !stack.has_media_of(first)) {
        return Err(OpticsError::DifferentMedia);
    }
    let mirrored = MirroredOfBoth(columns_of(stacks, &media, precision));
    let all = tables.each_mut().map(Vec::as_mut_slice);
    incidence::fill(model, &media, angle_rad, all, &mirrored, stop);
    Ok((!stop.load(Ordering::Relaxed)).then_some(tables))
}

/// Stacks of the same media, by runs of one thickness of protein.
fn columns_of<'a>(
    stacks: &'a [LayerStack],
    media: &Table,
    precision: Precision,
) -> Vec<Columns<'a>> {
    let alike = stacks.chunk_by(|a, b| a.protein_nm().to_bits() == b.protein_nm().to_bits());
    let columns = alike.map(|stacks| {
        let tabulated = precision == Precision::Single;
        Columns { stacks, tablets: tabulated.then(|| Tablets::new(stacks, media)) }
    });
    columns.collect()
}

/// Bilayers of all stacks together.
fn bilayers(columns: &[Columns<'_>]) -> usize {
    let stacks = columns.iter().flat_map(|columns| columns.stacks);
    stacks.map(|stack| stack.thickness_nm().len()).sum()
}

/// Mean R from the ambient, and of each polarisation from aragonite.
struct MirroredOfBoth<'a>(Vec<Columns<'a>>);

impl Use<3> for MirroredOfBoth<'_> {
    fn bilayers(&self) -> usize {
        bilayers(&self.0)
    }

    fn fill<const N: usize>(&self, block: &Block<'_, N>, tables: [&mut [f64]; 3]) {
        let mut means = [[0.0; LANES]; 3];
        let found = self.0.iter().flat_map(|columns| block.each_of_both(columns));
        for (column, shares) in found.enumerate() {
            let part = 1.0 / (column + 1) as f64;
            let within_aragonite = shares.aragonite.iter().map(|shares| &shares[0]);
            let all = std::iter::once(&shares.ambient[0]).chain(within_aragonite);
            for (mean, share) in means.iter_mut().zip(all) {
                for i in 0..LANES {
                    mean[i] += (share[i] - mean[i]) * part;
                }
            }
        }
        for (mean, table) in means.iter().zip(tables) {
            table.copy_from_slice(&mean[..table.len()]);
        }
    }
}

struct Means<'a> {
    /// Columns in the tables so far.
    before: usize,
    columns: Vec<Columns<'a>>,
}

impl Use<4> for Means<'_> {
    fn bilayers(&self) -> usize {
        bilayers(&self.columns)
    }

    fn fill<const N: usize>(&self, block: &Block<'_, N>, tables: [&mut [f64]; 4]) {
        let lanes = tables[0].len();
        let mut sums = [[0.0; LANES]; 4];
        for (sum, table) in sums.iter_mut().zip(&tables) {
            sum[..lanes].copy_from_slice(table);
        }
        let [r, t, r_squares, t_squares] = &mut sums;
        let found = self.columns.iter().flat_map(|columns| block.each(columns));
        for (column, shares) in found.enumerate() {
            let part = 1.0 / (self.before + column + 1) as f64;
            for (mean, squares, share) in
                [(&mut *r, &mut *r_squares, shares[0]), (t, t_squares, shares[1])]
            {
                // Welford 1962: no difference of large sums.
                for i in 0..LANES {
                    let step = share[i] - mean[i];
                    mean[i] += step * part;
                    squares[i] += step * (share[i] - mean[i]);
                }
            }
        }
        for (sum, table) in sums.iter().zip(tables) {
            table.copy_from_slice(&sum[..lanes]);
        }
    }
}

#[cfg(test)]
mod tests {
    use nacreous_nacre::Medium;

    use super::*;

    #[test]
    fn one_pass_finds_to_the_bit_what_three_find() {
        let n = |n| nacreous_nacre::Index::new("medium", n, 0.0).unwrap();
        let named = |name| Medium::named(name).unwrap();
        let stack = |i: usize, protein_nm| {
            let nm = (0..80).map(|layer| 330.0 + ((layer * 37 + 11 * i) % 60) as f64).collect();
            let (aragonite, chitin) = (named("aragonite"), named("chitin"));
            LayerStack::new(nm, protein_nm, aragonite.clone(), chitin, n(1.0), aragonite).unwrap()
        };
        let mut stacks: Vec<LayerStack> = (0..5).map(|i| stack(i, 20.0)).collect();
        stacks.push(stack(9, 25.0));
        let angle_rad: Vec<f64> = (0..7).map(|i| f64::from(i) * 0.25).collect();
        let nm: Vec<f64> = (0..101).map(|i| 380.0 + 4.0 * f64::from(i)).collect();
        let never = AtomicBool::new(false);
        let found = reflectances(&stacks, &angle_rad, &nm, &never).unwrap().unwrap();
        let asked = [
            (Polarisation::Unpolarised, Origin::Ambient),
            (Polarisation::S, Origin::Aragonite),
            (Polarisation::P, Origin::Aragonite),
        ];
        for ((polarisation, origin), found) in asked.into_iter().zip(found) {
            let model = TransferModel { polarisation, precision: Precision::Single, origin };
            let ensemble = Ensemble::empty(found.len());
            let mean = ensemble.with(model, &stacks, &angle_rad, &nm, &never).unwrap().unwrap();
            assert!(mean.reflectance() == found, "{polarisation:?}");
        }
    }
}
