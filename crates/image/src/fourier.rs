//! The Fourier transform of one ring of latitude, with the same bytes on every machine.
//!
//! Ready-made transforms (`rustfft`, our peer in the tests) choose their code by the processor and
//! take sines from the platform, so their last bits differ from machine to machine. A texture must
//! not: same seed, same bytes, in the browser too. Hence this small Stockham transform (radix 2,
//! sorted as it goes), whose sines come from `libm` and whose every operation is rounded by IEEE 754.

use std::f64::consts::TAU;

/// A complex signal as two real arrays, so that the compiler can work on several samples at once.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Signal {
    pub re: Vec<f64>,
    pub im: Vec<f64>,
}

impl Signal {
    pub fn zero(length: usize) -> Self {
        Self { re: vec![0.0; length], im: vec![0.0; length] }
    }
}

/// The inverse transform of one length, a power of two.
#[derive(Debug)]
pub(crate) struct InverseTransform {
    length: usize,
    cos: Vec<f64>,
    sin: Vec<f64>,
}

impl InverseTransform {
    /// Prepares the roots of unity. `length` is a power of two.
    pub fn new(length: usize) -> Self {
        debug_assert!(length.is_power_of_two());
        let root = |k: usize| libm::sincos(TAU * k as f64 / length as f64);
        let (sin, cos) = (0..length / 2).map(root).unzip();
        Self { length, cos, sin }
    }

    /// x_j = sum over k of X_k exp(+2 pi i j k / length), without any factor, in place.
    ///
    /// `scratch` has the same length as `signal`; what it holds afterwards means nothing.
    pub fn apply(&self, signal: &mut Signal, scratch: &mut Signal) {
        let mut stride = 1;
        while stride < self.length {
            self.pass(stride, signal, scratch);
            std::mem::swap(signal, scratch);
            stride *= 2;
        }
    }

    /// One pass: butterflies between the halves of `from`, written in their final order to `to`.
    fn pass(&self, stride: usize, from: &Signal, to: &mut Signal) {
        let half = self.length / 2;
        let (low_re, high_re) = from.re.split_at(half);
        let (low_im, high_im) = from.im.split_at(half);
        let groups = (to.re.chunks_exact_mut(2 * stride)).zip(to.im.chunks_exact_mut(2 * stride));
        for (p, (re, im)) in (0..half).step_by(stride).zip(groups) {
            let (cos, sin) = (self.cos[p], self.sin[p]);
            let span = p..p + stride;
            let (a_re, b_re) = (&low_re[span.clone()], &high_re[span.clone()]);
            let (a_im, b_im) = (&low_im[span.clone()], &high_im[span]);
            let (sum_re, turned_re) = re.split_at_mut(stride);
            let (sum_im, turned_im) = im.split_at_mut(stride);
            for q in 0..stride {
                sum_re[q] = a_re[q] + b_re[q];
                sum_im[q] = a_im[q] + b_im[q];
                let (d_re, d_im) = (a_re[q] - b_re[q], a_im[q] - b_im[q]);
                turned_re[q] = d_re * cos - d_im * sin;
                turned_im[q] = d_re * sin + d_im * cos;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rustfft::{FftPlanner, num_complex::Complex};

    #[test]
    fn agrees_with_rustfft() {
        for length in [2, 8, 64, 2048] {
            let value = |k: usize| libm::sincos(0.1 + 1.7 * (k * k) as f64);
            let (re, im): (Vec<f64>, Vec<f64>) = (0..length).map(value).unzip();
            let mut peer: Vec<_> = re.iter().zip(&im).map(|(&r, &i)| Complex::new(r, i)).collect();
            FftPlanner::new().plan_fft_inverse(length).process(&mut peer);
            let mut ours = Signal { re, im };
            InverseTransform::new(length).apply(&mut ours, &mut Signal::zero(length));
            for (j, expected) in peer.iter().enumerate() {
                let error = (Complex::new(ours.re[j], ours.im[j]) - expected).norm();
                assert!(error < 1e-14 * (length as f64).powi(2), "{length} at {j}: {error}");
            }
        }
    }
}
