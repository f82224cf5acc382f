//! Snell's law at the plane z = 0.

use crate::num::{Lane, Real, Vec3};

/// The cosine of the critical angle in a medium of that index beside another one; `None` unless the other is less.
pub fn critical_cosine(near: f64, far: f64) -> Option<f64> {
    let ratio = far / near;
    let squared = (1.0 - ratio) * (1.0 + ratio);
    (squared > 0.0).then(|| squared.sqrt())
}

/// The interface between an outer medium (z > 0) and an inner one (z < 0), both transparent.
#[derive(Clone, Copy, Debug)]
pub struct Interface<T> {
    /// The outer index over the inner index, r0 / r1.
    ratio: T,
    /// 1 - ratio^2: negative where total reflection is possible from outside.
    complement: T,
}

impl<T: Real> Interface<T> {
    /// The interface between two indices > 0. The complement is computed from their difference, so that it
    /// keeps its digits when they are nearly equal.
    #[inline(always)]
    pub fn new(eta_outside: T, eta_inside: T) -> Self {
        let ratio = eta_outside / eta_inside;
        let complement =
            (eta_inside - eta_outside) * (eta_inside + eta_outside) / eta_inside.squared();
        Self { ratio, complement }
    }

    /// (r0 / r1)^2, the factor of projected solid angles from outside to inside: cos_i dw_i = (r0 / r1)^2
    /// cos_o dw_o.
    #[inline(always)]
    pub fn ratio_squared(&self) -> T {
        self.ratio.squared()
    }

    /// The squared cosine of the critical angle inside; 0 if every inner direction can leave.
    #[inline(always)]
    pub fn critical_cosine_squared(&self) -> T {
        self.complement.max(T::new(0.0))
    }

    /// The inner direction of the ray whose outer part is `w` (unit, z > 0), both pointing to
    /// z > 0. Its z is 0 where `w` is totally reflected.
    ///
    /// cos_t^2 = (1 - ratio^2) + ratio^2 cos^2 has no cancellation for ratio <= 1, and uses the cosine
    /// itself, because at grazing angles the length of the tangential part rounds to 1.
    #[inline(always)]
    pub fn inside(&self, w: Vec3<T>) -> Vec3<T> {
        Vec3::new(self.ratio * w.x, self.ratio * w.y, self.cosine_inside(w.z))
    }

    /// The z of [`Interface::inside`] for the z of the outer direction.
    #[inline(always)]
    pub fn cosine_inside(&self, cos_theta: T) -> T {
        let cos_squared = self.complement + self.ratio.squared() * cos_theta.squared();
        cos_squared.sqrt_positive()
    }

    /// r0 / r1
    #[inline(always)]
    pub fn ratio(&self) -> T {
        self.ratio
    }

    /// The outer direction of the ray whose inner part is `a` (unit, z > 0), both pointing to
    /// z > 0. Its z is 0 where `a` is totally reflected.
    #[inline(always)]
    pub fn outside(&self, a: Vec3<T>) -> Vec3<T> {
        let inverse = T::new(1.0) / self.ratio;
        let cos_squared = a.z.squared() - self.complement;
        Vec3::new(
            a.x * inverse,
            a.y * inverse,
            cos_squared.sqrt_positive() * inverse,
        )
    }
}

impl<C: Real> Interface<C> {
    /// Applies a function to both numbers.
    #[inline(always)]
    pub(crate) fn map<D>(&self, f: impl Fn(C) -> D) -> Interface<D> {
        Interface {
            ratio: f(self.ratio),
            complement: f(self.complement),
        }
    }

    /// One channel of an interface with an index per channel.
    #[inline(always)]
    pub fn channel<T: Lane<Rgb = C>>(&self, c: usize) -> Interface<T> {
        Interface {
            ratio: T::channels(self.ratio)[c],
            complement: T::channels(self.complement)[c],
        }
    }

    /// The interface of the first channel in all channels.
    #[inline(always)]
    pub fn gray<T: Lane<Rgb = C>>(&self) -> Self {
        let Interface { ratio, complement } = self.channel::<T>(0);
        Interface {
            ratio: ratio.gray(),
            complement: complement.gray(),
        }
    }
}
