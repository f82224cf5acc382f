// How long it takes to create films and BSDFs: the worst times that pellicle.h states. Prints Markdown; it takes
// some minutes, and is run by hand.
#include <pellicle.hpp>

#include <chrono>
#include <cstdio>
#include <string>

namespace {

// Seconds of wall time; a refused description counts, too: it was tried.
template <class Builder> double seconds(const Builder &builder) {
    const auto start = std::chrono::steady_clock::now();
    try {
        builder.create();
    } catch (const pellicle::Error &) {
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print(const std::string &name, double time) {
    std::printf("| %s | %.3f |\n", name.c_str(), time);
    std::fflush(stdout);
}

void print_bsdfs() {
    double worst = 0;
    std::string worst_name;
    const auto add = [&](const std::string &name, const pellicle::BsdfBuilder &builder) {
        const double time = seconds(builder);
        if (time <= worst) return;
        worst = time;
        worst_name = name;
    };
    for (std::size_t model = 0; model < pellicle_model_count(); ++model) {
        PellicleModelInfo info{};
        pellicle_model_info(model, &info, sizeof info);
        add(info.name, pellicle::BsdfBuilder(info.name));
    }
    for (const char *distribution : {"ggx", "beckmann", "blinn_phong", "abc", "sgd"})
        for (const char *compensation : {"off", "on"})
            for (const float alpha : {1e-4f, 0.01f, 0.3f, 1.0f})
                add(std::string(distribution) + ", compensation " + compensation + ", alpha " + std::to_string(alpha),
                    pellicle::BsdfBuilder("microfacet")
                        .choose("distribution", distribution)
                        .choose("energy_compensation", compensation)
                        .set("alpha", alpha));
    print("worst BSDF: " + worst_name, worst);
}

pellicle::FilmBuilder stack(int fixed_layers) {
    pellicle::FilmBuilder builder("BK7");
    for (int i = 0; i < fixed_layers; ++i) builder.layer(i % 2 ? "SiO2" : "TiO2", 100);
    return builder;
}

void print_films() {
    using pellicle::FilmBuilder;
    print("bare glass", seconds(FilmBuilder("BK7")));
    print("soap, 0-1000 nm", seconds(FilmBuilder("vacuum").layer("water", 0, 1000)));
    print("MgF2 on BK7, 0-500 nm, transmittance", seconds(FilmBuilder("BK7").layer("MgF2", 0, 500).transmittance()));
    print("TiO2 on Ti, 0-3000 nm, tolerance 1e-4", seconds(FilmBuilder("Ti").layer("TiO2", 0, 3000).tolerance(1e-4f)));
    print("SiO2 on Si, 0-1e5 nm, tolerance 1e-5", seconds(FilmBuilder("Si").layer("SiO2", 0, 1e5f).tolerance(1e-5f)));
    print("SiO2 on Si, 0-1e8 nm", seconds(FilmBuilder("Si").layer("SiO2", 0, 1e8f)));
    print("64 fixed layers", seconds(stack(64)));
    print("64 layers, one of 0-1000 nm, transmittance", seconds(stack(63).layer("SiO2", 0, 1000).transmittance()));
}

} // namespace

int main() {
    std::printf("| creation | s |\n|---|---:|\n");
    print_bsdfs();
    print_films();
    return 0;
}
