//! The varying parameters of a batch.

use super::chunk::{Chunk, LANES};
use super::view::{ConstView, Span, check_reach};
use crate::bsdf::{Bsdf, MAX_FLOATS};
use crate::error::Error;
use std::mem::MaybeUninit;

/// The numbers that a [`Room`] holds.
const NUMBERS: usize = 2048;

/// A buffer for the components of a chunk's elements. With many components chunks are shorter, because callers may
/// have small stacks. It is not initialised before it is used.
#[repr(C, align(64))]
pub(super) struct Room([MaybeUninit<f32>; NUMBERS]);

impl Room {
    pub const EMPTY: Self = Self([MaybeUninit::uninit(); NUMBERS]);
}

/// The views of the varying parameters.
pub(super) struct VaryingViews<'a> {
    bsdf: &'a Bsdf,
    views: &'a [ConstView],
}

impl<'a> VaryingViews<'a> {
    pub fn new(bsdf: &'a Bsdf, views: &'a [ConstView], count: usize) -> Result<Self, Error> {
        if !views.is_empty() && views.len() != bsdf.varying_count() {
            return Err(Error::invalid(format!(
                "varying_count = {} but the BSDF has {} varying parameters",
                views.len(),
                bsdf.varying_count()
            )));
        }
        for (view, components) in views.iter().zip(components(bsdf)) {
            check_reach(
                "varying",
                components,
                count,
                view.element_stride,
                view.component_stride,
            )?;
        }
        Ok(Self { bsdf, views })
    }

    /// The number of elements of a chunk: `most`, or fewer if a [`Room`] does not hold their components; a multiple
    /// of [`LANES`].
    pub fn longest_chunk(&self, most: usize) -> usize {
        if self.views.is_empty() {
            return most;
        }
        most.min(NUMBERS / self.bsdf.varying_floats() / LANES * LANES)
    }

    /// The address range of each view.
    pub fn spans(&self, count: usize) -> impl Iterator<Item = Span> + '_ {
        let views = self.views.iter().zip(components(self.bsdf));
        views.map(move |(view, components)| view.span(components, count))
    }

    /// The components of a chunk's elements, one slice per component, one parameter after another.
    ///
    /// # Safety
    /// As for [`Chunk::read`].
    pub unsafe fn read<'b, 'c>(
        &self,
        chunk: &Chunk,
        room: &'b mut Room,
        slices: &'c mut [&'b [f32]; MAX_FLOATS],
    ) -> &'c [&'b [f32]] {
        let mut rest = &mut room.0[..];
        let length = chunk.padded();
        let mut first = 0;
        for (view, varying) in self.views.iter().zip(self.bsdf.varying()) {
            let (components, own) = (varying.defaults.len(), varying.defaults);
            let (room, after) = rest.split_at_mut(components * length);
            let slices = &mut slices[first..first + components];
            let rooms = room.chunks_exact_mut(length);
            for (c, (slice, room)) in slices.iter_mut().zip(rooms).enumerate() {
                // SAFETY: the caller vouches for it.
                *slice = unsafe { component(chunk, view, c, own[c], room) };
            }
            rest = after;
            first += components;
        }
        &slices[..first]
    }
}

/// The number of components of each varying parameter.
fn components(bsdf: &Bsdf) -> impl Iterator<Item = usize> + '_ {
    bsdf.varying().map(|varying| varying.defaults.len())
}

/// One component of a chunk's elements; its default if the view is null.
unsafe fn component<'a>(
    chunk: &Chunk,
    view: &ConstView,
    c: usize,
    default: f32,
    room: &'a mut [MaybeUninit<f32>],
) -> &'a [f32] {
    let one = if view.data.is_null() {
        ConstView {
            data: &default,
            element_stride: 0,
            component_stride: 0,
        }
    } else {
        ConstView {
            // SAFETY: the caller vouches for the address.
            data: unsafe { view.address(0, c) },
            ..*view
        }
    };
    // SAFETY: the caller vouches for all elements; the default outlives the copy.
    unsafe { chunk.read(&one, room) }
}
