// What pellicle's static library holds of memory. The linker's option --wrap sends the allocations of everything
// linked statically through counters; the shared libraries (OpenImageIO, Embree and its threads, the C++ library and
// with it every `new`) keep the C library's functions.
#pragma once

struct HeldMemory {
    long blocks, bytes;

    bool operator==(const HeldMemory &other) const { return blocks == other.blocks && bytes == other.bytes; }
};

/// What is allocated and not given back.
HeldMemory heldMemory();

/// Leaks that many bytes where pellicle's allocations are counted, to prove that a leak is found.
void leak(int bytes);
