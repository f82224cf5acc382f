#include "scenes.hpp"
#include "stacks.hpp"

namespace render {
namespace {

using SharedMaterial = std::shared_ptr<const Material>;

/// Reflects and does not transmit: what is below the film is taken to swallow the light, as metals and
/// deep water do.
SharedMaterial mirror(const Stack &stack, float thicknessMax, Pattern thickness) {
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("film").film(stack.film(thicknessMax).create()),
        std::vector<VaryingParameter>{{"thickness_nm", 0, thicknessMax, std::move(thickness)}});
}

SharedMaterial soapMaterial() {
    constexpr float max = 800;
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("film").film(soap().film(max).transmittance().create()),
        std::vector<VaryingParameter>{
            {"thickness_nm", 0, max, draining(V3f(0, -1, 0), -0.86f, 1, 660, 0.42f)}});
}

SharedMaterial oilMaterial() { return mirror(oilOnWater(), 800, stirred(-160, 720, 1.5f)); }

SharedMaterial titaniumMaterial() {
    std::vector<float> thicknesses;
    for (float thickness = 0; thickness <= 150; thickness += 12.5f) thicknesses.push_back(thickness);
    return mirror(anodisedTitanium(), 150, steps(V3f(0, 1, 0), -1, 1, thicknesses));
}

SharedMaterial steelMaterial() {
    return mirror(temperedSteel(), 100, draining(V3f(1, 0, 0), -0.9f, 0.9f, 75, 0.25f));
}

/// A quarter of 550 nm in the layer, on the right half only.
SharedMaterial glassMaterial() { return mirror(coatedGlass(), 100, steps(V3f(1, 0, 0), -1, 1, {0, 100})); }

SharedMaterial siliconMaterial() {
    std::vector<float> thicknesses;
    for (float thickness = 0; thickness <= 500; thickness += 50) thicknesses.push_back(thickness);
    return mirror(oxidisedSilicon(), 500, steps(V3f(1, 0, 0), -1, 1, thicknesses));
}

} // namespace

const std::vector<Scene> &filmScenes() {
    const Floor pale{0.5f, 0.2f}, dark{0.006f, 0.002f};
    static const std::vector<Scene> all{
        {"soap", "Soap, draining\n0 nm at the top, 660 nm below", bubbleAndFrame(soapMaterial), 2.6f,
         Lighting::darkRoom, 4, 12},
        {"oil", "Oil on deep water\n0-720 nm, two angles", dish(oilMaterial), 3, Lighting::sky},
        {"titanium", "Anodised titanium\nTiO2 in steps of 12.5 nm", sphereAndMesh(titaniumMaterial, pale), 0.2f,
         Lighting::tent},
        {"steel", "Tempered steel\nFe3O4 from 0 to 75 nm", sphereAndMesh(steelMaterial, pale), 0.4f,
         Lighting::tent},
        {"glass", "Glass, its right half coated\nMgF2, 100 nm", sphereAndMesh(glassMaterial, dark), 3.5f,
         Lighting::darkRoom},
        {"silicon", "Oxidised silicon\nSiO2 in steps of 50 nm", waferAndMesh(siliconMaterial, pale), 0.6f,
         Lighting::tent},
    };
    return all;
}

} // namespace render
