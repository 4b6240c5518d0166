//! A plane wave inside one medium: how it runs along the normal, and its admittance.

use num_complex::Complex64;

use crate::OpticsError;

/// How light swings: across the plane of incidence, in it, or both alike.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Polarisation {
    /// Electric field across the plane of incidence.
    S,
    /// Electric field in the plane of incidence.
    P,
    /// Natural light, the mean of both.
    #[default]
    Unpolarised,
}

impl std::str::FromStr for Polarisation {
    type Err = OpticsError;

    fn from_str(name: &str) -> Result<Self, OpticsError> {
        match name {
            "s" => Ok(Self::S),
            "p" => Ok(Self::P),
            "unpolarised" => Ok(Self::Unpolarised),
            other => Err(OpticsError::Polarisation(other.chars().take(40).collect())),
        }
    }
}

/// One of the two polarisations that a boundary does not mix.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Plane {
    S,
    P,
}

/// A wave in one medium, for one polarisation, angle and wavelength.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wave {
    /// Component of the wave vector along the normal, in units of that in vacuum.
    pub(crate) along: Complex64,
    /// Tangential magnetic over electric field, in units of that in vacuum.
    pub(crate) admittance: Complex64,
}

impl Wave {
    /// The wave that comes in through the ambient. Where that absorbs, the wave weakens along the normal
    /// and not along the layers, as it does behind a plane surface: s = Re n_ambient sin is real. A wave that
    /// weakened along the layers would have come in stronger elsewhere, and would grow in a clear layer.
    #[inline(always)]
    pub(crate) fn incident(plane: Plane, ambient: Complex64, cos_angle: f64) -> Self {
        let along = incident_along(ambient, cos_angle);
        let admittance = match plane {
            Plane::S => along,
            Plane::P if ambient.im == 0.0 => ambient / cos_angle,
            Plane::P => ambient * ambient / along,
        };
        Self { along, admittance }
    }

    /// What becomes of a wave, `ambient_along` being n_ambient cos in an `ambient` of this Re n, inside
    /// another medium, uniaxial with its axis along the normal: along = sqrt(n_o^2 - s^2) in s and
    /// n_o sqrt(1 - s^2 / n_e^2) in p, s = n_ambient sin; on the branch that decays, or runs away, from the
    /// boundary.
    ///
    /// In a passive medium n_o, sqrt(n_e^2 - s^2) and sqrt(1 - s^2 / n_e^2) all lie in the first quadrant, so
    /// the last times n_o is that branch as it stands. To choose again by the sign of its imaginary part
    /// would be wrong where that is 0 but for rounding: the wave would run towards the boundary.
    #[inline(always)]
    pub(crate) fn refracted(
        plane: Plane,
        (ordinary, extraordinary): (Complex64, Complex64),
        ambient: f64,
        ambient_along: f64,
    ) -> Self {
        if plane == Plane::S {
            let along = beside(ordinary, ambient, ambient_along);
            return Self { along, admittance: along };
        }
        let mut along = ordinary / extraordinary * beside(extraordinary, ambient, ambient_along);
        let admittance = ordinary * ordinary / along;
        along.im = if along.im > 0.0 { along.im } else { 0.0 };
        Self { along, admittance }
    }

    /// (along, admittance) of the wave that comes in through a lossless ambient.
    #[inline(always)]
    pub(crate) fn incident_real(plane: Plane, ambient: f64, cos_angle: f64) -> (f64, f64) {
        let along = ambient * cos_angle;
        (along, if plane == Plane::S { along } else { ambient / cos_angle })
    }

    /// (along, admittance) as [`Self::refracted`] between lossless media; `along` is 0 where the wave is
    /// evanescent or nearly so.
    #[inline(always)]
    pub(crate) fn refracted_real(
        plane: Plane,
        (ordinary, extraordinary): (f64, f64),
        ambient: f64,
        incident_along: f64,
    ) -> (f64, f64) {
        let n = if plane == Plane::S { ordinary } else { extraordinary };
        let square = (n - ambient) * (n + ambient) + incident_along * incident_along;
        let beside = if square >= LEAST_SQUARE { square.sqrt() } else { 0.0 };
        if plane == Plane::S {
            return (beside, beside);
        }
        let along = ordinary / extraordinary * beside;
        (along, ordinary * ordinary / along)
    }
}

/// sqrt(n_ambient^2 - s^2) with s = Re n_ambient sin.
#[inline(always)]
pub(crate) fn incident_along(ambient: Complex64, cos_angle: f64) -> Complex64 {
    let clear = ambient.re * cos_angle;
    if ambient.im == 0.0 { Complex64::from(clear) } else { beside(ambient, ambient.re, clear) }
}

/// sqrt(n^2 - s^2).
///
/// Written with n^2 - n_ambient^2 + (n_ambient cos)^2 and not n^2 - s^2, so that equal media stay invisible
/// up to grazing.
#[inline(always)]
pub(crate) fn beside(n: Complex64, ambient: f64, ambient_along: f64) -> Complex64 {
    away(root((n - ambient) * (n + ambient) + ambient_along * ambient_along))
}

#[inline(always)]
fn away(along: Complex64) -> Complex64 {
    let back = (along.im < 0.0) | ((along.im == 0.0) & (along.re < 0.0));
    if back { -along } else { along }
}

/// Below this the square of a wave vector's component along the normal counts as 0.
const LEAST_SQUARE: f64 = 1e-24;

/// The square root, never quite 0: a layer's matrix is even in it and bounded, but written with 1 / root.
/// At the very angle of total reflection the phase is thereby wrong by 1e-12 of a radian per
/// wavelength of thickness, and its square is all that counts.
#[inline(always)]
fn root(square: Complex64) -> Complex64 {
    let size = (square.re * square.re + square.im * square.im).sqrt();
    let large = (0.5 * (size + square.re.abs())).sqrt();
    let small = 0.5 * square.im / large;
    let (re, im) = if square.re >= 0.0 { (large, small) } else { (small, large) };
    let tiny = size < LEAST_SQUARE;
    Complex64::new(if tiny { 1e-12 } else { re }, if tiny { 0.0 } else { im })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_passive_medium_takes_energy_in() {
        let medium = |re, im| Complex64::new(re, im);
        for (ordinary, extraordinary) in [
            (medium(1.0, 0.0), medium(0.050_781_25, 1.0)),
            (medium(1.68, 0.0), medium(0.1, 3.0)),
            (medium(0.001, 4.0), medium(1.5, 0.0)),
            (medium(0.001, 4.0), medium(0.5, 0.0)),
            (medium(0.05, 4.0), medium(0.5, 0.0)),
        ] {
            for cos_angle in [1.0, 0.9, 0.5, 1e-9] {
                let pair = (ordinary, extraordinary);
                let wave = Wave::refracted(Plane::P, pair, 1.0, cos_angle);
                let size = wave.admittance.norm();
                assert!(wave.admittance.re >= -4e-16 * size, "{pair:?} {cos_angle} {wave:?}");
                assert!(wave.along.im >= 0.0);
            }
        }
    }

    /// Head on there is no extraordinary wave: n_e plays no part.
    #[test]
    fn head_on_both_polarisations_are_ordinary() {
        let (ordinary, extraordinary) = (Complex64::ONE, Complex64::new(0.050_781_25, 1.0));
        let wave = Wave::refracted(Plane::P, (ordinary, extraordinary), 1.0, 1.0);
        assert!((wave.along - 1.0).norm() < 1e-15);
        assert!((wave.admittance - 1.0).norm() < 1e-15);
    }

    #[test]
    fn the_root_squares_to_its_square() {
        for (re, im) in
            [(2.0, 3.0), (-2.0, 3.0), (-2.0, -3.0), (4.0, 0.0), (-4.0, 0.0), (0.0, 1e-9)]
        {
            let square = Complex64::new(re, im);
            let root = away(root(square));
            assert!((root * root - square).norm() <= 4e-16 * square.norm());
            assert!(root.im >= 0.0);
        }
    }
}
