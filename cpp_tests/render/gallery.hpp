// What the program does.
#pragma once

#include "options.hpp"

namespace render {

/// Names and captions of all scenes, on standard output.
void listGallery();

/// Renders what the options choose; tells on standard output where each picture is and how long it took. Throws
/// std::runtime_error or pellicle::Error.
void renderGallery(const Options &options);

} // namespace render
