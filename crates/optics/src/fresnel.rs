use std::f64::consts::FRAC_PI_2;

use nacreous_nacre::Index;
use num_complex::Complex64;

use crate::{OpticsError, error::within};

/// What one smooth boundary does to a plane wave: amplitudes of both polarisations, then energies.
///
/// `r_p` has the paper's sign, equal to `r_s` at normal incidence (some books have the opposite).
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(non_snake_case)] // R and T are the paper's letters for energies, r and t for amplitudes.
pub struct Fresnel {
    /// Reflected amplitude, electric field across the plane of incidence.
    pub r_s: Complex64,
    /// Reflected amplitude, electric field in the plane of incidence.
    pub r_p: Complex64,
    /// Transmitted amplitude, s.
    pub t_s: Complex64,
    /// Transmitted amplitude, p.
    pub t_p: Complex64,
    /// Reflected share of the energy, s.
    pub R_s: f64,
    /// Reflected share of the energy, p.
    pub R_p: f64,
    /// Transmitted share of the energy, s.
    pub T_s: f64,
    /// Transmitted share of the energy, p.
    pub T_p: f64,
}

impl Fresnel {
    /// Reflectance of natural light, equation (1).
    #[allow(non_snake_case)]
    pub fn R(&self) -> f64 {
        0.5 * (self.R_s + self.R_p)
    }

    /// Transmittance of natural light, equation (2).
    #[allow(non_snake_case)]
    pub fn T(&self) -> f64 {
        0.5 * (self.T_s + self.T_p)
    }
}

/// Fresnel's equations for light in `n_i` that meets `n_t` at `angle_rad` from the normal, 0 to pi/2.
///
/// R + T = 1 wherever `n_i` is lossless and `n_t` is too; T counts the energy just behind the boundary.
/// In an absorbing `n_i` the incoming and the reflected wave exchange energy, and R + T is 1 to O(k) only; the
/// wave weakens along the normal, and its angle is that of Snell's law with Re `n_i`.
///
/// The paper prints the p part of equation (2) with 2 n1 cos(theta_0) in the amplitude and the inverse
/// of its factor; that does not give its own T1 = 1 - R1. Here stand 2 n1 cos(theta_1) and the flux
/// ratio (n0 cos theta_0) / (n1 cos theta_1), which do.
///
/// # Errors
/// [`OpticsError::OutOfRange`] for an angle outside 0 to pi/2.
///
/// ```
/// use nacreous_nacre::Index;
/// let (air, aragonite) = (Index::new("air", 1.0, 0.0)?, Index::new("aragonite", 1.53, 0.0)?);
/// let at_normal = nacreous_optics::fresnel(aragonite, air, 0.0)?;
/// assert!((at_normal.R() - 0.0439).abs() < 5e-5); // figure 8
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fresnel(n_i: Index, n_t: Index, angle_rad: f64) -> Result<Fresnel, OpticsError> {
    within("angle_rad", angle_rad, 0.0..=FRAC_PI_2, "0 to pi/2")?;
    Ok(boundary(n_i.complex(), n_t.complex(), angle_rad.cos()))
}

/// The equations themselves, for an angle known to be one. `cos_i` is the cosine in `n_i`.
pub(crate) fn boundary(n_i: Complex64, n_t: Complex64, cos_i: f64) -> Fresnel {
    let cos_t = normal_component(n_t, n_i.re, n_i.re * cos_i) / n_t;
    let cos_i = match n_i.im {
        0.0 => Complex64::from(cos_i),
        _ => normal_component(n_i, n_i.re, n_i.re * cos_i) / n_i,
    };
    let (q_i, q_t) = (n_i * cos_i, n_t * cos_t);
    let (crossed_i, crossed_t) = (n_i * cos_t, n_t * cos_i);
    let r_s = (q_i - q_t) / (q_i + q_t);
    let r_p = (crossed_i - crossed_t) / (crossed_i + crossed_t);
    let t_s = 2.0 * q_i / (q_i + q_t);
    let t_p = 2.0 * q_i / (crossed_i + crossed_t);
    let flux_s = q_t.re / q_i.re;
    let flux_p = (n_t * cos_t.conj()).re / (n_i * cos_i.conj()).re;
    Fresnel {
        r_s,
        r_p,
        t_s,
        t_p,
        R_s: r_s.norm_sqr(),
        R_p: r_p.norm_sqr(),
        T_s: flux_s * t_s.norm_sqr(),
        T_p: flux_p * t_p.norm_sqr(),
    }
}

/// n_t cos(theta_t) by Snell's law, on the branch that decays or runs away from the boundary.
///
/// Written with n_t^2 - n_i^2 + (n_i cos)^2 and not n_t^2 - (n_i sin)^2, so that equal media stay
/// invisible up to grazing.
fn normal_component(n_t: Complex64, n_i: f64, along_i: f64) -> Complex64 {
    let q = ((n_t - n_i) * (n_t + n_i) + along_i * along_i).sqrt();
    if q.im < 0.0 || (q.im == 0.0 && q.re < 0.0) { -q } else { q }
}
