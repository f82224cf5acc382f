// Light sampling, BSDF sampling and both together are three ways to the same picture.

#include "scenes.hpp"
#include "statistics.hpp"

#include <doctest/doctest.h>

#include <ostream>

using namespace render;

namespace {

/// Uneven everywhere, with colours, and nowhere so narrow that BSDF sampling would not find it.
Environment mottledSky() {
    LatLongMap map{16, 8, {}};
    for (int i = 0; i < map.width * map.height; ++i) {
        const auto wave = [i](int step) { return 0.1f + 2.0f * static_cast<float>(i * step % 17 == 3); };
        map.texels.push_back(Rgb(wave(1), wave(5), wave(7)));
    }
    return Environment(map);
}

void checkTechniquesAgree(const std::string &name) {
    const Environment sky = mottledSky();
    const std::vector<View> views = sceneNamed(name).views.make({});
    const View &view = views.front();
    RenderSettings settings;
    settings.width = settings.height = 32;
    const auto mean = [&](Technique technique) {
        settings.path.technique = technique;
        return pictureMean(16, [&](std::uint32_t seed) {
            // Seeds of their own, so that the estimates compared are independent.
            settings.seed = seed + 1000 * static_cast<std::uint32_t>(technique);
            return renderPicture(*view.world, sky, view.camera, settings);
        });
    };
    const RgbEstimate combined = mean(Technique::combined);
    for (const Technique technique : {Technique::light, Technique::bsdf}) {
        CAPTURE(static_cast<int>(technique));
        const RgbEstimate single = mean(technique);
        for (int c = 0; c < 3; ++c) {
            CAPTURE(c);
            CAPTURE(combined[c].mean);
            CAPTURE(single[c].mean);
            CAPTURE(combined[c].standardError);
            CAPTURE(single[c].standardError);
            CHECK(single[c].standardError < 0.01 * single[c].mean);
            CHECK(agree(combined[c], single[c]));
        }
    }
}

} // namespace

TEST_SUITE_BEGIN("techniques");

TEST_CASE("techniques agree: diffuse layer") { checkTechniquesAgree("fig2-colourful"); }
TEST_CASE("techniques agree: deviated layer") { checkTechniquesAgree("fig5-medium"); }
TEST_CASE("techniques agree: bumpy layer") { checkTechniquesAgree("fig4-oil"); }
TEST_CASE("techniques agree: layer that conserves energy") { checkTechniquesAgree("fig5-thick-energy"); }

TEST_SUITE_END();
