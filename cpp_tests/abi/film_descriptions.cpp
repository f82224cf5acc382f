// What pellicle_film_create() refuses besides media: thicknesses, counts, names and switches.
#include "support.hpp"

#include <string>

namespace {

using support::infinity;
using support::quiet_nan;

// A valid film of two layers, for a test to spoil.
struct Description : support::FilmDescription {
    Description() { layers = {{support::medium(1.38f), 0.0f, 400.0f}, {support::medium(2.0f), 60.0f, 60.0f}}; }
};

} // namespace

TEST_CASE("film create: the film that the other tests spoil is valid") {
    CHECK_EQ(Description().create(), PELLICLE_OK);
}

TEST_CASE("film create: a thickness that is negative, too great, NaN or infinite is refused by its layer") {
    for (const float bad : {-1.0f, -1e-30f, 1.1e8f, quiet_nan, infinity, -infinity}) {
        CAPTURE(bad);
        Description least;
        least.layers[1].thickness_min_nm = bad;
        CHECK_REFUSED(least.create(), PELLICLE_OUT_OF_RANGE, "layers[1].thickness_min_nm");
        Description greatest;
        greatest.layers[0].thickness_max_nm = bad;
        CHECK_REFUSED(greatest.create(), PELLICLE_OUT_OF_RANGE, "layers[0].thickness_max_nm");
    }
}

TEST_CASE("film create: a reversed range of thickness is refused with its limits") {
    Description film;
    film.layers[1].thickness_min_nm = 61.0f;
    CHECK_REFUSED(film.create(), PELLICLE_OUT_OF_RANGE, "layers[1]");
    CHECK(support::message_has("61"));
    CHECK(support::message_has("60"));
}

TEST_CASE("film create: one layer may vary, two may not") {
    Description film;
    film.layers[1].thickness_max_nm = 61.0f;
    CHECK_REFUSED(film.create(), PELLICLE_INVALID_ARGUMENT, "2 layers vary");
}

TEST_CASE("film create: 64 layers are accepted, 65 or a count that was never set are refused") {
    Description film;
    film.layers.assign(64, {support::medium(1.38f), 1.0f, 1.0f});
    CHECK_EQ(film.create(), PELLICLE_OK);
    film.layers.push_back(film.layers.front());
    CHECK_REFUSED(film.create(), PELLICLE_OUT_OF_RANGE, "layer_count = 65");
    for (const std::size_t count : {SIZE_MAX, SIZE_MAX / 2, std::size_t{1} << 40}) {
        PellicleFilmDesc desc = film.raw();
        desc.layer_count = count;
        CHECK_REFUSED(support::create_film(desc), PELLICLE_OUT_OF_RANGE, "layer_count");
    }
}

TEST_CASE("film create: a tolerance that is negative, too small, above 1 or NaN is refused") {
    for (const float bad : {-2e-3f, -1e-30f, 1e-30f, 9.9e-6f, 1.1f, quiet_nan, infinity, -infinity}) {
        CAPTURE(bad);
        Description film;
        film.desc.tolerance = bad;
        CHECK_REFUSED(film.create(), PELLICLE_OUT_OF_RANGE, "tolerance");
    }
}

TEST_CASE("film create: the limits of the tolerance are accepted, and 0 is the default") {
    support::FilmDescription bare;
    for (const float tolerance : {0.0f, -0.0f, 1e-5f, 1.0f}) {
        CAPTURE(tolerance);
        bare.desc.tolerance = tolerance;
        CHECK_EQ(pellicle::Film(bare.raw()).plan().tolerance, tolerance == 0.0f ? 2e-3f : tolerance);
    }
}

TEST_CASE("film create: an unknown white, colour space or method is refused with the list of them") {
    const auto check = [](const char *PellicleFilmDesc::*field, const char *name,
                          const std::vector<const char *> &known) {
        CAPTURE(std::string(name));
        Description film;
        for (const char *unknown : {"", "no such name"}) {
            film.desc.*field = unknown;
            CHECK_REFUSED(film.create(), PELLICLE_UNKNOWN_NAME, name);
            for (const char *other : known) CHECK(support::message_has(other));
        }
        film.desc.*field = "\xff\xfe";
        CHECK_REFUSED(film.create(), PELLICLE_INVALID_ARGUMENT, name);
        for (const char *other : known) {
            film.desc.*field = other;
            CHECK_EQ(film.create(), PELLICLE_OK);
        }
    };
    check(&PellicleFilmDesc::white, "white", {"E", "D65"});
    check(&PellicleFilmDesc::color_space, "color_space", {"rec709", "rec2020", "acescg", "xyz"});
    check(&PellicleFilmDesc::method, "method", {"reference"});
}

TEST_CASE("film create: sizes that no version has are refused by name") {
    for (const std::size_t wrong : {std::size_t{0}, sizeof(PellicleMedium) - 1, SIZE_MAX, std::size_t{1} << 17}) {
        CAPTURE(wrong);
        Description film;
        PellicleFilmDesc desc = film.raw();
        desc.medium_size = wrong;
        CHECK_REFUSED(support::create_film(desc), PELLICLE_INVALID_ARGUMENT, "medium_size");
        desc = film.raw();
        desc.layer_size = wrong;
        CHECK_REFUSED(support::create_film(desc), PELLICLE_INVALID_ARGUMENT, "layer_size");
        // Without layers there is nothing that it could be the size of.
        desc.layer_count = 0;
        CHECK_EQ(support::create_film(desc), PELLICLE_OK);
    }
}

TEST_CASE("film create: a switch that is neither 0 nor 1 is refused") {
    for (const std::uint32_t bad : {2u, 0x80000000u, UINT32_MAX}) {
        Description unclipped;
        unclipped.desc.unclipped = bad;
        CHECK_REFUSED(unclipped.create(), PELLICLE_OUT_OF_RANGE, "unclipped");
        Description transmittance;
        transmittance.desc.transmittance = bad;
        CHECK_REFUSED(transmittance.create(), PELLICLE_OUT_OF_RANGE, "transmittance");
        Description extrapolate;
        extrapolate.desc.extrapolate = bad;
        CHECK_REFUSED(extrapolate.create(), PELLICLE_OUT_OF_RANGE, "extrapolate");
    }
}

TEST_CASE("film create: base_opaque has three values") {
    for (const std::uint32_t bad : {3u, 0x80000000u, UINT32_MAX}) {
        Description film;
        film.desc.base_opaque = bad;
        CHECK_REFUSED(film.create(), PELLICLE_OUT_OF_RANGE, "base_opaque = " + std::to_string(bad));
        for (const char *allowed : {"0 (by k)", "1 (opaque)", "2 (transparent)"}) CHECK(support::message_has(allowed));
    }
}

TEST_CASE("film eval: a side that is neither the ambient nor the base is refused") {
    for (const std::uint32_t side : {2u, UINT32_MAX}) {
        support::Untouched<float[3]> reflectance, transmittance;
        CHECK_REFUSED(pellicle_film_eval(support::fixed_film().raw(), 1.0f, 0.0f, side, reflectance.output,
                                         transmittance.output),
                      PELLICLE_OUT_OF_RANGE, "side");
    }
}

TEST_CASE("film eval: a film that keeps no transmittance says so") {
    const pellicle::Film film = pellicle::FilmBuilder("BK7").create();
    support::Untouched<float[3]> reflectance, transmittance;
    CHECK_REFUSED(pellicle_film_eval(film.raw(), 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT, reflectance.output,
                                     transmittance.output),
                  PELLICLE_UNSUPPORTED, "transmittance");
}

TEST_CASE("film spectrum: a wavelength that is not finite and above 0 is refused by its number") {
    for (const float bad : {0.0f, -0.0f, -550.0f, quiet_nan, infinity, -infinity}) {
        CAPTURE(bad);
        const float lambda_nm[4] = {400.0f, 500.0f, bad, 600.0f};
        support::Untouched<float[4]> reflectance;
        CHECK_REFUSED(pellicle_film_spectrum(support::fixed_film().raw(), 1.0f, 0.0f, lambda_nm, 4, reflectance.output),
                      PELLICLE_OUT_OF_RANGE, "lambda_nm[2]");
    }
}

TEST_CASE("film spectrum: results that would overwrite wavelengths not read yet are refused") {
    std::vector<float> numbers(8, 500.0f);
    for (const int shift : {1, 3})
        for (const bool is_before : {false, true}) {
            const float *lambda_nm = numbers.data() + (is_before ? shift : 0);
            float *reflectance = numbers.data() + (is_before ? 0 : shift);
            CHECK_REFUSED(pellicle_film_spectrum(support::fixed_film().raw(), 1.0f, 0.0f, lambda_nm, 4, reflectance),
                          PELLICLE_INVALID_ARGUMENT, "overlaps");
            CHECK_EQ(numbers, std::vector<float>(8, 500.0f));
        }
    CHECK_EQ(pellicle_film_spectrum(support::fixed_film().raw(), 1.0f, 0.0f, numbers.data(), 4, numbers.data() + 4),
             PELLICLE_OK);
}

TEST_CASE("film plan: it names a method, its reason and an error within the tolerance") {
    for (const float tolerance : {0.0f, 1e-2f}) {
        Description film;
        film.desc.tolerance = tolerance;
        const pellicle::Film created(film.raw());
        const PellicleFilmPlan plan = created.plan();
        CHECK_FALSE(std::string(plan.method).empty());
        CHECK_FALSE(std::string(plan.reason).empty());
        CHECK_GE(plan.measured_rms, 0.0f);
        CHECK_LE(plan.measured_rms, plan.measured_max);
        CHECK_LE(plan.measured_max, plan.tolerance);
    }
}

TEST_CASE("film plan: it tells of the base's side only if light comes from there, and whose index directions follow") {
    for (const std::uint32_t transmittance : {0u, 1u}) {
        Description film;
        film.desc.transmittance = transmittance;
        const PellicleFilmPlan plan = pellicle::Film(film.raw()).plan();
        CHECK_EQ(std::string(plan.ambient.method), plan.method);
        CHECK_GT(plan.ambient.cost_ns, 0.0f);
        CHECK_LE(plan.ambient.measured_rms, plan.ambient.measured_max);
        CHECK_EQ(plan.base.method != nullptr, transmittance == 1);
        CHECK_EQ(plan.base.cost_ns > 0.0f, transmittance == 1);
        CHECK_EQ(std::max(plan.ambient.measured_max, plan.base.measured_max), plan.measured_max);
        CHECK_EQ(plan.eta_lambda_nm, 550.0f);
        CHECK_EQ(plan.eta_ambient, 1.0f);
        CHECK_EQ(plan.eta_base, 1.5f);
    }
}
