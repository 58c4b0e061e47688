/* Three drops from C11, in static memory, sample by sample; saved, restored and moved in the middle. */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "must.h"
#include "rig.h"
#include "softanvil.h"

enum { MEMORY = 1 << 18, SNAPSHOT = 1 << 16, SAMPLES = 300, SAVED_SAMPLE = 100 };

static _Alignas(64) unsigned char memory[MEMORY];
static _Alignas(64) unsigned char copy[MEMORY];
static uint8_t snapshot[SNAPSHOT];

static void check(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "failed: %s\n", what);
        exit(1);
    }
}

static SoftanvilSimulation *start(double energy)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation;
    size_t size = 0;
    size_t alignment = 0;
    MUST(softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario));
    MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_DROP_BY, SOFTANVIL_IMPACTOR_DROP_BY_ENERGY,
                                &error));
    MUST(softanvil_scenario_set_by_name(&scenario, "impactor.drop_energy", energy, &error));
    MUST(softanvil_memory_size(&scenario, &size, &alignment, &error));
    check(size <= sizeof memory && 64 % alignment == 0, "the static memory is enough");
    MUST(softanvil_init(memory, sizeof memory, &scenario, &simulation, &error));
    return simulation;
}

static void run_samples(SoftanvilSimulation *simulation, int samples)
{
    for (int sample = 0; sample < samples; sample++) {
        MUST(softanvil_step_to_sample(simulation, NULL, &error));
    }
}

static double output(const SoftanvilSimulation *simulation, uint32_t id)
{
    double value = 0.0;
    MUST(softanvil_output(simulation, id, &value));
    return value;
}

static uint64_t hash(const SoftanvilSimulation *simulation)
{
    uint64_t value = 0;
    MUST(softanvil_trace_hash(simulation, &value));
    return value;
}

static struct rig_result drop(double energy)
{
    SoftanvilSimulation *simulation = start(energy);
    run_samples(simulation, SAMPLES);
    double time = 0.0;
    MUST(softanvil_time(simulation, &time));
    check(time == RIG_DURATION, "300 samples cover the duration exactly");
    return (struct rig_result){
        .energy = energy,
        .peak_force = output(simulation, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE),
        .max_deformation = output(simulation, SOFTANVIL_OUTPUT_RESULT_MAX_DEFORMATION),
        .impact_duration = output(simulation, SOFTANVIL_OUTPUT_RESULT_IMPACT_DURATION),
        .impulse = output(simulation, SOFTANVIL_OUTPUT_RESULT_IMPULSE),
        .residual = output(simulation, SOFTANVIL_OUTPUT_ENERGY_RESIDUAL),
        .trace_hash = hash(simulation),
    };
}

/* Saves in the middle, goes on, restores, goes on again: the same trace; and so in a copy at another address. */
static void resume(const struct rig_result *whole)
{
    SoftanvilSimulation *simulation = start(whole->energy);
    size_t size = 0;
    run_samples(simulation, SAVED_SAMPLE);
    MUST(softanvil_snapshot_size(simulation, &size));
    check(size <= sizeof snapshot, "the static snapshot is enough");
    MUST(softanvil_snapshot_save(simulation, snapshot, sizeof snapshot, &error));
    memcpy(copy, memory, sizeof copy);

    run_samples(simulation, SAMPLES - SAVED_SAMPLE);
    check(hash(simulation) == whole->trace_hash, "saving changes nothing");
    MUST(softanvil_reset(simulation));
    MUST(softanvil_snapshot_restore(simulation, snapshot, size, &error));
    run_samples(simulation, SAMPLES - SAVED_SAMPLE);
    check(hash(simulation) == whole->trace_hash, "a restored simulation continues with the same bits");

    SoftanvilSimulation *moved = (SoftanvilSimulation *)(void *)copy;
    run_samples(moved, SAMPLES - SAVED_SAMPLE);
    check(hash(moved) == whole->trace_hash, "a moved simulation continues with the same bits");
    MUST(softanvil_close(simulation));
}

int main(void)
{
    const double energies[] = RIG_ENERGIES;
#ifdef RELEASED_HEADER
    check(softanvil_version() >= SOFTANVIL_VERSION, "the library is no older than the header");
#else
    check(softanvil_version() == SOFTANVIL_VERSION, "header and library have the same version");
    check(strcmp(softanvil_version_text(), SOFTANVIL_VERSION_TEXT) == 0, "and the same version text");
#endif
    for (size_t i = 0; i < sizeof energies / sizeof energies[0]; i++) {
        const struct rig_result result = drop(energies[i]);
        rig_print(&result);
        check(result.residual < RIG_RESIDUAL * result.energy && -result.residual < RIG_RESIDUAL * result.energy,
              "the energy residual is small");
        resume(&result);
    }
    return 0;
}
