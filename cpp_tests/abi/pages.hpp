// Pages of memory with and without access, on POSIX systems and Windows, and the count of what is allocated.
#pragma once

#include <cstddef>

namespace pages {

// Bytes in a page.
std::size_t page_size();

// Bytes of new memory, which may be read and written or not touched at all; null if there is none.
void *map(std::size_t size, bool accessible);

// From now on nothing may touch these bytes, whole pages. False if the system refuses.
bool forbid(void *start, std::size_t size);

// Gives back what map() gave.
void unmap(void *start, std::size_t size);

// What the program has allocated and not given back; the allocator's own caches count.
std::size_t bytes_in_use();

} // namespace pages
