//! Evaluation and sampling of a surface, for one element and in jobs for many.
//!
//! The functions [`eval_pdf`], [`sample`] and [`vary`] are generic over the lane type: single calls run
//! them with one lane, jobs with the lanes of the processor.

use super::call::Transport;
use super::lobes::{LobeSet, MAX_LOBES, PerLobe, mixture_density, normalized};
use super::surface::Surface;
use super::varying::{MAX_VARYING, VaryingValues};
use crate::num::{ColumnMut, Columns, ColumnsMut, Lane, Mask, Real, Rgb, Vec3, each};

/// A job that finds values, densities or both of many elements.
pub struct EvalJob<'a, T> {
    /// Directions to the viewer; any numbers.
    pub wo: Columns<'a, T>,
    /// Directions to the light; any numbers.
    pub wi: Columns<'a, T>,
    /// Values of the parameters that vary.
    pub varying: VaryingValues<'a, T>,
    /// The lobes that take part.
    pub lobes: LobeSet,
    /// Receives f |wi.z|, if it is wanted; 0 for invalid directions.
    pub value: Option<ColumnsMut<'a, T>>,
    /// Receives the density of wi, if it is wanted.
    pub pdf: Option<ColumnMut<'a, T>>,
}

/// A job that samples directions of many elements. Without a valid sample every output is 0.
pub struct SampleJob<'a, T> {
    /// Directions to the viewer; any numbers.
    pub wo: Columns<'a, T>,
    /// Uniform numbers in [0, 1); the first chooses the lobe.
    pub u: Columns<'a, T>,
    /// Values of the parameters that vary.
    pub varying: VaryingValues<'a, T>,
    /// The lobes that take part.
    pub lobes: LobeSet,
    /// The quantity that is transported along the path.
    pub transport: Transport,
    /// Receives the directions to the light.
    pub wi: ColumnsMut<'a, T>,
    /// Receives value / pdf; for a Dirac lobe its throughput over the probability of choosing it.
    pub weight: ColumnsMut<'a, T>,
    /// Receives the density of wi over all lobes; 0 for a Dirac lobe.
    pub pdf: ColumnMut<'a, T>,
    /// Receives the index on wi's side over the index on wo's side.
    pub eta: ColumnMut<'a, T>,
    /// Receives the number of the chosen lobe.
    pub lobe: ColumnMut<'a, T>,
    /// Receives the probability with which the lobe was chosen; 0 tells that there is no sample.
    pub lobe_probability: ColumnMut<'a, T>,
}

/// A sampled direction, or one in each lane. Without a valid sample every field is 0.
#[derive(Clone, Copy, Debug)]
pub struct Direction<L> {
    /// The direction to the light.
    pub wi: Vec3<L>,
    /// The density over all lobes, per solid angle; 0 for a Dirac lobe.
    pub pdf: L,
    /// value / pdf; for a Dirac lobe its throughput over the probability of choosing it.
    pub weight: Rgb<L>,
    /// Index on wi's side over the index on wo's side.
    pub eta: L,
    /// Number of the chosen lobe.
    pub lobe: L,
    /// The probability with which it was chosen.
    pub lobe_probability: L,
}

/// The greatest |w|^2 - 1 of a direction that is accepted. It is that of a length of 1 + 1e-3, rounded up, because
/// what is within 1e-3 of unit length must be accepted whatever single precision makes of its square.
const ACCEPTED: f64 = 2.002e-3;

/// The greatest ||w|^2 - 1| that is left as it is. Single precision leaves up to 4e-7 in a direction that has been
/// normalised; a length off by half of this bound still is unit to 1e-6.
const AS_IT_IS: f64 = 1e-6;

/// The direction with unit length, and a mask of the lanes in which it is accepted: those in which its length is
/// 1 to within 1e-3; none where it is NaN or infinite.
///
/// A direction that is unit to rounding is not changed, and a block of such directions costs a comparison and a
/// branch that is not taken. Applied to its own result it changes nothing.
#[inline(always)]
pub fn unit<T: Real>(w: Vec3<T>) -> (Vec3<T>, T::Mask) {
    let excess = (w.length_squared() - T::new(1.0)).abs();
    let is_unit = excess.le(T::new(AS_IT_IS));
    if !(!is_unit).any() {
        return (w, is_unit);
    }
    let is_accepted = excess.le(T::new(ACCEPTED));
    let is_rough = is_accepted & !is_unit;
    (Vec3::select(is_rough, w.normalized(), w), is_accepted)
}

/// The direction with unit length, and a mask of the lanes in which it is accepted, see [`unit`], and has z > 0.
#[inline(always)]
pub fn unit_above<T: Real>(w: Vec3<T>) -> (Vec3<T>, T::Mask) {
    let (w, is_accepted) = unit(w);
    (w, is_accepted & w.z.gt(T::new(0.0)))
}

/// Whether all numbers are in [0, 1).
#[inline(always)]
pub fn are_uniform<T: Real>(u: [T; 3]) -> T::Mask {
    let is_uniform = |u: T| u.ge(T::new(0.0)) & u.lt(T::new(1.0));
    is_uniform(u[0]) & is_uniform(u[1]) & is_uniform(u[2])
}

impl<T: Lane<Scalar = T>> EvalJob<'_, T> {
    /// Does the job with a surface that has the description's values.
    #[inline(always)]
    pub fn run<L: Lane<Scalar = T>, S: Surface<L>>(&mut self, mut surface: S) {
        if !self.lobes.is_all() {
            surface.retain(self.lobes);
        }
        surface.finish_vary();
        // These are copied, because memory behind `self` would be read again after each result is written.
        let (wo, wi, varying, lobes) = (self.wo, self.wi, self.varying, self.lobes);
        let (mut values, mut pdf) = (self.value.take(), self.pdf.take());
        // The most frequent case, values alone without varying parameters, has its own loop: only the
        // directions depend on the element, and the compiler moves the rest out of the loop. These are
        // plain loops, because closures passed to the standard library are compiled without the level's
        // instructions.
        if pdf.is_none() && varying.is_empty() {
            let Some(values) = &mut values else { return };
            for from in (0..wo.count()).step_by(L::COUNT) {
                let (wo, wi, is_seen) = directions::<L>(&wo, &wi, from);
                store_value(values, from, is_seen, surface.eval(wo, wi));
            }
            return;
        }
        let mut is_usable = L::new(0.0).equals(L::new(0.0));
        for from in (0..wo.count()).step_by(L::COUNT) {
            if !varying.is_empty() {
                is_usable = vary(&mut surface, &varying, from);
            }
            let (wo, wi, is_seen) = directions::<L>(&wo, &wi, from);
            let is_seen = is_seen & is_usable;
            let (value, densities) = surface.eval_with_densities(wo, wi);
            if let Some(values) = &mut values {
                store_value(values, from, is_seen, value);
            }
            if let Some(pdf) = &mut pdf {
                let density = mixture_density(&choices(&surface, wo, lobes), &densities);
                pdf.store(from, L::select(is_seen, density, L::new(0.0)));
            }
        }
    }

    /// Does the job element by element. `eval_pdf` returns the value and the density of an element.
    pub fn run_each(&mut self, mut eval_pdf: impl FnMut(usize, Vec3<T>, Vec3<T>) -> (Rgb<T>, T)) {
        for element in 0..self.wo.count() {
            let (wo, wi, is_seen) = directions::<T>(&self.wo, &self.wi, element);
            let (value, density) = eval_pdf(element, wo, wi);
            if let Some(values) = &mut self.value {
                store_value(values, element, is_seen, value);
            }
            if let Some(pdf) = &mut self.pdf {
                pdf.set(element, T::select(is_seen, density, T::new(0.0)));
            }
        }
    }

    /// Writes zeros.
    pub fn clear(&mut self) {
        self.run_each(|_, _, _| ([T::new(0.0); 3], T::new(0.0)));
    }
}

/// wo, wi, and a mask of the lanes in which both are valid.
#[inline(always)]
fn directions<L: Lane>(
    wo: &Columns<L::Scalar>,
    wi: &Columns<L::Scalar>,
    from: usize,
) -> (Vec3<L>, Vec3<L>, L::Mask) {
    let (wo, is_wo_above) = unit_above(Vec3::from_array(wo.load::<L>(from)));
    let (wi, is_wi_above) = unit_above(Vec3::from_array(wi.load::<L>(from)));
    (wo, wi, is_wo_above & is_wi_above)
}

#[inline(always)]
fn store_value<L: Lane>(
    values: &mut ColumnsMut<L::Scalar>,
    from: usize,
    is_seen: L::Mask,
    value: Rgb<L>,
) {
    let zero = L::new(0.0);
    values.store(
        from,
        each!(value, |channel| L::select(is_seen, channel, zero)),
    );
}

impl<T: Lane<Scalar = T>> SampleJob<'_, T> {
    /// Does the job with a surface that has the description's values.
    #[inline(always)]
    pub fn run<L: Lane<Scalar = T>, S: Surface<L>>(&mut self, mut surface: S) {
        if !self.lobes.is_all() {
            surface.retain(self.lobes);
        }
        surface.finish_vary();
        // These are copied, as in `EvalJob::run`.
        let (wo, u, varying, lobes) = (self.wo, self.u, self.varying, self.lobes);
        let mut is_usable = L::new(0.0).equals(L::new(0.0));
        for from in (0..wo.count()).step_by(L::COUNT) {
            if !varying.is_empty() {
                is_usable = vary(&mut surface, &varying, from);
            }
            let (wo, is_above) = unit_above(Vec3::from_array(wo.load::<L>(from)));
            let u = u.load::<L>(from);
            let is_usable = is_usable & is_above & are_uniform(u);
            self.store(from, sample(&surface, lobes, is_usable, wo, u));
        }
    }

    /// Does the job element by element.
    pub fn run_each(&mut self, mut draw: impl FnMut(usize, Vec3<T>, [T; 3]) -> Direction<T>) {
        for element in 0..self.wo.count() {
            let wo = Vec3::from_array(self.wo.load::<T>(element));
            let u = self.u.load::<T>(element);
            self.store(element, draw(element, wo, u));
        }
    }

    #[inline(always)]
    fn store<L: Lane<Scalar = T>>(&mut self, from: usize, direction: Direction<L>) {
        self.wi.store(from, direction.wi.to_array());
        self.weight.store(from, direction.weight);
        self.pdf.store(from, direction.pdf);
        self.eta.store(from, direction.eta);
        self.lobe.store(from, direction.lobe);
        self.lobe_probability
            .store(from, direction.lobe_probability);
    }
}

impl<L: Lane> Direction<L> {
    /// No direction.
    #[inline(always)]
    pub fn none() -> Self {
        let zero = L::new(0.0);
        Self {
            wi: Vec3::zero(),
            pdf: zero,
            weight: [zero; 3],
            eta: zero,
            lobe: zero,
            lobe_probability: zero,
        }
    }
}

/// Calls `f` with the varying values of a single call, as pairs of parameter index and value; `None` if a
/// value is unusable.
#[inline(always)]
pub fn with_overrides<T: Lane<Scalar = T, Mask = bool>, R>(
    varying: &VaryingValues<T>,
    f: impl FnOnce(&[(usize, [T; 3])]) -> R,
) -> Option<R> {
    let mut overrides = [(0, [T::new(0.0); 3]); MAX_VARYING];
    let mut count = 0;
    let is_usable = varying.clamp_inputs::<T>(0, |param, value| {
        overrides[count] = (param, value);
        count += 1;
    });
    is_usable.then(|| f(&overrides[..count]))
}

/// Sets the varying values of the elements from `from` on. Returns a mask of the elements whose values are
/// usable.
#[inline(always)]
pub fn vary<L: Lane, S: Surface<L>>(
    surface: &mut S,
    varying: &VaryingValues<L::Scalar>,
    from: usize,
) -> L::Mask {
    let is_usable = varying.clamp_inputs::<L>(
        from,
        #[inline(always)]
        |param, value| surface.vary(param, value),
    );
    surface.finish_vary();
    is_usable
}

/// The probability of choosing each lobe; 0 for lobes that do not take part.
#[inline(always)]
pub fn choices<L: Lane, S: Surface<L>>(surface: &S, wo: Vec3<L>, lobes: LobeSet) -> PerLobe<L> {
    let mut shares = surface.choose(wo);
    if lobes.is_all() {
        return shares;
    }
    for (lobe, share) in shares.iter_mut().enumerate() {
        if !lobes.contains(lobe) {
            *share = L::new(0.0);
        }
    }
    normalized(shares)
}

/// The value, and the density over all lobes.
#[inline(always)]
pub fn eval_pdf<L: Lane, S: Surface<L>>(
    surface: &S,
    lobes: LobeSet,
    wo: Vec3<L>,
    wi: Vec3<L>,
) -> (Rgb<L>, L) {
    let (value, densities) = surface.eval_with_densities(wo, wi);
    (
        value,
        mixture_density(&choices(surface, wo, lobes), &densities),
    )
}

/// Samples a direction where the inputs are usable. The first number chooses the lobe.
#[inline(always)]
pub fn sample<L: Lane, S: Surface<L>>(
    surface: &S,
    lobes: LobeSet,
    is_usable: L::Mask,
    wo: Vec3<L>,
    u: [L; 3],
) -> Direction<L> {
    let (zero, one) = (L::new(0.0), L::new(1.0));
    let shares = choices(surface, wo, lobes);
    let (mut wi, mut number, mut probability) = (Vec3::zero(), zero, zero);
    let chosen = chosen_lobe(&shares, u[0]);
    if L::COUNT == 1 {
        if let Some(lobe) = only(&chosen) {
            wi = surface.sample(lobe, wo, [u[1], u[2]]);
            (number, probability) = (L::new(lobe as f64), shares[lobe]);
        }
    } else {
        for (lobe, is_chosen) in chosen.into_iter().enumerate() {
            if is_chosen.any() {
                let direction = surface.sample(lobe, wo, [u[1], u[2]]);
                wi = Vec3::select(is_chosen, direction, wi);
                number = L::select(is_chosen, L::new(lobe as f64), number);
                probability = L::select(is_chosen, shares[lobe], probability);
            }
        }
    }
    // An evaluation of this direction normalises it likewise, and must find the same density.
    let wi = if S::SAMPLES_ARE_UNIT { wi } else { unit(wi).0 };
    let is_above = wi.z.gt(zero);
    // Lanes without a direction evaluate wo itself, which is valid, and are set to 0 below.
    let wi = Vec3::select(is_above, wi, wo);
    let (value, densities) = surface.eval_with_densities(wo, wi);
    let pdf = mixture_density(&shares, &densities);
    let is_found = is_usable & is_above & pdf.gt(zero) & pdf.is_finite();
    let [x, y, z] = each!(wi.to_array(), |number| L::select(is_found, number, zero));
    Direction {
        wi: Vec3::new(x, y, z),
        pdf: L::select(is_found, pdf, zero),
        weight: each!(value, |value| L::select(is_found, value / pdf, zero)),
        eta: L::select(is_found, one, zero),
        lobe: L::select(is_found, number, zero),
        lobe_probability: L::select(is_found, probability, zero),
    }
}

/// The chosen lobe, for one lane.
#[inline(always)]
pub fn only<M: Mask>(chosen: &[M; MAX_LOBES]) -> Option<usize> {
    chosen.iter().position(|is_chosen| is_chosen.any())
}

/// The lobe in whose share of [0, 1) the number is, as one mask per lobe; no lobe if all shares are 0.
#[inline(always)]
pub fn chosen_lobe<T: Lane>(shares: &PerLobe<T>, u: T) -> [T::Mask; MAX_LOBES] {
    let zero = T::new(0.0);
    let never = zero.lt(zero);
    let (mut chosen, mut is_open, mut below) = ([never; MAX_LOBES], !never, zero);
    for (chosen, share) in chosen.iter_mut().zip(shares) {
        below = below + *share;
        *chosen = is_open & share.gt(zero) & u.lt(below);
        is_open = is_open & !*chosen;
    }
    // Rounding may leave the sum of all shares below u. Then the last lobe with a share is chosen.
    for (chosen, share) in chosen.iter_mut().zip(shares).rev() {
        let is_last = is_open & share.gt(zero);
        *chosen = *chosen | is_last;
        is_open = is_open & !is_last;
    }
    chosen
}
