//! Lossless layers without total reflection.
//!
//! A layer's matrix is then real on and imaginary off its diagonal, so the field (B, C) from the
//! substrate up splits into two real pairs, (Re B, Im C) and (Re C, Im B), that never meet. With C in
//! units of aragonite's admittance an aragonite layer turns both pairs by its phase; its scale changes
//! neither R nor T, so a number pair in the ratio of cosine and sine will do ([`phase::pair`]).

use multiversion::multiversion;

use crate::{
    lanes::{LANES, Lanes, fused},
    phase,
    real::{Real, Split},
};

/// One polarisation of one block of wavelengths: the layers, as light at one angle meets them.
#[derive(Clone)]
pub(crate) struct Layers<T> {
    /// Half turns of phase per nm of aragonite, and what this precision rounds away of them.
    pub(crate) aragonite_per_nm: Lanes<T>,
    pub(crate) aragonite_per_nm_low: Lanes<T>,
    /// The protein layer: cos, sin / q and q sin of its phase, q in units of aragonite's admittance.
    pub(crate) protein_cos: Lanes<T>,
    pub(crate) protein_sin_per_q: Lanes<T>,
    pub(crate) protein_q_sin: Lanes<T>,
}

impl<T: Real> Layers<T> {
    pub(crate) fn new() -> Self {
        let lanes = [T::default(); LANES];
        Self {
            aragonite_per_nm: lanes,
            aragonite_per_nm_low: lanes,
            protein_cos: lanes,
            protein_sin_per_q: lanes,
            protein_q_sin: lanes,
        }
    }
}

/// The field (B, C) of one polarisation, C in units of aragonite's admittance, up to a common scale.
#[derive(Clone)]
pub(crate) struct Field<T> {
    pub(crate) re_b: Lanes<T>,
    pub(crate) im_b: Lanes<T>,
    pub(crate) re_c: Lanes<T>,
    pub(crate) im_c: Lanes<T>,
}

impl<T: Real> Field<T> {
    pub(crate) fn new() -> Self {
        let lanes = [T::default(); LANES];
        Self { re_b: lanes, im_b: lanes, re_c: lanes, im_c: lanes }
    }

    /// (Re B, Im B, Re C, Im C) of one lane.
    pub(crate) fn at(&self, i: usize) -> [f64; 4] {
        [self.re_b[i], self.im_b[i], self.re_c[i], self.im_c[i]].map(Real::wide)
    }

    /// Brings the field back to size 1. Its scale means nothing, but must not overflow.
    #[inline(always)]
    fn rescale(&mut self) {
        for i in 0..LANES {
            let size = (self.re_b[i].abs() + self.im_b[i].abs())
                + (self.re_c[i].abs() + self.im_c[i].abs());
            let scale = T::ONE / size;
            self.re_b[i] = self.re_b[i] * scale;
            self.im_b[i] = self.im_b[i] * scale;
            self.re_c[i] = self.re_c[i] * scale;
            self.im_c[i] = self.im_c[i] * scale;
        }
    }
}

/// Layers taken in one go: their phases do not wait for one another.
const AT_ONCE: usize = 4;

/// Bilayers between two rescalings. The widest field that media allow grows by 1e15 in each.
const TO_RESCALE: usize = 4 * AT_ONCE;

/// Carries the fields from the substrate to the surface, through a protein and an aragonite layer each
/// time. `N` polarisations; where `ALIKE`, all of them have the first one's phase in aragonite.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
pub(crate) fn ascend<T: Real, const N: usize, const ALIKE: bool>(
    thickness_nm: &[f64],
    layers: &[Layers<T>; N],
    fields: &mut [Field<T>; N],
) {
    if fused!() {
        climb::<T, true, N, ALIKE>(thickness_nm, layers, fields);
    } else {
        climb::<T, false, N, ALIKE>(thickness_nm, layers, fields);
    }
}

#[inline(always)]
fn climb<T: Real, const FUSED: bool, const N: usize, const ALIKE: bool>(
    thickness_nm: &[f64],
    layers: &[Layers<T>; N],
    fields: &mut [Field<T>; N],
) {
    for bilayers in thickness_nm.rchunks(TO_RESCALE) {
        let (rest, groups) = bilayers.as_rchunks::<AT_ONCE>();
        for group in groups.iter().rev() {
            through::<T, FUSED, N, ALIKE, AT_ONCE>(group, layers, fields);
        }
        for &thickness in rest.iter().rev() {
            through::<T, FUSED, N, ALIKE, 1>(&[thickness], layers, fields);
        }
        for field in &mut *fields {
            field.rescale();
        }
    }
}

/// The arithmetic of a few bilayers, deepest last in `group`.
#[inline(always)]
fn through<T: Real, const FUSED: bool, const N: usize, const ALIKE: bool, const G: usize>(
    group: &[f64; G],
    layers: &[Layers<T>; N],
    fields: &mut [Field<T>; N],
) {
    let group = group.map(Split::<T>::of);
    for i in 0..LANES {
        let turns = |n: usize| -> [(T, T); G] {
            let (high, low) = (layers[n].aragonite_per_nm[i], layers[n].aragonite_per_nm_low[i]);
            group.map(|d| phase::pair::<T, FUSED>(phase::reduced::<T, FUSED>(d, high, low)))
        };
        let mut turn = turns(0);
        for n in 0..N {
            if n > 0 && !ALIKE {
                turn = turns(n);
            }
            let cos = layers[n].protein_cos[i];
            let (sin_per_q, q_sin) = (layers[n].protein_sin_per_q[i], layers[n].protein_q_sin[i]);
            let field = &mut fields[n];
            let (mut re_b, mut im_c) = (field.re_b[i], field.im_c[i]);
            let (mut re_c, mut im_b) = (field.re_c[i], field.im_b[i]);
            for &(p, s) in turn.iter().rev() {
                (re_b, im_c) = (
                    cos.times_plus::<FUSED>(re_b, sin_per_q * im_c),
                    cos.times_plus::<FUSED>(im_c, -(q_sin * re_b)),
                );
                (re_c, im_b) = (
                    cos.times_plus::<FUSED>(re_c, q_sin * im_b),
                    cos.times_plus::<FUSED>(im_b, -(sin_per_q * re_c)),
                );
                (re_b, im_c) = (
                    p.times_plus::<FUSED>(re_b, s * im_c),
                    p.times_plus::<FUSED>(im_c, -(s * re_b)),
                );
                (re_c, im_b) = (
                    p.times_plus::<FUSED>(re_c, s * im_b),
                    p.times_plus::<FUSED>(im_b, -(s * re_c)),
                );
            }
            (field.re_b[i], field.im_c[i]) = (re_b, im_c);
            (field.re_c[i], field.im_b[i]) = (re_c, im_b);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layers(shift: f64) -> Layers<f64> {
        let mut layers = Layers::new();
        for i in 0..LANES {
            let (per_nm, phase) = (2.0 * 1.683 / (400.0 + shift + i as f64), 0.3 + shift * 1e-3);
            let q = 0.85;
            layers.aragonite_per_nm[i] = per_nm;
            layers.protein_cos[i] = phase.cos();
            layers.protein_sin_per_q[i] = phase.sin() / q;
            layers.protein_q_sin[i] = phase.sin() * q;
        }
        layers
    }

    /// The processors' instructions differ in how a product is rounded before a sum, in nothing else.
    #[test]
    fn with_and_without_fused_instructions_only_rounding_differs() {
        let thickness_nm: Vec<f64> = (0..1001).map(|i| 350.0 + f64::from(i * 37 % 101)).collect();
        let layers = [layers(0.0), layers(7.0)];
        let reflectance = |fused: bool| {
            let mut fields = [Field::new(), Field::new()];
            for field in &mut fields {
                (field.re_b, field.re_c) = ([1.0; LANES], [0.9; LANES]);
            }
            if fused {
                climb::<f64, true, 2, false>(&thickness_nm, &layers, &mut fields);
            } else {
                climb::<f64, false, 2, false>(&thickness_nm, &layers, &mut fields);
            }
            fields.map(|field| {
                std::array::from_fn::<f64, LANES, _>(|i| {
                    let [re_b, im_b, re_c, im_c] = field.at(i);
                    let away = (0.6 * re_b - re_c).powi(2) + (0.6 * im_b - im_c).powi(2);
                    away / ((0.6 * re_b + re_c).powi(2) + (0.6 * im_b + im_c).powi(2))
                })
            })
        };
        let (fused, plain) = (reflectance(true), reflectance(false));
        for (a, b) in fused.as_flattened().iter().zip(plain.as_flattened()) {
            assert!((a - b).abs() < 1e-11, "{a} {b}");
        }
        assert!(fused.as_flattened().iter().any(|r| (0.2..0.9).contains(r)));
    }
}
