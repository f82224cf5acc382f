#include "strided.hpp"

namespace support {

namespace {

std::ptrdiff_t words(std::size_t count) {
    return static_cast<std::ptrdiff_t>(count) * word;
}

} // namespace

const std::vector<Layout> layouts = {
    {"array of structs",
     [](std::size_t n, std::size_t c) { return Place{n * c * 4, 0, words(c), word}; }},
    {"structs with something in between",
     [](std::size_t n, std::size_t c) { return Place{n * (c + 2) * 4, 4, words(c + 2), word}; }},
    {"struct of arrays",
     [](std::size_t n, std::size_t c) { return Place{n * c * 4, 0, word, words(n)}; }},
    {"elements backwards",
     [](std::size_t n, std::size_t c) { return Place{n * c * 4, n == 0 ? 0 : (n - 1) * c * 4, -words(c), word}; }},
    {"components backwards",
     [](std::size_t n, std::size_t c) { return Place{n * c * 4, (c - 1) * 4, words(c), -word}; }},
    {"unaligned",
     [](std::size_t n, std::size_t c) { return Place{n * (c * 4 + 1) + 1, 1, words(c) + 1, word}; }},
    {"unaligned planes",
     [](std::size_t n, std::size_t c) { return Place{(n * 4 + 1) * c + 3, 3, word, words(n) + 1}; }},
};

} // namespace support
