//! A film in the making: exact optics of its columns, some angles at a time.
//!
//! Means over columns of tablets; Airy's sum where surface and layers are apart.
//! Left out: how long it takes, which whoever asks decides by the angles.

use std::sync::atomic::AtomicBool;

use nacreous_colour::{SAMPLES, WAVELENGTH_NM};
use nacreous_nacre::LayerStack;
use nacreous_optics::{
    Ensemble, OpticsError, Origin, Polarisation, Precision, TransferModel, reflectances,
};

use crate::{
    light::bands::{self, BANDS, Bands},
    surface::{
        film::{Apart, Film, Mirrors, STEPS, cosines},
        film_sampling::FilmSampling,
        waviness::FilmParts,
    },
};

/// Shares by wavelength, at each of the cosines that are asked.
type Spectra = Vec<[f64; SAMPLES]>;

/// A film in the making, some angles of a group of columns at a time. The film does not depend on how many.
#[derive(Debug, Clone)]
pub struct FilmDraft {
    columns: Vec<LayerStack>,
    parts: FilmParts,
    sampling: FilmSampling,
    /// What surface and layers mirror together.
    together: Option<Spectra>,
    /// What the layers mirror to light from above them, in s and p.
    layers: Option<[Spectra; 2]>,
    /// Angles that are there, group after group.
    done: usize,
}

impl FilmDraft {
    /// All angles of a group of columns.
    pub const ALL_ANGLES: usize = STEPS + 1;

    /// Of the columns of a film.
    pub fn new(columns: Vec<LayerStack>, parts: FilmParts, sampling: FilmSampling) -> Self {
        let empty = || vec![[0.0; SAMPLES]; sampling.angles()];
        Self {
            columns,
            parts,
            sampling,
            together: (parts != FilmParts::Apart).then(empty),
            layers: (parts != FilmParts::Together).then(|| [empty(), empty()]),
            done: 0,
        }
    }

    /// Adds up to so many angles, at least one; whether the film is complete. `None`, and nothing to use, once
    /// `stop` is set.
    ///
    /// # Errors
    /// What [`Ensemble::with`] refuses.
    pub fn add(&mut self, angles: usize, stop: &AtomicBool) -> Result<Option<bool>, OpticsError> {
        let (sampling, columns) = (self.sampling, self.columns.len());
        let (group, first) = (self.done / sampling.angles(), self.done % sampling.angles());
        if group == sampling.groups(columns) {
            return Ok(Some(true));
        }
        let angle_rad: Vec<f64> =
            sampling.cosines().skip(first).take(angles.max(1)).map(libm::acos).collect();
        let Some(found) = self.asked(group, &angle_rad, stop)? else { return Ok(None) };
        self.put(group, first, &found);
        self.done += angle_rad.len();
        Ok(Some(self.done == sampling.groups(columns) * sampling.angles()))
    }

    /// Groups of columns and wavelengths, each of which can be worked out by itself.
    pub fn groups(&self) -> usize {
        self.sampling.groups(self.columns.len())
    }

    /// All angles of one group, for a draft of the same film elsewhere. `None` once `stop` is set.
    ///
    /// # Errors
    /// What [`Ensemble::with`] refuses.
    pub fn group(&self, group: usize, stop: &AtomicBool) -> Result<Option<Vec<f64>>, OpticsError> {
        let angle_rad: Vec<f64> = self.sampling.cosines().map(libm::acos).collect();
        Ok(self.asked(group, &angle_rad, stop)?.map(|tables| tables.concat()))
    }

    /// How many numbers a group has.
    pub fn numbers(&self, group: usize) -> usize {
        let tables = self.together.iter().chain(self.layers.iter().flatten()).count();
        let samples = self.sampling.samples(group, self.columns.len()).count();
        tables * self.sampling.angles() * samples
    }

    /// The same draft, complete, from what [`FilmDraft::group`] gave of each group; `None` where these are not all numbers
    /// of all groups.
    #[must_use]
    pub fn completed(mut self, groups: &[&[f64]]) -> Option<Self> {
        let (columns, angles) = (self.columns.len(), self.sampling.angles());
        if groups.len() != self.groups() {
            return None;
        }
        for (group, numbers) in groups.iter().enumerate() {
            let each = angles * self.sampling.samples(group, columns).count();
            if numbers.len() != self.numbers(group) {
                return None;
            }
            let found: Vec<Vec<f64>> = numbers.chunks(each).map(<[f64]>::to_vec).collect();
            self.put(group, 0, &found);
        }
        self.done = groups.len() * angles;
        Some(self)
    }

    /// Tables of a group of columns at its wavelengths and some angles.
    fn asked(
        &self,
        group: usize,
        angle_rad: &[f64],
        stop: &AtomicBool,
    ) -> Result<Option<Vec<Vec<f64>>>, OpticsError> {
        let (sampling, columns) = (self.sampling, self.columns.len());
        let (first, step) = sampling.columns(group, columns);
        let some: Vec<LayerStack> =
            self.columns.iter().skip(first).step_by(step).cloned().collect();
        let nm: Vec<f64> =
            sampling.samples(group, columns).map(|sample| WAVELENGTH_NM[sample]).collect();
        mirrored(self.parts, &some, angle_rad, &nm, stop)
    }

    /// Keeps tables of a group, from an angle on.
    fn put(&mut self, group: usize, first: usize, found: &[Vec<f64>]) {
        let samples: Vec<usize> = self.sampling.samples(group, self.columns.len()).collect();
        let tables = self.together.iter_mut().chain(self.layers.iter_mut().flatten());
        for (table, found) in tables.zip(found) {
            let rows = table.iter_mut().skip(first);
            for (row, found) in rows.zip(found.chunks_exact(samples.len())) {
                for (&sample, share) in samples.iter().zip(found) {
                    row[sample] = *share;
                }
            }
        }
    }

    /// The film, once it is complete.
    ///
    /// # Errors
    /// As [`FilmDraft::add`].
    pub fn film(&self) -> Result<Film, OpticsError> {
        self.film_of(1.0)
    }

    /// The film with all layers so many times as thick, once it is complete: its spectra at wavelengths so many times as
    /// long. Dispersion between both is left out, and beyond 380 and 780 nm spectra are as they are there.
    ///
    /// # Errors
    /// As [`FilmDraft::add`].
    pub fn film_of(&self, thickness: f64) -> Result<Film, OpticsError> {
        let sampling = self.sampling;
        let bands = |spectra: &[[f64; SAMPLES]]| {
            let ended: Spectra = spectra.iter().map(|row| sampling.ended(*row)).collect();
            sampling.all_rows(&match thickness {
                1.0 => in_bands(&ended),
                _ => in_bands(&stretched(&ended, thickness)),
            })
        };
        let together = self.together.as_deref().map(bands);
        let layers = self
            .layers
            .as_ref()
            .map(|spectra| apart(&self.columns, &spectra.each_ref().map(|plane| bands(plane))))
            .transpose()?;
        let mirrors = match (together, layers) {
            (Some(together), Some(apart)) => Mirrors::Both(together, apart),
            (None, Some(apart)) => Mirrors::Apart(apart),
            (together, None) => Mirrors::Together(together.unwrap_or_default()),
        };
        let Some(first) = self.columns.first() else {
            return Ok(Film::of(mirrors, &[1.0; BANDS], 1.0));
        };
        Ok(Film::of(mirrors, &modes(first)?, index(first)?))
    }
}

/// What columns mirror on average, as tables `[angle, wavelength]`: together where surface and layers are, and the layers in s
/// and p where they are apart. `None` once `stop` is set.
fn mirrored(
    parts: FilmParts,
    columns: &[LayerStack],
    angle_rad: &[f64],
    nm: &[f64],
    stop: &AtomicBool,
) -> Result<Option<Vec<Vec<f64>>>, OpticsError> {
    if parts != FilmParts::Together {
        let all = reflectances(columns, angle_rad, nm, stop)?;
        let skipped = usize::from(parts == FilmParts::Apart);
        return Ok(all.map(|all| all.into_iter().skip(skipped).collect()));
    }
    let (polarisation, origin) = (Polarisation::Unpolarised, Origin::Ambient);
    let model = TransferModel { polarisation, precision: Precision::Single, origin };
    let empty = Ensemble::empty(angle_rad.len() * nm.len());
    let mean = empty.with(model, columns, angle_rad, nm, stop)?;
    Ok(mean.map(|mean| vec![mean.reflectance().to_vec()]))
}

impl Film {
    /// `columns` are stacks of the same lossless media, alike in statistics. `None` once `stop` is set.
    ///
    /// # Errors
    /// What [`Ensemble::with`] refuses.
    pub fn new(
        columns: &[LayerStack],
        parts: FilmParts,
        stop: &AtomicBool,
    ) -> Result<Option<Self>, OpticsError> {
        let mut draft = FilmDraft::new(columns.to_vec(), parts, FilmSampling::WHOLE);
        loop {
            match draft.add(FilmDraft::ALL_ANGLES, stop)? {
                None => return Ok(None),
                Some(false) => {}
                Some(true) => return draft.film().map(Some),
            }
        }
    }
}

/// Spectra of layers so many times as thick: each wavelength takes what one so many times shorter had.
fn stretched(spectra: &[[f64; SAMPLES]], thickness: f64) -> Spectra {
    let (first, last) = (WAVELENGTH_NM[0], (SAMPLES - 1) as f64);
    let row = |row: &[f64; SAMPLES]| {
        std::array::from_fn(|i| {
            let at = (WAVELENGTH_NM[i] / thickness - first).clamp(0.0, last);
            let below = (at as usize).min(SAMPLES - 2);
            row[below] + (row[below + 1] - row[below]) * (at - below as f64)
        })
    };
    spectra.iter().map(row).collect()
}

fn in_bands(spectra: &[[f64; SAMPLES]]) -> Vec<Bands> {
    spectra.iter().map(|row| bands::means(row).map(|share| share.clamp(0.0, 1.0))).collect()
}

/// Surface and layers without a phase between them, of what the `layers` mirror in s and p: light goes to and
/// fro between both (Airy's sum, the mean over all phases).
fn apart(columns: &[LayerStack], layers: &[Vec<Bands>; 2]) -> Result<Apart, OpticsError> {
    let mut apart = Apart { surface: Vec::new(), layers: Vec::new() };
    let Some(first) = columns.first() else { return Ok(apart) };
    let surface = [boundary(first, Polarisation::S)?, boundary(first, Polarisation::P)?];
    for row in 0..=STEPS {
        let mean = |of: &dyn Fn(f64, f64) -> f64| -> Bands {
            std::array::from_fn(|band| {
                let of_plane =
                    |plane: usize| of(surface[plane][row][band], layers[plane][row][band]);
                0.5 * (of_plane(0) + of_plane(1))
            })
        };
        apart.surface.push(mean(&|r_s, _| r_s));
        apart.layers.push(mean(&|r_s, r_i| {
            // All of grazing light goes back at the surface.
            let passing = (1.0 - r_s).max(0.0);
            if passing > 0.0 { passing * passing * r_i / (1.0 - r_s * r_i) } else { 0.0 }
        }));
    }
    Ok(apart)
}

/// What the boundary to the outermost aragonite mirrors by itself, at each of the cosines.
fn boundary(of: &LayerStack, polarisation: Polarisation) -> Result<Vec<Bands>, OpticsError> {
    let (aragonite, protein, ambient) = (of.aragonite(), of.protein(), of.ambient());
    let (aragonite, ambient) = (aragonite.clone(), ambient.clone());
    // A layer on its own medium, and nothing between.
    let alone =
        LayerStack::new(vec![100.0], 0.0, aragonite.clone(), protein.clone(), ambient, aragonite)?;
    let model = TransferModel { polarisation, ..TransferModel::default() };
    let angle_rad: Vec<f64> = cosines().map(libm::acos).collect();
    let never = AtomicBool::new(false);
    let shares = model.energies(&alone, &angle_rad, &WAVELENGTH_NM, &never)?;
    let rows = shares.iter().flat_map(|shares| shares.reflectance().chunks_exact(SAMPLES));
    Ok(rows.map(|row| bands::means(row).map(|share| share.clamp(0.0, 1.0))).collect())
}

/// Waves across an area of a uniaxial medium with its axis along the normal fill two discs in their
/// wave vectors along it: of radius `n_o` for the ordinary wave, `n_e` for the extraordinary.
fn modes(of: &LayerStack) -> Result<Bands, OpticsError> {
    let of_substrate = |nm: &f64| -> Result<f64, OpticsError> {
        let index = of.substrate().at("substrate", *nm)?;
        Ok(0.5 * (index.ordinary.n().powi(2) + index.extraordinary.n().powi(2)))
    };
    let by_nm = WAVELENGTH_NM.iter().map(of_substrate).collect::<Result<Vec<_>, _>>()?;
    Ok(bands::means(&by_nm))
}

/// Of aragonite over the ambient's, where the eye sees most; what is optically thinner than the ambient counts as it.
fn index(of: &LayerStack) -> Result<f64, OpticsError> {
    const NM: f64 = 550.0;
    let n = |name, medium: &nacreous_nacre::Medium| medium.at(name, NM).map(|at| at.ordinary.n());
    Ok((n("aragonite", of.aragonite())? / n("ambient", of.ambient())?).max(1.0))
}

#[cfg(test)]
mod tests {
    use nacreous_nacre::Index;

    use super::*;

    const ALL: [FilmParts; 3] = [FilmParts::Together, FilmParts::Apart, FilmParts::Both];

    fn column(nm: f64) -> LayerStack {
        let n = |n| Index::new("medium", n, 0.0).unwrap();
        LayerStack::new(vec![nm; 60], 20.0, n(1.53), n(1.43), n(1.0), n(1.53)).unwrap()
    }

    fn film(columns: &[LayerStack], parts: FilmParts) -> Film {
        Film::new(columns, parts, &AtomicBool::new(false)).unwrap().unwrap()
    }

    #[test]
    fn a_film_is_the_mean_of_its_columns() {
        let together = FilmParts::Together;
        let (a, b) = (film(&[column(380.0)], together), film(&[column(420.0)], together));
        let both = film(&[column(380.0), column(420.0)], together);
        for cosine in [0.1, 0.63, 1.0] {
            let mean = bands::mix(&a.reflectance(cosine), &b.reflectance(cosine), 0.5);
            let seen = both.reflectance(cosine);
            assert!(mean.iter().zip(&seen).all(|(x, y)| (x - y).abs() < 1e-12));
        }
        assert!((both.modes()[7] - 1.53 * 1.53).abs() < 1e-12);
    }

    #[test]
    fn a_film_made_in_parts_is_the_same_to_the_bit() {
        let columns: Vec<LayerStack> = (0..9).map(|i| column(380.0 + f64::from(i))).collect();
        let never = AtomicBool::new(false);
        for parts in ALL {
            let mut draft = FilmDraft::new(columns.clone(), parts, FilmSampling::WHOLE);
            while !draft.add(50, &never).unwrap().unwrap() {
                assert_eq!(draft.add(50, &AtomicBool::new(true)), Ok(None));
            }
            assert_eq!(film(&columns, parts), draft.film().unwrap());
        }
    }

    #[test]
    fn a_film_of_groups_worked_out_elsewhere_is_the_same_to_the_bit() {
        let columns: Vec<LayerStack> = (0..9).map(|i| column(380.0 + f64::from(i))).collect();
        let never = AtomicBool::new(false);
        for parts in ALL {
            let draft = || FilmDraft::new(columns.clone(), parts, FilmSampling::WHOLE);
            let group = |group| draft().group(group, &never).unwrap().unwrap();
            let groups: Vec<Vec<f64>> = (0..draft().groups()).map(group).collect();
            let all: Vec<&[f64]> = groups.iter().map(Vec::as_slice).collect();
            let together = draft().completed(&all).unwrap().film().unwrap();
            assert_eq!(film(&columns, parts), together);
            assert!(draft().completed(&all[1..]).is_none());
            assert!(draft().completed(&[all[0], all[1], all[2], &all[3][1..]]).is_none());
        }
    }

    #[test]
    fn grazing_light_is_mirrored_whole() {
        for parts in ALL {
            let film = film(&[column(400.0)], parts);
            assert!(film.reflectance(0.0).iter().all(|r| (r - 1.0).abs() < 1e-9), "{parts:?}");
        }
        let stopped = Film::new(&[column(400.0)], FilmParts::Both, &AtomicBool::new(true));
        assert_eq!(stopped, Ok(None));
    }

    #[test]
    fn apart_they_mirror_the_mean_over_all_phases_between_them() {
        // Outermost layers through a fringe of the longest wave, in even steps.
        let columns: Vec<LayerStack> = (0..64)
            .map(|step| {
                let mut nm = vec![400.0; 60];
                nm[0] = 4000.0 + f64::from(step) / 64.0 * 8.0 * 780.0 / (2.0 * 1.53);
                column(400.0).with_layers(nm).unwrap()
            })
            .collect();
        let (together, apart) =
            (film(&columns, FilmParts::Together), film(&columns, FilmParts::Apart));
        for cosine in [1.0, 0.8] {
            let rows = together.reflectance(cosine).into_iter().zip(apart.reflectance(cosine));
            let worst = rows.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(worst < 0.015, "{cosine}: {worst}");
        }
    }
}
