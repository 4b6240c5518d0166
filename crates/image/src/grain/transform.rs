//! The Fourier transform of any length, with the same bytes on every machine: a photograph's grain is the same in the
//! browser.
//!
//! Lengths that the rings of latitude have are theirs (`harmonics/fourier.rs`). All others become a convolution, by
//! `2 j k = j^2 + k^2 - (j - k)^2` (Bluestein 1970), which such a length carries.

use std::f64::consts::PI;

use crate::harmonics::fourier::{InverseTransform, Signal};

/// The transform of one length, 4 and up.
pub(super) struct Transform {
    inner: InverseTransform,
    chirp: Option<Chirp>,
    inner_length: usize,
}

/// What makes a convolution of a transform.
struct Chirp {
    /// exp(i pi n^2 / length).
    turns: Signal,
    /// The transform of their conjugates, over the inner length.
    response: Signal,
}

/// Room for the transforms of one thread.
pub(super) struct Room {
    padded: Signal,
    scratch: Signal,
}

impl Transform {
    pub(super) fn new(length: usize) -> Self {
        if is_direct(length) {
            return Self {
                inner: InverseTransform::new(length),
                chirp: None,
                inner_length: length,
            };
        }
        let inner_length = next_direct(2 * length - 1);
        let inner = InverseTransform::new(inner_length);
        let mut turns = Signal::zero(length);
        let mut response = Signal::zero(inner_length);
        for n in 0..length {
            let angle = PI * (n * n % (2 * length)) as f64 / length as f64;
            (turns.im[n], turns.re[n]) = libm::sincos(angle);
            for place in [n, (inner_length - n) % inner_length] {
                (response.re[place], response.im[place]) = (turns.re[n], -turns.im[n]);
            }
        }
        inner.apply(&mut response, &mut Signal::zero(inner_length));
        Self { inner, chirp: Some(Chirp { turns, response }), inner_length }
    }

    pub(super) fn room(&self) -> Room {
        let empty = || Signal::zero(self.inner_length);
        Room { padded: empty(), scratch: empty() }
    }

    /// `X_k` = sum over j of `x_j` exp(-2 pi i j k / length), in place.
    pub(super) fn forward(&self, signal: &mut Signal, room: &mut Room) {
        exchanged(signal, |signal| self.inverse(signal, room));
    }

    /// `x_j` = sum over k of `X_k` exp(+2 pi i j k / length), without any factor, in place.
    pub(super) fn inverse(&self, signal: &mut Signal, room: &mut Room) {
        let Some(Chirp { turns, response }) = &self.chirp else {
            return self.inner.apply(signal, &mut room.scratch);
        };
        let Room { padded, scratch } = room;
        for k in 0..turns.re.len() {
            set(padded, k, times(at(signal, k), at(turns, k)));
        }
        padded.re[turns.re.len()..].fill(0.0);
        padded.im[turns.re.len()..].fill(0.0);
        self.inner.apply(padded, scratch);
        for k in 0..self.inner_length {
            set(padded, k, times(at(padded, k), at(response, k)));
        }
        exchanged(padded, |padded| self.inner.apply(padded, scratch));
        let share = 1.0 / self.inner_length as f64;
        for j in 0..turns.re.len() {
            let (re, im) = times(at(padded, j), at(turns, j));
            set(signal, j, (re * share, im * share));
        }
    }
}

/// The least length that a ring of latitude may have, from this one up.
fn next_direct(least: usize) -> usize {
    let thirds = 3 * least.div_ceil(3).next_power_of_two();
    least.next_power_of_two().min(thirds)
}

/// Whether a ring of latitude may have this length.
fn is_direct(length: usize) -> bool {
    length.is_power_of_two() || length.is_multiple_of(3) && (length / 3).is_power_of_two()
}

/// Real and imaginary part change places before and after: the other direction of a transform.
fn exchanged(signal: &mut Signal, transform: impl FnOnce(&mut Signal)) {
    std::mem::swap(&mut signal.re, &mut signal.im);
    transform(signal);
    std::mem::swap(&mut signal.re, &mut signal.im);
}

fn at(signal: &Signal, k: usize) -> (f64, f64) {
    (signal.re[k], signal.im[k])
}

fn set(signal: &mut Signal, k: usize, value: (f64, f64)) {
    (signal.re[k], signal.im[k]) = value;
}

fn times(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rustfft::{FftPlanner, num_complex::Complex};

    #[test]
    fn every_length_of_a_patch_agrees_with_rustfft_and_returns() {
        for length in (8..130).chain([691, 1000, 1021, 1023, 1024]) {
            let value = |k: usize| libm::sincos(0.1 + 1.7 * (k * k) as f64);
            let (re, im): (Vec<f64>, Vec<f64>) = (0..length).map(value).unzip();
            let mut peer: Vec<_> = re.iter().zip(&im).map(|(&r, &i)| Complex::new(r, i)).collect();
            FftPlanner::new().plan_fft_forward(length).process(&mut peer);
            let given = Signal { re, im };
            let mut ours = given.clone();
            let transform = Transform::new(length);
            let mut room = transform.room();
            transform.forward(&mut ours, &mut room);
            let far = |k: usize| (Complex::new(ours.re[k], ours.im[k]) - peer[k]).norm();
            let worst = (0..length).map(far).fold(0.0, f64::max);
            // The waves' power is the length on average.
            assert!(worst < 4e-15 * length as f64, "{length}: {worst}");
            transform.inverse(&mut ours, &mut room);
            let back = |j: usize| (ours.re[j] / length as f64 - given.re[j]).abs();
            assert!((0..length).map(back).fold(0.0, f64::max) < 1e-14, "{length}");
        }
    }
}
