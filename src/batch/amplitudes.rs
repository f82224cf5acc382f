//! Batches of a film's complex amplitudes, over elements and wavelengths.

use super::film::thickness;
use super::view::{ConstView, View};
use crate::error::Error;
use crate::film::{Film, Ray};
use crate::optics::Complex;
use crate::optics::stack::{P, S, Side};

/// Arguments of [`film_amplitudes`].
#[derive(Clone, Copy, Debug)]
pub struct AmplitudeArgs {
    /// The number of elements.
    pub count: usize,
    /// The number of wavelengths of each element.
    pub lambda_count: usize,
    /// The side that the light comes from.
    pub side: Side,
    /// Vacuum wavelengths, nm, one component each.
    pub lambda_nm: ConstView,
    /// Cosines of incidence, clamped as in [`Film`].
    pub cos_theta: ConstView,
    /// Thicknesses of the layer that varies, nm; data may be null if no layer varies.
    pub thickness_nm: ConstView,
    /// Receive r_s, r_p, t_s and t_p: real and imaginary part at each wavelength, two components.
    pub outputs: [View; 4],
}

const NAMES: [&str; 4] = ["r_s", "r_p", "t_s", "t_p"];

/// Finds the amplitudes at every wavelength of every element. The results are the bits of single calls.
///
/// # Errors
/// `InvalidArgument` if a needed view is null, no output is wanted, or an offset overflows the address space;
/// `OutOfRange` for a wavelength. Nothing is then written.
///
/// # Safety
/// Every address that the views stand for must be readable or, for outputs, writable. An output must overlap
/// neither an input nor another output.
pub unsafe fn film_amplitudes(film: &Film, args: &AmplitudeArgs) -> Result<(), Error> {
    let (count, lambda_count) = (args.count, args.lambda_count);
    if args.outputs.iter().all(|view| view.data.is_null()) {
        return Err(Error::invalid(
            "r_s, r_p, t_s and t_p are all NULL: nothing to compute",
        ));
    }
    if count == 0 || lambda_count == 0 {
        return Ok(());
    }
    let too_many = || {
        Error::invalid(format!(
            "count = {count} with lambda_count = {lambda_count} overflows the address space"
        ))
    };
    let components = lambda_count.checked_mul(2).ok_or_else(too_many)?;
    args.lambda_nm.check("lambda_nm", lambda_count, count)?;
    args.cos_theta.check("cos_theta", 1, count)?;
    let thickness_nm = thickness(film, args.thickness_nm, count)?;
    for (view, name) in args.outputs.iter().zip(NAMES) {
        view.check(name, components, count)?;
    }
    let pairs = count.checked_mul(lambda_count).ok_or_else(too_many)?;
    // SAFETY: the caller vouches for every address of every view.
    unsafe {
        check_wavelengths(film, args)?;
        let mut read = Pairs::new(lambda_count);
        let mut written = Pairs::new(lambda_count);
        film.each_amplitudes(
            args.side,
            pairs,
            #[inline(always)]
            |_| {
                let (i, c) = read.next();
                Ray {
                    cos_theta: read_number(&args.cos_theta, i, 0),
                    thickness_nm: read_number(&thickness_nm, i, 0),
                    wavelength_nm: read_number(&args.lambda_nm, i, c),
                }
            },
            |x| x as f32,
            #[inline(always)]
            |_, found| {
                let (i, c) = written.next();
                let ([r, t], [r_s, r_p, t_s, t_p]) =
                    ([found.reflection, found.transmission], args.outputs);
                write(&r_s, i, c, r[S]);
                write(&r_p, i, c, r[P]);
                write(&t_s, i, c, t[S]);
                write(&t_p, i, c, t[P]);
            },
        );
    }
    Ok(())
}

/// Reads component c of element i.
#[inline(always)]
unsafe fn read_number(view: &ConstView, i: usize, c: usize) -> f64 {
    // SAFETY: the caller vouches for the address.
    f64::from(unsafe { view.address(i, c).read_unaligned() })
}

/// Writes the amplitude of element i at wavelength c.
#[inline(always)]
unsafe fn write(view: &View, i: usize, c: usize, value: Complex<f32>) {
    if view.data.is_null() {
        return;
    }
    // SAFETY: the caller vouches for the address.
    unsafe {
        let part = view.address(i, 2 * c);
        part.write_unaligned(value.re);
        part.byte_offset(view.component_stride)
            .write_unaligned(value.im);
    }
}

/// Elements and their wavelengths in order.
struct Pairs {
    element: usize,
    wavelength: usize,
    lambda_count: usize,
}

impl Pairs {
    fn new(lambda_count: usize) -> Self {
        Self {
            element: 0,
            wavelength: 0,
            lambda_count,
        }
    }

    #[inline(always)]
    fn next(&mut self) -> (usize, usize) {
        let pair = (self.element, self.wavelength);
        self.wavelength += 1;
        if self.wavelength == self.lambda_count {
            (self.element, self.wavelength) = (self.element + 1, 0);
        }
        pair
    }
}

unsafe fn check_wavelengths(film: &Film, args: &AmplitudeArgs) -> Result<(), Error> {
    // The same wavelengths for all elements are looked at once.
    let is_broadcast = args.lambda_nm.element_stride == 0;
    for i in 0..if is_broadcast { 1 } else { args.count } {
        for c in 0..args.lambda_count {
            // SAFETY: the caller vouches for the address.
            let nm = unsafe { args.lambda_nm.address(i, c).read_unaligned() };
            film.check_wavelength(format_args!("lambda_nm[{c}] of element {i}"), f64::from(nm))?;
        }
    }
    Ok(())
}
