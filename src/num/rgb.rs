//! Three colour channels as three numbers.

use super::{Mask, Real};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Applies an expression to each of three values. Code for lanes must be inlined into a function that is
/// compiled for their instructions; a closure passed to `map` of an array is not.
macro_rules! each {
    ($values:expr, |$value:pat_param| $body:expr) => {{
        let [a, b, c] = $values;
        [
            {
                let $value = a;
                $body
            },
            {
                let $value = b;
                $body
            },
            {
                let $value = c;
                $body
            },
        ]
    }};
}
pub(crate) use each;

/// Three numbers or three truth values, one per colour channel.
#[derive(Clone, Copy, Debug)]
pub struct Triple<T>(pub [T; 3]);

/// Applies `$f` to each channel of one or two triples. It is a macro because a function passed as an
/// argument is not inlined, as code for lanes must be.
macro_rules! per_channel {
    ($f:expr, $a:expr) => {
        Triple([$f($a.0[0]), $f($a.0[1]), $f($a.0[2])])
    };
    ($f:expr, $a:expr, $b:expr) => {
        Triple([
            $f($a.0[0], $b.0[0]),
            $f($a.0[1], $b.0[1]),
            $f($a.0[2], $b.0[2]),
        ])
    };
}

macro_rules! channelwise_operator {
    ($trait:ident, $method:ident) => {
        impl<T: $trait<Output = T> + Copy> $trait for Triple<T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                per_channel!(T::$method, self, other)
            }
        }
    };
}

channelwise_operator!(Add, add);
channelwise_operator!(Sub, sub);
channelwise_operator!(Mul, mul);
channelwise_operator!(Div, div);
channelwise_operator!(BitAnd, bitand);
channelwise_operator!(BitOr, bitor);

impl<T: Neg<Output = T> + Copy> Neg for Triple<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        per_channel!(T::neg, self)
    }
}

impl<T: Not<Output = T> + Copy> Not for Triple<T> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        per_channel!(T::not, self)
    }
}

impl<M: Mask> Mask for Triple<M> {
    #[inline(always)]
    fn any(self) -> bool {
        self.0[0].any() | self.0[1].any() | self.0[2].any()
    }
}

macro_rules! channelwise {
    ($($method:ident),*) => {
        $(
            #[inline(always)]
            fn $method(self) -> Self {
                per_channel!(T::$method, self)
            }
        )*
    };
}

impl<T: Real> Real for Triple<T> {
    type Mask = Triple<T::Mask>;
    const EPSILON: f64 = T::EPSILON;

    #[inline(always)]
    fn new(value: f64) -> Self {
        Self([T::new(value); 3])
    }
    channelwise!(
        sqrt,
        abs,
        round,
        power_of_two,
        exp,
        exp_m1,
        ln,
        ln_1p,
        cos_turns,
        sin_turns
    );
    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let [(a, d), (b, e), (c, f)] = each!(self.0, |channel| channel.split());
        (Self([a, b, c]), Self([d, e, f]))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        per_channel!(T::min, self, other)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        per_channel!(T::max, self, other)
    }
    #[inline(always)]
    fn is_finite(self) -> Self::Mask {
        per_channel!(T::is_finite, self)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        per_channel!(T::lt, self, other)
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        per_channel!(T::le, self, other)
    }
    #[inline(always)]
    fn equals(self, other: Self) -> Self::Mask {
        per_channel!(T::equals, self, other)
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        let (Self(yes), Self(no)) = (yes, no);
        Self(each!([0, 1, 2], |c| T::select(mask.0[c], yes[c], no[c])))
    }
}
