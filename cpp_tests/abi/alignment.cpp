// Every array that a caller gives or gets may lie at any alignment. Here each lies one byte beyond an address
// that would suit it, and ends at a guard page.
#include "support.hpp"

namespace {

using support::Vec3;

// A copy of an array, misaligned.
template <class T> class Misaligned {
public:
    explicit Misaligned(const std::vector<T> &elements) : bytes_(size_of(elements)) {
        std::memcpy(data(), elements.data(), elements.size() * sizeof(T));
    }
    // Not to be dereferenced here.
    T *get() { return reinterpret_cast<T *>(data()); }
    std::vector<T> read(std::size_t count) {
        std::vector<T> elements(count);
        std::memcpy(elements.data(), data(), count * sizeof(T));
        return elements;
    }

private:
    // The block is aligned for any type; the elements begin with its second byte.
    static std::size_t size_of(const std::vector<T> &elements) { return (elements.size() * sizeof(T) + 16) / 16 * 16 + 1; }
    unsigned char *data() { return bytes_.template as<unsigned char>(); }
    support::GuardedBytes bytes_;
};

const Vec3 wo = {0.0f, 0.6f, 0.8f}, wi = {0.48f, -0.6f, 0.64f}, u = {0.3f, 0.6f, 0.9f};

std::vector<float> numbers(const Vec3 &vector) { return {vector.begin(), vector.end()}; }

} // namespace

TEST_CASE("alignment: single calls read and write numbers anywhere") {
    Misaligned<float> from(numbers(wo)), to(numbers(wi)), uniforms(numbers(u)), varying({0.25f, 0.5f, 0.75f}), value({0, 0, 0}),
        pdf({0}), reverse({0}), albedo({0, 0, 0});
    Misaligned<PellicleSample> sample({PellicleSample{}});
    Misaligned<PellicleCall> call({pellicle::call_options(PELLICLE_TRANSPORT_RADIANCE)});
    REQUIRE_NE(reinterpret_cast<std::uintptr_t>(varying.get()) % alignof(float), 0);
    const auto bsdf = pellicle::BsdfBuilder("lambert").vary("reflectance", 0.0f, 1.0f).create();
    const float aligned[3] = {0.25f, 0.5f, 0.75f};
    REQUIRE_EQ(pellicle_bsdf_eval(bsdf.raw(), from.get(), to.get(), varying.get(), call.get(), value.get(), pdf.get(),
                                  reverse.get()),
               PELLICLE_OK);
    const auto expected = bsdf.eval_both_ways(wo, wi, aligned);
    CHECK_EQ(value.read(3), numbers(expected.value));
    CHECK_EQ(pdf.read(1)[0], expected.pdf);
    CHECK_EQ(reverse.read(1)[0], expected.pdf_reverse);
    REQUIRE_EQ(pellicle_bsdf_sample(bsdf.raw(), from.get(), uniforms.get(), varying.get(), call.get(), sample.get(),
                                    sizeof(PellicleSample)),
               PELLICLE_OK);
    CHECK(support::same_bits(sample.read(1)[0], bsdf.sample(wo, u, aligned)));
    REQUIRE_EQ(pellicle_bsdf_albedo(bsdf.raw(), from.get(), varying.get(), call.get(), albedo.get()), PELLICLE_OK);
    CHECK_EQ(albedo.read(3), numbers(bsdf.albedo(wo, aligned)));

    const pellicle::Film &film = support::varying_film();
    REQUIRE_EQ(pellicle_film_reflectance(film.raw(), 0.7f, 99.0f, value.get()), PELLICLE_OK);
    CHECK_EQ(value.read(3), numbers(film.reflectance(0.7f, 99.0f)));
    REQUIRE_EQ(pellicle_film_eval(film.raw(), 0.7f, 99.0f, PELLICLE_SIDE_BASE, value.get(), albedo.get()), PELLICLE_OK);
    CHECK_EQ(albedo.read(3), numbers(film.eval(0.7f, 99.0f, PELLICLE_SIDE_BASE).transmittance));
    REQUIRE_EQ(pellicle_film_reference(film.raw(), 0.7f, 99.0f, value.get()), PELLICLE_OK);
    CHECK_EQ(value.read(3), numbers(film.reference(0.7f, 99.0f)));
    Misaligned<float> lambda_nm({450.0f, 550.0f, 650.0f});
    REQUIRE_EQ(pellicle_film_spectrum(film.raw(), 0.7f, 99.0f, lambda_nm.get(), 3, value.get()), PELLICLE_OK);
    const float nm[3] = {450.0f, 550.0f, 650.0f};
    std::vector<float> spectrum(3);
    film.spectrum(0.7f, 99.0f, nm, 3, spectrum.data());
    CHECK_EQ(value.read(3), spectrum);
    REQUIRE_EQ(pellicle_film_spectrum_eval(film.raw(), 0.7f, 99.0f, PELLICLE_SIDE_BASE, lambda_nm.get(), 3, value.get(),
                                           albedo.get()),
               PELLICLE_OK);
    std::vector<float> transmittance(3);
    film.spectrum_eval(0.7f, 99.0f, PELLICLE_SIDE_BASE, nm, 3, spectrum.data(), transmittance.data());
    CHECK_EQ(value.read(3), spectrum);
    CHECK_EQ(albedo.read(3), transmittance);
    Misaligned<PellicleAmplitudes> amplitudes(std::vector<PellicleAmplitudes>(3));
    REQUIRE_EQ(pellicle_film_amplitudes(film.raw(), 0.7f, 99.0f, PELLICLE_SIDE_BASE, lambda_nm.get(), 3, amplitudes.get()),
               PELLICLE_OK);
    std::vector<PellicleAmplitudes> aligned_amplitudes(3);
    film.amplitudes(0.7f, 99.0f, PELLICLE_SIDE_BASE, nm, 3, aligned_amplitudes.data());
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(support::same_bits(amplitudes.read(3)[i].r_s, aligned_amplitudes[i].r_s, 8));
}

TEST_CASE("alignment: descriptions and all that they point to lie anywhere") {
    Misaligned<float> reflectance({0.1f, 0.2f, 0.3f});
    Misaligned<PellicleParam> params({PellicleParam{"reflectance", reflectance.get(), 3, nullptr}});
    Misaligned<PellicleRange> ranges({PellicleRange{"reflectance", 0.0f, 0.5f}});
    PellicleBsdfDesc desc{};
    desc.model = "lambert";
    desc.params = params.get();
    desc.param_count = 1;
    desc.varying = ranges.get();
    desc.varying_count = 1;
    Misaligned<PellicleBsdfDesc> moved_desc({desc});
    Misaligned<PellicleBsdf *> handle({nullptr});
    REQUIRE_EQ(pellicle_bsdf_create(moved_desc.get(), sizeof desc, handle.get()), PELLICLE_OK);
    const pellicle::Bsdf bsdf(handle.read(1)[0]);
    CHECK_EQ(bsdf.varying(0).default_value[2], 0.3f);
    Misaligned<PellicleVaryingInfo> info({PellicleVaryingInfo{}});
    REQUIRE_EQ(pellicle_bsdf_varying(bsdf.raw(), 0, info.get(), sizeof(PellicleVaryingInfo)), PELLICLE_OK);
    CHECK_EQ(info.read(1)[0].max, 0.5f);

    Misaligned<float> nm({400.0f, 700.0f}), eta({1.6f, 1.5f}), k({0.0f, 0.0f});
    PellicleMedium measured{};
    measured.table_nm = nm.get();
    measured.table_eta = eta.get();
    measured.table_k = k.get();
    measured.table_count = 2;
    Misaligned<PellicleMedium> base({measured}), water({support::medium("water")});
    Misaligned<PellicleLayer> layers({{water.get(), 0.0f, 200.0f}, {base.get(), 20.0f, 20.0f}});
    PellicleFilmDesc film{};
    film.medium_size = sizeof(PellicleMedium);
    film.layer_size = sizeof(PellicleLayer);
    film.layers = layers.get();
    film.layer_count = 2;
    film.base = base.get();
    Misaligned<PellicleFilmDesc> moved_film({film});
    Misaligned<PellicleFilm *> film_handle({nullptr});
    REQUIRE_EQ(pellicle_film_create(moved_film.get(), sizeof film, film_handle.get()), PELLICLE_OK);
    CHECK_EQ(pellicle::Film(film_handle.read(1)[0]).info().thickness_max_nm, 200.0f);
}

TEST_CASE("alignment: batches take arguments and views of varying parameters anywhere") {
    const auto bsdf = pellicle::BsdfBuilder("lambert").vary("reflectance", 0.0f, 1.0f).create();
    const float reflectance[3] = {0.25f, 0.5f, 0.75f};
    Misaligned<PellicleConstView> varying({PellicleConstView{reflectance, 0, 4}});
    Misaligned<float> from(numbers(wo)), to(numbers(wi)), value(std::vector<float>(30));
    PellicleEvalBatchArgs args{};
    args.count = 10;
    args.wo = {from.get(), 0, 4};
    args.wi = {to.get(), 0, 4};
    args.varying = varying.get();
    args.varying_count = 1;
    args.value = {value.get(), 12, 4};
    Misaligned<PellicleEvalBatchArgs> moved({args});
    REQUIRE_EQ(pellicle_bsdf_eval_batch(bsdf.raw(), moved.get(), sizeof args), PELLICLE_OK);
    const Vec3 expected = bsdf.value(wo, wi, reflectance);
    const std::vector<float> found = value.read(30);
    for (std::size_t i = 0; i < 10; ++i) CHECK(support::same_bits(found.data() + 3 * i, expected.data(), 3));
}
