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
 * With it, z < 0 is the base's side and z = 0 gives 0; what is transmitted is radiance, which carries
 * (eta_o / eta_i)^2. Dirac lobes give value = pdf = 0; only sample() returns them, with weight and
 * pdf = 0.
 *
 * Data never fails. Finite inputs give finite, non-negative outputs (unclipped colours of films may
 * be negative). Directions within 1e-3 of unit length are accepted as they are; any other direction,
 * NaN and infinity give 0 for that element and leave its neighbours alone. A varying parameter's
 * finite value outside its declared range is clamped to it; NaN or infinity there gives 0 for that
 * element. In the calls of a film, cosines are clamped to [1e-9, 1] and thicknesses to the declared
 * range, infinities too, and NaN gives 0. Nothing else is clamped.
 *
 * Pointers and counts can fail. Every function checks every pointer for NULL. On failure a status
 * other than PELLICLE_OK is returned, outputs are untouched, and pellicle_last_error() says which
 * argument was wrong, its value, and what is allowed.
 *
 * Threads. Every function may be called from any thread. Handles are immutable and
 * reference-counted: share them freely. Nothing starts threads, locks, logs, calls back or changes
 * the floating-point state; results are right under flush-to-zero and denormals-are-zero.
 * Floating-point exception flags may be raised: do not unmask traps. Only these allocate: create();
 * pellicle_film_reference() and pellicle_film_spectrum(); what evaluates a film whose plan's method
 * is "reference"; and a failing call, for its message.
 *
 * Batches. Elements are evaluated side by side with the widest of SSE2, AVX2 and AVX-512, or NEON, that
 * the processor has, to the same bits as single calls. The environment variable PELLICLE_SIMD (sse2,
 * avx2), read once by the first create(), may name a narrower one, for tests; other values do nothing.
 * Components whose elements lie side by side are the fastest, then whole packed elements.
 *
 * Growth. Structs that are passed together with their own size grow by appending, and zero means
 * default: zero-initialise them and pass sizeof. A shorter struct of an older caller is accepted; a
 * longer one is accepted if what this build does not know is zero, else UNSUPPORTED. Outputs are
 * written up to the smaller size. A size that no version can have (0, above 65,536, or no multiple of
 * the struct's alignment) is INVALID_ARGUMENT.
 */


#ifndef PELLICLE_H
#define PELLICLE_H

#include <stddef.h>
#include <stdint.h>

// Success.
#define PELLICLE_OK 0

// A NULL pointer, a wrong count, overlapping or contradictory arguments.
#define PELLICLE_INVALID_ARGUMENT 1

// A model, parameter, choice or medium of that name does not exist; the message lists those that do.
#define PELLICLE_UNKNOWN_NAME 2

// A number is outside its range, or NaN or infinite; the message gives the value and the range.
#define PELLICLE_OUT_OF_RANGE 3

// This build does not offer what was asked for (for instance a field of a later version).
#define PELLICLE_UNSUPPORTED 4

// An allocation failed.
#define PELLICLE_OUT_OF_MEMORY 5

// A defect of pellicle itself: a panic was caught at the boundary. Handles stay usable.
#define PELLICLE_INTERNAL 6

// The binary interface described by this header. It changes only when programs must be rebuilt.
#define PELLICLE_ABI_VERSION 1

// Flag of a model, a BSDF or a sampled lobe: light leaves on the side of the viewer.
#define PELLICLE_REFLECTION 1

// Light leaves on the other side. Without this flag the model is one-sided: 0 at and below the horizon.
#define PELLICLE_TRANSMISSION 2

// A broad lobe without a preferred direction.
#define PELLICLE_DIFFUSE 4

// A lobe around a preferred direction.
#define PELLICLE_GLOSSY 8

// A perfectly specular lobe: eval() returns 0 for it, only sample() finds it.
#define PELLICLE_DELTA 16

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

// A compiled BSDF: opaque, immutable, reference-counted, usable from every thread at once.
typedef struct PellicleBsdf PellicleBsdf;

// A compiled film: opaque, immutable, reference-counted, usable from every thread at once.
typedef struct PellicleFilm PellicleFilm;

// What a call returned: PELLICLE_OK (0) or one of the failures below. After a failure every output
// is as it was before the call, and pellicle_last_error() says in words what was wrong.
typedef int32_t PellicleStatus;

// A model that this build offers. Its strings live as long as the library. Grows by appending;
// pass sizeof(PellicleModelInfo).
typedef struct PellicleModelInfo {
    // The name to create it by.
    const char *name;
    // One sentence.
    const char *summary;
    // Where the model comes from.
    const char *source;
    // PELLICLE_REFLECTION and so on, of all lobes together.
    uint32_t flags;
    // How many parameters it has.
    uint32_t param_count;
    // How many lobes sample() chooses from.
    uint32_t lobe_count;
    // When and why value(wo, wi) wo.z differs from value(wi, wo) wi.z; NULL: never.
    const char *not_reciprocal;
    // When and why the albedo exceeds 1; NULL: never.
    const char *not_conserving;
    // 1: with every parameter at its default it needs PellicleBsdfDesc::film; 0: it takes none then.
    uint32_t needs_film;
} PellicleModelInfo;

// A parameter of a model. Its strings live as long as the library. Grows by appending; pass
// sizeof(PellicleModelParam).
typedef struct PellicleModelParam {
    // The parameter's name.
    const char *name;
    // "nm", or "" for a pure number.
    const char *unit;
    // One sentence.
    const char *summary;
    // PELLICLE_KIND_NUMBER, _DIRECTION or _CHOICE.
    uint32_t kind;
    // 1 or 3 numbers; 0 for a CHOICE.
    uint32_t components;
    // 1 if it may be listed in PellicleBsdfDesc::varying.
    uint32_t can_vary;
    // Least value of each component.
    float min;
    // Greatest value of each component.
    float max;
    // Default of each component; unused ones are 0.
    float default_value[3];
    // For a CHOICE: the default's name; NULL otherwise.
    const char *default_choice;
    // For a CHOICE: how many names there are; 0 otherwise.
    uint32_t choice_count;
    // For a CHOICE: the names, then NULL.
    const char *choices[16];
} PellicleModelParam;

// A medium, given in one of three ways: by `name`, by `eta` and `k`, or by a table of measurements.
// All zero: vacuum as a film's ambient, refused elsewhere. Frozen for this ABI version.
typedef struct PellicleMedium {
    // "Au", "SiO2", "water", ...; upper and lower case are alike. The message for an unknown name
    // lists the known ones.
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
    // How many numbers each part of the table has.
    size_t table_count;
} PellicleMedium;

// A layer of a film. Frozen for this ABI version.
typedef struct PellicleLayer {
    // What it consists of.
    struct PellicleMedium medium;
    // Least thickness, nm, within [0, 1e8].
    float thickness_min_nm;
    // Greatest thickness, nm, within [0, 1e8]. Equal to the least: fixed. At most one layer of a film
    // may vary; its thickness comes with every call.
    float thickness_max_nm;
} PellicleLayer;

// What film to create: layers between an ambient medium and a base. Zero-initialise it, then set
// what you need: zero means default. Grows by appending; pass sizeof(PellicleFilmDesc).
typedef struct PellicleFilmDesc {
    // Where the light comes from; all zero: vacuum. It must have k = 0 and eta >= 1.
    struct PellicleMedium ambient;
    // The layers, the ambient's neighbour first; NULL if `layer_count` is 0. Copied.
    const struct PellicleLayer *layers;
    // How many layers there are, at most 64; 0: the bare base.
    size_t layer_count;
    // What the layers lie on; needed.
    struct PellicleMedium base;
    // The greatest error allowed of a channel of the clipped colours, within [1e-5, 1];
    // 0: the default, 2e-3.
    float tolerance;
    // The white in which a perfect mirror is (1, 1, 1): "E" or "D65"; NULL: "E".
    const char *white;
    // "rec709", "rec2020", "acescg" or "xyz", linear; NULL: "rec709".
    const char *color_space;
    // The name of the method of evaluation; NULL: the cheapest that holds the tolerance. The message
    // for an unknown name lists the known ones.
    const char *method;
    // 1: leave colours outside [0, 1] as they are (saturated films have such, negative ones too);
    // 0: clip them.
    uint32_t unclipped;
    // 1: also keep the transmittance, and the reflectance from the base's side, for
    // pellicle_film_eval(); 0: do not.
    uint32_t transmittance;
} PellicleFilmDesc;

// How a film is evaluated, and how well. Grows by appending; pass sizeof(PellicleFilmPlan).
typedef struct PellicleFilmPlan {
    // The method's name; lives as long as the film.
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
    // Why this method, in a sentence; lives as long as the film.
    const char *reason;
} PellicleFilmPlan;

// One parameter of a model, by name: either numbers (`values`, `count`) or a `choice`, never both.
// Frozen for this ABI version.
typedef struct PellicleParam {
    // The parameter's name, NUL-terminated; pellicle_model_param() lists them.
    const char *name;
    // `count` numbers. One number for a parameter with three components stands for all three
    // (directions excepted).
    const float *values;
    // How many numbers `values` holds.
    size_t count;
    // The chosen name for a parameter of kind CHOICE; NULL for the others.
    const char *choice;
} PellicleParam;

// A parameter that the caller supplies with every call, from a texture for example.
// Frozen for this ABI version.
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

// What to create. Zero-initialise it, then set what you need: zero means default.
// Grows by appending; pass sizeof(PellicleBsdfDesc).
typedef struct PellicleBsdfDesc {
    // The model's name: "lambert", "phong", "layered", ...; pellicle_model_info() lists them.
    const char *model;
    // Parameters that differ from their defaults; NULL if `param_count` is 0. Copied.
    const struct PellicleParam *params;
    // How many entries `params` has.
    size_t param_count;
    // Parameters given per call, in the order in which their components are passed; NULL if
    // `varying_count` is 0. Copied.
    const struct PellicleRange *varying;
    // How many entries `varying` has.
    size_t varying_count;
    // The film, for models that take one; retained, so release yours when you like. Given where
    // unused or missing where needed: INVALID_ARGUMENT. If a layer of it varies, the parameter
    // thickness_nm is needed, fixed or varying within the layer's range; if none does, it is refused.
    const struct PellicleFilm *film;
} PellicleBsdfDesc;

// What a BSDF is. Grows by appending; pass sizeof(PellicleBsdfInfo).
typedef struct PellicleBsdfInfo {
    // The model's name; lives as long as the library.
    const char *model;
    // PELLICLE_REFLECTION and so on, of all lobes together.
    uint32_t flags;
    // How many parameters vary per call.
    uint32_t varying_count;
    // How many numbers they have together: the length of `varying` in the single calls.
    uint32_t varying_floats;
    // How many lobes sample() chooses from.
    uint32_t lobe_count;
    // What the BSDF was specialised to, in words: terms that its values leave out, formulas that are shorter
    // for them, and the instructions that batches run with. Lives as long as the BSDF.
    const char *plan;
} PellicleBsdfInfo;

// A sampled direction. Grows by appending; pass sizeof(PellicleSample).
// No valid sample, or a random number outside [0, 1): all zero, with status PELLICLE_OK.
typedef struct PellicleSample {
    // To the light, unit, in the shading frame.
    float wi[3];
    // Density of wi per solid angle, of all lobes together; 0 for a DELTA lobe.
    float pdf;
    // value / pdf, RGB; for a DELTA lobe the throughput over the probability of choosing it.
    float weight[3];
    // Refractive index on wi's side over that on wo's side; 1 for a reflection.
    float eta;
    // Flags of the chosen lobe: PELLICLE_REFLECTION | PELLICLE_GLOSSY and so on.
    uint32_t flags;
    // Number of the chosen lobe, below PellicleBsdfInfo::lobe_count.
    uint32_t lobe;
} PellicleSample;

// A strided array to read: component c of element i is at
// `(const char*)data + i * element_stride + c * component_stride`. Strides are in bytes and may be
// negative; element_stride 0 broadcasts one element. Any alignment. Frozen for this ABI version.
typedef struct PellicleConstView {
    // Component 0 of element 0.
    const float *data;
    // Bytes from one element to the next.
    ptrdiff_t element_stride;
    // Bytes from one component to the next.
    ptrdiff_t component_stride;
} PellicleConstView;

// A strided array to write, addressed like PellicleConstView; data NULL = not wanted. Its elements
// and components must not overlap one another. Frozen for this ABI version.
typedef struct PellicleView {
    // Component 0 of element 0.
    float *data;
    // Bytes from one element to the next.
    ptrdiff_t element_stride;
    // Bytes from one component to the next.
    ptrdiff_t component_stride;
} PellicleView;

// Arguments of pellicle_bsdf_eval_batch(). Zero-initialise. Grows by appending; pass
// sizeof(PellicleEvalBatchArgs).
typedef struct PellicleEvalBatchArgs {
    // How many elements; 0 is allowed and does nothing.
    size_t count;
    // Directions to the viewer, 3 components.
    struct PellicleConstView wo;
    // Directions to the light, 3 components.
    struct PellicleConstView wi;
    // One view per varying parameter, in the order of PellicleBsdfDesc::varying. NULL: every
    // varying parameter keeps its value from `params`; so does one whose data is NULL.
    const struct PellicleConstView *varying;
    // How many views `varying` has: PellicleBsdfInfo::varying_count, or 0 with NULL.
    size_t varying_count;
    // Receives f(wo, wi) |wi.z|, 3 components.
    struct PellicleView value;
    // Receives the density, 1 component.
    struct PellicleView pdf;
} PellicleEvalBatchArgs;

// A strided array of whole numbers to write, one per element; data NULL = not wanted.
// Frozen for this ABI version.
typedef struct PellicleUintView {
    // Element 0.
    uint32_t *data;
    // Bytes from one element to the next.
    ptrdiff_t element_stride;
} PellicleUintView;

// Arguments of pellicle_bsdf_sample_batch(). Zero-initialise. Grows by appending; pass
// sizeof(PellicleSampleBatchArgs). The outputs are PellicleSample's fields.
typedef struct PellicleSampleBatchArgs {
    // How many elements; 0 is allowed and does nothing.
    size_t count;
    // Directions to the viewer, 3 components.
    struct PellicleConstView wo;
    // Uniform random numbers in [0, 1), 3 components.
    struct PellicleConstView u;
    // As in PellicleEvalBatchArgs.
    const struct PellicleConstView *varying;
    // As in PellicleEvalBatchArgs.
    size_t varying_count;
    // Receives the directions to the light, 3 components.
    struct PellicleView wi;
    // Receives the density, 1 component.
    struct PellicleView pdf;
    // Receives value / pdf, 3 components.
    struct PellicleView weight;
    // Receives the ratio of indices, 1 component.
    struct PellicleView eta;
    // Receives the chosen lobe's flags.
    struct PellicleUintView flags;
    // Receives the chosen lobe's number.
    struct PellicleUintView lobe;
} PellicleSampleBatchArgs;

// Arguments of pellicle_film_reflectance_batch(). Zero-initialise. Grows by appending; pass
// sizeof(PellicleFilmBatchArgs).
typedef struct PellicleFilmBatchArgs {
    // How many elements; 0 is allowed and does nothing.
    size_t count;
    // Cosines of incidence in the ambient medium, 1 component.
    struct PellicleConstView cos_theta;
    // Thicknesses of the layer that varies, nm, 1 component; data NULL only if none does.
    struct PellicleConstView thickness_nm;
    // Receives the reflectance, 3 components.
    struct PellicleView reflectance;
} PellicleFilmBatchArgs;

// Every function of this header, by its name without the prefix. Grows by appending: before using
// a member that was added later, check that it lies within `size`.
typedef struct PellicleApi {
    // Bytes in this table.
    size_t size;
    // pellicle_abi_version()
    uint32_t (*abi_version)(void);
    // pellicle_version_string()
    const char *(*version_string)(void);
    // pellicle_status_string()
    const char *(*status_string)(PellicleStatus status);
    // pellicle_last_error()
    const char *(*last_error)(void);
    // pellicle_model_count()
    size_t (*model_count)(void);
    // pellicle_model_info()
    PellicleStatus (*model_info)(size_t model, struct PellicleModelInfo *info, size_t info_size);
    // pellicle_model_param()
    PellicleStatus (*model_param)(size_t model,
                                  size_t param,
                                  struct PellicleModelParam *info,
                                  size_t info_size);
    // pellicle_bsdf_create()
    PellicleStatus (*bsdf_create)(const struct PellicleBsdfDesc *desc,
                                  size_t desc_size,
                                  struct PellicleBsdf **bsdf);
    // pellicle_bsdf_retain()
    PellicleStatus (*bsdf_retain)(struct PellicleBsdf *bsdf);
    // pellicle_bsdf_release()
    void (*bsdf_release)(struct PellicleBsdf *bsdf);
    // pellicle_bsdf_info()
    PellicleStatus (*bsdf_info)(const struct PellicleBsdf *bsdf,
                                struct PellicleBsdfInfo *info,
                                size_t info_size);
    // pellicle_bsdf_eval()
    PellicleStatus (*bsdf_eval)(const struct PellicleBsdf *bsdf,
                                const float *wo,
                                const float *wi,
                                const float *varying,
                                float *value,
                                float *pdf);
    // pellicle_bsdf_sample()
    PellicleStatus (*bsdf_sample)(const struct PellicleBsdf *bsdf,
                                  const float *wo,
                                  const float *u,
                                  const float *varying,
                                  struct PellicleSample *sample,
                                  size_t sample_size);
    // pellicle_bsdf_albedo()
    PellicleStatus (*bsdf_albedo)(const struct PellicleBsdf *bsdf,
                                  const float *wo,
                                  const float *varying,
                                  float *albedo);
    // pellicle_bsdf_eval_batch()
    PellicleStatus (*bsdf_eval_batch)(const struct PellicleBsdf *bsdf,
                                      const struct PellicleEvalBatchArgs *args,
                                      size_t args_size);
    // pellicle_bsdf_sample_batch()
    PellicleStatus (*bsdf_sample_batch)(const struct PellicleBsdf *bsdf,
                                        const struct PellicleSampleBatchArgs *args,
                                        size_t args_size);
    // pellicle_film_create()
    PellicleStatus (*film_create)(const struct PellicleFilmDesc *desc,
                                  size_t desc_size,
                                  struct PellicleFilm **film);
    // pellicle_film_retain()
    PellicleStatus (*film_retain)(struct PellicleFilm *film);
    // pellicle_film_release()
    void (*film_release)(struct PellicleFilm *film);
    // pellicle_film_plan()
    PellicleStatus (*film_plan)(const struct PellicleFilm *film,
                                struct PellicleFilmPlan *plan,
                                size_t plan_size);
    // pellicle_film_reflectance()
    PellicleStatus (*film_reflectance)(const struct PellicleFilm *film,
                                       float cos_theta,
                                       float thickness_nm,
                                       float *rgb);
    // pellicle_film_eval()
    PellicleStatus (*film_eval)(const struct PellicleFilm *film,
                                float cos_theta,
                                float thickness_nm,
                                uint32_t side,
                                float *reflectance,
                                float *transmittance);
    // pellicle_film_reflectance_batch()
    PellicleStatus (*film_reflectance_batch)(const struct PellicleFilm *film,
                                             const struct PellicleFilmBatchArgs *args,
                                             size_t args_size);
    // pellicle_film_reference()
    PellicleStatus (*film_reference)(const struct PellicleFilm *film,
                                     float cos_theta,
                                     float thickness_nm,
                                     float *rgb);
    // pellicle_film_spectrum()
    PellicleStatus (*film_spectrum)(const struct PellicleFilm *film,
                                    float cos_theta,
                                    float thickness_nm,
                                    const float *lambda_nm,
                                    size_t count,
                                    float *reflectance);
} PellicleApi;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// PELLICLE_ABI_VERSION of the library that runs; compare it with the header's.
uint32_t pellicle_abi_version(void);

// Version of the library that runs, "major.minor.patch"; lives as long as the library.
const char *pellicle_version_string(void);

// A status in words, "unknown status" for a number that is none; lives as long as the library.
const char *pellicle_status_string(PellicleStatus status);

// What was wrong in this thread's last failing call: which argument, its value, what is allowed.
// Never NULL; empty before the first failure. The text is valid until this thread's next failing
// call or its end; longer messages are cut at 1023 bytes.
const char *pellicle_last_error(void);

// How many models this build offers.
size_t pellicle_model_count(void);

// Describes the model with number `model`, below pellicle_model_count(); else OUT_OF_RANGE.
//
// Preconditions:
// `info` must be NULL (refused) or good for `info_size` bytes.
PellicleStatus pellicle_model_info(size_t model, struct PellicleModelInfo *info, size_t info_size);

// Describes parameter number `param`, below PellicleModelInfo::param_count, of model number
// `model`; else OUT_OF_RANGE.
//
// Preconditions:
// `info` must be NULL (refused) or good for `info_size` bytes.
PellicleStatus pellicle_model_param(size_t model,
                                    size_t param,
                                    struct PellicleModelParam *info,
                                    size_t info_size);

// Creates a film: validates the description, chooses and compiles the method that evaluates it, and
// stores a handle with one reference in `*film`. Meant for loading, not for shading.
//
// Fails with UNKNOWN_NAME (medium, white, color_space, method), OUT_OF_RANGE (numbers, the number of
// layers), INVALID_ARGUMENT (NULL, a medium missing or given in two ways, two layers that vary),
// UNSUPPORTED (a method that does not take such a film, fields of a later version) or OUT_OF_MEMORY;
// `*film` is then untouched.
//
// Preconditions:
// `desc` must be good for `desc_size` bytes, its pointers for their counts, `film` for one pointer.
PellicleStatus pellicle_film_create(const struct PellicleFilmDesc *desc,
                                    size_t desc_size,
                                    struct PellicleFilm **film);

// Adds a reference to a film: one more pellicle_film_release() is then due.
//
// Preconditions:
// `film` must be NULL (refused) or a handle that has not been released.
PellicleStatus pellicle_film_retain(struct PellicleFilm *film);

// Gives up a reference to a film; the last one frees it. NULL does nothing. A BSDF made with the
// film holds a reference of its own.
//
// Preconditions:
// `film` must be NULL or a handle of which a reference is owned.
void pellicle_film_release(struct PellicleFilm *film);

// Tells how a film is evaluated, and how well.
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, `plan` good for `plan_size` bytes.
PellicleStatus pellicle_film_plan(const struct PellicleFilm *film,
                                  struct PellicleFilmPlan *plan,
                                  size_t plan_size);

// Reflectance of unpolarised light from the ambient's side, RGB, into `rgb` (3 numbers).
//
// `cos_theta`: cosine of incidence in the ambient medium, clamped to [1e-9, 1]. `thickness_nm`: of the
// layer that varies, clamped to its range, infinities too; if none varies, any number. NaN in either
// gives 0.
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, `rgb` NULL (refused) or good for 3 numbers.
PellicleStatus pellicle_film_reflectance(const struct PellicleFilm *film,
                                         float cos_theta,
                                         float thickness_nm,
                                         float *rgb);

// Reflectance and transmittance of unpolarised light from either side, as fractions of its power,
// RGB. A film created without `transmittance` has neither: UNSUPPORTED.
//
// `side`: PELLICLE_SIDE_AMBIENT or PELLICLE_SIDE_BASE, where the light comes from and `cos_theta` is
// measured; any other: OUT_OF_RANGE. A base that absorbs sends no light: everything is 0 from its
// side. `cos_theta` and `thickness_nm` as in pellicle_film_reflectance(). `reflectance`,
// `transmittance`: 3 numbers each; either may be NULL if not wanted, not both.
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, the outputs NULL or good for 3 numbers.
PellicleStatus pellicle_film_eval(const struct PellicleFilm *film,
                                  float cos_theta,
                                  float thickness_nm,
                                  uint32_t side,
                                  float *reflectance,
                                  float *transmittance);

// What pellicle_film_reflectance() approximates: the reflectance by full wave optics, converged and
// never clipped. Slow (25 microseconds and up); it allocates. Call it to check, not to shade.
//
// Preconditions:
// As for pellicle_film_reflectance().
PellicleStatus pellicle_film_reference(const struct PellicleFilm *film,
                                       float cos_theta,
                                       float thickness_nm,
                                       float *rgb);

// Reflectance of unpolarised light from the ambient's side at single wavelengths, by full wave
// optics, for spectral renderers. Allocates.
//
// `lambda_nm`: `count` vacuum wavelengths, nm; one that is not finite and above 0: OUT_OF_RANGE.
// Named media are constant outside 380-780 nm. `reflectance`: `count` numbers; may be `lambda_nm`'s
// own memory, not otherwise overlap it. `cos_theta` and `thickness_nm` as in
// pellicle_film_reflectance().
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, the arrays NULL (refused, unless `count` is 0) or
// good for `count` numbers.
PellicleStatus pellicle_film_spectrum(const struct PellicleFilm *film,
                                      float cos_theta,
                                      float thickness_nm,
                                      const float *lambda_nm,
                                      size_t count,
                                      float *reflectance);

// Creates a BSDF: validates the description, compiles it, and stores a handle with one reference in
// `*bsdf`.
//
// Fails with UNKNOWN_NAME (model, parameter, choice), OUT_OF_RANGE (numbers, ranges, sums),
// INVALID_ARGUMENT (NULL, wrong count, something given twice, a film too many or too few) or
// UNSUPPORTED (a parameter that cannot vary, fields of a later version); `*bsdf` is then untouched.
//
// Preconditions:
// `desc` must be good for `desc_size` bytes, its pointers for their counts, its film NULL or a live
// handle, `bsdf` good for one pointer.
PellicleStatus pellicle_bsdf_create(const struct PellicleBsdfDesc *desc,
                                    size_t desc_size,
                                    struct PellicleBsdf **bsdf);

// Adds a reference to a BSDF: one more pellicle_bsdf_release() is then due.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a handle that has not been released.
PellicleStatus pellicle_bsdf_retain(struct PellicleBsdf *bsdf);

// Gives up a reference to a BSDF; the last one frees it. NULL does nothing.
//
// Preconditions:
// `bsdf` must be NULL or a handle of which a reference is owned.
void pellicle_bsdf_release(struct PellicleBsdf *bsdf);

// Tells what a BSDF is.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, `info` good for `info_size` bytes.
PellicleStatus pellicle_bsdf_info(const struct PellicleBsdf *bsdf,
                                  struct PellicleBsdfInfo *info,
                                  size_t info_size);

// Evaluates f(wo, wi) |wi.z| and the density with which pellicle_bsdf_sample() finds wi.
//
// `wo`, `wi`: 3 numbers each. `varying`: PellicleBsdfInfo::varying_floats numbers, the components
// of the varying parameters one after another in declared order; NULL takes the values from the
// description. `value`: 3 numbers; `pdf`: one; either may be NULL if not wanted, not both.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated.
PellicleStatus pellicle_bsdf_eval(const struct PellicleBsdf *bsdf,
                                  const float *wo,
                                  const float *wi,
                                  const float *varying,
                                  float *value,
                                  float *pdf);

// Samples a direction to the light. `u`: 3 uniform random numbers in [0, 1); the first chooses the
// lobe. `varying` as in pellicle_bsdf_eval(). Without a valid sample everything in `sample` is 0.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated, `sample` good for
// `sample_size` bytes.
PellicleStatus pellicle_bsdf_sample(const struct PellicleBsdf *bsdf,
                                    const float *wo,
                                    const float *u,
                                    const float *varying,
                                    struct PellicleSample *sample,
                                    size_t sample_size);

// Directional albedo: the integral of the value over wi, Dirac lobes included, RGB, into `albedo` (3
// numbers). `varying` as in pellicle_bsdf_eval(). By quadrature, which takes some milliseconds, unless the model has
// a closed form; call it when preparing, not when shading. Transmitted light counts as radiance: seen
// from within a dense base the albedo exceeds 1.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, the arrays as long as stated.
PellicleStatus pellicle_bsdf_albedo(const struct PellicleBsdf *bsdf,
                                    const float *wo,
                                    const float *varying,
                                    float *albedo);

// pellicle_bsdf_eval() for every element of strided arrays, equal to it bit for bit. `value` or
// `pdf` may have data NULL if not wanted, not both. An output may be an input's own memory with
// the same strides, otherwise outputs must not overlap inputs or each other.
//
// Preconditions:
// `bsdf` must be NULL (refused) or a live handle, `args` good for `args_size` bytes, and every
// address that its views stand for readable or writable.
PellicleStatus pellicle_bsdf_eval_batch(const struct PellicleBsdf *bsdf,
                                        const struct PellicleEvalBatchArgs *args,
                                        size_t args_size);

// pellicle_bsdf_sample() for every element of strided arrays, equal to it bit for bit. Outputs with
// data NULL are not wanted; at least one must be. Overlap as in pellicle_bsdf_eval_batch().
//
// Preconditions:
// As for pellicle_bsdf_eval_batch().
PellicleStatus pellicle_bsdf_sample_batch(const struct PellicleBsdf *bsdf,
                                          const struct PellicleSampleBatchArgs *args,
                                          size_t args_size);

// pellicle_film_reflectance() for every element of strided arrays, equal to it bit for bit. Overlap
// as in pellicle_bsdf_eval_batch().
//
// Preconditions:
// `film` must be NULL (refused) or a live handle, `args` good for `args_size` bytes, and every
// address that its views stand for readable or writable.
PellicleStatus pellicle_film_reflectance_batch(const struct PellicleFilm *film,
                                               const struct PellicleFilmBatchArgs *args,
                                               size_t args_size);

// The table of functions, for dlsym(): the one symbol to look up. Pass PELLICLE_ABI_VERSION; NULL
// if the library that runs has another one. The table lives as long as the library.
const struct PellicleApi *pellicle_get_api(uint32_t abi_version);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* PELLICLE_H */
