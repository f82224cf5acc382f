#include "render.hpp"

#include "parallel.hpp"

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

#include <algorithm>

namespace render {
namespace {

constexpr int tileSize = 16;

/// Embree's manual, section "Performance Recommendations", asks for both.
void flushDenormals() {
#if defined(__SSE2__)
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#endif
}

/// A place in the pixel, distributed as a tent that reaches into the neighbours: filter importance
/// sampling (M. Ernst, M. Stamminger and G. Greiner, "Filter Importance Sampling", RT 2006), which
/// keeps pixels independent of one another.
float tent(float u) { return u < 0.5f ? std::sqrt(2 * u) - 0.5f : 1.5f - std::sqrt(2 - 2 * u); }

class Job {
public:
    Job(const World &world, const Environment &environment, const Camera &camera,
        const RenderSettings &settings, const std::function<void(int)> &pixelsDone)
        : world_(world),
          environment_(environment),
          camera_(camera),
          settings_(settings),
          pixelsDone_(pixelsDone),
          columns_((settings.width + tileSize - 1) / tileSize),
          tiles_(columns_ * ((settings.height + tileSize - 1) / tileSize)),
          picture_{settings.width, settings.height, {}} {
        picture_.pixels.resize(static_cast<std::size_t>(settings.width) * settings.height);
    }

    Picture run() {
        parallelFor(tiles_, settings_.threads, [this](int tile) { renderTile(tile); });
        return std::move(picture_);
    }

private:

    void renderTile(int tile) {
        flushDenormals();
        const V2i first(tile % columns_ * tileSize, tile / columns_ * tileSize);
        const V2i end(std::min(first.x + tileSize, settings_.width),
                      std::min(first.y + tileSize, settings_.height));
        Sampler sampler(settings_.samplesPerPixel, settings_.seed);
        for (int y = first.y; y < end.y; ++y)
            for (int x = first.x; x < end.x; ++x)
                picture_.pixels[static_cast<std::size_t>(y) * settings_.width + x] =
                    renderPixel({x, y}, sampler);
        if (pixelsDone_) pixelsDone_((end.x - first.x) * (end.y - first.y));
    }

    Pixel renderPixel(V2i pixel, Sampler &sampler) const {
        Pixel sum;
        for (int sample = 0; sample < settings_.samplesPerPixel; ++sample) {
            sampler.start(pixel, sample);
            const auto [x, y, lens, turn] = sampler.next();
            const V2f raster(static_cast<float>(pixel.x) + tent(x), static_cast<float>(pixel.y) + tent(y));
            FirstHit firstHit;
            sum.radiance += radiance(camera_.ray(raster, {settings_.width, settings_.height}, {lens, turn}), world_,
                                     environment_, settings_.path, sampler, firstHit);
            sum.normal += firstHit.normal;
            sum.distance += firstHit.distance;
        }
        const float share = 1 / static_cast<float>(settings_.samplesPerPixel);
        return {sum.radiance * share, sum.normal * share, sum.distance * share};
    }

    const World &world_;
    const Environment &environment_;
    const Camera &camera_;
    const RenderSettings &settings_;
    const std::function<void(int)> &pixelsDone_;
    const int columns_, tiles_;
    Picture picture_;
};

} // namespace

Picture renderPicture(const World &world, const Environment &environment, const Camera &camera,
                      const RenderSettings &settings, const std::function<void(int)> &pixelsDone) {
    return Job(world, environment, camera, settings, pixelsDone).run();
}

} // namespace render
