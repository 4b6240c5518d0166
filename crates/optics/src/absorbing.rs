//! Any layers: absorbing, evanescent, metal.
//!
//! A layer's matrix is cos and sin of a complex phase, which overflow in a thick absorbing layer; so
//! each is taken times exp(-attenuation), both then at most 1. What the field loses by that is put back
//! into the transmittance at the end.

use std::f64::consts::{LOG2_E, PI};

use multiversion::multiversion;
use nacreous_nacre::LayerStack;
use num_complex::Complex64;

use crate::{
    incidence::Shares,
    lanes::{LANES, Lanes, Pair, fused, products},
    phase,
    real::Split,
    waves::Waves,
};

/// Adds R, T and A of one block of wavelengths, the mean of `N` polarisations; where `ALIKE`, all of them have
/// the first one's phase in aragonite. `absorbs`: whether a layer has an extinction coefficient.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
pub(crate) fn add_shares<const N: usize, const ALIKE: bool>(
    stack: &LayerStack,
    absorbs: bool,
    waves: &[Waves; N],
    half_turns_per_nm: &Lanes<f64>,
    shares: &mut Shares,
) {
    if fused!() {
        from_layers::<true, N, ALIKE>(stack, absorbs, waves, half_turns_per_nm, shares);
    } else {
        from_layers::<false, N, ALIKE>(stack, absorbs, waves, half_turns_per_nm, shares);
    }
}

#[inline(always)]
fn from_layers<const FUSED: bool, const N: usize, const ALIKE: bool>(
    stack: &LayerStack,
    absorbs: bool,
    waves: &[Waves; N],
    half_turns_per_nm: &Lanes<f64>,
    shares: &mut Shares,
) {
    // Loops and no closures, which would not be compiled with these instructions.
    let mut layers = [const { Layers::EMPTY }; N];
    let mut fields = [const { Field::EMPTY }; N];
    for n in 0..N {
        layers[n].meet::<FUSED>(&waves[n], half_turns_per_nm, stack.protein_nm());
        fields[n].start_at_substrate(&waves[n]);
    }
    climb::<FUSED, N, ALIKE>(stack, &layers, &mut fields);
    for (field, waves) in fields.iter().zip(waves) {
        field.add_shares(waves, absorbs, 1.0 / N as f64, shares);
    }
}

/// One polarisation of one block of wavelengths: the layers, as light at one angle meets them.
struct Layers {
    /// Half turns of phase per nm of aragonite.
    aragonite_per_nm: Lanes<f64>,
    /// Halvings of the energy per nm, negative: exp(-2 attenuation) = 2^(this * thickness).
    aragonite_power_per_nm: Lanes<f64>,
    protein_power_per_nm: Lanes<f64>,
    /// The protein layer: cos, -i sin / q and -i q sin of its complex phase, each times
    /// exp(-attenuation); q in units of aragonite's admittance.
    protein_cos: Pair,
    protein_sin_per_q: Pair,
    protein_q_sin: Pair,
}

impl Layers {
    const EMPTY: Self = Self {
        aragonite_per_nm: [0.0; LANES],
        aragonite_power_per_nm: [0.0; LANES],
        protein_power_per_nm: [0.0; LANES],
        protein_cos: Pair::ZERO,
        protein_sin_per_q: Pair::ZERO,
        protein_q_sin: Pair::ZERO,
    };

    #[inline(always)]
    fn meet<const FUSED: bool>(
        &mut self,
        waves: &Waves,
        half_turns_per_nm: &Lanes<f64>,
        protein_nm: f64,
    ) {
        // A wave's energy falls by exp(-2 pi Im k) in each half turn of the vacuum's.
        const POWER: f64 = -2.0 * PI * LOG2_E;
        for i in 0..LANES {
            let (aragonite, protein) = (waves.aragonite_along.at(i), waves.protein_along.at(i));
            self.aragonite_per_nm[i] = aragonite.re * half_turns_per_nm[i];
            self.aragonite_power_per_nm[i] = POWER * aragonite.im * half_turns_per_nm[i];
            self.protein_power_per_nm[i] = POWER * protein.im * half_turns_per_nm[i];
            let thickness = Split::of(protein_nm);
            let f = phase::reduced::<f64, FUSED>(thickness, protein.re * half_turns_per_nm[i], 0.0);
            let power = self.protein_power_per_nm[i] * protein_nm;
            let (cos, sin) = damped::<FUSED>(f, power);
            self.protein_cos.set(i, cos);
            self.protein_sin_per_q.set(i, sin * waves.per_q.at(i));
            self.protein_q_sin.set(i, sin * waves.q.at(i));
        }
    }
}

/// The field (B, C) of one polarisation, C in units of aragonite's admittance.
struct Field {
    b: Pair,
    c: Pair,
    /// The square of all that the field was multiplied with to keep its size.
    weight: Lanes<f64>,
}

impl Field {
    const EMPTY: Self = Self { b: Pair::ZERO, c: Pair::ZERO, weight: [1.0; LANES] };

    /// B = 1, C = the substrate's admittance.
    #[inline(always)]
    fn start_at_substrate(&mut self, waves: &Waves) {
        for i in 0..LANES {
            self.b.set(i, Complex64::ONE);
            self.c.set(i, waves.substrate_ratio.at(i));
        }
    }

    /// Brings the field back to size 1 above `layers` of these thicknesses, and puts into the weight what
    /// their matrices lacked.
    #[inline(always)]
    fn rescale<const FUSED: bool>(&mut self, layers: &Layers, aragonite_nm: f64, protein_nm: f64) {
        let (b, c) = (&mut self.b, &mut self.c);
        for i in 0..LANES {
            let size = (b.re[i].abs() + b.im[i].abs()) + (c.re[i].abs() + c.im[i].abs());
            let scale = 1.0 / size;
            b.re[i] *= scale;
            b.im[i] *= scale;
            c.re[i] *= scale;
            c.im[i] *= scale;
            let power = layers.aragonite_power_per_nm[i] * aragonite_nm
                + layers.protein_power_per_nm[i] * protein_nm;
            self.weight[i] *= (scale * scale) * phase::power_of_two::<FUSED>(power);
        }
    }

    /// R, T and A from the field at the surface, that at the substrate being (1, admittance) times the
    /// root of the weight.
    ///
    /// What goes in and R add up to 1 by arithmetic. What comes out below is counted by itself, and loses
    /// digits where light is stored in a resonance; so T is never more than went in, and without
    /// absorption all of it.
    #[inline(always)]
    fn add_shares(&self, waves: &Waves, absorbs: bool, part: f64, shares: &mut Shares) {
        for i in 0..LANES {
            let (q, b) = (waves.ambient.at(i), self.b.at(i));
            let c = self.c.at(i) * waves.aragonite.at(i);
            let (towards, away) = ((q * b + c).norm_sqr(), (q * b - c).norm_sqr());
            // Energy per incoming energy |towards / 2 q|^2 Re q.
            let share = 4.0 * q.norm_sqr() / q.re / towards;
            let goes_in = share * (b.re * c.re + b.im * c.im);
            let goes_in = if goes_in > 0.0 { goes_in } else { 0.0 };
            let out_of = waves.substrate.re[i];
            let comes_out = share * (out_of * self.weight[i]);
            // Without absorption they are two counts of the same, the second good for the smallest T too.
            let unequal = (goes_in - comes_out).abs() > 1e-14;
            let transmits = (out_of > 0.0) & (unequal & !absorbs | (comes_out > goes_in));
            let comes_out = if transmits { goes_in } else { comes_out };
            let stays = if absorbs { goes_in - comes_out } else { 0.0 };
            shares[0][i] += part * (away / towards);
            shares[1][i] += part * comes_out;
            shares[2][i] += part * stays;
        }
    }
}

/// Bilayers between two rescalings.
const TO_RESCALE: usize = 8;

/// Carries the fields from the substrate to the surface, through a protein and an aragonite layer each
/// time.
#[inline(always)]
fn climb<const FUSED: bool, const N: usize, const ALIKE: bool>(
    stack: &LayerStack,
    layers: &[Layers; N],
    fields: &mut [Field; N],
) {
    for bilayers in stack.thickness_nm().rchunks(TO_RESCALE) {
        for &thickness in bilayers.iter().rev() {
            through::<FUSED, N, ALIKE>(thickness, layers, fields);
        }
        let aragonite_nm = bilayers.iter().sum();
        let protein_nm = bilayers.len() as f64 * stack.protein_nm();
        for (field, layers) in fields.iter_mut().zip(layers) {
            field.rescale::<FUSED>(layers, aragonite_nm, protein_nm);
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
                products::<FUSED>(protein_cos, b, layer.protein_sin_per_q.at(i), c),
                products::<FUSED>(protein_cos, c, layer.protein_q_sin.at(i), b),
            );
            field.b.set(i, products::<FUSED>(cos, b, sin, c));
            field.c.set(i, products::<FUSED>(cos, c, sin, b));
        }
    }
}

/// cos and -i sin of the complex phase of aragonite, each times exp(-attenuation).
#[inline(always)]
fn turn<const FUSED: bool>(thickness_nm: f64, layers: &Layers, i: usize) -> (Complex64, Complex64) {
    let thickness = Split { high: thickness_nm, low: 0.0 };
    let f = phase::reduced::<f64, FUSED>(thickness, layers.aragonite_per_nm[i], 0.0);
    damped::<FUSED>(f, thickness_nm * layers.aragonite_power_per_nm[i])
}

/// cos and -i sin of the phase pi f + i y, each times exp(-y), where exp(-2 y) = 2^power.
#[inline(always)]
fn damped<const FUSED: bool>(f: f64, power: f64) -> (Complex64, Complex64) {
    let (cos, sin) = phase::cos_sin::<FUSED>(f);
    // exp(-y) cosh y and exp(-y) sinh y.
    let sinh = -0.5 * phase::power_of_two_less_one::<FUSED>(power);
    let cosh = 1.0 - sinh;
    (Complex64::new(cos * cosh, -(sin * sinh)), Complex64::new(cos * sinh, -(sin * cosh)))
}
