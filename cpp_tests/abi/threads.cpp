// Handles are immutable and counted, and every thread has its own last error.
#include "support.hpp"

#include <atomic>
#include <cstring>
#include <thread>

namespace {

using support::Vec3;

constexpr int thread_count = 8;

template <class Work> void on_threads(Work work) {
    std::vector<std::thread> threads;
    for (int i = 0; i < thread_count; ++i) threads.emplace_back([&work, i] { work(i); });
    for (std::thread &thread : threads) thread.join();
}

struct Results {
    pellicle::Evaluation evaluation;
    PellicleSample sample;
    Vec3 albedo; // of the first few calls only: it is a quadrature

    bool operator==(const Results &other) const {
        return support::same_bits(evaluation.value.data(), other.evaluation.value.data(), 3) &&
               support::same_bits(&evaluation.pdf, &other.evaluation.pdf, 1) &&
               support::same_bits(sample, other.sample) && support::same_bits(albedo.data(), other.albedo.data(), 3);
    }
};

// A fixed sequence of calls.
std::vector<Results> results(const pellicle::Bsdf &bsdf, const support::Varying &varying) {
    std::vector<Results> all;
    std::mt19937 random(4);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 wo = support::random_direction(random), wi = support::random_direction(random);
        const Vec3 u = support::random_uniforms(random);
        const std::vector<float> values = varying.random_values(random);
        all.push_back({bsdf.eval(wo, wi, values.data()), bsdf.sample(wo, u, values.data()),
                       i < 8 ? bsdf.albedo(wo, values.data()) : Vec3{}});
    }
    return all;
}

} // namespace

TEST_CASE("threads: a handle shared by many threads gives what it gives one") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying varying(model);
        const std::vector<Results> expected = results(varying.bsdf(), varying);
        std::atomic<int> equal{0};
        on_threads([&](int) { equal += results(varying.bsdf(), varying) == expected; });
        CHECK_EQ(equal, thread_count);
    }
}

TEST_CASE("threads: retain, release and create from many threads leave a shared handle usable") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying varying(model);
        const std::vector<Results> expected = results(varying.bsdf(), varying);
        on_threads([&](int) {
            for (int i = 0; i < 2000; ++i) {
                const pellicle::Bsdf shared = varying.bsdf();
                const pellicle::Bsdf other = support::builder(model).create();
            }
        });
        CHECK(results(varying.bsdf(), varying) == expected);
    }
}

TEST_CASE("references: as many releases as retains keep the handle, one more frees it") {
    PellicleBsdfDesc desc{};
    desc.model = "layered";
    const auto create_and_free = [&](int retains) {
        PellicleBsdf *bsdf = nullptr;
        REQUIRE_EQ(pellicle_bsdf_create(&desc, sizeof desc, &bsdf), PELLICLE_OK);
        for (int i = 0; i < retains; ++i) pellicle_bsdf_retain(bsdf);
        for (int i = 0; i <= retains; ++i) pellicle_bsdf_release(bsdf);
    };

    support::check_no_growth(1000, 1000, [&] { create_and_free(3); });

    PellicleBsdf *bsdf = nullptr;
    REQUIRE_EQ(pellicle_bsdf_create(&desc, sizeof desc, &bsdf), PELLICLE_OK);
    const std::size_t with_one = pages::bytes_in_use();
    for (int i = 0; i < 5; ++i) pellicle_bsdf_retain(bsdf);
    for (int i = 0; i < 5; ++i) pellicle_bsdf_release(bsdf);
    CHECK_EQ(pages::bytes_in_use(), with_one);
    PellicleBsdfInfo info{};
    CHECK_EQ(pellicle_bsdf_info(bsdf, &info, sizeof info), PELLICLE_OK);
    CHECK_EQ(std::string(info.model), "layered");
    pellicle_bsdf_release(bsdf);
}

TEST_CASE("create: descriptions are copied, the caller may overwrite them at once") {
    char model[] = "lambert", name[] = "reflectance";
    float reflectance = 0.25f;
    PellicleParam param = {name, &reflectance, 1, nullptr};
    PellicleRange range = {name, 0.0f, 0.5f};
    PellicleBsdfDesc desc{};
    desc.model = model;
    desc.params = &param;
    desc.param_count = 1;
    desc.varying = &range;
    desc.varying_count = 1;
    const pellicle::Bsdf bsdf(desc);
    const Vec3 up = {0.0f, 0.0f, 1.0f};
    const Vec3 before = bsdf.value(up, up);
    std::memset(model, 'x', sizeof model - 1);
    std::memset(name, 'x', sizeof name - 1);
    reflectance = 0.75f;
    param = {};
    range = {};
    CHECK(support::same_bits(bsdf.value(up, up).data(), before.data(), 3));
    CHECK_EQ(std::string(bsdf.info().model), "lambert");
}

TEST_CASE("threads: a film shared by many threads gives what it gives one") {
    const auto colors = [] {
        std::vector<pellicle::FilmColors> all;
        for (int i = 0; i < 200; ++i)
            for (const std::uint32_t side : {PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE})
                all.push_back(support::varying_film().eval(0.005f * float(i), 2.0f * float(i), side));
        return all;
    };
    static_assert(sizeof(pellicle::FilmColors) == 6 * sizeof(float), "no padding to compare");
    const auto same = [](const auto &a, const auto &b) {
        return std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
    };
    const std::vector<pellicle::FilmColors> expected = colors();
    std::atomic<int> equal{0};
    on_threads([&](int) { equal += same(colors(), expected); });
    CHECK_EQ(equal, thread_count);
}

TEST_CASE("threads: retain and release of a film, and BSDFs that share it, from many threads") {
    const pellicle::Film film = pellicle::FilmBuilder("BK7").layer("MgF2", 100).create();
    const Vec3 expected = film.reflectance(0.5f);
    on_threads([&](int) {
        for (int i = 0; i < 2000; ++i) {
            const pellicle::Film shared = film;
            const pellicle::Bsdf bsdf = pellicle::BsdfBuilder("film").film(shared).create();
        }
    });
    CHECK(support::same_bits(film.reflectance(0.5f).data(), expected.data(), 3));
}

TEST_CASE("references: as many releases as retains keep a film, one more frees it") {
    support::FilmDescription description;
    description.base = support::medium("BK7");
    description.desc.method = "reference"; // the quickest to create
    const PellicleFilmDesc &desc = description.raw();
    const auto create_and_free = [&](int retains) {
        PellicleFilm *film = nullptr;
        REQUIRE_EQ(pellicle_film_create(&desc, sizeof desc, &film), PELLICLE_OK);
        for (int i = 0; i < retains; ++i) pellicle_film_retain(film);
        for (int i = 0; i <= retains; ++i) pellicle_film_release(film);
    };
    support::check_no_growth(200, 50, [&] { create_and_free(3); });
}

TEST_CASE("references: a BSDF keeps its film, and gives it up at its end") {
    support::FilmDescription description;
    description.base = support::medium("BK7");
    description.desc.method = "reference";
    const PellicleFilmDesc &film_desc = description.raw();
    const Vec3 up = {0.0f, 0.0f, 1.0f}, u = {0.5f, 0.5f, 0.5f};
    const Vec3 expected = pellicle::Film(film_desc).reflectance(1.0f);
    const auto create_and_free = [&] {
        PellicleFilm *film = nullptr;
        REQUIRE_EQ(pellicle_film_create(&film_desc, sizeof film_desc, &film), PELLICLE_OK);
        PellicleBsdfDesc desc{};
        desc.model = "film";
        desc.film = film;
        const pellicle::Bsdf bsdf(desc);
        desc.model = "lambert";
        PellicleBsdf *refused = nullptr;
        REQUIRE_EQ(pellicle_bsdf_create(&desc, sizeof desc, &refused), PELLICLE_INVALID_ARGUMENT);
        pellicle_film_release(film);
        CHECK(support::same_bits(bsdf.sample(up, u).weight, expected.data(), 3));
    };
    support::check_no_growth(200, 50, create_and_free);
}

TEST_CASE("create: a film's description is copied, the caller may overwrite it at once") {
    char base[] = "Si", white[] = "D65", space[] = "acescg";
    float nm[] = {400.0f, 700.0f}, eta[] = {1.6f, 1.5f}, k[] = {0.1f, 0.0f};
    PellicleMedium measured{}, below = support::medium(base);
    measured.table_nm = nm;
    measured.table_eta = eta;
    measured.table_k = k;
    measured.table_count = 2;
    PellicleLayer layer = {&measured, 150.0f, 150.0f};
    PellicleFilmDesc desc{};
    desc.medium_size = sizeof measured;
    desc.layer_size = sizeof layer;
    desc.layers = &layer;
    desc.layer_count = 1;
    desc.base = &below;
    desc.white = white;
    desc.color_space = space;
    const pellicle::Film film(desc);
    const Vec3 reflectance = film.reflectance(0.6f), reference = film.reference(0.6f);
    for (char *text : {base, white, space}) std::memset(text, 'x', std::strlen(text));
    for (float *numbers : {nm, eta, k}) numbers[0] = numbers[1] = -1.0f;
    measured = below = {};
    layer = {};
    desc = {};
    CHECK(support::same_bits(film.reflectance(0.6f).data(), reflectance.data(), 3));
    CHECK(support::same_bits(film.reference(0.6f).data(), reference.data(), 3));
}

TEST_CASE("last error: never NULL, empty in a thread without failures, and each thread's own") {
    REQUIRE_EQ(pellicle_bsdf_info(nullptr, nullptr, 0), PELLICLE_INVALID_ARGUMENT);
    const std::string mine = pellicle_last_error();
    CHECK_FALSE(mine.empty());
    std::atomic<int> empty{0}, own{0};
    on_threads([&](int i) {
        empty += pellicle_last_error() != nullptr && std::string(pellicle_last_error()).empty();
        const std::string model = "no such model " + std::to_string(i);
        PellicleBsdfDesc desc{};
        desc.model = model.c_str();
        PellicleBsdf *bsdf = nullptr;
        for (int repeat = 0; repeat < 100; ++repeat) {
            pellicle_bsdf_create(&desc, sizeof desc, &bsdf);
            std::this_thread::yield();
        }
        own += support::message_has(model);
    });
    CHECK_EQ(empty, thread_count);
    CHECK_EQ(own, thread_count);
    CHECK_EQ(mine, pellicle_last_error());
}

TEST_CASE("last error: a call that succeeds leaves it alone") {
    REQUIRE_EQ(pellicle_bsdf_info(nullptr, nullptr, 0), PELLICLE_INVALID_ARGUMENT);
    const std::string message = pellicle_last_error();
    const auto bsdf = pellicle::BsdfBuilder("lambert").create();
    bsdf.info();
    CHECK_EQ(message, pellicle_last_error());
}

TEST_CASE("last error: names of any length and any bytes fit into the message's fixed buffer") {
    REQUIRE_EQ(pellicle_bsdf_info(nullptr, nullptr, 0), PELLICLE_INVALID_ARGUMENT);
    const std::string brief = pellicle_last_error();
    for (const std::size_t length : {100, 1000, 1023, 1024, 1025, 5000, 1000000}) {
        CAPTURE(length);
        for (const char *bytes : {"a", "\xc3\xa4", "\xf0\x9f\x8c\x88", "%s%n"}) {
            std::string name;
            while (name.size() < length) name += bytes;
            PellicleBsdf *bsdf = nullptr;
            PellicleBsdfDesc desc{};
            desc.model = name.c_str();
            CHECK_EQ(pellicle_bsdf_create(&desc, sizeof desc, &bsdf), PELLICLE_UNKNOWN_NAME);
            const std::size_t written = std::strlen(pellicle_last_error());
            CHECK_GT(written, 0);
            CHECK_LT(written, 5000);

            const PellicleParam param = {name.c_str(), nullptr, 0, "x"};
            desc.model = "layered";
            desc.params = &param;
            desc.param_count = 1;
            CHECK_EQ(pellicle_bsdf_create(&desc, sizeof desc, &bsdf), PELLICLE_UNKNOWN_NAME);
            CHECK_GT(std::strlen(pellicle_last_error()), 0);

            // Nothing of the long message shines through.
            CHECK_EQ(pellicle_bsdf_info(nullptr, nullptr, 0), PELLICLE_INVALID_ARGUMENT);
            CHECK_EQ(brief, pellicle_last_error());
        }
    }
}
