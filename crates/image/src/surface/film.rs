use std::sync::atomic::AtomicBool;

use nacreous_colour::{SAMPLES, WAVELENGTH_NM};
use nacreous_nacre::LayerStack;
use nacreous_optics::{Ensemble, OpticsError, Polarisation, Precision, TransferModel};

use crate::light::bands::{self, BANDS, Bands};

/// What the outer layers of nacre mirror, by the cosine of the angle of incidence and band: exact
/// optics, the mean over columns of tablets. They absorb nothing, so the rest gets through.
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    /// By cosine, evenly from 0 (grazing) to 1.
    reflectance: Vec<Bands>,
    /// Modes of light in the nacre below, for each of the air's.
    modes: Bands,
}

/// Steps in the cosine. The rings of an ensemble are wider than a tenth.
pub(crate) const STEPS: usize = 128;

/// The columns in so many groups, each of which is asked every fourth nanometre: a band is the mean over all
/// of them, and no fringe of a column that is finer than 4 nm leaves a pattern.
const GROUPS: usize = 4;

const MODEL: TransferModel =
    TransferModel { polarisation: Polarisation::Unpolarised, precision: Precision::Single };

impl Film {
    /// `columns` are stacks of the same lossless media, alike in statistics. `None` once `stop` is set.
    ///
    /// # Errors
    /// What [`Ensemble::with`] refuses.
    pub fn new(columns: &[LayerStack], stop: &AtomicBool) -> Result<Option<Self>, OpticsError> {
        let mut draft = FilmDraft::new(columns.to_vec());
        loop {
            match draft.add(FilmDraft::ALL_ANGLES, stop)? {
                None => return Ok(None),
                Some(false) => {}
                Some(true) => return draft.film().map(Some),
            }
        }
    }

    /// A film that mirrors the same at every angle and wavelength, above nacre of index `n`.
    pub fn even(reflectance: f64, n: f64) -> Self {
        Self { reflectance: vec![[reflectance; BANDS]; STEPS + 1], modes: [n * n; BANDS] }
    }

    /// The share mirrored at a cosine.
    pub fn reflectance(&self, cosine: f64) -> Bands {
        at(&self.reflectance, cosine)
    }

    /// Modes of light in the nacre below, for each of the air's.
    pub(crate) fn modes(&self) -> &Bands {
        &self.modes
    }
}

/// A film in the making, some angles of a group of columns at a time. The film does not depend on how many.
#[derive(Debug, Clone)]
pub struct FilmDraft {
    columns: Vec<LayerStack>,
    by_nm: Vec<[f64; SAMPLES]>,
    /// Angles that are there, group after group.
    done: usize,
}

impl FilmDraft {
    /// All angles of a group of columns.
    pub const ALL_ANGLES: usize = STEPS + 1;

    /// Of the columns of a film.
    pub fn new(columns: Vec<LayerStack>) -> Self {
        Self { columns, by_nm: vec![[0.0; SAMPLES]; Self::ALL_ANGLES], done: 0 }
    }

    /// Adds up to so many angles, at least one; whether the film is complete. `None`, and nothing added, once
    /// `stop` is set.
    ///
    /// # Errors
    /// What [`Ensemble::with`] refuses.
    pub fn add(&mut self, angles: usize, stop: &AtomicBool) -> Result<Option<bool>, OpticsError> {
        let groups = if self.columns.len() < 2 * GROUPS { 1 } else { GROUPS };
        let (group, first) = (self.done / Self::ALL_ANGLES, self.done % Self::ALL_ANGLES);
        if group == groups {
            return Ok(Some(true));
        }
        let angle_rad: Vec<f64> =
            cosines().skip(first).take(angles.max(1)).map(libm::acos).collect();
        let some: Vec<LayerStack> =
            self.columns.iter().skip(group).step_by(groups).cloned().collect();
        let nm: Vec<f64> = WAVELENGTH_NM.iter().skip(group).step_by(groups).copied().collect();
        let empty = Ensemble::empty(angle_rad.len() * nm.len());
        let Some(mean) = empty.with(MODEL, &some, &angle_rad, &nm, stop)? else { return Ok(None) };
        let rows = self.by_nm.iter_mut().skip(first);
        for (row, found) in rows.zip(mean.reflectance().chunks_exact(nm.len())) {
            for (to, from) in row.iter_mut().skip(group).step_by(groups).zip(found) {
                *to = *from;
            }
        }
        self.done += angle_rad.len();
        Ok(Some(self.done == groups * Self::ALL_ANGLES))
    }

    /// The film, once it is complete.
    ///
    /// # Errors
    /// As [`FilmDraft::add`].
    pub fn film(&self) -> Result<Film, OpticsError> {
        let bands = |row: &[f64; SAMPLES]| bands::means(row).map(|r| r.clamp(0.0, 1.0));
        let reflectance = self.by_nm.iter().map(bands).collect();
        Ok(Film { reflectance, modes: modes(&self.columns)? })
    }
}

/// Cosines of the tables' rows.
pub(crate) fn cosines() -> impl Iterator<Item = f64> {
    (0..=STEPS).map(|step| step as f64 / STEPS as f64)
}

/// A row between the table's rows.
pub(crate) fn at(table: &[Bands], cosine: f64) -> Bands {
    let x = cosine.clamp(0.0, 1.0) * STEPS as f64;
    let i = (x as usize).min(STEPS - 1);
    bands::mix(&table[i], &table[i + 1], x - i as f64)
}

/// Waves across an area of a uniaxial medium with its axis along the normal fill two discs in their
/// wave vectors along it: of radius `n_o` for the ordinary wave, `n_e` for the extraordinary.
fn modes(columns: &[LayerStack]) -> Result<Bands, OpticsError> {
    let Some(first) = columns.first() else { return Ok([1.0; BANDS]) };
    let of_substrate = |nm: &f64| -> Result<f64, OpticsError> {
        let index = first.substrate().at("substrate", *nm)?;
        Ok(0.5 * (index.ordinary.n().powi(2) + index.extraordinary.n().powi(2)))
    };
    let by_nm = WAVELENGTH_NM.iter().map(of_substrate).collect::<Result<Vec<_>, _>>()?;
    Ok(bands::means(&by_nm))
}

#[cfg(test)]
mod tests {
    use nacreous_nacre::Index;

    use super::*;

    fn column(nm: f64) -> LayerStack {
        let n = |n| Index::new("medium", n, 0.0).unwrap();
        LayerStack::new(vec![nm; 60], 20.0, n(1.53), n(1.43), n(1.0), n(1.53)).unwrap()
    }

    #[test]
    fn a_film_is_the_mean_of_its_columns() {
        let never = AtomicBool::new(false);
        let film = |columns: &[LayerStack]| Film::new(columns, &never).unwrap().unwrap();
        let (a, b) = (film(&[column(380.0)]), film(&[column(420.0)]));
        let both = film(&[column(380.0), column(420.0)]);
        for cosine in [0.1, 0.63, 1.0] {
            let mean = bands::mix(&a.reflectance(cosine), &b.reflectance(cosine), 0.5);
            let seen = both.reflectance(cosine);
            assert!(mean.iter().zip(&seen).all(|(x, y)| (x - y).abs() < 1e-12));
        }
        assert!((both.modes()[7] - 1.53 * 1.53).abs() < 1e-12);
    }

    #[test]
    fn a_film_made_in_parts_is_the_same_to_the_bit() {
        let (columns, never) =
            ((0..9).map(|i| column(380.0 + f64::from(i))), AtomicBool::new(false));
        let columns: Vec<LayerStack> = columns.collect();
        let mut draft = FilmDraft::new(columns.clone());
        while !draft.add(50, &never).unwrap().unwrap() {
            assert_eq!(draft.add(50, &AtomicBool::new(true)), Ok(None));
        }
        assert_eq!(Film::new(&columns, &never), Ok(Some(draft.film().unwrap())));
    }

    #[test]
    fn grazing_light_is_mirrored_whole() {
        let film = Film::new(&[column(400.0)], &AtomicBool::new(false)).unwrap().unwrap();
        assert!(film.reflectance(0.0).iter().all(|r| (r - 1.0).abs() < 1e-9));
        assert_eq!(Film::new(&[column(400.0)], &AtomicBool::new(true)), Ok(None));
    }
}
