#include "shapes.hpp"

#include "frame.hpp"

#include <algorithm>

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

Mesh gridMesh(const Grid &grid, const std::function<V3f(float u, float v)> &at) {
    const std::uint32_t wide = grid.columns + (grid.closedInU ? 0 : 1), high = grid.rows + (grid.closedInV ? 0 : 1);
    Mesh mesh;
    for (std::uint32_t j = 0; j < high; ++j)
        for (std::uint32_t i = 0; i < wide; ++i)
            mesh.positions.push_back(at(static_cast<float>(i) / static_cast<float>(grid.columns),
                                        static_cast<float>(j) / static_cast<float>(grid.rows)));
    const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return j % high * wide + i % wide; };
    for (std::uint32_t j = 0; j < grid.rows; ++j) {
        for (std::uint32_t i = 0; i < grid.columns; ++i) {
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    }
    mesh.uvs.assign(mesh.triangles.size(), {V2f(0), V2f(0), V2f(0)});
    smooth(mesh);
    return mesh;
}

Mesh turned(const std::vector<V2f> &outline) {
    const auto count = static_cast<int>(outline.size());
    const auto point = [&](int i) { return outline[static_cast<std::size_t>(std::clamp(i, 0, count - 1))]; };
    const auto spline = [&](float t) {
        const int i = std::min(static_cast<int>(t * static_cast<float>(count - 1)), count - 2);
        const float s = t * static_cast<float>(count - 1) - static_cast<float>(i);
        const V2f a = point(i - 1), b = point(i), c = point(i + 1), d = point(i + 2);
        return (b * 2 + (c - a) * s + (a * 2 - b * 5 + c * 4 - d) * (s * s) + (b * 3 - a - c * 3 + d) * (s * s * s)) *
               0.5f;
    };
    return gridMesh({around, 24 * static_cast<std::uint32_t>(count), true, false}, [&](float u, float v) {
        const V2f p = spline(v);
        const float angle = -2 * pi * u;
        return V3f(p.x * std::cos(angle), p.y, p.x * std::sin(angle));
    });
}

Mesh lens(float aperture, float sphere, float edge) {
    constexpr int steps = 96;
    struct Ring {
        float radius, height;
        V2f normal; ///< outwards and upwards
    };
    std::vector<Ring> rings;
    const float low = std::sqrt(sphere * sphere - aperture * aperture);
    const auto cap = [&](float side, int step) {
        const float r = aperture * static_cast<float>(step) / steps, h = std::sqrt(sphere * sphere - r * r);
        rings.push_back({r, side * (h - low + edge / 2), V2f(r, side * h) / sphere});
    };
    for (int step = 0; step <= steps; ++step) cap(-1, step);
    for (const float side : {-1.0f, 1.0f}) rings.push_back({aperture, side * edge / 2, V2f(1, 0)});
    for (int step = steps; step >= 0; --step) cap(1, step);

    Mesh mesh;
    std::vector<V3f> normals;
    for (const Ring &ring : rings) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const float angle = -2 * pi * static_cast<float>(i) / around;
            const V3f outward(std::cos(angle), 0, std::sin(angle)), up(0, 1, 0);
            mesh.positions.push_back(outward * ring.radius + up * ring.height);
            normals.push_back(outward * ring.normal.x + up * ring.normal.y);
        }
    }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back({a, b, c});
        mesh.normals.push_back({normals[a], normals[b], normals[c]});
        mesh.uvs.push_back({V2f(0), V2f(0), V2f(0)});
    };
    for (std::uint32_t j = 0; j + 1 < rings.size(); ++j) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t next = (i + 1) % around, here = j * around, above = here + around;
            add(here + i, here + next, above + next);
            add(here + i, above + next, above + i);
        }
    }
    return mesh;
}

Mesh facing(Mesh mesh, float degrees, const V3f &offset) {
    const float c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
    const auto turnedOver = [&](const V3f &v) { return V3f(c * v.x + s * v.y, -v.z, c * v.y - s * v.x); };
    for (V3f &position : mesh.positions) position = turnedOver(position) + offset;
    for (auto &corners : mesh.normals)
        for (V3f &normal : corners) normal = turnedOver(normal);
    return mesh;
}

} // namespace render
