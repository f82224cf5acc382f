#include "lat_long_texture.hpp"

#include "texture.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <stdexcept>

namespace render {
namespace {

constexpr int tileSize = 64;

void write(const std::vector<LatLongMap> &maps, Layout layout, const std::string &file) {
    const auto fail = [&](const std::string &why) {
        throw std::runtime_error("cannot write " + file + ": " + why);
    };
    std::vector<OIIO::ImageSpec> specs;
    for (const LatLongMap &map : maps) {
        OIIO::ImageSpec &spec = specs.emplace_back(map.width, map.height, 3, OIIO::TypeFloat);
        spec.tile_width = spec.tile_height = tileSize;
        spec.tile_depth = 1;
        spec.attribute("compression", "none");
        if (layout == Layout::levels) spec.attribute("textureformat", "Plain Texture"); // mip-mapped
    }
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file);
    if (!output) fail(OIIO::geterror());
    const int count = static_cast<int>(maps.size());
    const bool opened = layout == Layout::parts ? output->open(file, count, specs.data())
                                                : output->open(file, specs.front());
    if (!opened) fail(output->geterror());
    for (int i = 0; i < count; ++i) {
        const auto mode = layout == Layout::parts ? OIIO::ImageOutput::AppendSubimage
                                                  : OIIO::ImageOutput::AppendMIPLevel;
        if (i > 0 && !output->open(file, specs[i], mode)) fail(output->geterror());
        if (!output->write_image(OIIO::TypeFloat, maps[i].texels.data())) fail(output->geterror());
    }
    if (!output->close()) fail(output->geterror());
}

} // namespace

LatLongTexture::LatLongTexture(const std::vector<LatLongMap> &maps, Layout layout,
                               const std::filesystem::path &file)
    : system_(sharedTextureSystem()),
      height_(static_cast<float>(maps.at(0).height)) {
    write(maps, layout, file.string());
    const OIIO::ustring name(file.string());
    system_->invalidate(name); // it may have been read before it was written anew
    handle_ = system_->get_texture_handle(name);
    if (!system_->good(handle_)) throw std::runtime_error("cannot read " + file.string() + ": " + system_->geterror());
}

Rgb LatLongTexture::radiance(const V3f &direction, int part, float level) const {
    OIIO::TextureOpt options;
    options.subimage = part;
    options.swrap = OIIO::TextureOpt::WrapPeriodic;
    options.twrap = OIIO::TextureOpt::WrapClamp;
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    options.mipmode = OIIO::TextureOpt::MipModeTrilinear;
    // A level is asked for by the derivatives that make one of its texels.
    const float width = level > 0 ? std::exp2(level) / height_ : 0;
    const V2f point = latLongPoint(direction);
    Rgb result;
    if (!system_->texture(handle_, system_->get_perthread_info(), options, point.x, point.y, width, 0, 0, width, 3,
                          &result.x))
        throw std::runtime_error("cannot read an environment: " + system_->geterror());
    return result;
}

} // namespace render
