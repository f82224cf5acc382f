// Textures made by formula, and their files.
#pragma once

#include "math.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace render {

/// A place of a surface as textures describe it.
struct Finish {
    Rgb baseColor; ///< linear, 0 to 1
    float metallic, roughness;
    float height; ///< of the relief, in the same unit as the texture's side
};

/// The images of one finish.
struct MapFiles {
    std::filesystem::path baseColor, normal, roughness, metallic;
};

/// A square of finishes, `size` x `size`, rows from the top.
struct FinishImage {
    int size;
    std::vector<Finish> texels;
};

/// Evaluates a finish at the centres of texels; u and v as Texture has them.
FinishImage drawFinish(int size, const std::function<Finish(const V2f &uv)> &finish);

/// The tangent-space normals of a relief that repeats itself, by central differences; `side` is the
/// length of the image's side, in the unit of the heights.
std::vector<V3f> reliefNormals(const FinishImage &image, float side);

/// Writes DIRECTORY/NAME.base_color.png and so on: 8 bits, the colour as sRGB; normals 16 bits.
/// Throws std::runtime_error.
MapFiles writeMaps(const FinishImage &image, const std::vector<V3f> &normals,
                   const std::filesystem::path &directory, const std::string &name);

/// Enamelled steel plates with bevelled edges, rivets and worn paint: one face of a box.
Finish wornPlates(const V2f &uv);

/// Bronze as statues have it, at a place of the surface with this normal: polished, brown, and green where rain
/// stays.
Finish patinatedBronze(const V3f &position, const V3f &normal);

/// Stone slabs with grey mortar between, in a running bond; repeats itself.
Finish stoneSlabs(const V2f &uv);

} // namespace render
