// The numbers of an independent evaluation of the paper's formulas, through the C interface. The
// Rust tests compare the terms in double precision; here the value in single precision is compared.
#include "support.hpp"

#include <array>
#include <cmath>

namespace {

constexpr double pi = 3.14159265358979323846;

struct Degrees {
    double theta, phi;
};

std::array<float, 3> direction(Degrees angles) {
    const double theta = angles.theta * pi / 180, phi = angles.phi * pi / 180;
    return {float(std::sin(theta) * std::cos(phi)), float(std::sin(theta) * std::sin(phi)), float(std::cos(theta))};
}

struct Case {
    Degrees wi, wo, n1;
    std::array<float, 3> eta;
    float thickness_nm, exponent_reflection, exponent_transmission;
    std::array<double, 3> rho;
};

const Case cases[] = {
    {{30, 0}, {30, 180}, {0, 0}, {1.4f, 1.45f, 1.6f}, 70, 90, 170, {0.452282757, 0.367988482, 0.258287357}},
    {{30, 0}, {25, 170}, {0, 0}, {1.4f, 1.45f, 1.6f}, 70, 9, 17, {0.424467583, 0.346664442, 0.248385238}},
    {{45, 20}, {50, 185}, {10, 0}, {1.5f, 1.6f, 1.8f}, 90, 130, 130, {0.001070794, 0.001364744, 0.002145959}},
    {{60, 10}, {20, 200}, {14, 90}, {1.5f, 1.6f, 1.8f}, 180, 3, 5, {0.209157423, 0.333592106, 0.134917799}},
    {{85, 0}, {85, 180}, {0, 0}, {1.5f, 1.5f, 1.5f}, 15, 90, 90, {0.935467595, 0.922962756, 0.908586506}},
};

pellicle::BsdfBuilder paper(const std::array<float, 3> &eta, float thickness_nm) {
    return pellicle::BsdfBuilder("layered")
        .choose("variant", "paper")
        .set("eta", eta.data(), 3)
        .set("thickness_nm", thickness_nm);
}

// 1e-4: what single precision loses, exponents of 170 included.
void check_close(const std::array<float, 3> &value, const std::array<double, 3> &expected) {
    for (int c = 0; c < 3; ++c) CHECK_LT(std::fabs(value[c] / expected[c] - 1), 1e-4);
}

} // namespace

TEST_CASE("paper: the specular part is rho times the light's cosine") {
    for (const Case &c : cases) {
        CAPTURE(c.thickness_nm);
        const auto normal = direction(c.n1), wi = direction(c.wi), wo = direction(c.wo);
        const pellicle::Bsdf bsdf = paper(c.eta, c.thickness_nm)
                                        .set("exponent_reflection", c.exponent_reflection)
                                        .set("exponent_transmission", c.exponent_transmission)
                                        .set("base_normal", normal.data(), 3)
                                        .set("specular_weight", 1.0f)
                                        .set("diffuse_weight", 0.0f)
                                        .create();
        const double cosine = std::cos(c.wi.theta * pi / 180);
        check_close(bsdf.value(wo, wi), {c.rho[0] * cosine, c.rho[1] * cosine, c.rho[2] * cosine});
    }
}

TEST_CASE("paper: the diffuse part is rho_d over pi times the light's cosine") {
    const auto check = [](const std::array<float, 3> &eta, float thickness_nm, const std::array<double, 3> &rho_d) {
        const pellicle::Bsdf bsdf =
            paper(eta, thickness_nm).set("specular_weight", 0.0f).set("diffuse_weight", 1.0f).create();
        const double factor = std::cos(0.5) / pi;
        const std::array<float, 3> wi = {float(std::sin(0.5)), 0, float(std::cos(0.5))};
        check_close(bsdf.value(std::array<float, 3>{0, 0, 1}, wi),
                    {rho_d[0] * factor, rho_d[1] * factor, rho_d[2] * factor});
    };
    check({1.5f, 1.5f, 1.5f}, 15.0f, {1.506945410, 1.480631200, 1.450620590});
    check({1.5f, 1.6f, 1.8f}, 92.5f, {0.493054590, 0.451685610, 0.992987000});
}
