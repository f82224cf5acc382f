// A C++17 program against an installed pellicle: a Lambertian surface gives reflectance / pi * cos.
#include <pellicle.hpp>

#include <cmath>
#include <cstdio>

int main() {
    try {
        const auto bsdf = pellicle::BsdfBuilder("lambert").set("reflectance", 0.5f).create();
        const auto evaluation = bsdf.eval({{0.0f, 0.0f, 1.0f}}, {{0.0f, 0.6f, 0.8f}});
        const float expected = 0.5f * 0.8f / 3.14159265f;
        std::printf("pellicle %s: %g, expected %g\n", pellicle_version_string(), evaluation.value[1], expected);
        return std::fabs(evaluation.value[1] - expected) > 1e-6f;
    } catch (const pellicle::Error &error) {
        std::fprintf(stderr, "%d: %s\n", error.status(), error.what());
        return 1;
    }
}
