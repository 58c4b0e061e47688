/*
 * Floating-point environments that a host may have set: the trace is that of the default one, and the host finds its
 * environment as it left it. From the main thread, and from a thread that has an environment of its own.
 */

#include <fenv.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "rig.h"
#include "softanvil.h"

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
#error "this rig knows no floating-point environment of this processor"
#endif

enum { COUNT = sizeof environments / sizeof environments[0], MEMORY = 1 << 18, SNAPSHOT = 1 << 16 };

/* Memory of one run at a time. */
static _Alignas(64) unsigned char memory[MEMORY];
static uint8_t snapshot[SNAPSHOT];

static void check(int holds, const char *environment, const char *what)
{
    if (!holds) {
        fprintf(stderr, "%s: failed: %s\n", environment, what);
        exit(1);
    }
}

/* Everything that a call left behind. */
struct outcome {
    uint64_t trace_hash;
    double peak;
    uint64_t checksum;
    /* Whether the host's environment was the same after every call. */
    int kept;
};

/* One drop, from the scenario to the snapshot, with an environment set before every call. */
static struct outcome drop(control environment, double duration)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation = NULL;
    struct outcome outcome = { 0, 0.0, 0, 1 };
    size_t size = 0, alignment = 0, snapshot_size = 0;
    int bad = 0;
#define CALL(call)                                                        \
    do {                                                                  \
        write_control(environment);                                       \
        int status = (call);                                              \
        control left = read_control();                                    \
        write_control(environments[0].value);                             \
        outcome.kept &= (left & ~FLAGS) == (environment & ~FLAGS);        \
        bad |= status != SOFTANVIL_STATUS_OK;                             \
    } while (0)
    CALL(softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario));
    CALL(softanvil_memory_size(&scenario, &size, &alignment, NULL));
    check(size <= sizeof memory, "any", "the static memory is enough");
    CALL(softanvil_init(memory, sizeof memory, &scenario, &simulation, NULL));
    CALL(softanvil_step_to_sample(simulation, NULL, NULL));
    CALL(softanvil_run(simulation, duration, NULL, NULL));
    CALL(softanvil_output(simulation, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE, &outcome.peak));
    CALL(softanvil_trace_hash(simulation, &outcome.trace_hash));
    CALL(softanvil_snapshot_size(simulation, &snapshot_size));
    CALL(softanvil_snapshot_save(simulation, snapshot, sizeof snapshot, NULL));
    CALL(softanvil_snapshot_restore(simulation, snapshot, sizeof snapshot, NULL));
    check(!bad && snapshot_size >= 8, "any", "every call succeeds");
    for (int i = 0; i < 8; i++) {
        outcome.checksum |= (uint64_t)snapshot[snapshot_size - 8 + (size_t)i] << (8 * i);
    }
    return outcome;
}

/* Whether the environment does what its name says to the host's own numbers. */
static int changes_numbers(control environment)
{
    volatile double three = 3.0, tiny = 0x1p-1070, half = 0.5;
    write_control(environment);
    volatile double third = 1.0 / three, minus = -1.0 / three, smaller = tiny * half;
    write_control(environments[0].value);
    volatile double plain_third = 1.0 / three, plain_minus = -1.0 / three, plain_smaller = tiny * half;
    return third != plain_third || minus != plain_minus || smaller != plain_smaller;
}

static void sweep(double duration)
{
    struct outcome wanted = drop(environments[0].value, duration);
    for (int i = 0; i < COUNT; i++) {
        const char *name = environments[i].name;
        struct outcome found = drop(environments[i].value, duration);
        check(found.kept, name, "the host's environment is put back");
        check(found.trace_hash == wanted.trace_hash, name, "the trace is that of the default environment");
        check(found.checksum == wanted.checksum, name, "the state is that of the default environment");
        check(found.peak == wanted.peak, name, "outputs are those of the default environment");
        printf("%-36s trace %016llx\n", name, (unsigned long long)found.trace_hash);
    }
}

static void *thread(void *unused)
{
    (void)unused;
    fesetround(FE_TOWARDZERO);
    control environment = read_control();
    struct outcome found = drop(environment, 3e-3);
    check(found.kept, "a thread", "the thread's environment is put back");
    sweep(3e-3);
    return NULL;
}

/* Nanoseconds are not tested here; a call in the default environment only reads a register more. */
int main(void)
{
    int differing = 0;
    for (int i = 1; i < COUNT; i++) {
        /* Trapped exceptions would end this program at its own arithmetic. */
        int quiet = environments[i].name[0] != 'e' && environments[i].name[0] != 'a';
        differing += quiet && changes_numbers(environments[i].value);
    }
    check(differing >= 4, "host", "the environments change the host's own numbers");
    sweep(15e-3);
    pthread_t other;
    check(pthread_create(&other, NULL, thread, NULL) == 0, "a thread", "it starts");
    check(pthread_join(other, NULL) == 0, "a thread", "it ends");
    puts("every environment gives the same trace and is put back");
    return 0;
}
