// One small picture per figure, of a film and of the 25 spheres, compared with the one that was looked
// at and checked in. With the environment variable PELLICLE_RENEW_GOLDENS set the pictures are written
// instead: look at them before checking them in.

#include "picture.hpp"
#include "render.hpp"
#include "scenes.hpp"

#include <OpenImageIO/imagebufalgo.h>
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

using namespace render;

namespace {

/// Another processor may round differently, send a path elsewhere and so change its pixel: 2 % of
/// the pixels may differ by more than 3 levels of 255.
constexpr float tolerance = 3.0f / 255, tolerated = 0.02f;

/// The first view of a scene, or the second, which shows `mesh`.
OIIO::ImageBuf renderSmall(const std::string &name, const std::shared_ptr<const Mesh> &mesh) {
    const Scene &scene = sceneNamed(name);
    const std::size_t shown = mesh ? 1 : 0;
    const V2f &extent = scene.views.extents.at(shown);
    RenderSettings settings;
    settings.width = static_cast<int>(std::lround(64 * extent.x));
    settings.height = static_cast<int>(std::lround(64 * extent.y));
    settings.samplesPerPixel = 32;
    settings.seed = 1;
    settings.path.maxBounces = scene.maxBounces;
    const std::vector<View> views = scene.views.make({"mesh", mesh});
    const View &view = views.at(shown);
    const Picture picture =
        renderPicture(*view.world, environmentOf(scene.lighting, std::filesystem::temp_directory_path()),
                      view.camera, settings);
    return display(picture, scene.exposure);
}

void checkGolden(const std::string &name, const std::shared_ptr<const Mesh> &mesh = nullptr) {
    const std::filesystem::path file = std::filesystem::path(GOLDEN_DIRECTORY) / (name + ".png");
    const OIIO::ImageBuf rendered = renderSmall(name, mesh);
    if (std::getenv("PELLICLE_RENEW_GOLDENS")) {
        writePng(rendered, file);
        return;
    }
    OIIO::ImageBuf golden(file.string());
    REQUIRE_MESSAGE(golden.read(0, 0, true, OIIO::TypeFloat), golden.geterror());
    const auto difference = OIIO::ImageBufAlgo::compare(rendered, golden, tolerance, tolerance);
    const auto pixels = static_cast<float>(golden.spec().image_pixels());
    CAPTURE(difference.nfail);
    CAPTURE(difference.maxerror);
    CAPTURE(difference.meanerror);
    CHECK(static_cast<float>(difference.nfail) <= tolerated * pixels);
}

} // namespace

TEST_SUITE_BEGIN("goldens");

TEST_CASE("golden of figure 2") { checkGolden("fig2-colourful"); }

TEST_CASE("golden of figure 3, on a mesh") {
    auto bunny = std::make_shared<Mesh>(readObj(BUNNY));
    standOnFloor(*bunny);
    checkGolden("fig3-deviated", bunny);
}

TEST_CASE("golden of figure 4") { checkGolden("fig4-oil"); }

TEST_CASE("golden of figure 5") { checkGolden("fig5-medium"); }

TEST_CASE("golden of anodised titanium") { checkGolden("titanium"); }

TEST_CASE("golden of the 25 spheres") { checkGolden("spheres"); }

TEST_SUITE_END();
