//! Wavelengths, or where they are few angles too, side by side: every inner loop of the kernels runs over
//! them, and the compiler turns it into the vector instructions of the processor it finds.

use num_complex::Complex64;

use crate::real::Real;

/// Points of a table computed side by side, a multiple of every processor's vector length; enough of them that
/// one layer's arithmetic hides the latency of another's.
pub(crate) const LANES: usize = 32;

/// Lanes of a block that wavelengths end in early; a multiple of every processor's vector length too.
pub(crate) const HALF: usize = LANES / 2;

/// One number for each lane.
pub(crate) type Lanes<T> = [T; LANES];

/// A block of wavelengths, the last one again and again where they end within it.
pub(crate) fn filled(wavelength_nm: &[f64]) -> Lanes<f64> {
    std::array::from_fn(|lane| wavelength_nm[lane.min(wavelength_nm.len() - 1)])
}

/// One complex number for each lane.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Pair {
    pub(crate) re: Lanes<f64>,
    pub(crate) im: Lanes<f64>,
}

impl Pair {
    pub(crate) const ZERO: Self = Self { re: [0.0; LANES], im: [0.0; LANES] };

    #[inline(always)]
    pub(crate) fn at(&self, i: usize) -> Complex64 {
        Complex64::new(self.re[i], self.im[i])
    }

    #[inline(always)]
    pub(crate) fn set(&mut self, i: usize, value: Complex64) {
        (self.re[i], self.im[i]) = (value.re, value.im);
    }

    /// Each lane's number from the lane named.
    pub(crate) fn gathered(&self, from: &Lanes<usize>) -> Self {
        Self { re: from.map(|lane| self.re[lane]), im: from.map(|lane| self.im[lane]) }
    }

    #[inline(always)]
    pub(crate) fn is_real(&self) -> bool {
        // Without a way out in the middle, which would keep the lanes apart.
        self.im.iter().fold(true, |all, &im| all & (im == 0.0))
    }
}

/// a b + c d of complex numbers; num-complex's products do not fuse.
#[inline(always)]
pub(crate) fn products<const FUSED: bool>(
    a: Complex64,
    b: Complex64,
    c: Complex64,
    d: Complex64,
) -> Complex64 {
    let re = c.re.times_plus::<FUSED>(d.re, -(c.im * d.im));
    let im = c.re.times_plus::<FUSED>(d.im, c.im * d.re);
    let re = a.im.times_plus::<FUSED>(-b.im, re);
    let im = a.im.times_plus::<FUSED>(b.re, im);
    Complex64::new(a.re.times_plus::<FUSED>(b.re, re), a.re.times_plus::<FUSED>(b.im, im))
}

/// Whether the function that asks was compiled for a processor that multiplies and adds in one step.
/// Elsewhere `mul_add` would be a slow call.
macro_rules! fused {
    () => {
        cfg!(target_arch = "aarch64") || multiversion::target::target_cfg_f!(target_feature = "fma")
    };
}
pub(crate) use fused;
