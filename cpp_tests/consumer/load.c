/* A host that loads pellicle at run time. Usage: load <path of the shared library> */
#include <pellicle.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
static void *open_library(const char *path) { return (void *)LoadLibraryA(path); }
static void *look_up(void *library, const char *name) { return (void *)(uintptr_t)GetProcAddress(library, name); }
static int close_library(void *library) { return FreeLibrary(library) ? 0 : 1; }
#else
#include <dlfcn.h>
static void *open_library(const char *path) { return dlopen(path, RTLD_NOW | RTLD_LOCAL); }
static void *look_up(void *library, const char *name) { return dlsym(library, name); }
static int close_library(void *library) { return dlclose(library); }
#endif

typedef const PellicleApi *(*GetApi)(uint32_t abi_version);

int main(int argc, char **argv) {
    void *library = argc == 2 ? open_library(argv[1]) : NULL;
    if (library == NULL) {
        fprintf(stderr, "cannot load %s\n", argc == 2 ? argv[1] : "without a path");
        return 1;
    }
    /* ISO C has no cast from an object pointer to a function pointer; POSIX promises the copy works. */
    void *symbol = look_up(library, "pellicle_get_api");
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
    return fabsf(value[1] - expected) > 1e-6f || close_library(library) != 0;
}
