//! Parameters given per call: from a flat list of numbers to overrides, clamped and checked.

use super::Scalar;
use crate::bsdf::{ModelInfo, Override, ParamKind, Values, Varied};
use crate::num::{Real, Vec3};

/// More than any model's parameters; so that what varies fits on the stack.
pub(crate) const MAX_VARYING: usize = 16;

/// How to read one varying parameter.
struct Slot<T> {
    param: usize,
    components: usize,
    is_direction: bool,
    min: T,
    max: T,
}

/// The varying parameters of a BSDF, in declared order.
pub(super) struct Varying<T> {
    slots: Box<[Slot<T>]>,
    defaults: Box<[T]>,
}

/// A declared range: parameter index, least and greatest value of each component.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub param: usize,
    pub min: f32,
    pub max: f32,
}

impl<T: Scalar> Varying<T> {
    pub fn new(info: &ModelInfo, values: &Values<T>, ranges: &[Range]) -> Self {
        assert!(
            ranges.len() <= MAX_VARYING,
            "a model with more than {MAX_VARYING} parameters"
        );
        let slots = ranges.iter().map(|range| Slot {
            param: range.param,
            components: info.params[range.param].components(),
            is_direction: matches!(info.params[range.param].kind, ParamKind::Direction { .. }),
            min: T::new(f64::from(range.min)),
            max: T::new(f64::from(range.max)),
        });
        let slots: Box<[Slot<T>]> = slots.collect();
        let defaults = slots
            .iter()
            .flat_map(|slot| values.rgb(slot.param).into_iter().take(slot.components))
            .collect();
        Self { slots, defaults }
    }

    pub fn count(&self) -> usize {
        self.slots.len()
    }

    pub fn floats(&self) -> usize {
        self.defaults.len()
    }

    pub fn defaults(&self) -> &[T] {
        &self.defaults
    }

    pub fn components(&self) -> impl Iterator<Item = usize> + '_ {
        self.slots.iter().map(|slot| slot.components)
    }

    /// Calls `f` with the overrides that `varying` stands for; `None` if a value is unusable.
    #[inline(always)]
    pub fn with<R>(&self, varying: Option<&[T]>, f: impl FnOnce(&[Override<T>]) -> R) -> Option<R> {
        let Some(mut rest) = varying.filter(|_| !self.slots.is_empty()) else {
            return Some(f(&[]));
        };
        let unset = Override {
            param: 0,
            value: [T::new(0.0); 3],
        };
        let mut overrides = [unset; MAX_VARYING];
        for (slot, target) in self.slots.iter().zip(&mut overrides) {
            let (numbers, after) = rest.split_at_checked(slot.components)?;
            *target = Override {
                param: slot.param,
                value: slot.read(numbers)?,
            };
            rest = after;
        }
        rest.is_empty().then(|| f(&overrides[..self.slots.len()]))
    }
}

impl<T: Scalar> Slot<T> {
    /// Clamps numbers to the declared range, normalises directions; `None` where that is impossible.
    #[inline(always)]
    fn read(&self, numbers: &[T]) -> Option<[T; 3]> {
        let mut value = [numbers[0]; 3];
        value[..numbers.len()].copy_from_slice(numbers);
        if !value.into_iter().all(Real::is_finite) {
            return None;
        }
        if self.is_direction {
            return upward(value);
        }
        Some(value.map(|number| Real::min(Real::max(number, self.min), self.max)))
    }
}

impl Varying<f32> {
    /// The parameters of a tile: `all`, filled as far as needed. Of a scalar the one slice stands for all
    /// components.
    pub fn of_tile<'a, 'b>(
        &self,
        varying: &[&'a [f32]],
        all: &'b mut [Varied<'a>; MAX_VARYING],
    ) -> &'b [Varied<'a>] {
        let mut rest = varying;
        let mut count = 0;
        for (slot, varied) in self.slots.iter().zip(all.iter_mut()) {
            let Some((numbers, after)) = rest.split_at_checked(slot.components) else {
                break;
            };
            let last = slot.components - 1;
            *varied = Varied {
                param: slot.param,
                value: [0, 1, 2].map(|c| numbers[last.min(c)]),
                range: [slot.min, slot.max],
                is_direction: slot.is_direction,
            };
            rest = after;
            count += 1;
        }
        &all[..count]
    }
}

/// A vector of any length with z > 0, normalised.
pub(super) fn upward<T: Scalar>(value: [T; 3]) -> Option<[T; 3]> {
    let (unit, is_upward) = Vec3::from_array(value).upward();
    is_upward.then(|| unit.to_array())
}
