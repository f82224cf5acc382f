#include "mesh.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

[[noreturn]] void fail(const std::filesystem::path &file, std::string what) {
    while (!what.empty() && (what.back() == '\n' || what.back() == ' ')) what.pop_back();
    std::replace(what.begin(), what.end(), '\n', ' ');
    throw std::runtime_error("cannot read the mesh " + file.string() + ": " + what);
}

/// Vertex normals as the mean of the adjacent faces' normals, weighted by the angle at the vertex
/// (G. Thuermer and C. Wuethrich, "Computing Vertex Normals from Polygonal Facets", JGT 3(1), 1998):
/// independent of how the surface is cut into triangles.
std::vector<V3f> smoothNormals(const Mesh &mesh) {
    std::vector<V3f> normals(mesh.positions.size(), V3f(0));
    for (const Mesh::Triangle &triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const V3f &p = mesh.positions[triangle[corner]];
            const V3f a = mesh.positions[triangle[(corner + 1) % 3]] - p;
            const V3f b = mesh.positions[triangle[(corner + 2) % 3]] - p;
            const V3f perpendicular = cross(a, b);
            const float angle = std::atan2(perpendicular.length(), dot(a, b));
            normals[triangle[corner]] += perpendicular.normalized() * angle;
        }
    }
    for (V3f &normal : normals) normal.normalize();
    return normals;
}

bool finite(const V3f &v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

} // namespace

Mesh readObj(const std::filesystem::path &file) {
    if (!std::filesystem::is_regular_file(file)) fail(file, "no such file");
    tinyobj::ObjReader reader;
    tinyobj::ObjReaderConfig config;
    config.triangulate = true;
    if (!reader.ParseFromFile(file.string(), config)) fail(file, reader.Error());
    // tinyobjloader warns where an index is out of bounds or a material library is missing; the
    // latter does not matter, materials being ours.
    if (reader.Warning().find("out of bounds") != std::string::npos) fail(file, reader.Warning());

    const tinyobj::attrib_t &attributes = reader.GetAttrib();
    const auto vectorAt = [](const std::vector<float> &numbers, int index) {
        const float *v = numbers.data() + 3 * index;
        return V3f(v[0], v[1], v[2]);
    };
    const auto inRange = [](int index, std::size_t count) {
        return index >= 0 && static_cast<std::size_t>(index) < count;
    };

    Mesh mesh;
    const std::size_t vertexCount = attributes.vertices.size() / 3;
    for (std::size_t i = 0; i < vertexCount; ++i) {
        mesh.positions.push_back(vectorAt(attributes.vertices, static_cast<int>(i)));
        if (!finite(mesh.positions.back())) fail(file, "vertex " + std::to_string(i + 1) + " is not finite");
    }

    std::vector<std::array<int, 3>> normalIndices;
    for (const tinyobj::shape_t &shape : reader.GetShapes()) {
        const auto &indices = shape.mesh.indices;
        for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
            Mesh::Triangle triangle;
            std::array<V2f, 3> uv;
            std::array<int, 3> normalIndex;
            for (int corner = 0; corner < 3; ++corner) {
                const tinyobj::index_t &index = indices[first + corner];
                if (!inRange(index.vertex_index, vertexCount))
                    fail(file, "a face refers to vertex " + std::to_string(index.vertex_index + 1) + " of " +
                                   std::to_string(vertexCount));
                triangle[corner] = static_cast<std::uint32_t>(index.vertex_index);
                normalIndex[corner] = index.normal_index;
                uv[corner] = V2f(0);
                if (inRange(index.texcoord_index, attributes.texcoords.size() / 2))
                    uv[corner] = {attributes.texcoords[2 * index.texcoord_index],
                                  attributes.texcoords[2 * index.texcoord_index + 1]};
            }
            mesh.triangles.push_back(triangle);
            mesh.uvs.push_back(uv);
            normalIndices.push_back(normalIndex);
        }
    }
    if (mesh.triangles.empty()) fail(file, "it has no faces (is it a Wavefront OBJ file?)");

    const std::vector<V3f> smooth = smoothNormals(mesh);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        std::array<V3f, 3> corners;
        for (int corner = 0; corner < 3; ++corner) {
            corners[corner] = smooth[mesh.triangles[i][corner]];
            if (!inRange(normalIndices[i][corner], attributes.normals.size() / 3)) continue;
            const V3f normal = vectorAt(attributes.normals, normalIndices[i][corner]);
            if (finite(normal) && normal.length2() > 0) corners[corner] = normal.normalized();
        }
        mesh.normals.push_back(corners);
    }
    return mesh;
}

void smooth(Mesh &mesh) {
    const std::vector<V3f> normals = smoothNormals(mesh);
    mesh.normals.clear();
    for (const auto &[a, b, c] : mesh.triangles) mesh.normals.push_back({normals[a], normals[b], normals[c]});
}

void standOnFloor(Mesh &mesh) {
    V3f low = mesh.positions.front(), high = low;
    for (const V3f &p : mesh.positions) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    const V3f size = high - low;
    const float scale = 2 / std::max({size.x, size.y, size.z, 1e-20f});
    const V3f foot((low.x + high.x) / 2, low.y, (low.z + high.z) / 2);
    for (V3f &p : mesh.positions) p = (p - foot) * scale;
}

} // namespace render
