//! Conversion of a medium.

use super::boundary::{elements, string};
use super::c_types::c_char;
use super::film_types::PellicleMedium;
use crate::error::Error;
use crate::optics::Medium;

/// The medium given in one of the three ways; none if every field is zero. Messages begin with
/// `place`.
///
/// # Safety
/// Its pointers must be NULL or good for their counts, its name NUL-terminated.
pub(super) unsafe fn medium(given: &PellicleMedium, place: &str) -> Result<Option<Medium>, Error> {
    let parts = [given.table_nm, given.table_eta, given.table_k];
    let has_name = !given.name.is_null();
    let has_numbers = given
        .eta
        .iter()
        .chain(&given.k)
        .any(|number| *number != 0.0);
    let has_table = given.table_count > 0 || parts.iter().any(|part| !part.is_null());
    let found = match (has_name, has_numbers, has_table) {
        (false, false, false) => return Ok(None),
        // SAFETY: the caller vouches for the terminator.
        (true, false, false) => unsafe { named(given.name) },
        (false, true, false) => Medium::rgb(given.eta.map(f64::from), given.k.map(f64::from)),
        // SAFETY: the caller vouches for the count.
        (false, false, true) => unsafe { tabulated(parts, given.table_count) },
        (true, true, _) => Err(twice("a name and eta or k")),
        (true, false, true) => Err(twice("a name and a table")),
        (false, true, true) => Err(twice("eta or k and a table")),
    };
    let located = |error: Error| Error::new(error.status, format!("{place}: {error}"));
    found.map(Some).map_err(located)
}

/// As [`medium`], but refused if every field is zero.
///
/// # Safety
/// As for [`medium`].
pub(super) unsafe fn needed_medium(given: &PellicleMedium, place: &str) -> Result<Medium, Error> {
    // SAFETY: the caller vouches for strings and counts.
    unsafe { medium(given, place) }?.ok_or_else(|| {
        Error::invalid(format!(
            "{place} is all zero: give a name, eta and k, or a table"
        ))
    })
}

fn twice(both: &str) -> Error {
    Error::invalid(format!("{both} are both given: give one"))
}

unsafe fn named(name: *const c_char) -> Result<Medium, Error> {
    // SAFETY: the caller vouches for the terminator.
    Medium::named(&unsafe { string(name, "name") }?)
}

unsafe fn tabulated(parts: [*const f32; 3], count: usize) -> Result<Medium, Error> {
    // SAFETY: the caller vouches for the count.
    let [nm, eta, k] = unsafe {
        [
            doubles(parts[0], count, "table_nm")?,
            doubles(parts[1], count, "table_eta")?,
            doubles(parts[2], count, "table_k")?,
        ]
    };
    Medium::table(&nm, &eta, &k)
}

/// A copy in double precision. Its size is the caller's, so it is reserved fallibly.
unsafe fn doubles(pointer: *const f32, count: usize, name: &str) -> Result<Vec<f64>, Error> {
    // SAFETY: the caller vouches for `count` numbers.
    let given = unsafe { elements(pointer, count, name)? };
    let mut copy = Error::reserve(count, name)?;
    copy.extend(given.map(f64::from));
    Ok(copy)
}
