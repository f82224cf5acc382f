#include "maps.hpp"

#include "image_file.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <stdexcept>

namespace render {
namespace {

/// `channels` numbers a texel.
std::filesystem::path writeImage(const std::vector<float> &numbers, int size, int channels,
                                 OIIO::TypeDesc type, bool sRgb, const std::filesystem::path &file) {
    OIIO::ImageBuf image(OIIO::ImageSpec(size, size, channels, OIIO::TypeFloat));
    image.set_pixels(image.roi(), OIIO::TypeFloat, numbers.data());
    if (sRgb) {
        image = OIIO::ImageBufAlgo::colorconvert(image, "linear", "sRGB");
        image.specmod().attribute("oiio:ColorSpace", "sRGB");
    } else {
        image.specmod().attribute("oiio:ColorSpace", "linear");
    }
    if (image.has_error() || !image.write(file.string(), type))
        throw std::runtime_error("cannot write " + file.string() + ": " + image.geterror());
    return file;
}

} // namespace

FinishImage drawFinish(int size, const std::function<Finish(const V2f &uv)> &finish) {
    FinishImage image{size, {}};
    image.texels.reserve(static_cast<std::size_t>(size) * size);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            image.texels.push_back(
                finish(V2f((static_cast<float>(column) + 0.5f) / static_cast<float>(size),
                           1 - (static_cast<float>(row) + 0.5f) / static_cast<float>(size))));
    return image;
}

std::vector<V3f> reliefNormals(const FinishImage &image, float side) {
    const int size = image.size;
    const auto height = [&](int column, int row) {
        return image.texels[static_cast<std::size_t>((row + size) % size) * size + (column + size) % size]
            .height;
    };
    const float perTexel = static_cast<float>(size) / side / 2;
    std::vector<V3f> normals;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const float slopeU = (height(column + 1, row) - height(column - 1, row)) * perTexel;
            const float slopeV = (height(column, row - 1) - height(column, row + 1)) * perTexel;
            normals.push_back(V3f(-slopeU, -slopeV, 1).normalized());
        }
    }
    return normals;
}

MapFiles writeMaps(const FinishImage &image, const std::vector<V3f> &normals,
                   const std::filesystem::path &directory, const std::string &name) {
    std::vector<float> baseColor, roughness, metallic, normal;
    for (const Finish &texel : image.texels) {
        for (int c = 0; c < 3; ++c) baseColor.push_back(texel.baseColor[c]);
        roughness.push_back(texel.roughness);
        metallic.push_back(texel.metallic);
    }
    for (const V3f &n : normals)
        for (int axis = 0; axis < 3; ++axis) normal.push_back(0.5f + 0.5f * n[axis]);

    makeDirectory(directory);
    const auto file = [&](const char *map) { return directory / (name + "." + map + ".png"); };
    return {writeImage(baseColor, image.size, 3, OIIO::TypeUInt8, true, file("base_color")),
            writeImage(normal, image.size, 3, OIIO::TypeUInt16, false, file("normal")),
            writeImage(roughness, image.size, 1, OIIO::TypeUInt8, false, file("roughness")),
            writeImage(metallic, image.size, 1, OIIO::TypeUInt8, false, file("metallic"))};
}

} // namespace render
