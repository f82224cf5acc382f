// Media in a film's description: what is refused, by the place it stands at, and that the ways of
// giving the same medium agree.
#include "support.hpp"

namespace {

using support::infinity;
using support::quiet_nan;

const float table_nm[3] = {400.0f, 550.0f, 700.0f};
const float table_eta[3] = {1.6f, 1.5f, 1.45f};
const float table_k[3] = {0.0f, 0.0f, 0.0f};

PellicleMedium table() {
    PellicleMedium medium{};
    medium.table_nm = table_nm;
    medium.table_eta = table_eta;
    medium.table_k = table_k;
    medium.table_count = 3;
    return medium;
}

// Everywhere that a medium stands, and how messages call it.
enum class Place { ambient, outer_layer, inner_layer, base };
constexpr Place places[] = {Place::ambient, Place::outer_layer, Place::inner_layer, Place::base};

const char *name_of(Place place) {
    switch (place) {
    case Place::ambient: return "ambient";
    case Place::outer_layer: return "layers[0].medium";
    case Place::inner_layer: return "layers[1].medium";
    case Place::base: break;
    }
    return "base";
}

// A film that is valid but for the medium at one place.
PellicleStatus create(Place place, const PellicleMedium &medium) {
    support::FilmDescription film;
    film.layers = {{support::medium(1.38f), 100.0f, 100.0f}, {support::medium(2.0f), 60.0f, 60.0f}};
    PellicleMedium *const targets[] = {&film.ambient, &film.layers[0].medium, &film.layers[1].medium, &film.base};
    *targets[static_cast<int>(place)] = medium;
    return film.create();
}

// Refused at every place, and the message says where, and what.
void check_refused(const PellicleMedium &medium, PellicleStatus status, const std::string &words) {
    for (const Place place : places) {
        CAPTURE(std::string(name_of(place)));
        CHECK_REFUSED(create(place, medium), status, words);
        CHECK_EQ(std::string(pellicle_last_error()).find(name_of(place)), 0);
    }
}

float reflectance_at(const PellicleMedium &base, float lambda_nm) {
    support::FilmDescription film;
    film.base = base;
    film.desc.extrapolate = 1;
    float result = -1.0f;
    pellicle::Film(film.raw()).spectrum(1.0f, 0.0f, &lambda_nm, 1, &result);
    return result;
}

} // namespace

TEST_CASE("media: a zeroed one is vacuum as the ambient, and refused elsewhere") {
    CHECK_EQ(create(Place::ambient, {}), PELLICLE_OK);
    for (const Place place : {Place::outer_layer, Place::inner_layer, Place::base}) {
        CHECK_REFUSED(create(place, {}), PELLICLE_INVALID_ARGUMENT, name_of(place));
        for (const char *way : {"name", "eta", "table"}) CHECK(support::message_has(way));
    }
}

TEST_CASE("media: a zero, negative, excessive, NaN or infinite index is refused by its number") {
    for (const float bad : {0.0f, -1.0f, 1e-4f, 1001.0f, quiet_nan, infinity, -infinity})
        for (int channel = 0; channel < 3; ++channel) {
            CAPTURE(bad);
            PellicleMedium medium = support::medium(1.5f);
            medium.eta[channel] = bad;
            check_refused(medium, PELLICLE_OUT_OF_RANGE, "eta[" + std::to_string(channel) + "]");
        }
}

TEST_CASE("media: a negative, excessive, NaN or infinite extinction is refused by its number") {
    for (const float bad : {-1e-3f, 1001.0f, quiet_nan, infinity, -infinity})
        for (int channel = 0; channel < 3; ++channel) {
            CAPTURE(bad);
            PellicleMedium medium = support::medium(1.5f);
            medium.k[channel] = bad;
            check_refused(medium, PELLICLE_OUT_OF_RANGE, "k[" + std::to_string(channel) + "]");
        }
    // Extinction alone is no medium.
    check_refused(support::medium(0.0f, 1.0f), PELLICLE_OUT_OF_RANGE, "eta[0] = 0");
}

TEST_CASE("media: an ambient that absorbs or whose index is below 1 is refused") {
    for (const PellicleMedium &medium : {support::medium(1.5f, 1e-3f), support::medium("Au")})
        CHECK_REFUSED(create(Place::ambient, medium), PELLICLE_OUT_OF_RANGE, "ambient");
    PellicleMedium thin = support::medium(1.0f);
    thin.eta[1] = 0.999f;
    CHECK_REFUSED(create(Place::ambient, thin), PELLICLE_OUT_OF_RANGE, "ambient");
    for (const PellicleMedium &medium : {support::medium(1.0f), support::medium("water"), table()})
        CHECK_EQ(create(Place::ambient, medium), PELLICLE_OK);
}

TEST_CASE("media: an unknown name is refused with the list of names, one that is not UTF-8 at once") {
    for (const char *unknown : {"", "unobtainium", "Au "}) {
        check_refused(support::medium(unknown), PELLICLE_UNKNOWN_NAME, "unknown medium");
        for (const char *known : {"vacuum", "Au", "gold", "SiO2", "water", "oil"}) CHECK(support::message_has(known));
    }
    check_refused(support::medium("\xff\xfe"), PELLICLE_INVALID_ARGUMENT, "name");
}

TEST_CASE("media: one given in two ways is refused, with both") {
    PellicleMedium medium = support::medium(1.5f);
    medium.name = "SiO2";
    check_refused(medium, PELLICLE_INVALID_ARGUMENT, "a name and eta or k");
    medium = support::medium(0.0f, 1.0f);
    medium.name = "SiO2";
    check_refused(medium, PELLICLE_INVALID_ARGUMENT, "a name and eta or k");
    medium = table();
    medium.name = "SiO2";
    check_refused(medium, PELLICLE_INVALID_ARGUMENT, "a name and a table");
    medium = table();
    medium.eta[2] = 1.5f;
    check_refused(medium, PELLICLE_INVALID_ARGUMENT, "eta or k and a table");
    medium = support::medium("SiO2");
    medium.table_k = table_k;
    check_refused(medium, PELLICLE_INVALID_ARGUMENT, "a name and a table");
}

TEST_CASE("media: a table whose wavelengths do not ascend is refused by number") {
    for (const float second : {400.0f, 399.0f}) {
        const float unsorted[3] = {400.0f, second, 700.0f};
        PellicleMedium medium = table();
        medium.table_nm = unsorted;
        check_refused(medium, PELLICLE_OUT_OF_RANGE, "table_nm[1]");
    }
}

TEST_CASE("media: a table with a number outside its range is refused by number") {
    const auto check = [](const float *PellicleMedium::*part, const float *valid, float bad, const char *words) {
        CAPTURE(bad);
        float spoilt[3] = {valid[0], valid[1], bad};
        PellicleMedium medium = table();
        medium.*part = spoilt;
        check_refused(medium, PELLICLE_OUT_OF_RANGE, words);
    };
    for (const float bad : {-1.0f, quiet_nan, infinity}) {
        check(&PellicleMedium::table_nm, table_nm, bad, "table_nm[2]");
        check(&PellicleMedium::table_eta, table_eta, bad, "table_eta[2]");
        check(&PellicleMedium::table_k, table_k, bad, "table_k[2]");
    }
    check(&PellicleMedium::table_eta, table_eta, 0.0f, "table_eta[2]");
}

TEST_CASE("media: a table without count, and a count that no memory holds, are refused") {
    PellicleMedium medium = table();
    medium.table_count = 0;
    check_refused(medium, PELLICLE_INVALID_ARGUMENT, "table");
    medium.table_count = SIZE_MAX;
    check_refused(medium, PELLICLE_INVALID_ARGUMENT, "count");
    medium.table_count = std::size_t{1} << 60;
    check_refused(medium, PELLICLE_OUT_OF_MEMORY, "table_nm");
}

TEST_CASE("media: a table holds at its wavelengths, is linear between them and constant outside") {
    const auto bare = [](float eta) { return (eta - 1.0f) * (eta - 1.0f) / ((eta + 1.0f) * (eta + 1.0f)); };
    const struct {
        float lambda_nm, eta;
    } expected[] = {{300.0f, 1.6f}, {400.0f, 1.6f}, {475.0f, 1.55f}, {550.0f, 1.5f}, {700.0f, 1.45f}, {2000.0f, 1.45f}};
    for (const auto &[lambda_nm, eta] : expected) {
        CAPTURE(lambda_nm);
        CHECK_EQ(reflectance_at(table(), lambda_nm), doctest::Approx(bare(eta)).epsilon(1e-5));
    }
}

TEST_CASE("media: three indices belong to 645, 525 and 445 nm, extinction included") {
    PellicleMedium medium{};
    const float eta[3] = {0.2f, 0.6f, 1.4f}, k[3] = {3.6f, 2.1f, 1.9f}, lambda_nm[3] = {645.0f, 525.0f, 445.0f};
    for (int channel = 0; channel < 3; ++channel) {
        medium.eta[channel] = eta[channel];
        medium.k[channel] = k[channel];
    }
    for (int channel = 0; channel < 3; ++channel) {
        const double n = eta[channel], kk = k[channel] * k[channel];
        const double expected = ((n - 1) * (n - 1) + kk) / ((n + 1) * (n + 1) + kk);
        CHECK_EQ(reflectance_at(medium, lambda_nm[channel]), doctest::Approx(expected).epsilon(1e-5));
    }
}

TEST_CASE("media: a name and its alias, in upper or lower case, are the same medium") {
    const float expected = reflectance_at(support::medium("SiO2"), 500.0f);
    CHECK_GT(expected, 0.03f);
    for (const char *name : {"silica", "sio2", "SILICA"}) CHECK_EQ(reflectance_at(support::medium(name), 500.0f), expected);
}
