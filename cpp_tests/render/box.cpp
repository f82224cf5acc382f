#include "box.hpp"

#include <algorithm>

namespace render {

Mesh roundedBox(float half, float radius) {
    constexpr std::uint32_t cells = 64;
    // Outwards, to the right and up, seen from outside.
    constexpr float axes[6][3][3] = {
        {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
    };
    Mesh mesh;
    std::vector<V3f> normals;
    for (const auto &face : axes) {
        const auto axis = [&](int i) { return V3f(face[i][0], face[i][1], face[i][2]); };
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const auto uv = [](std::uint32_t i, std::uint32_t j) {
            return V2f(static_cast<float>(i), static_cast<float>(j)) / static_cast<float>(cells);
        };
        for (std::uint32_t j = 0; j <= cells; ++j) {
            for (std::uint32_t i = 0; i <= cells; ++i) {
                const V2f at = (uv(i, j) * 2 - V2f(1)) * half;
                const V3f onCube = axis(0) * half + axis(1) * at.x + axis(2) * at.y;
                V3f inner;
                for (int k = 0; k < 3; ++k) inner[k] = std::clamp(onCube[k], radius - half, half - radius);
                normals.push_back((onCube - inner).normalized());
                mesh.positions.push_back(inner + normals.back() * radius);
            }
        }
        const auto add = [&](const std::array<V2i, 3> &corners) {
            Mesh::Triangle triangle;
            std::array<V3f, 3> normal;
            std::array<V2f, 3> place;
            for (int corner = 0; corner < 3; ++corner) {
                const auto i = static_cast<std::uint32_t>(corners[corner].x);
                const auto j = static_cast<std::uint32_t>(corners[corner].y);
                triangle[corner] = first + j * (cells + 1) + i;
                normal[corner] = normals[triangle[corner]];
                place[corner] = uv(i, j);
            }
            mesh.triangles.push_back(triangle);
            mesh.normals.push_back(normal);
            mesh.uvs.push_back(place);
        };
        for (int j = 0; j < static_cast<int>(cells); ++j) {
            for (int i = 0; i < static_cast<int>(cells); ++i) {
                add({V2i(i, j), V2i(i + 1, j), V2i(i + 1, j + 1)});
                add({V2i(i, j), V2i(i + 1, j + 1), V2i(i, j + 1)});
            }
        }
    }
    return mesh;
}

Mesh placed(Mesh mesh, float degrees, const V3f &offset) {
    const float c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    const auto turned = [&](const V3f &v) { return V3f(c * v.x + s * v.z, v.y, c * v.z - s * v.x); };
    for (V3f &position : mesh.positions) position = turned(position) + offset;
    for (auto &corners : mesh.normals)
        for (V3f &normal : corners) normal = turned(normal);
    return mesh;
}

} // namespace render
