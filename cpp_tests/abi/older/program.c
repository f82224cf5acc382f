/* A program compiled against an older header runs with today's library: its structs are shorter, its table
 * of functions ends earlier, and what follows its structs in memory stays as it was. */
#include <pellicle.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#ifdef PELLICLE_SIDE_AMBIENT
#error "this is not the older header"
#endif

static int failures = 0;

#define CHECK(condition)                                                                                     \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            fprintf(stderr, "%s:%d: %s; last error: %s\n", __FILE__, __LINE__, #condition,                   \
                    pellicle_last_error());                                                                  \
            ++failures;                                                                                      \
        }                                                                                                    \
    } while (0)

enum { GUARD = 64, PATTERN = 0x5A };

/* Whether the bytes after a struct are as they were. */
static int is_untouched(const unsigned char *guard) {
    for (int i = 0; i < GUARD; ++i)
        if (guard[i] != PATTERN) return 0;
    return 1;
}

/* An older struct, and memory of the program's own behind it. */
#define GUARDED(type)                                                                                        \
    struct {                                                                                                 \
        type own;                                                                                            \
        unsigned char guard[GUARD];                                                                          \
    }

static void introspect(const PellicleApi *api) {
    const size_t count = api->model_count();
    CHECK(count >= 3);
    for (size_t model = 0; model < count; ++model) {
        GUARDED(PellicleModelInfo) info;
        memset(&info, PATTERN, sizeof info);
        CHECK(api->model_info(model, &info.own, sizeof info.own) == PELLICLE_OK);
        CHECK(is_untouched(info.guard));
        CHECK(strlen(info.own.name) > 0 && strlen(info.own.summary) > 0);
        for (size_t param = 0; param < info.own.param_count; ++param) {
            GUARDED(PellicleModelParam) described;
            memset(&described, PATTERN, sizeof described);
            CHECK(api->model_param(model, param, &described.own, sizeof described.own) == PELLICLE_OK);
            CHECK(is_untouched(described.guard));
            CHECK(strlen(described.own.name) > 0);
        }
    }
    GUARDED(PellicleModelInfo) info;
    CHECK(api->model_info(count, &info.own, sizeof info.own) == PELLICLE_OUT_OF_RANGE);
}

static const float up[3] = {0, 0, 1}, slanted[3] = {0, 0.6f, 0.8f};

static PellicleBsdf *create(const PellicleApi *api) {
    const float reflectance = 0.25f;
    const PellicleParam param = {"reflectance", &reflectance, 1, NULL};
    const PellicleRange range = {"reflectance", 0, 1};
    PellicleBsdf *bsdf = NULL;
    /* What lies behind the description is no field of it. */
    GUARDED(PellicleBsdfDesc) desc;
    memset(&desc, PATTERN, sizeof desc);
    memset(&desc.own, 0, sizeof desc.own);
    desc.own.model = "lambert";
    desc.own.params = &param;
    desc.own.param_count = 1;
    desc.own.varying = &range;
    desc.own.varying_count = 1;
    CHECK(api->bsdf_create(&desc.own, sizeof desc.own, &bsdf) == PELLICLE_OK);
    return bsdf;
}

static void call(const PellicleApi *api, const PellicleBsdf *bsdf) {
    GUARDED(PellicleBsdfInfo) info;
    memset(&info, PATTERN, sizeof info);
    CHECK(api->bsdf_info(bsdf, &info.own, sizeof info.own) == PELLICLE_OK);
    CHECK(is_untouched(info.guard));
    CHECK(strcmp(info.own.model, "lambert") == 0 && info.own.varying_floats == 3);

    const float expected = 0.25f * 0.8f / 3.14159265f;
    float value[3], pdf, albedo[3];
    CHECK(api->bsdf_eval(bsdf, up, slanted, NULL, value, &pdf) == PELLICLE_OK);
    CHECK(fabsf(value[0] - expected) < 1e-6f && pdf > 0);
    CHECK(api->bsdf_albedo(bsdf, up, NULL, albedo) == PELLICLE_OK);
    CHECK(fabsf(albedo[0] - 0.25f) < 1e-6f);

    GUARDED(PellicleSample) sample;
    memset(&sample, PATTERN, sizeof sample);
    CHECK(api->bsdf_sample(bsdf, up, slanted, NULL, &sample.own, sizeof sample.own) == PELLICLE_OK);
    CHECK(is_untouched(sample.guard));
    CHECK(fabsf(sample.own.weight[0] - 0.25f) < 1e-6f && sample.own.lobe < info.own.lobe_count);
}

static void call_batches(const PellicleApi *api, const PellicleBsdf *bsdf) {
    enum { COUNT = 37 };
    float values[COUNT][3], weights[COUNT][3];
    uint32_t flags[COUNT];
    GUARDED(PellicleEvalBatchArgs) eval;
    memset(&eval, PATTERN, sizeof eval);
    memset(&eval.own, 0, sizeof eval.own);
    eval.own.count = COUNT;
    eval.own.wo = (PellicleConstView){up, 0, 4};
    eval.own.wi = (PellicleConstView){slanted, 0, 4};
    eval.own.value = (PellicleView){values[0], sizeof values[0], 4};
    CHECK(api->bsdf_eval_batch(bsdf, &eval.own, sizeof eval.own) == PELLICLE_OK);
    GUARDED(PellicleSampleBatchArgs) sample;
    memset(&sample, PATTERN, sizeof sample);
    memset(&sample.own, 0, sizeof sample.own);
    sample.own.count = COUNT;
    sample.own.wo = eval.own.wo;
    sample.own.u = (PellicleConstView){slanted, 0, 4};
    sample.own.weight = (PellicleView){weights[0], sizeof weights[0], 4};
    sample.own.flags = (PellicleUintView){flags, sizeof flags[0]};
    CHECK(api->bsdf_sample_batch(bsdf, &sample.own, sizeof sample.own) == PELLICLE_OK);
    float value[3];
    CHECK(api->bsdf_eval(bsdf, up, slanted, NULL, value, NULL) == PELLICLE_OK);
    for (int i = 0; i < COUNT; ++i) {
        CHECK(memcmp(values[i], value, sizeof value) == 0);
        CHECK(fabsf(weights[i][0] - 0.25f) < 1e-6f && flags[i] == (PELLICLE_REFLECTION | PELLICLE_DIFFUSE));
    }
}

int main(void) {
    CHECK(pellicle_abi_version() == PELLICLE_ABI_VERSION);
    const PellicleApi *api = pellicle_get_api(PELLICLE_ABI_VERSION);
    if (!api) {
        fprintf(stderr, "no table of functions for ABI version %d\n", PELLICLE_ABI_VERSION);
        return 1;
    }
    CHECK(api->size > sizeof *api);
    CHECK(api->bsdf_create == &pellicle_bsdf_create && api->bsdf_sample_batch == &pellicle_bsdf_sample_batch);
    introspect(api);
    PellicleBsdf *bsdf = create(api);
    CHECK(api->bsdf_retain(bsdf) == PELLICLE_OK);
    api->bsdf_release(bsdf);
    call(api, bsdf);
    call_batches(api, bsdf);
    api->bsdf_release(bsdf);
    CHECK(strcmp(api->status_string(PELLICLE_INTERNAL), "unknown status") != 0);
    return failures != 0;
}
