#include "lighting.hpp"

#include "cube_map.hpp"
#include "landscape.hpp"
#include "studio.hpp"

#include <algorithm>
#include <stdexcept>

namespace render {

namespace {

LatLongMap writtenAndRead(const LatLongMap &map, const std::filesystem::path &file) {
    writeRadiance({map.width, map.height, map.texels}, file);
    return readLatLongMap(file);
}

CubeMap writtenAndRead(const CubeMap &map, const std::string &prefix) {
    writeCubeMap(map, prefix);
    return readCubeMap(prefix);
}

} // namespace

namespace {

/// A photograph of a quay at sunset (G. Zaal, CC0), turned so that the sun is behind the camera on the right, and
/// what a photographer adds: soft boxes at both sides, above the camera and above the picture's upper edge, where
/// wet ground reflects it. The sun is dimmed to a soft one.
LatLongMap evening() {
    constexpr float turn = 205, brightest = 14;
    const std::vector<SoftBox> boxes{{-68, 22, 16, 60, 0, Rgb(3.2f, 3.1f, 3.0f)},
                                     {66, 24, 12, 56, 0, Rgb(2.6f, 2.8f, 3.2f)},
                                     {-150, 58, 60, 26, 0, Rgb(1.6f, 1.6f, 1.6f)},
                                     {0, 36, 90, 38, 0, Rgb(2.6f, 2.6f, 2.7f)}};
    const LatLongLight photograph(readLatLongMap(PELLICLE_RENDER_PANORAMA));
    return drawLatLong(512, [&](const V3f &direction) {
        const float c = std::cos(radians(turn)), s = std::sin(radians(turn));
        Rgb light = photograph.radiance(V3f(c * direction.x - s * direction.z, direction.y, s * direction.x + c * direction.z));
        light *= std::min(1.0f, brightest / std::max(maxComponent(light), 1e-6f));
        return light + lightOf(boxes, direction);
    });
}

} // namespace

Environment environmentOf(Lighting lighting, const std::filesystem::path &directory) {
    constexpr int latLongHeight = 1024, cubeSize = 256;
    switch (lighting) {
    case Lighting::evening: return Environment(evening());
    case Lighting::studio: return Environment(studio());
    case Lighting::darkRoom: return Environment(darkRoom());
    case Lighting::tent: return Environment(tent());
    case Lighting::sky: return Environment(cloudedSky());
    case Lighting::window: return Environment(windowRoom());
    case Lighting::spot: return Environment(spotInRoom());
    case Lighting::front: return Environment(frontLamp());
    case Lighting::lamp: return Environment(lamp());
    case Lighting::landscape:
        makeDirectory(directory);
        return Environment(
            writtenAndRead(drawLatLong(latLongHeight, Landscape()), directory / "landscape.exr"));
    case Lighting::landscapeCube:
        makeDirectory(directory);
        return Environment(
            unrolled(writtenAndRead(drawCube(cubeSize, Landscape()), (directory / "landscape.").string())));
    }
    throw std::logic_error("an unknown lighting");
}

} // namespace render
