// The finishes of maps.hpp.

#include "maps.hpp"
#include "noise.hpp"

#include <algorithm>

namespace render {
namespace {

Rgb mix(const Rgb &a, const Rgb &b, float t) { return a + (b - a) * t; }

float noise01(const V2f &p, float layer, int octaves) {
    return fractalNoise01(V3f(p.x, p.y, layer), octaves).value;
}

/// The distance to the outline of a rectangle with round corners, negative inside.
float roundedRectangle(const V2f &p, const V2f &half, float radius) {
    const V2f q(std::fabs(p.x) - half.x + radius, std::fabs(p.y) - half.y + radius);
    return std::hypot(std::max(q.x, 0.0f), std::max(q.y, 0.0f)) + std::min(std::max(q.x, q.y), 0.0f) - radius;
}

/// A number in [0, 1] for a cell of a grid.
float cellNumber(int column, int row, float layer) {
    return fractalNoise01(
               V3f(static_cast<float>(column) * 7.31f + 0.5f, static_cast<float>(row) * 5.17f + 0.5f, layer),
               1)
        .value;
}

} // namespace

Finish wornPlates(const V2f &uv) {
    const V2f p = uv - V2f(0.5f);
    // A frame around a sunk panel.
    const float panel = roundedRectangle(p, V2f(0.33f), 0.07f);
    const float rim = roundedRectangle(p, V2f(0.485f), 0.05f);
    const float step = smoothstep(-0.012f, 0.012f, panel); // 0 in the panel, 1 on the frame
    float height = 0.022f * step - 0.016f * smoothstep(-0.02f, 0.01f, rim);

    // Rivets along the frame.
    const V2f mirrored(std::fabs(p.x), std::fabs(p.y));
    float rivet = 1;
    for (const V2f &centre : {V2f(0.41f, 0.41f), V2f(0.41f, 0.137f), V2f(0.137f, 0.41f)})
        rivet = std::min(rivet, (mirrored - centre).length());
    const float dome = std::max(0.0f, 1 - rivet * rivet / (0.022f * 0.022f));
    height += 0.011f * std::sqrt(dome) -
              0.004f * (1 - smoothstep(0.022f, 0.032f, rivet)) * (dome > 0 ? 0.0f : 1.0f);

    // Paint goes first where something sticks out, and in flakes elsewhere.
    const float grain = noise01(uv * 9, 3.7f, 5), fine = noise01(uv * 42, 8.1f, 3);
    const float exposed = std::max({1 - std::fabs(panel - 0.01f) / 0.030f, 1 - std::fabs(rim) / 0.05f,
                                    0.85f * (dome > 0 ? 1.0f : 0.0f)});
    const float wear = 0.62f * std::max(exposed, 0.0f) + 0.62f * grain + 0.18f * fine - 0.74f;
    const float bare = smoothstep(0, 0.035f, wear);
    // Scratches: thin zero lines of stretched noise.
    const V2f leaning(uv.x * 0.8f + uv.y * 0.6f, uv.y * 0.8f - uv.x * 0.6f);
    const float line = std::fabs(improvedNoise(V3f(leaning.x * 3, leaning.y * 34, 5.5f)).value);
    const float scratch =
        (1 - smoothstep(0.006f, 0.02f, line)) * smoothstep(0.52f, 0.66f, noise01(uv * 4, 17.3f, 2));
    const float metal = std::max(bare, scratch);

    // Rust creeps from the bare places under the paint.
    const float rust = smoothstep(-0.10f, 0.0f, wear) * (1 - smoothstep(0.03f, 0.09f, wear)) *
                       smoothstep(0.40f, 0.62f, noise01(uv * 14, 29.9f, 4));
    const float dirt = 0.75f + 0.25f * smoothstep(0.3f, 0.7f, noise01(uv * 5, 41.3f, 4));
    const bool onFrame = step > 0.5f;
    const Rgb paint = mix(Rgb(0.03f, 0.13f, 0.20f), Rgb(0.72f, 0.27f, 0.03f), onFrame ? 0.0f : 1.0f) * dirt;
    const Rgb steel(0.56f, 0.57f, 0.58f),
        oxide = mix(Rgb(0.16f, 0.05f, 0.018f), Rgb(0.32f, 0.12f, 0.03f), fine);

    height -= 0.0024f * metal;
    height += 0.0016f * (fine - 0.5f) * rust + 0.0005f * (noise01(uv * 30, 2.2f, 2) - 0.5f);
    return {
        mix(mix(paint, steel, metal), oxide, rust), metal * (1 - rust),
        std::clamp(lerp(lerp(0.30f + 0.16f * grain, 0.26f + 0.2f * fine, metal), 0.85f, rust), 0.0f, 1.0f),
        height};
}

Finish stoneSlabs(const V2f &uv) {
    constexpr int rows = 4, columns = 2;
    const float y = uv.y * rows;
    const int row = static_cast<int>(std::floor(y)) % rows;
    const float x = uv.x * columns + (row % 2 ? 0.5f : 0.0f);
    const int column = static_cast<int>(std::floor(x)) % columns;
    // In units of a slab's depth, from its centre; a slab is twice as wide as deep.
    const V2f p((x - std::floor(x) - 0.5f) * rows / columns, y - std::floor(y) - 0.5f);
    const float layer = static_cast<float>(row * columns + column) * 13.7f;
    const V2f place = p + V2f(3.3f, 8.9f);

    const float ragged = 0.018f * (noise01(place * 6, layer, 3) - 0.5f);
    const float edge =
        roundedRectangle(p, V2f(static_cast<float>(rows) / (2 * columns) - 0.025f, 0.475f), 0.06f) + ragged;
    const float mortar = smoothstep(-0.008f, 0.012f, edge);
    const float rough = noise01(place * 3, layer + 5.1f, 6), grain = noise01(place * 40, layer + 2.6f, 2);
    const float vein =
        1 - smoothstep(0, 0.05f, std::fabs(improvedNoise(V3f(place.x * 2, place.y * 2, layer + 9.4f)).value));

    const float tone = cellNumber(column, row, 4.4f);
    Rgb stone = mix(Rgb(0.30f, 0.25f, 0.20f), Rgb(0.42f, 0.37f, 0.31f), tone);
    stone = mix(stone, stone * 0.55f, 0.7f * rough) * (0.85f + 0.3f * grain);
    stone = mix(stone, Rgb(0.50f, 0.46f, 0.40f), 0.22f * vein);
    const Rgb joint(0.20f, 0.19f, 0.175f); // without grain: slabs have noises of their own that meet there
    const float height = 0.034f * (1 - smoothstep(-0.05f, 0.012f, edge)) +
                         (0.020f * (rough - 0.5f) + 0.003f * (grain - 0.5f)) * (1 - mortar);
    return {mix(stone, joint, mortar), 0, lerp(0.42f + 0.3f * rough, 0.9f, mortar), height};
}

Finish patinatedBronze(const V3f &p, const V3f &normal) {
    const float large = fractalNoise01(p * 2.3f + V3f(4.1f, 0.6f, 7.7f), 4).value;
    const float fine = fractalNoise01(p * 11 + V3f(1.3f, 9.2f, 3.8f), 4).value;
    const float grain = fractalNoise01(p * 34 + V3f(6.6f, 2.5f, 0.4f), 2).value;

    // Rain leaves its green where it stays and where it runs.
    const float run = fractalNoise01(V3f(p.x * 7, p.y * 0.9f, p.z * 7) + V3f(2.9f, 5.4f, 8.3f), 4).value;
    const float wet = 0.95f * (large - 0.5f) + 0.75f * (run - 0.5f) +
                      0.30f * std::max(normal.y, 0.0f) + 0.25f * (fine - 0.5f);
    const float green = smoothstep(0.16f, 0.42f, wet);
    const float polish =
        smoothstep(0.1f, 0.9f, -0.8f * (large - 0.5f) + 0.3f * (fine - 0.5f));

    const Rgb brown = mix(Rgb(0.20f, 0.105f, 0.05f), Rgb(0.33f, 0.18f, 0.08f), fine);
    const Rgb bronze(0.78f, 0.50f, 0.24f);
    const Rgb verdigris =
        mix(Rgb(0.10f, 0.30f, 0.235f), Rgb(0.30f, 0.52f, 0.43f), 0.65f * fine + 0.35f * grain);
    return {mix(mix(brown, bronze, polish), verdigris, green), 1 - green,
            lerp(lerp(0.42f + 0.12f * fine, 0.22f + 0.1f * fine, polish), 0.82f, green),
            0};
}

} // namespace render
