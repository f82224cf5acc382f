#include "studio.hpp"

#include <functional>
#include <vector>

namespace render {
namespace {

const std::vector<SoftBox> studioBoxes{
    {-132, 38, 4, 44, 14, Rgb(57, 55, 52)},     // key: from the left and in front
    {118, 28, 6, 46, -10, Rgb(9, 9.5f, 10.5f)}, // fill: from the right
    {38, 34, 7, 36, 0, Rgb(14, 14, 14.7f)},     // rim: from behind
    {-50, 66, 36, 22, 20, Rgb(3.6f, 3.6f, 3.6f)}, // overhead
    {172, 14, 60, 9, 0, Rgb(1.2f, 1.2f, 1.2f)}, // a low strip in front, for what faces the viewer
};

const std::vector<SoftBox> wideBoxes{
    {-122, 4, 84, 104, 0, Rgb(1.1f, 1.1f, 1.1f)},   // left, in front
    {126, 4, 80, 100, 0, Rgb(0.9f, 0.9f, 0.9f)},    // right, in front
    {180, 72, 64, 44, 0, Rgb(1.2f, 1.2f, 1.2f)},    // above the camera
    {-46, 30, 24, 66, 6, Rgb(0.9f, 0.9f, 0.9f)},    // behind, left
    {48, 34, 24, 66, -6, Rgb(0.9f, 0.9f, 0.9f)},    // behind, right
};

const std::vector<SoftBox> roomBoxes{
    {116, 14, 50, 74, 0, Rgb(0.62f, 0.6f, 0.57f)},    // right, in front
    {-42, 24, 26, 66, 8, Rgb(0.72f, 0.74f, 0.76f)},   // behind, left
    {44, 22, 22, 62, -8, Rgb(0.65f, 0.65f, 0.65f)},   // behind, right
};

/// Two panes wide and three high.
const std::vector<SoftBox> windowPanes = [] {
    std::vector<SoftBox> panes;
    for (const float azimuth : {-145.0f, -119.0f})
        for (const float elevation : {2.0f, 25.0f, 48.0f})
            panes.push_back({azimuth, elevation, 23, 21, 0, Rgb(2.2f, 2.2f, 2.16f)});
    return panes;
}();

/// Radiance falls to 0 over this fraction of a box's half width and height.
constexpr float softEdge = 0.25f;

Rgb dimSky(const V3f &direction) {
    const Rgb zenith(0.13f, 0.145f, 0.17f), horizon(0.07f, 0.07f, 0.07f);
    if (direction.y < 0) return Rgb(0); // where the floor is
    return horizon + (zenith - horizon) * direction.y;
}

V3f fromAngles(float azimuth, float elevation) {
    const float a = radians(azimuth), e = radians(elevation);
    return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

Rgb lightOfOne(const SoftBox &box, const V3f &direction) {
    const V3f forward = fromAngles(box.azimuth, box.elevation);
    const float depth = dot(direction, forward);
    if (depth <= 0) return Rgb(0);
    const V3f right = cross(V3f(0, 1, 0), forward).normalized(), up = cross(forward, right);
    const float c = std::cos(radians(box.roll)), s = std::sin(radians(box.roll));
    const float x = dot(direction, right * c + up * s) / depth / std::tan(radians(box.width / 2));
    const float y = dot(direction, up * c - right * s) / depth / std::tan(radians(box.height / 2));
    return box.radiance * ((1 - smoothstep(1 - softEdge, 1, std::fabs(x))) *
                           (1 - smoothstep(1 - softEdge, 1, std::fabs(y))));
}

LatLongMap draw(const std::function<Rgb(const V3f &direction)> &radiance) {
    LatLongMap map{512, 256, {}};
    map.texels.reserve(static_cast<std::size_t>(map.width) * map.height);
    for (int row = 0; row < map.height; ++row) {
        for (int column = 0; column < map.width; ++column) {
            map.texels.push_back(radiance(latLongDirection(
                (static_cast<float>(column) + 0.5f) / static_cast<float>(map.width),
                std::cos(pi * (static_cast<float>(row) + 0.5f) / static_cast<float>(map.height)))));
        }
    }
    return map;
}

} // namespace

Rgb lightOf(const std::vector<SoftBox> &boxes, const V3f &direction) {
    Rgb light(0);
    for (const SoftBox &box : boxes) light += lightOfOne(box, direction);
    return light;
}

LatLongMap studio() {
    return draw([](const V3f &direction) { return dimSky(direction) + lightOf(studioBoxes, direction); });
}

LatLongMap darkRoom() {
    return draw([](const V3f &direction) { return Rgb(0.002f) + lightOf(wideBoxes, direction); });
}

LatLongMap tent() {
    return draw([](const V3f &direction) { return Rgb(0.16f) + lightOf(wideBoxes, direction); });
}

LatLongMap windowRoom() {
    return draw([](const V3f &direction) {
        // From the floor through the walls to the ceiling; darker straight behind the object.
        const float room = lerp(0.1f, 0.26f, smoothstep(-0.9f, 0.9f, direction.y));
        const float grey = room * lerp(1, 0.2f, smoothstep(std::cos(radians(50)), 1, -direction.z));
        return Rgb(grey) + lightOf(roomBoxes, direction) + lightOf(windowPanes, direction);
    });
}

LatLongMap spotInRoom() {
    const std::vector<SoftBox> spot{{-148, 40, 6, 6, 0, Rgb(200)}};
    return draw([&](const V3f &direction) {
        return Rgb(lerp(0.03f, 0.08f, smoothstep(-0.5f, 1, direction.y))) + lightOf(spot, direction);
    });
}

LatLongMap frontLamp() {
    const std::vector<SoftBox> lamp{{180, 14, 8, 8, 0, Rgb(200)}};
    return draw([&](const V3f &direction) { return Rgb(0.02f) + lightOf(lamp, direction); });
}

LatLongMap lamp() {
    const std::vector<SoftBox> boxes{{-140, 42, 6, 6, 0, Rgb(340)}};
    return draw([&](const V3f &direction) { return lightOf(boxes, direction); });
}

// P. Moon and D. Spencer, "Illumination from a Non-Uniform Sky", Illuminating Engineering 37, 1942.
LatLongMap cloudedSky() {
    return draw([](const V3f &direction) {
        return direction.y < 0 ? Rgb(0) : Rgb((1 + 2 * direction.y) / 3);
    });
}

} // namespace render
