/* A C99 program against an installed pellicle: a Lambertian surface gives reflectance / pi * cos. */
#include <pellicle.h>

#include <math.h>
#include <stdio.h>

int main(void) {
    const float reflectance = 0.5f;
    const PellicleParam param = {"reflectance", &reflectance, 1, NULL};
    const float wo[3] = {0.0f, 0.0f, 1.0f};
    const float wi[3] = {0.0f, 0.6f, 0.8f};
    const float expected = 0.5f * 0.8f / 3.14159265f;
    float value[3] = {0.0f, 0.0f, 0.0f};
    PellicleBsdf *bsdf = NULL;
    PellicleBsdfDesc desc = {0};
    desc.model = "lambert";
    desc.params = &param;
    desc.param_count = 1;

    if (pellicle_bsdf_create(&desc, sizeof desc, &bsdf) != PELLICLE_OK ||
        pellicle_bsdf_eval(bsdf, wo, wi, NULL, NULL, value, NULL, NULL) != PELLICLE_OK) {
        fprintf(stderr, "%s\n", pellicle_last_error());
        return 1;
    }
    pellicle_bsdf_release(bsdf);
    printf("pellicle %s: %g, expected %g\n", pellicle_version_string(), value[1], expected);
    return fabsf(value[1] - expected) > 1e-6f;
}
