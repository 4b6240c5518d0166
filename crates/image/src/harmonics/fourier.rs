//! The Fourier transform of one ring of latitude, with the same bytes on every machine.
//!
//! Ready-made transforms (`rustfft`, our peer in the tests) choose their code by the processor and
//! take sines from the platform, so their last bits differ from machine to machine. A texture must
//! not: same seed, same bytes, in the browser too. Hence this small Stockham transform (passes of
//! four, sorted as it goes), whose sines come from `libm` and whose every operation is rounded by IEEE 754.

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

/// The inverse transform of one length: 1 or 3 times a power of two, from 4 up.
#[derive(Debug)]
pub(crate) struct InverseTransform {
    length: usize,
    /// exp(2 pi i k / length) as (cosine, sine).
    roots: Vec<(f64, f64)>,
}

impl InverseTransform {
    /// Prepares the roots of unity.
    pub fn new(length: usize) -> Self {
        debug_assert!(length >= 4 && (length.is_power_of_two() || (length / 3).is_power_of_two()));
        let angle = |k: usize| TAU * k as f64 / length as f64;
        let roots = (0..3 * length / 4).map(|k| (libm::cos(angle(k)), libm::sin(angle(k))));
        Self { length, roots: roots.collect() }
    }

    /// `x_j` = sum over k of `X_k` exp(+2 pi i j k / length), without any factor, in place.
    ///
    /// `scratch` has the same length as `signal`; what it holds afterwards means nothing.
    pub fn apply(&self, signal: &mut Signal, scratch: &mut Signal) {
        let mut stride = 1;
        if self.length.is_multiple_of(3) {
            self.first_pass_of_three(signal, scratch);
            std::mem::swap(signal, scratch);
            stride = 3;
        }
        while 4 * stride <= self.length {
            self.pass_of_four(stride, signal, scratch);
            std::mem::swap(signal, scratch);
            stride *= 4;
        }
        if stride < self.length {
            self.last_pass_of_two(signal, scratch);
            std::mem::swap(signal, scratch);
        }
    }

    /// Butterflies between the thirds of `from`.
    fn first_pass_of_three(&self, from: &Signal, to: &mut Signal) {
        let third = self.length / 3;
        let height = 0.75_f64.sqrt();
        for (p, (re, im)) in to.re.chunks_exact_mut(3).zip(to.im.chunks_exact_mut(3)).enumerate() {
            let [a, b, c] = [p, p + third, p + 2 * third].map(|k| (from.re[k], from.im[k]));
            let (s, t) = (b.0 + c.0, b.1 + c.1);
            let (g, h) = (height * (b.0 - c.0), height * (b.1 - c.1));
            let (u, v) = (a.0 - 0.5 * s, a.1 - 0.5 * t);
            (re[0], im[0]) = (a.0 + s, a.1 + t);
            (re[1], im[1]) = times((u - h, v + g), self.roots[p]);
            (re[2], im[2]) = times((u + h, v - g), self.roots[2 * p]);
        }
    }

    /// Butterflies between the quarters of `from`, written in their final order to `to`.
    fn pass_of_four(&self, stride: usize, from: &Signal, to: &mut Signal) {
        let quarter = self.length / 4;
        let group = 4 * stride;
        let groups = to.re.chunks_exact_mut(group).zip(to.im.chunks_exact_mut(group));
        for (start, (re, im)) in (0..quarter).step_by(stride).zip(groups) {
            let turn = [1, 2, 3].map(|power| self.roots[power * start]);
            let [a_re, b_re, c_re, d_re] =
                [0, 1, 2, 3].map(|k| &from.re[k * quarter + start..][..stride]);
            let [a_im, b_im, c_im, d_im] =
                [0, 1, 2, 3].map(|k| &from.im[k * quarter + start..][..stride]);
            let [re_0, re_1, re_2, re_3] = quarters(re, stride);
            let [im_0, im_1, im_2, im_3] = quarters(im, stride);
            for q in 0..stride {
                let (s, t) = (a_re[q] + c_re[q], a_im[q] + c_im[q]);
                let (u, v) = (a_re[q] - c_re[q], a_im[q] - c_im[q]);
                let (e, f) = (b_re[q] + d_re[q], b_im[q] + d_im[q]);
                let (g, h) = (b_re[q] - d_re[q], b_im[q] - d_im[q]);
                (re_0[q], im_0[q]) = (s + e, t + f);
                (re_1[q], im_1[q]) = times((u - h, v + g), turn[0]);
                (re_2[q], im_2[q]) = times((s - e, t - f), turn[1]);
                (re_3[q], im_3[q]) = times((u + h, v - g), turn[2]);
            }
        }
    }

    /// What remains when four does not divide the rest: butterflies between the halves.
    fn last_pass_of_two(&self, from: &Signal, to: &mut Signal) {
        for (from, to) in [(&from.re, &mut to.re), (&from.im, &mut to.im)] {
            let (a, b) = from.split_at(self.length / 2);
            let (sum, difference) = to.split_at_mut(self.length / 2);
            for q in 0..self.length / 2 {
                (sum[q], difference[q]) = (a[q] + b[q], a[q] - b[q]);
            }
        }
    }
}

fn quarters(all: &mut [f64], stride: usize) -> [&mut [f64]; 4] {
    let (low, high) = all.split_at_mut(2 * stride);
    let ((a, b), (c, d)) = (low.split_at_mut(stride), high.split_at_mut(stride));
    [a, b, c, d]
}

fn times((re, im): (f64, f64), (cos, sin): (f64, f64)) -> (f64, f64) {
    (re * cos - im * sin, re * sin + im * cos)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rustfft::{FftPlanner, num_complex::Complex};

    #[test]
    fn agrees_with_rustfft() {
        for length in [4, 6, 8, 12, 64, 96, 1536, 2048] {
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
