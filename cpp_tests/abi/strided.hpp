// Arrays in memory as batches address them: layouts, and arrays that tell what was written.
#pragma once

#include "support.hpp"

#include <cstring>
#include <functional>
#include <memory>

namespace support {

// Where component c of element i of an array lives: begin + i * element + c * component, in bytes.
struct Place {
    std::size_t bytes, begin;
    std::ptrdiff_t element, component;

    std::ptrdiff_t offset(std::size_t i, std::size_t c) const {
        return static_cast<std::ptrdiff_t>(begin) + static_cast<std::ptrdiff_t>(i) * element +
               static_cast<std::ptrdiff_t>(c) * component;
    }
};

struct Layout {
    const char *name;
    // Of `count` elements with `components` floats each.
    std::function<Place(std::size_t count, std::size_t components)> place;
};

constexpr std::ptrdiff_t word = sizeof(float);

// Packed, padded, planar, backwards, unaligned.
extern const std::vector<Layout> layouts;

// An array in one of the layouts; reading beyond its end stops the program, and what lies between
// its elements must keep its pattern.
class Strided {
public:
    Strided(const Layout &layout, std::size_t count, std::size_t components)
        : place_(layout.place(count, components)), count_(count), components_(components),
          bytes_(std::make_unique<GuardedBytes>(place_.bytes)) {
        std::memset(data(), pattern, place_.bytes);
    }

    void set(std::size_t i, std::size_t c, float value) { std::memcpy(at(i, c), &value, sizeof value); }
    float get(std::size_t i, std::size_t c) const {
        float value;
        std::memcpy(&value, at(i, c), sizeof value);
        return value;
    }

    PellicleView view() const { return {reinterpret_cast<float *>(data() + place_.begin), place_.element, place_.component}; }
    PellicleConstView const_view() const { return {view().data, place_.element, place_.component}; }
    PellicleUintView uint_view() const { return {reinterpret_cast<std::uint32_t *>(view().data), place_.element}; }

    bool rest_untouched() const {
        std::vector<bool> named(place_.bytes);
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t c = 0; c < components_; ++c)
                for (std::ptrdiff_t byte = 0; byte < word; ++byte)
                    named[static_cast<std::size_t>(place_.offset(i, c) + byte)] = true;
        for (std::size_t byte = 0; byte < place_.bytes; ++byte)
            if (!named[byte] && data()[byte] != pattern) return false;
        return true;
    }

private:
    static constexpr unsigned char pattern = 0x5A;

    unsigned char *data() const { return bytes_->as<unsigned char>(); }
    unsigned char *at(std::size_t i, std::size_t c) const { return data() + place_.offset(i, c); }

    Place place_;
    std::size_t count_, components_;
    std::unique_ptr<GuardedBytes> bytes_;
};

} // namespace support
