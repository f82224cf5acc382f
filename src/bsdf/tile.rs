//! Many calls of one kernel at once: numbers lie side by side by component, and are evaluated as many
//! at a time as the processor has lanes.

use super::mixture::{Sampled, SurfaceWork, Surfaces, eval_pdf, sample};
use super::model::Scattering;
use crate::num::{Lane, Level, Real, Vec3, Work, each};

/// Slices of a tile have a multiple of so many numbers, which every level's lanes divide.
pub const LANES: usize = 16;

/// Three numbers per element.
pub type Vectors<'a> = [&'a [f32]; 3];
/// Three numbers per element, to write.
pub type VectorsMut<'a> = [&'a mut [f32]; 3];

/// The values of a parameter that varies, held in its range: a finite number by clamping, a direction, of
/// which z must be positive, by normalising it. Where that is impossible all results are 0.
#[derive(Clone, Copy, Debug)]
pub struct Varied<'a> {
    /// Index of the parameter.
    pub param: usize,
    /// Its values; a scalar is in all three places.
    pub value: Vectors<'a>,
    /// The range of each component; of no use for a direction.
    pub range: [f32; 2],
    /// Whether it is a direction.
    pub is_direction: bool,
}

impl Varied<'_> {
    /// A place to fill.
    pub const NONE: Self = Self {
        param: 0,
        value: [&[]; 3],
        range: [0.0; 2],
        is_direction: false,
    };
}

/// Calls of [`Kernel::eval_pdf`](super::Kernel::eval_pdf). All slices are equally long.
pub struct EvalTile<'a> {
    /// Directions to the viewer; any numbers.
    pub wo: Vectors<'a>,
    /// Directions to the light; any numbers.
    pub wi: Vectors<'a>,
    /// All parameters that vary, or none.
    pub varied: &'a [Varied<'a>],
    /// Receives f |wi.z|; 0 for directions that are not unit or not above the surface.
    pub value: VectorsMut<'a>,
    /// Receives the density, if it is wanted.
    pub pdf: Option<&'a mut [f32]>,
}

/// Calls of [`Kernel::sample`](super::Kernel::sample). All slices are equally long.
pub struct SampleTile<'a> {
    /// Directions to the viewer; any numbers.
    pub wo: Vectors<'a>,
    /// Uniform numbers; any numbers.
    pub u: Vectors<'a>,
    /// All parameters that vary, or none.
    pub varied: &'a [Varied<'a>],
    /// Receives the directions to the light; all outputs are 0 if there is no sample.
    pub wi: VectorsMut<'a>,
    /// Receives the density.
    pub pdf: &'a mut [f32],
    /// Receives value / pdf.
    pub weight: VectorsMut<'a>,
    /// Receives the lobe's number.
    pub lobe: &'a mut [f32],
}

/// A kernel that takes tiles.
pub trait Tiles {
    /// Value and density of every element.
    fn eval(&self, level: Level, tile: EvalTile);
    /// A direction for every element. All lobes reflect, and eta is 1.
    fn sample(&self, level: Level, tile: SampleTile);
}

/// Whether the direction is unit to 1e-3 and above the surface. NaN and infinity are not.
#[inline(always)]
pub fn is_above<T: Real>(w: Vec3<T>) -> T::Mask {
    is_unit(w) & w.z.gt(T::new(0.0))
}

/// Whether the direction is unit to 1e-3: twice that, since the length is squared.
#[inline(always)]
pub fn is_unit<T: Real>(w: Vec3<T>) -> T::Mask {
    (w.length_squared() - T::new(1.0)).abs().le(T::new(2e-3))
}

/// Whether a number is in [0, 1).
#[inline(always)]
pub fn is_uniform<T: Real>(u: T) -> T::Mask {
    u.ge(T::new(0.0)) & u.lt(T::new(1.0))
}

#[inline(always)]
fn load<L: Lane<Scalar = f32>>(vectors: Vectors, from: usize) -> [L; 3] {
    each!(vectors, |numbers| L::load(&numbers[from..from + L::COUNT]))
}

#[inline(always)]
fn store<L: Lane<Scalar = f32>>(vectors: &mut VectorsMut, from: usize, [x, y, z]: [L; 3]) {
    x.store(&mut vectors[0][from..from + L::COUNT]);
    y.store(&mut vectors[1][from..from + L::COUNT]);
    z.store(&mut vectors[2][from..from + L::COUNT]);
}

/// Gives the surface the values of the elements from one on; where they are usable.
#[inline(always)]
fn vary<L: Lane<Scalar = f32>, S: Scattering<L>>(
    surface: &mut S,
    varied: &[Varied],
    from: usize,
) -> L::Mask {
    let zero = L::new(0.0);
    let mut is_usable = zero.equals(zero);
    for varied in varied {
        let value = load(varied.value, from);
        let [x, y, z]: [L; 3] = value;
        is_usable = is_usable & x.is_finite() & y.is_finite() & z.is_finite();
        let value = if varied.is_direction {
            let (unit, is_upward) = Vec3::from_array(value).upward();
            is_usable = is_usable & is_upward;
            unit.to_array()
        } else {
            let [min, max] = [L::splat(varied.range[0]), L::splat(varied.range[1])];
            each!(value, |number| number.max(min).min(max))
        };
        surface.vary(varied.param, value);
    }
    surface.settle();
    is_usable
}

/// Evaluates a tile.
pub(super) struct Eval<'a, M> {
    pub model: &'a M,
    pub tile: EvalTile<'a>,
}

impl<M: Surfaces<f32>> Work<f32> for Eval<'_, M> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lane<Scalar = f32>>(self) {
        self.model.with_surface::<L, _>(self.tile);
    }
}

impl<L: Lane<Scalar = f32>> SurfaceWork<L> for EvalTile<'_> {
    const IS_SHORT: bool = true;

    /// A loop of its own for the most frequent case: as much follows from what does not vary, once for all
    /// elements.
    #[inline(always)]
    fn run_swiftly<S: Scattering<L>>(mut self, mut surface: S) {
        if self.pdf.is_some() || !self.varied.is_empty() {
            return self.run(surface);
        }
        surface.settle();
        for from in (0..self.wo[0].len()).step_by(L::COUNT) {
            self.value(&surface, from);
        }
    }

    #[inline(always)]
    fn run<S: Scattering<L>>(mut self, mut surface: S) {
        surface.settle();
        let mut is_usable = L::new(0.0).equals(L::new(0.0));
        for from in (0..self.wo[0].len()).step_by(L::COUNT) {
            if !self.varied.is_empty() {
                is_usable = vary(&mut surface, self.varied, from);
            }
            self.both(&surface, from, is_usable);
        }
    }
}

impl EvalTile<'_> {
    #[inline(always)]
    fn pair<L: Lane<Scalar = f32>>(&self, from: usize) -> [Vec3<L>; 2] {
        [
            Vec3::from_array(load(self.wo, from)),
            Vec3::from_array(load(self.wi, from)),
        ]
    }

    #[inline(always)]
    fn value<L: Lane<Scalar = f32>, S: Scattering<L>>(&mut self, surface: &S, from: usize) {
        let [wo, wi] = self.pair(from);
        let is_seen = is_above(wo) & is_above(wi);
        let value = surface.eval(wo, wi);
        let value = each!(value, |channel| L::select(is_seen, channel, L::new(0.0)));
        store(&mut self.value, from, value);
    }

    #[inline(always)]
    fn both<L: Lane<Scalar = f32>, S: Scattering<L>>(
        &mut self,
        surface: &S,
        from: usize,
        is_usable: L::Mask,
    ) {
        let [wo, wi] = self.pair(from);
        let is_seen = is_usable & is_above(wo) & is_above(wi);
        let (value, density) = eval_pdf(surface, wo, wi);
        let value = each!(value, |channel| L::select(is_seen, channel, L::new(0.0)));
        store(&mut self.value, from, value);
        if let Some(pdf) = &mut self.pdf {
            let density = L::select(is_seen, density, L::new(0.0));
            density.store(&mut pdf[from..from + L::COUNT]);
        }
    }
}

/// Samples a tile.
pub(super) struct Sample<'a, M> {
    pub model: &'a M,
    pub tile: SampleTile<'a>,
}

impl<M: Surfaces<f32>> Work<f32> for Sample<'_, M> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lane<Scalar = f32>>(self) {
        self.model.with_surface::<L, _>(self.tile);
    }
}

impl<L: Lane<Scalar = f32>> SurfaceWork<L> for SampleTile<'_> {
    const IS_SHORT: bool = false;

    #[inline(always)]
    fn run<S: Scattering<L>>(mut self, mut surface: S) {
        for from in (0..self.wo[0].len()).step_by(L::COUNT) {
            let is_usable = vary(&mut surface, self.varied, from);
            self.sample(&surface, from, is_usable);
        }
    }
}

impl SampleTile<'_> {
    #[inline(always)]
    fn sample<L: Lane<Scalar = f32>, S: Scattering<L>>(
        &mut self,
        surface: &S,
        from: usize,
        is_usable: L::Mask,
    ) {
        let zero = L::new(0.0);
        let (wo, u) = (Vec3::from_array(load(self.wo, from)), load(self.u, from));
        let is_usable =
            is_usable & is_above(wo) & is_uniform(u[0]) & is_uniform(u[1]) & is_uniform(u[2]);
        let Sampled {
            wi,
            pdf,
            weight,
            lobe,
        } = sample(surface, wo, u);
        let wi = each!(wi.to_array(), |number| L::select(is_usable, number, zero));
        let weight = each!(weight, |number| L::select(is_usable, number, zero));
        let [pdf, lobe] = [
            L::select(is_usable, pdf, zero),
            L::select(is_usable, lobe, zero),
        ];
        store(&mut self.wi, from, wi);
        store(&mut self.weight, from, weight);
        pdf.store(&mut self.pdf[from..from + L::COUNT]);
        lobe.store(&mut self.lobe[from..from + L::COUNT]);
    }
}
