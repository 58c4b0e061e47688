/* A unit test rig, the pattern for a user's own: three drops, their peak forces against reference values, the table,
 * and an exit code of 0 if all of them are within the tolerance.
 *
 *     unit [TOLERANCE_PERCENT]      (5 unless told)
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "softanvil.h"

enum { MEMORY = 1 << 18 };

static _Alignas(64) unsigned char memory[MEMORY];

/* Energies, J, and the peak forces that the study measured, N (doi 10.1007/s12283-023-00407-7, Table 1). */
static const struct {
    double energy;
    double peak_force;
} references[] = { { 14.7, 5499.0 }, { 9.8, 4071.0 }, { 4.9, 2399.0 } };

/* Peak force of a drop, N; ends the program if it cannot be simulated. */
static double peak_force(double energy)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation = NULL;
    SoftanvilError error = { 0 };
    double peak = NAN;
    softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario);
    scenario.value[SOFTANVIL_PARAMETER_IMPACTOR_DROP_BY] = SOFTANVIL_IMPACTOR_DROP_BY_ENERGY;
    scenario.value[SOFTANVIL_PARAMETER_IMPACTOR_DROP_ENERGY] = energy;
    if (softanvil_init(memory, sizeof memory, &scenario, &simulation, &error) != SOFTANVIL_STATUS_OK ||
        softanvil_run(simulation, 15e-3, NULL, &error) != SOFTANVIL_STATUS_OK ||
        softanvil_output(simulation, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE, &peak) != SOFTANVIL_STATUS_OK) {
        fprintf(stderr, "%g J: %s\n", energy, error.text);
        exit(2);
    }
    return peak;
}

int main(int argc, char **argv)
{
    const double tolerance = argc > 1 ? strtod(argv[1], NULL) : 5.0;
    int failed = 0;
    printf("energy      reference    simulated    error (tolerance %g %%)\n", tolerance);
    for (size_t i = 0; i < sizeof references / sizeof references[0]; i++) {
        const double expected = references[i].peak_force;
        const double peak = peak_force(references[i].energy);
        const double percent = 100.0 * (peak - expected) / expected;
        const int holds = fabs(percent) <= tolerance;
        printf("%4.1f J      %7.1f N    %7.1f N    %+.2f %%  %s\n", references[i].energy, expected, peak, percent,
               holds ? "ok" : "FAILED");
        failed += !holds;
    }
    return failed == 0 ? 0 : 1;
}
