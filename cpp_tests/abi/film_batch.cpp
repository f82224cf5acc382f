// The film's batch is the single call, many times: bit for bit, through every kind of view, and it
// writes nothing but the places its view names.
#include "strided.hpp"

namespace {

using support::Layout;
using support::layouts;
using support::quiet_nan;
using support::Strided;
using support::Vec3;
using support::word;

struct Inputs {
    std::vector<float> cos_theta, thickness_nm;

    explicit Inputs(std::size_t count) {
        std::mt19937 random(8);
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 u = support::random_uniforms(random);
            cos_theta.push_back(u[0]);
            thickness_nm.push_back(u[1] * support::varying_film_max_nm);
        }
    }
};

Strided strided(const Layout &layout, const std::vector<float> &numbers) {
    Strided result(layout, numbers.size(), 1);
    for (std::size_t i = 0; i < numbers.size(); ++i) result.set(i, 0, numbers[i]);
    return result;
}

PellicleConstView packed(const std::vector<float> &numbers) {
    return {numbers.data(), word, word};
}

// The single call of every element.
std::vector<Vec3> singles(const pellicle::Film &film, const Inputs &inputs) {
    std::vector<Vec3> results;
    for (std::size_t i = 0; i < inputs.cos_theta.size(); ++i)
        results.push_back(film.reflectance(inputs.cos_theta[i], inputs.thickness_nm[i]));
    return results;
}

} // namespace

TEST_CASE("film batch: it equals the single call bit for bit in every layout") {
    for (const std::size_t count : {0, 1, 7, 63, 64, 65, 277}) {
        CAPTURE(count);
        const Inputs inputs(count);
        const std::vector<Vec3> expected = singles(support::varying_film(), inputs);
        for (const Layout &in : layouts)
            for (const Layout &out : layouts) {
                CAPTURE(std::string(in.name));
                CAPTURE(std::string(out.name));
                const Strided cos_theta = strided(in, inputs.cos_theta), thickness = strided(in, inputs.thickness_nm);
                Strided reflectance(out, count, 3);
                PellicleFilmBatchArgs args{};
                args.count = count;
                args.cos_theta = cos_theta.const_view();
                args.thickness_nm = thickness.const_view();
                args.reflectance = reflectance.view();
                support::varying_film().reflectance_batch(args);

                bool equal = true;
                for (std::size_t i = 0; i < count; ++i) {
                    const Vec3 rgb = {reflectance.get(i, 0), reflectance.get(i, 1), reflectance.get(i, 2)};
                    equal = equal && support::same_bits(rgb.data(), expected[i].data(), 3);
                }
                CHECK(equal);
                CHECK(reflectance.rest_untouched());
            }
    }
}

TEST_CASE("film batch: element stride 0 broadcasts one cosine or one thickness to all") {
    Inputs inputs(17);
    std::vector<Vec3> reflectance(17);
    PellicleFilmBatchArgs args{};
    args.count = 17;
    args.cos_theta = packed(inputs.cos_theta);
    args.thickness_nm = {&inputs.thickness_nm[0], 0, 0};
    args.reflectance = {reflectance[0].data(), 12, 4};
    support::varying_film().reflectance_batch(args);
    for (std::size_t i = 0; i < 17; ++i) {
        const Vec3 single = support::varying_film().reflectance(inputs.cos_theta[i], inputs.thickness_nm[0]);
        CHECK(support::same_bits(reflectance[i].data(), single.data(), 3));
    }
    args.cos_theta = {&inputs.cos_theta[0], 0, 0};
    args.thickness_nm = packed(inputs.thickness_nm);
    support::varying_film().reflectance_batch(args);
    for (std::size_t i = 0; i < 17; ++i) {
        const Vec3 single = support::varying_film().reflectance(inputs.cos_theta[0], inputs.thickness_nm[i]);
        CHECK(support::same_bits(reflectance[i].data(), single.data(), 3));
    }
}

TEST_CASE("film batch: thicknesses may be left out, or given in vain, where none varies") {
    const Inputs inputs(9);
    const std::vector<Vec3> expected = singles(support::fixed_film(), inputs);
    for (const bool given : {false, true}) {
        CAPTURE(given);
        std::vector<Vec3> reflectance(9);
        PellicleFilmBatchArgs args{};
        args.count = 9;
        args.cos_theta = packed(inputs.cos_theta);
        if (given) args.thickness_nm = packed(inputs.thickness_nm);
        args.reflectance = {reflectance[0].data(), 12, 4};
        support::fixed_film().reflectance_batch(args);
        for (std::size_t i = 0; i < 9; ++i) CHECK(support::same_bits(reflectance[i].data(), expected[i].data(), 3));
    }
}

TEST_CASE("film batch: a bad element does not disturb its neighbours") {
    for (const std::size_t bad : {0, 5, 18})
        for (std::vector<float> Inputs::*field : {&Inputs::cos_theta, &Inputs::thickness_nm}) {
            Inputs inputs(19);
            const std::vector<Vec3> clean = singles(support::varying_film(), inputs);
            (inputs.*field)[bad] = quiet_nan;
            std::vector<Vec3> reflectance(19);
            PellicleFilmBatchArgs args{};
            args.count = 19;
            args.cos_theta = packed(inputs.cos_theta);
            args.thickness_nm = packed(inputs.thickness_nm);
            args.reflectance = {reflectance[0].data(), 12, 4};
            support::varying_film().reflectance_batch(args);
            for (std::size_t i = 0; i < 19; ++i) {
                const Vec3 expected = i == bad ? Vec3{0.0f, 0.0f, 0.0f} : clean[i];
                CHECK(support::same_bits(reflectance[i].data(), expected.data(), 3));
            }
        }
}

TEST_CASE("film batch: the colours may take the place of cosine and thickness") {
    const Inputs inputs(13);
    const std::vector<Vec3> expected = singles(support::varying_film(), inputs);
    std::vector<Vec3> elements;
    for (std::size_t i = 0; i < 13; ++i) elements.push_back({inputs.cos_theta[i], inputs.thickness_nm[i], 0.0f});
    PellicleFilmBatchArgs args{};
    args.count = 13;
    args.cos_theta = {&elements[0][0], 12, 4};
    args.thickness_nm = {&elements[0][1], 12, 4};
    args.reflectance = {elements[0].data(), 12, 4};
    support::varying_film().reflectance_batch(args);
    for (std::size_t i = 0; i < 13; ++i) CHECK(support::same_bits(elements[i].data(), expected[i].data(), 3));
}

TEST_CASE("film batch: a count and strides that leave the address space are refused") {
    const float number = 1.0f;
    for (const std::size_t count : {SIZE_MAX, SIZE_MAX / 12, SIZE_MAX / 16}) {
        CAPTURE(count);
        support::Untouched<float[3]> reflectance;
        PellicleFilmBatchArgs args{};
        args.count = count;
        args.cos_theta = args.thickness_nm = {&number, 0, 4};
        args.reflectance = {reflectance.output, 12, 4};
        const PellicleFilm *film = support::varying_film().raw();
        CHECK_REFUSED(pellicle_film_reflectance_batch(film, &args, sizeof args), PELLICLE_INVALID_ARGUMENT,
                      "reflectance");
        args.reflectance.element_stride = 0;
        args.cos_theta.element_stride = 12;
        CHECK_REFUSED(pellicle_film_reflectance_batch(film, &args, sizeof args), PELLICLE_INVALID_ARGUMENT, "cos_theta");
        args.cos_theta.element_stride = 0;
        args.thickness_nm.element_stride = 12;
        CHECK_REFUSED(pellicle_film_reflectance_batch(film, &args, sizeof args), PELLICLE_INVALID_ARGUMENT,
                      "thickness_nm");
    }
}
