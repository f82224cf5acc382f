//! Numbers and colours as little-endian bytes: what films are saved as and loaded from. Whoever reads may have been
//! given bytes of any kind, so that reading checks everything and asks for no more memory than the bytes can fill.
//!
//! What is called for single numbers is never inlined: loading would be three times as much code.

use super::TableEntry;
use crate::error::Error;

/// The greatest magnitude of a channel that is read: far beyond the colours of any film, and far from overflow.
const GREATEST_CHANNEL: f32 = 1e3;
/// Bytes of a colour.
const COLOR: usize = 12;

/// Bytes that grow. Once there is no memory for them, nothing more is written, and the end tells.
#[derive(Default)]
pub(crate) struct ByteWriter {
    bytes: Vec<u8>,
    failure: Option<Error>,
}

impl ByteWriter {
    #[inline(never)]
    pub fn put(&mut self, bytes: &[u8]) {
        if self.failure.is_some() {
            return;
        }
        match Error::reserve_more(&mut self.bytes, bytes.len(), "a film's block") {
            Ok(()) => self.bytes.extend_from_slice(bytes),
            Err(error) => self.failure = Some(error),
        }
    }

    #[inline(never)]
    pub fn byte(&mut self, number: u8) {
        self.put(&[number]);
    }

    pub fn flag(&mut self, is_set: bool) {
        self.byte(u8::from(is_set));
    }

    pub fn count(&mut self, count: usize) {
        self.put(&(count as u64).to_le_bytes());
    }

    #[inline(never)]
    pub fn numbers(&mut self, numbers: &[f64]) {
        for number in numbers {
            self.put(&number.to_le_bytes());
        }
    }

    pub fn color(&mut self, color: [f32; 3]) {
        let mut bytes = [0; COLOR];
        for (bytes, channel) in bytes.chunks_exact_mut(4).zip(color) {
            bytes.copy_from_slice(&channel.to_le_bytes());
        }
        self.put(&bytes);
    }

    pub fn colors(&mut self, colors: &[TableEntry<f32>]) {
        for color in colors {
            self.color(color.channels());
        }
    }

    /// All that was written; fails if there was no memory for it.
    pub fn finish(self) -> Result<Vec<u8>, Error> {
        self.failure.map_or(Ok(self.bytes), Err)
    }
}

/// The bytes that are still to be read.
pub(crate) struct ByteReader<'a>(pub &'a [u8]);

impl<'a> ByteReader<'a> {
    pub fn take(&mut self, count: usize) -> Result<&'a [u8], Error> {
        let (taken, left) = self.0.split_at_checked(count).ok_or_else(too_short)?;
        self.0 = left;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], Error> {
        let (taken, left) = self.0.split_first_chunk().ok_or_else(too_short)?;
        self.0 = left;
        Ok(*taken)
    }

    #[inline(never)]
    pub fn byte(&mut self) -> Result<u8, Error> {
        self.array().map(|[byte]| byte)
    }

    pub fn flag(&mut self) -> Result<bool, Error> {
        self.choice(&[false, true])
    }

    /// The choice of a number that was written as one byte.
    pub fn choice<T: Copy>(&mut self, choices: &[T]) -> Result<T, Error> {
        let number = self.byte()?;
        let choice = choices.get(usize::from(number)).copied();
        choice.ok_or_else(|| unfit("a choice", f64::from(number)))
    }

    /// A count of at most `greatest` elements of `bytes` each, which must be there.
    #[inline(never)]
    pub fn count(&mut self, bytes: usize, greatest: usize) -> Result<usize, Error> {
        let count = u64::from_le_bytes(self.array()?);
        if count > greatest as u64 {
            return Err(unfit("a count", count as f64));
        }
        self.check_left(count as usize, bytes)?;
        Ok(count as usize)
    }

    /// Refuses more elements of `bytes` each than there are bytes left.
    #[inline(never)]
    pub fn check_left(&self, count: usize, bytes: usize) -> Result<(), Error> {
        if count.saturating_mul(bytes) > self.0.len() {
            return Err(too_short());
        }
        Ok(())
    }

    /// A finite number.
    #[inline(never)]
    pub fn number(&mut self) -> Result<f64, Error> {
        let number = f64::from_le_bytes(self.array()?);
        if !number.is_finite() {
            return Err(unfit("a number", number));
        }
        Ok(number)
    }

    /// A number of a range; `what` names it.
    #[inline(never)]
    pub fn number_within(&mut self, what: &str, [min, max]: [f64; 2]) -> Result<f64, Error> {
        let number = self.number()?;
        if !(min..=max).contains(&number) {
            return Err(unfit(what, number));
        }
        Ok(number)
    }

    pub fn numbers<const N: usize>(&mut self) -> Result<[f64; N], Error> {
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            *number = self.number()?;
        }
        Ok(numbers)
    }

    #[inline(never)]
    pub fn color(&mut self) -> Result<[f32; 3], Error> {
        color(self.array()?)
    }

    /// `count` colours.
    pub fn colors(&mut self, count: usize) -> Result<Vec<TableEntry<f32>>, Error> {
        self.check_left(count, COLOR)?;
        let (bytes, _) = self.take(count * COLOR)?.as_chunks();
        let mut colors = Error::reserve(count, "a film's table")?;
        for bytes in bytes {
            colors.push(TableEntry::new(color(*bytes)?));
        }
        Ok(colors)
    }
}

fn color(bytes: [u8; COLOR]) -> Result<[f32; 3], Error> {
    let channel = |at: usize| f32::from_le_bytes(std::array::from_fn(|i| bytes[at + i]));
    let color = [0, 4, 8].map(channel);
    for channel in color {
        if channel.is_nan() || channel.abs() > GREATEST_CHANNEL {
            return Err(unfit("a colour", f64::from(channel)));
        }
    }
    Ok(color)
}

#[cold]
fn too_short() -> Error {
    unusable("it ends early")
}

#[cold]
fn unfit(what: &str, value: f64) -> Error {
    unusable(&format!("{what} is {value}"))
}

/// The refusal of bytes that no film is saved as.
#[cold]
pub(crate) fn unusable(why: &str) -> Error {
    Error::invalid(format!("block holds no film: {why}"))
}
