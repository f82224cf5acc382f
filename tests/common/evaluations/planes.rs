//! Arrays of one batch, each component's numbers side by side.

use super::BATCH;
use pellicle::batch::{ConstView, View};

/// Components of all elements.
pub struct Planes<T, const N: usize>(Vec<[T; BATCH]>);

impl<T: Copy, const N: usize> Planes<T, N> {
    pub fn new(value: T) -> Self {
        Self(vec![[value; BATCH]; N])
    }

    pub fn set(&mut self, i: usize, values: [T; N]) {
        for (plane, value) in self.0.iter_mut().zip(values) {
            plane[i] = value;
        }
    }

    pub fn get(&self, i: usize) -> [T; N] {
        std::array::from_fn(|c| self.0[c][i])
    }

    pub fn view(&mut self) -> View<T> {
        View {
            data: self.0.as_mut_ptr().cast(),
            element_stride: size_of::<T>() as isize,
            component_stride: size_of::<[T; BATCH]>() as isize,
        }
    }
}

impl<const N: usize> Planes<f32, N> {
    pub fn const_view(&self) -> ConstView {
        ConstView {
            data: self.0.as_ptr().cast(),
            element_stride: 4,
            component_stride: 4 * BATCH as isize,
        }
    }
}
