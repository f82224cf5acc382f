//! Parameters that vary per call: reading their values and clamping them to their ranges.

use super::info::{ModelInfo, ParamKind};
use super::values::Values;
use crate::num::{Lane, Real, Vec3, each};

/// The greatest number of varying parameters of a BSDF. Their values fit on the stack.
pub(crate) const MAX_VARYING: usize = 16;

/// The most numbers that varying parameters have together.
pub(crate) const MAX_FLOATS: usize = 3 * MAX_VARYING;

/// A varying parameter and its declared range.
#[derive(Clone, Copy, Debug)]
pub struct VaryingRange {
    /// Index of the parameter.
    pub param: usize,
    /// Least value of each component; 0 for a direction.
    pub min: f32,
    /// Greatest value of each component; 0 for a direction.
    pub max: f32,
}

/// The place and the range of one varying parameter.
#[derive(Clone, Copy, Debug)]
pub struct VaryingSlot<T> {
    /// Index of the parameter.
    pub param: usize,
    /// The number of components: 1 or 3.
    pub components: usize,
    /// The number of its first component among the components of all varying parameters.
    first: usize,
    is_direction: bool,
    min: T,
    max: T,
}

/// The varying parameters of a BSDF, in the order of their declaration.
pub(super) struct VaryingParams<T> {
    slots: Box<[VaryingSlot<T>]>,
    defaults: Box<[T]>,
}

/// The values of the varying parameters, for one element or many. Without slots no value is given, and
/// every parameter has its default.
#[derive(Clone, Copy, Debug)]
pub struct VaryingValues<'a, T> {
    slots: &'a [VaryingSlot<T>],
    numbers: VaryingNumbers<'a, T>,
    /// The number of the element that loads count from.
    first: usize,
}

/// The components of all varying parameters, one parameter after another.
#[derive(Clone, Copy, Debug)]
pub enum VaryingNumbers<'a, T> {
    /// The components of one element.
    One(&'a [T]),
    /// The components of many elements, one column per component.
    Many(&'a [&'a [T]]),
}

impl<T: Lane<Scalar = T>> VaryingParams<T> {
    pub fn new(info: &ModelInfo, values: &Values<T>, ranges: &[VaryingRange]) -> Self {
        assert!(
            ranges.len() <= MAX_VARYING,
            "a model with more than {MAX_VARYING} parameters"
        );
        let mut first = 0;
        let slots = ranges.iter().map(|range| {
            let param = &info.params[range.param];
            let slot = VaryingSlot {
                param: range.param,
                components: param.components(),
                first,
                is_direction: matches!(param.kind, ParamKind::Direction { .. }),
                min: T::new(f64::from(range.min)),
                max: T::new(f64::from(range.max)),
            };
            first += slot.components;
            slot
        });
        let slots: Box<[VaryingSlot<T>]> = slots.collect();
        let defaults = slots
            .iter()
            .flat_map(|slot| values.rgb(slot.param).into_iter().take(slot.components))
            .collect();
        Self { slots, defaults }
    }

    /// The defaults of all components.
    pub fn defaults(&self) -> &[T] {
        &self.defaults
    }

    /// The values of a single call; `None` if their number is wrong.
    #[inline(always)]
    pub fn of_one<'a>(&'a self, numbers: Option<&'a [T]>) -> Option<VaryingValues<'a, T>> {
        let Some(numbers) = numbers else {
            return Some(VaryingValues::none());
        };
        (numbers.len() == self.defaults.len()).then_some(VaryingValues {
            slots: &self.slots,
            numbers: VaryingNumbers::One(numbers),
            first: 0,
        })
    }

    /// The values of many elements: one column per component, or no columns.
    pub fn of_many<'a>(&'a self, columns: &'a [&'a [T]]) -> VaryingValues<'a, T> {
        if columns.is_empty() {
            return VaryingValues::none();
        }
        assert_eq!(columns.len(), self.defaults.len());
        VaryingValues {
            slots: &self.slots,
            numbers: VaryingNumbers::Many(columns),
            first: 0,
        }
    }
}

impl<T: Lane<Scalar = T>> VaryingValues<'_, T> {
    /// No values, so that every parameter has its default.
    #[inline(always)]
    pub fn none() -> Self {
        Self {
            slots: &[],
            numbers: VaryingNumbers::One(&[]),
            first: 0,
        }
    }

    /// The values of one element.
    pub fn element(&self, element: usize) -> Self {
        Self {
            first: self.first + element,
            ..*self
        }
    }

    /// Whether no value is given.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.slots.is_empty()
    }

    /// Calls `vary` with the index and the value of each varying parameter, for the `L::COUNT` elements
    /// that begin at `from`. Numbers are clamped to the declared range, directions are normalised, and
    /// scalars are repeated in all three components. Returns a mask of the usable elements: those whose
    /// numbers are finite and whose directions have z > 0.
    #[inline(always)]
    pub fn clamp_inputs<L: Lane<Scalar = T>>(
        &self,
        from: usize,
        mut vary: impl FnMut(usize, [L; 3]),
    ) -> L::Mask {
        let mut is_usable = L::new(0.0).equals(L::new(0.0));
        for slot in self.slots {
            let value = self.numbers.load::<L>(slot, self.first + from);
            let [x, y, z] = value;
            is_usable = is_usable & x.is_finite() & y.is_finite() & z.is_finite();
            let value = if slot.is_direction {
                let (unit, is_upward) = Vec3::from_array(value).upward();
                is_usable = is_usable & is_upward;
                unit.to_array()
            } else {
                let [min, max] = [L::splat(slot.min), L::splat(slot.max)];
                each!(value, |number| number.max(min).min(max))
            };
            vary(slot.param, value);
        }
        is_usable
    }
}

impl<T: Lane<Scalar = T>> VaryingNumbers<'_, T> {
    #[inline(always)]
    fn load<L: Lane<Scalar = T>>(&self, slot: &VaryingSlot<T>, from: usize) -> [L; 3] {
        let number = |c: usize| {
            let k = slot.first + c.min(slot.components - 1);
            match self {
                Self::One(numbers) => L::load(&numbers[k..=k]),
                Self::Many(columns) => L::load(&columns[k][from..from + L::COUNT]),
            }
        };
        [number(0), number(1), number(2)]
    }
}

/// The unit vector along a vector with z > 0.
pub(super) fn upward<T: Real<Mask = bool>>(value: [T; 3]) -> Option<[T; 3]> {
    let (unit, is_upward) = Vec3::from_array(value).upward();
    is_upward.then(|| unit.to_array())
}
