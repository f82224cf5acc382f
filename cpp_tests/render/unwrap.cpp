#include "unwrap.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace render {
namespace {

/// The six directions, each with what is to its right and above it, seen from outside.
struct Facing {
    V3f outwards, right, up;
};
const Facing facings[6] = {
    {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
};

constexpr int none = -1;
using Neighbours = std::vector<std::array<int, 3>>;

/// For each vertex the first one at its place: files may give every triangle vertices of its own.
std::vector<std::uint32_t> welded(const Mesh &mesh) {
    std::map<std::array<float, 3>, std::uint32_t> first;
    std::vector<std::uint32_t> indices;
    for (const V3f &p : mesh.positions)
        indices.push_back(first.emplace(std::array{p.x, p.y, p.z}, static_cast<std::uint32_t>(indices.size()))
                              .first->second);
    return indices;
}

/// The triangle across each edge, or none.
Neighbours neighboursOf(const Mesh &mesh) {
    const std::vector<std::uint32_t> vertices = welded(mesh);
    Neighbours neighbours(mesh.triangles.size(), {none, none, none});
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> open;
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
        for (int edge = 0; edge < 3; ++edge) {
            const std::uint32_t from = vertices[mesh.triangles[i][edge]];
            const std::uint32_t to = vertices[mesh.triangles[i][(edge + 1) % 3]];
            const auto other = open.find({to, from});
            if (other == open.end()) {
                open[{from, to}] = {i, edge};
                continue;
            }
            neighbours[i][edge] = other->second.first;
            neighbours[other->second.first][other->second.second] = i;
            open.erase(other);
        }
    }
    return neighbours;
}

V3f faceNormal(const Mesh &mesh, int i) {
    const auto &[a, b, c] = mesh.triangles[i];
    const V3f normal =
        cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).normalized();
    // As the renderer has it: the vertex normals say where the outside is.
    const auto &corners = mesh.normals[i];
    return dot(normal, corners[0] + corners[1] + corners[2]) < 0 ? -normal : normal;
}

/// Which way each triangle is laid flat: the way it faces, unless most of its neighbours go another way
/// that it can follow without being squeezed too much.
std::vector<int> facingOf(const Mesh &mesh, const Neighbours &neighbours) {
    const int count = static_cast<int>(mesh.triangles.size());
    std::vector<int> facing(count, 0);
    std::vector<V3f> normals;
    for (int i = 0; i < count; ++i) {
        normals.push_back(faceNormal(mesh, i));
        for (int f = 1; f < 6; ++f)
            if (dot(normals[i], facings[f].outwards) > dot(normals[i], facings[facing[i]].outwards))
                facing[i] = f;
    }
    constexpr int rounds = 40;
    constexpr float leastCosine = 0.4f;
    for (int round = 0; round < rounds; ++round) {
        for (int i = 0; i < count; ++i) {
            std::array<int, 6> votes{};
            for (const int neighbour : neighbours[i])
                if (neighbour != none) ++votes[facing[neighbour]];
            const int most = static_cast<int>(std::max_element(votes.begin(), votes.end()) - votes.begin());
            if (votes[most] >= 2 && dot(normals[i], facings[most].outwards) > leastCosine) facing[i] = most;
        }
    }
    return facing;
}

struct Chart {
    int facing;
    std::vector<int> triangles;
    V2f low{0}, high{0}; ///< of its corners, laid flat
    V2f place{0};        ///< of `low` in the image, texels
};

V2f flat(const V3f &position, int facing) {
    return {dot(position, facings[facing].right), dot(position, facings[facing].up)};
}

std::vector<Chart> chartsOf(const Mesh &mesh) {
    const Neighbours neighbours = neighboursOf(mesh);
    const std::vector<int> facing = facingOf(mesh, neighbours);
    std::vector<bool> taken(mesh.triangles.size(), false);
    std::vector<Chart> charts;
    for (int seed = 0; seed < static_cast<int>(mesh.triangles.size()); ++seed) {
        if (taken[seed]) continue;
        Chart chart{facing[seed], {seed}};
        taken[seed] = true;
        chart.low = chart.high = flat(mesh.positions[mesh.triangles[seed][0]], chart.facing);
        for (std::size_t next = 0; next < chart.triangles.size(); ++next) {
            const int i = chart.triangles[next];
            for (const std::uint32_t corner : mesh.triangles[i]) {
                const V2f p = flat(mesh.positions[corner], chart.facing);
                chart.low = {std::min(chart.low.x, p.x), std::min(chart.low.y, p.y)};
                chart.high = {std::max(chart.high.x, p.x), std::max(chart.high.y, p.y)};
            }
            for (const int neighbour : neighbours[i]) {
                if (neighbour == none || taken[neighbour] || facing[neighbour] != chart.facing) continue;
                taken[neighbour] = true;
                chart.triangles.push_back(neighbour);
            }
        }
        charts.push_back(std::move(chart));
    }
    return charts;
}

/// Shelves: charts side by side in rows, the highest first. False if they do not fit.
bool pack(std::vector<Chart> &charts, float texelsPerUnit, int size, int gap) {
    float x = 0, y = 0, rowHeight = 0;
    const auto side = static_cast<float>(size), margin = static_cast<float>(gap);
    for (Chart &chart : charts) {
        const V2f extent = (chart.high - chart.low) * texelsPerUnit + V2f(2 * margin);
        if (extent.x > side) return false;
        if (x + extent.x > side) {
            x = 0;
            y += rowHeight;
            rowHeight = 0;
        }
        if (y + extent.y > side) return false;
        chart.place = V2f(x + margin, y + margin);
        x += extent.x;
        rowHeight = std::max(rowHeight, extent.y);
    }
    return true;
}

/// The charts packed with the largest scale that fits, by bisection of its logarithm; 0 if none does.
float largestScale(std::vector<Chart> &charts, int size, int gap) {
    float fits = 0, least = -20, most = 20;
    for (int step = 0; step < 40; ++step) {
        const float middle = (least + most) / 2;
        const float scale = std::exp2(middle);
        if (pack(charts, scale, size, gap)) {
            fits = scale;
            least = middle;
        } else {
            most = middle;
        }
    }
    pack(charts, fits, size, gap);
    return fits;
}

} // namespace

Mesh unwrapped(Mesh mesh, int size, int gap) {
    std::vector<Chart> charts = chartsOf(mesh);
    std::sort(charts.begin(), charts.end(),
              [](const Chart &a, const Chart &b) { return a.high.y - a.low.y > b.high.y - b.low.y; });
    float scale = largestScale(charts, size, gap);
    for (; scale == 0 && gap > 0; gap /= 2) scale = largestScale(charts, size, gap / 2);
    for (const Chart &chart : charts)
        for (const int i : chart.triangles)
            for (int corner = 0; corner < 3; ++corner) {
                const V2f p = flat(mesh.positions[mesh.triangles[i][corner]], chart.facing);
                mesh.uvs[i][corner] = ((p - chart.low) * scale + chart.place) / static_cast<float>(size);
            }
    return mesh;
}

} // namespace render
