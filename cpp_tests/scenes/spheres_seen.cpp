#include "spheres_seen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace render;

SpheresSeen::SpheresSeen(const std::string &name, const Environment &environment, int rows, int columns,
                         int size, int samplesPerPixel)
    : columns_(columns), spheres_(static_cast<std::size_t>(rows) * columns) {
    const Scene &scene = sceneNamed(name);
    const V2f &extent = scene.views.extents.at(0);
    RenderSettings settings;
    settings.width = static_cast<int>(std::lround(extent.x * static_cast<float>(size)));
    settings.height = static_cast<int>(std::lround(extent.y * static_cast<float>(size)));
    settings.samplesPerPixel = samplesPerPixel;
    const std::vector<View> views = scene.views.make({});
    const View &view = views.at(0);
    const Picture picture = renderPicture(*view.world, environment, view.camera, settings);

    const V2f middle(static_cast<float>(settings.width) / 2, static_cast<float>(settings.height) / 2);
    const V3f toCamera = -view.camera.ray(middle, {settings.width, settings.height}).direction;
    const auto each = [&](const std::function<void(int sphere, const Pixel &)> &visit) {
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x)
                visit(y * rows / settings.height * columns + x * columns / settings.width,
                      picture.pixels[static_cast<std::size_t>(y) * settings.width + x]);
    };
    // A point whose normal has this cosine is as much farther away than the sphere's nearest.
    std::vector<float> nearest(spheres_.size(), std::numeric_limits<float>::max());
    each([&](int sphere, const Pixel &pixel) {
        if (pixel.distance > 0 && dot(pixel.normal, toCamera) > 0.98f)
            nearest[sphere] = std::min(nearest[sphere], pixel.distance);
    });
    each([&](int sphere, const Pixel &pixel) {
        const V3f normal = pixel.normal.normalized();
        const float cosine = dot(normal, toCamera);
        // Pixels that show something else besides are at another distance.
        if (std::fabs(pixel.distance - (nearest[sphere] + 1 - cosine)) < 0.05f)
            spheres_[sphere].push_back({pixel.radiance, normal, cosine});
    });
}

const std::vector<Seen> &SpheresSeen::at(int row, int column) const {
    return spheres_.at(static_cast<std::size_t>(row) * columns_ + column);
}

Rgb meanRadiance(const std::vector<Seen> &pixels, const std::function<bool(const Seen &)> &of) {
    Rgb sum(0);
    float count = 0;
    for (const Seen &pixel : pixels) {
        if (!of(pixel)) continue;
        sum += pixel.radiance;
        ++count;
    }
    if (count == 0) throw std::runtime_error("no pixel to measure");
    return sum / count;
}

double contrast(const std::vector<Seen> &pixels) {
    constexpr int bands = 24; // from the sphere's bottom to its top
    struct Sums {
        double count = 0, sum = 0, squares = 0;
    };
    std::array<Sums, bands> sums;
    for (const Seen &pixel : pixels) {
        if (pixel.cosine < 0.5f) continue;
        Sums &band = sums[std::clamp(static_cast<int>((pixel.normal.y + 1) / 2 * bands), 0, bands - 1)];
        const double y = luminance(pixel.radiance);
        band.count += 1;
        band.sum += y;
        band.squares += y * y;
    }
    Sums all;
    for (const Sums &band : sums) {
        if (band.count == 0) continue;
        all.count += band.count;
        all.sum += band.sum;
        all.squares += band.squares - band.sum * band.sum / band.count;
    }
    return std::sqrt(std::max(0.0, all.squares / all.count)) / (all.sum / all.count);
}
