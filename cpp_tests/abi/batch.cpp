// A batch is the single call, many times: bit for bit, through every kind of view, and it writes
// nothing but the places its views name.
#include "strided.hpp"

#include <cstring>

namespace {

using support::Layout;
using support::layouts;
using support::Strided;
using support::Vec3;
using support::word;

struct Inputs {
    std::vector<Vec3> wo, wi, u;
    std::vector<std::vector<float>> varying;

    Inputs(const support::Varying &subject, std::size_t count) {
        std::mt19937 random(3);
        for (std::size_t i = 0; i < count; ++i) {
            wo.push_back(support::random_direction(random));
            wi.push_back(support::random_direction(random));
            u.push_back(support::random_uniforms(random));
            varying.push_back(subject.random_values(random));
        }
    }
};

Strided strided(const Layout &layout, const std::vector<Vec3> &vectors) {
    Strided result(layout, vectors.size(), 3);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) result.set(i, c, vectors[i][c]);
    return result;
}

// One array per varying parameter.
std::vector<Strided> strided_varying(const Layout &layout, const support::Varying &subject, const Inputs &inputs) {
    std::vector<Strided> result;
    std::size_t first = 0;
    for (const std::size_t components : subject.components()) {
        Strided &array = result.emplace_back(layout, inputs.varying.size(), components);
        for (std::size_t i = 0; i < inputs.varying.size(); ++i)
            for (std::size_t c = 0; c < components; ++c) array.set(i, c, inputs.varying[i][first + c]);
        first += components;
    }
    return result;
}

std::vector<PellicleConstView> views(const std::vector<Strided> &arrays) {
    std::vector<PellicleConstView> result;
    for (const Strided &array : arrays) result.push_back(array.const_view());
    return result;
}

std::uint32_t as_uint(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

void check_eval(const support::Varying &subject, std::size_t count, const Layout &in, const Layout &out) {
    const Inputs inputs(subject, count);
    const Strided wo = strided(in, inputs.wo), wi = strided(in, inputs.wi);
    const std::vector<Strided> varying = strided_varying(in, subject, inputs);
    const std::vector<PellicleConstView> varying_views = views(varying);
    Strided value(out, count, 3), pdf(out, count, 1), pdf_reverse(out, count, 1);

    PellicleEvalBatchArgs args{};
    args.count = count;
    args.wo = wo.const_view();
    args.wi = wi.const_view();
    args.varying = varying_views.data();
    args.varying_count = varying_views.size();
    args.value = value.view();
    args.pdf = pdf.view();
    args.pdf_reverse = pdf_reverse.view();
    subject.bsdf().eval_batch(args);

    bool equal = true;
    for (std::size_t i = 0; i < count; ++i) {
        const auto single = subject.bsdf().eval_both_ways(inputs.wo[i], inputs.wi[i], inputs.varying[i].data());
        const float batch[5] = {value.get(i, 0), value.get(i, 1), value.get(i, 2), pdf.get(i, 0), pdf_reverse.get(i, 0)};
        equal = equal && support::same_bits(batch, single.value.data(), 3) &&
                support::same_bits(batch + 3, &single.pdf, 1) && support::same_bits(batch + 4, &single.pdf_reverse, 1);
    }
    CHECK(equal);
    CHECK(value.rest_untouched());
    CHECK(pdf.rest_untouched());
    CHECK(pdf_reverse.rest_untouched());
}

void check_sample(const support::Varying &subject, std::size_t count, const Layout &in, const Layout &out) {
    const Inputs inputs(subject, count);
    const Strided wo = strided(in, inputs.wo), u = strided(in, inputs.u);
    const std::vector<Strided> varying = strided_varying(in, subject, inputs);
    const std::vector<PellicleConstView> varying_views = views(varying);
    Strided wi(out, count, 3), pdf(out, count, 1), weight(out, count, 3), eta(out, count, 1), flags(out, count, 1),
        lobe(out, count, 1), lobe_probability(out, count, 1);

    PellicleSampleBatchArgs args{};
    args.count = count;
    args.wo = wo.const_view();
    args.u = u.const_view();
    args.varying = varying_views.data();
    args.varying_count = varying_views.size();
    args.wi = wi.view();
    args.pdf = pdf.view();
    args.weight = weight.view();
    args.eta = eta.view();
    args.flags = flags.uint_view();
    args.lobe = lobe.uint_view();
    args.lobe_probability = lobe_probability.view();
    subject.bsdf().sample_batch(args);

    bool equal = true;
    for (std::size_t i = 0; i < count; ++i) {
        const PellicleSample single = subject.bsdf().sample(inputs.wo[i], inputs.u[i], inputs.varying[i].data());
        const PellicleSample batch = {{wi.get(i, 0), wi.get(i, 1), wi.get(i, 2)},
                                      pdf.get(i, 0),
                                      {weight.get(i, 0), weight.get(i, 1), weight.get(i, 2)},
                                      eta.get(i, 0),
                                      as_uint(flags.get(i, 0)),
                                      as_uint(lobe.get(i, 0)),
                                      lobe_probability.get(i, 0)};
        equal = equal && support::same_bits(batch, single);
    }
    CHECK(equal);
    for (const Strided *output : {&wi, &pdf, &weight, &eta, &flags, &lobe, &lobe_probability}) CHECK(output->rest_untouched());
}

template <class Check> void for_each_layout(Check check) {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        // The last is more than a chunk, and a rest that no lanes divide.
        for (const std::size_t count : {0, 1, 7, 63, 64, 65, 277})
            for (const Layout &in : layouts)
                for (const Layout &out : layouts) {
                    CAPTURE(count);
                    CAPTURE(std::string(in.name));
                    CAPTURE(std::string(out.name));
                    check(subject, count, in, out);
                }
    }
}

} // namespace

TEST_CASE("batch: eval equals the single call bit for bit in every layout") {
    for_each_layout(check_eval);
}

TEST_CASE("batch: sample equals the single call bit for bit in every layout") {
    for_each_layout(check_sample);
}

TEST_CASE("batch: element stride 0 broadcasts one element to all") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        constexpr std::size_t count = 65;
        const Inputs inputs(subject, count);
        const Strided wi = strided(layouts.front(), inputs.wi), u = strided(layouts.front(), inputs.u);
        std::vector<PellicleConstView> varying;
        std::size_t first = 0;
        for (const std::size_t components : subject.components()) {
            varying.push_back({inputs.varying[0].data() + first, 0, word});
            first += components;
        }

        std::vector<Vec3> value(count), weight(count);
        PellicleEvalBatchArgs eval{};
        eval.count = count;
        eval.wo = {inputs.wo[0].data(), 0, word};
        eval.wi = wi.const_view();
        eval.varying = varying.data();
        eval.varying_count = varying.size();
        eval.value = {value[0].data(), 12, 4};
        subject.bsdf().eval_batch(eval);
        PellicleSampleBatchArgs sample{};
        sample.count = count;
        sample.wo = eval.wo;
        sample.u = u.const_view();
        sample.varying = varying.data();
        sample.varying_count = varying.size();
        sample.weight = {weight[0].data(), 12, 4};
        subject.bsdf().sample_batch(sample);

        for (std::size_t i = 0; i < count; ++i) {
            const auto single = subject.bsdf().value(inputs.wo[0], inputs.wi[i], inputs.varying[0].data());
            const auto sampled = subject.bsdf().sample(inputs.wo[0], inputs.u[i], inputs.varying[0].data());
            CHECK(support::same_bits(value[i].data(), single.data(), 3));
            CHECK(support::same_bits(weight[i].data(), sampled.weight, 3));
        }
    }
}

TEST_CASE("batch: component stride 0 reads one number for all three") {
    const auto bsdf = pellicle::BsdfBuilder("lambert").set("reflectance", 0.5f).vary("reflectance", 0.0f, 1.0f).create();
    const Vec3 up = {0.0f, 0.0f, 1.0f};
    const float grey = 0.25f;
    const PellicleConstView varying = {&grey, 4, 0};
    Vec3 value{};
    PellicleEvalBatchArgs args{};
    args.count = 1;
    args.wo = args.wi = {up.data(), 12, 4};
    args.varying = &varying;
    args.varying_count = 1;
    args.value = {value.data(), 12, 4};
    bsdf.eval_batch(args);
    const Vec3 greys = {grey, grey, grey};
    CHECK(support::same_bits(value.data(), bsdf.value(up, up, greys.data()).data(), 3));
}

TEST_CASE("batch: without varying, and for a varying view without data, the created values hold") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        const Inputs inputs(subject, 7);
        const Strided wo = strided(layouts.front(), inputs.wo), wi = strided(layouts.front(), inputs.wi);
        const std::vector<PellicleConstView> without_data(subject.components().size(), PellicleConstView{});
        for (const bool list : {false, true}) {
            CAPTURE(list);
            std::vector<Vec3> value(7);
            PellicleEvalBatchArgs args{};
            args.count = 7;
            args.wo = wo.const_view();
            args.wi = wi.const_view();
            args.varying = list ? without_data.data() : nullptr;
            args.varying_count = list ? without_data.size() : 0;
            args.value = {value[0].data(), 12, 4};
            subject.bsdf().eval_batch(args);
            for (std::size_t i = 0; i < 7; ++i)
                CHECK(support::same_bits(value[i].data(), subject.bsdf().value(inputs.wo[i], inputs.wi[i]).data(), 3));
        }
    }
}

TEST_CASE("batch: each output alone is the same as all of them together") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        const Inputs inputs(subject, 65);
        const Strided wo = strided(layouts.front(), inputs.wo), wi = strided(layouts.front(), inputs.wi);
        std::vector<Vec3> value(65);
        std::vector<float> pdf(65), pdf_reverse(65), lobe_probability(65);
        PellicleEvalBatchArgs args{};
        args.count = 65;
        args.wo = wo.const_view();
        args.wi = wi.const_view();
        args.value = {value[0].data(), 12, 4};
        subject.bsdf().eval_batch(args);
        args.value = {};
        args.pdf = {pdf.data(), 4, 4};
        subject.bsdf().eval_batch(args);
        args.pdf = {};
        args.pdf_reverse = {pdf_reverse.data(), 4, 4};
        subject.bsdf().eval_batch(args);
        PellicleSampleBatchArgs sample{};
        sample.count = 65;
        sample.wo = args.wo;
        sample.u = {inputs.u[0].data(), 12, 4};
        sample.lobe_probability = {lobe_probability.data(), 4, 4};
        subject.bsdf().sample_batch(sample);
        for (std::size_t i = 0; i < 65; ++i) {
            const auto single = subject.bsdf().eval_both_ways(inputs.wo[i], inputs.wi[i]);
            const float probability = subject.bsdf().sample(inputs.wo[i], inputs.u[i]).lobe_probability;
            CHECK(support::same_bits(&pdf_reverse[i], &single.pdf_reverse, 1));
            CHECK(support::same_bits(&lobe_probability[i], &probability, 1));
            CHECK(support::same_bits(value[i].data(), single.value.data(), 3));
            CHECK(support::same_bits(&pdf[i], &single.pdf, 1));
        }
    }
}

TEST_CASE("batch: another number of varying views than declared is refused") {
    const auto bsdf = pellicle::BsdfBuilder("lambert").set("reflectance", 0.5f).vary("reflectance", 0.0f, 1.0f).create();
    const Vec3 up = {0.0f, 0.0f, 1.0f};
    const PellicleConstView varying[2] = {{up.data(), 12, 4}, {up.data(), 12, 4}};
    Vec3 value = {-1.0f, -1.0f, -1.0f};
    PellicleEvalBatchArgs args{};
    args.count = 1;
    args.wo = args.wi = {up.data(), 12, 4};
    args.varying = varying;
    args.value = {value.data(), 12, 4};
    for (const std::size_t wrong : {std::size_t{2}, SIZE_MAX}) {
        args.varying_count = wrong;
        CHECK_REFUSED(pellicle_bsdf_eval_batch(bsdf.raw(), &args, sizeof args), PELLICLE_INVALID_ARGUMENT, "varying");
        CHECK_EQ(value[0], -1.0f);
    }
}

TEST_CASE("batch: an output may be an input's own memory with the same strides") {
    for (const support::Model &model : support::models_with_and_without_film()) {
        CAPTURE(std::string(model.info.name));
        const support::Varying subject(model);
        Inputs inputs(subject, 65);
        const Inputs kept = inputs;
        PellicleEvalBatchArgs eval{};
        eval.count = 65;
        eval.wo = {inputs.wo[0].data(), 12, 4};
        eval.wi = {inputs.wi[0].data(), 12, 4};
        eval.value = {inputs.wi[0].data(), 12, 4};
        subject.bsdf().eval_batch(eval);
        PellicleSampleBatchArgs sample{};
        sample.count = 65;
        sample.wo = eval.wo;
        sample.u = {inputs.u[0].data(), 12, 4};
        sample.wi = {inputs.u[0].data(), 12, 4};
        sample.weight = {inputs.wo[0].data(), 12, 4};
        subject.bsdf().sample_batch(sample);
        for (std::size_t i = 0; i < 65; ++i) {
            const auto value = subject.bsdf().value(kept.wo[i], kept.wi[i]);
            const auto sampled = subject.bsdf().sample(kept.wo[i], kept.u[i]);
            CHECK(support::same_bits(inputs.wi[i].data(), value.data(), 3));
            CHECK(support::same_bits(inputs.u[i].data(), sampled.wi, 3));
            CHECK(support::same_bits(inputs.wo[i].data(), sampled.weight, 3));
        }
    }
}

TEST_CASE("batch: a count and strides that leave the address space are refused") {
    const auto bsdf = pellicle::BsdfBuilder("lambert").create();
    const Vec3 up = {0.0f, 0.0f, 1.0f};
    Vec3 value{};
    for (const std::size_t count : {SIZE_MAX, SIZE_MAX / 12, SIZE_MAX / 16}) {
        CAPTURE(count);
        PellicleEvalBatchArgs args{};
        args.count = count;
        args.wo = args.wi = {up.data(), 0, 4};
        args.value = {value.data(), 12, 4};
        CHECK_REFUSED(pellicle_bsdf_eval_batch(bsdf.raw(), &args, sizeof args), PELLICLE_INVALID_ARGUMENT, "value");
    }
}
