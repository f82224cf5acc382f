#include "lighting.hpp"

#include "landscape.hpp"
#include "studio.hpp"

#include <cmath>
#include <cstdlib>
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

LatLongMap evening() {
    const char *e = std::getenv("HERO_ENV"), *r = std::getenv("HERO_TURN"), *c = std::getenv("HERO_CLAMP"), *g = std::getenv("HERO_GAIN");
    LatLongMap map = readLatLongMap(std::string("/usr/share/blender/datafiles/studiolights/world/") + (e ? e : "sunset") + ".exr");
    const int turn = int(std::lround((r ? std::atof(r) : 0) / 360 * map.width));
    LatLongMap result = map;
    const float limit = c ? std::atof(c) : 60, gain = g ? std::atof(g) : 1;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            Rgb t = map.texels[y * map.width + (x + turn + map.width) % map.width];
            const float m = maxComponent(t);
            if (m > limit) t *= limit / m;
            const std::vector<SoftBox> boxes{
                {-68, 22, 16, 60, 0, Rgb(3.2f, 3.1f, 3.0f)}, {66, 24, 12, 56, 0, Rgb(2.6f, 2.8f, 3.2f)},
                {-150, 58, 60, 26, 0, Rgb(1.6f, 1.6f, 1.6f)}, {0, 27, 70, 30, 0, Rgb(2.5f, 2.5f, 2.6f)}};
            const V3f d = latLongDirection((x + 0.5f) / map.width, std::cos(pi * (y + 0.5f) / map.height));
            result.texels[y * map.width + x] = t * gain + (std::getenv("NOBOX") ? Rgb(0) : lightOf(boxes, d));
        }
    return result;
}

} // namespace

Environment environmentOf(Lighting lighting, const std::filesystem::path &directory) {
    // Both maps have about as many texels.
    constexpr int latLongHeight = 1024, cubeSize = 600;
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
            writtenAndRead(drawCube(cubeSize, Landscape()), (directory / "landscape.").string()));
    }
    throw std::logic_error("an unknown lighting");
}

} // namespace render
