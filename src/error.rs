//! Errors: a status for programs and a message for people.

use std::borrow::Cow;
use std::fmt;

/// The kind of a failure. Its number is what the C interface returns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Status {
    /// A pointer is NULL, a count is wrong, or arguments overlap or contradict each other.
    InvalidArgument = 1,
    /// Nothing of that name exists: a model, a parameter, a choice, a medium, a method or a level.
    UnknownName = 2,
    /// A number is outside its range, or NaN or infinite.
    OutOfRange = 3,
    /// The request is valid, but this version, this processor or the chosen method does not offer it.
    Unsupported = 4,
    /// An allocation failed.
    OutOfMemory = 5,
    /// The library has a defect.
    Internal = 6,
}

/// A failure: its kind, and a message that names the parameter, its value and what is allowed.
#[derive(Clone, Debug)]
pub struct Error {
    /// The kind of the failure.
    pub status: Status,
    /// The message, one sentence.
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

    /// An empty vector with room for `count` elements. If there is no memory, the message is "no memory for
    /// `what` of ... bytes".
    pub(crate) fn reserve<T>(count: usize, what: &str) -> Result<Vec<T>, Self> {
        let mut vector = Vec::new();
        let reserved = vector.try_reserve_exact(count);
        reserved.map_err(|_| Self::no_memory::<T>(count, what))?;
        Ok(vector)
    }

    /// Makes room for `more` elements in a vector, which may become longer still; otherwise as
    /// [`Error::reserve`].
    pub(crate) fn reserve_more<T>(
        vector: &mut Vec<T>,
        more: usize,
        what: &str,
    ) -> Result<(), Self> {
        let reserved = vector.try_reserve(more);
        reserved.map_err(|_| Self::no_memory::<T>(vector.len() + more, what))
    }

    fn no_memory<T>(count: usize, what: &str) -> Self {
        let bytes = count.saturating_mul(size_of::<T>());
        let message = format!("no memory for {what} of {bytes} bytes");
        Self::new(Status::OutOfMemory, message)
    }

    /// An error with the message "unknown `kind` '`name`'; known: a, b, c".
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
