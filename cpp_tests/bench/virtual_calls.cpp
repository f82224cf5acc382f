// The price of a single call: beside a C++ virtual function that computes the same plain formula, which is what a
// renderer with material plug-ins pays already. Prints Markdown.

#include "virtual_calls.hpp"

#include "batch/plain_microfacet.hpp"
#include "contender.hpp"

#include <pellicle.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>

namespace {

using Vec3 = std::array<float, 3>;
constexpr float alpha = 0.3f;
constexpr plain::Schlick schlick = {{0.9f, 0.7f, 0.4f}};

// A renderer's own interface: checks directions, as pellicle does, and returns value and density.
class Material {
public:
    virtual ~Material() = default;
    virtual void eval(const Vec3 &wo, const Vec3 &wi, float value[3]) const = 0;
    virtual void eval_pdf(const Vec3 &wo, const Vec3 &wi, float value[3], float &pdf) const = 0;
};

plain::Direction direction(const Vec3 &w) { return {w[0], w[1], w[2]}; }

class Lambert final : public Material {
public:
    void eval(const Vec3 &wo, const Vec3 &wi, float value[3]) const override {
        plain::lambert(direction(wo), direction(wi), value);
    }
    void eval_pdf(const Vec3 &wo, const Vec3 &wi, float value[3], float &pdf) const override {
        eval(wo, wi, value);
        pdf = std::max(wi[2], 0.0f) / material::pi;
    }
};

class Rough final : public Material {
public:
    void eval(const Vec3 &wo, const Vec3 &wi, float value[3]) const override {
        plain::microfacet(ggx_, schlick, direction(wo), direction(wi), value);
    }
    void eval_pdf(const Vec3 &wo, const Vec3 &wi, float value[3], float &pdf) const override {
        eval(wo, wi, value);
        const plain::Direction h = plain::normalized({wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]});
        const float a2 = alpha * alpha;
        // Heitz 2018, "Sampling the GGX Distribution of Visible Normals", eq. 17, with G1 = 2 n.v / (n.v + root).
        pdf = ggx_.density(h) / (2 * (wo[2] + std::sqrt(a2 + (1 - a2) * wo[2] * wo[2])));
    }

private:
    plain::Ggx ggx_{alpha};
};

struct Row {
    const char *name;
    std::unique_ptr<Material> plain;
    pellicle::Bsdf bsdf;
};

struct Pairs {
    std::vector<Vec3> wo, wi;
};

Pairs random_pairs() {
    Pairs pairs;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0.0f, 0.999f);
    const auto draw = [&] {
        const float z = 1.0f - uniform(random), phi = 6.2831853f * uniform(random);
        const float radius = std::sqrt(1.0f - z * z);
        return Vec3{radius * std::cos(phi), radius * std::sin(phi), z};
    };
    for (std::size_t i = 0; i < count; ++i) {
        pairs.wo.push_back(draw());
        pairs.wi.push_back(draw());
    }
    return pairs;
}

} // namespace

bool bench_virtual_calls() {
    const Pairs pairs = random_pairs();
    std::vector<Row> rows;
    const float reflectance[3] = {material::reflectance[0], material::reflectance[1], material::reflectance[2]};
    rows.push_back({"lambert", std::make_unique<Lambert>(),
                    pellicle::BsdfBuilder("lambert").set("reflectance", reflectance, 3).create()});
    rows.push_back({"ggx, schlick", std::make_unique<Rough>(),
                    pellicle::BsdfBuilder("microfacet").set("alpha", alpha).set("f0", schlick.f0, 3).create()});
    std::vector<Contender> contenders;
    bool agree = true;
    for (const Row &row : rows) {
        const Material *material = row.plain.get();
        PellicleBsdf *raw = row.bsdf.raw();
        const auto add = [&](const char *what, auto body) {
            contenders.push_back({std::string(row.name) + ", " + what, count, [body] {
                                      float sum = 0.0f;
                                      for (std::size_t i = 0; i < count; ++i) sum += body(i);
                                      return sum;
                                  }, {}});
        };
        add("value, virtual C++", [&pairs, material](std::size_t i) {
            float value[3];
            material->eval(pairs.wo[i], pairs.wi[i], value);
            return value[0];
        });
        add("value, pellicle", [&pairs, raw](std::size_t i) {
            float value[3];
            pellicle_bsdf_eval(raw, pairs.wo[i].data(), pairs.wi[i].data(), nullptr, nullptr, value, nullptr, nullptr);
            return value[0];
        });
        add("value and pdf, virtual C++", [&pairs, material](std::size_t i) {
            float value[3], pdf;
            material->eval_pdf(pairs.wo[i], pairs.wi[i], value, pdf);
            return value[0] + pdf;
        });
        add("value and pdf, pellicle", [&pairs, raw](std::size_t i) {
            float value[3], pdf;
            pellicle_bsdf_eval(raw, pairs.wo[i].data(), pairs.wi[i].data(), nullptr, nullptr, value, &pdf, nullptr);
            return value[0] + pdf;
        });
        for (std::size_t i = 0; i < 1000; ++i) {
            float expected[3], pdf, found[3], found_pdf;
            material->eval_pdf(pairs.wo[i], pairs.wi[i], expected, pdf);
            pellicle_bsdf_eval(raw, pairs.wo[i].data(), pairs.wi[i].data(), nullptr, nullptr, found, &found_pdf,
                               nullptr);
            for (int c = 0; c < 3; ++c)
                agree = agree && std::fabs(expected[c] - found[c]) <= 1e-3f * std::max(1.0f, expected[c]);
            agree = agree && std::fabs(pdf - found_pdf) <= 1e-3f * std::max(1.0f, pdf);
        }
    }
    measure(contenders);
    std::printf("\n| single call | ns, virtual C++ | ns, pellicle | ratio |\n|---|---:|---:|---:|\n");
    for (std::size_t i = 0; i < contenders.size(); i += 2) {
        const std::string &name = contenders[i].name;
        std::printf("| %s | %.1f | %.1f | %.2f |\n", name.substr(0, name.rfind(',')).c_str(), contenders[i].median(),
                    contenders[i + 1].median(), contenders[i + 1].median() / contenders[i].median());
    }
    return agree;
}
