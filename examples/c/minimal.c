/* The smallest complete use of pellicle: a soap-like film, one evaluation and one sample.
 *
 * Builds alone against an installed pellicle:
 *     cc -std=c99 minimal.c $(pkg-config --cflags --libs pellicle) -o minimal
 * or with CMake, see CMakeLists.txt beside it. */

#include <pellicle.h>
#include <stdio.h>

/* Every call returns a status; after a failure the message says what would have been right. */
static int failed(PellicleStatus status) {
    if (status != PELLICLE_OK) {
        fprintf(stderr, "%s: %s\n", pellicle_status_string(status), pellicle_last_error());
    }
    return status != PELLICLE_OK;
}

int main(void) {
    /* What is not named keeps its default. Three indices: red, green and blue see different ones. */
    const float eta[3] = {1.40f, 1.45f, 1.60f};
    const float exponent = 90.0f;
    const PellicleParam params[] = {
        {"eta", eta, 3, NULL},
        {"exponent_reflection", &exponent, 1, NULL},
        {"variant", NULL, 0, "paper"},
    };
    /* The thickness comes with every call, as from a texture. */
    const PellicleRange varying[] = {{"thickness_nm", 66.0f, 76.0f}};

    PellicleBsdfDesc desc = {0};
    desc.model = "layered";
    desc.params = params;
    desc.param_count = sizeof params / sizeof params[0];
    desc.varying = varying;
    desc.varying_count = sizeof varying / sizeof varying[0];

    PellicleBsdf *film = NULL;
    if (failed(pellicle_bsdf_create(&desc, sizeof desc, &film))) {
        return 1;
    }

    /* To the viewer and to the light, 30 degrees to either side of the normal (+Z). */
    const float wo[3] = {-0.5f, 0.0f, 0.8660254f};
    const float wi[3] = {0.5f, 0.0f, 0.8660254f};
    const float u[3] = {0.25f, 0.5f, 0.75f};
    const float thickness_nm = 70.0f;
    float value[3], pdf;
    PellicleSample sample;
    int failures = failed(pellicle_bsdf_eval(film, wo, wi, &thickness_nm, NULL, value, &pdf, NULL));
    failures += failed(pellicle_bsdf_sample(film, wo, u, &thickness_nm, NULL, &sample, sizeof sample));
    if (failures == 0) {
        printf("value  %g %g %g  pdf %g\n", value[0], value[1], value[2], pdf);
        printf("sample towards %g %g %g  weight %g %g %g\n", sample.wi[0], sample.wi[1], sample.wi[2],
               sample.weight[0], sample.weight[1], sample.weight[2]);
    }

    pellicle_bsdf_release(film);
    return failures != 0;
}
