// A loop on several cores.
#pragma once

#include <functional>

namespace render {

/// Calls `body` with 0 to count - 1, each once, in any order and from several threads; 0 threads: one
/// per core. What `body` throws is thrown here.
void parallelFor(int count, int threads, const std::function<void(int)> &body);

} // namespace render
