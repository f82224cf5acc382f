#include "scenes.hpp"
#include "spheres.hpp"
#include "stacks.hpp"

#include <cmath>

namespace render {
namespace {

using SharedMaterial = std::shared_ptr<const Material>;

constexpr float gridSide = 2.55f; ///< a grid takes half the page
const V2f rowExtent{2.55f, 0.5f}, pageExtent{5.1f, 0.5f};

const std::array<float, 5> fifths{0, 0.25f, 0.5f, 0.75f, 1};

SharedMaterial make(const pellicle::BsdfBuilder &bsdf) { return std::make_shared<Material>(bsdf); }

pellicle::BsdfBuilder microfacet(const char *fresnel, float alpha) {
    return pellicle::BsdfBuilder("microfacet").choose("fresnel", fresnel).set("alpha", alpha);
}

/// The exercise: metallic falls from row to row, roughness grows from column to column.
std::vector<Materials> metallicAndRoughness() {
    std::vector<Materials> rows;
    for (auto metallic = fifths.rbegin(); metallic != fifths.rend(); ++metallic) {
        Materials &row = rows.emplace_back();
        for (const float roughness : fifths)
            row.push_back(make(pellicle::BsdfBuilder("metallic_roughness")
                                   .set("base_color", {0.6f, 0.09f, 0.035f})
                                   .set("metallic", *metallic)
                                   .set("roughness", roughness)));
    }
    return rows;
}

/// A film and how thick it is at the top and at the bottom of a sphere, nm.
struct Coating {
    Stack stack;
    float top, bottom;
};

Pattern fromTopToBottom(float top, float bottom) {
    return {1, [=](const SurfacePoint &point, float *number) {
                *number = lerp(bottom, top, (point.objectPosition.y + 1) / 2);
            }};
}

/// alpha is the square of the column's roughness.
std::vector<Materials> filmsAndRoughness() {
    const std::array<Coating, 5> coatings{{
        {anodisedTitanium(), 15, 115},
        {temperedSteel(), 5, 90},
        {oxidisedSilicon(), 60, 330},
        {{"", "", "PMMA", "Au", 0}, 120, 480},
        {{"", "", "TiO2", "BK7", 0}, 20, 320},
    }};
    std::vector<Materials> rows;
    for (const Coating &coating : coatings) {
        Materials &row = rows.emplace_back();
        const pellicle::Film film = coating.stack.film(coating.bottom).create();
        for (const float roughness : fifths)
            row.push_back(std::make_shared<Material>(
                microfacet("film", roughness * roughness).film(film),
                std::vector<VaryingParameter>{
                    {"thickness_nm", 0, coating.bottom, fromTopToBottom(coating.top, coating.bottom)}}));
    }
    return rows;
}

Materials distributions() {
    Materials row;
    for (const char *distribution : {"ggx", "beckmann", "blinn_phong", "abc", "sgd"})
        row.push_back(make(microfacet("schlick", 0.3f).choose("distribution", distribution).set("f0", 0.5f)));
    return row;
}

/// The lecture's comparison: the same reflectance from everywhere, Schlick's, and the exact one.
Materials withAndWithoutFresnel() {
    constexpr float alpha = 0.05f;
    const auto constant = [](float f) { return make(microfacet("schlick", alpha).set("f0", f).set("f90", f)); };
    const auto exact = [](float eta) { return make(microfacet("dielectric", alpha).set("eta", eta)); };
    return {constant(0.04f), make(microfacet("schlick", alpha).set("f0", 0.04f)), exact(1.5f), constant(0.172f),
            exact(2.42f)};
}

/// In the order of the lecture's table of F0. There are no spectra of palladium and zinc here: they
/// have the table's F0 and Schlick's approximation.
Materials metals() {
    constexpr float alpha = 0.1f;
    const auto measured = [](const char *metal) {
        return make(microfacet("conductor", alpha).choose("metal", metal));
    };
    const auto tabulated = [](std::initializer_list<float> f0) {
        return make(microfacet("schlick", alpha).set("f0", f0));
    };
    return {measured("Ti"), measured("Cr"), measured("Fe"), measured("Ni"), measured("Pt"), measured("Cu"),
            tabulated({0.733f, 0.697f, 0.652f}), tabulated({0.664f, 0.824f, 0.850f}), measured("Au"), measured("Al"), measured("Ag")};
}

/// From each row of the lecture's table of dielectrics, with the index that has its F0.
Materials dielectrics() {
    Materials row;
    for (const float eta : {1.333f, 1.5f, 1.65f, 1.77f, 2.42f})
        row.push_back(make(pellicle::BsdfBuilder("metallic_roughness")
                               .set("base_color", {0.02f, 0.022f, 0.028f})
                               .set("roughness", 0.1f)
                               .set("eta", eta)));
    return row;
}

Materials diffuse() {
    constexpr float reflectance = 0.7f;
    const auto orenNayar = [](float sigma) {
        return make(pellicle::BsdfBuilder("oren_nayar").set("reflectance", reflectance).set("sigma_radians", sigma));
    };
    const auto disney = [](float roughness) {
        return make(
            pellicle::BsdfBuilder("disney_diffuse").set("reflectance", reflectance).set("roughness", roughness));
    };
    return {make(pellicle::BsdfBuilder("lambert").set("reflectance", reflectance)), orenNayar(0.3f),
            orenNayar(0.6f), disney(0.5f), disney(1)};
}

const std::vector<std::string> roughnessLabels{"roughness 0", "0.25", "0.5", "0.75", "1"};

Scene grid(std::string name, std::string caption, std::function<std::vector<Materials>()> rows, float exposure,
           std::vector<std::string> labels) {
    Scene scene{std::move(name), std::move(caption), sphereGrid(std::move(rows), gridSide), exposure,
                Lighting::window};
    scene.effort = 4;
    scene.labels = {roughnessLabels, std::move(labels)};
    return scene;
}

Scene row(std::string name, std::string caption, const Views &views, float exposure, Lighting lighting,
          std::vector<std::string> labels) {
    Scene scene{std::move(name), std::move(caption), views, exposure, lighting};
    scene.labels = {std::move(labels), {}};
    return scene;
}

} // namespace

std::vector<Chapter> microfacetChapters() {
    const Floor dark{0.1f, 0.04f};
    return {
        {"spheres",
         2,
         {
             grid("spheres", "The 25 spheres\nmetallic_roughness: GGX, Smith, Schlick over a diffuse body",
                  metallicAndRoughness, 0.8f, {"metallic 1", "0.75", "0.5", "0.25", "0"}),
             grid("film-spheres",
                  "Films on rough surfaces\nmicrofacet with a film as its Fresnel term, alpha = roughness^2",
                  filmsAndRoughness, 0.5f,
                  {"TiO2 on titanium, 15-115 nm", "Fe3O4 on iron, 5-90 nm", "SiO2 on silicon, 60-330 nm",
                   "Acrylic on gold, 120-480 nm", "TiO2 on glass, 20-320 nm"}),
         }},
        {"metals",
         1,
         {
             row("metals",
                 "Metals of the lecture's table\nfrom spectra of measured indices; palladium and zinc from the "
                 "table's F0 by Schlick's approximation",
                 sphereRow(metals, pageExtent), -0.4f, Lighting::tent,
                 {"Titanium", "Chromium", "Iron", "Nickel", "Platinum", "Copper", "Palladium", "Zinc", "Gold",
                  "Aluminium", "Silver"}),
         }},
        {"lobes",
         2,
         {
             row("distributions", "Distributions of normals\nalpha 0.3, each with its own Smith masking",
                 sphereRow(distributions, rowExtent, dark), 0.2f, Lighting::spot,
                 {"GGX", "Beckmann", "Blinn-Phong", "ABC", "Shifted gamma"}),
             row("fresnel", "Without and with Fresnel\nF0 everywhere; Schlick; exact",
                 sphereRow(withAndWithoutFresnel, rowExtent, dark), 1.5f, Lighting::window,
                 {"F = 0.04", "Schlick, F0 = 0.04", "Exact, index 1.5", "F = 0.172", "Exact, index 2.42"}),
             row("dielectrics", "Dielectrics on a dark body\nF0 0.020, 0.040, 0.060, 0.077, 0.172",
                 sphereRow(dielectrics, rowExtent, dark), 1.2f, Lighting::window,
                 {"Water", "Plastic, glass", "Crystal", "Sapphire", "Diamond"}),
             row("diffuse", "Matt surfaces lit from the camera\nreflectance 0.7",
                 sphereRow(diffuse, rowExtent), 0, Lighting::front,
                 {"Lambert", "Oren-Nayar 0.3", "Oren-Nayar 0.6", "Disney 0.5", "Disney 1"}),
         }},
    };
}

} // namespace render
