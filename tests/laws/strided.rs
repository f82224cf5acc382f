//! Arrays in memory as batches address them, and what was written beside their elements.

#![allow(dead_code)] // each test program uses a part

use pellicle::batch::{ConstView, View};

/// Where component c of element i is: `begin + i * element + c * component`, all in bytes.
#[derive(Clone, Copy)]
pub struct Place {
    pub bytes: usize,
    pub begin: usize,
    pub element: isize,
    pub component: isize,
}

/// A name, and where elements lie, from the numbers of elements and of components.
pub type Layout = (&'static str, fn(isize, isize) -> Place);

const WORD: isize = 4;
const KIB: isize = 1024;

/// The arguments are the size of the array in bytes, the offset of its first element and the strides. Sizes and
/// offsets that an empty array makes negative become 0.
fn place(bytes: isize, begin: isize, element: isize, component: isize) -> Place {
    Place {
        bytes: bytes.max(0) as usize,
        begin: begin.max(0) as usize,
        element,
        component,
    }
}

/// Elements side by side, components side by side, both backwards, far apart, at every alignment.
pub const LAYOUTS: [Layout; 13] = [
    ("elements", |n, c| place(n * c * WORD, 0, c * WORD, WORD)),
    ("planes", |n, c| place(n * c * WORD, 0, WORD, n * WORD)),
    ("elements backwards", |n, c| {
        place(n * c * WORD, (n - 1) * c * WORD, -c * WORD, WORD)
    }),
    ("components backwards", |n, c| {
        place(n * c * WORD, (c - 1) * WORD, c * WORD, -WORD)
    }),
    ("planes backwards", |n, c| {
        place(n * c * WORD, (n - 1) * WORD, -WORD, n * WORD)
    }),
    ("all backwards", |n, c| {
        place(n * c * WORD, (n * c - 1) * WORD, -c * WORD, -WORD)
    }),
    ("planes in reverse order", |n, c| {
        place(n * c * WORD, (c - 1) * n * WORD, WORD, -n * WORD)
    }),
    ("5 KiB apart", |n, c| {
        place(n * (5 * KIB + c * WORD), 8, 5 * KIB, WORD)
    }),
    ("1 MiB apart, backwards", |n, c| {
        place(
            n * KIB * KIB + c * WORD,
            (n - 1) * KIB * KIB,
            -KIB * KIB,
            WORD,
        )
    }),
    ("planes 1 MiB apart", |n, c| {
        place((c - 1) * KIB * KIB + n * WORD, 0, WORD, KIB * KIB)
    }),
    ("one byte off", |n, c| {
        place(n * (c * WORD + 1) + 1, 1, c * WORD + 1, WORD)
    }),
    ("planes two bytes off", |n, c| {
        place(n * c * WORD + 2, 2, WORD, n * WORD)
    }),
    ("planes three bytes off and odd", |n, c| {
        place(c * (n * WORD + 1) + 3, 3, WORD, n * WORD + 1)
    }),
];

/// One element that stands for all, for inputs.
pub const BROADCAST: Layout = ("one for all", |_, c| place(c * WORD, 0, 0, WORD));

/// An array; its bytes are 0 where nothing is written.
pub struct Array {
    place: Place,
    count: usize,
    components: usize,
    bytes: Vec<u8>,
}

impl Array {
    pub fn new(layout: Layout, count: usize, components: usize) -> Self {
        let place = layout.1(count as isize, components as isize);
        Self {
            place,
            count,
            components,
            bytes: vec![0; place.bytes],
        }
    }

    fn offset(&self, i: usize, c: usize) -> usize {
        let Place {
            begin,
            element,
            component,
            ..
        } = self.place;
        begin.wrapping_add_signed(i as isize * element + c as isize * component)
    }

    pub fn set(&mut self, i: usize, numbers: &[f32]) {
        for (c, number) in numbers.iter().enumerate() {
            let at = self.offset(i, c);
            self.bytes[at..at + 4].copy_from_slice(&number.to_ne_bytes());
        }
    }

    /// The bits of a component.
    pub fn bits(&self, i: usize, c: usize) -> u32 {
        let at = self.offset(i, c);
        u32::from_ne_bytes(self.bytes[at..at + 4].try_into().unwrap())
    }

    pub fn get<const N: usize>(&self, i: usize) -> [f32; N] {
        std::array::from_fn(|c| f32::from_bits(self.bits(i, c)))
    }

    pub fn numbers(&self, i: usize) -> Vec<f32> {
        let number = |c| f32::from_bits(self.bits(i, c));
        (0..self.components).map(number).collect()
    }

    pub fn const_view(&self) -> ConstView {
        ConstView {
            data: self.bytes.as_ptr().wrapping_add(self.place.begin).cast(),
            element_stride: self.place.element,
            component_stride: self.place.component,
        }
    }

    pub fn view<T>(&mut self) -> View<T> {
        View {
            data: self
                .bytes
                .as_mut_ptr()
                .wrapping_add(self.place.begin)
                .cast(),
            element_stride: self.place.element,
            component_stride: self.place.component,
        }
    }

    /// Whether all bytes that belong to no element are 0: in an array too large for that, those next to
    /// each number.
    pub fn rest_is_untouched(&self) -> bool {
        const LARGE: usize = 1 << 20;
        const BESIDE: usize = 64;
        let mut named = std::collections::HashSet::new();
        for i in 0..self.count {
            for c in 0..self.components {
                let at = self.offset(i, c);
                named.extend(at..at + 4);
            }
        }
        let is_clean = |byte: usize| self.bytes[byte] == 0 || named.contains(&byte);
        if self.bytes.len() <= LARGE {
            return (0..self.bytes.len()).all(is_clean);
        }
        let beside = |at: &usize| at.saturating_sub(BESIDE)..(at + BESIDE).min(self.bytes.len());
        let starts = (0..self.count).map(|i| self.offset(i, 0));
        starts.into_iter().all(|at| beside(&at).all(is_clean))
    }
}
