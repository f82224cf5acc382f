#include "box.hpp"
#include "maps.hpp"
#include "scenes.hpp"
#include "shapes.hpp"
#include "texture.hpp"

namespace render {
namespace {

using SharedMaterial = std::shared_ptr<const Material>;

std::shared_ptr<const Mesh> share(Mesh mesh) { return std::make_shared<Mesh>(std::move(mesh)); }

std::unique_ptr<World> committed(std::unique_ptr<World> world) {
    world->commit();
    return world;
}

// Phong's terms, each on an object of its own, and their sum.

const Rgb phongDiffuse(0.62f, 0.13f, 0.06f);
constexpr float phongSpecular = 0.35f, phongExponent = 60;
const Rgb ambientLight(0.28f);

SharedMaterial phong(bool ambient, bool diffuse, bool specular) {
    const Rgb d = diffuse ? phongDiffuse : Rgb(0);
    auto material = std::make_shared<Material>(pellicle::BsdfBuilder("phong")
                                                   .set("diffuse", {d.x, d.y, d.z})
                                                   .set("specular", specular ? phongSpecular : 0.0f)
                                                   .set("exponent", phongExponent));
    if (ambient) material->reflectAmbient(phongDiffuse);
    return material;
}

/// Four objects side by side before a grey wall: ambient, diffuse, specular, all. `add` puts one at a place.
View phongRow(const std::string &name,
              const std::function<void(World &world, const V3f &place, SharedMaterial material)> &add) {
    auto world = std::make_unique<World>();
    world->setAmbient(ambientLight);
    constexpr float distance = 2.3f;
    const SharedMaterial materials[] = {phong(true, false, false), phong(false, true, false),
                                        phong(false, false, true), phong(true, true, true)};
    for (int i = 0; i < 4; ++i)
        add(*world, V3f(distance * (static_cast<float>(i) - 1.5f), 0, 0), materials[i]);
    auto wall = std::make_shared<Material>(pellicle::BsdfBuilder("lambert").set("reflectance", 0.05f));
    wall->reflectAmbient(Rgb(0.05f));
    world->add(share(disc(V3f(0, 0, -8), V3f(0, 0, 1), 20)), std::move(wall));
    // Far away, so that the objects' differences in perspective are small.
    return {name, committed(std::move(world)), Camera(V3f(0, 0.9f, 60), V3f(0, 0, 0), 2.2f)};
}

std::vector<View> phongTerms(const Subject &mesh) {
    std::vector<View> views;
    views.push_back(phongRow("spheres", [](World &world, const V3f &place, SharedMaterial material) {
        world.add(Sphere{place, 1}, std::move(material));
    }));
    views.push_back(phongRow(mesh.name, [&](World &world, const V3f &place, SharedMaterial material) {
        world.add(share(placed(*mesh.mesh, 0, place - V3f(0, 1, 0))), std::move(material));
    }));
    return views;
}

// Image textures.

SharedMaterial textured(const MapFiles &files, float repetitions = 1) {
    const auto read = [](const std::filesystem::path &file, Encoding encoding) {
        return std::make_shared<Texture>(file, encoding);
    };
    auto material = std::make_shared<Material>(
        pellicle::BsdfBuilder("metallic_roughness"),
        std::vector<VaryingParameter>{
            {"base_color", 0, 1, imagePattern(read(files.baseColor, Encoding::sRgb), 3, repetitions)},
            {"metallic", 0, 1, imagePattern(read(files.metallic, Encoding::linear), 1, repetitions)},
            {"roughness", 0, 1, imagePattern(read(files.roughness, Encoding::linear), 1, repetitions)}});
    material->mapNormals(normalPattern(read(files.normal, Encoding::linear), repetitions));
    return material;
}

constexpr int mapSize = 1024;

/// Slabs of stone, 1.6 units to an image.
struct Pavement {
    std::shared_ptr<const Mesh> mesh;
    SharedMaterial material;
};
Pavement pavement(const std::filesystem::path &directory) {
    constexpr float half = 40, side = 1.6f;
    const FinishImage image = drawFinish(mapSize, stoneSlabs);
    return {share(square(half)),
            textured(writeMaps(image, reliefNormals(image, 1), directory, "slabs"), 2 * half / side)};
}

SharedMaterial plateMaterial(const std::filesystem::path &directory) {
    const FinishImage image = drawFinish(mapSize, wornPlates);
    return textured(writeMaps(image, reliefNormals(image, 1), directory, "plates"));
}

/// By position, without images.
SharedMaterial bronze() {
    const auto finish = [](const SurfacePoint &point) {
        return patinatedBronze(point.objectPosition, point.shading.normal);
    };
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("metallic_roughness"),
        std::vector<VaryingParameter>{
            {"base_color", 0, 1, {3, [=](const SurfacePoint &point, float *rgb) {
                                      const Rgb color = finish(point).baseColor;
                                      for (int c = 0; c < 3; ++c) rgb[c] = color[c];
                                  }}},
            {"metallic", 0, 1, {1, [=](const SurfacePoint &point, float *x) { *x = finish(point).metallic; }}},
            {"roughness", 0, 1, {1, [=](const SurfacePoint &point, float *x) { *x = finish(point).roughness; }}}});
}

std::vector<View> texturedObjects(const Subject &mesh) {
    const Camera camera(V3f(0, 2.1f, 7.6f), V3f(0, 0.98f, 0), 25);
    const Pavement floor = pavement(mesh.directory);
    auto box = std::make_unique<World>();
    box->add(floor.mesh, floor.material);
    box->add(share(placed(roundedBox(0.88f, 0.12f), 33, V3f(0, 0.88f, 0))), plateMaterial(mesh.directory));

    auto statue = std::make_unique<World>();
    statue->add(floor.mesh, floor.material);
    statue->add(mesh.mesh, bronze());

    std::vector<View> views;
    views.push_back({"box", committed(std::move(box)), camera});
    views.push_back({mesh.name, committed(std::move(statue)), camera});
    return views;
}

// Environment maps.

SharedMaterial silver() {
    return std::make_shared<Material>(
        pellicle::BsdfBuilder("film").film(pellicle::FilmBuilder("Ag").white("D65").create()));
}

/// Floating in the landscape, at the height of the eye.
std::vector<View> mirrors(const Subject &mesh) {
    const Camera camera(V3f(0, 0.5f, 6), V3f(0, 0, 0), 32);
    const SharedMaterial material = silver();
    auto sphere = std::make_unique<World>();
    sphere->add(Sphere{V3f(0), 1.1f}, material);
    auto other = std::make_unique<World>();
    other->add(share(placed(*mesh.mesh, 0, V3f(0, -1, 0))), material);
    std::vector<View> views;
    views.push_back({"sphere", committed(std::move(sphere)), camera});
    views.push_back({mesh.name, committed(std::move(other)), camera});
    return views;
}

} // namespace

std::vector<Chapter> textureChapters() {
    const std::vector<V2f> pair{V2f(1), V2f(1)}, rows{V2f(3, 0.75f), V2f(3, 0.75f)};
    return {
        {"phong",
         1,
         // Phong's light is reflected once.
         {{"phong-terms", "Phong's model and its terms", {rows, phongTerms}, 0, Lighting::lamp, 1, 1, false,
           {{"ambient", "diffuse", "specular", "their sum"}, {}}}}},
        {"textures",
         3,
         {{"textures", "Textures: images on a box, patterns by position on a mesh\nbase colour, normal, roughness, metallic", {pair, texturedObjects},
           -0.8f, Lighting::landscape, 2, 4},
          {"environment-lat-long", "Environment mapping: silver\nlatitude-longitude map", {pair, mirrors},
           -0.4f, Lighting::landscape},
          {"environment-cube", "Environment mapping: silver\ncube map of six images", {pair, mirrors},
           -0.4f, Lighting::landscapeCube}}},
    };
}

} // namespace render
