/* The header as programs were first compiled against it, for ABI version 1, without its comments: before
 * films, with shorter structs. Frozen: never renewed. */
#ifndef PELLICLE_H
#define PELLICLE_H

#include <stddef.h>
#include <stdint.h>

#define PELLICLE_OK 0

#define PELLICLE_INVALID_ARGUMENT 1

#define PELLICLE_UNKNOWN_NAME 2

#define PELLICLE_OUT_OF_RANGE 3

#define PELLICLE_UNSUPPORTED 4

#define PELLICLE_OUT_OF_MEMORY 5

#define PELLICLE_INTERNAL 6

#define PELLICLE_ABI_VERSION 1

#define PELLICLE_REFLECTION 1

#define PELLICLE_TRANSMISSION 2

#define PELLICLE_DIFFUSE 4

#define PELLICLE_GLOSSY 8

#define PELLICLE_DELTA 16

#define PELLICLE_KIND_NUMBER 0

#define PELLICLE_KIND_DIRECTION 1

#define PELLICLE_KIND_CHOICE 2

typedef struct PellicleBsdf PellicleBsdf;

typedef int32_t PellicleStatus;

typedef struct PellicleModelInfo {

    const char *name;

    const char *summary;

    const char *source;

    uint32_t flags;

    uint32_t param_count;

    uint32_t lobe_count;

    const char *not_reciprocal;

    const char *not_conserving;
} PellicleModelInfo;

typedef struct PellicleModelParam {

    const char *name;

    const char *unit;

    const char *summary;

    uint32_t kind;

    uint32_t components;

    uint32_t can_vary;

    float min;

    float max;

    float default_value[3];

    const char *default_choice;

    uint32_t choice_count;

    const char *choices[8];
} PellicleModelParam;

typedef struct PellicleParam {

    const char *name;

    const float *values;

    size_t count;

    const char *choice;
} PellicleParam;

typedef struct PellicleRange {

    const char *name;

    float min;

    float max;
} PellicleRange;

typedef struct PellicleBsdfDesc {

    const char *model;

    const struct PellicleParam *params;

    size_t param_count;

    const struct PellicleRange *varying;

    size_t varying_count;
} PellicleBsdfDesc;

typedef struct PellicleBsdfInfo {

    const char *model;

    uint32_t flags;

    uint32_t varying_count;

    uint32_t varying_floats;

    uint32_t lobe_count;
} PellicleBsdfInfo;

typedef struct PellicleSample {

    float wi[3];

    float pdf;

    float weight[3];

    float eta;

    uint32_t flags;

    uint32_t lobe;
} PellicleSample;

typedef struct PellicleConstView {

    const float *data;

    ptrdiff_t element_stride;

    ptrdiff_t component_stride;
} PellicleConstView;

typedef struct PellicleView {

    float *data;

    ptrdiff_t element_stride;

    ptrdiff_t component_stride;
} PellicleView;

typedef struct PellicleEvalBatchArgs {

    size_t count;

    struct PellicleConstView wo;

    struct PellicleConstView wi;

    const struct PellicleConstView *varying;

    size_t varying_count;

    struct PellicleView value;

    struct PellicleView pdf;
} PellicleEvalBatchArgs;

typedef struct PellicleUintView {

    uint32_t *data;

    ptrdiff_t element_stride;
} PellicleUintView;

typedef struct PellicleSampleBatchArgs {

    size_t count;

    struct PellicleConstView wo;

    struct PellicleConstView u;

    const struct PellicleConstView *varying;

    size_t varying_count;

    struct PellicleView wi;

    struct PellicleView pdf;

    struct PellicleView weight;

    struct PellicleView eta;

    struct PellicleUintView flags;

    struct PellicleUintView lobe;
} PellicleSampleBatchArgs;

typedef struct PellicleApi {

    size_t size;

    uint32_t (*abi_version)(void);

    const char *(*version_string)(void);

    const char *(*status_string)(PellicleStatus status);

    const char *(*last_error)(void);

    size_t (*model_count)(void);

    PellicleStatus (*model_info)(size_t model, struct PellicleModelInfo *info, size_t info_size);

    PellicleStatus (*model_param)(size_t model,
                                  size_t param,
                                  struct PellicleModelParam *info,
                                  size_t info_size);

    PellicleStatus (*bsdf_create)(const struct PellicleBsdfDesc *desc,
                                  size_t desc_size,
                                  struct PellicleBsdf **bsdf);

    PellicleStatus (*bsdf_retain)(struct PellicleBsdf *bsdf);

    void (*bsdf_release)(struct PellicleBsdf *bsdf);

    PellicleStatus (*bsdf_info)(const struct PellicleBsdf *bsdf,
                                struct PellicleBsdfInfo *info,
                                size_t info_size);

    PellicleStatus (*bsdf_eval)(const struct PellicleBsdf *bsdf,
                                const float *wo,
                                const float *wi,
                                const float *varying,
                                float *value,
                                float *pdf);

    PellicleStatus (*bsdf_sample)(const struct PellicleBsdf *bsdf,
                                  const float *wo,
                                  const float *u,
                                  const float *varying,
                                  struct PellicleSample *sample,
                                  size_t sample_size);

    PellicleStatus (*bsdf_albedo)(const struct PellicleBsdf *bsdf,
                                  const float *wo,
                                  const float *varying,
                                  float *albedo);

    PellicleStatus (*bsdf_eval_batch)(const struct PellicleBsdf *bsdf,
                                      const struct PellicleEvalBatchArgs *args,
                                      size_t args_size);

    PellicleStatus (*bsdf_sample_batch)(const struct PellicleBsdf *bsdf,
                                        const struct PellicleSampleBatchArgs *args,
                                        size_t args_size);
} PellicleApi;

#ifdef __cplusplus
extern "C" {
#endif

uint32_t pellicle_abi_version(void);

const char *pellicle_version_string(void);

const char *pellicle_status_string(PellicleStatus status);

const char *pellicle_last_error(void);

size_t pellicle_model_count(void);

PellicleStatus pellicle_model_info(size_t model, struct PellicleModelInfo *info, size_t info_size);

PellicleStatus pellicle_model_param(size_t model,
                                    size_t param,
                                    struct PellicleModelParam *info,
                                    size_t info_size);

PellicleStatus pellicle_bsdf_create(const struct PellicleBsdfDesc *desc,
                                    size_t desc_size,
                                    struct PellicleBsdf **bsdf);

PellicleStatus pellicle_bsdf_retain(struct PellicleBsdf *bsdf);

void pellicle_bsdf_release(struct PellicleBsdf *bsdf);

PellicleStatus pellicle_bsdf_info(const struct PellicleBsdf *bsdf,
                                  struct PellicleBsdfInfo *info,
                                  size_t info_size);

PellicleStatus pellicle_bsdf_eval(const struct PellicleBsdf *bsdf,
                                  const float *wo,
                                  const float *wi,
                                  const float *varying,
                                  float *value,
                                  float *pdf);

PellicleStatus pellicle_bsdf_sample(const struct PellicleBsdf *bsdf,
                                    const float *wo,
                                    const float *u,
                                    const float *varying,
                                    struct PellicleSample *sample,
                                    size_t sample_size);

PellicleStatus pellicle_bsdf_albedo(const struct PellicleBsdf *bsdf,
                                    const float *wo,
                                    const float *varying,
                                    float *albedo);

PellicleStatus pellicle_bsdf_eval_batch(const struct PellicleBsdf *bsdf,
                                        const struct PellicleEvalBatchArgs *args,
                                        size_t args_size);

PellicleStatus pellicle_bsdf_sample_batch(const struct PellicleBsdf *bsdf,
                                          const struct PellicleSampleBatchArgs *args,
                                          size_t args_size);

const struct PellicleApi *pellicle_get_api(uint32_t abi_version);

#ifdef __cplusplus
}
#endif

#endif
