#include "lighting.hpp"

#include "studio.hpp"

#include <stdexcept>

namespace render {

LatLongMap mapOf(Lighting lighting) {
    switch (lighting) {
    case Lighting::studio: return studio();
    case Lighting::darkRoom: return darkRoom();
    case Lighting::tent: return tent();
    case Lighting::sky: return cloudedSky();
    }
    throw std::logic_error("an unknown lighting");
}

} // namespace render
