/* A host that makes the symbols of all its plug-ins global, as many do.
 * Usage: plugin_host (<plug-in> <its function> <version that it must run>)... */
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(int argc, char **argv) {
    int failures = 0;
    for (int i = 1; i + 2 < argc; i += 3) {
        void *plugin = dlopen(argv[i], RTLD_NOW | RTLD_GLOBAL);
        void *symbol = plugin != NULL ? dlsym(plugin, argv[i + 1]) : NULL;
        if (symbol == NULL) {
            fprintf(stderr, "cannot load: %s\n", dlerror());
            return 1;
        }
        /* ISO C has no cast from an object pointer to a function pointer; POSIX promises the copy works. */
        const char *(*function)(float *);
        memcpy(&function, &symbol, sizeof function);
        float value = 0.0f;
        const char *version = function(&value);
        printf("%s runs pellicle %s, which must be %s: %g\n", argv[i + 1], version, argv[i + 2], value);
        failures += strcmp(version, argv[i + 2]) != 0 || fabsf(value - 0.5f / 3.14159265f) > 1e-6f;
    }
    return failures != 0 || argc < 7;
}
