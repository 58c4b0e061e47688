/*
 * Floating-point environments that a host may have set: the trace is that of the default one, and the host finds its
 * environment as it left it. From the main thread, and from a thread that has an environment of its own.
 */

#include <fenv.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "host_environment.h"
#include "rig.h"
#include "softanvil.h"

enum { MEMORY = 1 << 18, SNAPSHOT = 1 << 16 };

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
        outcome.kept &= same_environment(left, environment);              \
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

static void sweep(double duration)
{
    struct outcome wanted = drop(environments[0].value, duration);
    for (int i = 0; i < ENVIRONMENTS; i++) {
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
    check(environments_change_numbers(), "host", "the environments change the host's own numbers");
    sweep(15e-3);
    pthread_t other;
    check(pthread_create(&other, NULL, thread, NULL) == 0, "a thread", "it starts");
    check(pthread_join(other, NULL) == 0, "a thread", "it ends");
    puts("every environment gives the same trace and is put back");
    return 0;
}
