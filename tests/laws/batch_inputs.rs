//! BSDFs, and arrays of what they are called with, for the tests of views.

#![allow(unsafe_code)] // batches go by addresses

use crate::common::calls::Calls;
use crate::common::films::Kind;
use crate::common::{hemisphere, rng, uniforms};
use crate::strided::{Array, Layout};
use glam::Vec3;
use pellicle::batch::{ConstView, View};
use pellicle::{Bsdf, Call, Description, Evaluation, Sample};
use rand::RngExt;

/// No element, too few for lanes, about multiples of 16 lanes, a chunk of 256, and more than a chunk.
pub const COUNTS: [usize; 9] = [0, 1, 4, 7, 63, 64, 65, 256, 277];

pub fn bits<const N: usize>(numbers: [f32; N]) -> [u32; N] {
    numbers.map(f32::to_bits)
}

pub const NOT_WANTED: View = View {
    data: std::ptr::null_mut(),
    element_stride: 0,
    component_stride: 0,
};

/// A BSDF, and the range of each parameter that varies; a direction has none.
pub struct Subject {
    pub bsdf: Bsdf,
    pub ranges: Vec<Option<[f32; 2]>>,
}

/// BSDFs in which nothing varies, a colour, several parameters; and one that batches call element by element.
pub fn subjects() -> Vec<Subject> {
    let lambert = Description::new("lambert").vary("reflectance", 0.0, 1.0);
    let microfacet = Description::new("microfacet").choose("distribution", "ggx");
    let layered = Description::new("layered")
        .vary("thickness_nm", 0.0, 800.0)
        .vary("base_normal", 0.0, 0.0)
        .vary("base", 0.0, 1.0);
    let film = Description::new("film")
        .film(Kind::Lens.film())
        .vary("thickness_nm", 0.0, 600.0);
    let new = |description: &Description, ranges: &[Option<[f32; 2]>]| Subject {
        bsdf: Bsdf::new(description).unwrap(),
        ranges: ranges.to_vec(),
    };
    let unit = Some([0.0, 1.0]);
    vec![
        new(&microfacet, &[]),
        new(&lambert, &[unit]),
        new(&layered, &[Some([0.0, 800.0]), None, unit]),
        new(&film, &[Some([0.0, 600.0])]),
    ]
}

/// The arrays that a batch reads.
pub struct Inputs {
    pub wo: Array,
    pub wi: Array,
    pub u: Array,
    pub varying: Vec<Array>,
}

impl Inputs {
    pub fn new(subject: &Subject, count: usize, layout: Layout) -> Self {
        let rng = &mut rng(count as u64);
        let [mut wo, mut wi, mut u] = [(); 3].map(|()| Array::new(layout, count, 3));
        let components = subject
            .bsdf
            .varying()
            .map(|varying| varying.param.components());
        let mut varying: Vec<Array> = components.map(|c| Array::new(layout, count, c)).collect();
        for i in 0..count {
            wo.set(i, &hemisphere(rng).as_vec3().to_array());
            wi.set(i, &hemisphere(rng).as_vec3().to_array());
            u.set(i, &uniforms(rng));
            for (array, range) in varying.iter_mut().zip(&subject.ranges) {
                let numbers: Vec<f32> = match range {
                    Some([min, max]) => {
                        let number = |_| min + (max - min) * rng.random::<f32>();
                        (0..array.numbers(i).len()).map(number).collect()
                    }
                    None => hemisphere(rng).as_vec3().to_array().to_vec(),
                };
                array.set(i, &numbers);
            }
        }
        Self { wo, wi, u, varying }
    }

    pub fn views(&self) -> Vec<ConstView> {
        self.varying.iter().map(Array::const_view).collect()
    }

    pub fn numbers(&self, i: usize) -> Vec<f32> {
        self.varying
            .iter()
            .flat_map(|array| array.numbers(i))
            .collect()
    }

    pub fn evaluated(&self, bsdf: &Bsdf, count: usize) -> Vec<Evaluation> {
        let single = |i| {
            let [wo, wi] = [&self.wo, &self.wi].map(|array| Vec3::from(array.get(i)));
            let varying = self.numbers(i);
            bsdf.evaluate(
                wo,
                wi,
                (!varying.is_empty()).then_some(&varying),
                &Call::default(),
            )
        };
        (0..count).map(single).collect()
    }

    pub fn sampled(&self, bsdf: &Bsdf, count: usize) -> Vec<Sample> {
        let single = |i| {
            let [wo, u] = [&self.wo, &self.u].map(|array| Vec3::from(array.get(i)));
            let varying = self.numbers(i);
            bsdf.sampled(wo, u, (!varying.is_empty()).then_some(&varying))
        };
        (0..count).map(single).collect()
    }
}
