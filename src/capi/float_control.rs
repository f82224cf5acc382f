//! The floating-point state of the calling thread. Rust, like C without `FENV_ACCESS`, assumes the default
//! rounding (to nearest) and masked exceptions: the boundary sets both where a host has changed them.
//!
//! Flush-to-zero and denormals-are-zero stay as the host has them. The x87 unit has a state of its own. The library's
//! code and the C library's mathematics on x86-64 Linux do not use that unit, but MinGW's mathematics do: on Windows
//! its rounding and masks are set and restored too.

/// Calls `body` under the default rounding with exceptions masked. The host's state, its exception flags
/// included, is restored afterwards, also if `body` panics. It is behind a pointer, so that no arithmetic of it can
/// be moved before.
pub(super) fn under_default<R>(body: &mut dyn FnMut() -> R) -> R {
    let host = register::read();
    if register::is_default(host) {
        return body();
    }
    let _restored = Restored(host);
    register::write(register::default_beside(host));
    body()
}

/// Calls `f` with upward rounding and tells whether the state is the same afterwards, but for raised flags. Nothing
/// in `f` may depend on the rounding but calls of entry points.
#[cfg(all(test, target_arch = "x86_64", not(miri)))]
pub(super) fn is_kept_by(f: impl FnOnce()) -> bool {
    const FLAGS: u32 = 0x3F;
    const UPWARD: u32 = 0x4000;
    let host = register::read();
    let before = register::Bits {
        mxcsr: host.mxcsr | UPWARD,
        ..host
    };
    let restored = Restored(host);
    register::write(before);
    f();
    let after = register::read();
    drop(restored);
    (after.mxcsr & !FLAGS, after.x87) == (before.mxcsr & !FLAGS, before.x87)
}

/// Whether traps were unmasked where a handle was made. Hosts that unmask them do so when they start.
#[derive(Clone, Copy)]
pub(super) struct Traps(bool);

impl Traps {
    /// None.
    pub const NONE: Self = Self(false);

    /// Those of the caller.
    pub fn of_caller() -> Self {
        Self(!register::is_default(register::read()))
    }

    /// Whether the state is the default, as a test of less than a nanosecond tells, which is enough for most calls:
    /// what it does not see is traps that the host unmasked in the SSE unit alone and after the handle was made.
    #[inline(always)]
    pub fn look_default(self) -> bool {
        register::looks_default(self.0)
    }
}

/// Writes the host's state when it is dropped.
struct Restored(register::Bits);

impl Drop for Restored {
    fn drop(&mut self) {
        register::write(self.0);
    }
}

/// MXCSR: Intel 64 manual, volume 1, section 10.2.3; the x87 control word: section 8.1.5.
#[cfg(all(target_arch = "x86_64", not(miri)))]
mod register {
    use std::arch::asm;

    #[derive(Clone, Copy)]
    pub struct Bits {
        pub mxcsr: u32,
        /// The x87 control word; the default where the library does not use that unit.
        pub x87: u16,
    }

    /// The masks of the six exceptions in MXCSR, bits 7 to 12.
    const MASKS: u32 = 0x1F80;
    /// The rounding, bits 13 and 14; 0 is to nearest.
    const ROUNDING: u32 = 0x6000;
    /// The flags of exceptions that have occurred, bits 0 to 5.
    const FLAGS: u32 = 0x3F;
    /// The masks in the x87 control word, bits 0 to 5.
    const X87_MASKS: u16 = 0x3F;
    /// Its rounding, bits 10 and 11; 0 is to nearest.
    const X87_ROUNDING: u16 = 0xC00;

    #[inline(always)]
    pub fn read() -> Bits {
        let mut mxcsr: u32 = 0;
        // SAFETY: writes four bytes to `mxcsr`.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut mxcsr, options(nostack, preserves_flags)) };
        let x87 = if cfg!(windows) { read_x87() } else { X87_MASKS };
        Bits { mxcsr, x87 }
    }

    #[inline(always)]
    fn read_x87() -> u16 {
        let mut control: u16 = 0;
        // SAFETY: writes two bytes to `control`.
        unsafe { asm!("fnstcw [{}]", in(reg) &raw mut control, options(nostack, preserves_flags)) };
        control
    }

    #[inline(always)]
    pub fn write(bits: Bits) {
        // SAFETY: reads four bytes; the reserved bits are as `read` found them.
        unsafe {
            asm!("ldmxcsr [{}]", in(reg) &raw const bits.mxcsr, options(nostack, preserves_flags));
        }
        if cfg!(windows) {
            // SAFETY: reads two bytes. Flags are cleared first: one whose trap is unmasked would fire.
            unsafe {
                asm!("fnclex", "fldcw [{}]", in(reg) &raw const bits.x87, options(nostack, preserves_flags));
            }
        }
    }

    #[inline(always)]
    pub fn is_default(bits: Bits) -> bool {
        bits.mxcsr & (MASKS | ROUNDING) == MASKS
            && bits.x87 & (X87_MASKS | X87_ROUNDING) == X87_MASKS
    }

    /// Whether a test finds the default, without reading MXCSR, which takes 15 cycles on Zen 4. The control word of
    /// the x87 unit tells whether traps are unmasked: whoever unmasks them by the C library's functions does so in
    /// both units. If it does not tell, `has_traps` does. The rounding is tried: to nearest, and only then,
    /// -0.75 becomes negative and -0.25 does not.
    #[inline(always)]
    pub fn looks_default(has_traps: bool) -> bool {
        #[repr(align(16))]
        struct Tried([f32; 4]);
        static TRIED: Tried = Tried([-0.75, -0.25, -0.75, -0.25]);
        // Before the conversion, which would be inexact.
        if read_x87() & X87_MASKS != X87_MASKS || has_traps {
            return false;
        }
        let signs: u32;
        // SAFETY: reads four numbers.
        unsafe {
            asm!(
                "cvtps2dq {numbers}, [{tried}]",
                "movmskps {signs:e}, {numbers}",
                tried = in(reg) &raw const TRIED.0,
                numbers = out(xmm_reg) _,
                signs = out(reg) signs,
                options(nostack, preserves_flags, readonly)
            );
        }
        signs == 0b0101
    }

    /// The default, with flush-to-zero and denormals-are-zero as in `bits`.
    pub fn default_beside(bits: Bits) -> Bits {
        Bits {
            mxcsr: bits.mxcsr & !(ROUNDING | FLAGS) | MASKS,
            x87: bits.x87 & !X87_ROUNDING | X87_MASKS,
        }
    }
}

/// FPCR: Arm Architecture Reference Manual for A-profile, section C5.2.8. Its flags are in FPSR.
#[cfg(all(target_arch = "aarch64", not(miri)))]
mod register {
    use std::arch::asm;

    /// FPCR and FPSR.
    pub type Bits = [u64; 2];

    /// The enabled traps: bits 8 to 12 and 15.
    const TRAPS: u64 = 0x9F00;
    /// The rounding, bits 22 and 23; 0 is to nearest.
    const ROUNDING: u64 = 0xC0_0000;

    #[inline(always)]
    pub fn read() -> Bits {
        let status;
        // SAFETY: reads a register that every program may read.
        unsafe { asm!("mrs {}, fpsr", out(reg) status, options(nomem, nostack, preserves_flags)) };
        [read_control(), status]
    }

    #[inline(always)]
    fn read_control() -> u64 {
        let control;
        // SAFETY: reads a register that every program may read.
        unsafe { asm!("mrs {}, fpcr", out(reg) control, options(nomem, nostack, preserves_flags)) };
        control
    }

    #[inline(always)]
    pub fn write([control, status]: Bits) {
        // SAFETY: the reserved bits are as `read` found them. Memory counts as used, so that results are
        // written before.
        unsafe {
            asm!("msr fpsr, {}", in(reg) status, options(nostack, preserves_flags));
            asm!("msr fpcr, {}", in(reg) control, options(nostack, preserves_flags));
        }
    }

    #[inline(always)]
    pub fn is_default([control, _]: Bits) -> bool {
        control & (TRAPS | ROUNDING) == 0
    }

    #[inline(always)]
    pub fn looks_default(_has_traps: bool) -> bool {
        is_default([read_control(), 0])
    }

    /// The default, with flush-to-zero as in `bits`.
    pub fn default_beside([control, status]: Bits) -> Bits {
        [control & !(TRAPS | ROUNDING), status]
    }
}

/// Other processors (WebAssembly has one rounding and no traps), and the interpreter Miri.
#[cfg(any(miri, not(any(target_arch = "x86_64", target_arch = "aarch64"))))]
mod register {
    pub type Bits = ();

    #[inline(always)]
    pub fn read() -> Bits {}

    pub fn write((): Bits) {}

    #[inline(always)]
    pub fn is_default((): Bits) -> bool {
        true
    }

    #[inline(always)]
    pub fn looks_default(_has_traps: bool) -> bool {
        true
    }

    pub fn default_beside((): Bits) -> Bits {}
}
