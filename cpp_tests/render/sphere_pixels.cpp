#include "sphere_pixels.hpp"

namespace render {

std::vector<SpherePixel> spherePixels(int size) {
    std::vector<SpherePixel> pixels;
    const auto place = [&](int i) { return (2 * static_cast<float>(i) + 1) / static_cast<float>(size) - 1; };
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const float x = place(column), y = -place(row), rest = 1 - x * x - y * y;
            if (rest > 0) pixels.push_back({{column, row}, frameAround(V3f(x, y, std::sqrt(rest)).normalized())});
        }
    }
    return pixels;
}

} // namespace render
