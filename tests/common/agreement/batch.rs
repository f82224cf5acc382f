//! Batch calls on arrays.

#![allow(unsafe_code)] // batches go by addresses

use glam::Vec3;
use pellicle::batch::{
    ConstView, EvalArgs, FilmArgs, SampleArgs, View, eval, film_reflectance, sample,
};
use pellicle::bsdf::Flags;
use pellicle::film::Film;
use pellicle::num::Level;
use pellicle::{Bsdf, Sample};

/// Components one after another.
struct Planes<T> {
    numbers: Vec<T>,
    count: usize,
}

impl<T: Copy + Default> Planes<T> {
    fn zero(components: usize, count: usize) -> Self {
        let numbers = vec![T::default(); components * count];
        Self { numbers, count }
    }

    fn view(&mut self) -> View<T> {
        View {
            data: self.numbers.as_mut_ptr(),
            element_stride: size_of::<T>() as isize,
            component_stride: (size_of::<T>() * self.count) as isize,
        }
    }

    fn get<const N: usize>(&self, i: usize) -> [T; N] {
        std::array::from_fn(|c| self.numbers[c * self.count + i])
    }
}

/// Elements of so many floats, side by side.
fn view(numbers: &[f32], floats: usize) -> ConstView {
    ConstView {
        data: numbers.as_ptr(),
        element_stride: (size_of::<f32>() * floats) as isize,
        component_stride: size_of::<f32>() as isize,
    }
}

fn vectors(vectors: &[Vec3]) -> Vec<f32> {
    vectors.iter().flat_map(Vec3::to_array).collect()
}

/// A batch's varying numbers: `floats` for each element, and how many each parameter has.
pub struct Varying<'a> {
    pub numbers: &'a [f32],
    pub floats: usize,
    pub components: Vec<usize>,
}

impl<'a> Varying<'a> {
    fn views(&self) -> Vec<ConstView> {
        let mut first = 0;
        let view = |components: &usize| {
            let view = view(&self.numbers[first..], self.floats);
            first += components;
            view
        };
        self.components.iter().map(view).collect()
    }

    /// Those of one element.
    pub fn of(&self, i: usize) -> Option<&'a [f32]> {
        let own = i * self.floats..(i + 1) * self.floats;
        (self.floats > 0).then(|| &self.numbers[own])
    }
}

/// Value and density.
pub type Evaluated = ([f32; 3], f32);

pub fn evaluated(
    bsdf: &Bsdf,
    level: Level,
    wo: &[Vec3],
    wi: &[Vec3],
    varying: &Varying,
) -> Vec<Evaluated> {
    let count = wo.len();
    let (wo, wi) = (vectors(wo), vectors(wi));
    let (mut value, mut pdf) = (Planes::zero(3, count), Planes::zero(1, count));
    let args = EvalArgs {
        count,
        wo: view(&wo, 3),
        wi: view(&wi, 3),
        varying: &varying.views(),
        value: value.view(),
        pdf: pdf.view(),
    };
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { eval(bsdf, &args, level) }.unwrap();
    (0..count).map(|i| (value.get(i), pdf.numbers[i])).collect()
}

pub fn sampled(
    bsdf: &Bsdf,
    level: Level,
    wo: &[Vec3],
    u: &[Vec3],
    varying: &Varying,
) -> Vec<Sample> {
    let count = wo.len();
    let (wo, u) = (vectors(wo), vectors(u));
    let [mut wi, mut weight] = [(); 2].map(|()| Planes::zero(3, count));
    let [mut pdf, mut eta] = [(); 2].map(|()| Planes::zero(1, count));
    let [mut flags, mut lobe] = [(); 2].map(|()| Planes::zero(1, count));
    let args = SampleArgs {
        count,
        wo: view(&wo, 3),
        u: view(&u, 3),
        varying: &varying.views(),
        wi: wi.view(),
        pdf: pdf.view(),
        weight: weight.view(),
        eta: eta.view(),
        flags: flags.view(),
        lobe: lobe.view(),
    };
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { sample(bsdf, &args, level) }.unwrap();
    let sample = |i: usize| Sample {
        wi: wi.get(i).into(),
        pdf: pdf.numbers[i],
        weight: weight.get(i),
        eta: eta.numbers[i],
        flags: Flags(flags.numbers[i]),
        lobe: lobe.numbers[i] as usize,
    };
    (0..count).map(sample).collect()
}

pub fn reflectances(
    film: &Film,
    level: Level,
    cos_theta: &[f32],
    thickness_nm: &[f32],
) -> Vec<[f32; 3]> {
    let count = cos_theta.len();
    let mut reflectance = Planes::zero(3, count);
    let args = FilmArgs {
        count,
        cos_theta: view(cos_theta, 1),
        thickness_nm: view(thickness_nm, 1),
        reflectance: reflectance.view(),
    };
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { film_reflectance(film, &args, level) }.unwrap();
    (0..count).map(|i| reflectance.get(i)).collect()
}
