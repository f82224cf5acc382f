//! The frame of a saved film: what tells that a block is one, of this build and undamaged.
//!
//! | byte | |
//! |---|---|
//! | 0 | `pellfilm` |
//! | 8 | the format, 32 bits |
//! | 12 | the version of the library, filled up with 0 |
//! | 24 | the fingerprint of the library's sources and of its compiler, 64 bits |
//! | 32 | bytes of the contents, 64 bits |
//! | 40 | the checksum of the contents, 64 bits |
//! | 48 | the contents |

use crate::error::Error;
use crate::num::bytes::ByteWriter;

const MAGIC: [u8; 8] = *b"pellfilm";
/// The number of this frame.
const FORMAT: u32 = 1;
const HEADER: usize = 48;
/// The place of the contents' size, which the checksum follows.
const SIZE: usize = 32;

/// The version, filled up with 0.
const VERSION: [u8; 12] = {
    let text = env!("CARGO_PKG_VERSION").as_bytes();
    let mut version = [0; 12];
    let mut i = 0;
    while i < text.len() {
        version[i] = text[i];
        i += 1;
    }
    version
};
/// By build.rs, of all that decides which bits a film evaluates to.
const FINGERPRINT: u64 = {
    match u64::from_str_radix(env!("PELLICLE_FINGERPRINT"), 16) {
        Ok(number) => number,
        Err(_) => panic!("build.rs writes a hexadecimal number"),
    }
};

/// Writes the header, with size and checksum still 0.
pub(super) fn begin(block: &mut ByteWriter) {
    block.put(&MAGIC);
    block.put(&FORMAT.to_le_bytes());
    block.put(&VERSION);
    block.put(&FINGERPRINT.to_le_bytes());
    block.put(&[0; HEADER - SIZE]);
}

/// Enters size and checksum of the contents.
pub(super) fn seal(block: &mut [u8]) {
    let Some((header, contents)) = block.split_first_chunk_mut::<HEADER>() else {
        return;
    };
    let sealed = [contents.len() as u64, checksum(contents)];
    for (place, number) in header[SIZE..].chunks_exact_mut(8).zip(sealed) {
        place.copy_from_slice(&number.to_le_bytes());
    }
}

/// The contents of a block of this build.
pub(super) fn opened(block: &[u8]) -> Result<&[u8], Error> {
    let known = block.len().min(MAGIC.len());
    if block[..known] != MAGIC[..known] {
        return Err(Error::invalid(
            "block is no saved film: it does not begin with 'pellfilm'",
        ));
    }
    let Some((header, contents)) = block.split_first_chunk::<HEADER>() else {
        return Err(Error::invalid(format!(
            "block of {} bytes is truncated: a saved film has more than {HEADER}",
            block.len()
        )));
    };
    let number = |at: usize| u64::from_le_bytes(std::array::from_fn(|i| header[at + i]));
    let format = u32::from_le_bytes(std::array::from_fn(|i| header[8 + i]));
    if format != FORMAT {
        return Err(Error::unsupported(format!(
            "block has format {format}, and this library reads format {FORMAT}: create the film anew"
        )));
    }
    let (version, fingerprint) = (&header[12..24], number(24));
    if version != VERSION || fingerprint != FINGERPRINT {
        let printed = version.iter().filter(|byte| byte.is_ascii_graphic());
        let version: String = printed.map(|byte| char::from(*byte)).collect();
        return Err(Error::unsupported(format!(
            "block belongs to another build: {version} ({fingerprint:016x}), and this library is {} \
             ({FINGERPRINT:016x}): create the film anew",
            env!("CARGO_PKG_VERSION")
        )));
    }
    let (found, size) = (contents.len() as u64, number(SIZE));
    if found < size {
        let missing = size - found;
        return Err(Error::invalid(format!(
            "block of {} bytes is truncated: {missing} bytes are missing",
            block.len()
        )));
    }
    if found > size {
        let trailing = found - size;
        return Err(Error::invalid(format!(
            "block of {} bytes is too long: {trailing} bytes follow the film",
            block.len()
        )));
    }
    if checksum(contents) != number(SIZE + 8) {
        return Err(Error::invalid(
            "block is damaged: its checksum is not that of its contents",
        ));
    }
    Ok(contents)
}

/// Every step is invertible, so that a change within 8 bytes is always found; others are overlooked once in 2^64
/// times. The constant and the shift are of MurmurHash3's finalizer (Appleby 2011).
fn checksum(bytes: &[u8]) -> u64 {
    let mixed = |sum: u64, word: u64| {
        let product = (sum ^ word).wrapping_mul(0xff51_afd7_ed55_8ccd);
        product ^ (product >> 33)
    };
    let (words, rest) = bytes.as_chunks::<8>();
    let sum = words
        .iter()
        .fold(0, |sum, word| mixed(sum, u64::from_le_bytes(*word)));
    let last = std::array::from_fn(|i| rest.get(i).copied().unwrap_or_default());
    mixed(sum, u64::from_le_bytes(last))
}

/// Hidden: makes the header of any bytes right, for tests and fuzzers that look behind the checksum. Bytes shorter
/// than a header stay as they are.
#[doc(hidden)]
pub fn resealed(mut block: Vec<u8>) -> Vec<u8> {
    let mut header = ByteWriter::default();
    begin(&mut header);
    if let (Ok(header), Some(place)) = (header.finish(), block.get_mut(..HEADER)) {
        place.copy_from_slice(&header);
        seal(&mut block);
    }
    block
}
