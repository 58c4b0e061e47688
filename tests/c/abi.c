/* The layout of every structure, at compile time; ffi/tests/abi.rs holds the Rust side to the same list. */

#include <stddef.h>

#include "softanvil.h"

#define SIZE(type, bytes) _Static_assert(sizeof(type) == (bytes), "size of " #type);
#define ALIGNMENT(type, bytes) _Static_assert(_Alignof(type) == (bytes), "alignment of " #type);
#define FIELD(type, field, offset) _Static_assert(offsetof(type, field) == (offset), "offset of " #type "." #field);
#define VALUE(name, number) _Static_assert((name) == (number), "value of " #name);
#include "abi.inc"

int main(void)
{
    return 0;
}
