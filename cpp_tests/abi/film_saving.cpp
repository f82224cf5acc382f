// Compiled films as blocks of memory: what they give when loaded, and which blocks are refused. tests/films/saving.rs
// has the kinds of films and every byte of a block.
#include "support.hpp"

namespace {

using support::Untouched;

pellicle::Film loaded(const std::vector<unsigned char> &block) {
    pellicle::Film film;
    REQUIRE_EQ(pellicle::Film::load(block.data(), block.size(), film), PELLICLE_OK);
    return film;
}

// A block that is refused makes no film.
PellicleStatus load(const std::vector<unsigned char> &block) {
    Untouched<PellicleFilm *> film;
    return pellicle_film_load(block.data(), block.size(), &film.output);
}

} // namespace

TEST_CASE("saving: a loaded film gives the same bits in calls and batches, and as a BSDF") {
    const pellicle::Film &film = support::varying_film();
    const pellicle::Film again = loaded(film.save());
    constexpr std::size_t count = 300;
    std::mt19937 random(18);
    std::vector<float> cos_theta, thickness_nm, found[2] = {std::vector<float>(3 * count), std::vector<float>(3 * count)};
    for (std::size_t i = 0; i < count; ++i) {
        const support::Vec3 u = support::random_uniforms(random);
        cos_theta.push_back(u[0]);
        thickness_nm.push_back(u[1] * support::varying_film_max_nm);
        const float c = u[0], d = thickness_nm.back();
        CHECK_EQ(film.reflectance(c, d), again.reflectance(c, d));
        for (const std::uint32_t side : {PELLICLE_SIDE_AMBIENT, PELLICLE_SIDE_BASE}) {
            const pellicle::FilmColors a = film.eval(c, d, side), b = again.eval(c, d, side);
            CHECK_EQ(a.reflectance, b.reflectance);
            CHECK_EQ(a.transmittance, b.transmittance);
        }
    }
    const pellicle::Film *films[2] = {&film, &again};
    for (int i = 0; i < 2; ++i) {
        PellicleFilmBatchArgs args{};
        args.count = count;
        args.cos_theta = {cos_theta.data(), 4, 4};
        args.thickness_nm = {thickness_nm.data(), 4, 4};
        args.reflectance = {found[i].data(), 12, 4};
        films[i]->reflectance_batch(args);
    }
    CHECK(support::same_bits(found[0].data(), found[1].data(), 3 * count));

    CHECK_EQ(std::string(film.plan().method), again.plan().method);
    CHECK_EQ(std::string(film.plan().reason), again.plan().reason);
    CHECK_EQ(film.plan().measured_max, again.plan().measured_max);
    CHECK_EQ(film.info().thickness_max_nm, again.info().thickness_max_nm);
    pellicle::BsdfBuilder("film").film(again).vary("thickness_nm", 0.0f, support::varying_film_max_nm).create();
}

TEST_CASE("saving: the size is told first, and a block that is too small is refused") {
    const PellicleFilm *film = support::fixed_film().raw();
    std::size_t size = 0;
    REQUIRE_EQ(pellicle_film_save(film, nullptr, 0, &size), PELLICLE_OK);
    REQUIRE_GT(size, 48);
    // With any size stated, NULL asks.
    std::size_t again = 0;
    CHECK_EQ(pellicle_film_save(film, nullptr, 1, &again), PELLICLE_OK);
    CHECK_EQ(again, size);

    support::GuardedBytes small(size - 1);
    std::memset(small.as<void>(), 0x5A, size - 1);
    Untouched<std::size_t> untouched;
    for (const std::size_t less : {std::size_t{0}, std::size_t{47}, size - 1}) {
        CHECK_REFUSED(pellicle_film_save(film, small.as<void>(), less, &untouched.output), PELLICLE_OUT_OF_RANGE,
                      "block_size");
        CHECK_REFUSED(pellicle_film_save(film, small.as<void>(), less, &untouched.output), PELLICLE_OUT_OF_RANGE,
                      std::to_string(size));
    }
    for (std::size_t i = 0; i < size - 1; ++i) CHECK_EQ(small.as<unsigned char>()[i], 0x5A);

    // Neither the block nor the size need be aligned, and nothing is written or read beyond the block.
    support::GuardedBytes exact(size);
    unsigned char place[sizeof(std::size_t) + 1];
    auto *unaligned = reinterpret_cast<std::size_t *>(place + 1);
    CHECK_EQ(pellicle_film_save(film, exact.as<void>(), size, unaligned), PELLICLE_OK);
    std::memcpy(&again, place + 1, sizeof again);
    CHECK_EQ(again, size);
    pellicle::Film made;
    CHECK_EQ(pellicle::Film::load(exact.as<void>(), size, made), PELLICLE_OK);
    CHECK_EQ(std::memcmp(exact.as<void>(), support::fixed_film().save().data(), size), 0);
}

TEST_CASE("saving: a block that is no film of this build is refused with the reason") {
    const std::vector<unsigned char> block = support::fixed_film().save();
    const auto changed = [&](std::size_t at) {
        std::vector<unsigned char> copy = block;
        copy[at] ^= 1;
        return copy;
    };
    CHECK_REFUSED(load(changed(0)), PELLICLE_INVALID_ARGUMENT, "no saved film");
    CHECK_REFUSED(load(changed(8)), PELLICLE_UNSUPPORTED, "format");
    CHECK_REFUSED(load(changed(12)), PELLICLE_UNSUPPORTED, "another build");
    CHECK_REFUSED(load(changed(24)), PELLICLE_UNSUPPORTED, "another build");
    CHECK_REFUSED(load(changed(48)), PELLICLE_INVALID_ARGUMENT, "damaged");
    CHECK_REFUSED(load(changed(block.size() - 1)), PELLICLE_INVALID_ARGUMENT, "damaged");
    std::vector<unsigned char> longer = block;
    longer.push_back(0);
    CHECK_REFUSED(load(longer), PELLICLE_INVALID_ARGUMENT, "too long");
    for (const std::size_t length : {std::size_t{0}, std::size_t{7}, std::size_t{47}, block.size() - 1}) {
        support::GuardedBytes part(length);
        if (length > 0) std::memcpy(part.as<void>(), block.data(), length);
        Untouched<PellicleFilm *> film;
        CHECK_REFUSED(pellicle_film_load(part.as<void>(), length, &film.output), PELLICLE_INVALID_ARGUMENT, "truncated");
    }
    Untouched<PellicleFilm *> film;
    CHECK_REFUSED(pellicle_film_load(block.data(), static_cast<std::size_t>(-1), &film.output), PELLICLE_INVALID_ARGUMENT,
                  "size");
}

TEST_CASE("saving: films that are saved, loaded and refused leave nothing behind") {
    const pellicle::Film &film = support::varying_film();
    std::vector<unsigned char> spoilt = film.save();
    spoilt.back() ^= 1;
    support::check_no_growth(20, 200, [&] {
        pellicle::Film again;
        const std::vector<unsigned char> block = film.save();
        CHECK_EQ(pellicle::Film::load(block.data(), block.size(), again), PELLICLE_OK);
        CHECK_EQ(pellicle::Film::load(spoilt.data(), spoilt.size(), again), PELLICLE_INVALID_ARGUMENT);
    });
}
