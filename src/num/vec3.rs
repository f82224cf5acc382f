//! Three-vectors and colours over [`Real`].

use super::{Lane, Real};

/// One value per colour channel: red, green, blue.
pub type Rgb<T> = [T; 3];

/// A vector or a direction in the shading frame.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Vec3<T> {
    /// Component along the tangent.
    pub x: T,
    /// Component along the bitangent.
    pub y: T,
    /// Component along the shading normal; for a unit direction the cosine of its angle to the normal.
    pub z: T,
}

impl<T: Real> Vec3<T> {
    /// The vector with these components.
    #[inline(always)]
    pub fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// The vector with these components.
    #[inline(always)]
    pub fn from_array([x, y, z]: [T; 3]) -> Self {
        Self { x, y, z }
    }

    /// The components.
    #[inline(always)]
    pub fn to_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }

    /// The null vector, which stands for "no direction".
    #[inline(always)]
    pub fn zero() -> Self {
        Self::new(T::new(0.0), T::new(0.0), T::new(0.0))
    }

    /// Inner product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Squared length.
    #[inline(always)]
    pub fn length_squared(self) -> T {
        self.dot(self)
    }

    /// Product with a number.
    #[inline(always)]
    pub fn scaled(self, factor: T) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }

    /// Sum.
    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }

    /// Difference.
    #[inline(always)]
    pub fn minus(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }

    /// The vector divided by its length. The vector must not be null.
    #[inline(always)]
    pub fn normalized(self) -> Self {
        self.scaled(T::new(1.0) / self.length_squared().sqrt())
    }

    /// The direction that leaves a mirror with unit normal `n` when light arrives along `-self`. It is 2 (w.n) n /
    /// |n|^2 - w with 1 / |n|^2 = 2 - |n|^2, to first order: what rounding has left of the length of `n` would be
    /// four times as much in the squared length of the result.
    #[inline(always)]
    pub fn mirrored_about(self, n: Self) -> Self {
        let two = T::new(2.0);
        let twice = self.dot(n) * two * (two - n.length_squared());
        n.scaled(twice).minus(self)
    }

    /// [`Vec3::mirrored_about`] the shading normal.
    #[inline(always)]
    pub fn mirrored(self) -> Self {
        Self::new(-self.x, -self.y, self.z)
    }

    /// Rotates a vector given relative to +Z into the frame whose third axis is the unit vector `self`. The
    /// frame is continuous except at z = 0, where its sign convention switches: Duff et al. 2017, "Building
    /// an Orthonormal Basis, Revisited", listing 3.
    #[inline(always)]
    pub fn frame_to_world(self, local: Self) -> Self {
        let one = T::new(1.0);
        let sign = T::select(self.z.lt(T::new(0.0)), -one, one);
        let a = -one / (sign + self.z);
        let b = self.x * self.y * a;
        let tangent = Self::new(
            one + sign * self.x.squared() * a,
            sign * b,
            -(sign * self.x),
        );
        let bitangent = Self::new(b, sign + self.y.squared() * a, -self.y);
        tangent
            .scaled(local.x)
            .plus(bitangent.scaled(local.y))
            .plus(self.scaled(local.z))
    }

    /// The unit vector along this one, and a mask of the lanes in which it exists and has z > 0. The vector
    /// is divided by its largest component first, since the square of a large or a small number may leave
    /// the range of the type.
    #[inline(always)]
    pub fn upward(self) -> (Self, T::Mask) {
        let zero = T::new(0.0);
        let largest = self.x.abs().max(self.y.abs()).max(self.z.abs());
        let inverse = T::new(1.0) / largest;
        let unit = self.scaled(inverse).normalized();
        let is_upward = self.z.gt(zero) & inverse.is_finite() & unit.z.gt(zero);
        (unit, is_upward)
    }

    /// `yes` where the mask is set, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self::new(
            T::select(mask, yes.x, no.x),
            T::select(mask, yes.y, no.y),
            T::select(mask, yes.z, no.z),
        )
    }
}

impl<T: Lane> Vec3<T> {
    /// The same vector in every colour channel.
    #[inline(always)]
    pub fn gray(self) -> Vec3<T::Rgb> {
        Vec3::new(self.x.gray(), self.y.gray(), self.z.gray())
    }
}
