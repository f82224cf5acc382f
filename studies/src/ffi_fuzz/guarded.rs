//! Memory between two pages that nobody may touch.

use std::ptr::null_mut;

/// Bytes whose end, or whose beginning, is beside an inaccessible page: an access beyond stops the
/// program.
pub struct Guarded {
    mapping: *mut u8,
    mapped: usize,
    begin: usize,
    length: usize,
}

impl Guarded {
    /// `length` bytes, all `fill`, at the end of the room or at its beginning.
    pub fn new(length: usize, at_end: bool, fill: u8) -> Self {
        // SAFETY: memory of our own, unmapped by drop().
        unsafe {
            let page = libc::sysconf(libc::_SC_PAGESIZE) as usize;
            let room = length.next_multiple_of(page);
            let mapped = room + 2 * page;
            let (protection, kind) = (libc::PROT_NONE, libc::MAP_PRIVATE | libc::MAP_ANONYMOUS);
            let mapping = libc::mmap(null_mut(), mapped, protection, kind, -1, 0);
            assert_ne!(mapping, libc::MAP_FAILED);
            let mapping = mapping.cast::<u8>();
            if room > 0 {
                let writable = libc::PROT_READ | libc::PROT_WRITE;
                assert_eq!(libc::mprotect(mapping.add(page).cast(), room, writable), 0);
            }
            let begin = if at_end { page + room - length } else { page };
            let mut guarded = Self {
                mapping,
                mapped,
                begin,
                length,
            };
            guarded.bytes_mut().fill(fill);
            guarded
        }
    }

    pub fn pointer(&self) -> *mut u8 {
        // SAFETY: within the mapping.
        unsafe { self.mapping.add(self.begin) }
    }

    pub fn bytes(&self) -> &[u8] {
        // SAFETY: readable; calls that write it are over.
        unsafe { std::slice::from_raw_parts(self.pointer(), self.length) }
    }

    pub fn bytes_mut(&mut self) -> &mut [u8] {
        // SAFETY: writable, and borrowed for as long.
        unsafe { std::slice::from_raw_parts_mut(self.pointer(), self.length) }
    }
}

impl Drop for Guarded {
    fn drop(&mut self) {
        // SAFETY: mapped by `new`.
        unsafe { libc::munmap(self.mapping.cast(), self.mapped) };
    }
}
