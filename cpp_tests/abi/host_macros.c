/* pellicle.h compiles after the macros of a host. */
#include "host_macros.h"

#include <pellicle.h>

const size_t size_after_host_macros = sizeof(PellicleApi);
