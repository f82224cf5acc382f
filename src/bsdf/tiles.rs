//! Many calls at once, in single precision: what a batch is made of.

use super::{Bsdf, MAX_VARYING};
use crate::bsdf::{EvalTile, MAX_LOBES, SampleTile, Varied, Vectors, VectorsMut};
use crate::num::Level;
use glam::Vec3;

/// What is given for a tile of elements: slices of equal length, a multiple of [`crate::bsdf::LANES`].
#[derive(Clone, Copy)]
pub(crate) struct Given<'a> {
    pub wo: Vectors<'a>,
    /// wi, or the uniform numbers.
    pub other: Vectors<'a>,
    /// One slice per number that varies, or none at all.
    pub varying: &'a [&'a [f32]],
}

/// What [`Bsdf::sample_tile`] finds, in slices as long as the given ones: the fields of
/// [`Sample`](super::Sample).
pub(crate) struct Found<'a> {
    pub wi: VectorsMut<'a>,
    pub pdf: &'a mut [f32],
    pub weight: VectorsMut<'a>,
    pub eta: &'a mut [f32],
    pub flags: &'a mut [u32],
    pub lobe: &'a mut [u32],
}

impl Bsdf<f32> {
    /// [`Bsdf::eval`], or [`Bsdf::eval_pdf`] if `pdf` is wanted, for every element: equal bit for bit.
    pub(crate) fn eval_tile(
        &self,
        level: Level,
        given: Given,
        value: VectorsMut,
        pdf: Option<&mut [f32]>,
    ) {
        let Some(tiles) = self.kernel.tiles() else {
            // No lobe has a density.
            value
                .into_iter()
                .chain(pdf)
                .for_each(|numbers| numbers.fill(0.0));
            return;
        };
        let mut all = [Varied::NONE; MAX_VARYING];
        let tile = EvalTile {
            wo: given.wo,
            wi: given.other,
            varied: self.varying.of_tile(given.varying, &mut all),
            value,
            pdf,
        };
        tiles.eval(level, tile);
    }

    /// [`Bsdf::sample`] for every element: equal bit for bit.
    pub(crate) fn sample_tile(&self, level: Level, given: Given, found: Found) {
        let Some(tiles) = self.kernel.tiles() else {
            self.sample_one_by_one(given, found);
            return;
        };
        let mut all = [Varied::NONE; MAX_VARYING];
        let tile = SampleTile {
            wo: given.wo,
            u: given.other,
            varied: self.varying.of_tile(given.varying, &mut all),
            wi: found.wi,
            pdf: &mut *found.pdf,
            weight: found.weight,
            lobe: &mut *found.eta,
        };
        tiles.sample(level, tile);
        let mut flags_of = [0; MAX_LOBES];
        for (flags, lobe) in flags_of.iter_mut().zip(self.lobes) {
            *flags = lobe.flags.0;
        }
        let integers = found.flags.iter_mut().zip(found.lobe);
        for ((pdf, eta), (flags, lobe)) in found.pdf.iter().zip(found.eta).zip(integers) {
            let is_found = *pdf > 0.0;
            *lobe = *eta as u32;
            *flags = if is_found {
                flags_of[*lobe as usize]
            } else {
                0
            };
            *eta = if is_found { 1.0 } else { 0.0 };
        }
    }

    /// For kernels that do not take tiles.
    fn sample_one_by_one(&self, given: Given, found: Found) {
        let mut numbers = [0.0; 3 * MAX_VARYING];
        for i in 0..given.wo[0].len() {
            for (number, given) in numbers.iter_mut().zip(given.varying) {
                *number = given[i];
            }
            let numbers = &numbers[..given.varying.len()];
            let varying = (!numbers.is_empty()).then_some(numbers);
            let sample = self.sample(vector(given.wo, i), vector(given.other, i), varying);
            for c in 0..3 {
                found.wi[c][i] = sample.wi[c];
                found.weight[c][i] = sample.weight[c];
            }
            found.pdf[i] = sample.pdf;
            found.eta[i] = sample.eta;
            found.flags[i] = sample.flags.0;
            found.lobe[i] = sample.lobe as u32;
        }
    }
}

fn vector([x, y, z]: Vectors, i: usize) -> Vec3 {
    Vec3::new(x[i], y[i], z[i])
}
