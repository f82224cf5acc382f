// The command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace render {

struct Options {
    bool list = false;
    std::vector<std::string> scenes; ///< empty: all
    std::filesystem::path mesh, environment, out = "out";
    std::string cubeMap; ///< what the names of the six images begin with; empty: none
    int size, samplesPerPixel;
    int threads = 0;
    std::uint32_t seed = 1;
};

/// The program is to end at once with this exit code: after --help, for example.
struct Exit {
    int code;
};

/// Throws Exit, or std::runtime_error with one line for a bad command line.
Options parseCommandLine(int argc, char **argv);

} // namespace render
