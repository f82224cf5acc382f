/* A plug-in: its only function gives the version of the pellicle that it runs, and the value of a Lambertian surface. */
#include <pellicle.h>

const char *PLUGIN(float *value);
const char *PLUGIN(float *value) {
    const float wo[3] = {0.0f, 0.0f, 1.0f};
    float rgb[3] = {0.0f, 0.0f, 0.0f};
    PellicleBsdf *bsdf = NULL;
    PellicleBsdfDesc desc = {0};
    desc.model = "lambert";
    if (pellicle_bsdf_create(&desc, sizeof desc, &bsdf) == PELLICLE_OK)
        pellicle_bsdf_eval(bsdf, wo, wo, NULL, NULL, rgb, NULL, NULL);
    pellicle_bsdf_release(bsdf);
    *value = rgb[1];
    return pellicle_version_string();
}
