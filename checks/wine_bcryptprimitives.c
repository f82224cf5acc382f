/* Rust's standard library asks Windows' bcryptprimitives.dll for random numbers, and wine before 8.18 has no such
 * library. The checks put this one into wine's system folder. */
#include <windows.h>

BOOLEAN NTAPI SystemFunction036(PVOID buffer, ULONG size); /* RtlGenRandom, in advapi32 */

__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE buffer, SIZE_T size) {
    return SystemFunction036(buffer, (ULONG)size);
}
