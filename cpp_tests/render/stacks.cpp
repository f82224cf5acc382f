#include "stacks.hpp"

namespace render {

const Stack &soap() {
    static const Stack stack{"soap", "Soap film", "water", pellicle::Medium::constant(1), 3};
    return stack;
}

const Stack &oilOnWater() {
    static const Stack stack{"oil", "Oil on water", "oil", "water", 3};
    return stack;
}

const Stack &anodisedTitanium() {
    static const Stack stack{"titanium", "TiO2 on titanium", "TiO2", "Ti", 0};
    return stack;
}

const Stack &temperedSteel() {
    static const Stack stack{"steel", "Fe3O4 on iron", "Fe3O4", "Fe", 0};
    return stack;
}

const Stack &coatedGlass() {
    static const Stack stack{"glass", "MgF2 on glass", "MgF2", "BK7", 3};
    return stack;
}

const Stack &oxidisedSilicon() {
    static const Stack stack{"silicon", "SiO2 on silicon", "SiO2", "Si", 1};
    return stack;
}

std::vector<Stack> stacks() {
    return {soap(), oilOnWater(), anodisedTitanium(), temperedSteel(), coatedGlass(), oxidisedSilicon()};
}

} // namespace render
