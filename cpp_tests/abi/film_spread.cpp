// Spreads of thickness through C: their values, bad input, and the batch.
#include "support.hpp"

#include <limits>

namespace {

using support::Untouched;
using support::Vec3;

// Water between vacuum and vacuum; unclipped, because colours are averaged before they are clipped.
pellicle::Film bubble(float spread_max_nm) {
    return pellicle::FilmBuilder(pellicle::Medium("vacuum"))
        .layer("water", 0.0f, 600.0f)
        .transmittance()
        .unclipped()
        .thickness_spread_max(spread_max_nm)
        .create();
}

} // namespace

TEST_CASE("film spread: the average of calls without") {
    const pellicle::Film film = bubble(200.0f);
    CHECK_EQ(film.info().thickness_spread_max_nm, 200.0f);
    for (const float spread : {2.0f, 20.0f, 60.0f, 200.0f}) {
        CAPTURE(spread);
        const float c = 0.8f, d = 250.0f;
        double sum[3] = {}, total = 0.0;
        for (int i = 0; i <= 6000; ++i) {
            const double t = 0.1 * i, x = (t - d) / spread, weight = std::exp(-0.5 * x * x);
            const Vec3 color = film.reflectance(c, static_cast<float>(t));
            for (int channel = 0; channel < 3; ++channel) sum[channel] += weight * color[channel];
            total += weight;
        }
        const Vec3 found = film.reflectance_spread(c, d, spread);
        const pellicle::FilmColors both = film.eval_spread(c, d, spread);
        CHECK(both.reflectance == found);
        for (int channel = 0; channel < 3; ++channel) {
            CHECK(std::abs(found[channel] - sum[channel] / total) < 2e-3);
            CHECK(std::abs(found[channel] + both.transmittance[channel] - 1.0f) < 1e-6f);
        }
    }
    CHECK(film.reflectance_spread(0.8f, 250.0f, 0.0f) == film.reflectance(0.8f, 250.0f));
    CHECK(film.reflectance_spread(0.8f, 250.0f, 1e9f) == film.reflectance_spread(0.8f, 250.0f, 200.0f));
}

TEST_CASE("film spread: bad ones are refused, single and in a batch, and nothing is written") {
    const pellicle::Film film = bubble(200.0f), none = bubble(0.0f);
    const float infinite = std::numeric_limits<float>::infinity();
    Untouched<float[3]> rgb, other;
    for (const float bad : {-1.0f, infinite, std::numeric_limits<float>::quiet_NaN()}) {
        CHECK_REFUSED(pellicle_film_reflectance_spread(film.raw(), 0.5f, 100.0f, bad, rgb.output),
                      PELLICLE_OUT_OF_RANGE, "thickness_spread_nm");
        CHECK_REFUSED(pellicle_film_eval_spread(film.raw(), 0.5f, 100.0f, bad, PELLICLE_SIDE_BASE, rgb.output, other.output),
                      PELLICLE_OUT_OF_RANGE, "thickness_spread_nm");
        const float cos_theta = 0.5f, thickness_nm = 100.0f, spreads[3] = {0.0f, 5.0f, bad};
        float colors[9] = {7.0f};
        PellicleFilmBatchArgs args{};
        args.count = 3;
        args.cos_theta.data = &cos_theta;
        args.thickness_nm.data = &thickness_nm;
        args.reflectance = {colors, 3 * sizeof(float), sizeof(float)};
        args.thickness_spread_nm = {spreads, sizeof(float), sizeof(float)};
        CHECK_REFUSED(pellicle_film_reflectance_batch(film.raw(), &args, sizeof args), PELLICLE_OUT_OF_RANGE,
                      "thickness_spread_nm");
        CHECK_EQ(colors[0], 7.0f);
        args.count = 2;
        REQUIRE_EQ(pellicle_film_reflectance_batch(film.raw(), &args, sizeof args), PELLICLE_OK);
        for (int i = 0; i < 2; ++i) {
            const Vec3 single = film.reflectance_spread(cos_theta, thickness_nm, spreads[i]);
            for (int channel = 0; channel < 3; ++channel) CHECK_EQ(colors[3 * i + channel], single[channel]);
        }
    }
    CHECK_REFUSED(pellicle_film_reflectance_spread(none.raw(), 0.5f, 100.0f, 1.0f, rgb.output),
                  PELLICLE_INVALID_ARGUMENT, "thickness_spread_max_nm");
    CHECK_REFUSED(pellicle_film_reflectance_spread(support::fixed_film().raw(), 0.5f, 100.0f, 1.0f, rgb.output),
                  PELLICLE_INVALID_ARGUMENT, "no layer");
}
