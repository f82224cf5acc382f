// The gallery: pictures of all scenes, charts of all films, and the contact sheet.
#pragma once

#include "options.hpp"

namespace render {

/// Names and captions, to standard output.
void listGallery();

/// Throws std::runtime_error.
void renderGallery(const Options &options);

} // namespace render
