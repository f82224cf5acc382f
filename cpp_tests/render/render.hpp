// Renders a picture on all cores.
#pragma once

#include "camera.hpp"
#include "integrator.hpp"
#include "picture.hpp"

#include <functional>

namespace render {

struct RenderSettings {
    int width = 256, height = 256;
    int samplesPerPixel = 16; ///< powers of two are stratified best
    std::uint32_t seed = 0;
    int threads = 0; ///< 0: one per core; the picture does not depend on it
    PathSettings path;
};

/// `pixelsDone`, if given, is told from any thread how many more pixels are finished.
Picture renderPicture(const World &world, const Environment &environment, const Camera &camera,
                      const RenderSettings &settings,
                      const std::function<void(int pixels)> &pixelsDone = nullptr);

} // namespace render
