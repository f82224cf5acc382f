/* pellicle 0.1.0: layered and thin-film reflectance and the classic shading models, as
 * eval / sample / pdf, for renderers. MIT OR Apache-2.0.
 *
 * Generated from the Rust sources by cbindgen; do not edit.
 *
 * CONVENTIONS
 *
 * Frame. Directions are unit, point away from the surface and live in the local shading frame: +Z
 * is the shading normal, +X the tangent. wo goes to the viewer, wi to the light.
 *
 * Quantities. value = f(wo, wi) |wi.z|, RGB. pdf is per solid angle of wi. weight = value / pdf.
 * Lengths are nanometres. RGB is linear Rec.709, unless a film's description names another space; a
 * perfect mirror is (1, 1, 1) in all of them. A complex index is eta + i k, k >= 0, vacuum 1. Three
 * index values belong to 645, 525 and 445 nm: linear in 1 / lambda^2 between, constant outside.
 *
 * Sides. Without the flag TRANSMISSION, wi.z <= 0 or wo.z <= 0 gives 0: one-sided, the caller flips.
 * With it, z < 0 is the base's side and z = 0 gives 0. What is transmitted is radiance, which carries
 * (eta_o / eta_i)^2, unless the call asks for importance. Dirac lobes give value = pdf = 0; only
 * sample() returns them, with weight and pdf = 0.
 *
 * Data never fails. Finite inputs give finite, non-negative outputs (unclipped colours of films may
 * be negative). A direction within 1e-3 of unit length is accepted; unless it is unit to 5e-7 it is normalised first,
 * so that outputs are unit to 1e-6 and evaluations agree with samples. Any other direction, NaN and infinity
 * give 0 for that element and leave its neighbours alone. A varying parameter's
 * finite value outside its declared range is clamped to it; NaN or infinity there gives 0 for that
 * element. In the calls of a film, cosines are clamped to [1e-9, 1] and thicknesses to the declared
 * range, infinities too, and NaN gives 0. A varying parameter that a call does not give has its value
 * in `params`; without one there, it has the model's default, clamped to the declared range. Nothing
 * else is clamped.
 *
 * Pointers and counts can fail. Every function checks every pointer for NULL. On failure a status
 * other than PELLICLE_OK is returned, outputs are untouched, and pellicle_last_error() says which
 * argument was wrong, its value, and what is allowed. Every array may lie at any alignment.
 *
 * Threads. Every function may be called from any thread. Handles are immutable and
 * reference-counted: share them freely. Nothing starts threads, locks, logs, calls back or reads the
 * environment; the only state of the process is each thread's last error. Only these allocate: create();
 * pellicle_name(); pellicle_film_reference() and pellicle_film_spectrum(); what evaluates a film whose plan's method
 * is "reference"; and a failing call, for its message. A defect of pellicle is reported as PELLICLE_INTERNAL, and
 * Rust's line about it may appear on the standard error stream.
 *
 * Stack. Every call, create() too, needs at most 32 KiB of stack; reporting a defect may need more.
 *
 * Floating point. Results do not depend on the rounding that the host has set, and unmasked traps do not fire: a
 * call that finds another rounding than to nearest, or unmasked traps, sets the default and restores what was there.
 * That takes 6 to 8 ns for another rounding and 40 to 60 ns for traps. Where nothing differs, a single call takes half
 * a nanosecond longer, every other call 5 (Zen 4). One exception, on x86-64: single calls see traps that are unmasked
 * in both units, as by feenableexcept(), or that were unmasked in MXCSR when their film or BSDF was created; to unmask
 * them in MXCSR alone later is not supported. Flush-to-zero and denormals-are-zero stay as they are, and results are
 * right under both. Flags of exceptions may be raised; none is raised where traps are unmasked.
 *
 * Batches. Elements are evaluated side by side with the widest of SSE2, AVX2 and AVX-512, or NEON, that
 * the processor has, to the same bits as single calls. Components whose elements lie side by side are
 * the fastest, then whole packed elements.
 *
 * Growth. Structs grow by appending, and zero means default: zero-initialise them and state their
 * size. The size of a struct that is passed alone stands beside it in the call; that of PellicleCall in
 * its first field; that of PellicleMedium and PellicleLayer in the description that points to them.
 * A shorter struct of an older caller is accepted; a longer one is accepted if what this build does not
 * know is zero, else UNSUPPORTED. Outputs are written up to the smaller size. A size that no version can
 * have (0, above 65,536, or no multiple of the struct's alignment) is INVALID_ARGUMENT. Structs that say
 * "Frozen" do not grow.
 *
 * EXAMPLE
 *
 *   PellicleMedium glass = {0}, water = {0};
 *   glass.name = "BK7";
 *   water.name = "water";
 *   PellicleLayer layer = {&water, 0.0f, 500.0f};               // its thickness comes with every call
 *   PellicleFilmDesc desc = {sizeof glass, sizeof layer};       // the sizes of this header's structs
 *   desc.layers = &layer;
 *   desc.layer_count = 1;
 *   desc.base = &glass;
 *   PellicleFilm *film;
 *   if (pellicle_film_create(&desc, sizeof desc, &film) != PELLICLE_OK) puts(pellicle_last_error());
 *   else {
 *       float rgb[3];
 *       pellicle_film_reflectance(film, 0.8f, 320.0f, rgb);     // cosine of incidence, nm
 *       pellicle_film_release(film);
 *   }
 */


#ifndef PELLICLE_H
#define PELLICLE_H

#include <stddef.h>
#include <stdint.h>

// The call succeeded.
#define PELLICLE_OK 0

// A pointer is NULL, a count or size is wrong, or arguments overlap or contradict each other.
#define PELLICLE_INVALID_ARGUMENT 1

// Nothing of that name exists. The message lists the names that do.
#define PELLICLE_UNKNOWN_NAME 2

// A number is outside its range, or NaN or infinite. The message gives the value and the range.
#define PELLICLE_OUT_OF_RANGE 3

// This build or this processor does not offer what was asked for, such as a field of a later version.
#define PELLICLE_UNSUPPORTED 4

// An allocation failed.
#define PELLICLE_OUT_OF_MEMORY 5

// Pellicle itself has a defect: a panic was caught at the boundary. Handles stay usable.
#define PELLICLE_INTERNAL 6

// The number of the binary interface that this header describes, and of the SONAME. 0 means that the
// interface may still change between versions: rebuild programs with every new version. From 1 on it
// changes only when programs must be rebuilt.
#define PELLICLE_ABI_VERSION 0

// Flag of a lobe, and of models and BSDFs that have one: light leaves on the side of the viewer.
#define PELLICLE_REFLECTION 1

// Light leaves on the other side. A model without this flag is one-sided: it is 0 at and below the horizon.
#define PELLICLE_TRANSMISSION 2

// The lobe is broad and has no preferred direction.
#define PELLICLE_DIFFUSE 4

// The lobe lies around a preferred direction.
#define PELLICLE_GLOSSY 8

// The lobe is perfectly specular: eval() returns 0 for it, and only sample() finds it.
#define PELLICLE_DELTA 16

// Transport of radiance, from lights along camera paths: refraction carries (eta_o / eta_i)^2.
#define PELLICLE_TRANSPORT_RADIANCE 0

// Transport of importance, along light paths and photons: that factor is left out.
#define PELLICLE_TRANSPORT_IMPORTANCE 1

// Kind of a parameter: `components` numbers, each within [min, max].
#define PELLICLE_KIND_NUMBER 0

// Kind of a parameter: a direction in the shading frame. Any length but 0 is accepted and normalised;
// after that its z must lie within [min, max].
#define PELLICLE_KIND_DIRECTION 1

// Kind of a parameter: one name out of a list, given in PellicleParam::choice.
#define PELLICLE_KIND_CHOICE 2

// Side of a film that the light comes from: the ambient medium.
#define PELLICLE_SIDE_AMBIENT 0

// Side of a film that the light comes from: the base.
#define PELLICLE_SIDE_BASE 1

// PellicleFilmDesc::base_opaque: light that has entered the base is followed there if the base's k is at most
// 1e-3 at 550 nm, so that 1 / e of the power is left after 44 um or more.
#define PELLICLE_BASE_BY_K 0

// PellicleFilmDesc::base_opaque: what enters the base is absorbed, whatever its k is.
#define PELLICLE_BASE_OPAQUE 1

// PellicleFilmDesc::base_opaque: light in the base is followed, whatever its k is.
#define PELLICLE_BASE_TRANSPARENT 2

// List for pellicle_name(): the methods of evaluating a film.
#define PELLICLE_NAMES_METHOD 0

// List for pellicle_name(): the colour spaces, the default first.
#define PELLICLE_NAMES_COLOR_SPACE 1

// List for pellicle_name(): the whites, the default first.
#define PELLICLE_NAMES_WHITE 2

// List for pellicle_name(): the SIMD levels of this processor, the narrowest first; the last one is the
// default.
#define PELLICLE_NAMES_SIMD_LEVEL 3

// The table of all functions, which pellicle_get_api() gives.
typedef struct PellicleApi PellicleApi;

// A compiled BSDF. It is opaque, immutable and reference-counted, and every thread may use it at once.
typedef struct PellicleBsdf PellicleBsdf;

// A compiled film. It is opaque, immutable and reference-counted, and every thread may use it at once.
typedef struct PellicleFilm PellicleFilm;

// The result of a call: PELLICLE_OK (0) or one of the failures below. After a failure every output is as
// it was before the call, and pellicle_last_error() says in words what was wrong.
typedef int32_t PellicleStatus;

// A model that this build offers. Its texts live as long as the library. It grows by appending;
// pass sizeof(PellicleModelInfo).
typedef struct PellicleModelInfo {
    // The name to create it by.
    const char *name;
    // What the model is, in one sentence.
    const char *summary;
    // Where the model comes from.
    const char *source;
    // PELLICLE_REFLECTION and so on, of all lobes together.
    uint32_t flags;
    // Number of parameters; pellicle_model_param() describes them.
    uint32_t param_count;
    // Number of lobes that sample() chooses from, with the parameters that give the most of them.
    uint32_t lobe_count;
    // When and why value(wo, wi) wo.z differs from value(wi, wo) wi.z; NULL: never.
    const char *not_reciprocal;
    // When and why the albedo exceeds 1; NULL: never.
    const char *not_conserving;
    // 1: with every parameter at its default it needs PellicleBsdfDesc::film; 0: it takes none then.
    uint32_t needs_film;
} PellicleModelInfo;

// A parameter of a model. Its texts live as long as the library. It grows by appending; pass
// sizeof(PellicleModelParam).
typedef struct PellicleModelParam {
    // The parameter's name.
    const char *name;
    // "nm", "radians", "turns", or "" for a pure number.
    const char *unit;
    // What the parameter means, in one sentence.
    const char *summary;
    // PELLICLE_KIND_NUMBER, _DIRECTION or _CHOICE.
    uint32_t kind;
    // Number of components: 1 or 3; 0 for a CHOICE.
    uint32_t components;
    // 1 if it may be listed in PellicleBsdfDesc::varying.
    uint32_t can_vary;
    // Least value of each component.
    float min;
    // Greatest value of each component.
    float max;
    // Default of each component; unused ones are 0.
    float default_value[3];
    // The names of a CHOICE, then NULL; the first is the default. NULL for other kinds.
    const char *const *choices;
    // Number of names of a CHOICE; 0 for other kinds.
    uint32_t choice_count;
} PellicleModelParam;

// A medium that is known by name. Its texts live as long as the library. It grows by appending; pass
// sizeof(PellicleMediumInfo).
typedef struct PellicleMediumInfo {
    // The chemical formula, or the usual name.
    const char *name;
    // Other names for it, then NULL.
    const char *const *also;
    // Who measured it.
    const char *source;
    // The least wavelength of its data, nm; the index is constant below. 0 for vacuum.
    float lambda_min_nm;
    // The greatest wavelength of its data, nm; the index is constant above. Infinite for vacuum.
    float lambda_max_nm;
    // 1: it absorbs somewhere in that range; 0: it is transparent.
    uint32_t absorbs;
} PellicleMediumInfo;

// A medium, given in one of three ways: by `name`, by `eta` and `k`, or by a table of measurements.
// All zero means vacuum as a film's ambient and is refused elsewhere. It grows by appending; its size
// stands in PellicleFilmDesc::medium_size.
typedef struct PellicleMedium {
    // "Au", "SiO2", "water", ...; upper and lower case are alike. pellicle_medium_info() lists the names.
    const char *name;
    // Refractive index at 645, 525 and 445 nm, each within [0.001, 1000]: linear in 1 / lambda^2
    // between them, constant outside. Three equal values are a constant.
    float eta[3];
    // Extinction, the index's imaginary part, at the same wavelengths, each within [0, 1000].
    // 0: transparent.
    float k[3];
    // `table_count` vacuum wavelengths in nm, ascending, within [1, 1e6]: the index is linear between
    // them and constant outside. Copied.
    const float *table_nm;
    // `table_count` refractive indices, in the range of `eta`. Copied.
    const float *table_eta;
    // `table_count` extinctions, in the range of `k`. Copied.
    const float *table_k;
    // Number of entries in each of the three arrays of the table.
    size_t table_count;
} PellicleMedium;

// A layer of a film. It grows by appending; its size stands in PellicleFilmDesc::layer_size.
typedef struct PellicleLayer {
    // The layer's medium. Copied.
    const PellicleMedium *medium;
    // Least thickness, nm, within [0, 1e8].
    float thickness_min_nm;
    // Greatest thickness, nm, within [0, 1e8]. Equal to the least: fixed. At most one layer of a film
    // may vary; its thickness comes with every call.
    float thickness_max_nm;
} PellicleLayer;

// What film to create: layers between an ambient medium and a base. Zero-initialise it, then set
// what you need: zero means default. It grows by appending; pass sizeof(PellicleFilmDesc).
typedef struct PellicleFilmDesc {
    // sizeof(PellicleMedium); needed.
    size_t medium_size;
    // sizeof(PellicleLayer): the bytes from one layer to the next. Needed if there are layers.
    size_t layer_size;
    // Where the light comes from; NULL: vacuum. It must have k = 0 and eta >= 1. Copied.
    const PellicleMedium *ambient;
    // The layers, the ambient's neighbour first; NULL if `layer_count` is 0. Copied.
    const PellicleLayer *layers;
    // Number of layers, at most 64; 0: the bare base.
    size_t layer_count;
    // What the layers lie on; needed. Copied.
    const PellicleMedium *base;
    // The greatest error allowed of a channel of the clipped colours, within [1e-5, 1];
    // 0: the default, 2e-3.
    float tolerance;
    // 1: leave colours outside [0, 1] as they are (saturated films have such, negative ones too);
    // 0: clip them.
    uint32_t unclipped;
    // 1: also keep the transmittance, and the reflectance from the base's side, for
    // pellicle_film_eval(); 0: do not.
    uint32_t transmittance;
    // The white in which a perfect mirror is (1, 1, 1): "E" or "D65"; NULL: "E".
    const char *white;
    // "rec709", "rec2020", "acescg" or "xyz", linear; NULL: "rec709".
    const char *color_space;
    // The name of the method of evaluation, out of PELLICLE_NAMES_METHOD; NULL: the cheapest that holds the
    // tolerance.
    const char *method;
    // The instructions of batches, out of PELLICLE_NAMES_SIMD_LEVEL; NULL: the widest. For tests: the
    // results are the same.
    const char *simd_level;
    // PELLICLE_BASE_BY_K, PELLICLE_BASE_OPAQUE or PELLICLE_BASE_TRANSPARENT: whether light that has entered the base
    // is followed there. It decides whether the model "film" has the flag TRANSMISSION and whether light comes from
    // the base's side, never what is reflected and what enters from the ambient's side.
    uint32_t base_opaque;
    // 1: pellicle_film_spectrum() also answers outside the ranges of wavelengths of the media, where their indices
    // are taken to be constant; 0: it refuses that. A named medium has the range of its data (PellicleMediumInfo), a
    // table that of its entries, a constant given by `eta` and `k` all wavelengths, and one that disperses 380-780 nm.
    uint32_t extrapolate;
    // The greatest standard deviation of the thickness that varies which calls may give, nm, within [0, 1e8];
    // 0: calls give none. Where averages of up to 64 look-ups do not suffice, tables of averages are made, which
    // PellicleFilmPlan::bytes counts. No layer that varies: INVALID_ARGUMENT.
    float thickness_spread_max_nm;
} PellicleFilmDesc;

// What a film is. It grows by appending; pass sizeof(PellicleFilmInfo).
typedef struct PellicleFilmInfo {
    // 1: a layer's thickness varies and comes with every call; 0: none does.
    uint32_t varies;
    // 1: pellicle_film_eval() can be called; 0: the film keeps no transmittance.
    uint32_t transmittance;
    // Least thickness of the layer that varies, nm; 0 if none does.
    float thickness_min_nm;
    // Greatest thickness of the layer that varies, nm; 0 if none does.
    float thickness_max_nm;
    // 1: what enters the base is absorbed, and no light comes from it; 0: light in the base is followed. By the
    // base's k and PellicleFilmDesc::base_opaque.
    uint32_t base_opaque;
    // The attenuation 4 pi k / lambda of light in the base, per millimetre, RGB: the absorption coefficient of the
    // renderer's volume there. The mean of each channel under its weights, which is exact for short paths; a channel
    // whose negative weights prevail has 0.
    float base_attenuation_per_mm[3];
    // The least wavelength that all media are known for, nm; PellicleFilmDesc::extrapolate tells their ranges. Greater
    // than `lambda_max_nm` if there is none.
    float lambda_min_nm;
    // The greatest wavelength that all media are known for, nm; infinite if all are constant.
    float lambda_max_nm;
    // The greatest standard deviation of the thickness that calls may give, nm; 0: they may give none.
    float thickness_spread_max_nm;
} PellicleFilmInfo;

// How a film evaluates light from one side. Frozen.
typedef struct PellicleFilmSidePlan {
    // The method's name. It lives as long as the library.
    const char *method;
    // The greatest error of a channel that was measured on this side at creation.
    float measured_max;
    // The root of the mean square of the errors measured on this side.
    float measured_rms;
    // Estimated nanoseconds of one call, on one core of a 2024 server with nothing else to do: of pellicle_film_eval()
    // if the film keeps its transmittance, of pellicle_film_reflectance() if not. Tables are estimated to a factor of
    // two, the methods "series" and "reference" to an order of magnitude.
    float cost_ns;
    // The greatest part of the light that the layers absorb, of a channel, at the points looked at; 0 if no layer
    // absorbs. What enters a base that absorbs counts as transmitted.
    float absorbed_max;
} PellicleFilmSidePlan;

// How a film is evaluated, and how well. It grows by appending; pass sizeof(PellicleFilmPlan).
typedef struct PellicleFilmPlan {
    // The method's name. It lives as long as the library.
    const char *method;
    // The error that was allowed.
    float tolerance;
    // The greatest error of a channel that was measured at creation, of the clipped colours against
    // full wave optics.
    float measured_max;
    // The root of the mean square of the errors measured.
    float measured_rms;
    // Bytes of the film's tables.
    size_t bytes;
    // Why this method was chosen, in a sentence. It lives as long as the film.
    const char *reason;
    // How light from the ambient's side is evaluated.
    PellicleFilmSidePlan ambient;
    // How light from the base's side is evaluated. All 0 if the film keeps no transmittance or its base is opaque.
    PellicleFilmSidePlan base;
    // The index of the ambient that directions of refraction follow, at `eta_lambda_nm`.
    float eta_ambient;
    // The index of the base that directions of refraction follow, its real part, at `eta_lambda_nm`.
    float eta_base;
    // The wavelength of these indices, nm: 550.
    float eta_lambda_nm;
} PellicleFilmPlan;

// Complex ratios of the electric fields of reflected and transmitted light to that of the incident light:
// real part, imaginary part. pellicle_film_amplitudes() states signs and phases. Frozen.
typedef struct PellicleAmplitudes {
    // Reflected, E parallel to the layers.
    float r_s[2];
    // Reflected, H parallel to the layers.
    float r_p[2];
    // Transmitted, E parallel to the layers.
    float t_s[2];
    // Transmitted, H parallel to the layers.
    float t_p[2];
} PellicleAmplitudes;

// One parameter of a model, by name: either numbers (`values`, `count`) or a `choice`, never both. Frozen.
typedef struct PellicleParam {
    // The parameter's name; pellicle_model_param() lists them.
    const char *name;
    // `count` numbers. One number for a parameter with three components stands for all three
    // (directions excepted). Copied.
    const float *values;
    // Number of entries in `values`.
    size_t count;
    // The chosen name for a parameter of kind CHOICE; NULL for the others. Copied.
    const char *choice;
} PellicleParam;

// A parameter that the caller supplies with every call, from a texture for example. Frozen.
typedef struct PellicleRange {
    // The parameter's name; pellicle_model_param() tells which may vary.
    const char *name;
    // Least value of each component. For a direction give 0 and 0: any vector with z > 0 is
    // accepted at call time and normalised.
    float min;
    // Greatest value of each component. Finite values outside [min, max] at call time are clamped
    // to it. NaN or infinity there gives 0 for that element.
    float max;
} PellicleRange;

// What BSDF to create. Zero-initialise it, then set what you need: zero means default. It grows by
// appending; pass sizeof(PellicleBsdfDesc).
typedef struct PellicleBsdfDesc {
    // The model's name: "lambert", "phong", "layered", ...; pellicle_model_info() lists them.
    const char *model;
    // Parameters that differ from their defaults; NULL if `param_count` is 0. Copied.
    const PellicleParam *params;
    // Number of entries in `params`.
    size_t param_count;
    // Parameters given per call, in the order in which their components are passed; NULL if
    // `varying_count` is 0. Copied.
    const PellicleRange *varying;
    // Number of entries in `varying`.
    size_t varying_count;
    // The film, for models that take one. It is retained, so release yours when you like. A film that is
    // not used, and none where one is needed, are INVALID_ARGUMENT. If a layer of it varies, the parameter
    // thickness_nm is needed, fixed or varying within the layer's range; if none does, it is refused.
    const PellicleFilm *film;
    // The instructions of batches, out of PELLICLE_NAMES_SIMD_LEVEL; NULL: the widest. For tests: the
    // results are the same.
    const char *simd_level;
} PellicleBsdfDesc;

// What a BSDF is. It grows by appending; pass sizeof(PellicleBsdfInfo).
typedef struct PellicleBsdfInfo {
    // The model's name. It lives as long as the library.
    const char *model;
    // PELLICLE_REFLECTION and so on, of all lobes together.
    uint32_t flags;
    // Number of parameters that vary per call; pellicle_bsdf_varying() describes them.
    uint32_t varying_count;
    // Number of components that they have together: the length of `varying` in the single calls.
    uint32_t varying_floats;
    // Number of lobes that sample() chooses from; pellicle_bsdf_lobe() describes them.
    uint32_t lobe_count;
    // What the BSDF was specialised to, in words: terms that its values leave out, formulas that are
    // shorter for them, and the instructions of batches. It lives as long as the BSDF.
    const char *plan;
} PellicleBsdfInfo;

// A parameter that varies in a BSDF. It grows by appending; pass sizeof(PellicleVaryingInfo).
typedef struct PellicleVaryingInfo {
    // The parameter's name. It lives as long as the library.
    const char *name;
    // "nm", "radians", "turns", or "" for a pure number. It lives as long as the library.
    const char *unit;
    // PELLICLE_KIND_NUMBER or PELLICLE_KIND_DIRECTION.
    uint32_t kind;
    // Number of components: 1 or 3.
    uint32_t components;
    // Place of its first component in the `varying` of the single calls.
    uint32_t offset;
    // Least value of each component; 0 for a direction.
    float min;
    // Greatest value of each component; 0 for a direction.
    float max;
    // The values that it has where a call does not give it; unused components are 0.
    float default_value[3];
} PellicleVaryingInfo;

// A lobe of a BSDF. It grows by appending; pass sizeof(PellicleLobeInfo).
typedef struct PellicleLobeInfo {
    // The lobe's name, for people. It lives as long as the library.
    const char *name;
    // PELLICLE_REFLECTION | PELLICLE_GLOSSY and so on.
    uint32_t flags;
} PellicleLobeInfo;

// How to evaluate, sample or integrate in one call. NULL instead of a pointer to it, or zeros, mean
// radiance and every lobe. It begins with its own size and grows by appending.
typedef struct PellicleCall {
    // sizeof(PellicleCall).
    size_t size;
    // PELLICLE_TRANSPORT_RADIANCE or PELLICLE_TRANSPORT_IMPORTANCE.
    uint32_t transport;
    // A mask of lobe flags: a lobe belongs to the call if all its flags are in the mask. Values, densities,
    // selection and samples are those of these lobes alone. 0: every lobe.
    uint32_t lobes;
} PellicleCall;

// A sampled direction. It grows by appending; pass sizeof(PellicleSample).
// Without a valid sample, and for a random number outside [0, 1), it is all zero, with status PELLICLE_OK.
typedef struct PellicleSample {
    // Direction to the light, unit, in the shading frame.
    float wi[3];
    // Density of wi per solid angle, of all lobes of the call together; 0 for a DELTA lobe.
    float pdf;
    // value / pdf, RGB; for a DELTA lobe the throughput over the probability of choosing it.
    float weight[3];
    // Refractive index on wi's side over that on wo's side; 1 for a reflection.
    float eta;
    // Flags of the chosen lobe: PELLICLE_REFLECTION | PELLICLE_GLOSSY and so on.
    uint32_t flags;
    // Number of the chosen lobe, below PellicleBsdfInfo::lobe_count.
    uint32_t lobe;
    // Probability with which that lobe was chosen among the lobes of the call.
    float lobe_probability;
} PellicleSample;

// A direction sampled for one wavelength, the hero. It grows by appending; pass sizeof(PellicleSpectralSample).
// Without a valid sample, and for a random number outside [0, 1), it is all zero, with status PELLICLE_OK.
typedef struct PellicleSpectralSample {
    // Direction to the light, unit, in the shading frame.
    float wi[3];
    // Refractive index on wi's side over that on wo's side, for the hero; 1 for a reflection.
    float eta;
    // Flags of the chosen lobe: PELLICLE_REFLECTION | PELLICLE_GLOSSY and so on.
    uint32_t flags;
    // Number of the chosen lobe, below PellicleBsdfInfo::lobe_count.
    uint32_t lobe;
    // Probability with which the hero chose that lobe among the lobes of the call.
    float lobe_probability;
    // 1 if the hero alone goes in this direction, because a medium disperses and the ray was refracted; else 0. The
    // other wavelengths have weight and density 0, and the hero's weight counts for all of them: it is divided by the
    // mean of the densities like any other. A path goes on with that wavelength alone.
    uint32_t hero_only;
} PellicleSpectralSample;

// A strided array to read: component c of element i is at
// `(const char*)data + i * element_stride + c * component_stride`. Strides are in bytes and may be
// negative; element_stride 0 broadcasts one element. Any alignment. Frozen.
typedef struct PellicleConstView {
    // Component 0 of element 0.
    const float *data;
    // Bytes from one element to the next.
    ptrdiff_t element_stride;
    // Bytes from one component to the next.
    ptrdiff_t component_stride;
} PellicleConstView;

// A strided array to write, addressed like PellicleConstView. data NULL means that it is not wanted. Its
// elements and components must not overlap one another. Any alignment. Frozen.
typedef struct PellicleView {
    // Component 0 of element 0.
    float *data;
    // Bytes from one element to the next.
    ptrdiff_t element_stride;
    // Bytes from one component to the next.
    ptrdiff_t component_stride;
} PellicleView;

// Arguments of pellicle_bsdf_eval_spectral_batch(). Zero-initialise them. They grow by appending; pass
// sizeof(PellicleEvalSpectralBatchArgs).
typedef struct PellicleEvalSpectralBatchArgs {
    // Number of elements; 0 is allowed and does nothing.
    size_t count;
    // Number of wavelengths of each element, 1 to 16.
    size_t lambda_count;
    // Vacuum wavelengths, nm, lambda_count components; element_stride 0 gives all elements the same.
    PellicleConstView lambda_nm;
    // Directions to the viewer, 3 components.
    PellicleConstView wo;
    // Directions to the light, 3 components.
    PellicleConstView wi;
    // As in PellicleEvalBatchArgs, but colours have lambda_count components.
    const PellicleConstView *varying;
    // As in PellicleEvalBatchArgs.
    size_t varying_count;
    // As in PellicleEvalBatchArgs.
    const PellicleCall *call;
    // Receives f(wo, wi) |wi.z|, lambda_count components.
    PellicleView value;
    // Receives the densities of wi as if each wavelength had been the hero, lambda_count components.
    PellicleView pdf;
} PellicleEvalSpectralBatchArgs;

// A strided array of whole numbers to write, one per element. data NULL means that it is not wanted. Any
// alignment. Frozen.
typedef struct PellicleUintView {
    // Element 0.
    uint32_t *data;
    // Bytes from one element to the next.
    ptrdiff_t element_stride;
} PellicleUintView;

// Arguments of pellicle_bsdf_sample_spectral_batch(). Zero-initialise them. They grow by appending; pass
// sizeof(PellicleSampleSpectralBatchArgs).
typedef struct PellicleSampleSpectralBatchArgs {
    // Number of elements; 0 is allowed and does nothing.
    size_t count;
    // Number of wavelengths of each element, 1 to 16.
    size_t lambda_count;
    // Number of the wavelength that directions are sampled for, below lambda_count.
    size_t hero;
    // As in PellicleEvalSpectralBatchArgs.
    PellicleConstView lambda_nm;
    // Directions to the viewer, 3 components.
    PellicleConstView wo;
    // Uniform random numbers in [0, 1), 3 components.
    PellicleConstView u;
    // As in PellicleEvalSpectralBatchArgs.
    const PellicleConstView *varying;
    // As in PellicleEvalBatchArgs.
    size_t varying_count;
    // As in PellicleEvalBatchArgs.
    const PellicleCall *call;
    // Receives the directions to the light, 3 components.
    PellicleView wi;
    // Receives the weights, lambda_count components.
    PellicleView weight;
    // Receives the densities as if each wavelength had been the hero, lambda_count components.
    PellicleView pdf;
    // Receives the ratio of indices, 1 component.
    PellicleView eta;
    // Receives the chosen lobe's flags.
    PellicleUintView flags;
    // Receives the chosen lobe's number.
    PellicleUintView lobe;
    // Receives the probability with which the hero chose that lobe, 1 component.
    PellicleView lobe_probability;
    // Receives 1 where the hero alone goes in that direction, else 0.
    PellicleUintView hero_only;
} PellicleSampleSpectralBatchArgs;

// Arguments of pellicle_bsdf_eval_batch(). Zero-initialise them. They grow by appending; pass
// sizeof(PellicleEvalBatchArgs).
typedef struct PellicleEvalBatchArgs {
    // Number of elements; 0 is allowed and does nothing.
    size_t count;
    // Directions to the viewer, 3 components.
    PellicleConstView wo;
    // Directions to the light, 3 components.
    PellicleConstView wi;
    // One view per varying parameter, in the order of PellicleBsdfDesc::varying. NULL: every varying
    // parameter has its default (PellicleVaryingInfo); so does one whose data is NULL.
    const PellicleConstView *varying;
    // Number of views in `varying`: PellicleBsdfInfo::varying_count, or 0 with NULL.
    size_t varying_count;
    // Transport and lobes of all elements; NULL: radiance and every lobe.
    const PellicleCall *call;
    // Receives f(wo, wi) |wi.z|, 3 components.
    PellicleView value;
    // Receives the density of wi, 1 component.
    PellicleView pdf;
    // Receives the density of wo for a sample from wi, 1 component.
    PellicleView pdf_reverse;
} PellicleEvalBatchArgs;

// Arguments of pellicle_bsdf_sample_batch(). Zero-initialise them. They grow by appending; pass
// sizeof(PellicleSampleBatchArgs). The outputs are PellicleSample's fields.
typedef struct PellicleSampleBatchArgs {
    // Number of elements; 0 is allowed and does nothing.
    size_t count;
    // Directions to the viewer, 3 components.
    PellicleConstView wo;
    // Uniform random numbers in [0, 1), 3 components.
    PellicleConstView u;
    // As in PellicleEvalBatchArgs.
    const PellicleConstView *varying;
    // As in PellicleEvalBatchArgs.
    size_t varying_count;
    // As in PellicleEvalBatchArgs.
    const PellicleCall *call;
    // Receives the directions to the light, 3 components.
    PellicleView wi;
    // Receives the density of wi, 1 component.
    PellicleView pdf;
    // Receives value / pdf, 3 components.
    PellicleView weight;
    // Receives the ratio of indices, 1 component.
    PellicleView eta;
    // Receives the chosen lobe's flags.
    PellicleUintView flags;
    // Receives the chosen lobe's number.
    PellicleUintView lobe;
    // Receives the probability of choosing that lobe, 1 component.
    PellicleView lobe_probability;
} PellicleSampleBatchArgs;

// Arguments of pellicle_film_reflectance_batch(). Zero-initialise them. They grow by appending; pass
// sizeof(PellicleFilmBatchArgs).
typedef struct PellicleFilmBatchArgs {
    // Number of elements; 0 is allowed and does nothing.
    size_t count;
    // Cosines of incidence in the ambient medium, 1 component.
    PellicleConstView cos_theta;
    // Thicknesses of the layer that varies, nm, 1 component; data may be NULL only if none varies.
    PellicleConstView thickness_nm;
    // Receives the reflectance, 3 components.
    PellicleView reflectance;
    // Standard deviations of the thickness, nm, 1 component, as in pellicle_film_reflectance_spread(); data NULL: 0.
    // One that single calls refuse is refused whichever element it belongs to, and nothing is written.
    PellicleConstView thickness_spread_nm;
} PellicleFilmBatchArgs;

// Arguments of pellicle_film_amplitudes_batch(). Zero-initialise them. They grow by appending; pass
// sizeof(PellicleAmplitudesBatchArgs).
typedef struct PellicleAmplitudesBatchArgs {
    // Number of elements; 0 is allowed and does nothing.
    size_t count;
    // Number of wavelengths of each element; 0 is allowed and does nothing.
    size_t lambda_count;
    // Vacuum wavelengths, nm, `lambda_count` components; element_stride 0 gives all elements the same.
    PellicleConstView lambda_nm;
    // Cosines of incidence, 1 component.
    PellicleConstView cos_theta;
    // Thicknesses of the layer that varies, nm, 1 component; data may be NULL only if none varies.
    PellicleConstView thickness_nm;
    // Receives r_s, 2 `lambda_count` components: real and imaginary part at the first wavelength, then those
    // at the next.
    PellicleView r_s;
    // Receives r_p likewise.
    PellicleView r_p;
    // Receives t_s likewise.
    PellicleView t_s;
    // Receives t_p likewise.
    PellicleView t_p;
    // Where the light comes from: PELLICLE_SIDE_AMBIENT (0) or PELLICLE_SIDE_BASE.
    uint32_t side;
} PellicleAmplitudesBatchArgs;

// Every function of this header, by its name without the prefix. It grows by appending: before using
// a member that was added later, check that it lies within `size`.
struct PellicleApi {
    // Bytes in this table.
    size_t size;
    uint32_t (*abi_version)(void);
    const char *(*version_string)(void);
    const char *(*status_string)(PellicleStatus status);
    const char *(*last_error)(void);
    size_t (*model_count)(void);
    PellicleStatus (*model_info)(size_t model, PellicleModelInfo *info, size_t info_size);
    PellicleStatus (*model_param)(
        size_t model,
        size_t param,
        PellicleModelParam *info,
        size_t info_size);
    size_t (*medium_count)(void);
    PellicleStatus (*medium_info)(size_t medium, PellicleMediumInfo *info, size_t info_size);
    const char *(*name)(uint32_t list, size_t index);
    PellicleStatus (*film_create)(
        const PellicleFilmDesc *desc,
        size_t desc_size,
        PellicleFilm **film);
    void (*film_retain)(const PellicleFilm *film);
    void (*film_release)(const PellicleFilm *film);
    PellicleStatus (*film_info)(const PellicleFilm *film, PellicleFilmInfo *info, size_t info_size);
    PellicleStatus (*film_plan)(const PellicleFilm *film, PellicleFilmPlan *plan, size_t plan_size);
    PellicleStatus (*film_save)(
        const PellicleFilm *film,
        void *block,
        size_t block_size,
        size_t *size);
    PellicleStatus (*film_load)(const void *block, size_t size, PellicleFilm **film);
    PellicleStatus (*film_reflectance)(
        const PellicleFilm *film,
        float cos_theta,
        float thickness_nm,
        float *rgb);
    PellicleStatus (*film_eval)(
        const PellicleFilm *film,
        float cos_theta,
        float thickness_nm,
        uint32_t side,
        float *reflectance,
        float *transmittance);
    PellicleStatus (*film_reflectance_spread)(
        const PellicleFilm *film,
        float cos_theta,
        float thickness_nm,
        float thickness_spread_nm,
        float *rgb);
    PellicleStatus (*film_eval_spread)(
        const PellicleFilm *film,
        float cos_theta,
        float thickness_nm,
        float thickness_spread_nm,
        uint32_t side,
        float *reflectance,
        float *transmittance);
    PellicleStatus (*film_reference)(
        const PellicleFilm *film,
        float cos_theta,
        float thickness_nm,
        float *rgb);
    PellicleStatus (*film_spectrum)(
        const PellicleFilm *film,
        float cos_theta,
        float thickness_nm,
        const float *lambda_nm,
        size_t count,
        float *reflectance);
    PellicleStatus (*film_spectrum_eval)(
        const PellicleFilm *film,
        float cos_theta,
        float thickness_nm,
        uint32_t side,
        const float *lambda_nm,
        size_t count,
        float *reflectance,
        float *transmittance);
    PellicleStatus (*film_amplitudes)(
        const PellicleFilm *film,
        float cos_theta,
        float thickness_nm,
        uint32_t side,
        const float *lambda_nm,
        size_t count,
        PellicleAmplitudes *amplitudes);
    PellicleStatus (*bsdf_create)(
        const PellicleBsdfDesc *desc,
        size_t desc_size,
        PellicleBsdf **bsdf);
    void (*bsdf_retain)(const PellicleBsdf *bsdf);
    void (*bsdf_release)(const PellicleBsdf *bsdf);
    PellicleStatus (*bsdf_info)(const PellicleBsdf *bsdf, PellicleBsdfInfo *info, size_t info_size);
    PellicleStatus (*bsdf_varying)(
        const PellicleBsdf *bsdf,
        size_t varying,
        PellicleVaryingInfo *info,
        size_t info_size);
    PellicleStatus (*bsdf_lobe)(
        const PellicleBsdf *bsdf,
        size_t lobe,
        PellicleLobeInfo *info,
        size_t info_size);
    PellicleStatus (*bsdf_eval)(
        const PellicleBsdf *bsdf,
        const float *wo,
        const float *wi,
        const float *varying,
        const PellicleCall *call,
        float *value,
        float *pdf,
        float *pdf_reverse);
    PellicleStatus (*bsdf_sample)(
        const PellicleBsdf *bsdf,
        const float *wo,
        const float *u,
        const float *varying,
        const PellicleCall *call,
        PellicleSample *sample,
        size_t sample_size);
    PellicleStatus (*bsdf_albedo)(
        const PellicleBsdf *bsdf,
        const float *wo,
        const float *varying,
        const PellicleCall *call,
        float *albedo);
    PellicleStatus (*bsdf_eval_spectral)(
        const PellicleBsdf *bsdf,
        const float *wo,
        const float *wi,
        const float *varying,
        const PellicleCall *call,
        const float *lambda_nm,
        size_t lambda_count,
        float *value,
        float *pdf);
    PellicleStatus (*bsdf_sample_spectral)(
        const PellicleBsdf *bsdf,
        const float *wo,
        const float *u,
        const float *varying,
        const PellicleCall *call,
        const float *lambda_nm,
        size_t lambda_count,
        size_t hero,
        float *weight,
        float *pdf,
        PellicleSpectralSample *sample,
        size_t sample_size);
    PellicleStatus (*bsdf_eval_spectral_batch)(
        const PellicleBsdf *bsdf,
        const PellicleEvalSpectralBatchArgs *args,
        size_t args_size);
    PellicleStatus (*bsdf_sample_spectral_batch)(
        const PellicleBsdf *bsdf,
        const PellicleSampleSpectralBatchArgs *args,
        size_t args_size);
    PellicleStatus (*bsdf_eval_batch)(
        const PellicleBsdf *bsdf,
        const PellicleEvalBatchArgs *args,
        size_t args_size);
    PellicleStatus (*bsdf_sample_batch)(
        const PellicleBsdf *bsdf,
        const PellicleSampleBatchArgs *args,
        size_t args_size);
    PellicleStatus (*film_reflectance_batch)(
        const PellicleFilm *film,
        const PellicleFilmBatchArgs *args,
        size_t args_size);
    PellicleStatus (*film_amplitudes_batch)(
        const PellicleFilm *film,
        const PellicleAmplitudesBatchArgs *args,
        size_t args_size);
};

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Gives PELLICLE_ABI_VERSION of the library that runs; compare it with the header's.
uint32_t pellicle_abi_version(void);

// Gives the version of the library that runs, "major.minor.patch". It lives as long as the library.
const char *pellicle_version_string(void);

// Gives a status in words, "unknown status" for a number that is none. It lives as long as the library.
const char *pellicle_status_string(PellicleStatus status);

// Tells what was wrong in this thread's last failing call: which argument, its value, what is allowed.
// It is never NULL, and empty before the first failure. The text is valid until this thread's next failing
// call or its end; longer messages are cut at 1023 bytes.
const char *pellicle_last_error(void);

// Tells how many models this build offers.
size_t pellicle_model_count(void);

// Describes the model with number `model`, below pellicle_model_count(); else OUT_OF_RANGE.
//
// Preconditions:
// `info` must be NULL (refused) or good for `info_size` bytes.
PellicleStatus pellicle_model_info(size_t model, PellicleModelInfo *info, size_t info_size);

// Describes parameter number `param`, below PellicleModelInfo::param_count, of model number
// `model`; else OUT_OF_RANGE.
//
// Preconditions:
// `info` must be NULL (refused) or good for `info_size` bytes.
PellicleStatus pellicle_model_param(size_t model,
                                    size_t param,
                                    PellicleModelParam *info,
                                    size_t info_size);

// Tells how many media are known by name.
size_t pellicle_medium_count(void);

// Describes the medium with number `medium`, below pellicle_medium_count(); else OUT_OF_RANGE.
//
// Preconditions:
// `info` must be NULL (refused) or good for `info_size` bytes.
PellicleStatus pellicle_medium_info(size_t medium,
                                    PellicleMediumInfo *info,
                                    size_t info_size);

// Gives the name with number `index` of a list, PELLICLE_NAMES_METHOD and so on: NULL beyond the last one,
// and for a list that does not exist. The name lives as long as the library.
const char *pellicle_name(uint32_t list,
                          size_t index);

// Creates a film: validates the description, chooses and compiles the method that evaluates it, and
// stores a handle with one reference in `*film`. Call it when loading, not when shading: it takes 10
// milliseconds to 10 seconds for one layer, and up to two minutes for 64 layers of which one varies.
//
// Fails with UNKNOWN_NAME (medium, white, color_space, method, level), OUT_OF_RANGE (numbers, the number of
// layers), INVALID_ARGUMENT (NULL, a wrong size, a medium missing or given in two ways, two layers that
// vary), UNSUPPORTED (a method that does not take such a film, fields of a later version) or OUT_OF_MEMORY; `*film` is then untouched.
//
// Preconditions:
// `desc` must be good for `desc_size` bytes, its pointers for their counts and sizes, `film` for one pointer.
PellicleStatus pellicle_film_create(const PellicleFilmDesc *desc,
                                    size_t desc_size,
                                    PellicleFilm **film);

// Adds a reference to a film: one more pellicle_film_release() is then due. NULL does nothing.
//
// Preconditions:
// `film` must be NULL or a live handle.
void pellicle_film_retain(const PellicleFilm *film);

// Gives up a reference to a film; the last one frees it. NULL does nothing. A BSDF made with the
// film holds a reference of its own.
//
// Preconditions:
// `film` must be NULL or a handle of which the caller owns a reference.
void pellicle_film_release(const PellicleFilm *film);

// Tells what a film is.
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, `info` good for `info_size` bytes.
PellicleStatus pellicle_film_info(const PellicleFilm *film,
                                  PellicleFilmInfo *info,
                                  size_t info_size);

// Tells how a film is evaluated, and how well.
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, `plan` good for `plan_size` bytes.
PellicleStatus pellicle_film_plan(const PellicleFilm *film,
                                  PellicleFilmPlan *plan,
                                  size_t plan_size);

// Writes a compiled film to a block of memory, from which pellicle_film_load() makes it again without fitting or
// measuring. Call it twice: with `block` NULL it only stores the block's bytes in `*size`, some hundred to some
// million, for a film always the same number; then with that many.
//
// `block_size` below that number: OUT_OF_RANGE. Also OUT_OF_MEMORY. A block holds no pointers and may be written to a
// file as it is.
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, `block` NULL or good for `block_size` bytes, `size` NULL (refused) or
// good for one number.
PellicleStatus pellicle_film_save(const PellicleFilm *film,
                                  void *block,
                                  size_t block_size,
                                  size_t *size);

// Makes a film of a block that pellicle_film_save() has written, and stores a handle with one reference in `*film`. It
// gives the same bits as the film that was saved, in every call. Most films take 25 to 110 microseconds. The block is
// copied. Batches use the widest instructions there are (PellicleFilmDesc::simd_level NULL).
//
// A block belongs to the build of the library that wrote it, since another one may evaluate the same numbers to other
// bits. Refused are, with the reason in pellicle_last_error(): bytes that are no saved film, cut short, too long or
// damaged (INVALID_ARGUMENT); another format and another build (UNSUPPORTED). Also OUT_OF_RANGE for contents that no
// film has behind a checksum that is right, and OUT_OF_MEMORY. `*film` is then untouched.
//
// So a cache on disk needs no checks of its own: read the file, load it, and after any failure create the film and
// write the file anew (docs/films.md has an example). But a block does not tell which film was wanted: name the file by
// all that went into PellicleFilmDesc, tables of media too. No block makes a call read or write outside its memory, or
// fail to return; what colours a forged one gives is not checked.
//
// Preconditions:
// `block` must be NULL (refused) or good for `size` bytes, `film` for one pointer.
PellicleStatus pellicle_film_load(const void *block,
                                  size_t size,
                                  PellicleFilm **film);

// Reflectance of unpolarised light from the ambient's side, RGB, into `rgb` (3 numbers).
//
// `cos_theta`: cosine of incidence in the ambient medium, clamped to [1e-9, 1]. `thickness_nm`: of the
// layer that varies, clamped to its range, infinities too; if none varies, any number. NaN in either
// gives 0.
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, `rgb` NULL (refused) or good for 3 numbers.
PellicleStatus pellicle_film_reflectance(const PellicleFilm *film,
                                         float cos_theta,
                                         float thickness_nm,
                                         float *rgb);

// Reflectance and transmittance of unpolarised light from either side, as fractions of its power,
// RGB. A film created without `transmittance` has neither: UNSUPPORTED.
//
// `side`: PELLICLE_SIDE_AMBIENT or PELLICLE_SIDE_BASE, where the light comes from and `cos_theta` is
// measured; any other: OUT_OF_RANGE. A base that is opaque (PellicleFilmInfo::base_opaque) sends
// no light: everything is 0 from its side. In one that absorbs but is not opaque, light from its side travels as if
// k were 0 there, which is off by the order of k. From the ambient's side `transmittance` is what enters the base. `cos_theta` and `thickness_nm` as in pellicle_film_reflectance(). `reflectance`,
// `transmittance`: 3 numbers each; either may be NULL if not wanted, not both.
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, the outputs NULL or good for 3 numbers.
PellicleStatus pellicle_film_eval(const PellicleFilm *film,
                                  float cos_theta,
                                  float thickness_nm,
                                  uint32_t side,
                                  float *reflectance,
                                  float *transmittance);

// pellicle_film_reflectance(), averaged over a spread of thickness: that of a pixel, or of a real layer.
//
// `thickness_spread_nm`: the standard deviation of a normal distribution around `thickness_nm`, which is cut to the
// range of the layer that varies and renormalised; the mean of the distribution is then not `thickness_nm`. 0: the
// bits of pellicle_film_reflectance(). Negative, NaN or infinite: OUT_OF_RANGE. Above
// PellicleFilmDesc::thickness_spread_max_nm: clamped to it; positive where that is 0 or no layer varies:
// INVALID_ARGUMENT. Colours are averaged before they are clipped. The others as in pellicle_film_reflectance().
// Spectra and amplitudes know no spread: average pellicle_film_spectrum() over thicknesses of your own.
//
// Preconditions:
// As for pellicle_film_reflectance().
PellicleStatus pellicle_film_reflectance_spread(const PellicleFilm *film,
                                                float cos_theta,
                                                float thickness_nm,
                                                float thickness_spread_nm,
                                                float *rgb);

// pellicle_film_eval(), averaged over a spread of thickness as in pellicle_film_reflectance_spread(). The averages of
// a film that does not absorb sum to 1 where its colours do.
//
// Preconditions:
// As for pellicle_film_eval().
PellicleStatus pellicle_film_eval_spread(const PellicleFilm *film,
                                         float cos_theta,
                                         float thickness_nm,
                                         float thickness_spread_nm,
                                         uint32_t side,
                                         float *reflectance,
                                         float *transmittance);

// What pellicle_film_reflectance() approximates: the reflectance by full wave optics, converged and
// never clipped. Slow (25 microseconds and up); it allocates. Call it to check, not to shade.
//
// Preconditions:
// As for pellicle_film_reflectance().
PellicleStatus pellicle_film_reference(const PellicleFilm *film,
                                       float cos_theta,
                                       float thickness_nm,
                                       float *rgb);

// Reflectance of unpolarised light from the ambient's side at single wavelengths, by full wave
// optics, for spectral renderers. Allocates.
//
// `lambda_nm`: `count` vacuum wavelengths, nm; one that is not finite and above 0, or outside the range of a
// medium's data (PellicleFilmInfo::lambda_min_nm) unless PellicleFilmDesc::extrapolate is 1: OUT_OF_RANGE.
// `reflectance`: `count`
// numbers; it may be the array `lambda_nm` itself, and is refused if it overlaps that otherwise.
// `cos_theta` and `thickness_nm` as in pellicle_film_reflectance().
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, the arrays NULL (refused, unless `count` is 0) or
// good for `count` numbers.
PellicleStatus pellicle_film_spectrum(const PellicleFilm *film,
                                      float cos_theta,
                                      float thickness_nm,
                                      const float *lambda_nm,
                                      size_t count,
                                      float *reflectance);

// Reflectance and transmittance of unpolarised light from either side at single wavelengths, by full wave
// optics, for spectral renderers. Needs no PellicleFilmDesc::transmittance, and allocates nothing.
//
// `lambda_nm`: `count` vacuum wavelengths, nm; one that is not finite and above 0 or, without `extrapolate` in the
// film's description, outside the range of a medium's data: OUT_OF_RANGE. `reflectance`, `transmittance`: `count` numbers each,
// not clipped; either may be NULL if not wanted, not both; one that overlaps `lambda_nm` is INVALID_ARGUMENT.
// `cos_theta`, `thickness_nm` and `side` as in pellicle_film_eval().
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, the arrays NULL (`lambda_nm`: refused, unless `count` is 0)
// or good for `count` numbers.
PellicleStatus pellicle_film_spectrum_eval(const PellicleFilm *film,
                                           float cos_theta,
                                           float thickness_nm,
                                           uint32_t side,
                                           const float *lambda_nm,
                                           size_t count,
                                           float *reflectance,
                                           float *transmittance);

// Complex amplitudes r_s, r_p, t_s and t_p from either side at single wavelengths, by full wave optics: for
// renderers that track polarisation, and for ellipsometry. Needs no PellicleFilmDesc::transmittance, and
// allocates nothing.
//
// Waves are exp(i (k x - omega t)), so that an index eta + i k with k > 0 absorbs and a longer path adds to
// the phase. At normal incidence r_p = -r_s. These are the signs of Byrnes (arXiv:1603.02720) and his Python
// package tmm. r compares the fields on the near side of the film's first surface, t the field just behind
// its last surface with the incident one at the first. |r|^2 is the reflectance. With the complex indices n
// and cosines c on the two sides (n sin alike on both, Im(n c) >= 0), the transmittance is
// |t_s|^2 Re(n_far c_far) / (n_near c_near) for s and |t_p|^2 Re(n_far conj(c_far)) / (n_near c_near) for p.
//
// `lambda_nm`: `count` vacuum wavelengths, nm; one that is not finite and above 0 or, without `extrapolate` in the
// film's description, outside the range of a medium's data (PellicleFilmInfo): OUT_OF_RANGE. `amplitudes`: `count`
// structs; INVALID_ARGUMENT if they overlap `lambda_nm`. `cos_theta`, `thickness_nm` and `side` as in
// pellicle_film_eval(): everything is 0 from an opaque base.
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, the arrays NULL (refused, unless `count` is 0) or good for
// `count` elements.
PellicleStatus pellicle_film_amplitudes(const PellicleFilm *film,
                                        float cos_theta,
                                        float thickness_nm,
                                        uint32_t side,
                                        const float *lambda_nm,
                                        size_t count,
                                        PellicleAmplitudes *amplitudes);

// Creates a BSDF: validates the description, compiles it, and stores a handle with one reference in
// `*bsdf`. Call it when loading, not when shading: it takes milliseconds, at
// most a tenth of a second.
//
// Fails with UNKNOWN_NAME (model, parameter, choice, level), OUT_OF_RANGE (numbers, ranges, sums),
// INVALID_ARGUMENT (NULL, a wrong count or size, something given twice, a film that is missing or not used)
// or UNSUPPORTED (a parameter that cannot vary, fields of a later version); `*bsdf` is then untouched.
//
// Preconditions:
// `desc` must be good for `desc_size` bytes, its pointers for their counts, its film NULL or a live
// handle, `bsdf` good for one pointer.
PellicleStatus pellicle_bsdf_create(const PellicleBsdfDesc *desc,
                                    size_t desc_size,
                                    PellicleBsdf **bsdf);

// Adds a reference to a BSDF: one more pellicle_bsdf_release() is then due. NULL does nothing.
//
// Preconditions:
// `bsdf` must be NULL or a live handle.
void pellicle_bsdf_retain(const PellicleBsdf *bsdf);

// Gives up a reference to a BSDF; the last one frees it. NULL does nothing.
//
// Preconditions:
// `bsdf` must be NULL or a handle of which the caller owns a reference.
void pellicle_bsdf_release(const PellicleBsdf *bsdf);

// Tells what a BSDF is.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, `info` good for `info_size` bytes.
PellicleStatus pellicle_bsdf_info(const PellicleBsdf *bsdf,
                                  PellicleBsdfInfo *info,
                                  size_t info_size);

// Describes the varying parameter with number `varying`, in declared order, below
// PellicleBsdfInfo::varying_count; else OUT_OF_RANGE.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, `info` good for `info_size` bytes.
PellicleStatus pellicle_bsdf_varying(const PellicleBsdf *bsdf,
                                     size_t varying,
                                     PellicleVaryingInfo *info,
                                     size_t info_size);

// Describes the lobe with number `lobe`, below PellicleBsdfInfo::lobe_count; else OUT_OF_RANGE.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, `info` good for `info_size` bytes.
PellicleStatus pellicle_bsdf_lobe(const PellicleBsdf *bsdf,
                                  size_t lobe,
                                  PellicleLobeInfo *info,
                                  size_t info_size);

// Evaluates f(wo, wi) |wi.z|, the density with which pellicle_bsdf_sample() finds wi from wo, and the
// density with which it finds wo from wi.
//
// `wo`, `wi`: 3 numbers each. `varying`: PellicleBsdfInfo::varying_floats numbers, the components of the
// varying parameters one after another in declared order; NULL gives each its default (see
// PellicleVaryingInfo). `call`: transport and lobes; NULL means radiance and every lobe. `value`: 3 numbers;
// `pdf` and `pdf_reverse`: one each, per solid angle. Each output may be NULL if it is not wanted, but not
// all of them.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size.
PellicleStatus pellicle_bsdf_eval(const PellicleBsdf *bsdf,
                                  const float *wo,
                                  const float *wi,
                                  const float *varying,
                                  const PellicleCall *call,
                                  float *value,
                                  float *pdf,
                                  float *pdf_reverse);

// Samples a direction to the light. `u`: 3 uniform random numbers in [0, 1); the first chooses the
// lobe. `varying` and `call` as in pellicle_bsdf_eval(). Without a valid sample everything in `sample` is 0.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size,
// `sample` good for `sample_size` bytes.
PellicleStatus pellicle_bsdf_sample(const PellicleBsdf *bsdf,
                                    const float *wo,
                                    const float *u,
                                    const float *varying,
                                    const PellicleCall *call,
                                    PellicleSample *sample,
                                    size_t sample_size);

// Integrates the value over wi, Dirac lobes included: the directional albedo, RGB, into `albedo` (3
// numbers). `varying` and `call` as in pellicle_bsdf_eval(). Call it when preparing, not when shading: it is
// a quadrature of some milliseconds, unless the model has a closed form. As radiance, transmitted light
// carries (eta_o / eta_i)^2: seen from within a dense base the albedo exceeds 1.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size.
PellicleStatus pellicle_bsdf_albedo(const PellicleBsdf *bsdf,
                                    const float *wo,
                                    const float *varying,
                                    const PellicleCall *call,
                                    float *albedo);

// Evaluates f(wo, wi) |wi.z| at `lambda_count` vacuum wavelengths, nm, and for each the density with which
// pellicle_bsdf_sample_spectral() finds wi if that wavelength is the hero.
//
// Films and media are evaluated by wave optics at each wavelength, without clipping; indices given at 645, 525 and
// 445 nm are interpolated. `varying`: as in pellicle_bsdf_eval(), but each colour (an RGB parameter that is no index)
// has `lambda_count` numbers instead of 3, one per wavelength; NULL: every varying parameter has its default, which for
// a colour must be gray. `lambda_nm`: 1 to 16 numbers, else OUT_OF_RANGE; a wavelength that is not finite and above 0
// or, without `extrapolate` in the film's description, outside the range of a medium's data: OUT_OF_RANGE. `value` and
// `pdf`: `lambda_count` numbers each; either may be NULL if it is not wanted, not both. `wo`, `wi` and `call` as in
// pellicle_bsdf_eval().
//
// UNSUPPORTED: a colour with three different numbers that does not vary, or a `thickness_spread_nm` that varies or is
// above 0.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size.
PellicleStatus pellicle_bsdf_eval_spectral(const PellicleBsdf *bsdf,
                                           const float *wo,
                                           const float *wi,
                                           const float *varying,
                                           const PellicleCall *call,
                                           const float *lambda_nm,
                                           size_t lambda_count,
                                           float *value,
                                           float *pdf);

// Samples a direction to the light for wavelength number `hero`, and finds for every wavelength the weight and the
// density that it would have as the hero.
//
// `pdf`: `lambda_count` numbers, the densities; for a DELTA lobe the probabilities of choosing it. `weight`:
// `lambda_count` numbers, value / mean of `pdf`; for a DELTA lobe throughput / mean of `pdf`. Either may be NULL if it
// is not wanted. The weights suit a renderer that draws the hero anew for every call, each wavelength as often as any
// other. One that keeps the hero along a path multiplies the values, weight times mean of `pdf`, and the densities along
// it, and divides by the mean of the products. `sample` as in pellicle_bsdf_sample(); the rest as in
// pellicle_bsdf_eval_spectral().
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `call` good for its size,
// `sample` good for `sample_size` bytes.
PellicleStatus pellicle_bsdf_sample_spectral(const PellicleBsdf *bsdf,
                                             const float *wo,
                                             const float *u,
                                             const float *varying,
                                             const PellicleCall *call,
                                             const float *lambda_nm,
                                             size_t lambda_count,
                                             size_t hero,
                                             float *weight,
                                             float *pdf,
                                             PellicleSpectralSample *sample,
                                             size_t sample_size);

// Calls pellicle_bsdf_eval_spectral() for every element of strided arrays, each with wavelengths of its own or all with
// the same; the results are those of single calls, bit for bit. An output with data NULL is not wanted; at least one
// must be. An output that overlaps an input or another output is undefined behaviour. A wavelength that the single call
// refuses is refused whichever element it belongs to, and nothing is written.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, `args` good for `args_size` bytes, `args->call` good for
// its size, and every address that the views stand for readable or writable.
PellicleStatus pellicle_bsdf_eval_spectral_batch(const PellicleBsdf *bsdf,
                                                 const PellicleEvalSpectralBatchArgs *args,
                                                 size_t args_size);

// Calls pellicle_bsdf_sample_spectral() for every element of strided arrays, as pellicle_bsdf_eval_spectral_batch() does
// for evaluations.
//
// Preconditions:
// As for pellicle_bsdf_eval_spectral_batch().
PellicleStatus pellicle_bsdf_sample_spectral_batch(const PellicleBsdf *bsdf,
                                                   const PellicleSampleSpectralBatchArgs *args,
                                                   size_t args_size);

// Calls pellicle_bsdf_eval() for every element of strided arrays; the results are those of single calls, bit
// for bit. An output with data NULL is not wanted; at least one must be.
//
// An output may be an input's own memory with the same strides. Any other overlap of an output with an
// input or another output is undefined behaviour.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, `args` good for `args_size` bytes, `args->call` good for
// its size, and every address that the views stand for readable or writable.
PellicleStatus pellicle_bsdf_eval_batch(const PellicleBsdf *bsdf,
                                        const PellicleEvalBatchArgs *args,
                                        size_t args_size);

// Calls pellicle_bsdf_sample() for every element of strided arrays; the results are those of single calls,
// bit for bit. An output with data NULL is not wanted; at least one must be. Overlap is as for
// pellicle_bsdf_eval_batch().
//
// Preconditions:
// As for pellicle_bsdf_eval_batch().
PellicleStatus pellicle_bsdf_sample_batch(const PellicleBsdf *bsdf,
                                          const PellicleSampleBatchArgs *args,
                                          size_t args_size);

// Calls pellicle_film_reflectance() for every element of strided arrays; the results are those of single
// calls, bit for bit. Overlap is as for pellicle_bsdf_eval_batch().
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, `args` good for `args_size` bytes, and every
// address that its views stand for readable or writable.
PellicleStatus pellicle_film_reflectance_batch(const PellicleFilm *film,
                                               const PellicleFilmBatchArgs *args,
                                               size_t args_size);

// Calls pellicle_film_amplitudes() for every element of strided arrays, each with wavelengths of its own or all
// with the same; the results are those of single calls, bit for bit. An output with data NULL is not wanted; at
// least one must be. An output that overlaps an input or another output is undefined behaviour.
//
// A wavelength that pellicle_film_amplitudes() refuses is OUT_OF_RANGE, whichever element it belongs to, and
// nothing is written.
//
// Preconditions:
// As for pellicle_film_reflectance_batch().
PellicleStatus pellicle_film_amplitudes_batch(const PellicleFilm *film,
                                              const PellicleAmplitudesBatchArgs *args,
                                              size_t args_size);

// Gives the table of functions: the one symbol to look up with dlsym(). Pass PELLICLE_ABI_VERSION; NULL
// means that the library that runs has another one. The table lives as long as the library.
const PellicleApi *pellicle_get_api(uint32_t abi_version);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* PELLICLE_H */
