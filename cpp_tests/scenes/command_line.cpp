// The program as its user meets it.

#include "temporary.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <doctest/doctest.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

namespace {

namespace fs = std::filesystem;

struct Result {
    int exitCode;
    std::string output;
};

/// `redirection`: which stream to read, in the shell's words.
Result run(const std::string &arguments, const char *redirection) {
    FILE *pipe = popen((RENDERER " " + arguments + " " + redirection).c_str(), "r");
    REQUIRE(pipe);
    std::string output;
    for (int c; (c = std::fgetc(pipe)) != EOF;) output += static_cast<char>(c);
    const int status = pclose(pipe);
    REQUIRE(WIFEXITED(status));
    return {WEXITSTATUS(status), output};
}

void checkRefused(const std::string &arguments, const std::string &expected) {
    const Result result = run(arguments, "2>&1 >/dev/null");
    CAPTURE(arguments);
    CAPTURE(result.output);
    CHECK(result.exitCode != 0);
    CHECK(std::count(result.output.begin(), result.output.end(), '\n') == 1);
    CHECK(result.output.back() == '\n');
    CHECK(result.output.find(expected) != std::string::npos);
}

} // namespace

TEST_SUITE_BEGIN("command_line");

TEST_CASE("--list names the scenes") {
    const Result result = run("--list", "2>&1");
    CHECK(result.exitCode == 0);
    CHECK(result.output.find("fig2-old-metal") != std::string::npos);
    CHECK(result.output.find("fig5-thick") != std::string::npos);
    CHECK(result.output.find("titanium") != std::string::npos);
    CHECK(result.output.find("film-spheres") != std::string::npos);
    CHECK(result.output.find("minified-spread") != std::string::npos);
    CHECK(result.output.find("newton-soap") != std::string::npos);
}

TEST_CASE("what cannot be done is refused in one line") {
    const TemporaryDirectory directory;
    std::ofstream(directory / "poem.obj") << "roses are red\n";
    std::ofstream(directory / "broken.exr") << "violets are blue\n";

    checkRefused("--scene fig9", "fig9");
    checkRefused("--size 0", "size");
    checkRefused("--size many", "size");
    checkRefused("--spp -4", "spp");
    checkRefused("--threads -1", "threads");
    checkRefused("--quality best", "best");
    checkRefused("--nonsense", "nonsense");
    checkRefused("--all --scene fig2-clay", "--all");
    checkRefused("--mesh /no/such.obj", "/no/such.obj");
    checkRefused("--mesh " + (directory / "poem.obj"), "poem.obj");
    checkRefused("--env /no/such.exr", "/no/such.exr");
    checkRefused("--env " + (directory / "broken.exr"), "broken.exr");
    checkRefused("--cube-map /no/such/sky.", "/no/such");
    checkRefused("--cube-map " + (directory / "sky."), "sky.px");
    checkRefused("--cube-map sky. --env sky.exr", "--env");
    checkRefused("--out /proc/nowhere --scene fig2-clay --size 16 --spp 1", "/proc/nowhere");
}

TEST_CASE("pictures do not depend on the number of threads, but do on the seed") {
    const TemporaryDirectory directory;
    const auto renderTo = [&](const std::string &name, const std::string &arguments) {
        const std::string out = (directory / name);
        REQUIRE(run("--scene fig5-medium --size 40 --spp 4 --out " + out + " " + arguments, "2>/dev/null")
                    .exitCode == 0);
        for (const char *file : {"fig5-medium.sphere.png", "fig5-medium.bunny.png", "gallery/paper.jpg"})
            CHECK(fs::exists(fs::path(out) / file));
        return out;
    };
    const auto sameExr = [](const std::string &a, const std::string &b) {
        for (const char *file : {"/fig5-medium.sphere.exr", "/fig5-medium.bunny.exr"}) {
            OIIO::ImageBuf first(a + file), second(b + file);
            REQUIRE(first.read());
            REQUIRE(second.read());
            REQUIRE(first.nchannels() == 7);
            if (OIIO::ImageBufAlgo::compare(first, second, 0, 0).maxerror != 0) return false;
        }
        return true;
    };
    const std::string one = renderTo("one", "--seed 7 --threads 1");
    CHECK(sameExr(one, renderTo("two", "--seed 7 --threads 2")));
    CHECK_FALSE(sameExr(one, renderTo("other", "--seed 8 --threads 2")));
}

TEST_CASE("films and their charts are rendered like the figures") {
    const TemporaryDirectory directory;
    const std::string out = (directory / "out");
    const Result result = run("--scene soap --scene newton-soap --scene titanium --size 32 --spp 1 --out " + out,
                              "2>/dev/null");
    CHECK(result.exitCode == 0);
    CHECK(result.output.find("soap.bubble.png: 32 x 32, 4 samples a pixel") != std::string::npos);
    for (const char *file : {"soap.bubble", "soap.frame", "titanium.sphere", "titanium.bunny", "newton-soap"}) {
        CHECK(fs::exists(fs::path(out) / (std::string(file) + ".png")));
        CHECK(fs::exists(fs::path(out) / (std::string(file) + ".exr")));
    }
    for (const char *sheet : {"films.jpg", "newton.jpg"}) CHECK(fs::exists(fs::path(out) / "gallery" / sheet));
}

TEST_CASE("any mesh and environment will do") {
    const TemporaryDirectory directory;
    std::ofstream(directory / "tent.obj")
        << "v 0 2 0\nv -1 0 1\nv 1 0 1\nv 0 0 -1\nf 1 2 3\nf 1 3 4\nf 1 4 2\n";
    OIIO::ImageBuf sky(OIIO::ImageSpec(8, 4, 3, OIIO::TypeFloat));
    OIIO::ImageBufAlgo::fill(sky, {1.0f, 0.5f, 0.25f});
    REQUIRE(sky.write((directory / "sky.hdr")));
    const std::string out = (directory / "out");
    const Result result = run("--scene fig2-clay --size 32 --spp 4 --mesh " + (directory / "tent.obj") +
                                  " --env " + (directory / "sky.hdr") + " --out " + out,
                              "2>/dev/null");
    CHECK(result.exitCode == 0);
    CHECK(result.output.find(out) != std::string::npos);
    OIIO::ImageBuf picture(out + "/fig2-clay.tent.exr");
    REQUIRE(picture.read());
    const auto mean = OIIO::ImageBufAlgo::computePixelStats(picture).avg;
    CHECK(mean[0] > 1.5f * mean[1]);
    CHECK(mean[1] > 1.5f * mean[2]);

    OIIO::ImageBuf face(OIIO::ImageSpec(4, 4, 3, OIIO::TypeFloat));
    OIIO::ImageBufAlgo::fill(face, {0.25f, 0.5f, 1.0f});
    for (const char *name : {"px", "nx", "py", "ny", "pz", "nz"})
        REQUIRE(face.write((directory / "face-") + name + ".hdr"));
    CHECK(run("--scene fig2-clay --size 32 --spp 4 --cube-map " + (directory / "face-") + " --out " + out,
              "2>/dev/null")
              .exitCode == 0);
    OIIO::ImageBuf bluish(out + "/fig2-clay.sphere.exr");
    REQUIRE(bluish.read(0, 0, true));
    const auto blueMean = OIIO::ImageBufAlgo::computePixelStats(bluish).avg;
    CHECK(blueMean[2] > 1.5f * blueMean[1]);
    CHECK(blueMean[1] > 1.5f * blueMean[0]);
}

TEST_CASE("textured scenes write their images and read them back") {
    const TemporaryDirectory directory;
    const std::string out = (directory / "out");
    CHECK(run("--scene textures --size 32 --spp 1 --out " + out, "2>/dev/null").exitCode == 0);
    for (const char *file : {"textures.box.png", "textures.bunny.png", "maps/plates.base_color.png",
                             "maps/plates.normal.png", "maps/slabs.roughness.png",
                             "maps/landscape.exr"})
        CHECK(fs::exists(fs::path(out) / file));
}

TEST_SUITE_END();
