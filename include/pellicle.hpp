// pellicle.hpp: a thin C++17 wrapper over pellicle.h. Header only, nothing else to link.
//
// It adds ownership (Bsdf), exceptions (Error) and a way to describe a BSDF in one expression
// (BsdfBuilder); conventions, units and limits are those written at the top of pellicle.h.
// Programs built without exceptions use pellicle.h.

#ifndef PELLICLE_HPP
#define PELLICLE_HPP

#include "pellicle.h"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pellicle {

// A call that failed. what() is the text of pellicle_last_error(), copied: it outlives later calls.
class Error : public std::runtime_error {
public:
    Error(PellicleStatus status, const char *message) : std::runtime_error(message), status_(status) {}

    // PELLICLE_INVALID_ARGUMENT and so on; never PELLICLE_OK.
    PellicleStatus status() const noexcept { return status_; }

private:
    PellicleStatus status_;
};

namespace detail {

inline void check(PellicleStatus status) {
    if (status != PELLICLE_OK) throw Error(status, pellicle_last_error());
}

} // namespace detail

// Three floats to read, from `const float *` or std::array. Does not own them: meant as a parameter
// type, where a temporary array lives until the call has returned.
class Float3 {
public:
    Float3(const float *components) noexcept : components_(components) {}
    Float3(const std::array<float, 3> &components) noexcept : components_(components.data()) {}

    const float *data() const noexcept { return components_; }

private:
    const float *components_;
};

// What Bsdf::eval() returns.
struct Evaluation {
    std::array<float, 3> value; // f(wo, wi) |wi.z|, RGB
    float pdf;                  // density of wi per solid angle
};

// An owning handle of a compiled BSDF. Copies share the same immutable object (its reference count
// goes up), so passing one by value is cheap and every thread may use it at once.
//
// `wo` points to the viewer, `wi` to the light; both are unit vectors in the shading frame.
// `varying` holds the components of the varying parameters one after another, in the order in which
// they were declared (info().varying_floats numbers); nullptr keeps the values given at creation.
//
// A default-constructed or moved-from Bsdf holds nothing: its calls throw Error with
// PELLICLE_INVALID_ARGUMENT.
class Bsdf {
public:
    Bsdf() noexcept = default;

    // Compiles a description. Throws Error; the message says what was wrong and what would be right.
    explicit Bsdf(const PellicleBsdfDesc &desc) { detail::check(pellicle_bsdf_create(&desc, sizeof desc, &bsdf_)); }

    // Takes over one reference to a handle made with pellicle.h.
    explicit Bsdf(PellicleBsdf *adopted) noexcept : bsdf_(adopted) {}

    Bsdf(const Bsdf &other) : bsdf_(other.bsdf_) {
        if (bsdf_ != nullptr) detail::check(pellicle_bsdf_retain(bsdf_));
    }

    Bsdf(Bsdf &&other) noexcept : bsdf_(std::exchange(other.bsdf_, nullptr)) {}

    // By value: the argument is the copy or the move, and takes the old handle away with it.
    Bsdf &operator=(Bsdf other) noexcept {
        std::swap(bsdf_, other.bsdf_);
        return *this;
    }

    ~Bsdf() { pellicle_bsdf_release(bsdf_); }

    // The handle, for calls of pellicle.h; still owned by this object.
    PellicleBsdf *raw() const noexcept { return bsdf_; }

    // Model, flags, number of lobes and of varying floats.
    PellicleBsdfInfo info() const {
        PellicleBsdfInfo info{};
        detail::check(pellicle_bsdf_info(bsdf_, &info, sizeof info));
        return info;
    }

    // f(wo, wi) |wi.z| and the density with which sample() chooses wi.
    Evaluation eval(Float3 wo, Float3 wi, const float *varying = nullptr) const {
        Evaluation result{};
        detail::check(pellicle_bsdf_eval(bsdf_, wo.data(), wi.data(), varying, result.value.data(), &result.pdf));
        return result;
    }

    // f(wo, wi) |wi.z| alone: cheaper than eval() where the density is not needed.
    std::array<float, 3> value(Float3 wo, Float3 wi, const float *varying = nullptr) const {
        std::array<float, 3> result{};
        detail::check(pellicle_bsdf_eval(bsdf_, wo.data(), wi.data(), varying, result.data(), nullptr));
        return result;
    }

    // The density alone, per solid angle of wi.
    float pdf(Float3 wo, Float3 wi, const float *varying = nullptr) const {
        float result = 0.0f;
        detail::check(pellicle_bsdf_eval(bsdf_, wo.data(), wi.data(), varying, nullptr, &result));
        return result;
    }

    // Chooses wi from three uniform numbers in [0, 1). All zero: no valid sample.
    PellicleSample sample(Float3 wo, Float3 u, const float *varying = nullptr) const {
        PellicleSample result{};
        detail::check(pellicle_bsdf_sample(bsdf_, wo.data(), u.data(), varying, &result, sizeof result));
        return result;
    }

    // Directional albedo, RGB.
    std::array<float, 3> albedo(Float3 wo, const float *varying = nullptr) const {
        std::array<float, 3> result{};
        detail::check(pellicle_bsdf_albedo(bsdf_, wo.data(), varying, result.data()));
        return result;
    }

    // eval() of args.count elements; the numbers are the same as of single calls.
    void eval_batch(const PellicleEvalBatchArgs &args) const {
        detail::check(pellicle_bsdf_eval_batch(bsdf_, &args, sizeof args));
    }

    // sample() of args.count elements; the numbers are the same as of single calls.
    void sample_batch(const PellicleSampleBatchArgs &args) const {
        detail::check(pellicle_bsdf_sample_batch(bsdf_, &args, sizeof args));
    }

private:
    PellicleBsdf *bsdf_ = nullptr;
};

// Describes a BSDF by names:
//
//     auto film = pellicle::BsdfBuilder("layered")
//                     .set("eta", {1.4f, 1.45f, 1.6f})
//                     .choose("variant", "paper")
//                     .vary("thickness_nm", 66, 76)
//                     .create();
//
// Names and numbers are checked by create(), not before. The builder copies what it is given and
// may create any number of BSDFs.
class BsdfBuilder {
public:
    // `model`: a name that pellicle_model_info() lists.
    explicit BsdfBuilder(std::string model) : model_(std::move(model)) {}

    // One number; for a parameter with three components it stands for all three.
    BsdfBuilder &set(std::string name, float value) { return set(std::move(name), &value, 1); }

    BsdfBuilder &set(std::string name, std::initializer_list<float> values) {
        return set(std::move(name), values.begin(), values.size());
    }

    BsdfBuilder &set(std::string name, const float *values, std::size_t count) {
        params_.push_back({std::move(name), {values, values + count}, std::nullopt});
        return *this;
    }

    // One name out of a list, for a parameter of kind CHOICE.
    BsdfBuilder &choose(std::string name, std::string choice) {
        params_.push_back({std::move(name), {}, std::move(choice)});
        return *this;
    }

    // The parameter is given per call, each component within [min, max]; 0 and 0 for a direction.
    BsdfBuilder &vary(std::string name, float min, float max) {
        varying_.push_back({std::move(name), min, max});
        return *this;
    }

    // Throws Error; the message says what was wrong and what would be right.
    Bsdf create() const {
        std::vector<PellicleParam> params;
        for (const Param &param : params_) {
            params.push_back({param.name.c_str(), param.choice ? nullptr : param.values.data(),
                              param.values.size(), param.choice ? param.choice->c_str() : nullptr});
        }
        std::vector<PellicleRange> varying;
        for (const Range &range : varying_) varying.push_back({range.name.c_str(), range.min, range.max});

        PellicleBsdfDesc desc{};
        desc.model = model_.c_str();
        desc.params = params.data();
        desc.param_count = params.size();
        desc.varying = varying.data();
        desc.varying_count = varying.size();
        return Bsdf(desc);
    }

private:
    struct Param {
        std::string name;
        std::vector<float> values;
        std::optional<std::string> choice; // instead of `values`
    };
    struct Range {
        std::string name;
        float min, max;
    };

    std::string model_;
    std::vector<Param> params_;
    std::vector<Range> varying_;
};

} // namespace pellicle

#endif // PELLICLE_HPP
