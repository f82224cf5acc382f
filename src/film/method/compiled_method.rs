//! The trait of compiled methods.

use crate::num::Rgb;

/// A method compiled for a film, in numbers of type `T`.
pub trait CompiledMethod<T>: Send + Sync {
    /// Reflectance of unpolarised light from the ambient's side, linear RGB, not clipped, at the cosine
    /// of incidence in the ambient medium and a thickness (nm). Both are clamped to the method's range;
    /// NaN counts as 0. Results are finite.
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T>;
}
