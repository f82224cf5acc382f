// The light of a scene.
#pragma once

#include "environment.hpp"

namespace render {

enum class Lighting {
    evening,  ///< a quay at sunset, photographed: for the hero
    studio,   ///< narrow soft boxes: for highlights of rough surfaces
    darkRoom, ///< wide soft boxes and nothing else: for what is transparent or reflects little
    tent,     ///< wide soft boxes with grey gaps: for metals
    sky,      ///< a clouded sky: for mirrors that lie flat
    window,   ///< a room with a window of small panes: for all from mirrors to what is matt
    spot,     ///< a lamp at the upper left in a dim room: for the shapes of highlights
    front,    ///< one lamp beside the camera: for how matt surfaces darken towards their outlines
    lamp,     ///< a lamp at the upper left and nothing else: for highlights by themselves
    landscape,     ///< sky, sun, hills and a meadow, as a latitude-longitude map
    landscapeCube, ///< the same as a cube map
};

/// Landscapes are written into `directory`, as images, and read from there; it is made if missing. Throws
/// std::runtime_error.
Environment environmentOf(Lighting lighting, const std::filesystem::path &directory);

} // namespace render
