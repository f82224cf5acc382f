#include "gallery.hpp"

#include "chart.hpp"
#include "cube_map.hpp"
#include "progress.hpp"
#include "render.hpp"
#include "scenes.hpp"
#include "sheet.hpp"

#include <algorithm>
#include <chrono>
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

/// Without --all and --scene: a first look in less than a minute. The hero is 640 x 360.
struct FirstLook {
    const char *chapter;
    int size, samplesPerPixel;
};
constexpr FirstLook firstLook[] = {{"hero", 128, 32}, {"paper", 192, 16}};

void list(const std::string &name, std::string caption) {
    for (std::size_t i; (i = caption.find('\n')) != std::string::npos;)
        caption.replace(i, 1, i + 1 < caption.size() ? "; " : "");
    std::printf("%-20s %s\n", name.c_str(), caption.c_str());
}

/// A chapter of which some scenes are rendered.
struct Job {
    Chapter chapter;
    int size, samplesPerPixel;
    bool effort; ///< scenes take their multiple of the samples

    int samplesOf(const Scene &scene) const {
        const float share = effort ? scene.effort : 1;
        return std::max(1, static_cast<int>(static_cast<float>(samplesPerPixel) * share));
    }

    V2i pixelsOf(const V2f &extent) const {
        const auto pixels = [&](float side) { return static_cast<int>(std::lround(side * static_cast<float>(size))); };
        return {pixels(extent.x), pixels(extent.y)};
    }
};

struct Choice {
    std::vector<Job> jobs;
    std::vector<Chart> charts;
};

/// The scenes of `all` that are named, each name crossed off.
template <typename T>
std::vector<T> named(const std::vector<T> &all, std::vector<std::string> &names) {
    std::vector<T> list;
    for (const T &item : all) {
        const auto rest = std::remove(names.begin(), names.end(), item.name);
        if (rest != names.end()) list.push_back(item);
        names.erase(rest, names.end());
    }
    return list;
}

Choice choose(const Options &options) {
    Choice choice;
    if (options.all || !options.scenes.empty()) {
        std::vector<std::string> names = options.scenes;
        for (Chapter chapter : chapters()) {
            if (!options.all) chapter.scenes = named(chapter.scenes, names);
            if (!chapter.scenes.empty())
                choice.jobs.push_back({chapter, *options.size, *options.samplesPerPixel, true});
        }
        choice.charts = options.all ? charts() : named(charts(), names);
        if (!names.empty())
            throw std::runtime_error("there is no scene \"" + names.front() + "\"; --list shows those there are");
        return choice;
    }
    for (const FirstLook &look : firstLook)
        for (const Chapter &chapter : chapters())
            if (chapter.name == look.chapter)
                choice.jobs.push_back({chapter, options.size.value_or(look.size),
                                       options.samplesPerPixel.value_or(look.samplesPerPixel), false});
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
          choice_(choose(options)),
          subject_(readSubject(options.mesh, options.out / mapsDirectory)) {
        if (!options.environment.empty()) given_.emplace(readLatLongMap(options.environment));
        if (!options.cubeMap.empty()) given_.emplace(unrolled(readCubeMap(options.cubeMap)));
        makeDirectory(options.out);
    }

    void render() {
        Progress progress(totalWork());
        for (const Job &job : choice_.jobs) {
            Section section{job.chapter.columns, 1, {}};
            for (const Scene &scene : job.chapter.scenes) {
                const V2f &extent = scene.views.extents.front();
                section.aspect = extent.y / extent.x;
                section.cells.push_back(
                    {scene.caption, pictures(job, scene, progress), scene.labels.columns, scene.labels.rows});
            }
            writeSheet(job.chapter.name, section);
        }
        drawCharts(progress);
    }

private:
    double totalWork() const {
        double work = static_cast<double>(choice_.charts.size());
        for (const Job &job : choice_.jobs)
            for (const Scene &scene : job.chapter.scenes)
                for (const V2f &extent : scene.views.extents) {
                    const V2i pixels = job.pixelsOf(extent);
                    work += static_cast<double>(pixels.x) * pixels.y * job.samplesOf(scene);
                }
        return work;
    }

    const Environment &environmentOf(Lighting lighting) {
        if (given_) return *given_;
        const auto found = environments_.find(lighting);
        if (found != environments_.end()) return found->second;
        return environments_.emplace(lighting, render::environmentOf(lighting, subject_.directory)).first->second;
    }

    std::vector<OIIO::ImageBuf> pictures(const Job &job, const Scene &scene, Progress &progress) {
        using Clock = std::chrono::steady_clock;
        RenderSettings settings;
        settings.samplesPerPixel = job.samplesOf(scene);
        settings.seed = options_.seed;
        settings.threads = options_.threads;
        settings.path.indirectLimit = 2;
        settings.path.maxBounces = scene.maxBounces;

        std::vector<OIIO::ImageBuf> shown;
        Clock::time_point start = Clock::now();
        progress.label(scene.name);
        const std::vector<View> views = scene.views.make(subject_);
        for (std::size_t i = 0; i < views.size(); ++i, start = Clock::now()) {
            const View &view = views[i];
            const V2i pixels = job.pixelsOf(scene.views.extents.at(i));
            settings.width = pixels.x;
            settings.height = pixels.y;
            const std::string name = view.name.empty() ? scene.name : scene.name + "." + view.name;
            progress.label(name);
            const Picture picture =
                renderPicture(*view.world, environmentOf(scene.lighting), view.camera, settings, [&](int done) {
                    progress.advance(static_cast<double>(done) * settings.samplesPerPixel);
                });
            writeExr(picture, options_.out / (name + ".exr"));
            shown.push_back(scene.photograph ? photograph(picture, scene.exposure)
                                             : display(picture, scene.exposure));
            writePng(shown.back(), options_.out / (name + ".png"));
            tell(name + ".png", pixels, settings.samplesPerPixel,
                 std::chrono::duration<double>(Clock::now() - start).count());
        }
        return shown;
    }

    void tell(const std::string &file, V2i pixels, int samples, double seconds) const {
        std::printf("%s: %d x %d, %d samples a pixel, %.1f s\n", (options_.out / file).c_str(), pixels.x, pixels.y,
                    samples, seconds);
        std::fflush(stdout);
    }

    /// The pictures of a chapter with their captions. A single picture needs none.
    void writeSheet(const std::string &name, const Section &section) {
        const bool single = section.cells.size() == 1 && section.cells.front().pictures.size() == 1 &&
                            section.cells.front().columns.empty();
        const OIIO::ImageBuf sheet = single ? section.cells.front().pictures.front() : contactSheet(section);
        const fs::path directory = options_.out / "gallery";
        makeDirectory(directory);
        writeJpeg(sheet, directory / (name + ".jpg"));
        std::printf("%s\n", (directory / (name + ".jpg")).c_str());
    }

    void drawCharts(Progress &progress) {
        if (choice_.charts.empty()) return;
        Section section{3, 0.5f, {}};
        for (const Chart &chart : choice_.charts) {
            progress.label(chart.name);
            const OIIO::ImageBuf linear = reflectanceChart(chart.stack, chartWidth, chartHeight);
            const OIIO::ImageBuf shown = displayChart(linear, chart.exposure);
            writeExr(linear, options_.out / (chart.name + ".exr"));
            writePng(shown, options_.out / (chart.name + ".png"));
            section.aspect = static_cast<float>(shown.spec().height) / static_cast<float>(shown.spec().width);
            section.cells.push_back({chart.caption, {shown}, {}, {}});
            std::printf("%s\n", (options_.out / (chart.name + ".png")).c_str());
            progress.advance(1);
        }
        writeSheet("newton", section);
    }

    const Options &options_;
    const Choice choice_;
    const Subject subject_;
    std::optional<Environment> given_; ///< by the user, for all scenes
    std::map<Lighting, Environment> environments_;
};

} // namespace

void listGallery() {
    for (const Chapter &chapter : chapters())
        for (const Scene &scene : chapter.scenes) list(scene.name, scene.caption);
    for (const Chart &chart : charts()) list(chart.name, chart.caption);
}

void renderGallery(const Options &options) { Gallery(options).render(); }

} // namespace render
