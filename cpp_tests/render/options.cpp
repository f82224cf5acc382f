#include "options.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <stdexcept>

namespace render {
namespace {

struct Quality {
    const char *name;
    int size, samplesPerPixel;
};
constexpr Quality qualities[] = {{"draft", 192, 4}, {"normal", 320, 32}, {"high", 512, 128}};

} // namespace

Options parseCommandLine(int argc, char **argv) {
    Options options;
    std::string quality;
    std::vector<std::string> names;
    for (const Quality &q : qualities) names.push_back(q.name);

    CLI::App app{"Renders pellicle's gallery. Without arguments a first look: a small hero and the paper's figures 2-5."};
    app.add_flag("--list", options.list, "List the scenes and end");
    CLI::Option *all = app.add_flag("--all", options.all,
                                    "Render the whole gallery and the hero in full size, which takes long");
    app.add_option("--scene", options.scenes, "Render only this scene, in full size; may be repeated")->excludes(all);
    app.add_option("--quality", quality,
                   "draft, normal or high, which takes ten times as long: sets --size and --spp")
        ->check(CLI::IsMember(names));
    app.add_option("--size", options.size, "Pixels along each side of a square picture")->check(CLI::Range(16, 8192));
    app.add_option("--spp", options.samplesPerPixel,
                   "Samples per pixel, of which some scenes take a multiple; powers of two are best")
        ->check(CLI::Range(1, 65536));
    app.add_option("--mesh", options.mesh, "Wavefront OBJ to show in place of the bunny");
    CLI::Option *environment =
        app.add_option("--env", options.environment, "Latitude-longitude image (EXR, HDR) to light with");
    app.add_option("--cube-map", options.cubeMap,
                   "Six images to light with instead: PREFIXpx.exr and nx, py, ny, pz, nz, of any format")
        ->excludes(environment);
    app.add_option("--out", options.out, "Directory for the pictures; made if missing")
        ->capture_default_str();
    app.add_option("--threads", options.threads, "Threads; 0: one per core")->check(CLI::Range(0, 1024));
    app.add_option("--seed", options.seed, "Other seeds give other noise")->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        if (error.get_exit_code() == 0) throw Exit{app.exit(error)};
        throw std::runtime_error(error.what());
    }

    if (quality.empty() && (options.all || !options.scenes.empty())) quality = "normal";
    for (const Quality &q : qualities) {
        if (quality != q.name) continue;
        options.size = options.size.value_or(q.size);
        options.samplesPerPixel = options.samplesPerPixel.value_or(q.samplesPerPixel);
    }
    return options;
}

} // namespace render
