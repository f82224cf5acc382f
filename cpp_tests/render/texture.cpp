#include "texture.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <stdexcept>

namespace render {

std::shared_ptr<OIIO::TextureSystem> sharedTextureSystem() {
    static const std::shared_ptr<OIIO::TextureSystem> system(
        OIIO::TextureSystem::create(true), [](OIIO::TextureSystem *s) { OIIO::TextureSystem::destroy(s); });
    return system;
}

Texture::Texture(const std::filesystem::path &file, Encoding encoding)
    : system_(sharedTextureSystem()) {
    const auto fail = [&](const std::string &why) {
        throw std::runtime_error("cannot read the texture " + file.string() + ": " + why);
    };
    OIIO::ImageBuf image(file.string());
    if (!image.read(0, 0, true, OIIO::TypeFloat)) fail(image.geterror());
    if (encoding == Encoding::sRgb) image = OIIO::ImageBufAlgo::colorconvert(image, "sRGB", "linear");
    if (image.has_error()) fail(image.geterror());
    channels_ = std::min(image.nchannels(), 3);

    const std::string prepared = file.string() + ".tx";
    OIIO::ImageSpec config;
    config.format = OIIO::TypeHalf;
    config.attribute("maketx:fileformatname", "openexr");
    config.attribute("wrapmodes", "periodic,periodic");
    if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, prepared, config))
        fail(OIIO::geterror());
    const OIIO::ustring name(prepared);
    system_->invalidate(name); // it may have been read before it was written anew
    handle_ = system_->get_texture_handle(name);
    if (!system_->good(handle_)) fail(system_->geterror());
}

void Texture::lookUp(const SurfacePoint &point, float repetitions, int channels, float *result) const {
    OIIO::TextureOpt options;
    options.swrap = options.twrap = OIIO::TextureOpt::WrapPeriodic;
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    const V2f across = point.footprint[0] * repetitions, along = point.footprint[1] * repetitions;
    // OpenImageIO's t runs downwards.
    const int read = std::min(channels, channels_);
    if (!system_->texture(handle_, system_->get_perthread_info(), options, point.uv.x * repetitions,
                          1 - point.uv.y * repetitions, across.x, -across.y, along.x, -along.y, read, result))
        throw std::runtime_error("cannot read a texture: " + system_->geterror());
    for (int channel = read; channel < channels; ++channel) result[channel] = result[read - 1];
}

Pattern imagePattern(std::shared_ptr<const Texture> texture, int components, float repetitions) {
    return {components, [=](const SurfacePoint &point, float *numbers) {
                texture->lookUp(point, repetitions, components, numbers);
            }};
}

Pattern normalPattern(std::shared_ptr<const Texture> texture, float repetitions) {
    return {3, [=](const SurfacePoint &point, float *direction) {
                texture->lookUp(point, repetitions, 3, direction);
                for (int axis = 0; axis < 3; ++axis) direction[axis] = 2 * direction[axis] - 1;
                constexpr float leastHeight = 0.05f;
                direction[2] = std::max(direction[2], leastHeight);
            }};
}

} // namespace render
