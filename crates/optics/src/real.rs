//! The two precisions of the exact kernel, and what differs between them.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A precision: `f64`, exact to rounding, or `f32`, for interactive use.
pub(crate) trait Real:
    Copy
    + Default
    + Send
    + Sync
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// Adding and subtracting it rounds to the nearest integer: 1.5 times the largest power of two
    /// below which halves can be written.
    const ROUND: Self;
    /// 1.
    const ONE: Self;
    /// Whether a number needs a second one that holds its rounding error.
    const SPLIT: bool;
    /// Coefficients of P and Q of [`crate::phase::pair`], highest first, shared length.
    const PAIR: &'static [(Self, Self)];

    /// The nearest number of this precision.
    fn near(x: f64) -> Self;
    /// Without loss.
    fn wide(self) -> f64;
    /// self * b + c, rounded once where `FUSED`; only processors with that instruction should ask.
    fn times_plus<const FUSED: bool>(self, b: Self, c: Self) -> Self;
    fn abs(self) -> Self;
}

impl Real for f64 {
    const ROUND: Self = 6_755_399_441_055_744.0;
    const ONE: Self = 1.0;
    const SPLIT: bool = false;
    // Through zeros of Chebyshev's polynomial: the angle is right to 1.7e-18.
    const PAIR: &'static [(Self, Self)] = &[
        (0.012_657_822_997_745_95, 0.000_895_332_033_241_712_6),
        (-0.389_696_067_122_937_6, -0.087_911_309_009_917_04),
        (2.680_004_157_601_326, 1.205_343_446_335_254),
        (-4.645_842_813_689_488, -4.259_920_093_119_891),
        (1.0, std::f64::consts::PI),
    ];

    #[inline(always)]
    fn near(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn wide(self) -> f64 {
        self
    }
    #[inline(always)]
    fn times_plus<const FUSED: bool>(self, b: Self, c: Self) -> Self {
        if FUSED { self.mul_add(b, c) } else { self * b + c }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
}

impl Real for f32 {
    const ROUND: Self = 12_582_912.0;
    const ONE: Self = 1.0;
    const SPLIT: bool = true;
    // The angle is right to 2.6e-8, less than the rounding.
    const PAIR: &'static [(Self, Self)] =
        &[(1.583_977_7, 0.344_715_15), (-4.395_994, -3.475_010_3), (1.0, std::f32::consts::PI)];

    #[inline(always)]
    fn near(x: f64) -> Self {
        x as f32
    }
    #[inline(always)]
    fn wide(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    fn times_plus<const FUSED: bool>(self, b: Self, c: Self) -> Self {
        if FUSED { self.mul_add(b, c) } else { self * b + c }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
}

/// A number and what it lacks, where the precision needs that.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Split<T> {
    pub(crate) high: T,
    pub(crate) low: T,
}

impl<T: Real> Split<T> {
    #[inline(always)]
    pub(crate) fn of(x: f64) -> Self {
        let high = T::near(x);
        Self { high, low: T::near(x - high.wide()) }
    }
}
