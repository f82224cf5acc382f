#include "gallery.hpp"

#include "chart.hpp"
#include "environment_chart.hpp"
#include "progress.hpp"
#include "render.hpp"
#include "scenes.hpp"
#include "sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

namespace render {
namespace {

namespace fs = std::filesystem;

/// Inside the pictures' directory: images that scenes are made of.
constexpr const char *mapsDirectory = "maps";

constexpr int chartWidth = 500, chartHeight = 250;
/// Of a chart's work, in pixels of a picture: it goes by unnoticed.
constexpr double chartWork = 1;

/// Of the spheres that show an environment, and the work of all, in pixels of a picture.
constexpr int environmentSphereSize = 128;
constexpr double environmentWork = 4e5;

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
    std::vector<Chapter> chapters;
    std::vector<EnvironmentChart> environments;
    std::vector<Chart> charts;
};

Choice choose(std::vector<std::string> names) {
    const bool everything = names.empty();
    Choice choice;
    for (const Chapter &chapter : chapters())
        choice.chapters.push_back({chapter.columns, chosen(chapter.scenes, everything, names)});
    choice.environments = chosen(environmentCharts(), everything, names);
    choice.charts = chosen(charts(), everything, names);
    if (!names.empty())
        throw std::runtime_error("there is no scene \"" + names.front() + "\"; --list shows those there are");
    return choice;
}

Subject readSubject(const fs::path &file, const fs::path &directory) {
    const fs::path actual = file.empty() ? fs::path(PELLICLE_RENDER_DEFAULT_MESH) : file;
    auto mesh = std::make_shared<Mesh>(readObj(actual));
    standOnFloor(*mesh);
    const std::string name = actual.stem().string();
    return {name == "sphere" ? "sphere-mesh" : name, std::move(mesh), directory};
}

class Gallery {
public:
    explicit Gallery(const Options &options)
        : options_(options),
          choice_(choose(options.scenes)),
          subject_(readSubject(options.mesh, options.out / mapsDirectory)) {
        if (!options.environment.empty()) given_.emplace(readLatLongMap(options.environment));
        if (!options.cubeMap.empty()) given_.emplace(readCubeMap(options.cubeMap));
        makeDirectory(options.out);
    }

    /// How many files there are to look at.
    std::size_t render() {
        Progress progress(totalWork());
        std::vector<Section> sections;
        for (const Chapter &chapter : choice_.chapters) sections.push_back(chapterInSection(chapter, progress));
        sections.push_back(environmentsInSection(progress));
        sections.push_back(chartsInSection(progress));
        writePng(contactSheet(sections), options_.out / "gallery.png");
        return written_;
    }

private:
    V2i sizeOf(const V2f &extent) const {
        const auto pixels = [&](float side) {
            return static_cast<int>(std::lround(side * static_cast<float>(options_.size)));
        };
        return {pixels(extent.x), pixels(extent.y)};
    }

    double totalWork() const {
        double work = chartWork * static_cast<double>(choice_.charts.size()) +
                      environmentWork * static_cast<double>(choice_.environments.size());
        for (const Chapter &chapter : choice_.chapters) {
            for (const Scene &scene : chapter.scenes) {
                for (const V2f &extent : scene.views.extents) {
                    const V2i size = sizeOf(extent);
                    work += static_cast<double>(size.x) * size.y * scene.effort;
                }
            }
        }
        return work;
    }

    const Environment &environmentOf(Lighting lighting) {
        if (given_) return *given_;
        const auto found = environments_.find(lighting);
        if (found != environments_.end()) return found->second;
        return environments_.emplace(lighting, render::environmentOf(lighting, subject_.directory)).first->second;
    }

    Section chapterInSection(const Chapter &chapter, Progress &progress) {
        Section section{chapter.columns, 1, {}};
        for (const Scene &scene : chapter.scenes) {
            const V2f &extent = scene.views.extents.front();
            section.aspect = extent.y / extent.x;
            section.cells.push_back(
                {scene.caption, pictures(scene, progress), scene.labels.columns, scene.labels.rows});
        }
        return section;
    }

    std::vector<OIIO::ImageBuf> pictures(const Scene &scene, Progress &progress) {
        RenderSettings settings;
        settings.samplesPerPixel =
            std::max(1, static_cast<int>(static_cast<float>(options_.samplesPerPixel) * scene.effort));
        settings.seed = options_.seed;
        settings.threads = options_.threads;
        settings.path.indirectLimit = 2;
        settings.path.maxBounces = scene.maxBounces;

        std::vector<OIIO::ImageBuf> shown;
        progress.label(scene.name);
        const std::vector<View> views = scene.views.make(subject_);
        for (std::size_t i = 0; i < views.size(); ++i) {
            const View &view = views[i];
            const V2i size = sizeOf(scene.views.extents.at(i));
            settings.width = size.x;
            settings.height = size.y;
            const std::string name = scene.name + "." + view.name;
            progress.label(name);
            const Picture picture =
                renderPicture(*view.world, environmentOf(scene.lighting), view.camera, settings,
                              [&](int done) { progress.advance(static_cast<double>(done) * scene.effort); });
            writeExr(picture, options_.out / (name + ".exr"));
            shown.push_back(scene.lighting == Lighting::evening ? photograph(picture, scene.exposure)
                                                                : display(picture, scene.exposure));
            writePng(shown.back(), options_.out / (name + ".png"));
            ++written_;
        }
        return shown;
    }

    /// Writes a chart and puts it on the sheet.
    void add(Section &section, const std::string &name, const std::string &caption, const OIIO::ImageBuf &linear,
             const OIIO::ImageBuf &shown) {
        writeExr(linear, options_.out / (name + ".exr"));
        writePng(shown, options_.out / (name + ".png"));
        section.aspect = static_cast<float>(shown.spec().height) / static_cast<float>(shown.spec().width);
        section.cells.push_back({caption, {shown}, {}, {}});
        ++written_;
    }

    Section environmentsInSection(Progress &progress) {
        Section section{1, 0.5f, {}};
        if (choice_.environments.empty()) return section;
        const AlbedoTable albedo(options_.threads);
        for (const EnvironmentChart &chart : choice_.environments) {
            progress.label(chart.name);
            const EnvironmentSpheres spheres =
                environmentSpheres(chart, albedo, environmentSphereSize, subject_.directory, options_.threads);
            add(section, chart.name, chart.caption, spheres.radiance, displaySpheres(spheres, chart.exposure));
            progress.advance(environmentWork);
        }
        return section;
    }

    Section chartsInSection(Progress &progress) {
        Section section{3, 0.5f, {}};
        for (const Chart &chart : choice_.charts) {
            progress.label(chart.name);
            const OIIO::ImageBuf linear = reflectanceChart(chart.stack, chartWidth, chartHeight);
            add(section, chart.name, chart.caption, linear, displayChart(linear, chart.exposure));
            progress.advance(chartWork);
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
    for (const Chapter &chapter : chapters())
        for (const Scene &scene : chapter.scenes) list(scene.name, scene.caption);
    for (const EnvironmentChart &chart : environmentCharts()) list(chart.name, chart.caption);
    for (const Chart &chart : charts()) list(chart.name, chart.caption);
}

void renderGallery(const Options &options) {
    const std::size_t count = Gallery(options).render();
    std::printf("%zu pictures (.png to look at, .exr linear) and gallery.png are in %s\n", count,
                fs::absolute(options.out).lexically_normal().c_str());
}

} // namespace render
