#include "pages.hpp"

#ifdef _WIN32
#include <windows.h>
#else
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace pages {

#ifdef _WIN32

std::size_t page_size() {
    SYSTEM_INFO info;
    GetSystemInfo(&info);
    return info.dwPageSize;
}

void *map(std::size_t size, bool accessible) {
    return VirtualAlloc(nullptr, size, MEM_RESERVE | MEM_COMMIT, accessible ? PAGE_READWRITE : PAGE_NOACCESS);
}

bool forbid(void *start, std::size_t size) {
    DWORD before;
    return VirtualProtect(start, size, PAGE_NOACCESS, &before) != 0;
}

void unmap(void *start, std::size_t) { VirtualFree(start, 0, MEM_RELEASE); }

std::size_t bytes_in_use() {
    const HANDLE heap = GetProcessHeap();
    std::size_t bytes = 0;
    PROCESS_HEAP_ENTRY entry{};
    HeapLock(heap);
    while (HeapWalk(heap, &entry))
        if (entry.wFlags & PROCESS_HEAP_ENTRY_BUSY) bytes += entry.cbData;
    HeapUnlock(heap);
    return bytes;
}

#else

std::size_t page_size() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }

void *map(std::size_t size, bool accessible) {
    const int access = accessible ? PROT_READ | PROT_WRITE : PROT_NONE;
    void *start = mmap(nullptr, size, access, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return start == MAP_FAILED ? nullptr : start;
}

bool forbid(void *start, std::size_t size) { return mprotect(start, size, PROT_NONE) == 0; }

void unmap(void *start, std::size_t size) { munmap(start, size); }

std::size_t bytes_in_use() { return mallinfo2().uordblks; }

#endif

} // namespace pages
