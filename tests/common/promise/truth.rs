//! The colours that films are compared with.

use super::points::Point;
use super::stack::Stack;
use pellicle::optics::stack::Side;
use pellicle::optics::{Converged, Reference, TOLERANCE};

/// Of a stack that is checked from both sides, every tenth point is.
pub const BOTH_SIDES_STRIDE: usize = 10;

/// The colours at one point, not clipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Truth {
    /// From the ambient's side.
    pub reflectance: [f64; 3],
    /// Where both sides are checked.
    pub sides: Option<Sides>,
}

/// What only films with transmittance have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    pub transmittance: [f64; 3],
    pub reflectance_from_base: [f64; 3],
    pub transmittance_from_base: [f64; 3],
}

/// Whether the point of that number is checked from both sides.
pub fn has_sides(stack: &Stack, point: usize) -> bool {
    stack.both_sides && point.is_multiple_of(BOTH_SIDES_STRIDE)
}

/// The converged colours at a point. Panics if they do not converge.
pub fn truth(stack: &Stack, reference: &Reference, point: Point, both_sides: bool) -> Truth {
    let from = |side| converged(stack, reference, point, side);
    let ambient = from(Side::Ambient);
    let sides = both_sides.then(|| {
        let base = from(Side::Base);
        Sides {
            transmittance: ambient.transmittance,
            reflectance_from_base: base.reflectance,
            transmittance_from_base: base.transmittance,
        }
    });
    Truth {
        reflectance: ambient.reflectance,
        sides,
    }
}

fn converged(stack: &Stack, reference: &Reference, point: Point, side: Side) -> Converged {
    let thicknesses = stack.thicknesses(point.thickness_nm);
    let found = reference.evaluate(side, point.cos_theta.into(), &thicknesses);
    assert!(found.change <= TOLERANCE, "{point:?} {side:?}: {found:?}");
    found
}
