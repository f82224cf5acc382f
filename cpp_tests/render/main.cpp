// pellicle_render: renders the gallery.

#include "gallery.hpp"

#include <cstdio>
#include <exception>

int main(int argc, char **argv) {
    try {
        const render::Options options = render::parseCommandLine(argc, argv);
        if (options.list)
            render::listGallery();
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
