// Nanoseconds per call beside a renderer's own plain C++, and the difference of the results: time
// and error stand together. Prints Markdown. Fails only if the results disagree, never on time.
//
// All contenders see 300,000 random inputs, so that no branch or table of the standard library
// learns them. The films have a table of their own.

#include "contender.hpp"
#include "film.hpp"
#include "plain.hpp"
#include "virtual_calls.hpp"

#include <pellicle.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace {

using Vec3 = std::array<float, 3>;

// One albedo is a quadrature of about a millisecond.
constexpr std::size_t albedo_count = 50;
constexpr double allowed_difference = 1e-3;

constexpr float eta[3] = {1.4f, 1.45f, 1.6f};
constexpr float exponent_reflection = 90.0f, exponent_transmission = 170.0f;
constexpr float thickness_nm = 70.0f;
const float deviation = 10.0f * 3.14159265f / 180.0f;

struct Inputs {
    std::vector<Vec3> wo, wi, u;
};

Inputs random_inputs() {
    Inputs inputs;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0.0f, 0.999f);
    const auto direction = [&] {
        const float z = 1.0f - uniform(random), phi = 6.2831853f * uniform(random);
        const float radius = std::sqrt(1.0f - z * z);
        return Vec3{radius * std::cos(phi), radius * std::sin(phi), z};
    };
    for (std::size_t i = 0; i < count; ++i) {
        inputs.wo.push_back(direction());
        inputs.wi.push_back(direction());
        inputs.u.push_back({uniform(random), uniform(random), uniform(random)});
    }
    return inputs;
}

template <class Real> plain::Layered<Real> plain_layered() {
    return {{eta[0], eta[1], eta[2]},
            1,
            exponent_reflection,
            exponent_transmission,
            thickness_nm,
            {std::sin(Real(deviation)), 0, std::cos(Real(deviation))}};
}

template <class Real> plain::Vec3<Real> to_plain(const Vec3 &v) {
    return {v[0], v[1], v[2]};
}

pellicle::Bsdf layered(const char *variant) {
    return pellicle::BsdfBuilder("layered")
        .set("eta", eta, 3)
        .set("exponent_reflection", exponent_reflection)
        .set("exponent_transmission", exponent_transmission)
        .set("thickness_nm", thickness_nm)
        .set("base_normal", {std::sin(deviation), 0.0f, std::cos(deviation)})
        .set("specular_weight", 1.0f)
        .set("diffuse_weight", 0.0f)
        .choose("variant", variant)
        .create();
}

Contender plain_contender(const Inputs &inputs) {
    return {"plain C++, paper's specular term, value", count, [&inputs] {
                const auto model = plain_layered<float>();
                float sum = 0.0f, value[3];
                for (std::size_t i = 0; i < count; ++i) {
                    plain::eval(model, to_plain<float>(inputs.wo[i]), to_plain<float>(inputs.wi[i]), value);
                    sum += value[0] + value[1] + value[2];
                }
                return sum;
            }, {}};
}

void add_contenders(std::vector<Contender> &contenders, const std::string &name, const pellicle::Bsdf &bsdf,
                    const Inputs &inputs) {
    const auto add = [&](const char *call, std::size_t calls, auto body) {
        contenders.push_back({name + ", " + call, calls, [bsdf, calls, body] {
                                  float sum = 0.0f;
                                  for (std::size_t i = 0; i < calls; ++i) sum += body(bsdf.raw(), i);
                                  return sum;
                              }, {}});
    };
    add("value", count, [&inputs](PellicleBsdf *raw, std::size_t i) {
        float value[3];
        pellicle_bsdf_eval(raw, inputs.wo[i].data(), inputs.wi[i].data(), nullptr, nullptr, value, nullptr, nullptr);
        return value[0];
    });
    add("value and pdf", count, [&inputs](PellicleBsdf *raw, std::size_t i) {
        float value[3], pdf;
        pellicle_bsdf_eval(raw, inputs.wo[i].data(), inputs.wi[i].data(), nullptr, nullptr, value, &pdf, nullptr);
        return value[0] + pdf;
    });
    add("pdf", count, [&inputs](PellicleBsdf *raw, std::size_t i) {
        float pdf;
        pellicle_bsdf_eval(raw, inputs.wo[i].data(), inputs.wi[i].data(), nullptr, nullptr, nullptr, &pdf, nullptr);
        return pdf;
    });
    add("sample", count, [&inputs](PellicleBsdf *raw, std::size_t i) {
        PellicleSample sample;
        pellicle_bsdf_sample(raw, inputs.wo[i].data(), inputs.u[i].data(), nullptr, nullptr, &sample, sizeof sample);
        return sample.pdf;
    });
    add("albedo", albedo_count, [&inputs](PellicleBsdf *raw, std::size_t i) {
        float albedo[3];
        pellicle_bsdf_albedo(raw, inputs.wo[i].data(), nullptr, nullptr, albedo);
        return albedo[0];
    });
    const auto batch = [&](const char *call, bool with_pdf) {
        contenders.push_back({name + ", " + call, count, [&inputs, bsdf, with_pdf] {
                                  static std::vector<Vec3> value(count);
                                  static std::vector<float> pdf(count);
                                  PellicleEvalBatchArgs args{};
                                  args.count = count;
                                  args.wo = {inputs.wo[0].data(), sizeof(Vec3), sizeof(float)};
                                  args.wi = {inputs.wi[0].data(), sizeof(Vec3), sizeof(float)};
                                  args.value = {value[0].data(), sizeof(Vec3), sizeof(float)};
                                  if (with_pdf) args.pdf = {pdf.data(), sizeof(float), sizeof(float)};
                                  bsdf.eval_batch(args);
                                  return value[0][0];
                              }, {}});
    };
    batch("eval_batch, value", false);
    batch("eval_batch, value and pdf", true);
}

void print_times(const std::vector<Contender> &contenders) {
    std::printf("| what | ns per call | against plain C++ |\n|---|---:|---:|\n");
    for (const Contender &contender : contenders)
        std::printf("| %s | %.1f | %.2f |\n", contender.name.c_str(), contender.median(),
                    contender.median() / contenders.front().median());
}

// Differences over the greatest value that occurs.
struct Difference {
    double sum = 0.0, greatest = 0.0;
    void add(double difference) {
        sum += difference;
        greatest = std::max(greatest, difference);
    }
};

// Compares with the plain formula in double precision and with itself; returns whether all agree.
bool print_differences(const Inputs &inputs) {
    const auto in_float = plain_layered<float>();
    const auto in_double = plain_layered<double>();
    const pellicle::Bsdf bsdf = layered("paper");
    Difference plain_pellicle, plain_double, pellicle_double;
    double greatest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        float a[3];
        double exact[3];
        plain::eval(in_float, to_plain<float>(inputs.wo[i]), to_plain<float>(inputs.wi[i]), a);
        plain::eval(in_double, to_plain<double>(inputs.wo[i]), to_plain<double>(inputs.wi[i]), exact);
        const Vec3 b = bsdf.value(inputs.wo[i], inputs.wi[i]);
        for (int c = 0; c < 3; ++c) {
            greatest = std::max(greatest, exact[c]);
            plain_pellicle.add(std::fabs(double(a[c]) - b[c]));
            plain_double.add(std::fabs(a[c] - exact[c]));
            pellicle_double.add(std::fabs(b[c] - exact[c]));
        }
    }
    std::printf("\n| difference / greatest value | mean | max |\n|---|---:|---:|\n");
    const auto print = [&](const char *name, const Difference &difference) {
        std::printf("| %s | %.1e | %.1e |\n", name, difference.sum / (3.0 * count) / greatest,
                    difference.greatest / greatest);
    };
    print("plain C++ and pellicle", plain_pellicle);
    print("plain C++ and the same in double", plain_double);
    print("pellicle and plain C++ in double", pellicle_double);
    return greatest > 0.0 && plain_pellicle.greatest <= allowed_difference * greatest;
}

} // namespace

int main() {
    const Inputs inputs = random_inputs();
    std::vector<Contender> contenders = {plain_contender(inputs)};
    add_contenders(contenders, "layered paper", layered("paper"), inputs);
    add_contenders(contenders, "layered energy", layered("energy"), inputs);
    add_contenders(contenders, "lambert", pellicle::BsdfBuilder("lambert").create(), inputs);
    add_contenders(contenders, "phong", pellicle::BsdfBuilder("phong").create(), inputs);
    measure(contenders);

    std::printf("\npellicle %s; median of %d runs over %zu random directions, one thread\n\n",
                pellicle_version_string(), runs, count);
    print_times(contenders);
    if (!print_differences(inputs)) {
        std::fprintf(stderr, "plain C++ and pellicle differ by more than %g of the greatest value\n", allowed_difference);
        return 1;
    }
    if (!bench_virtual_calls()) {
        std::fprintf(stderr, "a virtual C++ function and pellicle disagree\n");
        return 1;
    }
    if (!bench_films()) {
        std::fprintf(stderr, "a film is further from full wave optics than its tolerance\n");
        return 1;
    }
    return 0;
}
