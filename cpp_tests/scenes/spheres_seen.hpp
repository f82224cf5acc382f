// Pictures of many spheres, measured sphere by sphere.
#pragma once

#include "render.hpp"
#include "scenes.hpp"

#include <functional>
#include <vector>

/// A pixel that shows a sphere and nothing else.
struct Seen {
    render::Rgb radiance;
    render::V3f normal;
    float cosine; ///< between the normal and the direction to the camera
};

class SpheresSeen {
public:
    /// A scene of rows and columns as in spheres.hpp; `size` as the program's --size.
    SpheresSeen(const std::string &scene, const render::Environment &environment, int rows, int columns,
                int size, int samplesPerPixel);

    const std::vector<Seen> &at(int row, int column) const;

private:
    int columns_;
    std::vector<std::vector<Seen>> spheres_;
};

/// Of those for which `of` holds; at least one.
render::Rgb meanRadiance(const std::vector<Seen> &pixels, const std::function<bool(const Seen &)> &of);

/// Of the luminance where the cosine is above 0.5: standard deviation from left to right, within bands of
/// equal height, over mean. What changes with height alone, as films do here, is no contrast.
double contrast(const std::vector<Seen> &pixels);
