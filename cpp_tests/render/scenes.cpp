#include "scenes.hpp"

#include <stdexcept>

namespace render {
namespace {

/// The variables of the paper's figures (X. Granier and W. Heidrich, "A Simple Layered RGB BRDF
/// Model", Pacific Graphics 2002). Fields without a value here are given by each figure.
struct Layer {
    std::array<float, 3> eta;
    float thicknessMin, thicknessMax; ///< nm
    float specularWeight = 0, diffuseWeight = 0;
    float exponentReflection = 50, exponentTransmission = 50;
    float deviation = 0;  ///< degrees between the two boundaries
    float bumpHeight = 0; ///< instead: the deviation follows the thickness
    const char *variant = "paper";
};

constexpr NoiseField stains{1.9f, 4};
/// Smooth, as its slope turns the lower boundary.
constexpr NoiseField waves{1.5f, 2};

std::shared_ptr<const Material> layered(const Layer &layer) {
    auto bsdf = pellicle::BsdfBuilder("layered")
                    .choose("variant", layer.variant)
                    .set("eta", {layer.eta[0], layer.eta[1], layer.eta[2]})
                    .set("exponent_reflection", layer.exponentReflection)
                    .set("exponent_transmission", layer.exponentTransmission)
                    .set("specular_weight", layer.specularWeight)
                    .set("diffuse_weight", layer.diffuseWeight);
    const NoiseField noise = layer.bumpHeight > 0 ? waves : stains;
    std::vector<VaryingParameter> varying{{"thickness_nm", layer.thicknessMin, layer.thicknessMax,
                                           noiseBetween(layer.thicknessMin, layer.thicknessMax, noise)}};
    if (layer.deviation > 0) varying.push_back({"base_normal", 0, 0, constantDeviation(layer.deviation)});
    if (layer.bumpHeight > 0) varying.push_back({"base_normal", 0, 0, bump(layer.bumpHeight, noise)});
    return std::make_shared<Material>(bsdf, std::move(varying));
}

Scene scene(std::string name, std::string caption, const Layer &layer, float exposure = 0) {
    return {std::move(name), std::move(caption), sphereAndMesh([layer] { return layered(layer); }), exposure};
}

std::array<float, 3> everywhere(float eta) { return {eta, eta, eta}; }

/// Figure 2: diffuse only. The paper gives no weight; half makes rho_d / 2, which is an albedo.
Layer figure2(float eta, float min, float max) { return {everywhere(eta), min, max, 0, 0.5f}; }

/// Figures 3 and 4 share indices, exponents and heights.
Layer figure3(float diffuseWeight) { return {{1.4f, 1.45f, 1.6f}, 66, 76, 1, diffuseWeight, 90, 170}; }

Layer figure3Deviated() {
    Layer layer = figure3(0.7f);
    layer.deviation = 10;
    return layer;
}

/// Figure 4: specular only, normal and thickness vary together.
Layer figure4() {
    Layer layer = figure3(0);
    layer.bumpHeight = 0.14f;
    return layer;
}

Layer figure5(float min, float max) { return {{1.5f, 1.6f, 1.8f}, min, max, 1, 0.5f, 130, 130, 14}; }

/// The same look in the variant that conserves energy, its weights divided by their sum.
Layer conserving(Layer layer) {
    const float sum = layer.specularWeight + layer.diffuseWeight;
    layer.specularWeight /= sum;
    layer.diffuseWeight /= sum;
    layer.variant = "energy";
    return layer;
}

} // namespace

const std::vector<Scene> &scenes() {
    static const std::vector<Scene> all{
        scene("fig2-old-metal", "Figure 2: old metal\n1-30 nm, index 1.5, diffuse", figure2(1.5f, 1, 30),
              -0.4f),
        scene("fig2-colourful", "Figure 2: colourful\n1-210 nm, index 1.3, diffuse", figure2(1.3f, 1, 210)),
        scene("fig2-clay", "Figure 2: clay\n67-73 nm, index 1.4, diffuse", figure2(1.4f, 67, 73)),
        scene("fig3-parallel", "Figure 3: parallel boundaries\n66-76 nm, 1.4 / 1.45 / 1.6", figure3(0.7f)),
        scene("fig3-deviated", "Figure 3: deviation 10 degrees\n66-76 nm, 1.4 / 1.45 / 1.6",
              figure3Deviated()),
        scene("fig4-oil", "Figure 4: deviation follows thickness\n66-76 nm, specular only", figure4(), 0.8f),
        scene("fig5-thin", "Figure 5: deviation 14 degrees\n1-30 nm, 1.5 / 1.6 / 1.8", figure5(1, 30), -0.4f),
        scene("fig5-medium", "Figure 5: deviation 14 degrees\n79-106 nm, 1.5 / 1.6 / 1.8", figure5(79, 106)),
        scene("fig5-thick", "Figure 5: deviation 14 degrees\n146-200 nm, 1.5 / 1.6 / 1.8", figure5(146, 200), -0.2f),
        scene("fig5-thick-energy", "Figure 5, energy-conserving variant\n146-200 nm, weights 2/3 and 1/3",
              conserving(figure5(146, 200)), -0.6f),
    };
    return all;
}

const std::vector<Chapter> &chapters() {
    static const std::vector<Chapter> all = [] {
        std::vector<Chapter> list{heroChapter(), {"paper", 5, scenes()}, {"films", 6, filmScenes()}, lensChapter(),
                                  minifiedFilmChapter()};
        for (Chapter &chapter : microfacetChapters()) list.push_back(std::move(chapter));
        for (Chapter &chapter : textureChapters()) list.push_back(std::move(chapter));
        return list;
    }();
    return all;
}

const Scene &sceneNamed(const std::string &name) {
    for (const Chapter &chapter : chapters())
        for (const Scene &scene : chapter.scenes)
            if (scene.name == name) return scene;
    throw std::runtime_error("there is no scene \"" + name + "\"; --list shows those there are");
}

} // namespace render
