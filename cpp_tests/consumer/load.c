/* A host that loads pellicle at run time. Usage: load <path of libpellicle.so> */
#include <pellicle.h>

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef const PellicleApi *(*GetApi)(uint32_t abi_version);

int main(int argc, char **argv) {
    void *library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
    if (library == NULL) {
        fprintf(stderr, "cannot load: %s\n", argc == 2 ? dlerror() : "give one path");
        return 1;
    }
    /* ISO C has no cast from an object pointer to a function pointer; POSIX promises the copy works. */
    void *symbol = dlsym(library, "pellicle_get_api");
    GetApi get_api;
    memcpy(&get_api, &symbol, sizeof get_api);
    const PellicleApi *api = symbol != NULL ? get_api(PELLICLE_ABI_VERSION) : NULL;
    if (api == NULL || api->size < sizeof *api) {
        fprintf(stderr, "no table of ABI version %d\n", PELLICLE_ABI_VERSION);
        return 1;
    }

    const float wo[3] = {0.0f, 0.0f, 1.0f};
    const float wi[3] = {0.0f, 0.6f, 0.8f};
    const float expected = 0.5f * 0.8f / 3.14159265f;
    float value[3] = {0.0f, 0.0f, 0.0f};
    PellicleBsdf *bsdf = NULL;
    PellicleBsdfDesc desc = {0};
    desc.model = "lambert";
    if (api->bsdf_create(&desc, sizeof desc, &bsdf) != PELLICLE_OK ||
        api->bsdf_eval(bsdf, wo, wi, NULL, NULL, value, NULL, NULL) != PELLICLE_OK) {
        fprintf(stderr, "%s\n", api->last_error());
        return 1;
    }
    api->bsdf_release(bsdf);
    printf("pellicle %s: %g, expected %g\n", api->version_string(), value[1], expected);
    return fabsf(value[1] - expected) > 1e-6f || dlclose(library) != 0;
}
