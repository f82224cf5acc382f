// pellicle_render: renders the gallery.

#include "options.hpp"
#include "progress.hpp"
#include "render.hpp"
#include "scenes.hpp"
#include "sheet.hpp"
#include "stage.hpp"
#include "studio.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace render {
namespace {

namespace fs = std::filesystem;

void list() {
    for (const Scene &scene : scenes()) {
        std::string caption = scene.caption;
        for (std::size_t i; (i = caption.find('\n')) != std::string::npos;) caption.replace(i, 1, "; ");
        std::printf("%-20s %s\n", scene.name.c_str(), caption.c_str());
    }
}

std::vector<Scene> chosenScenes(const std::vector<std::string> &names) {
    if (names.empty()) return scenes();
    std::vector<Scene> chosen;
    for (const std::string &name : names) {
        const auto known = std::find_if(scenes().begin(), scenes().end(),
                                        [&](const Scene &scene) { return scene.name == name; });
        if (known == scenes().end())
            throw std::runtime_error("there is no scene \"" + name + "\"; --list shows those there are");
        chosen.push_back(*known);
    }
    return chosen;
}

void makeDirectory(const fs::path &directory) {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
        throw std::runtime_error("cannot make the directory " + directory.string() + ": " + error.message());
}

/// What is shown. No mesh: a sphere.
struct Subject {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
};

Subject readMesh(const fs::path &file) {
    const fs::path actual = file.empty() ? fs::path(PELLICLE_RENDER_DEFAULT_MESH) : file;
    auto mesh = std::make_shared<Mesh>(readObj(actual));
    standOnFloor(*mesh);
    const std::string name = actual.stem().string();
    return {name == "sphere" ? "sphere-mesh" : name, std::move(mesh)};
}

void renderGallery(const Options &options) {
    const std::vector<Scene> chosen = chosenScenes(options.scenes);
    const Environment environment(options.environment.empty() ? studio()
                                                              : readLatLongMap(options.environment));
    const Subject subjects[] = {{"sphere", nullptr}, readMesh(options.mesh)};
    makeDirectory(options.out);

    RenderSettings settings;
    settings.width = settings.height = options.size;
    settings.samplesPerPixel = options.samplesPerPixel;
    settings.seed = options.seed;
    settings.threads = options.threads;
    settings.path.indirectLimit = 2;

    std::vector<Cell> cells;
    {
        Progress progress(static_cast<double>(options.size) * options.size * std::size(subjects) *
                          chosen.size());
        for (const Scene &scene : chosen) {
            cells.push_back({scene.caption, {}});
            for (const Subject &subject : subjects) {
                const std::string name = scene.name + "." + subject.name;
                progress.label(name);
                const auto world = stage(subject.mesh, scene.material());
                const Picture picture = renderPicture(*world, environment, stageCamera(), settings,
                                                      [&](int pixels) { progress.advance(pixels); });
                writeExr(picture, options.out / (name + ".exr"));
                cells.back().pictures.push_back(display(picture, scene.exposure));
                writePng(cells.back().pictures.back(), options.out / (name + ".png"));
            }
        }
    }
    writePng(contactSheet(cells), options.out / "gallery.png");
    std::printf("%zu pictures (.png to look at, .exr linear) and gallery.png are in %s\n",
                cells.size() * std::size(subjects), fs::absolute(options.out).lexically_normal().c_str());
}

} // namespace
} // namespace render

int main(int argc, char **argv) {
    try {
        const render::Options options = render::parseCommandLine(argc, argv);
        if (options.list)
            render::list();
        else
            render::renderGallery(options);
        return 0;
    } catch (const render::Exit &exit) {
        return exit.code;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "pellicle_render: %s\n", error.what());
        return 1;
    }
}
