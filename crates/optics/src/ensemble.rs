//! Means over many stacks: what an eye sees of columns of tablets side by side.

use std::sync::atomic::{AtomicBool, Ordering};

use nacreous_nacre::LayerStack;

use crate::{
    OpticsError,
    incidence::{self, Block, Use},
    lanes::LANES,
    tablets::{Columns, Tablets},
    transfer::{Precision, TransferModel, table},
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
        let alike = stacks.chunk_by(|a, b| a.protein_nm().to_bits() == b.protein_nm().to_bits());
        let columns = alike.map(|stacks| {
            let tabulated = model.precision == Precision::Single;
            Columns { stacks, tablets: tabulated.then(|| Tablets::new(stacks, &media)) }
        });
        let means = Means { before: self.columns, columns: columns.collect() };
        incidence::fill(model, &media, angle_rad, tables, &means, stop);
        self.columns += stacks.len();
        Ok((!stop.load(Ordering::Relaxed)).then_some(self))
    }
}

struct Means<'a> {
    /// Columns in the tables so far.
    before: usize,
    columns: Vec<Columns<'a>>,
}

impl Use<4> for Means<'_> {
    fn bilayers(&self) -> usize {
        let stacks = self.columns.iter().flat_map(|columns| columns.stacks);
        stacks.map(|stack| stack.thickness_nm().len()).sum()
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
