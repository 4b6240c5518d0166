//! Any layers: absorbing, evanescent, metal.
//!
//! A layer's matrix is cos and sin of a complex phase, which overflow in a thick absorbing layer; so
//! each is taken times exp(-attenuation), both then at most 1. What the field loses by that is put back
//! into the transmittance at the end.

use multiversion::multiversion;
use num_complex::Complex64;

use crate::{
    lanes::{LANES, Lanes, fused},
    phase,
    real::{Real, Split},
};

/// Real and imaginary parts, lane by lane.
#[derive(Clone)]
pub(crate) struct Pair {
    pub(crate) re: Lanes<f64>,
    pub(crate) im: Lanes<f64>,
}

impl Pair {
    pub(crate) const ZERO: Self = Self { re: [0.0; LANES], im: [0.0; LANES] };

    pub(crate) fn get(&self, lane: usize) -> Complex64 {
        Complex64::new(self.re[lane], self.im[lane])
    }

    pub(crate) fn put(&mut self, lane: usize, value: Complex64) {
        (self.re[lane], self.im[lane]) = (value.re, value.im);
    }

    #[inline(always)]
    fn at(&self, i: usize) -> Complex {
        Complex(self.re[i], self.im[i])
    }

    #[inline(always)]
    fn set(&mut self, i: usize, Complex(re, im): Complex) {
        (self.re[i], self.im[i]) = (re, im);
    }
}

/// The complex numbers of one lane; num-complex's do not fuse.
#[derive(Clone, Copy)]
struct Complex(f64, f64);

impl Complex {
    /// self * a + other * b.
    #[inline(always)]
    fn times_plus<const FUSED: bool>(self, a: Self, other: Self, b: Self) -> Self {
        let re = other.0.times_plus::<FUSED>(b.0, -(other.1 * b.1));
        let im = other.0.times_plus::<FUSED>(b.1, other.1 * b.0);
        let re = self.1.times_plus::<FUSED>(-a.1, re);
        let im = self.1.times_plus::<FUSED>(a.0, im);
        Self(self.0.times_plus::<FUSED>(a.0, re), self.0.times_plus::<FUSED>(a.1, im))
    }
}

/// One polarisation of one block of wavelengths: the layers, as light at one angle meets them.
#[derive(Clone)]
pub(crate) struct Layers {
    /// Half turns of phase per nm of aragonite.
    pub(crate) aragonite_per_nm: Lanes<f64>,
    /// Halvings of the energy per nm, negative: exp(-2 attenuation) = 2^(this * thickness).
    pub(crate) aragonite_power_per_nm: Lanes<f64>,
    /// The protein layer: cos, -i sin / q and -i q sin of its complex phase, each times
    /// exp(-attenuation); q in units of aragonite's admittance.
    pub(crate) protein_cos: Pair,
    pub(crate) protein_sin_per_q: Pair,
    pub(crate) protein_q_sin: Pair,
}

impl Layers {
    pub(crate) const EMPTY: Self = Self {
        aragonite_per_nm: [0.0; LANES],
        aragonite_power_per_nm: [0.0; LANES],
        protein_cos: Pair::ZERO,
        protein_sin_per_q: Pair::ZERO,
        protein_q_sin: Pair::ZERO,
    };
}

/// The field (B, C) of one polarisation, C in units of aragonite's admittance.
#[derive(Clone)]
pub(crate) struct Field {
    pub(crate) b: Pair,
    pub(crate) c: Pair,
    /// The square of all that the field was multiplied with to keep its size.
    pub(crate) weight: Lanes<f64>,
}

impl Field {
    pub(crate) const DARK: Self = Self { b: Pair::ZERO, c: Pair::ZERO, weight: [1.0; LANES] };

    #[inline(always)]
    fn rescale(&mut self) {
        let (b, c) = (&mut self.b, &mut self.c);
        for i in 0..LANES {
            let size = (b.re[i].abs() + b.im[i].abs()) + (c.re[i].abs() + c.im[i].abs());
            let scale = 1.0 / size;
            b.re[i] *= scale;
            b.im[i] *= scale;
            c.re[i] *= scale;
            c.im[i] *= scale;
            self.weight[i] *= scale * scale;
        }
    }
}

/// Bilayers between two rescalings.
const TO_RESCALE: usize = 8;

/// Carries the fields from the substrate to the surface, through a protein and an aragonite layer each
/// time. `N` polarisations; where `ALIKE`, all of them have the first one's phase in aragonite.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
pub(crate) fn ascend<const N: usize, const ALIKE: bool>(
    thickness_nm: &[f64],
    layers: &[Layers; N],
    fields: &mut [Field; N],
) {
    if fused!() {
        climb::<true, N, ALIKE>(thickness_nm, layers, fields);
    } else {
        climb::<false, N, ALIKE>(thickness_nm, layers, fields);
    }
}

#[inline(always)]
fn climb<const FUSED: bool, const N: usize, const ALIKE: bool>(
    thickness_nm: &[f64],
    layers: &[Layers; N],
    fields: &mut [Field; N],
) {
    for bilayers in thickness_nm.rchunks(TO_RESCALE) {
        for &thickness in bilayers.iter().rev() {
            through::<FUSED, N, ALIKE>(thickness, layers, fields);
        }
        for field in &mut *fields {
            field.rescale();
        }
    }
}

/// The arithmetic of one bilayer.
#[inline(always)]
fn through<const FUSED: bool, const N: usize, const ALIKE: bool>(
    thickness_nm: f64,
    layers: &[Layers; N],
    fields: &mut [Field; N],
) {
    for i in 0..LANES {
        let mut turn = turn::<FUSED>(thickness_nm, &layers[0], i);
        for n in 0..N {
            if n > 0 && !ALIKE {
                turn = self::turn::<FUSED>(thickness_nm, &layers[n], i);
            }
            let (layer, field) = (&layers[n], &mut fields[n]);
            let (cos, sin) = turn;
            let protein_cos = layer.protein_cos.at(i);
            let (b, c) = (field.b.at(i), field.c.at(i));
            let (b, c) = (
                protein_cos.times_plus::<FUSED>(b, layer.protein_sin_per_q.at(i), c),
                protein_cos.times_plus::<FUSED>(c, layer.protein_q_sin.at(i), b),
            );
            field.b.set(i, cos.times_plus::<FUSED>(b, sin, c));
            field.c.set(i, cos.times_plus::<FUSED>(c, sin, b));
        }
    }
}

/// cos and -i sin of the complex phase of aragonite, each times exp(-attenuation).
#[inline(always)]
fn turn<const FUSED: bool>(thickness_nm: f64, layers: &Layers, i: usize) -> (Complex, Complex) {
    let thickness = Split { high: thickness_nm, low: 0.0 };
    let f = phase::reduced::<f64, FUSED>(thickness, layers.aragonite_per_nm[i], 0.0);
    damped::<FUSED>(f, thickness_nm * layers.aragonite_power_per_nm[i])
}

/// cos and -i sin of the phase pi f + i y, each times exp(-y), where exp(-2 y) = 2^power.
#[inline(always)]
fn damped<const FUSED: bool>(f: f64, power: f64) -> (Complex, Complex) {
    let (cos, sin) = phase::cos_sin::<FUSED>(f);
    // exp(-y) cosh y and exp(-y) sinh y.
    let sinh = -0.5 * phase::power_of_two_less_one::<FUSED>(power);
    let cosh = 1.0 - sinh;
    (Complex(cos * cosh, -(sin * sinh)), Complex(cos * sinh, -(sin * cosh)))
}

/// The same for the thin layer between, as numbers rather than lanes.
pub(crate) fn cos_and_sin(half_turns: f64, power: f64) -> [Complex64; 2] {
    let (cos, sin) = damped::<false>(half_turns - half_turns.round(), power);
    [Complex64::new(cos.0, cos.1), Complex64::new(sin.0, sin.1)]
}
