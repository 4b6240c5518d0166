use num_complex::Complex64;

use crate::{NacreError, error::within};

/// The refractive index n + ik of an isotropic medium, n > 0 and k >= 0.
///
/// Convention: waves run as exp(i(kx - wt)), so a positive k absorbs.
///
/// ```
/// use nacreous_nacre::Index;
/// let aragonite = Index::new("aragonite", 1.53, 0.0)?;
/// assert!(aragonite.is_lossless());
/// assert!(Index::new("aragonite", -1.53, 0.0).is_err());
/// # Ok::<(), nacreous_nacre::NacreError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    n: f64,
    k: f64,
}

impl Index {
    /// Aragonite as the paper has it, section 3.2: the value along its c axis.
    pub const PAPER_ARAGONITE: Self = Self { n: 1.53, k: 0.0 };
    /// The protein between the layers as the paper has it.
    pub const PAPER_PROTEIN: Self = Self { n: 1.43, k: 0.0 };

    /// # Errors
    /// [`NacreError::OutOfRange`], naming `medium`, unless 0 < n <= 100 and 0 <= k <= 100. Metals stay
    /// below 30; the bound keeps overflow out of the formulas.
    pub fn new(medium: &str, n: f64, k: f64) -> Result<Self, NacreError> {
        within(&format!("{medium}: n"), n, f64::MIN_POSITIVE..=100.0, "above 0, up to 100")?;
        within(&format!("{medium}: k"), k, 0.0..=100.0, "0 to 100")?;
        Ok(Self { n, k })
    }

    /// The real part.
    pub fn n(self) -> f64 {
        self.n
    }

    /// The imaginary part, the extinction coefficient.
    pub fn k(self) -> f64 {
        self.k
    }

    /// n + ik.
    pub fn complex(self) -> Complex64 {
        Complex64::new(self.n, self.k)
    }

    /// Whether light passes the medium without absorption.
    pub fn is_lossless(self) -> bool {
        self.k == 0.0
    }

    /// The way from this index to another, in a straight line: 0 is here, 1 is there.
    pub(crate) fn mixed(self, other: Self, share: f64) -> Self {
        let between = |from: f64, to: f64| from + share * (to - from);
        Self { n: between(self.n, other.n), k: between(self.k, other.k) }
    }
}
