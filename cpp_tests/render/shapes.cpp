#include "shapes.hpp"

#include "frame.hpp"

namespace render {
namespace {

constexpr std::uint32_t around = 192, across = 24;

V3f onCircle(const Frame &frame, std::uint32_t i, std::uint32_t count) {
    const float angle = 2 * pi * static_cast<float>(i) / static_cast<float>(count);
    return frame.tangent * std::cos(angle) + frame.bitangent * std::sin(angle);
}

} // namespace

Mesh square(float half) {
    Mesh mesh;
    mesh.positions = {{-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const V3f up(0, 1, 0);
    mesh.normals = {{up, up, up}, {up, up, up}};
    mesh.uvs = {{V2f(0, 0), V2f(1, 0), V2f(1, 1)}, {V2f(0, 0), V2f(1, 1), V2f(0, 1)}};
    return mesh;
}

Mesh disc(const V3f &centre, const V3f &normal, float radius) {
    const Frame frame = frameAround(normal.normalized());
    Mesh mesh;
    mesh.positions.push_back(centre);
    for (std::uint32_t i = 0; i < around; ++i) {
        mesh.positions.push_back(centre + onCircle(frame, i, around) * radius);
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % around});
        mesh.normals.push_back({frame.normal, frame.normal, frame.normal});
        mesh.uvs.push_back({V2f(0), V2f(0), V2f(0)});
    }
    return mesh;
}

Mesh ring(const V3f &centre, const V3f &normal, float radius, float thickness) {
    const Frame frame = frameAround(normal.normalized());
    Mesh mesh;
    std::vector<V3f> normals;
    for (std::uint32_t i = 0; i < around; ++i) {
        const V3f outward = onCircle(frame, i, around);
        for (std::uint32_t j = 0; j < across; ++j) {
            const float angle = 2 * pi * static_cast<float>(j) / across;
            normals.push_back(outward * std::cos(angle) + frame.normal * std::sin(angle));
            mesh.positions.push_back(centre + outward * radius + normals.back() * (thickness / 2));
        }
    }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back({a, b, c});
        mesh.normals.push_back({normals[a], normals[b], normals[c]});
        mesh.uvs.push_back({V2f(0), V2f(0), V2f(0)});
    };
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t j = 0; j < across; ++j) {
            const std::uint32_t next = (i + 1) % around, above = (j + 1) % across;
            const std::uint32_t a = i * across + j, b = next * across + j, c = next * across + above,
                                d = i * across + above;
            add(a, b, c);
            add(a, c, d);
        }
    }
    return mesh;
}

} // namespace render
