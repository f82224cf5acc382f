/* Loads the library, uses it and unloads it, again and again: no byte may be left behind.
 * Usage: unload <path of the shared library> */
#define _GNU_SOURCE
#include <pellicle.h>

#include <dlfcn.h>
#include <malloc.h>
#include <stdio.h>
#include <string.h>

/* Makes and gives up a film, a BSDF and a failure. Returns 0 if all went well. */
static int use(const char *path) {
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) {
        fprintf(stderr, "cannot load: %s\n", dlerror());
        return 1;
    }
    /* ISO C has no cast from an object pointer to a function pointer; POSIX promises the copy works. */
    void *symbol = dlsym(library, "pellicle_get_api");
    const PellicleApi *(*get_api)(uint32_t);
    memcpy(&get_api, &symbol, sizeof get_api);
    const PellicleApi *api = get_api(PELLICLE_ABI_VERSION);

    PellicleMedium glass = {0};
    glass.name = "BK7";
    PellicleFilmDesc film_desc = {0};
    film_desc.medium_size = sizeof glass;
    film_desc.base = &glass;
    PellicleFilm *film = NULL;
    PellicleFilmPlan plan;
    PellicleBsdfDesc desc = {0};
    desc.model = "film";
    PellicleBsdf *bsdf = NULL;
    PellicleBsdfInfo info;
    int failures = api->film_create(&film_desc, sizeof film_desc, &film) != PELLICLE_OK;
    failures += api->film_plan(film, &plan, sizeof plan) != PELLICLE_OK;
    failures += api->bsdf_create(&desc, sizeof desc, &bsdf) != PELLICLE_INVALID_ARGUMENT;
    desc.film = film;
    failures += api->bsdf_create(&desc, sizeof desc, &bsdf) != PELLICLE_OK;
    failures += api->bsdf_info(bsdf, &info, sizeof info) != PELLICLE_OK;
    failures += api->name(PELLICLE_NAMES_SIMD_LEVEL, 0) == NULL;
    if (failures != 0) fprintf(stderr, "%d calls went wrong: %s\n", failures, api->last_error());
    api->bsdf_release(bsdf);
    api->film_release(film);

    if (dlclose(library) != 0 || dlopen(path, RTLD_NOW | RTLD_NOLOAD) != NULL) {
        fprintf(stderr, "the library stays loaded\n");
        return 1;
    }
    return failures;
}

int main(int argc, char **argv) {
    if (argc != 2) return 2;
    /* The first rounds fill the caches of the allocator and of the dynamic linker. */
    for (int i = 0; i < 200; ++i)
        if (use(argv[1]) != 0) return 1;
    const size_t before = mallinfo2().uordblks;
    const int rounds = 100;
    for (int i = 0; i < rounds; ++i)
        if (use(argv[1]) != 0) return 1;
    const size_t after = mallinfo2().uordblks;
    printf("in use: %zu bytes before, %zu after %d rounds\n", before, after, rounds);
    return after >= before + (size_t)rounds;
}
