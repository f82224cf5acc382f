//! Compiled films as blocks of memory, and back. What is fitted or takes long is stored; the reference, the weights of
//! the channels and all that follows from the description is made anew.
//!
//! A block is little-endian. It begins with [a header](block), which says to which build of the library it
//! belongs: another build may evaluate the same numbers to other bits. So the layout of what follows may change with
//! any change of the sources.

mod block;
mod contents;

use super::description::FilmDescription;
use super::evaluator::Evaluator;
use super::film::Film;
use super::fringe_series::series::FringeSeries;
use super::plan::film_plan::FilmPlan;
use super::table::two_sided::TwoSidedTables;
use crate::error::Error;
use crate::num::bytes::{ByteReader, ByteWriter, unusable};
#[doc(hidden)]
pub use block::resealed;
use contents::{load_method, save_ingredients};

impl Film {
    /// The compiled film as a block of bytes, for [`Film::from_bytes`] of the same build of the library.
    ///
    /// # Errors
    /// `OutOfMemory`.
    pub fn to_bytes(&self) -> Result<Vec<u8>, Error> {
        let mut payload = ByteWriter::default();
        block::begin(&mut payload);
        self.description().save(&mut payload);
        payload.numbers(&self.base_attenuation_per_mm());
        self.plan().save(&mut payload);
        match &self.evaluator {
            Evaluator::Tables(tables) => tables.save(&mut payload),
            Evaluator::Method(method) => save_ingredients(&method.ingredients, &mut payload),
            Evaluator::Series(series) => series.save(&mut payload),
            Evaluator::Reference => {}
        }
        let mut bytes = payload.finish()?;
        block::seal(&mut bytes);
        Ok(bytes)
    }

    /// The film that was saved: it gives the same bits in every call. Nothing is fitted and nothing measured.
    ///
    /// # Errors
    /// `InvalidArgument` for bytes that are no saved film, cut short, too long or damaged; `Unsupported` for those of
    /// another format or another build of the library; `OutOfMemory`.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let mut payload = ByteReader(block::opened(bytes)?);
        let description = FilmDescription::load(&mut payload)?;
        let mut attenuation_per_mm = [0.0; 3];
        for channel in &mut attenuation_per_mm {
            *channel = payload.number_within("the attenuation of the base", [0.0, f64::MAX])?;
        }
        let plan = FilmPlan::load(&mut payload, &description)?;
        let evaluator = match plan.method {
            "table" => Evaluator::Tables(TwoSidedTables::load(&mut payload, &description)?),
            "series" => Evaluator::Series(FringeSeries::load(&mut payload, &description)?),
            "reference" => Evaluator::Reference,
            name => Evaluator::Method(load_method(name, &mut payload, &description)?),
        };
        if !payload.0.is_empty() {
            return Err(unusable("its contents end early"));
        }
        let reference = Self::reference_of(&description)?;
        Ok(Self::of_parts(
            description,
            reference,
            attenuation_per_mm,
            evaluator,
            plan,
        ))
    }
}
