//! Lossless layers of many columns in single precision: phases of tablets from a table.
//!
//! A protein layer turns the pairs of [`lossless`](crate::lossless) by half its phase psi, shrinks them by mu
//! along one diagonal, and turns them by the other half. In axes along the diagonals a bilayer is thus
//! diag(1, mu) and one turn by its phases in aragonite and protein together. The turn is the nearest
//! node's and a small one, by (1, tan x) up to scale: half the work of a phase of its own.

use multiversion::multiversion;

use crate::{
    incidence::{OfBoth, Shares},
    lanes::{LANES, Lanes, fused},
    lossless::Field,
    phase,
    real::{Real, Split},
    tablets::{Tablet, Tablets},
    waves::Waves,
};

/// The bilayers of one block of wavelengths as light of `N` polarisations meets them.
pub(crate) struct Met<const N: usize> {
    bilayers: [Bilayers; N],
    /// `[node]`
    turns: Vec<[Turn; N]>,
}

/// Up to scale, cosine and sine of a node's phase and the protein's.
#[derive(Clone, Copy)]
struct Turn {
    cos: Lanes<f32>,
    sin: Lanes<f32>,
}

/// What is the same for all bilayers.
#[derive(Clone, Copy)]
struct Bilayers {
    /// The tangent of the phase beyond a node: odd polynomial in nm.
    tan_per_nm: Lanes<f32>,
    tan_per_nm3: Lanes<f32>,
    mu: Lanes<f32>,
    /// Up to scale, cosine and sine from the axes of (B, C) to the diagonals within the protein.
    diagonal: Turn,
    /// cos and sin of psi.
    protein: Turn,
}

impl Turn {
    const NONE: Self = Self { cos: [1.0; LANES], sin: [0.0; LANES] };
}

impl<const N: usize> Met<N> {
    pub(crate) fn new(
        waves: &[Waves; N],
        half_turns_per_nm: &Lanes<f64>,
        protein_nm: f64,
        tablets: &Tablets,
    ) -> Self {
        let mut met = Self {
            bilayers: [Bilayers::EMPTY; N],
            turns: vec![[Turn::NONE; N]; tablets.nodes_nm.len()],
        };
        meet(&mut met, waves, half_turns_per_nm, protein_nm, tablets);
        met
    }
}

#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
fn meet<const N: usize>(
    met: &mut Met<N>,
    waves: &[Waves; N],
    half_turns_per_nm: &Lanes<f64>,
    protein_nm: f64,
    tablets: &Tablets,
) {
    for n in 0..N {
        let mut per_nm = [0.0; LANES];
        for i in 0..LANES {
            per_nm[i] = waves[n].aragonite_along.re[i] * half_turns_per_nm[i];
        }
        let bilayers = &mut met.bilayers[n];
        bilayers.meet_tablets(&per_nm, tablets.step_nm);
        if fused!() {
            bilayers.meet_protein::<true>(&waves[n], half_turns_per_nm, protein_nm);
        } else {
            bilayers.meet_protein::<false>(&waves[n], half_turns_per_nm, protein_nm);
        }
        for (turns, &nm) in met.turns.iter_mut().zip(&tablets.nodes_nm) {
            if fused!() {
                turns[n].meet::<true>(nm, &per_nm, &bilayers.protein);
            } else {
                turns[n].meet::<false>(nm, &per_nm, &bilayers.protein);
            }
        }
    }
}

/// Adds R and T of the first `W` wavelengths of a block, the mean of `N` polarisations.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
pub(crate) fn add_shares<const N: usize, const W: usize>(
    column: &[Tablet],
    met: &Met<N>,
    waves: &[Waves; N],
    shares: &mut Shares,
) {
    // Loops and no closures, which would not be compiled with these instructions.
    let mut fields = [Field::<f32>::empty(); N];
    for n in 0..N {
        fields[n].start_at_substrate(&waves[n]);
        fields[n].turn::<W>(&met.bilayers[n].diagonal, 1.0);
    }
    if fused!() {
        climb::<true, N, W>(column, met, &mut fields);
    } else {
        climb::<false, N, W>(column, met, &mut fields);
    }
    for n in 0..N {
        fields[n].turn::<W>(&met.bilayers[n].diagonal, -1.0);
        fields[n].add_shares::<W>(&waves[n], 1.0 / N as f64, shares);
    }
}

/// The same, and those of each polarisation alone from aragonite above the layers, as `inside` has it: the field at the
/// outermost layer is that of both.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
pub(crate) fn add_shares_of_both<const N: usize, const W: usize>(
    column: &[Tablet],
    met: &Met<N>,
    waves: &[Waves; N],
    inside: &[Waves; N],
    shares: &mut OfBoth<N>,
) {
    let mut fields = [Field::<f32>::empty(); N];
    for n in 0..N {
        fields[n].start_at_substrate(&waves[n]);
        fields[n].turn::<W>(&met.bilayers[n].diagonal, 1.0);
    }
    if fused!() {
        climb::<true, N, W>(column, met, &mut fields);
    } else {
        climb::<false, N, W>(column, met, &mut fields);
    }
    for n in 0..N {
        fields[n].turn::<W>(&met.bilayers[n].diagonal, -1.0);
        fields[n].add_shares::<W>(&waves[n], 1.0 / N as f64, &mut shares.ambient);
        fields[n].add_shares::<W>(&inside[n], 1.0, &mut shares.aragonite[n]);
    }
}

impl Bilayers {
    const EMPTY: Self = Self {
        tan_per_nm: [0.0; LANES],
        tan_per_nm3: [0.0; LANES],
        mu: [1.0; LANES],
        diagonal: Turn::NONE,
        protein: Turn::NONE,
    };

    /// tan x = x + x^3 / 3 + 2 x^5 / 15, the last term by Chebyshev's polynomial within half a step.
    #[inline(always)]
    fn meet_tablets(&mut self, half_turns_per_nm: &Lanes<f64>, step_nm: f64) {
        for i in 0..LANES {
            let per_nm = std::f64::consts::PI * half_turns_per_nm[i];
            let reach = 0.5 * step_nm * per_nm;
            let square = reach * reach;
            self.tan_per_nm[i] = (per_nm * (1.0 - square * square / 24.0)) as f32;
            self.tan_per_nm3[i] = (per_nm * per_nm * per_nm * (1.0 / 3.0 + square / 6.0)) as f32;
        }
    }

    /// The layer's matrix in forward and backward waves, (a, b; b*, a*) with |a|^2 - |b|^2 = 1: psi is
    /// the phase of a, mu = (|a| - |b|) / (|a| + |b|).
    #[inline(always)]
    fn meet_protein<const FUSED: bool>(
        &mut self,
        waves: &Waves,
        half_turns_per_nm: &Lanes<f64>,
        protein_nm: f64,
    ) {
        for i in 0..LANES {
            let per_nm = waves.protein_along.re[i] * half_turns_per_nm[i];
            let f = phase::reduced::<f64, FUSED>(Split::of(protein_nm), per_nm, 0.0);
            let (cos, sin) = phase::cos_sin::<FUSED>(f);
            let (q, per_q) = (waves.q.re[i], waves.per_q.re[i]);
            let (re_a, im_a, b) = (cos, 0.5 * sin * (q + per_q), 0.5 * sin * (q - per_q));
            let a = (re_a * re_a + im_a * im_a).sqrt();
            let sum = a + b.abs();
            self.mu[i] = (1.0 / (sum * sum)) as f32;
            let (cos, sin) = (re_a / a, im_a / a);
            (self.protein.cos[i], self.protein.sin[i]) = (cos as f32, sin as f32);
            // Half of psi, and an eighth of a turn forth or back.
            let (half_cos, half_sin) = if cos > 0.0 { (1.0 + cos, sin) } else { (sin, 1.0 - cos) };
            let side = if b < 0.0 { -1.0 } else { 1.0 };
            self.diagonal.cos[i] = (half_cos - side * half_sin) as f32;
            self.diagonal.sin[i] = (half_sin + side * half_cos) as f32;
        }
    }
}

impl Turn {
    #[inline(always)]
    fn meet<const FUSED: bool>(
        &mut self,
        node_nm: f64,
        half_turns_per_nm: &Lanes<f64>,
        protein: &Self,
    ) {
        for i in 0..LANES {
            let f = phase::reduced::<f64, FUSED>(Split::of(node_nm), half_turns_per_nm[i], 0.0);
            let (p, s) = phase::pair::<f32, FUSED>(f as f32);
            let (cos, sin) = (protein.cos[i], protein.sin[i]);
            self.cos[i] = p.times_plus::<FUSED>(cos, -(s * sin));
            self.sin[i] = p.times_plus::<FUSED>(sin, s * cos);
        }
    }
}

impl Field<f32> {
    /// Turns both pairs, forth for a `sense` of 1, back for -1.
    #[inline(always)]
    fn turn<const W: usize>(&mut self, turn: &Turn, sense: f32) {
        for i in 0..W {
            let (cos, sin) = (turn.cos[i], sense * turn.sin[i]);
            let (re_b, im_c, re_c, im_b) = (self.re_b[i], self.im_c[i], self.re_c[i], self.im_b[i]);
            (self.re_b[i], self.im_c[i]) = (cos * re_b + sin * im_c, cos * im_c - sin * re_b);
            (self.re_c[i], self.im_b[i]) = (cos * re_c + sin * im_b, cos * im_b - sin * re_c);
        }
    }
}

/// Bilayers taken in one go: their phases do not wait for one another.
const AT_ONCE: usize = 4;

/// Bilayers between two rescalings: where mu < 1/3 the field may vanish, and is not a number.
const TO_RESCALE: usize = 16 * AT_ONCE;

/// Carries the fields from the substrate to the surface.
#[inline(always)]
fn climb<const FUSED: bool, const N: usize, const W: usize>(
    column: &[Tablet],
    met: &Met<N>,
    fields: &mut [Field<f32>; N],
) {
    for bilayers in column.rchunks(TO_RESCALE) {
        let (rest, groups) = bilayers.as_rchunks::<AT_ONCE>();
        for group in groups.iter().rev() {
            through::<FUSED, N, W, AT_ONCE>(group, met, fields);
        }
        for &tablet in rest.iter().rev() {
            through::<FUSED, N, W, 1>(&[tablet], met, fields);
        }
        for field in &mut *fields {
            field.rescale::<W>();
        }
    }
}

/// The arithmetic of a few bilayers, deepest last in `group`.
#[inline(always)]
fn through<const FUSED: bool, const N: usize, const W: usize, const G: usize>(
    group: &[Tablet; G],
    met: &Met<N>,
    fields: &mut [Field<f32>; N],
) {
    let turns = group.map(|tablet| &met.turns[tablet.node]);
    let beyond = group.map(|tablet| (tablet.beyond_nm, tablet.beyond_nm * tablet.beyond_nm));
    for n in 0..N {
        let (field, bilayers) = (&mut fields[n], &met.bilayers[n]);
        for i in 0..W {
            let (per_nm, per_nm3) = (bilayers.tan_per_nm[i], bilayers.tan_per_nm3[i]);
            let mu = bilayers.mu[i];
            let (mut re_b, mut im_c) = (field.re_b[i], field.im_c[i]);
            let (mut re_c, mut im_b) = (field.re_c[i], field.im_b[i]);
            for layer in (0..G).rev() {
                let (nm, square) = beyond[layer];
                let tan = per_nm3.times_plus::<FUSED>(square, per_nm) * nm;
                let (node_cos, node_sin) = (turns[layer][n].cos[i], turns[layer][n].sin[i]);
                let cos = (-node_sin).times_plus::<FUSED>(tan, node_cos);
                let sin = node_cos.times_plus::<FUSED>(tan, node_sin);
                (re_b, im_b) = (mu * re_b, mu * im_b);
                (re_b, im_c) = (
                    cos.times_plus::<FUSED>(re_b, sin * im_c),
                    cos.times_plus::<FUSED>(im_c, -(sin * re_b)),
                );
                (re_c, im_b) = (
                    cos.times_plus::<FUSED>(re_c, sin * im_b),
                    cos.times_plus::<FUSED>(im_b, -(sin * re_c)),
                );
            }
            (field.re_b[i], field.im_c[i]) = (re_b, im_c);
            (field.re_c[i], field.im_b[i]) = (re_c, im_b);
        }
    }
}

#[cfg(test)]
mod tests {
    use nacreous_nacre::{Index, LayerStack};

    use super::*;
    use crate::{media::Table, wave::Plane};

    /// The processors' instructions differ in how a product is rounded before a sum, in nothing else.
    #[test]
    fn with_and_without_fused_instructions_only_rounding_differs() {
        let thickness_nm = (0..101).map(|i| 350.0 + f64::from(i * 37 % 101)).collect();
        let n = |n| Index::new("medium", n, 0.0).unwrap();
        let stack = LayerStack::new(thickness_nm, 20.0, n(1.68), n(1.43), n(1.0), n(1.53)).unwrap();
        let nm: Lanes<f64> = std::array::from_fn(|i| 400.0 + 7.0 * i as f64);
        let table = Table::new(&stack, &nm).unwrap();
        let waves = table.at([Plane::S, Plane::P], 0.8, 0).waves;
        let tablets = Tablets::new(std::slice::from_ref(&stack), &table);
        let met = Met::new(&waves, &table.half_turns_per_nm[0], stack.protein_nm(), &tablets);
        let mut start = [Field::<f32>::empty(); 2];
        for n in 0..2 {
            start[n].start_at_substrate(&waves[n]);
        }
        let (mut fused, mut plain) = (start, start);
        climb::<true, 2, LANES>(&tablets.columns[0], &met, &mut fused);
        climb::<false, 2, LANES>(&tablets.columns[0], &met, &mut plain);
        let mut moved = 0.0_f32;
        for (fused, plain) in fused.iter().zip(&plain) {
            for i in 0..LANES {
                assert!((fused.re_b[i] - plain.re_b[i]).abs() < 2e-5);
                assert!((fused.im_c[i] - plain.im_c[i]).abs() < 2e-5);
                moved = moved.max((fused.re_b[i] - 1.0).abs());
            }
        }
        assert!(moved > 0.5);
    }
}
