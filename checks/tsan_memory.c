/* What Rust's thread sanitizer calls and the C compiler's run-time library, which is older, does not have: its
 * functions of the C library's names look at the same accesses. */
#include <string.h>

void *__tsan_memcpy(void *to, const void *from, size_t size) { return memcpy(to, from, size); }
void *__tsan_memmove(void *to, const void *from, size_t size) { return memmove(to, from, size); }
void *__tsan_memset(void *to, int byte, size_t size) { return memset(to, byte, size); }
