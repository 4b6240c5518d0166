use std::sync::Arc;

use num_complex::Complex64;

use crate::{
    Index, NacreError,
    dispersion::Dispersion,
    error::{said_nm, within},
};

/// What a layer, the surroundings or the core is made of: a refractive index, for each direction and
/// each wavelength.
///
/// Anisotropic media are uniaxial with their axis along the layers' normal, which is how aragonite
/// stands in nacre.
///
/// ```
/// use nacreous_nacre::{Index, Medium};
/// let glass = Medium::from(Index::new("glass", 1.5, 0.0)?);
/// assert_eq!(glass.at("glass", 550.0)?.ordinary.n(), 1.5);
/// let aragonite = Medium::named("aragonite").unwrap().at("aragonite", 589.3)?;
/// assert!((aragonite.ordinary.n() - 1.6837).abs() < 1e-4);
/// assert!((aragonite.extraordinary.n() - 1.5301).abs() < 1e-4);
/// # Ok::<(), nacreous_nacre::NacreError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Medium(Kind);

#[derive(Debug, Clone, PartialEq)]
enum Kind {
    Constant(Principal),
    Formula(Dispersion),
    Table(Arc<Table>),
}

/// The principal indices at one wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Principal {
    /// For the electric field along the layers.
    pub ordinary: Index,
    /// For the electric field along their normal.
    pub extraordinary: Index,
}

/// Indices at some wavelengths, straight lines between them.
#[derive(Debug, PartialEq)]
struct Table {
    wavelength_nm: Vec<f64>,
    principal: Vec<Principal>,
}

impl Medium {
    /// The media that [`Medium::named`] knows; sources in `data/dispersion.csv`.
    pub const NAMES: [&'static str; 5] =
        ["aragonite", "aragonite-isotropic-1.53", "chitin", "silk-fibroin", "protein-1.43"];

    /// A uniaxial medium, axis along the layers' normal.
    pub fn uniaxial(ordinary: Index, extraordinary: Index) -> Self {
        Self(Kind::Constant(Principal { ordinary, extraordinary }))
    }

    /// A measured medium, or one of the paper's constants, by its name.
    ///
    /// `aragonite` is uniaxial and dispersive. Its two indices across c differ by 0.005; grains of
    /// nacre lie turned about c, so their mean stands for both **(ours)**.
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "aragonite-isotropic-1.53" => Some(Index::PAPER_ARAGONITE.into()),
            "protein-1.43" => Some(Index::PAPER_PROTEIN.into()),
            name => Dispersion::named(name).map(|formula| Self(Kind::Formula(formula))),
        }
    }

    /// A medium measured at some wavelengths; between them indices are interpolated linearly.
    ///
    /// # Errors
    /// [`NacreError`], naming `quantity`, unless there are as many indices as wavelengths, the
    /// wavelengths rise, and every index is as [`Index::new`] asks.
    pub fn table(
        quantity: &str,
        wavelength_nm: Vec<f64>,
        ordinary: &[Complex64],
        extraordinary: &[Complex64],
    ) -> Result<Self, NacreError> {
        let rows = wavelength_nm.len();
        if rows == 0 || ordinary.len() != rows || extraordinary.len() != rows {
            let quantity = quantity.to_owned();
            let indices = ordinary.len().min(extraordinary.len());
            return Err(NacreError::TableShape { quantity, wavelengths: rows, indices });
        }
        let mut last_nm = 0.0;
        for &nm in &wavelength_nm {
            within(&format!("{quantity}: wavelength_nm"), nm, 1.0..=1e6, "1 to 1000000 nm")?;
            if nm <= last_nm {
                let quantity = quantity.to_owned();
                return Err(NacreError::TableOrder { quantity, last_nm, nm });
            }
            last_nm = nm;
        }
        let principal = wavelength_nm
            .iter()
            .zip(ordinary.iter().zip(extraordinary))
            .map(|(nm, (o, e))| {
                let place = format!("{quantity} at {} nm", said_nm(*nm));
                Ok(Principal {
                    ordinary: Index::new(&place, o.re, o.im)?,
                    extraordinary: Index::new(&place, e.re, e.im)?,
                })
            })
            .collect::<Result<_, NacreError>>()?;
        Ok(Self(Kind::Table(Arc::new(Table { wavelength_nm, principal }))))
    }

    /// The principal indices at a wavelength.
    ///
    /// # Errors
    /// [`NacreError::OutOfRange`], naming `quantity`, for a wavelength outside a table or a formula.
    pub fn at(&self, quantity: &str, wavelength_nm: f64) -> Result<Principal, NacreError> {
        match &self.0 {
            Kind::Constant(principal) => Ok(*principal),
            Kind::Formula(formula) => formula.at(quantity, wavelength_nm),
            Kind::Table(table) => table.at(quantity, wavelength_nm),
        }
    }

    /// The indices of a medium that is the same at every wavelength.
    pub fn constant(&self) -> Option<Principal> {
        match &self.0 {
            Kind::Constant(principal) => Some(*principal),
            Kind::Formula(_) | Kind::Table(_) => None,
        }
    }

    /// The one index of a medium that is the same at every wavelength and in every direction.
    ///
    /// # Errors
    /// [`NacreError::NotConstant`], naming `quantity`, for any other.
    pub fn index(&self, quantity: &'static str) -> Result<Index, NacreError> {
        match self.constant() {
            Some(principal) if principal.ordinary == principal.extraordinary => {
                Ok(principal.ordinary)
            }
            Some(_) => Err(NacreError::NotConstant { quantity, fault: "direction" }),
            None => Err(NacreError::NotConstant { quantity, fault: "wavelength" }),
        }
    }
}

impl From<Index> for Medium {
    fn from(index: Index) -> Self {
        Self::uniaxial(index, index)
    }
}

impl Table {
    fn at(&self, quantity: &str, wavelength_nm: f64) -> Result<Principal, NacreError> {
        let nm = &self.wavelength_nm;
        let (first_nm, last_nm) = (nm[0], nm[nm.len() - 1]);
        if !(first_nm..=last_nm).contains(&wavelength_nm) {
            let quantity = quantity.to_owned();
            return Err(NacreError::NotMeasured { quantity, wavelength_nm, first_nm, last_nm });
        }
        let above = match nm.binary_search_by(|at| at.total_cmp(&wavelength_nm)) {
            Ok(measured) => return Ok(self.principal[measured]), // to the last bit
            Err(above) => above,
        };
        let share = (wavelength_nm - nm[above - 1]) / (nm[above] - nm[above - 1]);
        let (low, high) = (self.principal[above - 1], self.principal[above]);
        Ok(Principal {
            ordinary: low.ordinary.mixed(high.ordinary, share),
            extraordinary: low.extraordinary.mixed(high.extraordinary, share),
        })
    }
}
