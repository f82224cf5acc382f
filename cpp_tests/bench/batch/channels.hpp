// A table's channels apart, for loops over structures of arrays.
#pragma once

#include "vectorised.hpp"

#include <vector>

struct Channels {
    std::vector<float> r, g, b;

    explicit Channels(const std::vector<float> &rgb) {
        for (std::size_t i = 0; i < rgb.size(); i += 3) {
            r.push_back(rgb[i]);
            g.push_back(rgb[i + 1]);
            b.push_back(rgb[i + 2]);
        }
    }

    vectorised::FilmPlanes planes() const { return {r.data(), g.data(), b.data()}; }
};
