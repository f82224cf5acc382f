#include "spheres.hpp"

namespace render {
namespace {

constexpr float radius = 1;
constexpr float rowSpacing = 2.5f, gridSpacing = 2.7f; ///< of centres
/// By which a grid's spheres are below the middle of their cells: room for the labels of rows.
constexpr float lowered = 0.12f;
/// So far away that all spheres are seen from nearly the same side.
constexpr float cameraDistance = 100;

/// A camera at `elevation` degrees that sees `height` at the target.
Camera distantCamera(const V3f &target, float elevation, float height) {
    const V3f direction(0, std::sin(radians(elevation)), std::cos(radians(elevation)));
    return {target + direction * cameraDistance, target,
            2 * std::atan(height / (2 * cameraDistance)) * 180 / pi};
}

/// Of the i-th of `count`, centred on 0.
float place(std::size_t i, std::size_t count, float spacing) {
    return spacing * (static_cast<float>(i) - static_cast<float>(count - 1) / 2);
}

std::vector<View> oneView(const char *name, std::unique_ptr<World> world, const Camera &camera) {
    world->commit();
    std::vector<View> views;
    views.push_back({name, std::move(world), camera});
    return views;
}

} // namespace

Views sphereRow(std::function<Materials()> spheres, V2f extent, Floor floor) {
    return {{extent}, [=](const Subject &) {
                const Materials materials = spheres();
                const float width = rowSpacing * static_cast<float>(materials.size());
                auto world = std::make_unique<World>();
                addFloor(*world, floor, width / 3, width);
                for (std::size_t i = 0; i < materials.size(); ++i) {
                    const V3f centre(place(i, materials.size(), rowSpacing), radius, 0);
                    world->add(Sphere{centre, radius}, materials[i]);
                }
                return oneView("row", std::move(world),
                               distantCamera(V3f(0, 0.93f * radius, 0), 14, width * extent.y / extent.x));
            }};
}

Views sphereGrid(std::function<std::vector<Materials>()> rows, float side) {
    return {{V2f(side)}, [=](const Subject &) {
                const std::vector<Materials> materials = rows();
                auto world = std::make_unique<World>();
                for (std::size_t row = 0; row < materials.size(); ++row) {
                    const std::size_t columns = materials[row].size();
                    for (std::size_t column = 0; column < columns; ++column) {
                        const V3f centre(place(column, columns, gridSpacing),
                                         -place(row, materials.size(), gridSpacing), 0);
                        world->add(Sphere{centre, radius}, materials[row][column]);
                    }
                }
                return oneView("grid", std::move(world),
                               distantCamera(V3f(0, lowered, 0), 0,
                                             gridSpacing * static_cast<float>(materials.size())));
            }};
}

} // namespace render
