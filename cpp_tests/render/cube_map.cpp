#include "cube_map.hpp"

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

namespace fs = std::filesystem;

/// The axes of a face in the world: of its centre, to its right and downwards.
struct Face {
    V3f centre, right, down;
};
const Face faces[6] = {
    {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},  {{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},  {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}}, {{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
};

fs::path findFace(const std::string &prefix, const char *face) {
    const auto fail = [&](const std::string &why) {
        throw std::runtime_error("cannot read the cube map " + prefix + "*: " + why);
    };
    const fs::path whole(prefix + face);
    const fs::path directory = whole.has_parent_path() ? whole.parent_path() : fs::path(".");
    std::vector<fs::path> found;
    std::error_code error;
    for (const fs::directory_entry &entry : fs::directory_iterator(directory, error))
        if (entry.path().stem() == whole.filename()) found.push_back(entry.path());
    if (error) fail(directory.string() + ": " + error.message());
    if (found.empty()) fail("there is no image " + whole.string() + ".*");
    if (found.size() > 1) fail("there are several images " + whole.string() + ".*");
    return found.front();
}

const char *const faceNames[6] = {"px", "nx", "py", "ny", "pz", "nz"};

} // namespace

CubeMap readCubeMap(const std::string &prefix) {
    CubeMap map{0, {}};
    for (int face = 0; face < 6; ++face) {
        const fs::path file = findFace(prefix, faceNames[face]);
        RadianceImage image = readRadiance(file, "cube map");
        if (face == 0) map.size = image.width;
        if (image.width != map.size || image.height != map.size)
            throw std::runtime_error("cannot read the cube map " + file.string() + ": it has " +
                                     std::to_string(image.width) + " x " + std::to_string(image.height) +
                                     " pixels instead of " + std::to_string(map.size) + " x " +
                                     std::to_string(map.size));
        map.faces[face] = std::move(image.texels);
    }
    return map;
}

void writeCubeMap(const CubeMap &map, const std::string &prefix) {
    for (int face = 0; face < 6; ++face)
        writeRadiance({map.size, map.size, map.faces[face]}, prefix + faceNames[face] + ".exr");
}

CubePoint cubePoint(const V3f &direction) {
    int face = 0;
    float depth = -1;
    for (int i = 0; i < 6; ++i) {
        const float along = dot(direction, faces[i].centre);
        if (along > depth) face = i, depth = along;
    }
    return {face, V2f(0.5f + 0.5f * dot(direction, faces[face].right) / depth,
                      0.5f + 0.5f * dot(direction, faces[face].down) / depth)};
}

V3f cubeDirection(const CubePoint &point) {
    const Face &face = faces[point.face];
    return (face.centre + face.right * (2 * point.st.x - 1) + face.down * (2 * point.st.y - 1)).normalized();
}

LatLongMap unrolled(const CubeMap &map) {
    return drawLatLong(4 * map.size, [&](const V3f &direction) {
        const CubePoint point = cubePoint(direction);
        const std::vector<Rgb> &face = map.faces[static_cast<std::size_t>(point.face)];
        // Beyond the centres of the outermost texels their values go on.
        const auto last = static_cast<float>(map.size - 1);
        const float x = std::clamp(point.st.x * static_cast<float>(map.size) - 0.5f, 0.0f, last);
        const float y = std::clamp(point.st.y * static_cast<float>(map.size) - 0.5f, 0.0f, last);
        const int column = std::min(static_cast<int>(x), std::max(map.size - 2, 0));
        const int row = std::min(static_cast<int>(y), std::max(map.size - 2, 0));
        const int right = std::min(column + 1, map.size - 1), below = std::min(row + 1, map.size - 1);
        const float s = x - static_cast<float>(column), t = y - static_cast<float>(row);
        const auto texel = [&](int i, int j) { return face[static_cast<std::size_t>(j) * map.size + i]; };
        return (texel(column, row) * (1 - s) + texel(right, row) * s) * (1 - t) +
               (texel(column, below) * (1 - s) + texel(right, below) * s) * t;
    });
}

} // namespace render
