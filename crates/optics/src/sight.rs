//! Snell and Fresnel along one line of sight, for the illuminant model.

use nacreous_nacre::LayerStack;
use num_complex::Complex64;

use crate::{
    OpticsError,
    fresnel::boundary,
    lanes::{LANES, Lanes},
};

/// n0, n1, n2 of the paper at one wavelength: real, the same in every direction, and none below n0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Indices([f64; 3]);

impl Indices {
    pub(crate) fn of(
        stack: &LayerStack,
        wavelength_nm: &Lanes<f64>,
    ) -> Result<[Self; LANES], OpticsError> {
        let mut indices = [Self([0.0; 3]); LANES];
        for (slot, &nm) in indices.iter_mut().zip(wavelength_nm) {
            *slot = Self::at(stack, nm)?;
        }
        Ok(indices)
    }

    fn at(stack: &LayerStack, wavelength_nm: f64) -> Result<Self, OpticsError> {
        let media = [
            ("ambient", stack.ambient()),
            ("aragonite", stack.aragonite()),
            ("protein", stack.protein()),
        ];
        let mut indices = [0.0; 3];
        for (i, (medium, of)) in media.into_iter().enumerate() {
            let principal = of.at(medium, wavelength_nm)?;
            let index = principal.ordinary;
            if index != principal.extraordinary {
                return Err(OpticsError::Anisotropic { medium });
            }
            if !index.is_lossless() {
                return Err(OpticsError::Absorbing { medium, k: index.k() });
            }
            let (n, ambient) = (index.n(), indices[0]);
            if n < ambient {
                return Err(OpticsError::TotalReflection { medium, n, ambient });
            }
            indices[i] = n;
        }
        Ok(Self(indices))
    }
}

/// A line of sight in the ambient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Direction {
    sin_theta_0: f64,
    cos_theta_0: f64,
}

impl Direction {
    pub(crate) fn new(theta_0: f64) -> Self {
        Self { sin_theta_0: theta_0.sin(), cos_theta_0: theta_0.cos() }
    }
}

/// What does not change along one line of sight, lane by lane.
pub(crate) struct Sight {
    /// 2 n1 cos(theta_1): path difference per nm of aragonite.
    pub(crate) path_per_nm: Lanes<f64>,
    /// 2 n2 d_p cos(theta_2): path difference of the two faces of a protein layer.
    pub(crate) protein_path_nm: Lanes<f64>,
    pub(crate) t1: Lanes<f64>,
    pub(crate) r2_s: Lanes<f64>,
    pub(crate) r2_p: Lanes<f64>,
}

impl Sight {
    pub(crate) fn new(protein_nm: f64, light: &Lanes<(Indices, Direction)>) -> Self {
        let none = [0.0; LANES];
        let mut sight =
            Self { path_per_nm: none, protein_path_nm: none, t1: none, r2_s: none, r2_p: none };
        for lane in 0..LANES {
            if lane > 0 && light[lane] == light[lane - 1] {
                sight.repeat(lane);
            } else {
                sight.meet(lane, protein_nm, light[lane]);
            }
        }
        sight
    }

    /// Steps 1 and 2 of section 3 of docs/model.md.
    fn meet(&mut self, lane: usize, protein_nm: f64, (indices, direction): (Indices, Direction)) {
        let Indices([n0, n1, n2]) = indices;
        let Direction { sin_theta_0, cos_theta_0 } = direction;
        // Not quite 0 at grazing, where a medium that is no denser than its neighbour gives 0 / 0.
        let cos2 = |n: f64| 1.0 - (n0 / n * sin_theta_0).powi(2);
        let snell = |n: f64| cos2(n).max(f64::MIN_POSITIVE).sqrt();
        let (cos_theta_1, cos_theta_2) = (snell(n1), snell(n2));
        // T1 is the same both ways; from outside it is exact at grazing, where theta_1 loses digits.
        let surface = boundary(Complex64::from(n0), Complex64::from(n1), cos_theta_0);
        let inner = boundary(Complex64::from(n1), Complex64::from(n2), cos_theta_1);
        self.path_per_nm[lane] = 2.0 * n1 * cos_theta_1;
        self.protein_path_nm[lane] = 2.0 * n2 * protein_nm * cos_theta_2;
        self.t1[lane] = surface.T().max(0.0);
        self.r2_s[lane] = inner.r_s.re;
        self.r2_p[lane] = inner.r_p.re;
    }

    /// What the lane before has.
    fn repeat(&mut self, lane: usize) {
        let Self { path_per_nm, protein_path_nm, t1, r2_s, r2_p } = self;
        for lanes in [path_per_nm, protein_path_nm, t1, r2_s, r2_p] {
            lanes[lane] = lanes[lane - 1];
        }
    }
}
