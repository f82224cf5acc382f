#include "held_memory.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>

#include <malloc.h>

namespace {

std::atomic<long> blocks{0}, bytes{0};

void *counted(void *block) {
    if (block) {
        ++blocks;
        bytes += static_cast<long>(malloc_usable_size(block));
    }
    return block;
}

void discount(void *block) {
    if (block) {
        --blocks;
        bytes -= static_cast<long>(malloc_usable_size(block));
    }
}

} // namespace

// The linker's option --wrap gives calls of malloc() to __wrap_malloc(), and calls of __real_malloc() to malloc().
extern "C" {

void *__real_malloc(std::size_t size);
void *__real_calloc(std::size_t count, std::size_t size);
void *__real_realloc(void *block, std::size_t size);
int __real_posix_memalign(void **block, std::size_t alignment, std::size_t size);
void *__real_aligned_alloc(std::size_t alignment, std::size_t size);
void __real_free(void *block);

void *__wrap_malloc(std::size_t size) { return counted(__real_malloc(size)); }
void *__wrap_calloc(std::size_t count, std::size_t size) { return counted(__real_calloc(count, size)); }

void *__wrap_realloc(void *block, std::size_t size) {
    const auto before = block ? static_cast<long>(malloc_usable_size(block)) : 0;
    void *const result = __real_realloc(block, size);
    if (!result) return nullptr; // the old block stays
    blocks += !block;
    bytes += static_cast<long>(malloc_usable_size(result)) - before;
    return result;
}

int __wrap_posix_memalign(void **block, std::size_t alignment, std::size_t size) {
    const int status = __real_posix_memalign(block, alignment, size);
    if (status == 0) counted(*block);
    return status;
}

void *__wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
    return counted(__real_aligned_alloc(alignment, size));
}

void __wrap_free(void *block) {
    discount(block);
    __real_free(block);
}

} // extern "C"

HeldMemory heldMemory() { return {blocks, bytes}; }

void leak(int size) {
    // A volatile pointer, because the compiler may drop an allocation that nothing uses.
    static void *volatile latest;
    if (size > 0) latest = std::malloc(static_cast<std::size_t>(size));
    static_cast<void>(latest);
}
