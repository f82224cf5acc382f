//! Complex numbers over [`Real`], with the operations that wave optics needs.

use crate::num::Real;
use std::ops::{Add, Mul, Neg, Sub};

/// A complex number re + i im. Waves are written as e^(i (k x - w t)), so that a medium of index eta + i k
/// with k > 0 absorbs.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Complex<T> {
    /// Real part.
    pub re: T,
    /// Imaginary part.
    pub im: T,
}

impl<T: Real> Complex<T> {
    /// re + i im.
    #[inline(always)]
    pub fn new(re: T, im: T) -> Self {
        Self { re, im }
    }

    /// A real number.
    #[inline(always)]
    pub fn real(re: T) -> Self {
        Self::new(re, T::new(0.0))
    }

    /// Product with a real number.
    #[inline(always)]
    pub fn scaled(self, factor: T) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }

    /// |z|^2.
    #[inline(always)]
    pub fn norm_squared(self) -> T {
        self.re.squared() + self.im.squared()
    }

    /// Whether the numbers are equal, in both parts.
    #[inline(always)]
    pub fn equals(self, other: Self) -> T::Mask {
        self.re.equals(other.re) & self.im.equals(other.im)
    }

    /// The greater of |re| and |im|. It differs from |z| by a factor sqrt(2) at most, and does not
    /// underflow.
    #[inline(always)]
    pub fn magnitude(self) -> T {
        self.re.abs().max(self.im.abs())
    }

    /// 1 / z. |z|^2 must neither overflow nor underflow.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let factor = T::new(1.0) / self.norm_squared();
        Self::new(self.re * factor, -(self.im * factor))
    }

    /// The square root with im >= 0 and re >= 0 of a number with im >= 0. Of (|z| + re) / 2 and (|z| - re)
    /// / 2 the root of the one without cancellation is taken; the other part follows from 2 re im = im(z).
    #[inline(always)]
    pub fn sqrt_upper(self) -> Self {
        let half = T::new(0.5);
        let zero = T::new(0.0);
        let large = ((self.norm_squared().sqrt() + self.re.abs()) * half).sqrt();
        let is_zero = large.equals(zero);
        let quotient = half * self.im / T::select(is_zero, T::new(1.0), large);
        let small = T::select(is_zero, zero, quotient);
        let left = self.re.lt(zero);
        Self::new(T::select(left, small, large), T::select(left, large, small))
    }

    /// `yes` where the mask is set, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self::new(
            T::select(mask, yes.re, no.re),
            T::select(mask, yes.im, no.im),
        )
    }
}

impl<T: Real> Add for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl<T: Real> Sub for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl<T: Real> Mul for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}

impl<T: Real> Neg for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}
