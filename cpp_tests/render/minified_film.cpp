#include "minified_film.hpp"

#include "scenes.hpp"
#include "shapes.hpp"
#include "stacks.hpp"

namespace render {
namespace {

constexpr float thicknessMax = 320, meanThickness = 160, broadDeviation = 22, fineDeviation = 28;
/// A pixel that averages all of both has 35.6 nm, and one that happens to see larger waves a little more.
constexpr float deviationMax = 45;

constexpr float half = 400;
constexpr float fineSide = 0.6f, broadSide = 12;

Scene sceneOf(std::string name, std::string caption, Minification minification, float effort) {
    const auto make = [minification](const Subject &subject) {
        const auto moments = std::make_shared<Texture>(writeMoments(subject.directory), Encoding::linear);
        std::vector<View> views;
        views.push_back({"", anodisedSheet(unevenOxide(minification, moments)), overSheet()});
        return views;
    };
    return {std::move(name), std::move(caption), {{V2f(1)}, make}, 0.6f, Lighting::sky, effort};
}

} // namespace

std::shared_ptr<const Material> unevenOxide(Minification minification, std::shared_ptr<const Texture> moments) {
    const ThicknessMap map(std::move(moments), meanThickness,
                           {{fineDeviation, 2 * half / fineSide}, {broadDeviation, 2 * half / broadSide}});
    std::vector<VaryingParameter> varying{{"thickness_nm", 0, thicknessMax, map.thickness(minification)}};
    pellicle::FilmBuilder film = anodisedTitanium().film(thicknessMax);
    if (minification == Minification::meanAndDeviation) {
        film.thickness_spread_max(deviationMax);
        varying.push_back({"thickness_spread_nm", 0, deviationMax, map.deviation(deviationMax)});
    }
    return std::make_shared<Material>(pellicle::BsdfBuilder("film").film(film.create()), std::move(varying));
}

std::unique_ptr<World> anodisedSheet(std::shared_ptr<const Material> material) {
    auto world = std::make_unique<World>();
    world->add(std::make_shared<Mesh>(square(half)), std::move(material));
    world->commit();
    return world;
}

Camera overSheet() { return Camera(V3f(0, 2, 0), V3f(0, 0.05f, -4), 44); }

Chapter minifiedFilmChapter() {
    return {"minified",
            3,
            {sceneOf("minified-mean", "Mean thickness of a pixel\nTiO2 on titanium, 160 nm, uneven by 22 and 28 nm",
                     Minification::mean, 0.25f),
             sceneOf("minified-spread", "Mean and standard deviation\nfrom the mip map, as thickness_spread_nm",
                     Minification::meanAndDeviation, 0.25f),
             sceneOf("minified-truth", "Truth\nfull detail, 64 times as many samples", Minification::none, 16)}};
}

} // namespace render
