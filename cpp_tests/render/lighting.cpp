#include "lighting.hpp"

#include "landscape.hpp"
#include "studio.hpp"

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

Environment environmentOf(Lighting lighting, const std::filesystem::path &directory) {
    // Both maps have about as many texels.
    constexpr int latLongHeight = 1024, cubeSize = 600;
    switch (lighting) {
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
