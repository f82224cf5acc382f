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
    bool all = false;                ///< the whole gallery
    std::vector<std::string> scenes; ///< empty: all, or the first look
    std::filesystem::path mesh, environment, out = "out";
    std::string cubeMap; ///< what the names of the six images begin with; empty: none
    /// None: the first look chooses for itself.
    std::optional<int> size, samplesPerPixel;
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
