//! Batches of spectral calls, over elements and wavelengths.

use super::view::{ConstView, View, check_reach};
use crate::bsdf::{AtWavelengths, Bsdf, Call, MAX_SPECTRAL_FLOATS, MAX_VARYING, MAX_WAVELENGTHS};
use crate::error::Error;

/// What evaluation and sampling have in common.
#[derive(Clone, Copy, Debug)]
pub struct SpectralInputs<'a> {
    /// The number of elements.
    pub count: usize,
    /// The number of wavelengths of each element.
    pub lambda_count: usize,
    /// Options for all elements.
    pub call: Call,
    /// Vacuum wavelengths, nm, one component each.
    pub lambda_nm: ConstView,
    /// Directions to the viewer.
    pub wo: ConstView,
    /// One view per varying parameter, or no views: colours have a component for each wavelength. A parameter whose
    /// data is null, and every parameter without views, has its default.
    pub varying: &'a [ConstView],
}

/// Arguments of [`eval_spectral`].
#[derive(Clone, Copy, Debug)]
pub struct EvalSpectralArgs<'a> {
    /// The inputs that sampling takes too.
    pub inputs: SpectralInputs<'a>,
    /// Directions to the light.
    pub wi: ConstView,
    /// Receives f |wi.z|, a component for each wavelength.
    pub value: View,
    /// Receives the densities of wi as if each wavelength had been the hero.
    pub pdf: View,
}

/// Arguments of [`sample_spectral`].
#[derive(Clone, Copy, Debug)]
pub struct SampleSpectralArgs<'a> {
    /// The inputs that evaluation takes too.
    pub inputs: SpectralInputs<'a>,
    /// The wavelength that directions are sampled for.
    pub hero: usize,
    /// Uniform numbers in [0, 1).
    pub u: ConstView,
    /// Receives the directions to the light.
    pub wi: View,
    /// Receives the weights, a component for each wavelength.
    pub weight: View,
    /// Receives the densities, a component for each wavelength.
    pub pdf: View,
    /// Receives the refractive index on wi's side over that on wo's side, for the hero.
    pub eta: View,
    /// Receives the chosen lobe's flags.
    pub flags: View<u32>,
    /// Receives the chosen lobe's number.
    pub lobe: View<u32>,
    /// Receives the probability with which the hero chose the lobe.
    pub lobe_probability: View,
    /// Receives 1 where the hero alone goes in that direction, else 0.
    pub hero_only: View<u32>,
}

/// Evaluates values and densities at every wavelength of every element. The results are the bits of single calls.
///
/// # Errors
/// Those of [`Bsdf::eval_spectral`]; `InvalidArgument` if a needed view is null, no output is wanted, the number of
/// varying views is wrong, or an offset overflows the address space. Nothing is then written.
///
/// # Safety
/// Every address that the views stand for must be readable or, for outputs, writable. An output must overlap neither an
/// input nor another output.
pub unsafe fn eval_spectral(bsdf: &Bsdf, args: &EvalSpectralArgs) -> Result<(), Error> {
    let EvalSpectralArgs {
        inputs,
        wi,
        value,
        pdf,
    } = args;
    if value.data.is_null() && pdf.data.is_null() {
        return Err(Error::invalid(
            "value and pdf are both NULL: nothing to compute",
        ));
    }
    wi.check("wi", 3, inputs.count)?;
    let used = inputs.lambda_count.min(MAX_WAVELENGTHS);
    value.check("value", used, inputs.count)?;
    pdf.check("pdf", used, inputs.count)?;
    // SAFETY: the caller vouches for every address of every view.
    unsafe {
        inputs.each(bsdf, 0, |i, element| {
            let [mut values, mut densities] = [[0.0; MAX_WAVELENGTHS]; 2];
            bsdf.eval_spectral_checked(
                element.wo.into(),
                vector(wi, i).into(),
                &element.at,
                &inputs.call,
                &mut values[..used],
                &mut densities[..used],
            );
            write(value, i, &values[..used]);
            write(pdf, i, &densities[..used]);
        })
    }
}

/// Samples a direction for every element. The results are the bits of single calls.
///
/// # Errors
/// Those of [`Bsdf::sample_spectral`] and [`eval_spectral`].
///
/// # Safety
/// As for [`eval_spectral`].
pub unsafe fn sample_spectral(bsdf: &Bsdf, args: &SampleSpectralArgs) -> Result<(), Error> {
    let inputs = &args.inputs;
    let floats = [
        ("wi", args.wi, 3),
        ("weight", args.weight, inputs.lambda_count),
        ("pdf", args.pdf, inputs.lambda_count),
        ("eta", args.eta, 1),
        ("lobe_probability", args.lobe_probability, 1),
    ];
    let numbers = [
        ("flags", args.flags),
        ("lobe", args.lobe),
        ("hero_only", args.hero_only),
    ];
    let is_unwanted = floats.iter().all(|(_, view, _)| view.data.is_null())
        && numbers.iter().all(|(_, view)| view.data.is_null());
    if is_unwanted {
        return Err(Error::invalid("every output is NULL: nothing to compute"));
    }
    args.u.check("u", 3, inputs.count)?;
    for (name, view, components) in floats {
        view.check(name, components.min(MAX_WAVELENGTHS), inputs.count)?;
    }
    for (name, view) in numbers {
        view.check(name, 1, inputs.count)?;
    }
    let used = inputs.lambda_count.min(MAX_WAVELENGTHS);
    // SAFETY: the caller vouches for every address of every view.
    unsafe {
        inputs.each(bsdf, args.hero, |i, element| {
            let [mut weights, mut densities] = [[0.0; MAX_WAVELENGTHS]; 2];
            let sample = bsdf.sample_spectral_checked(
                element.wo.into(),
                vector(&args.u, i).into(),
                &element.at,
                &inputs.call,
                &mut weights[..used],
                &mut densities[..used],
            );
            write(&args.wi, i, &sample.wi.to_array());
            write(&args.weight, i, &weights[..used]);
            write(&args.pdf, i, &densities[..used]);
            write(&args.eta, i, &[sample.eta]);
            write(&args.lobe_probability, i, &[sample.lobe_probability]);
            write(&args.flags, i, &[sample.flags.0]);
            write(&args.lobe, i, &[sample.lobe as u32]);
            write(&args.hero_only, i, &[u32::from(sample.is_hero_only)]);
        })
    }
}

/// The inputs of one element, as single calls take them.
struct Element<'a> {
    wo: [f32; 3],
    at: AtWavelengths<'a>,
}

impl SpectralInputs<'_> {
    /// Checks everything that may be refused, then calls `f` for each element.
    ///
    /// # Safety
    /// Every address that the views stand for must be readable.
    unsafe fn each(
        &self,
        bsdf: &Bsdf,
        hero: usize,
        mut f: impl FnMut(usize, Element),
    ) -> Result<(), Error> {
        let (count, used) = (self.count, self.lambda_count);
        self.wo.check("wo", 3, count)?;
        bsdf.check_wavelength_count(used, hero)?;
        self.lambda_nm.check("lambda_nm", used, count)?;
        if !self.varying.is_empty() && self.varying.len() != bsdf.varying_count() {
            return Err(Error::invalid(format!(
                "varying_count = {} but the BSDF has {} varying parameters",
                self.varying.len(),
                bsdf.varying_count()
            )));
        }
        let mut components = [0; MAX_VARYING];
        for (components, varying) in components.iter_mut().zip(bsdf.varying()) {
            *components = varying.param.spectral_components(used);
        }
        for (view, components) in self.varying.iter().zip(components) {
            let strides = [view.element_stride, view.component_stride];
            check_reach("varying", components, count, strides[0], strides[1])?;
        }
        let is_default = |at: usize| self.varying.get(at).is_none_or(|view| view.data.is_null());
        bsdf.check_spectral_defaults(is_default)?;
        // The same wavelengths for all elements are looked at once.
        let is_broadcast = self.lambda_nm.element_stride == 0;
        for i in 0..if is_broadcast { count.min(1) } else { count } {
            for c in 0..used {
                // SAFETY: the caller vouches for the address.
                let nm = unsafe { self.lambda_nm.address(i, c).read_unaligned() };
                let name = format_args!("lambda_nm[{c}] of element {i}");
                bsdf.check_wavelength(name, f64::from(nm))?;
            }
        }
        let mut lambda_nm = [0.0; MAX_WAVELENGTHS];
        let mut numbers = [0.0; MAX_SPECTRAL_FLOATS];
        for i in 0..count {
            // SAFETY: the caller vouches for every address.
            unsafe {
                read(&self.lambda_nm, i, &mut lambda_nm[..used]);
                let mut floats = 0;
                for ((view, components), varying) in
                    self.varying.iter().zip(components).zip(bsdf.varying())
                {
                    let own = &mut numbers[floats..floats + components];
                    if view.data.is_null() {
                        let defaults = varying.defaults;
                        for (c, number) in own.iter_mut().enumerate() {
                            *number = defaults[c.min(defaults.len() - 1)];
                        }
                    } else {
                        read(view, i, own);
                    }
                    floats += components;
                }
                let element = Element {
                    wo: vector(&self.wo, i),
                    at: AtWavelengths {
                        lambda_nm: &lambda_nm[..used],
                        hero,
                        varying: (!self.varying.is_empty()).then_some(&numbers[..floats]),
                    },
                };
                f(i, element);
            }
        }
        Ok(())
    }
}

/// Reads the components of element i.
unsafe fn read(view: &ConstView, i: usize, numbers: &mut [f32]) {
    for (c, number) in numbers.iter_mut().enumerate() {
        // SAFETY: the caller vouches for the address.
        *number = unsafe { view.address(i, c).read_unaligned() };
    }
}

unsafe fn vector(view: &ConstView, i: usize) -> [f32; 3] {
    let mut numbers = [0.0; 3];
    // SAFETY: the caller vouches for the address.
    unsafe { read(view, i, &mut numbers) };
    numbers
}

/// Writes the components of element i, if they are wanted.
unsafe fn write<T: Copy>(view: &View<T>, i: usize, numbers: &[T]) {
    if view.data.is_null() {
        return;
    }
    for (c, number) in numbers.iter().enumerate() {
        // SAFETY: the caller vouches for the address.
        unsafe { view.address(i, c).write_unaligned(*number) };
    }
}
