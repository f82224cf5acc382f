// Counts and strides that leave the address space: refused by name before any access, which pointers into
// inaccessible memory prove.
#include "support.hpp"

#include <cstdint>
#include <functional>

namespace {

// Memory that may be neither read nor written.
class Forbidden {
public:
    Forbidden() : size_(pages::page_size()), page_(pages::map(size_, false)) { REQUIRE(page_); }
    ~Forbidden() { pages::unmap(page_, size_); }
    Forbidden(const Forbidden &) = delete;
    Forbidden &operator=(const Forbidden &) = delete;

    float *data() const { return static_cast<float *>(page_); }

private:
    std::size_t size_;
    void *page_;
};

struct Reach {
    std::size_t count;
    std::ptrdiff_t element, component;
};

// Farther than an address can say, each by another of the three numbers.
const std::vector<Reach> element_reaches = {
    {SIZE_MAX, 4, 4},
    {SIZE_MAX / 12, 12, 4},
    {SIZE_MAX / 8 + 2, 4, 4},
    {SIZE_MAX, -4, 4},
    {2, PTRDIFF_MIN, 4},
    {3, PTRDIFF_MAX, 4},
    {5, PTRDIFF_MAX / 2, 4},
    {5, PTRDIFF_MIN / 2, -4},
};
const std::vector<Reach> component_reaches = {
    {1, 0, PTRDIFF_MAX},
    {1, 0, PTRDIFF_MIN},
    {5, 12, PTRDIFF_MAX / 2 + 1},
    {5, PTRDIFF_MAX / 4, -(PTRDIFF_MAX / 2)},
};

// Every view of a call once with each reach; the others are broadcast.
template <class Args> struct Place {
    const char *name;
    bool has_components;
    std::function<void(Args &, const Reach &)> set;
};

template <class View> void set_view(View &view, const Reach &reach) {
    view.element_stride = reach.element;
    view.component_stride = reach.component;
}

template <class Args, class Call>
void check_refused(const Args &valid, const std::vector<Place<Args>> &places, Call call) {
    for (const Place<Args> &place : places) {
        CAPTURE(std::string(place.name));
        std::vector<Reach> reaches = element_reaches;
        if (place.has_components) reaches.insert(reaches.end(), component_reaches.begin(), component_reaches.end());
        for (const Reach &reach : reaches) {
            CAPTURE(reach.count);
            CAPTURE(reach.element);
            CAPTURE(reach.component);
            Args args = valid;
            args.count = reach.count;
            place.set(args, reach);
            CHECK_REFUSED(call(args), PELLICLE_INVALID_ARGUMENT, place.name);
        }
    }
}

pellicle::Bsdf varying_lambert() {
    return pellicle::BsdfBuilder("lambert").set("reflectance", 0.5f).vary("reflectance", 0.0f, 1.0f).create();
}

} // namespace

TEST_CASE("overflow: eval batches refuse every view that leaves the address space") {
    const Forbidden memory;
    const pellicle::Bsdf bsdf = varying_lambert();
    PellicleConstView varying = {memory.data(), 0, 0};
    PellicleEvalBatchArgs args{};
    args.wo = args.wi = {memory.data(), 0, 0};
    args.varying = &varying;
    args.varying_count = 1;
    args.value = args.pdf = args.pdf_reverse = {memory.data(), 0, 0};
    using Args = PellicleEvalBatchArgs;
    check_refused<Args>(args,
                        {
                            {"wo", true, [](Args &a, const Reach &r) { set_view(a.wo, r); }},
                            {"wi", true, [](Args &a, const Reach &r) { set_view(a.wi, r); }},
                            {"varying", true, [&](Args &, const Reach &r) { set_view(varying, r); }},
                            {"value", true, [](Args &a, const Reach &r) { set_view(a.value, r); }},
                            {"pdf", false, [](Args &a, const Reach &r) { set_view(a.pdf, r); }},
                            {"pdf_reverse", false, [](Args &a, const Reach &r) { set_view(a.pdf_reverse, r); }},
                        },
                        [&](const Args &a) {
                            const PellicleStatus status = pellicle_bsdf_eval_batch(bsdf.raw(), &a, sizeof a);
                            varying = {memory.data(), 0, 0};
                            return status;
                        });
}

TEST_CASE("overflow: sample batches refuse every view that leaves the address space") {
    const Forbidden memory;
    const pellicle::Bsdf bsdf = varying_lambert();
    PellicleConstView varying = {memory.data(), 0, 0};
    PellicleSampleBatchArgs args{};
    args.wo = args.u = {memory.data(), 0, 0};
    args.varying = &varying;
    args.varying_count = 1;
    args.wi = args.pdf = args.weight = args.eta = args.lobe_probability = {memory.data(), 0, 0};
    args.flags = args.lobe = {reinterpret_cast<std::uint32_t *>(memory.data()), 0};
    using Args = PellicleSampleBatchArgs;
    check_refused<Args>(args,
                        {
                            {"wo", true, [](Args &a, const Reach &r) { set_view(a.wo, r); }},
                            {"u", true, [](Args &a, const Reach &r) { set_view(a.u, r); }},
                            {"varying", true, [&](Args &, const Reach &r) { set_view(varying, r); }},
                            {"wi", true, [](Args &a, const Reach &r) { set_view(a.wi, r); }},
                            {"pdf", false, [](Args &a, const Reach &r) { set_view(a.pdf, r); }},
                            {"weight", true, [](Args &a, const Reach &r) { set_view(a.weight, r); }},
                            {"eta", false, [](Args &a, const Reach &r) { set_view(a.eta, r); }},
                            {"flags", false, [](Args &a, const Reach &r) { a.flags.element_stride = r.element; }},
                            {"lobe", false, [](Args &a, const Reach &r) { a.lobe.element_stride = r.element; }},
                            {"lobe_probability", false,
                             [](Args &a, const Reach &r) { set_view(a.lobe_probability, r); }},
                        },
                        [&](const Args &a) {
                            const PellicleStatus status = pellicle_bsdf_sample_batch(bsdf.raw(), &a, sizeof a);
                            varying = {memory.data(), 0, 0};
                            return status;
                        });
}

TEST_CASE("overflow: film batches refuse every view that leaves the address space") {
    const Forbidden memory;
    PellicleFilmBatchArgs args{};
    args.cos_theta = args.thickness_nm = {memory.data(), 0, 0};
    args.reflectance = {memory.data(), 0, 0};
    using Args = PellicleFilmBatchArgs;
    check_refused<Args>(args,
                        {
                            {"cos_theta", false, [](Args &a, const Reach &r) { set_view(a.cos_theta, r); }},
                            {"thickness_nm", false, [](Args &a, const Reach &r) { set_view(a.thickness_nm, r); }},
                            {"reflectance", true, [](Args &a, const Reach &r) { set_view(a.reflectance, r); }},
                        },
                        [](const Args &a) {
                            return pellicle_film_reflectance_batch(support::varying_film().raw(), &a, sizeof a);
                        });
}

TEST_CASE("overflow: batches of amplitudes refuse every view that leaves the address space") {
    const Forbidden memory;
    PellicleAmplitudesBatchArgs args{};
    args.lambda_count = 3;
    args.lambda_nm = args.cos_theta = args.thickness_nm = {memory.data(), 0, 0};
    args.r_s = args.r_p = args.t_s = args.t_p = {memory.data(), 0, 0};
    using Args = PellicleAmplitudesBatchArgs;
    const auto call = [](const Args &a) {
        return pellicle_film_amplitudes_batch(support::varying_film().raw(), &a, sizeof a);
    };
    check_refused<Args>(args,
                        {
                            {"lambda_nm", true, [](Args &a, const Reach &r) { set_view(a.lambda_nm, r); }},
                            {"cos_theta", false, [](Args &a, const Reach &r) { set_view(a.cos_theta, r); }},
                            {"thickness_nm", false, [](Args &a, const Reach &r) { set_view(a.thickness_nm, r); }},
                            {"r_s", true, [](Args &a, const Reach &r) { set_view(a.r_s, r); }},
                            {"r_p", true, [](Args &a, const Reach &r) { set_view(a.r_p, r); }},
                            {"t_s", true, [](Args &a, const Reach &r) { set_view(a.t_s, r); }},
                            {"t_p", true, [](Args &a, const Reach &r) { set_view(a.t_p, r); }},
                        },
                        call);
    args.count = SIZE_MAX / 2;
    CHECK_REFUSED(call(args), PELLICLE_INVALID_ARGUMENT, "lambda_count");
}

TEST_CASE("overflow: counts of single calls and descriptions are refused as well") {
    const Forbidden memory;
    for (const std::size_t count : {SIZE_MAX, SIZE_MAX / 4 + 1, SIZE_MAX / 8 + 1}) {
        CAPTURE(count);
        CHECK_REFUSED(pellicle_film_spectrum(support::fixed_film().raw(), 1.0f, 0.0f, memory.data(), count, memory.data()),
                      PELLICLE_INVALID_ARGUMENT, "lambda_nm");
        auto *amplitudes = reinterpret_cast<PellicleAmplitudes *>(memory.data());
        CHECK_REFUSED(pellicle_film_amplitudes(support::fixed_film().raw(), 1.0f, 0.0f, PELLICLE_SIDE_AMBIENT,
                                               memory.data(), count, amplitudes),
                      PELLICLE_INVALID_ARGUMENT, "lambda_nm");

        PellicleBsdfDesc bsdf{};
        bsdf.model = "lambert";
        bsdf.params = reinterpret_cast<const PellicleParam *>(memory.data());
        bsdf.param_count = count;
        support::Untouched<PellicleBsdf *> handle;
        CHECK_REFUSED(pellicle_bsdf_create(&bsdf, sizeof bsdf, &handle.output), PELLICLE_INVALID_ARGUMENT, "params");
        bsdf.param_count = 0;
        bsdf.varying = reinterpret_cast<const PellicleRange *>(memory.data());
        bsdf.varying_count = count;
        CHECK_REFUSED(pellicle_bsdf_create(&bsdf, sizeof bsdf, &handle.output), PELLICLE_INVALID_ARGUMENT, "varying");

        support::FilmDescription film;
        PellicleFilmDesc desc = film.raw();
        desc.layers = reinterpret_cast<const PellicleLayer *>(memory.data());
        desc.layer_count = count;
        CHECK_EQ(support::create_film(desc), PELLICLE_OUT_OF_RANGE);
        film.base = PellicleMedium{};
        film.base.table_nm = film.base.table_eta = film.base.table_k = memory.data();
        film.base.table_count = count;
        CHECK_EQ(film.create(), PELLICLE_INVALID_ARGUMENT);
    }
}
