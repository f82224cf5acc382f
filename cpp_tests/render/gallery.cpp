#include "gallery.hpp"

#include "chart.hpp"
#include "progress.hpp"
#include "render.hpp"
#include "scenes.hpp"
#include "sheet.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <stdexcept>

namespace render {
namespace {

namespace fs = std::filesystem;

constexpr int chartWidth = 500, chartHeight = 250;
/// Of a chart's work, in pixels of a picture: it goes by unnoticed.
constexpr double chartWork = 1;

void list(const std::string &name, std::string caption) {
    for (std::size_t i; (i = caption.find('\n')) != std::string::npos;)
        caption.replace(i, 1, i + 1 < caption.size() ? "; " : "");
    std::printf("%-20s %s\n", name.c_str(), caption.c_str());
}

/// Those of `all` that are named, each name crossed off; all if there are no names.
template <typename T>
std::vector<T> chosen(const std::vector<T> &all, bool everything, std::vector<std::string> &names) {
    if (everything) return all;
    std::vector<T> list;
    for (const T &item : all) {
        const auto rest = std::remove(names.begin(), names.end(), item.name);
        if (rest != names.end()) list.push_back(item);
        names.erase(rest, names.end());
    }
    return list;
}

struct Choice {
    std::vector<Scene> figures, films;
    std::vector<Chart> charts;
};

Choice choose(std::vector<std::string> names) {
    const bool everything = names.empty();
    Choice choice;
    choice.figures = chosen(scenes(), everything, names);
    choice.films = chosen(filmScenes(), everything, names);
    choice.charts = chosen(charts(), everything, names);
    if (!names.empty())
        throw std::runtime_error("there is no scene \"" + names.front() + "\"; --list shows those there are");
    return choice;
}

void makeDirectory(const fs::path &directory) {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
        throw std::runtime_error("cannot make the directory " + directory.string() + ": " + error.message());
}

Subject readSubject(const fs::path &file) {
    const fs::path actual = file.empty() ? fs::path(PELLICLE_RENDER_DEFAULT_MESH) : file;
    auto mesh = std::make_shared<Mesh>(readObj(actual));
    standOnFloor(*mesh);
    const std::string name = actual.stem().string();
    return {name == "sphere" ? "sphere-mesh" : name, std::move(mesh)};
}

class Gallery {
public:
    explicit Gallery(const Options &options)
        : options_(options), choice_(choose(options.scenes)), subject_(readSubject(options.mesh)) {
        if (!options.environment.empty()) given_.emplace(readLatLongMap(options.environment));
        makeDirectory(options.out);
    }

    /// How many files there are to look at.
    std::size_t render() {
        Progress progress(totalWork());
        const Section figures = scenesInSection(choice_.figures, 5, progress);
        const Section films = scenesInSection(choice_.films, 6, progress);
        writePng(contactSheet({figures, films, chartsInSection(progress)}), options_.out / "gallery.png");
        return written_;
    }

private:
    static constexpr int viewsPerScene = 2;

    double pixels() const { return static_cast<double>(options_.size) * options_.size; }

    double totalWork() const {
        double work = chartWork * static_cast<double>(choice_.charts.size());
        for (const auto &list : {choice_.figures, choice_.films})
            for (const Scene &scene : list) work += pixels() * viewsPerScene * scene.effort;
        return work;
    }

    const Environment &environmentOf(Lighting lighting) {
        if (given_) return *given_;
        const auto found = environments_.find(lighting);
        if (found != environments_.end()) return found->second;
        return environments_.emplace(lighting, mapOf(lighting)).first->second;
    }

    Section scenesInSection(const std::vector<Scene> &list, int columns, Progress &progress) {
        Section section{columns, 1, {}};
        for (const Scene &scene : list) section.cells.push_back({scene.caption, pictures(scene, progress)});
        return section;
    }

    std::vector<OIIO::ImageBuf> pictures(const Scene &scene, Progress &progress) {
        RenderSettings settings;
        settings.width = settings.height = options_.size;
        settings.samplesPerPixel = options_.samplesPerPixel * scene.effort;
        settings.seed = options_.seed;
        settings.threads = options_.threads;
        settings.path.indirectLimit = 2;
        settings.path.maxBounces = scene.maxBounces;

        std::vector<OIIO::ImageBuf> shown;
        progress.label(scene.name);
        for (const View &view : scene.views(scene.material(), subject_)) {
            const std::string name = scene.name + "." + view.name;
            progress.label(name);
            const Picture picture =
                renderPicture(*view.world, environmentOf(scene.lighting), view.camera, settings,
                              [&](int done) { progress.advance(static_cast<double>(done) * scene.effort); });
            writeExr(picture, options_.out / (name + ".exr"));
            shown.push_back(display(picture, scene.exposure));
            writePng(shown.back(), options_.out / (name + ".png"));
            ++written_;
        }
        return shown;
    }

    Section chartsInSection(Progress &progress) {
        Section section{3, 0.5f, {}};
        for (const Chart &chart : choice_.charts) {
            progress.label(chart.name);
            const OIIO::ImageBuf linear = reflectanceChart(chart.stack, chartWidth, chartHeight);
            writeExr(linear, options_.out / (chart.name + ".exr"));
            const OIIO::ImageBuf shown = displayChart(linear, chart.exposure);
            writePng(shown, options_.out / (chart.name + ".png"));
            section.aspect = static_cast<float>(shown.spec().height) / static_cast<float>(shown.spec().width);
            section.cells.push_back({chart.caption, {shown}});
            progress.advance(chartWork);
            ++written_;
        }
        return section;
    }

    const Options &options_;
    const Choice choice_;
    const Subject subject_;
    std::optional<Environment> given_; ///< by the user, for all scenes
    std::map<Lighting, Environment> environments_;
    std::size_t written_ = 0;
};

} // namespace

void listGallery() {
    for (const Scene &scene : scenes()) list(scene.name, scene.caption);
    for (const Scene &scene : filmScenes()) list(scene.name, scene.caption);
    for (const Chart &chart : charts()) list(chart.name, chart.caption);
}

void renderGallery(const Options &options) {
    const std::size_t count = Gallery(options).render();
    std::printf("%zu pictures (.png to look at, .exr linear) and gallery.png are in %s\n", count,
                fs::absolute(options.out).lexically_normal().c_str());
}

} // namespace render
