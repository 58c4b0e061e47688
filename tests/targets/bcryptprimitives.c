/* What the programs of Rust's standard library ask of bcryptprimitives.dll, which older versions of wine lack: bytes for
 * the seeds of hash tables. No result of a simulation depends on them. */
#include <stddef.h>

__declspec(dllexport) int ProcessPrng(unsigned char *bytes, size_t count) {
    for (size_t i = 0; i < count; i++) bytes[i] = (unsigned char)(97 * i + 13);
    return 1;
}
