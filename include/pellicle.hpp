// pellicle.hpp: a thin C++17 wrapper over pellicle.h. Header only, nothing else to link.
//
// It adds ownership (Bsdf, Film), exceptions (Error) and a way to describe either in one expression
// (BsdfBuilder, FilmBuilder); conventions, units and limits are those written at the top of pellicle.h.
//
// Without exceptions (-fno-exceptions) everything that throws is left out: create with
// BsdfBuilder::create(Bsdf &) and FilmBuilder::create(Film &), which return a status, and call the functions
// of pellicle.h on raw().

#ifndef PELLICLE_HPP
#define PELLICLE_HPP

#include "pellicle.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define PELLICLE_HPP_THROWS 1
#include <stdexcept>
#else
#define PELLICLE_HPP_THROWS 0
#endif

namespace pellicle {

#if PELLICLE_HPP_THROWS
// A call that failed. what() is the text of pellicle_last_error(), copied: it outlives later calls.
class Error : public std::runtime_error {
public:
    Error(PellicleStatus status, const char *message) : std::runtime_error(message), status_(status) {}

    // PELLICLE_INVALID_ARGUMENT and so on; never PELLICLE_OK.
    PellicleStatus status() const noexcept { return status_; }

private:
    PellicleStatus status_;
};
#endif

// Names in here have the prefix of the library: hosts define words such as check and verify as macros.
namespace detail {

#if PELLICLE_HPP_THROWS
inline void pellicle_throw_on_failure(PellicleStatus status) {
    if (status != PELLICLE_OK) throw Error(status, pellicle_last_error());
}
#endif

// One reference to an object of pellicle.h, or none. A copy retains, the destructor releases.
template <class Object, void (*retain)(const Object *), void (*release)(const Object *)> class Handle {
public:
    Handle() noexcept = default;
    // Takes over one reference.
    explicit Handle(Object *adopted) noexcept : object_(adopted) {}

    Handle(const Handle &other) noexcept : object_(other.object_) { retain(object_); }
    Handle(Handle &&other) noexcept : object_(std::exchange(other.object_, nullptr)) {}

    Handle &operator=(const Handle &other) noexcept {
        Handle(other).trade(*this);
        return *this;
    }
    Handle &operator=(Handle &&other) noexcept {
        Handle(std::move(other)).trade(*this);
        return *this;
    }

    ~Handle() { release(object_); }

    Object *get() const noexcept { return object_; }

private:
    void trade(Handle &other) noexcept { object_ = std::exchange(other.object_, object_); }

    Object *object_ = nullptr;
};

} // namespace detail

// Transport and lobes for the calls of a Bsdf: PELLICLE_TRANSPORT_RADIANCE or _IMPORTANCE, and a mask of
// lobe flags, 0 for every lobe.
inline PellicleCall call_options(std::uint32_t transport, std::uint32_t lobes = 0) noexcept {
    PellicleCall options{};
    options.size = sizeof options;
    options.transport = transport;
    options.lobes = lobes;
    return options;
}

// Three floats to read, from `const float *` or std::array. It does not own them: it is meant as a parameter
// type, where a temporary array lives until the call has returned.
class Float3 {
public:
    Float3(const float *components) noexcept : components_(components) {}
    Float3(const std::array<float, 3> &components) noexcept : components_(components.data()) {}

    const float *data() const noexcept { return components_; }

private:
    const float *components_;
};

// A medium of a film. It owns what it is given.
class Medium {
public:
    // Vacuum, as a film's ambient; refused elsewhere.
    Medium() = default;

    // By its name: "Au", "SiO2", "water", ...; upper and lower case are alike.
    Medium(const char *name) : name_(name) {}
    Medium(std::string name) : name_(std::move(name)) {}

    // The same index eta + i k at every wavelength.
    static Medium constant(float eta, float k = 0.0f) { return rgb({eta, eta, eta}, {k, k, k}); }

    // At 645, 525 and 445 nm.
    static Medium rgb(const std::array<float, 3> &eta, const std::array<float, 3> &k = {}) {
        Medium medium;
        medium.eta_ = eta;
        medium.k_ = k;
        return medium;
    }

    // A row of a table of measurements.
    struct Measured {
        float lambda_nm, eta, k;
    };

    // Measured at ascending wavelengths.
    static Medium table(const std::vector<Measured> &rows) {
        Medium medium;
        for (const Measured &row : rows) {
            medium.table_nm_.push_back(row.lambda_nm);
            medium.table_eta_.push_back(row.eta);
            medium.table_k_.push_back(row.k);
        }
        return medium;
    }

    // For pellicle.h; points into this object.
    PellicleMedium raw() const noexcept {
        PellicleMedium medium{};
        medium.name = name_ ? name_->c_str() : nullptr;
        for (std::size_t i = 0; i < 3; ++i) {
            medium.eta[i] = eta_[i];
            medium.k[i] = k_[i];
        }
        if (!table_nm_.empty()) {
            medium.table_nm = table_nm_.data();
            medium.table_eta = table_eta_.data();
            medium.table_k = table_k_.data();
            medium.table_count = table_nm_.size();
        }
        return medium;
    }

private:
    std::optional<std::string> name_{};
    std::array<float, 3> eta_{}, k_{};
    std::vector<float> table_nm_{}, table_eta_{}, table_k_{};
};

// What Film::eval() returns: fractions of the power, RGB.
struct FilmColors {
    std::array<float, 3> reflectance, transmittance;
};

// An owning handle of a compiled film; as with Bsdf, its copies and threads share it.
//
// `cos_theta` is the cosine of incidence, clamped to [1e-9, 1]; `thickness_nm` that of the layer that
// varies, clamped to its range, and without effect if none does. NaN gives 0.
//
// A default-constructed or moved-from Film holds nothing: its calls throw Error with
// PELLICLE_INVALID_ARGUMENT.
class Film {
public:
    Film() noexcept = default;

    // Takes over one reference to a handle made with pellicle.h.
    explicit Film(PellicleFilm *adopted) noexcept : film_(adopted) {}

    // The handle, for calls of pellicle.h; still owned by this object.
    PellicleFilm *raw() const noexcept { return film_.get(); }

    // Stores the film that save() has written in `result`, or leaves that as it was and returns what failed: then create
    // the film anew. Blocks of another build of the library are refused; pellicle_film_load() tells more.
    static PellicleStatus load(const void *block, std::size_t size, Film &result) noexcept {
        PellicleFilm *film = nullptr;
        const PellicleStatus status = pellicle_film_load(block, size, &film);
        if (status == PELLICLE_OK) result = Film(film);
        return status;
    }

#if PELLICLE_HPP_THROWS
    // Compiles a description. Throws Error; the message says what was wrong and what would be right.
    explicit Film(const PellicleFilmDesc &desc) : film_() {
        PellicleFilm *film = nullptr;
        detail::pellicle_throw_on_failure(pellicle_film_create(&desc, sizeof desc, &film));
        film_ = Handle(film);
    }

    // The compiled film as a block of bytes for load(), in memory or in a file.
    std::vector<unsigned char> save() const {
        std::size_t size = 0;
        detail::pellicle_throw_on_failure(pellicle_film_save(raw(), nullptr, 0, &size));
        std::vector<unsigned char> block(size);
        detail::pellicle_throw_on_failure(pellicle_film_save(raw(), block.data(), size, &size));
        return block;
    }

    // Whether a layer varies, and in which range of thickness.
    PellicleFilmInfo info() const {
        PellicleFilmInfo info{};
        detail::pellicle_throw_on_failure(pellicle_film_info(raw(), &info, sizeof info));
        return info;
    }

    // Which method evaluates it, and how well. The texts live as long as the film.
    PellicleFilmPlan plan() const {
        PellicleFilmPlan plan{};
        detail::pellicle_throw_on_failure(pellicle_film_plan(raw(), &plan, sizeof plan));
        return plan;
    }

    // Reflectance from the ambient's side, RGB.
    std::array<float, 3> reflectance(float cos_theta, float thickness_nm = 0.0f) const {
        std::array<float, 3> result{};
        detail::pellicle_throw_on_failure(
            pellicle_film_reflectance(raw(), cos_theta, thickness_nm, result.data()));
        return result;
    }

    // From the side PELLICLE_SIDE_AMBIENT or _BASE; needs FilmBuilder::transmittance().
    FilmColors eval(float cos_theta, float thickness_nm = 0.0f, std::uint32_t side = PELLICLE_SIDE_AMBIENT) const {
        FilmColors result{};
        detail::pellicle_throw_on_failure(pellicle_film_eval(raw(), cos_theta, thickness_nm, side,
                                                             result.reflectance.data(),
                                                             result.transmittance.data()));
        return result;
    }

    // reflectance() averaged over a normal distribution of thickness; needs FilmBuilder::thickness_spread_max().
    std::array<float, 3> reflectance_spread(float cos_theta, float thickness_nm, float thickness_spread_nm) const {
        std::array<float, 3> result{};
        detail::pellicle_throw_on_failure(pellicle_film_reflectance_spread(raw(), cos_theta, thickness_nm,
                                                                           thickness_spread_nm, result.data()));
        return result;
    }

    // eval() averaged likewise.
    FilmColors eval_spread(float cos_theta, float thickness_nm, float thickness_spread_nm,
                           std::uint32_t side = PELLICLE_SIDE_AMBIENT) const {
        FilmColors result{};
        detail::pellicle_throw_on_failure(
            pellicle_film_eval_spread(raw(), cos_theta, thickness_nm, thickness_spread_nm, side,
                                      result.reflectance.data(), result.transmittance.data()));
        return result;
    }

    // reflectance() of args.count elements; the numbers are those of single calls.
    void reflectance_batch(const PellicleFilmBatchArgs &args) const {
        detail::pellicle_throw_on_failure(pellicle_film_reflectance_batch(raw(), &args, sizeof args));
    }

    // What reflectance() approximates: slow, converged, never clipped.
    std::array<float, 3> reference(float cos_theta, float thickness_nm = 0.0f) const {
        std::array<float, 3> result{};
        detail::pellicle_throw_on_failure(
            pellicle_film_reference(raw(), cos_theta, thickness_nm, result.data()));
        return result;
    }

    // Reflectance at `count` vacuum wavelengths.
    void spectrum(float cos_theta, float thickness_nm, const float *lambda_nm, std::size_t count,
                  float *reflectance) const {
        detail::pellicle_throw_on_failure(
            pellicle_film_spectrum(raw(), cos_theta, thickness_nm, lambda_nm, count, reflectance));
    }

    // Reflectance and transmittance at `count` vacuum wavelengths; either may be null.
    void spectrum_eval(float cos_theta, float thickness_nm, std::uint32_t side, const float *lambda_nm,
                       std::size_t count, float *reflectance, float *transmittance) const {
        detail::pellicle_throw_on_failure(pellicle_film_spectrum_eval(
            raw(), cos_theta, thickness_nm, side, lambda_nm, count, reflectance, transmittance));
    }

    // Complex r_s, r_p, t_s, t_p at `count` vacuum wavelengths; pellicle.h states signs and phases.
    void amplitudes(float cos_theta, float thickness_nm, std::uint32_t side, const float *lambda_nm,
                    std::size_t count, PellicleAmplitudes *amplitudes) const {
        detail::pellicle_throw_on_failure(
            pellicle_film_amplitudes(raw(), cos_theta, thickness_nm, side, lambda_nm, count, amplitudes));
    }

    // amplitudes() of args.count elements at args.lambda_count wavelengths; the numbers are those of single calls.
    void amplitudes_batch(const PellicleAmplitudesBatchArgs &args) const {
        detail::pellicle_throw_on_failure(pellicle_film_amplitudes_batch(raw(), &args, sizeof args));
    }
#endif

private:
    using Handle = detail::Handle<PellicleFilm, pellicle_film_retain, pellicle_film_release>;
    Handle film_{};
};

// Describes a film, the layers outermost first:
//
//     auto film = pellicle::FilmBuilder("Si")
//                     .layer("SiO2", 0, 500)
//                     .layer(pellicle::Medium::constant(2.0f), 60)
//                     .tolerance(1e-3f)
//                     .create();
//
// Names and numbers are checked by create(), not before. The builder copies what it is given and
// may create any number of films.
class FilmBuilder {
public:
    // `base`: what the layers lie on.
    explicit FilmBuilder(Medium base) : base_(std::move(base)) {}

    // Where the light comes from, if not vacuum.
    FilmBuilder &ambient(Medium medium) {
        ambient_ = std::move(medium);
        return *this;
    }

    // Adds a layer below those that are there.
    FilmBuilder &layer(Medium medium, float thickness_nm) {
        return layer(std::move(medium), thickness_nm, thickness_nm);
    }

    // Adds a layer whose thickness is given per call, within [min, max]; one layer may vary.
    FilmBuilder &layer(Medium medium, float thickness_min_nm, float thickness_max_nm) {
        layers_.push_back({std::move(medium), thickness_min_nm, thickness_max_nm});
        return *this;
    }

    // The greatest error allowed of a channel of the clipped colours.
    FilmBuilder &tolerance(float tolerance) {
        desc_.tolerance = tolerance;
        return *this;
    }

    // "E" or "D65".
    FilmBuilder &white(std::string name) {
        white_ = std::move(name);
        return *this;
    }

    // "rec709", "rec2020", "acescg" or "xyz".
    FilmBuilder &color_space(std::string name) {
        color_space_ = std::move(name);
        return *this;
    }

    // A method's name, instead of the cheapest that holds the tolerance.
    FilmBuilder &method(std::string name) {
        method_ = std::move(name);
        return *this;
    }

    // Leaves colours outside [0, 1] as they are.
    FilmBuilder &unclipped() {
        desc_.unclipped = 1;
        return *this;
    }

    // Also keeps what Film::eval() needs.
    FilmBuilder &transmittance() {
        desc_.transmittance = 1;
        return *this;
    }

    // Whether light in the base is followed: PELLICLE_BASE_OPAQUE or PELLICLE_BASE_TRANSPARENT, instead of by its k.
    FilmBuilder &base_opaque(std::uint32_t base_opaque) {
        desc_.base_opaque = base_opaque;
        return *this;
    }

    // The greatest standard deviation of the thickness that calls may give, nm.
    FilmBuilder &thickness_spread_max(float nm) {
        desc_.thickness_spread_max_nm = nm;
        return *this;
    }

    // Film::spectrum() also answers outside the ranges of the media, where their indices are taken to be constant.
    FilmBuilder &extrapolate() {
        desc_.extrapolate = 1;
        return *this;
    }

    // The instructions of batches, a name out of PELLICLE_NAMES_SIMD_LEVEL, instead of the widest.
    FilmBuilder &simd_level(std::string name) {
        simd_level_ = std::move(name);
        return *this;
    }

    // Stores a film in `result`, or leaves that as it was and returns what failed.
    PellicleStatus create(Film &result) const {
        const auto text = [](const std::optional<std::string> &name) {
            return name ? name->c_str() : nullptr;
        };
        std::vector<PellicleMedium> media; // the layers point into it: it must not grow below
        media.reserve(layers_.size());
        std::vector<PellicleLayer> layers;
        for (const Layer &layer : layers_) {
            media.push_back(layer.medium.raw());
            layers.push_back({&media.back(), layer.thickness_min_nm, layer.thickness_max_nm});
        }
        const PellicleMedium ambient = ambient_.raw(), base = base_.raw();

        PellicleFilmDesc desc = desc_;
        desc.medium_size = sizeof(PellicleMedium);
        desc.layer_size = sizeof(PellicleLayer);
        desc.ambient = &ambient;
        desc.layers = layers.data();
        desc.layer_count = layers.size();
        desc.base = &base;
        desc.white = text(white_);
        desc.color_space = text(color_space_);
        desc.method = text(method_);
        desc.simd_level = text(simd_level_);
        PellicleFilm *film = nullptr;
        const PellicleStatus status = pellicle_film_create(&desc, sizeof desc, &film);
        if (status == PELLICLE_OK) result = Film(film);
        return status;
    }

#if PELLICLE_HPP_THROWS
    // Throws Error; the message says what was wrong and what would be right.
    Film create() const {
        Film result;
        detail::pellicle_throw_on_failure(create(result));
        return result;
    }
#endif

private:
    struct Layer {
        Medium medium;
        float thickness_min_nm, thickness_max_nm;
    };

    PellicleFilmDesc desc_{}; // its numbers; create() sets the pointers
    Medium ambient_{}, base_;
    std::vector<Layer> layers_{};
    std::optional<std::string> white_{}, color_space_{}, method_{}, simd_level_{};
};

// What Bsdf::eval() returns.
struct Evaluation {
    std::array<float, 3> value; // f(wo, wi) |wi.z|, RGB
    float pdf;                  // density of wi per solid angle
};

// What Bsdf::eval_both_ways() returns.
struct TwoWayEvaluation {
    std::array<float, 3> value; // f(wo, wi) |wi.z|, RGB
    float pdf;                  // density of wi per solid angle, sampled from wo
    float pdf_reverse;          // density of wo per solid angle, sampled from wi
};

// An owning handle of a compiled BSDF. Copies share the same immutable object (its reference count
// goes up), so passing one by value is cheap and every thread may use it at once.
//
// `wo` points to the viewer, `wi` to the light; both are unit vectors in the shading frame.
// `varying` holds the components of the varying parameters one after another, in the order in which
// they were declared (info().varying_floats numbers); nullptr gives each its default. `call` gives transport
// and lobes, see call_options(); nullptr means radiance and every lobe.
//
// A default-constructed or moved-from Bsdf holds nothing: its calls throw Error with
// PELLICLE_INVALID_ARGUMENT.
class Bsdf {
public:
    Bsdf() noexcept = default;

    // Takes over one reference to a handle made with pellicle.h.
    explicit Bsdf(PellicleBsdf *adopted) noexcept : bsdf_(adopted) {}

    // The handle, for calls of pellicle.h; still owned by this object.
    PellicleBsdf *raw() const noexcept { return bsdf_.get(); }

#if PELLICLE_HPP_THROWS
    // Compiles a description. Throws Error; the message says what was wrong and what would be right.
    explicit Bsdf(const PellicleBsdfDesc &desc) : bsdf_() {
        PellicleBsdf *bsdf = nullptr;
        detail::pellicle_throw_on_failure(pellicle_bsdf_create(&desc, sizeof desc, &bsdf));
        bsdf_ = Handle(bsdf);
    }

    // Model, flags, number of lobes and of varying floats.
    PellicleBsdfInfo info() const {
        PellicleBsdfInfo info{};
        detail::pellicle_throw_on_failure(pellicle_bsdf_info(raw(), &info, sizeof info));
        return info;
    }

    // The varying parameter with that number, in declared order: name, range, default.
    PellicleVaryingInfo varying(std::size_t number) const {
        PellicleVaryingInfo info{};
        detail::pellicle_throw_on_failure(pellicle_bsdf_varying(raw(), number, &info, sizeof info));
        return info;
    }

    // The lobe with that number: name and flags.
    PellicleLobeInfo lobe(std::size_t number) const {
        PellicleLobeInfo info{};
        detail::pellicle_throw_on_failure(pellicle_bsdf_lobe(raw(), number, &info, sizeof info));
        return info;
    }

    // f(wo, wi) |wi.z| and the density with which sample() chooses wi.
    Evaluation eval(Float3 wo, Float3 wi, const float *varying = nullptr,
                    const PellicleCall *call = nullptr) const {
        Evaluation result{};
        eval(wo, wi, varying, call, result.value.data(), &result.pdf, nullptr);
        return result;
    }

    // The same, and the density of the reverse direction.
    TwoWayEvaluation eval_both_ways(Float3 wo, Float3 wi, const float *varying = nullptr,
                                    const PellicleCall *call = nullptr) const {
        TwoWayEvaluation result{};
        eval(wo, wi, varying, call, result.value.data(), &result.pdf, &result.pdf_reverse);
        return result;
    }

    // f(wo, wi) |wi.z| alone: cheaper than eval() where the density is not needed.
    std::array<float, 3> value(Float3 wo, Float3 wi, const float *varying = nullptr,
                               const PellicleCall *call = nullptr) const {
        std::array<float, 3> result{};
        eval(wo, wi, varying, call, result.data(), nullptr, nullptr);
        return result;
    }

    // The density alone, per solid angle of wi.
    float pdf(Float3 wo, Float3 wi, const float *varying = nullptr, const PellicleCall *call = nullptr) const {
        float result = 0.0f;
        eval(wo, wi, varying, call, nullptr, &result, nullptr);
        return result;
    }

    // Chooses wi from three uniform numbers in [0, 1). All zero: no valid sample.
    PellicleSample sample(Float3 wo, Float3 u, const float *varying = nullptr,
                          const PellicleCall *call = nullptr) const {
        PellicleSample result{};
        detail::pellicle_throw_on_failure(
            pellicle_bsdf_sample(raw(), wo.data(), u.data(), varying, call, &result, sizeof result));
        return result;
    }

    // Directional albedo, RGB.
    std::array<float, 3> albedo(Float3 wo, const float *varying = nullptr,
                                const PellicleCall *call = nullptr) const {
        std::array<float, 3> result{};
        detail::pellicle_throw_on_failure(
            pellicle_bsdf_albedo(raw(), wo.data(), varying, call, result.data()));
        return result;
    }

    // eval() of args.count elements; the numbers are those of single calls.
    void eval_batch(const PellicleEvalBatchArgs &args) const {
        detail::pellicle_throw_on_failure(pellicle_bsdf_eval_batch(raw(), &args, sizeof args));
    }

    // sample() of args.count elements; the numbers are those of single calls.
    void sample_batch(const PellicleSampleBatchArgs &args) const {
        detail::pellicle_throw_on_failure(pellicle_bsdf_sample_batch(raw(), &args, sizeof args));
    }

    // f |wi.z| and the density of wi at `count` wavelengths, nm; `value` and `pdf`: `count` numbers, or nullptr. Colours
    // in `varying` have `count` numbers each.
    void eval_spectral(Float3 wo, Float3 wi, const float *lambda_nm, std::size_t count, float *value, float *pdf,
                       const float *varying = nullptr, const PellicleCall *call = nullptr) const {
        detail::pellicle_throw_on_failure(pellicle_bsdf_eval_spectral(raw(), wo.data(), wi.data(), varying, call, lambda_nm,
                                                                      count, value, pdf));
    }

    // Chooses wi for wavelength number `hero`; `weight` and `pdf`: a number for each wavelength, or nullptr.
    PellicleSpectralSample sample_spectral(Float3 wo, Float3 u, const float *lambda_nm, std::size_t count, std::size_t hero,
                                           float *weight, float *pdf, const float *varying = nullptr,
                                           const PellicleCall *call = nullptr) const {
        PellicleSpectralSample result{};
        detail::pellicle_throw_on_failure(pellicle_bsdf_sample_spectral(raw(), wo.data(), u.data(), varying, call, lambda_nm,
                                                                        count, hero, weight, pdf, &result, sizeof result));
        return result;
    }

    // eval_spectral() of args.count elements; the numbers are those of single calls.
    void eval_spectral_batch(const PellicleEvalSpectralBatchArgs &args) const {
        detail::pellicle_throw_on_failure(pellicle_bsdf_eval_spectral_batch(raw(), &args, sizeof args));
    }

    // sample_spectral() of args.count elements; the numbers are those of single calls.
    void sample_spectral_batch(const PellicleSampleSpectralBatchArgs &args) const {
        detail::pellicle_throw_on_failure(pellicle_bsdf_sample_spectral_batch(raw(), &args, sizeof args));
    }
#endif

private:
#if PELLICLE_HPP_THROWS
    void eval(Float3 wo, Float3 wi, const float *varying, const PellicleCall *call, float *value, float *pdf,
              float *pdf_reverse) const {
        detail::pellicle_throw_on_failure(
            pellicle_bsdf_eval(raw(), wo.data(), wi.data(), varying, call, value, pdf, pdf_reverse));
    }
#endif

    using Handle = detail::Handle<PellicleBsdf, pellicle_bsdf_retain, pellicle_bsdf_release>;
    Handle bsdf_{};
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

    // The parameter is given per call, each component within [least, greatest]; 0 and 0 for a direction.
    BsdfBuilder &vary(std::string name, float least, float greatest) {
        varying_.push_back({std::move(name), least, greatest});
        return *this;
    }

    // The film, for models that take one; shared, not copied.
    BsdfBuilder &film(Film film) {
        film_ = std::move(film);
        return *this;
    }

    // The instructions of batches, a name out of PELLICLE_NAMES_SIMD_LEVEL, instead of the widest.
    BsdfBuilder &simd_level(std::string name) {
        simd_level_ = std::move(name);
        return *this;
    }

    // Stores a BSDF in `result`, or leaves that as it was and returns what failed.
    PellicleStatus create(Bsdf &result) const {
        std::vector<PellicleParam> params;
        for (const Param &param : params_) {
            params.push_back({param.name.c_str(), param.choice ? nullptr : param.values.data(),
                              param.values.size(), param.choice ? param.choice->c_str() : nullptr});
        }
        std::vector<PellicleRange> varying;
        for (const Range &range : varying_) varying.push_back({range.name.c_str(), range.least, range.greatest});

        PellicleBsdfDesc desc{};
        desc.model = model_.c_str();
        desc.params = params.data();
        desc.param_count = params.size();
        desc.varying = varying.data();
        desc.varying_count = varying.size();
        desc.film = film_.raw();
        desc.simd_level = simd_level_ ? simd_level_->c_str() : nullptr;
        PellicleBsdf *bsdf = nullptr;
        const PellicleStatus status = pellicle_bsdf_create(&desc, sizeof desc, &bsdf);
        if (status == PELLICLE_OK) result = Bsdf(bsdf);
        return status;
    }

#if PELLICLE_HPP_THROWS
    // Throws Error; the message says what was wrong and what would be right.
    Bsdf create() const {
        Bsdf result;
        detail::pellicle_throw_on_failure(create(result));
        return result;
    }
#endif

private:
    struct Param {
        std::string name;
        std::vector<float> values;
        std::optional<std::string> choice; // instead of `values`
    };
    struct Range {
        std::string name;
        float least, greatest;
    };

    std::string model_;
    std::vector<Param> params_{};
    std::vector<Range> varying_{};
    Film film_{};
    std::optional<std::string> simd_level_{};
};

} // namespace pellicle

#endif // PELLICLE_HPP
