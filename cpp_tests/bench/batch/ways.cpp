#include "ways.hpp"

#include <cstdio>

namespace ways {

namespace {

constexpr std::ptrdiff_t one_float = sizeof(float);

PellicleConstView from(const Planes &planes, std::size_t first) {
    return {planes[0] + first, one_float, planes.bytes()};
}
PellicleView into(Planes &planes, std::size_t component, std::size_t first) {
    return {planes[component] + first, one_float, planes.bytes()};
}
PellicleConstView from(const std::vector<Vec3> &packed, std::size_t first) {
    return {packed[first].data(), sizeof(Vec3), one_float};
}
PellicleView into(std::vector<Vec3> &packed, std::size_t first) {
    return {packed[first].data(), sizeof(Vec3), one_float};
}

void eval_batch(const pellicle::Bsdf &bsdf, const float *varying, std::size_t first, PellicleEvalBatchArgs args) {
    const PellicleConstView view = {varying + (varying ? first : 0), one_float, one_float};
    if (varying) {
        args.varying = &view;
        args.varying_count = 1;
    }
    bsdf.eval_batch(args);
}

} // namespace

vectorised::In in(const Elements &elements, const float *varying, std::size_t first) {
    const Planes &wo = elements.wo.planes, &wi = elements.wi.planes;
    return {{wo[0] + first, wo[1] + first, wo[2] + first},
            {wi[0] + first, wi[1] + first, wi[2] + first},
            varying ? varying + first : nullptr};
}

vectorised::Out out(Outputs &outputs, std::size_t first) {
    Planes &planes = outputs.planes;
    return {planes[0] + first, planes[1] + first, planes[2] + first};
}

void add_values(Row &row, const pellicle::Bsdf &bsdf, const Elements &elements, Outputs &outputs,
                const float *varying) {
    row.work[single_way] = [bsdf, &elements, &outputs, varying](std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i)
            pellicle_bsdf_eval(bsdf.raw(), elements.wo.packed[i].data(), elements.wi.packed[i].data(),
                               varying ? varying + i : nullptr, nullptr, outputs.values[i].data(), nullptr, nullptr);
    };
    row.work[batch_way] = [bsdf, &elements, &outputs, varying](std::size_t first, std::size_t count) {
        PellicleEvalBatchArgs args{};
        args.count = count;
        args.wo = from(elements.wo.planes, first);
        args.wi = from(elements.wi.planes, first);
        args.value = into(outputs.planes, 0, first);
        eval_batch(bsdf, varying, first, args);
    };
    row.work[packed_way] = [bsdf, &elements, &outputs, varying](std::size_t first, std::size_t count) {
        PellicleEvalBatchArgs args{};
        args.count = count;
        args.wo = from(elements.wo.packed, first);
        args.wi = from(elements.wi.packed, first);
        args.value = into(outputs.values, first);
        eval_batch(bsdf, varying, first, args);
    };
    const Planes &wo = elements.wo.planes, &wi = elements.wi.planes;
    std::vector<const float *> read = {wo[0], wo[1], wo[2], wi[0], wi[1], wi[2]};
    if (varying) read.push_back(varying);
    add_copy(row, read, outputs, 3);
}

void add_reflectances(Row &row, const pellicle::Film &film, const Elements &elements, Outputs &outputs,
                      bool varies) {
    row.work[single_way] = [film, &elements, &outputs](std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i)
            pellicle_film_reflectance(film.raw(), elements.angles[i].cos_theta, elements.angles[i].thickness_nm,
                                      outputs.values[i].data());
    };
    row.work[batch_way] = [film, &elements, &outputs, varies](std::size_t first, std::size_t count) {
        PellicleFilmBatchArgs args{};
        args.count = count;
        args.cos_theta = {elements.wi.planes[2] + first, one_float, one_float};
        if (varies) args.thickness_nm = {elements.film_nm.data() + first, one_float, one_float};
        args.reflectance = into(outputs.planes, 0, first);
        film.reflectance_batch(args);
    };
    row.work[packed_way] = [film, &elements, &outputs, varies](std::size_t first, std::size_t count) {
        PellicleFilmBatchArgs args{};
        args.count = count;
        args.cos_theta = {&elements.angles[first].cos_theta, sizeof(Angle), one_float};
        if (varies) args.thickness_nm = {&elements.angles[first].thickness_nm, sizeof(Angle), one_float};
        args.reflectance = into(outputs.values, first);
        film.reflectance_batch(args);
    };
    std::vector<const float *> read = {elements.wi.planes[2]};
    if (varies) read.push_back(elements.film_nm.data());
    add_copy(row, read, outputs, 3);
}

void add_samples(Row &row, const pellicle::Bsdf &bsdf, const Elements &elements, Outputs &outputs) {
    row.is_sampling = true;
    row.work[single_way] = [bsdf, &elements, &outputs](std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; ++i) {
            PellicleSample found;
            pellicle_bsdf_sample(bsdf.raw(), elements.wo.packed[i].data(), elements.u.packed[i].data(), nullptr,
                                 nullptr, &found, sizeof found);
            outputs.samples[i] = {{found.wi[0], found.wi[1], found.wi[2]},
                                  found.pdf,
                                  {found.weight[0], found.weight[1], found.weight[2]}};
        }
    };
    row.work[batch_way] = [bsdf, &elements, &outputs](std::size_t first, std::size_t count) {
        PellicleSampleBatchArgs args{};
        args.count = count;
        args.wo = from(elements.wo.planes, first);
        args.u = from(elements.u.planes, first);
        args.wi = into(outputs.planes, 0, first);
        args.pdf = into(outputs.planes, 3, first);
        args.weight = into(outputs.planes, 4, first);
        bsdf.sample_batch(args);
    };
    row.work[packed_way] = [bsdf, &elements, &outputs](std::size_t first, std::size_t count) {
        Sampled &out = outputs.samples[first];
        PellicleSampleBatchArgs args{};
        args.count = count;
        args.wo = from(elements.wo.packed, first);
        args.u = from(elements.u.packed, first);
        args.wi = {out.wi.data(), sizeof(Sampled), one_float};
        args.pdf = {&out.pdf, sizeof(Sampled), one_float};
        args.weight = {out.weight.data(), sizeof(Sampled), one_float};
        bsdf.sample_batch(args);
    };
    const Planes &wo = elements.wo.planes, &u = elements.u.planes;
    add_copy(row, {wo[0], wo[1], wo[2], u[0], u[1], u[2]}, outputs, sampled_floats);
}

namespace {

template <std::size_t in_count, std::size_t out_count>
Work copy(const std::vector<const float *> &in, Outputs &outputs) {
    std::array<const float *, in_count> from;
    std::array<float *, out_count> into;
    for (std::size_t c = 0; c < in_count; ++c) from[c] = in[c];
    for (std::size_t c = 0; c < out_count; ++c) into[c] = outputs.planes[c];
    return [from, into](std::size_t first, std::size_t count) {
#pragma GCC ivdep
        for (std::size_t i = first; i < first + count; ++i) {
            float sum = 0;
            for (std::size_t c = 0; c < in_count; ++c) sum += from[c][i];
            for (std::size_t c = 0; c < out_count; ++c) into[c][i] = sum;
        }
    };
}

} // namespace

void add_copy(Row &row, const std::vector<const float *> &in, Outputs &outputs, std::size_t out) {
    if (out == sampled_floats)
        row.work[copy_way] = copy<6, sampled_floats>(in, outputs);
    else if (in.size() == 7)
        row.work[copy_way] = copy<7, 3>(in, outputs);
    else if (in.size() == 6)
        row.work[copy_way] = copy<6, 3>(in, outputs);
    else if (in.size() == 2)
        row.work[copy_way] = copy<2, 3>(in, outputs);
    else
        row.work[copy_way] = copy<1, 3>(in, outputs);
}

std::string error_bound(const pellicle::Film &film) {
    const PellicleFilmPlan plan = film.plan();
    char text[64];
    std::snprintf(text, sizeof text, "%.1e of %.0e", double(plan.measured_max), double(plan.tolerance));
    return text;
}

} // namespace ways
