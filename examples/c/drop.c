#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <softanvil.h>

int main(void)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation;
    SoftanvilError error = { 0 };
    size_t size, alignment;
    double peak;
    uint64_t hash;
    softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario); /* 14.7 J */
    softanvil_memory_size(&scenario, &size, &alignment, &error);
    void *memory = malloc(size);
    if (softanvil_init(memory, size, &scenario, &simulation, &error) != SOFTANVIL_STATUS_OK ||
        softanvil_run(simulation, 15e-3, NULL, &error) != SOFTANVIL_STATUS_OK)
        return fprintf(stderr, "%s\n", error.text), 1;
    softanvil_output(simulation, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE, &peak);
    softanvil_trace_hash(simulation, &hash);
    printf("peak force %.1f N, trace hash %016" PRIx64 "\n", peak, hash);
    free(memory);
    return 0;
}
