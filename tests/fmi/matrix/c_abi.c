/* The C ABI of softanvil.h for matrix.c. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "matrix.h"
#include "softanvil.h"

struct Drop {
    SoftanvilSimulation *simulation;
    void *memory;
};

static int ok(SoftanvilStatus status) { return status == SOFTANVIL_STATUS_OK; }

void prepare(const char *library, const char *token)
{
    (void)library;
    (void)token;
}

Drop *begin(double energy)
{
    SoftanvilScenario scenario;
    size_t size, alignment;
    Drop *drop = malloc(sizeof *drop);
    MUST(drop != NULL);
    MUST(ok(softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario)));
    MUST(ok(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_DROP_ENERGY, energy, NULL)));
    MUST(ok(softanvil_memory_size(&scenario, &size, &alignment, NULL)));
    drop->memory = malloc(size);
    MUST(drop->memory != NULL);
    MUST(ok(softanvil_init(drop->memory, size, &scenario, &drop->simulation, NULL)));
    return drop;
}

void advance(Drop *drop, int made, int count, double size)
{
    for (int i = made; i < made + count; i++) MUST(ok(softanvil_run_until(drop->simulation, (i + 1) * size, NULL, NULL)));
}

unsigned char *save(Drop *drop, size_t *size)
{
    MUST(ok(softanvil_snapshot_size(drop->simulation, size)));
    unsigned char *bytes = malloc(*size);
    MUST(bytes != NULL);
    MUST(ok(softanvil_snapshot_save(drop->simulation, bytes, *size, NULL)));
    return bytes;
}

void restore(Drop *drop, const unsigned char *bytes, size_t size)
{
    MUST(ok(softanvil_snapshot_restore(drop->simulation, bytes, size, NULL)));
}

Outcome outcome(Drop *drop)
{
    Outcome found;
    uint64_t hash;
    MUST(ok(softanvil_output(drop->simulation, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE, &found.peak_force)));
    MUST(ok(softanvil_output(drop->simulation, SOFTANVIL_OUTPUT_RESULT_IMPULSE, &found.impulse)));
    MUST(ok(softanvil_trace_hash(drop->simulation, &hash)));
    snprintf(found.trace_hash, sizeof found.trace_hash, "%016" PRIx64, hash);
    return found;
}

void end(Drop *drop)
{
    softanvil_close(drop->simulation);
    free(drop->memory);
    free(drop);
}
