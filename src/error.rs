//! What can go wrong, and how it is said.

use std::borrow::Cow;
use std::fmt;

/// The kind of a failure; the C interface returns its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Status {
    /// A NULL pointer, a wrong count, overlapping or contradictory arguments.
    InvalidArgument = 1,
    /// A model, parameter or choice of that name does not exist.
    UnknownName = 2,
    /// A number is outside its range, or NaN or infinite.
    OutOfRange = 3,
    /// This build does not offer what was asked for.
    Unsupported = 4,
    /// An allocation failed.
    OutOfMemory = 5,
    /// A defect of the library itself.
    Internal = 6,
}

/// A failure: its kind, and a sentence that names the parameter, the value and what is allowed.
#[derive(Clone, Debug)]
pub struct Error {
    /// The kind.
    pub status: Status,
    /// The sentence.
    pub message: Cow<'static, str>,
}

impl Error {
    pub(crate) fn new(status: Status, message: impl Into<Cow<'static, str>>) -> Self {
        Self {
            status,
            message: message.into(),
        }
    }

    pub(crate) fn invalid(message: impl Into<Cow<'static, str>>) -> Self {
        Self::new(Status::InvalidArgument, message)
    }

    pub(crate) fn out_of_range(message: impl Into<Cow<'static, str>>) -> Self {
        Self::new(Status::OutOfRange, message)
    }

    pub(crate) fn unsupported(message: impl Into<Cow<'static, str>>) -> Self {
        Self::new(Status::Unsupported, message)
    }

    /// An empty vector with room for so many, or "no memory for `what` of `bytes` bytes".
    pub(crate) fn reserve<T>(count: usize, what: &str) -> Result<Vec<T>, Self> {
        let mut vector = Vec::new();
        vector.try_reserve_exact(count).map_err(|_| {
            let bytes = count.saturating_mul(size_of::<T>());
            let message = format!("no memory for {what} of {bytes} bytes");
            Self::new(Status::OutOfMemory, message)
        })?;
        Ok(vector)
    }

    /// "unknown `kind` 'name'; known: a, b, c"
    pub(crate) fn unknown<'a>(
        kind: &str,
        name: &str,
        known: impl Iterator<Item = &'a str>,
    ) -> Self {
        let known = known.collect::<Vec<_>>().join(", ");
        Self::new(
            Status::UnknownName,
            format!("unknown {kind} '{name}'; known: {known}"),
        )
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Error {}
