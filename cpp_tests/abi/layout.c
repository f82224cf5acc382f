/* The header alone compiles as pedantic C99, twice, and has the layout that is kept. */
#include <pellicle.h>
#include <pellicle.h>

/* C99 has no _Static_assert: an array of -1 elements is the error. */
#define JOIN(a, b) a##b
#define NAMED(condition, line) extern const char JOIN(law_of_line_, line)[(condition) ? 1 : -1];
#define AT(condition, line) NAMED(condition, line)
#define LAW(condition) AT(condition, __LINE__)

#include "layout.h"
