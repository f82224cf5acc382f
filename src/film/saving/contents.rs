//! The parts of a saved film that are no tables: its description, its plan, and methods.

use crate::error::Error;
use crate::film::description::{BaseOpacity, FilmDescription, FilmLayer, MAX_LAYERS};
use crate::film::evaluator::MethodEvaluator;
use crate::film::method::compiled_method::Ingredients;
use crate::film::method::info::MethodInfo;
use crate::film::method::registry::{ALL, METHODS};
use crate::film::plan::film_plan::{FilmPlan, SidePlan};
use crate::num::bytes::{ByteReader, ByteWriter, unusable};
use crate::optics::{ColorSpace, Medium, White};

const OPACITIES: [BaseOpacity; 3] = [
    BaseOpacity::ByExtinction,
    BaseOpacity::Opaque,
    BaseOpacity::Transparent,
];
/// Bytes of a layer, at least.
const LAYER: usize = 1 + 1 + size_of::<[f64; 2]>();
/// Bytes of the longest reason of a plan.
const MOST_REASON: usize = 1 << 12;
/// The greatest size of a method for one layer.
const MOST_SIZE: usize = 1 << 10;

impl FilmDescription {
    /// Writes the description, which was checked.
    pub(super) fn save(&self, block: &mut ByteWriter) {
        let Self {
            ambient,
            layers,
            base,
            tolerance,
            white,
            color_space,
            method,
            unclipped,
            transmittance,
            base_opacity,
            extrapolate,
            thickness_spread_max_nm,
        } = self;
        ambient.save(block);
        base.save(block);
        block.count(layers.len());
        for FilmLayer {
            medium,
            thickness_nm,
        } in layers
        {
            medium.save(block);
            block.numbers(thickness_nm);
        }
        block.numbers(&[*tolerance]);
        block.byte(number_of(&White::NAMES, |(_, other)| other == white));
        block.byte(number_of(&ColorSpace::NAMES, |(_, other)| {
            other == color_space
        }));
        block.flag(method.is_some());
        if let Some(method) = method {
            block.byte(number_of(&METHODS, |name| name == method));
        }
        block.flag(*unclipped);
        block.flag(*transmittance);
        block.byte(number_of(&OPACITIES, |other| other == base_opacity));
        block.flag(*extrapolate);
        block.numbers(&[*thickness_spread_max_nm]);
    }

    /// Reads a description and checks it.
    pub(super) fn load(block: &mut ByteReader<'_>) -> Result<Self, Error> {
        let ambient = Medium::load(block)?;
        let base = Medium::load(block)?;
        let mut layers = Vec::new();
        for _ in 0..block.count(LAYER, MAX_LAYERS)? {
            layers.push(FilmLayer {
                medium: Medium::load(block)?,
                thickness_nm: block.numbers()?,
            });
        }
        let loaded = Self {
            ambient,
            layers,
            base,
            tolerance: block.numbers::<1>()?[0],
            white: block.choice(&White::NAMES)?.1,
            color_space: block.choice(&ColorSpace::NAMES)?.1,
            method: if block.flag()? {
                Some(block.choice(&METHODS)?.to_owned())
            } else {
                None
            },
            unclipped: block.flag()?,
            transmittance: block.flag()?,
            base_opacity: block.choice(&OPACITIES)?,
            extrapolate: block.flag()?,
            thickness_spread_max_nm: block.number()?,
        };
        loaded.check()?;
        Ok(loaded)
    }
}

impl FilmPlan {
    pub(super) fn save(&self, block: &mut ByteWriter) {
        let Self {
            method,
            tolerance,
            measured_max,
            measured_rms,
            bytes,
            reason,
            sides,
            eta: _,
        } = self;
        block.byte(number_of(&METHODS, |name| name == method));
        block.numbers(&[*tolerance, *measured_max, *measured_rms]);
        block.count(*bytes);
        block.count(reason.len());
        block.put(reason.as_bytes());
        for side in sides.iter().flatten() {
            let SidePlan {
                method,
                measured_max,
                measured_rms,
                cost_ns,
                absorbed_max,
            } = side;
            block.byte(number_of(&METHODS, |name| name == method));
            block.numbers(&[*measured_max, *measured_rms, *cost_ns, *absorbed_max]);
        }
    }

    /// Reads the plan of a film.
    pub(super) fn load(
        block: &mut ByteReader<'_>,
        description: &FilmDescription,
    ) -> Result<Self, Error> {
        let positive = [0.0, f64::MAX];
        Ok(Self {
            method: block.choice(&METHODS)?,
            tolerance: block.number_within("the tolerance", positive)?,
            measured_max: block.number_within("the greatest error", positive)?,
            measured_rms: block.number_within("the root of the mean square of errors", positive)?,
            bytes: block.count(0, isize::MAX as usize)?,
            reason: {
                let length = block.count(1, MOST_REASON)?;
                let text = str::from_utf8(block.take(length)?).ok();
                // C callers are given the text.
                let text = text.filter(|text| !text.contains('\0'));
                text.ok_or_else(|| unusable("its plan's reason is no text"))?
                    .to_owned()
            },
            sides: {
                let mut sides = [None; 2];
                for side in description.sides() {
                    sides[*side as usize] = Some(SidePlan {
                        method: block.choice(&METHODS)?,
                        measured_max: block.number_within("a side's greatest error", positive)?,
                        measured_rms: block.number_within("a side's errors", positive)?,
                        cost_ns: block.number_within("the time of a call", positive)?,
                        absorbed_max: block.number_within("what is absorbed", [0.0, 1.0])?,
                    });
                }
                sides
            },
            eta: Self::eta_of(description),
        })
    }
}

pub(super) fn save_ingredients(ingredients: &Ingredients, block: &mut ByteWriter) {
    let Ingredients { size, normal } = ingredients;
    block.count(*size);
    block.color(*normal);
}

/// Reads what the method of that name is made from, and makes it for a film.
pub(super) fn load_method(
    name: &str,
    block: &mut ByteReader<'_>,
    description: &FilmDescription,
) -> Result<MethodEvaluator, Error> {
    let ingredients = Ingredients {
        size: block.count(0, MOST_SIZE)?,
        normal: block.color()?,
    };
    let takes = |method: &&&MethodInfo| method.name == name && (method.takes)(description);
    let method = ALL.iter().find(takes);
    let made = method.map(|method| method.made_from(description, ingredients));
    let (made, _) = made
        .transpose()?
        .flatten()
        .ok_or_else(|| unusable("its method does not take its film"))?;
    Ok(made)
}

/// The number of the element of a list, of at most 256, that is sought.
fn number_of<T>(list: &[T], is_sought: impl Fn(&T) -> bool) -> u8 {
    list.iter().position(is_sought).unwrap_or_default() as u8
}
