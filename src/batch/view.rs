//! Strided arrays, and the checks that are made before any address is used.

use crate::error::Error;

/// A strided array to read: component c of element i is `i * element_stride + c * component_stride` bytes
/// after `data`. Any alignment is allowed, and strides may be negative or 0.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct ConstView {
    /// Component 0 of element 0.
    pub data: *const f32,
    /// Bytes from one element to the next.
    pub element_stride: isize,
    /// Bytes from one component to the next.
    pub component_stride: isize,
}

/// A strided array to write, addressed like [`ConstView`]. Null data means that the output is not wanted.
#[derive(Clone, Copy, Debug)]
pub struct View<T = f32> {
    /// Component 0 of element 0.
    pub data: *mut T,
    /// Bytes from one element to the next.
    pub element_stride: isize,
    /// Bytes from one component to the next.
    pub component_stride: isize,
}

/// The first and the last address of a view's elements; `None` for null data or without elements.
pub(super) type Span = Option<[usize; 2]>;

/// The least distance of the columns of two components that are used in place, in elements: the length of a
/// chunk.
pub(super) const LEAST_DISTANCE: usize = 256;

/// The size of a number in bytes.
const NUMBER: isize = size_of::<f32>() as isize;

impl ConstView {
    /// No array: null data.
    pub const NONE: Self = Self {
        data: std::ptr::null(),
        element_stride: 0,
        component_stride: 0,
    };

    /// Refuses null data, unless there are no elements, and offsets that overflow.
    #[inline]
    pub(super) fn check(&self, name: &str, components: usize, count: usize) -> Result<(), Error> {
        if self.data.is_null() && count > 0 {
            return Err(Error::invalid(format!("{name}.data is NULL")));
        }
        self.as_view().check(name, components, count)
    }

    /// [`View::span`]
    pub(super) fn span(&self, components: usize, count: usize) -> Span {
        self.as_view().span(components, count)
    }

    /// [`View::address`]
    #[inline(always)]
    pub(super) unsafe fn address(&self, i: usize, c: usize) -> *const f32 {
        // SAFETY: the caller vouches for it.
        unsafe { self.as_view().address(i, c) }
    }

    /// A [`View`] with the same addresses, for methods that do not write.
    #[inline(always)]
    pub(super) fn as_view(&self) -> View {
        View {
            data: self.data.cast_mut(),
            element_stride: self.element_stride,
            component_stride: self.component_stride,
        }
    }

    /// [`View::column_stride`]
    pub(super) fn column_stride(&self) -> isize {
        self.as_view().column_stride()
    }

    /// Copies the `count` elements that begin at `first` to one column per component.
    pub(super) unsafe fn load(&self, first: usize, count: usize, room: &mut [&mut [f32]]) {
        // SAFETY: the caller of the batch vouches for all addresses; `check` has found that no offset overflows.
        unsafe {
            // Loops whose strides the compiler knows are faster.
            if let [x, y, z] = room
                && self.element_stride == 3 * NUMBER
                && self.component_stride == NUMBER
            {
                let data = self.address(first, 0).cast::<[f32; 3]>();
                // Equal lengths, which the compiler knows, avoid a check for each number.
                let (x, y, z) = (&mut x[..count], &mut y[..count], &mut z[..count]);
                for i in 0..count {
                    [x[i], y[i], z[i]] = data.add(i).read_unaligned();
                }
                return;
            }
            for (c, column) in room.iter_mut().enumerate() {
                let data = self.address(first, c);
                let numbers = &mut column[..count];
                match self.element_stride {
                    NUMBER => gather(data, NUMBER, numbers),
                    0 => numbers.fill(data.read_unaligned()),
                    stride => gather(data, stride, numbers),
                }
            }
        }
    }
}

/// Copies numbers that are `stride` bytes apart.
#[inline(always)]
unsafe fn gather(data: *const f32, stride: isize, numbers: &mut [f32]) {
    for (i, number) in numbers.iter_mut().enumerate() {
        // SAFETY: the caller vouches for these addresses.
        *number = unsafe { data.byte_offset(i as isize * stride).read_unaligned() };
    }
}

/// Copies numbers to addresses that are `stride` bytes apart.
#[inline(always)]
unsafe fn scatter<T: Copy>(data: *mut T, stride: isize, numbers: &[T]) {
    for (i, number) in numbers.iter().enumerate() {
        // SAFETY: the caller vouches for these addresses.
        unsafe {
            data.byte_offset(i as isize * stride)
                .write_unaligned(*number)
        }
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

    /// The address of component c of element i.
    #[inline(always)]
    pub(super) unsafe fn address(&self, i: usize, c: usize) -> *mut T {
        let offset = i as isize * self.element_stride + c as isize * self.component_stride;
        // SAFETY: the caller vouches for the address; `check` has found that the offset does not overflow.
        unsafe { self.data.byte_offset(offset) }
    }

    /// Whether the numbers of each component are aligned and contiguous, as in a slice, and the columns of
    /// different components do not overlap within a chunk.
    pub(super) fn is_contiguous(&self, components: usize) -> bool {
        let [number, between] = [size_of::<T>() as isize, self.component_stride];
        let is_apart =
            between % number == 0 && between.unsigned_abs() >= LEAST_DISTANCE * size_of::<T>();
        let is_aligned = !self.data.is_null() && self.data.is_aligned();
        self.element_stride == number && is_aligned && (components == 1 || is_apart)
    }

    /// For a contiguous view: the distance of the columns of successive components, in numbers.
    pub(super) fn column_stride(&self) -> isize {
        self.component_stride / size_of::<T>() as isize
    }

    /// The address range of `count` elements.
    pub(super) fn span(&self, components: usize, count: usize) -> Span {
        if self.data.is_null() || count == 0 {
            return None;
        }
        let reach = |steps: usize, stride: isize| {
            let farthest = (steps as isize).wrapping_mul(stride);
            [farthest.min(0), farthest.max(0)]
        };
        let [elements, components] = [
            reach(count - 1, self.element_stride),
            reach(components - 1, self.component_stride),
        ];
        let data = self.data.addr();
        let least = data.wrapping_add_signed(elements[0] + components[0]);
        let greatest = data.wrapping_add_signed(elements[1] + components[1]);
        Some([least, greatest.wrapping_add(size_of::<T>() - 1)])
    }

    /// The address range, and whether the elements can be written in place.
    pub(super) fn target(&self, components: usize, count: usize) -> (Span, bool) {
        (self.span(components, count), self.is_contiguous(components))
    }

    /// Writes elements, given as one column per component, from element `first` on.
    pub(super) unsafe fn store<const N: usize>(&self, first: usize, columns: [&[T]; N]) {
        let number = size_of::<T>() as isize;
        let count = columns[0].len();
        let columns = columns.map(|column| &column[..count]);
        // SAFETY: the caller of the batch vouches for all addresses; `check` has found that no offset overflows.
        unsafe {
            if N > 1
                && self.element_stride == N as isize * number
                && self.component_stride == number
            {
                let data = self.address(first, 0).cast::<[T; N]>();
                #[allow(clippy::needless_range_loop)] // of N arrays at once
                for i in 0..count {
                    let element: [T; N] = std::array::from_fn(|c| columns[c][i]);
                    data.add(i).write_unaligned(element);
                }
                return;
            }
            for (c, column) in columns.into_iter().enumerate() {
                let data = self.address(first, c);
                if self.element_stride == number {
                    scatter(data, number, column);
                } else {
                    scatter(data, self.element_stride, column);
                }
            }
        }
    }
}

/// Refuses views with an element whose offset overflows the address space.
#[inline]
pub(super) fn check_reach(
    name: &str,
    components: usize,
    count: usize,
    element_stride: isize,
    component_stride: isize,
) -> Result<(), Error> {
    // Offsets of 2^32 elements with strides of 2^30 bytes do not overflow.
    const NEAR: usize = 1 << 30;
    let strides = element_stride.unsigned_abs() | component_stride.unsigned_abs();
    if count <= u32::MAX as usize && strides < NEAR {
        return Ok(());
    }
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

/// Whether no output that can be written in place overlaps another view.
pub(super) fn is_apart(inputs: &[Span], outputs: &[(Span, bool)]) -> bool {
    let touch = |a: &Span, b: &Span| match (a, b) {
        (Some([a, b]), Some([c, d])) => a <= d && c <= b,
        _ => false,
    };
    outputs.iter().enumerate().all(|(i, (own, is_contiguous))| {
        let others = outputs.iter().enumerate().filter(|(j, _)| *j != i);
        let mut all = inputs.iter().chain(others.map(|(_, (span, _))| span));
        !is_contiguous || !all.any(|other| touch(own, other))
    })
}
