/*
 * The floating-point environment of the calling thread, and those that a host may have set. For x86-64 and aarch64.
 */
#ifndef HOST_ENVIRONMENT_H
#define HOST_ENVIRONMENT_H

#if defined(__x86_64__)
#include <xmmintrin.h>
typedef unsigned int control;
static control read_control(void) { return _mm_getcsr(); }
static void write_control(control value) { _mm_setcsr(value); }
/* The flags, which tell what happened and change nothing. */
#define FLAGS 0x3fu
#define MASKS 0x1f80u
static const struct {
    const char *name;
    control value;
} environments[] = {
    { "default", MASKS },
    { "rounding down", MASKS | 0x2000 },
    { "rounding up", MASKS | 0x4000 },
    { "rounding to zero", MASKS | 0x6000 },
    { "flush to zero", MASKS | 0x8000 },
    { "denormals are zero", MASKS | 0x0040 },
    { "every exception unmasked but inexact", 0x1000 },
    { "every exception unmasked", 0x0000 },
    { "all of it", 0xe040 },
};
#elif defined(__aarch64__)
typedef unsigned long control;
static control read_control(void)
{
    control value;
    __asm__ volatile("mrs %0, fpcr" : "=r"(value));
    return value;
}
static void write_control(control value) { __asm__ volatile("msr fpcr, %0" : : "r"(value)); }
#define FLAGS 0ul
static const struct {
    const char *name;
    control value;
} environments[] = {
    { "default", 0 },
    { "rounding up", 1ul << 22 },
    { "rounding down", 2ul << 22 },
    { "rounding to zero", 3ul << 22 },
    { "flush to zero", 1ul << 24 },
    { "all of it", (3ul << 22) | (1ul << 24) | (1ul << 25) },
};
#else
#error "no floating-point environment of this processor is known here"
#endif

enum { ENVIRONMENTS = sizeof environments / sizeof environments[0] };

/* Whether two environments are the same but for the flags. */
static int same_environment(control a, control b) { return (a & ~FLAGS) == (b & ~FLAGS); }

/* Whether the environment does what its name says to the host's own numbers. */
static int changes_numbers(control environment)
{
    volatile double three = 3.0, five = 5.0, tiny = 0x1p-1070, half = 0.5;
    write_control(environment);
    volatile double third = 1.0 / three, fifth = 1.0 / five, minus = -1.0 / three, smaller = tiny * half;
    write_control(environments[0].value);
    return third != 1.0 / three || fifth != 1.0 / five || minus != -1.0 / three || smaller != tiny * half;
}

/* Whether every environment changes the host's own numbers, of those that trap nothing. */
static int environments_change_numbers(void)
{
    for (int i = 1; i < ENVIRONMENTS; i++) {
        /* Trapped exceptions would end the program at its own arithmetic. */
        int traps = environments[i].name[0] == 'e' || environments[i].name[0] == 'a';
        if (!traps && !changes_numbers(environments[i].value)) return 0;
    }
    return 1;
}

#endif
