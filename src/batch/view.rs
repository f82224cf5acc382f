//! Strided arrays, and the checks that come before any address is used.

use crate::error::Error;

/// A strided array to read: component c of element i is `i * element_stride + c * component_stride`
/// bytes from `data`. Any alignment, any sign of stride.
#[derive(Clone, Copy, Debug)]
pub struct ConstView {
    /// Component 0 of element 0.
    pub data: *const f32,
    /// Bytes from one element to the next.
    pub element_stride: isize,
    /// Bytes from one component to the next.
    pub component_stride: isize,
}

/// A strided array to write, addressed like [`ConstView`]; null data = not wanted.
#[derive(Clone, Copy, Debug)]
pub struct View<T = f32> {
    /// Component 0 of element 0.
    pub data: *mut T,
    /// Bytes from one element to the next.
    pub element_stride: isize,
    /// Bytes from one component to the next.
    pub component_stride: isize,
}

impl ConstView {
    /// Refuses null, unless there are no elements, and offsets that overflow.
    pub(super) fn check(&self, name: &str, components: usize, count: usize) -> Result<(), Error> {
        if self.data.is_null() && count > 0 {
            return Err(Error::invalid(format!("{name}.data is NULL")));
        }
        check_reach(
            name,
            components,
            count,
            self.element_stride,
            self.component_stride,
        )
    }

    /// Component c of element i.
    pub(super) unsafe fn at(&self, i: usize, c: usize) -> f32 {
        let offset = i as isize * self.element_stride + c as isize * self.component_stride;
        // SAFETY: the caller of the batch vouches for this address; check_reach for the offset.
        unsafe { self.data.byte_offset(offset).read_unaligned() }
    }

    /// The three components of element i.
    pub(super) unsafe fn load(&self, i: usize) -> [f32; 3] {
        // SAFETY: as in `at`.
        unsafe { [self.at(i, 0), self.at(i, 1), self.at(i, 2)] }
    }
}

impl<T: Copy> View<T> {
    /// Refuses offsets that overflow.
    pub(super) fn check(&self, name: &str, components: usize, count: usize) -> Result<(), Error> {
        check_reach(
            name,
            components,
            count,
            self.element_stride,
            self.component_stride,
        )
    }

    /// Writes the components of element i, if they are wanted.
    pub(super) unsafe fn store<const N: usize>(&self, i: usize, values: [T; N]) {
        if self.data.is_null() {
            return;
        }
        for (c, value) in values.into_iter().enumerate() {
            let offset = i as isize * self.element_stride + c as isize * self.component_stride;
            // SAFETY: the caller of the batch vouches for this address; check_reach for the offset.
            unsafe { self.data.byte_offset(offset).write_unaligned(value) }
        }
    }
}

/// Refuses views whose farthest component is further away than an address can say.
pub(super) fn check_reach(
    name: &str,
    components: usize,
    count: usize,
    element_stride: isize,
    component_stride: isize,
) -> Result<(), Error> {
    let reach = |steps: usize, stride: isize| steps.checked_mul(stride.unsigned_abs());
    let farthest = reach(count.saturating_sub(1), element_stride)
        .zip(reach(components - 1, component_stride))
        .and_then(|(elements, components)| elements.checked_add(components));
    match farthest {
        Some(bytes) if isize::try_from(bytes).is_ok() => Ok(()),
        _ => Err(Error::invalid(format!(
            "{name}: count = {count} with element_stride = {element_stride} and \
             component_stride = {component_stride} overflows the address space"
        ))),
    }
}
