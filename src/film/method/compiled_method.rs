//! The trait of compiled methods.

use crate::num::Rgb;

/// A method compiled for a film, in numbers of type `T`.
pub trait CompiledMethod<T>: Send + Sync {
    /// Reflectance of unpolarised light from the ambient's side, linear RGB, not clipped, at the cosine
    /// of incidence in the ambient medium and a thickness (nm). Both are clamped to the method's range;
    /// NaN counts as 0. Results are finite.
    fn reflectance(&self, cos_theta: T, thickness_nm: T) -> Rgb<T>;
}

/// What a method that has no table is made from, besides the description of the film.
#[derive(Clone, Copy, Debug)]
pub(in crate::film) struct Ingredients {
    /// The size of a method for one layer; 1 for others.
    pub size: usize,
    /// The reflectance of a bare base at normal incidence, from the ambient's side; 0 for other films.
    pub normal: Rgb<f32>,
}
