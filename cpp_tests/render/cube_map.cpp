#include "cube_map.hpp"

#include <algorithm>
#include <numeric>
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

/// The solid angle of a unit of area of the face's st square.
float solidAngleDensity(const V2f &st) {
    const float x = 2 * st.x - 1, y = 2 * st.y - 1, squared = 1 + x * x + y * y;
    return 4 / (squared * std::sqrt(squared));
}

int clampIndex(float x, int count) { return std::clamp(static_cast<int>(std::floor(x)), 0, count - 1); }

} // namespace

const std::array<const char *, 6> cubeFaceNames{"px", "nx", "py", "ny", "pz", "nz"};

CubeMap readCubeMap(const std::string &prefix) {
    CubeMap map{0, {}};
    for (int face = 0; face < 6; ++face) {
        const fs::path file = findFace(prefix, cubeFaceNames[face]);
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
        writeRadiance({map.size, map.size, map.faces[face]}, prefix + cubeFaceNames[face] + ".exr");
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

CubeLight::CubeLight(const CubeMap &map)
    : size_(map.size),
      texels_(6 * (map.size + 2) * (map.size + 2)) {
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < size_; ++row)
            for (int column = 0; column < size_; ++column)
                texel(face, column, row) = map.faces[face][static_cast<std::size_t>(row) * size_ + column];
    addBorders();

    // As for the latitude-longitude map the importance is the luminance of the bilinear interpolant,
    // integrated over the texel with the weights 1/8, 6/8, 1/8 along each axis.
    const auto along = [](float before, float here, float after) { return (before + 6 * here + after) / 8; };
    const auto across = [&](int face, int column, int row) {
        return along(luminance(texel(face, column - 1, row)), luminance(texel(face, column, row)),
                     luminance(texel(face, column + 1, row)));
    };
    std::vector<double> rowWeights;
    for (int face = 0; face < 6; ++face) {
        for (int row = 0; row < size_; ++row) {
            std::vector<double> weights;
            for (int column = 0; column < size_; ++column) {
                const V2f centre = V2f(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f) /
                                   static_cast<float>(size_);
                weights.push_back(solidAngleDensity(centre) * along(across(face, column, row - 1),
                                                                    across(face, column, row),
                                                                    across(face, column, row + 1)));
            }
            columns_.emplace_back(weights);
            rowWeights.push_back(std::accumulate(weights.begin(), weights.end(), 0.0));
        }
    }
    rows_ = Distribution(rowWeights);
}

Rgb CubeLight::radiance(const V3f &direction) const { return radianceAt(cubePoint(direction)); }

// Rows, then columns, as for the latitude-longitude map; within a texel uniform on the cube.
LightSample CubeLight::sample(const V2f &u) const {
    const Distribution::Point row = rows_.invert(u.y);
    const Distribution::Point column = columns_[row.cell].invert(u.x);
    const int rowOfFace = row.cell % size_;
    const CubePoint point{row.cell / size_, V2f(static_cast<float>(column.cell) + column.offset,
                                                static_cast<float>(rowOfFace) + row.offset) /
                                                static_cast<float>(size_)};
    return {cubeDirection(point), radianceAt(point), pdfAt(point, column.cell, rowOfFace)};
}

float CubeLight::pdf(const V3f &direction) const {
    const CubePoint point = cubePoint(direction);
    const auto size = static_cast<float>(size_);
    return pdfAt(point, clampIndex(point.st.x * size, size_), clampIndex(point.st.y * size, size_));
}

/// Columns and rows from -1 to the size.
Rgb &CubeLight::texel(int face, int column, int row) {
    const std::size_t side = static_cast<std::size_t>(size_) + 2;
    return texels_[(face * side + row + 1) * side + column + 1];
}
const Rgb &CubeLight::texel(int face, int column, int row) const {
    return const_cast<CubeLight *>(this)->texel(face, column, row);
}

// A border texel is the texel of the neighbouring face that touches it, so that both faces interpolate
// between the same two on their edge. At a corner three texels meet: the border's is their mean, which
// gives the corner that mean from all three faces.
void CubeLight::addBorders() {
    const auto size = static_cast<float>(size_);
    const auto beyond = [&](int face, float x, float y) {
        const CubePoint point = cubePoint(cubeDirection({face, V2f(x / size, y / size)}));
        return texel(point.face, clampIndex(point.st.x * size, size_), clampIndex(point.st.y * size, size_));
    };
    constexpr float little = 1e-3f; // of a texel: just over the edge
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < size_; ++i) {
            const float centre = static_cast<float>(i) + 0.5f;
            texel(face, i, -1) = beyond(face, centre, -little);
            texel(face, i, size_) = beyond(face, centre, size + little);
            texel(face, -1, i) = beyond(face, -little, centre);
            texel(face, size_, i) = beyond(face, size + little, centre);
        }
        for (const int outerRow : {-1, size_}) {
            for (const int outerColumn : {-1, size_}) {
                const int row = std::clamp(outerRow, 0, size_ - 1);
                const int column = std::clamp(outerColumn, 0, size_ - 1);
                texel(face, outerColumn, outerRow) =
                    (texel(face, column, row) + texel(face, outerColumn, row) +
                     texel(face, column, outerRow)) /
                    3.0f;
            }
        }
    }
}

Rgb CubeLight::radianceAt(const CubePoint &point) const {
    const float x = point.st.x * static_cast<float>(size_) - 0.5f;
    const float y = point.st.y * static_cast<float>(size_) - 0.5f;
    const int column = std::clamp(static_cast<int>(std::floor(x)), -1, size_ - 1);
    const int row = std::clamp(static_cast<int>(std::floor(y)), -1, size_ - 1);
    const float s = x - static_cast<float>(column), t = y - static_cast<float>(row);
    const auto between = [&](int line) {
        return texel(point.face, column, line) * (1 - s) + texel(point.face, column + 1, line) * s;
    };
    return between(row) * (1 - t) + between(row + 1) * t;
}

/// 0 everywhere if the map is black.
float CubeLight::pdfAt(const CubePoint &point, int column, int row) const {
    const int line = point.face * size_ + row;
    const float texels = static_cast<float>(size_) * static_cast<float>(size_);
    return rows_.probability(line) * columns_[line].probability(column) * texels /
           solidAngleDensity(point.st);
}

} // namespace render
