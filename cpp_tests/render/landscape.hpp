// An outdoor environment drawn by formula: sky, sun, clouds, hills and a meadow.
#pragma once

#include "sky.hpp"

namespace render {

/// The radiance of a landscape as a function of the direction, for drawLatLong and drawCube.
class Landscape {
public:
    Landscape();

    Rgb operator()(const V3f &direction) const;

private:
    Rgb clouds(const V3f &direction, const Rgb &behind) const;
    Rgb hills(const V3f &direction, const Rgb &behind) const;
    Rgb meadow(const V3f &direction) const;

    ClearSky sky_;
    Rgb horizontalIrradiance_; ///< of the ground, by sun and sky
};

} // namespace render
