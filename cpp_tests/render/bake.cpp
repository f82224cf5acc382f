#include "bake.hpp"

#include "footprint.hpp"
#include "normal_map.hpp"

#include <algorithm>

namespace render {
namespace {

/// The mean curvature at each vertex, by the umbrella operator, averaged with the neighbours' until it
/// shows hollows rather than triangles, and scaled to the mesh's standard deviation.
std::vector<float> hollownessOf(const Mesh &mesh) {
    const std::size_t count = mesh.positions.size();
    std::vector<V3f> normals(count, V3f(0));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int corner = 0; corner < 3; ++corner)
            normals[mesh.triangles[i][corner]] += mesh.normals[i][corner];

    // The mean of the vertices around each: every triangle adds its two other corners.
    const auto average = [&](const auto &values) {
        auto sums = values;
        std::vector<float> weights(count, 0);
        for (auto &sum : sums) sum = sum * 0.0f;
        for (const Mesh::Triangle &triangle : mesh.triangles) {
            for (int corner = 0; corner < 3; ++corner) {
                sums[triangle[corner]] +=
                    values[triangle[(corner + 1) % 3]] + values[triangle[(corner + 2) % 3]];
                weights[triangle[corner]] += 2;
            }
        }
        for (std::size_t i = 0; i < count; ++i)
            if (weights[i] > 0) sums[i] = sums[i] / weights[i];
        return sums;
    };
    const std::vector<V3f> centres = average(mesh.positions);
    std::vector<float> hollowness(count, 0);
    for (std::size_t i = 0; i < count; ++i)
        hollowness[i] = dot(centres[i] - mesh.positions[i], normals[i].normalized());
    constexpr int smoothing = 12;
    for (int round = 0; round < smoothing; ++round) hollowness = average(hollowness);
    double squares = 0;
    for (const float h : hollowness) squares += static_cast<double>(h) * h;
    const auto deviation = static_cast<float>(std::sqrt(squares / static_cast<double>(count)));
    for (float &h : hollowness) h /= std::max(deviation, 1e-20f);
    return hollowness;
}

/// The normal of the relief, in the tangent frame of `surface`, by central differences in space.
V3f reliefNormal(const SurfacePoint &surface, const BakePoint &point, const SolidFinish &finish) {
    constexpr float step = 0.003f;
    V3f gradient;
    for (int axis = 0; axis < 3; ++axis) {
        BakePoint before = point, after = point;
        before.position[axis] -= step;
        after.position[axis] += step;
        gradient[axis] = (finish(after).height - finish(before).height) / (2 * step);
    }
    const V3f along = gradient - point.normal * dot(gradient, point.normal);
    return tangentFrame(surface).toLocal((point.normal - along).normalized());
}

class Canvas {
public:
    Canvas(const Mesh &mesh, int size, const SolidFinish &finish)
        : mesh_(mesh),
          finish_(finish),
          hollowness_(hollownessOf(mesh)),
          size_(size),
          maps_{{size, std::vector<Finish>(static_cast<std::size_t>(size) * size)},
                std::vector<V3f>(static_cast<std::size_t>(size) * size, V3f(0, 0, 1)),
                0},
          owners_(maps_.normals.size(), none) {}

    BakedMaps bake(int gap) {
        for (int i = 0; i < static_cast<int>(mesh_.triangles.size()); ++i) paint(i);
        for (int round = 0; round < gap; ++round) grow();
        fillRest();
        return std::move(maps_);
    }

private:
    static constexpr int none = -1;

    std::size_t at(int column, int row) const { return static_cast<std::size_t>(row) * size_ + column; }

    /// The texels whose centre the triangle covers.
    void paint(int i) {
        const auto side = static_cast<float>(size_);
        std::array<V2f, 3> raster;
        for (int corner = 0; corner < 3; ++corner) {
            const V2f &uv = mesh_.uvs[i][corner];
            raster[corner] = V2f(uv.x * side - 0.5f, (1 - uv.y) * side - 0.5f);
        }
        const V2f a = raster[1] - raster[0], b = raster[2] - raster[0];
        const float area = a.x * b.y - a.y * b.x;
        if (area == 0) return;
        const auto [left, right] = std::minmax({raster[0].x, raster[1].x, raster[2].x});
        const auto [top, bottom] = std::minmax({raster[0].y, raster[1].y, raster[2].y});
        const auto clampIndex = [&](float x) { return std::clamp(static_cast<int>(x), 0, size_ - 1); };
        for (int row = clampIndex(std::ceil(top)); row <= clampIndex(std::floor(bottom)); ++row) {
            for (int column = clampIndex(std::ceil(left)); column <= clampIndex(std::floor(right));
                 ++column) {
                const V2f p = V2f(static_cast<float>(column), static_cast<float>(row)) - raster[0];
                const float u = (p.x * b.y - p.y * b.x) / area, v = (a.x * p.y - a.y * p.x) / area;
                if (u >= 0 && v >= 0 && u + v <= 1) paint(i, u, v, at(column, row));
            }
        }
    }

    void paint(int i, float u, float v, std::size_t texel) {
        const Mesh::Triangle &t = mesh_.triangles[i];
        const auto between = [&](const auto &x, const auto &y, const auto &z) {
            return x * (1 - u - v) + y * u + z * v;
        };
        BakePoint point;
        point.position = between(mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]);
        const auto &normals = mesh_.normals[i];
        point.normal = between(normals[0], normals[1], normals[2]).normalized();
        point.hollowness = between(hollowness_[t[0]], hollowness_[t[1]], hollowness_[t[2]]);

        if (owners_[texel] != none && owners_[texel] != i) {
            const V3f other = mesh_.positions[mesh_.triangles[owners_[texel]][0]];
            const float edge = (mesh_.positions[t[1]] - mesh_.positions[t[0]]).length();
            if ((other - point.position).length() > 8 * edge) ++maps_.overlaps;
            return;
        }
        owners_[texel] = i;
        SurfacePoint surface;
        surface.shading = frameAround(point.normal);
        const TextureTangents tangents = textureTangents(
            {mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]}, mesh_.uvs[i]);
        surface.alongU = tangents.alongU;
        surface.alongV = tangents.alongV;
        maps_.image.texels[texel] = finish_(point);
        maps_.normals[texel] = reliefNormal(surface, point, finish_);
    }

    /// Texels beside painted ones repeat one of these.
    void grow() {
        const std::vector<int> before = owners_;
        for (int row = 0; row < size_; ++row) {
            for (int column = 0; column < size_; ++column) {
                const std::size_t texel = at(column, row);
                if (before[texel] != none) continue;
                for (const V2i &step : {V2i(1, 0), V2i(-1, 0), V2i(0, 1), V2i(0, -1)}) {
                    const V2i beside = V2i(column, row) + step;
                    if (beside.x < 0 || beside.y < 0 || beside.x >= size_ || beside.y >= size_) continue;
                    const std::size_t source = at(beside.x, beside.y);
                    if (before[source] == none) continue;
                    owners_[texel] = before[source];
                    maps_.image.texels[texel] = maps_.image.texels[source];
                    maps_.normals[texel] = maps_.normals[source];
                    break;
                }
            }
        }
    }

    void fillRest() {
        Finish mean{Rgb(0), 0, 0, 0};
        float count = 0;
        for (std::size_t i = 0; i < owners_.size(); ++i) {
            if (owners_[i] == none) continue;
            const Finish &texel = maps_.image.texels[i];
            mean.baseColor += texel.baseColor;
            mean.metallic += texel.metallic;
            mean.roughness += texel.roughness;
            ++count;
        }
        if (count > 0) mean = {mean.baseColor / count, mean.metallic / count, mean.roughness / count, 0};
        for (std::size_t i = 0; i < owners_.size(); ++i)
            if (owners_[i] == none) maps_.image.texels[i] = mean;
    }

    const Mesh &mesh_;
    const SolidFinish &finish_;
    const std::vector<float> hollowness_;
    const int size_;
    BakedMaps maps_;
    std::vector<int> owners_; ///< of each texel: the triangle that painted it
};

} // namespace

BakedMaps bake(const Mesh &mesh, int size, int gap, const SolidFinish &finish) {
    return Canvas(mesh, size, finish).bake(gap);
}

} // namespace render
