// Look-ups of films alone.

#include "../plain_film.hpp"
#include "bsdfs.hpp"
#include "channels.hpp"
#include "materials.hpp"
#include "row.hpp"
#include "spline.hpp"
#include "ways.hpp"

#include <cmath>
#include <cstdio>
#include <memory>

namespace {

// How far plain tables, linear between their entries, are off: soap most where cosine and thickness vanish.
struct Allowed {
    double max, rms;
};
constexpr Allowed of_coating = {0.05, 2e-3}, of_soap = {0.75, 5e-3}, of_curve = {0.05, 3e-3};

template <class Loop>
Work loop(const std::shared_ptr<Channels> &channels, const float *varying, const Elements &elements,
          Outputs &outputs, Loop loop) {
    return [=, &elements, &outputs](std::size_t first, std::size_t count) {
        loop(channels->planes(), ways::in(elements, varying, first), ways::out(outputs, first), count);
    };
}

void add_varying(std::vector<Row> &rows, const char *name, const pellicle::Film &film, Allowed allowed,
                 const Elements &elements, Outputs &outputs) {
    Row row;
    row.name = name;
    row.allowed = allowed.max;
    row.allowed_rms = allowed.rms;
    row.error_bound = ways::error_bound(film);
    const auto table = std::make_shared<plain::Bilinear>(
        material::greatest_nm, [&film](float cos_theta, float nm) { return film.reflectance(cos_theta, nm); });
    const auto channels = std::make_shared<Channels>(table->rgb);
    row.work[plain_way] = [table, &elements, &outputs](std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i)
            table->at(elements.angles[i].cos_theta, elements.angles[i].thickness_nm, outputs.values[i].data());
    };
    const float *varying = elements.film_nm.data();
    row.work[bits256_way] = loop(channels, varying, elements, outputs, vectorised::bits256::film);
    row.work[bits512_way] = loop(channels, varying, elements, outputs, vectorised::bits512::film);
    if (Spline::is_available()) {
        const auto spline = std::make_shared<Spline>();
        row.work[intrinsic_way] = [spline, &elements, &outputs](std::size_t first, std::size_t count) {
            const vectorised::Out out = ways::out(outputs, first);
            spline->at_each(elements.wi.planes[2] + first, elements.film_nm.data() + first, out.r, out.g, out.b,
                            count);
        };
    }
    ways::add_reflectances(row, film, elements, outputs, true);
    rows.push_back(row);
}

void add_fixed(std::vector<Row> &rows, const Elements &elements, Outputs &outputs) {
    const pellicle::Film film = bsdfs::fixed_soap();
    Row row;
    row.name = "film: soap of 350 nm";
    row.allowed = of_curve.max;
    row.allowed_rms = of_curve.rms;
    row.error_bound = ways::error_bound(film);
    // As linear as the tables of varying films, with 64 cosines.
    std::vector<float> rgb;
    for (int i = 0; i < plain::Bilinear::width; ++i)
        for (const float channel : film.reflectance(i / (plain::Bilinear::width - 1.0f))) rgb.push_back(channel);
    const auto table = std::make_shared<std::vector<float>>(rgb);
    const auto channels = std::make_shared<Channels>(rgb);
    row.work[plain_way] = [table, &elements, &outputs](std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i) {
            const float x = std::clamp(elements.angles[i].cos_theta, 0.0f, 1.0f) * (plain::Bilinear::width - 1);
            const int index = std::min(int(x), plain::Bilinear::width - 2);
            const float *near = &(*table)[3 * index];
            for (int c = 0; c < 3; ++c) outputs.values[i][c] = near[c] + (x - index) * (near[c + 3] - near[c]);
        }
    };
    row.work[bits256_way] = loop(channels, nullptr, elements, outputs, vectorised::bits256::film_curve);
    row.work[bits512_way] = loop(channels, nullptr, elements, outputs, vectorised::bits512::film_curve);
    ways::add_reflectances(row, film, elements, outputs, false);
    rows.push_back(row);
}

} // namespace

void add_film_rows(std::vector<Row> &rows, const Elements &elements, Outputs &outputs) {
    add_varying(rows, "film: 1.33 on 1.5 + 3i", bsdfs::coating(), of_coating, elements, outputs);
    add_varying(rows, "film: soap", bsdfs::soap(), of_soap, elements, outputs);
    add_fixed(rows, elements, outputs);
}

bool spline_agrees(const Elements &elements, Outputs &outputs) {
    constexpr double allowed = 1e-5;
    const Spline spline;
    const float *cosine = elements.wi.planes[2], *thickness = elements.film_nm.data();
    // Not a multiple of sixteen.
    const std::size_t count = elements.film_nm.size() - 3;
    outputs.forget();
    Planes &found = outputs.planes;
    spline.at_each(cosine, thickness, found[0], found[1], found[2], count);
    double greatest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        float rgb[3];
        spline.at(cosine[i], thickness[i], rgb);
        for (std::size_t c = 0; c < 3; ++c) {
            const double apart = std::fabs(double(found[c][i]) - rgb[c]);
            if (!(apart <= greatest)) greatest = apart;
        }
    }
    if (greatest <= allowed) return true;
    std::fprintf(stderr, "the spline by intrinsics is off by %.1e; allowed is %.0e\n", greatest, allowed);
    return false;
}
