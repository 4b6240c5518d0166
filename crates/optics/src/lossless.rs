//! Lossless layers without total reflection.
//!
//! A layer's matrix is then real on and imaginary off its diagonal, so the field (B, C) from the
//! substrate up splits into two real pairs, (Re B, Im C) and (Re C, Im B), that never meet. With C in
//! units of aragonite's admittance an aragonite layer turns both pairs by its phase; its scale changes
//! neither R nor T, so a number pair in the ratio of cosine and sine will do ([`phase::pair`]).

use multiversion::multiversion;

use crate::{
    incidence::Shares,
    lanes::{LANES, Lanes, fused},
    phase,
    real::{Real, Split},
    waves::Waves,
};

/// The media of one block of wavelengths as light of `N` polarisations meets them, for every stack of them
/// with protein layers of one thickness.
#[derive(Clone)]
pub(crate) struct Met<T, const N: usize>([Layers<T>; N]);

impl<T: Real, const N: usize> Met<T, N> {
    pub(crate) fn new(waves: &[Waves; N], half_turns_per_nm: &Lanes<f64>, protein_nm: f64) -> Self {
        let mut met = Self([Layers::empty(); N]);
        meet(&mut met, waves, half_turns_per_nm, protein_nm);
        met
    }
}

#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
fn meet<T: Real, const N: usize>(
    met: &mut Met<T, N>,
    waves: &[Waves; N],
    half_turns_per_nm: &Lanes<f64>,
    protein_nm: f64,
) {
    for (layers, waves) in met.0.iter_mut().zip(waves) {
        if fused!() {
            layers.meet::<true>(waves, half_turns_per_nm, protein_nm);
        } else {
            layers.meet::<false>(waves, half_turns_per_nm, protein_nm);
        }
    }
}

/// Adds R and T of the first `W` wavelengths of a block, the mean of `N` polarisations; where `ALIKE`, all of
/// them have the first one's phase in aragonite.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
pub(crate) fn add_shares<T: Real, const N: usize, const ALIKE: bool, const W: usize>(
    thickness_nm: &[f64],
    met: &Met<T, N>,
    waves: &[Waves; N],
    shares: &mut Shares,
) {
    if fused!() {
        from_layers::<T, true, N, ALIKE, W>(thickness_nm, met, waves, shares);
    } else {
        from_layers::<T, false, N, ALIKE, W>(thickness_nm, met, waves, shares);
    }
}

#[inline(always)]
fn from_layers<T: Real, const FUSED: bool, const N: usize, const ALIKE: bool, const W: usize>(
    thickness_nm: &[f64],
    Met(layers): &Met<T, N>,
    waves: &[Waves; N],
    shares: &mut Shares,
) {
    // Loops and no closures, which would not be compiled with these instructions.
    let mut fields = [Field::<T>::empty(); N];
    for n in 0..N {
        fields[n].start_at_substrate(&waves[n]);
    }
    climb::<T, FUSED, N, ALIKE, W>(thickness_nm, layers, &mut fields);
    for (field, waves) in fields.iter().zip(waves) {
        field.add_shares::<W>(waves, 1.0 / N as f64, shares);
    }
}

/// One polarisation of one block of wavelengths: the layers, as light at one angle meets them.
#[derive(Clone, Copy)]
struct Layers<T> {
    /// Half turns of phase per nm of aragonite, and what this precision rounds away of them.
    aragonite_per_nm: Lanes<T>,
    aragonite_per_nm_low: Lanes<T>,
    /// The protein layer: cos, sin / q and q sin of its phase, q in units of aragonite's admittance.
    protein_cos: Lanes<T>,
    protein_sin_per_q: Lanes<T>,
    protein_q_sin: Lanes<T>,
}

impl<T: Real> Layers<T> {
    #[inline(always)]
    fn empty() -> Self {
        let lanes = [T::default(); LANES];
        Self {
            aragonite_per_nm: lanes,
            aragonite_per_nm_low: lanes,
            protein_cos: lanes,
            protein_sin_per_q: lanes,
            protein_q_sin: lanes,
        }
    }

    #[inline(always)]
    fn meet<const FUSED: bool>(
        &mut self,
        waves: &Waves,
        half_turns_per_nm: &Lanes<f64>,
        protein_nm: f64,
    ) {
        for i in 0..LANES {
            let turn = Split::<T>::of(waves.aragonite_along.re[i] * half_turns_per_nm[i]);
            self.aragonite_per_nm[i] = turn.high;
            self.aragonite_per_nm_low[i] = turn.low;
            let protein_per_nm = waves.protein_along.re[i] * half_turns_per_nm[i];
            let f = phase::reduced::<f64, FUSED>(Split::of(protein_nm), protein_per_nm, 0.0);
            let (cos, sin) = phase::cos_sin::<FUSED>(f);
            self.protein_cos[i] = T::near(cos);
            self.protein_sin_per_q[i] = T::near(sin * waves.per_q.re[i]);
            self.protein_q_sin[i] = T::near(sin * waves.q.re[i]);
        }
    }
}

/// The field (B, C) of one polarisation, C in units of aragonite's admittance, up to a common scale.
#[derive(Clone, Copy)]
pub(crate) struct Field<T> {
    pub(crate) re_b: Lanes<T>,
    pub(crate) im_b: Lanes<T>,
    pub(crate) re_c: Lanes<T>,
    pub(crate) im_c: Lanes<T>,
}

impl<T: Real> Field<T> {
    #[inline(always)]
    pub(crate) fn empty() -> Self {
        let lanes = [T::default(); LANES];
        Self { re_b: lanes, im_b: lanes, re_c: lanes, im_c: lanes }
    }

    /// B = 1, C = the substrate's admittance.
    #[inline(always)]
    pub(crate) fn start_at_substrate(&mut self, waves: &Waves) {
        for i in 0..LANES {
            self.re_b[i] = T::ONE;
            self.re_c[i] = T::near(waves.substrate_ratio.re[i]);
            self.im_c[i] = T::near(waves.substrate_ratio.im[i]);
        }
    }

    /// R and T from the field at the surface, of any scale: the energy that goes in is what T lets out.
    #[inline(always)]
    pub(crate) fn add_shares<const W: usize>(&self, waves: &Waves, part: f64, shares: &mut Shares) {
        for i in 0..W {
            let (re_b, im_b) = (self.re_b[i].wide(), self.im_b[i].wide());
            let (re_c, im_c) = (self.re_c[i].wide(), self.im_c[i].wide());
            // Of the ambient in units of aragonite's, written without a division.
            let (q, unit) = (waves.ambient.re[i], waves.aragonite.re[i]);
            let square = |re: f64, im: f64| re * re + im * im;
            let away = square(q * re_b - unit * re_c, q * im_b - unit * im_c);
            let towards = square(q * re_b + unit * re_c, q * im_b + unit * im_c);
            let goes_in = 4.0 * q * unit * (re_b * re_c + im_b * im_c);
            let goes_in = if goes_in > 0.0 { goes_in } else { 0.0 };
            let transmits = waves.substrate.re[i] != 0.0;
            let share = part / towards;
            shares[0][i] += away * share;
            shares[1][i] += if transmits { goes_in * share } else { 0.0 };
        }
    }

    /// Brings the field back to size 1. Its scale means nothing, but must not overflow.
    #[inline(always)]
    pub(crate) fn rescale<const W: usize>(&mut self) {
        for i in 0..W {
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
/// time.
#[inline(always)]
fn climb<T: Real, const FUSED: bool, const N: usize, const ALIKE: bool, const W: usize>(
    thickness_nm: &[f64],
    layers: &[Layers<T>; N],
    fields: &mut [Field<T>; N],
) {
    for bilayers in thickness_nm.rchunks(TO_RESCALE) {
        let (rest, groups) = bilayers.as_rchunks::<AT_ONCE>();
        for group in groups.iter().rev() {
            through::<T, FUSED, N, ALIKE, W, AT_ONCE>(group, layers, fields);
        }
        for &thickness in rest.iter().rev() {
            through::<T, FUSED, N, ALIKE, W, 1>(&[thickness], layers, fields);
        }
        for field in &mut *fields {
            field.rescale::<W>();
        }
    }
}

/// The arithmetic of a few bilayers, deepest last in `group`.
#[inline(always)]
fn through<
    T: Real,
    const FUSED: bool,
    const N: usize,
    const ALIKE: bool,
    const W: usize,
    const G: usize,
>(
    group: &[f64; G],
    layers: &[Layers<T>; N],
    fields: &mut [Field<T>; N],
) {
    let group = group.map(Split::<T>::of);
    for i in 0..W {
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
    use crate::{media::Table, wave::Plane};
    use nacreous_nacre::{LayerStack, Medium};

    /// The processors' instructions differ in how a product is rounded before a sum, in nothing else.
    #[test]
    fn with_and_without_fused_instructions_only_rounding_differs() {
        let thickness_nm: Vec<f64> = (0..1001).map(|i| 350.0 + f64::from(i * 37 % 101)).collect();
        let medium = |n, k| nacreous_nacre::Index::new("medium", n, k).unwrap();
        let aragonite = Medium::uniaxial(medium(1.683, 0.0), medium(1.53, 0.0));
        let (protein, ambient) = (medium(1.43, 0.0), medium(1.0, 0.0));
        let stack =
            LayerStack::new(thickness_nm, 20.0, aragonite, protein, ambient, medium(1.5, 0.1));
        let stack = stack.unwrap();
        let nm: Lanes<f64> = std::array::from_fn(|i| 400.0 + 7.0 * i as f64);
        let table = Table::new(&stack, &nm).unwrap();
        let (media, turns) = (table.at([Plane::S, Plane::P], 0.8, 0), table.half_turns_per_nm[0]);
        let (mut fused, mut plain) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
        let (nm, waves) = (stack.thickness_nm(), &media.waves);
        let met = Met::new(waves, &turns, stack.protein_nm());
        from_layers::<f64, true, 2, false, LANES>(nm, &met, waves, &mut fused);
        from_layers::<f64, false, 2, false, LANES>(nm, &met, waves, &mut plain);
        for (a, b) in fused.as_flattened().iter().zip(plain.as_flattened()) {
            assert!((a - b).abs() < 1e-11, "{a} {b}");
        }
        assert!(fused[0].iter().any(|r| (0.2..0.9).contains(r)));
    }
}
