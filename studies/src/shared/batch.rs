//! Batch calls on arrays: vectors lie element by element, results component by component.

#![allow(unsafe_code)] // batches take addresses

use glam::Vec3;
use pellicle::batch::{
    ConstView, EvalArgs, FilmArgs, SampleArgs, View, eval, film_reflectance, sample,
};
use pellicle::bsdf::Flags;
use pellicle::film::Film;
use pellicle::num::Level;
use pellicle::{Bsdf, Call, Error, Sample};

/// The varying parameters of a batch: the numbers of one element after those of the one before.
#[derive(Clone, Debug, Default)]
pub struct Varying {
    pub numbers: Vec<f32>,
    /// Of each parameter.
    pub components: Vec<usize>,
}

impl Varying {
    fn floats(&self) -> usize {
        self.components.iter().sum()
    }

    /// The numbers of one element, if any parameter varies.
    pub fn of(&self, i: usize) -> Option<&[f32]> {
        let floats = self.floats();
        (floats > 0).then(|| &self.numbers[i * floats..(i + 1) * floats])
    }

    fn views(&self) -> Vec<ConstView> {
        let mut first = 0;
        let view = |components: &usize| {
            let view = elements(&self.numbers[first..], self.floats());
            first += components;
            view
        };
        self.components.iter().map(view).collect()
    }
}

/// An array of results, each component's numbers side by side. What a batch leaves out stays `filler`.
struct Planes<T> {
    numbers: Vec<T>,
    count: usize,
}

impl<T: Copy> Planes<T> {
    fn new(components: usize, count: usize, filler: T) -> Self {
        let numbers = vec![filler; components * count];
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

/// Elements of that number of floats, side by side.
fn elements(numbers: &[f32], floats: usize) -> ConstView {
    ConstView {
        data: numbers.as_ptr(),
        element_stride: (size_of::<f32>() * floats) as isize,
        component_stride: size_of::<f32>() as isize,
    }
}

fn vectors(vectors: &[Vec3]) -> ConstView {
    ConstView {
        data: vectors.as_ptr().cast(),
        element_stride: size_of::<Vec3>() as isize,
        component_stride: size_of::<f32>() as isize,
    }
}

fn not_wanted() -> View {
    View {
        data: std::ptr::null_mut(),
        element_stride: 0,
        component_stride: 0,
    }
}

/// Value and density.
pub type Evaluated = ([f32; 3], f32);

pub fn values(
    bsdf: &Bsdf,
    level: Level,
    wo: &[Vec3],
    wi: &[Vec3],
    varying: &Varying,
) -> Result<Vec<Evaluated>, Error> {
    let count = wo.len();
    assert_eq!(wi.len(), count);
    let [mut value, mut pdf] = [3, 1].map(|components| Planes::new(components, count, f32::NAN));
    let args = EvalArgs {
        count,
        wo: vectors(wo),
        wi: vectors(wi),
        varying: &varying.views(),
        value: value.view(),
        pdf: pdf.view(),
        pdf_reverse: not_wanted(),
        call: Call::default(),
    };
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { eval(bsdf, &args, level) }?;
    Ok((0..count).map(|i| (value.get(i), pdf.numbers[i])).collect())
}

pub fn samples(
    bsdf: &Bsdf,
    level: Level,
    wo: &[Vec3],
    u: &[Vec3],
    varying: &Varying,
) -> Result<Vec<Sample>, Error> {
    let count = wo.len();
    assert_eq!(u.len(), count);
    let [mut wi, mut weight, mut pdf, mut eta, mut probability] =
        [3, 3, 1, 1, 1].map(|components| Planes::new(components, count, f32::NAN));
    let [mut flags, mut lobe] = [(); 2].map(|()| Planes::new(1, count, u32::MAX));
    let args = SampleArgs {
        count,
        wo: vectors(wo),
        u: vectors(u),
        varying: &varying.views(),
        wi: wi.view(),
        pdf: pdf.view(),
        weight: weight.view(),
        eta: eta.view(),
        flags: flags.view(),
        lobe: lobe.view(),
        lobe_probability: probability.view(),
        call: Call::default(),
    };
    // SAFETY: all views are of arrays of `count` elements.
    unsafe { sample(bsdf, &args, level) }?;
    let sample = |i: usize| Sample {
        wi: wi.get(i).into(),
        pdf: pdf.numbers[i],
        weight: weight.get(i),
        eta: eta.numbers[i],
        flags: Flags(flags.numbers[i]),
        lobe: lobe.numbers[i] as usize,
        lobe_probability: probability.numbers[i],
    };
    Ok((0..count).map(sample).collect())
}

/// At cosines and thicknesses (nm).
pub fn reflectances(
    film: &Film,
    level: Level,
    points: &[[f32; 2]],
) -> Result<Vec<[f32; 3]>, Error> {
    let mut colors = vec![[f32::NAN; 3]; points.len()];
    fill_reflectances(film, level, points, &mut colors)?;
    Ok(colors)
}

/// The same, into an array of the caller's.
pub fn fill_reflectances(
    film: &Film,
    level: Level,
    points: &[[f32; 2]],
    colors: &mut [[f32; 3]],
) -> Result<(), Error> {
    assert_eq!(points.len(), colors.len());
    if points.is_empty() {
        return Ok(());
    }
    let args = FilmArgs {
        thickness_spread_nm: ConstView::NONE,
        count: points.len(),
        cos_theta: elements(points.as_flattened(), 2),
        thickness_nm: elements(&points.as_flattened()[1..], 2),
        reflectance: View {
            data: colors.as_mut_ptr().cast(),
            element_stride: size_of::<[f32; 3]>() as isize,
            component_stride: size_of::<f32>() as isize,
        },
    };
    // SAFETY: all views are of arrays of as many elements.
    unsafe { film_reflectance(film, &args, level) }
}
