//! BSDFs, and arrays of what they are called with, for the tests of views.

#![allow(unsafe_code)] // batches go by addresses

use crate::common::calls::Calls;
use crate::common::films::Kind;
use crate::common::{hemisphere, rng, uniforms};
use crate::strided::{Array, Layout};
use glam::Vec3;
use pellicle::batch::{ConstView, EvalArgs, SampleArgs, View};
use pellicle::bsdf::{ParamKind, Varying};
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

/// BSDFs in which nothing varies, a colour, several parameters; and one that batches call element by element.
pub fn subjects() -> [Bsdf; 4] {
    let lambert = Description::new("lambert").vary("reflectance", 0.0, 1.0);
    let microfacet = Description::new("microfacet").choose("distribution", "ggx");
    let layered = Description::new("layered")
        .vary("thickness_nm", 0.0, 800.0)
        .vary("base_normal", 0.0, 0.0)
        .vary("base", 0.0, 1.0);
    let film = Description::new("film")
        .film(Kind::Lens.film())
        .vary("thickness_nm", 0.0, 600.0);
    [microfacet, lambert, layered, film].map(|description| Bsdf::new(&description).unwrap())
}

/// The arrays that a batch reads.
pub struct Inputs {
    count: usize,
    pub wo: Array,
    pub wi: Array,
    pub u: Array,
    pub varying: Vec<Array>,
}

impl Inputs {
    pub fn new(bsdf: &Bsdf, count: usize, layout: Layout) -> Self {
        let rng = &mut rng(count as u64);
        let [mut wo, mut wi, mut u] = [(); 3].map(|()| Array::new(layout, count, 3));
        let params: Vec<_> = bsdf.varying().collect();
        let array = |param: &Varying| Array::new(layout, count, param.param.components());
        let mut varying: Vec<Array> = params.iter().map(array).collect();
        for i in 0..count {
            wo.set(i, &hemisphere(rng).as_vec3().to_array());
            wi.set(i, &hemisphere(rng).as_vec3().to_array());
            u.set(i, &uniforms(rng));
            for (array, param) in varying.iter_mut().zip(&params) {
                let numbers: Vec<f32> = match param.param.kind {
                    ParamKind::Direction { .. } => hemisphere(rng).as_vec3().to_array().to_vec(),
                    _ => {
                        let number =
                            |_: &f32| param.min + (param.max - param.min) * rng.random::<f32>();
                        param.defaults.iter().map(number).collect()
                    }
                };
                array.set(i, &numbers);
            }
        }
        Self {
            count,
            wo,
            wi,
            u,
            varying,
        }
    }

    /// A batch of values over these arrays, into views.
    pub fn eval_args<'a>(
        &self,
        varying: &'a [ConstView],
        value: View,
        [pdf, pdf_reverse]: [View; 2],
    ) -> EvalArgs<'a> {
        EvalArgs {
            count: self.count,
            call: Call::default(),
            wo: self.wo.const_view(),
            wi: self.wi.const_view(),
            varying,
            value,
            pdf,
            pdf_reverse,
        }
    }

    /// A batch of samples over these arrays: directions and lobes into views, nothing else.
    pub fn sample_args<'a>(
        &self,
        varying: &'a [ConstView],
        wi: View,
        lobe: View<u32>,
    ) -> SampleArgs<'a> {
        SampleArgs {
            count: self.count,
            call: Call::default(),
            wo: self.wo.const_view(),
            u: self.u.const_view(),
            varying,
            wi,
            pdf: NOT_WANTED,
            weight: NOT_WANTED,
            eta: NOT_WANTED,
            flags: View {
                data: std::ptr::null_mut(),
                element_stride: 0,
                component_stride: 0,
            },
            lobe,
            lobe_probability: NOT_WANTED,
        }
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

    pub fn evaluated(&self, bsdf: &Bsdf) -> Vec<Evaluation> {
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
        (0..self.count).map(single).collect()
    }

    pub fn sampled(&self, bsdf: &Bsdf) -> Vec<Sample> {
        let single = |i| {
            let [wo, u] = [&self.wo, &self.u].map(|array| Vec3::from(array.get(i)));
            let varying = self.numbers(i);
            bsdf.sampled(wo, u, (!varying.is_empty()).then_some(&varying))
        };
        (0..self.count).map(single).collect()
    }
}
