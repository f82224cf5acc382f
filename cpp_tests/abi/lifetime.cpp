// Handles that end while others use them, and very many of them.
#include "support.hpp"

#include <atomic>
#include <thread>

namespace {

using support::Vec3;

const float up[3] = {0.0f, 0.0f, 1.0f};
const float slanted[3] = {0.0f, 0.6f, 0.8f};

// NULL if it is refused.
PellicleBsdf *raw_bsdf(const char *model, const PellicleFilm *film = nullptr) {
    PellicleBsdfDesc desc{};
    desc.model = model;
    desc.film = film;
    PellicleBsdf *bsdf = nullptr;
    pellicle_bsdf_create(&desc, sizeof desc, &bsdf);
    return bsdf;
}

PellicleFilm *raw_film() {
    support::FilmDescription description;
    PellicleFilm *film = nullptr;
    REQUIRE_EQ(pellicle_film_create(&description.raw(), sizeof description.desc, &film), PELLICLE_OK);
    return film;
}

// One owner's calls until it gives up its reference.
void evaluate_and_release(PellicleBsdf *bsdf, const Vec3 &expected, std::atomic<int> &wrong) {
    for (int i = 0; i < 50; ++i) {
        Vec3 values[8];
        PellicleEvalBatchArgs args{};
        args.count = 8;
        args.wo = {up, 0, 4};
        args.wi = {slanted, 0, 4};
        args.value = {values[0].data(), 12, 4};
        wrong += pellicle_bsdf_eval_batch(bsdf, &args, sizeof args) != PELLICLE_OK;
        for (const Vec3 &value : values) wrong += !support::same_bits(value.data(), expected.data(), 3);
    }
    pellicle_bsdf_release(bsdf);
}

// So many cycles, each of which tells whether it did what it should.
template <class Cycle> void check_no_growth(int count, Cycle cycle) {
    constexpr int first = 1000;
    int right = 0;
    support::check_no_growth(first, count, [&] { right += cycle(); });
    CHECK_EQ(right, count + first);
}

bool make_and_release(const char *model, const PellicleFilm *film = nullptr) {
    PellicleBsdf *bsdf = raw_bsdf(model, film);
    pellicle_bsdf_release(bsdf);
    return bsdf != nullptr;
}

} // namespace

TEST_CASE("threads: a BSDF lives until its last owner is done, whoever made it") {
    Vec3 expected;
    PellicleBsdf *first = raw_bsdf("layered");
    REQUIRE_EQ(pellicle_bsdf_eval(first, up, slanted, nullptr, nullptr, expected.data(), nullptr, nullptr), PELLICLE_OK);
    pellicle_bsdf_release(first);
    std::atomic<int> wrong{0};
    for (int round = 0; round < 100; ++round) {
        PellicleBsdf *bsdf = raw_bsdf("layered");
        std::vector<std::thread> owners;
        for (int i = 0; i < 4; ++i) {
            pellicle_bsdf_retain(bsdf);
            owners.emplace_back([&, bsdf] { evaluate_and_release(bsdf, expected, wrong); });
        }
        // The maker is the first to go.
        pellicle_bsdf_release(bsdf);
        for (std::thread &owner : owners) owner.join();
    }
    CHECK_EQ(wrong, 0);
}

TEST_CASE("threads: a film lives until the last BSDF that shares it is done") {
    std::atomic<int> wrong{0};
    for (int round = 0; round < 50; ++round) {
        PellicleFilm *film = raw_film();
        Vec3 expected;
        REQUIRE_EQ(pellicle_film_reflectance(film, 1.0f, 0.0f, expected.data()), PELLICLE_OK);
        std::vector<std::thread> owners;
        for (int i = 0; i < 4; ++i) {
            PellicleBsdf *bsdf = raw_bsdf("film", film);
            owners.emplace_back([bsdf, expected, &wrong] {
                const float u[3] = {0.0f, 0.5f, 0.5f};
                for (int call = 0; call < 50; ++call) {
                    PellicleSample sample;
                    wrong += pellicle_bsdf_sample(bsdf, up, u, nullptr, nullptr, &sample, sizeof sample) != PELLICLE_OK;
                    wrong += !support::same_bits(sample.weight, expected.data(), 3);
                }
                pellicle_bsdf_release(bsdf);
            });
        }
        pellicle_film_release(film);
        for (std::thread &owner : owners) owner.join();
    }
    CHECK_EQ(wrong, 0);
}

TEST_CASE("references: a million handles made and given up leave no byte behind") {
    check_no_growth(1000000, [] { return make_and_release("lambert"); });
}

TEST_CASE("references: a million handles that share a film leave no byte behind") {
    const PellicleFilm *film = support::fixed_film().raw();
    check_no_growth(1000000, [&] { return make_and_release("film", film); });
}

TEST_CASE("references: a million refused descriptions leave no byte behind") {
    // A film that the model does not take.
    const PellicleFilm *film = support::fixed_film().raw();
    check_no_growth(1000000, [&] { return raw_bsdf("lambert", film) == nullptr; });
}
