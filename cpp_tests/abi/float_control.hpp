// The floating-point control register of the calling thread, as hosts set it.
#pragma once

#include <cstdint>

#if defined(__x86_64__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace float_control {

#if defined(__x86_64__) || defined(_M_X64)

// MXCSR. Denormals-are-zero is bit 6; exceptions are masked by bits 7 to 12; the lowest six bits are flags of
// exceptions that have occurred.
using Bits = std::uint32_t;
constexpr Bits flush = 0x8040;
constexpr Bits rounding_down = 0x2000, rounding_up = 0x4000, rounding_to_zero = 0x6000;
constexpr Bits flags = 0x3F, masks = 0x1F80;
inline Bits read() { return _mm_getcsr(); }
inline void write(Bits bits) { _mm_setcsr(bits); }
inline Bits trapping(Bits bits) { return bits & ~(masks | flags); }
inline bool is_trapping(Bits bits) { return (bits & masks) != masks; }
// The C library's functions unmask traps in the x87 unit, too, where they are the lowest six bits of its word.
inline void unmask_x87(bool unmask) {
    std::uint16_t word;
    __asm__ volatile("fnstcw %0" : "=m"(word));
    word = static_cast<std::uint16_t>(unmask ? word & ~0x3F : word | 0x3F);
    __asm__ volatile("fnclex\n\tfldcw %0" ::"m"(word));
}

#elif defined(__aarch64__)

// FPCR: flush-to-zero is bit 24, traps are enabled by bits 8 to 12 and 15, where the processor has traps. The
// flags are in FPSR, and are bits 32 and up here.
using Bits = std::uint64_t;
constexpr Bits flush = Bits{1} << 24;
constexpr Bits rounding_down = Bits{2} << 22, rounding_up = Bits{1} << 22, rounding_to_zero = Bits{3} << 22;
constexpr Bits flags = Bits{0x9F} << 32;
inline Bits read() {
    std::uint64_t control, status;
    __asm__ volatile("mrs %0, fpcr" : "=r"(control));
    __asm__ volatile("mrs %0, fpsr" : "=r"(status));
    return control | status << 32;
}
inline void write(Bits bits) {
    __asm__ volatile("msr fpsr, %0" ::"r"(bits >> 32) : "memory");
    __asm__ volatile("msr fpcr, %0" ::"r"(bits & 0xFFFFFFFF) : "memory");
}
// Without traps, as in most processors and in qemu, the register keeps none of the bits that enable them.
inline Bits trapping(Bits bits) {
    const Bits before = read();
    write(before | 0x9F00);
    const Bits enabled = read() & 0x9F00;
    write(before);
    return (bits & ~flags) | enabled;
}
inline bool is_trapping(Bits bits) { return bits & 0x9F00; }
inline void unmask_x87(bool) {}

#endif

// Sets the register for as long as it lives, as feenableexcept() and fesetround() do.
class Scope {
public:
    explicit Scope(Bits bits) : saved_(read()) {
        if (is_trapping(bits)) unmask_x87(true);
        write(bits);
    }
    ~Scope() {
        write(saved_);
        unmask_x87(false);
    }
    Scope(const Scope &) = delete;
    Scope &operator=(const Scope &) = delete;

private:
    Bits saved_;
};

} // namespace float_control
