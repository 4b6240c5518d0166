use std::sync::LazyLock;

use crate::{Index, NacreError, medium::Principal};

/// Measured between 397 and 687 nm at most; beyond, Cauchy's formula goes on smoothly but unproved
/// **(ours)**. Far out its even powers would run away.
const FIRST_NM: f64 = 300.0;
const LAST_NM: f64 = 1100.0;

/// A lossless medium whose indices follow Cauchy's formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dispersion {
    ordinary: Cauchy,
    extraordinary: Cauchy,
}

/// n = a + b / L^2 + c / L^4, L in micrometres.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cauchy([f64; 3]);

static FITS: LazyLock<Vec<(&str, &str, Cauchy)>> =
    LazyLock::new(|| fits(include_str!("../../../data/dispersion.csv")));

fn fits(text: &'static str) -> Vec<(&'static str, &'static str, Cauchy)> {
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    // The file is part of the program, and a test reads all of it.
    let number = |cell: &str| cell.parse().expect("data/dispersion.csv holds numbers");
    rows.map(|row| {
        let cells: Vec<&str> = row.split(',').collect();
        (cells[0], cells[1], Cauchy([number(cells[2]), number(cells[3]), number(cells[4])]))
    })
    .collect()
}

impl Dispersion {
    pub(crate) fn named(name: &str) -> Option<Self> {
        let fit = |component| {
            let found = FITS.iter().find(|fit| fit.0 == name && fit.1 == component);
            found.map(|fit| fit.2)
        };
        if let Some(isotropic) = fit("isotropic") {
            return Some(Self { ordinary: isotropic, extraordinary: isotropic });
        }
        let (alpha, beta, gamma) = (fit("alpha")?, fit("beta")?, fit("gamma")?);
        Some(Self { ordinary: beta.mean(gamma), extraordinary: alpha })
    }

    pub(crate) fn at(self, quantity: &str, wavelength_nm: f64) -> Result<Principal, NacreError> {
        let (first_nm, last_nm) = (FIRST_NM, LAST_NM);
        if !(first_nm..=last_nm).contains(&wavelength_nm) {
            let quantity = quantity.to_owned();
            return Err(NacreError::NotMeasured { quantity, wavelength_nm, first_nm, last_nm });
        }
        let index = |cauchy: Cauchy| Index::new(quantity, cauchy.n(wavelength_nm), 0.0);
        let (ordinary, extraordinary) = (index(self.ordinary)?, index(self.extraordinary)?);
        Ok(Principal { ordinary, extraordinary })
    }
}

impl Cauchy {
    fn n(self, wavelength_nm: f64) -> f64 {
        let [a, b, c] = self.0;
        let per_square = 1e6 / (wavelength_nm * wavelength_nm);
        a + (b + c * per_square) * per_square
    }

    fn mean(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| 0.5 * (self.0[i] + other.0[i])))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Medium;

    #[test]
    fn every_name_is_a_medium_and_every_fit_has_a_name() {
        for name in Medium::NAMES {
            assert!(Medium::named(name).is_some(), "{name}");
        }
        for (name, ..) in FITS.iter() {
            assert!(Medium::NAMES.contains(name), "{name}");
        }
        assert!(Medium::named("granite").is_none());
    }

    #[test]
    fn aragonite_goes_through_its_measured_lines() {
        let lines = include_str!("../../../data/aragonite_lines.csv");
        let aragonite = Medium::named("aragonite").unwrap();
        let mut seen = 0;
        for row in lines.lines().filter(|line| !line.starts_with('#')).skip(1) {
            let cell: Vec<f64> = row.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect();
            let indices = aragonite.at("aragonite", cell[0]).unwrap();
            assert!((indices.extraordinary.n() - cell[1]).abs() < 5e-5, "{row}");
            assert!((indices.ordinary.n() - 0.5 * (cell[2] + cell[3])).abs() < 1e-4, "{row}");
            seen += 1;
        }
        assert_eq!(seen, 7);
    }

    #[test]
    fn organic_layers_have_their_published_indices() {
        // Leertouwer 2011 and Perotto 2017, the formulas as printed.
        let n = |name, nm| Medium::named(name).unwrap().at(name, nm).unwrap().ordinary.n();
        assert!((n("chitin", 500.0) - (1.517 + 8.80e3 / 250_000.0)).abs() < 1e-14);
        assert!((n("silk-fibroin", 500.0) - (1.551 + 0.0026 * 4.0 + 2.4e-4 * 16.0)).abs() < 1e-14);
    }
}
