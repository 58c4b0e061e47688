/* Layers: one of 16/1024 m in eight rows of cells, and stacks of the same material and the same rows, give the same trace to the
 * last bit; a layer without a thickness is refused by its number.
 *
 *     layers
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "must.h"
#include "softanvil.h"

enum { MEMORY = 1 << 19 };

static _Alignas(64) unsigned char memory[MEMORY];
/* Rows of the layers from the core to the surface, of 2/1024 m each; 0 ends them. */
static const unsigned stacks[][SOFTANVIL_MAX_LAYERS] = { { 8 }, { 6, 2 }, { 4, 2, 2 }, { 2, 2, 2, 2 } };

/* Trace hash of a drop on a stack. */
static uint64_t drop(const unsigned *rows)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation;
    uint64_t hash = 0;
    uint32_t layer = 0;
    MUST(softanvil_scenario_default(SOFTANVIL_PRESET_ELASTIC, &scenario));
    MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_TIME_STEP, 4e-6, &error));
    for (; layer < SOFTANVIL_MAX_LAYERS && rows[layer] > 0; layer++) {
        const double thickness = ldexp(2.0 * rows[layer], -10);
        MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_OF_LAYER(layer, SOFTANVIL_LAYER_THICKNESS), thickness,
                                    &error));
        MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_OF_LAYER(layer, SOFTANVIL_LAYER_ROWS), rows[layer],
                                    &error));
    }
    MUST(softanvil_scenario_set_by_name(&scenario, "layers.count", layer, &error));
    MUST(softanvil_init(memory, sizeof memory, &scenario, &simulation, &error));
    MUST(softanvil_run(simulation, 10e-3, NULL, &error));
    MUST(softanvil_trace_hash(simulation, &hash));
    return hash;
}

/* Whether a layer that is counted and has no thickness is refused by its number. */
static int missing_thickness_is_refused(void)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation;
    MUST(softanvil_scenario_default(SOFTANVIL_PRESET_ELASTIC, &scenario));
    MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_LAYERS_COUNT, 3.0, &error));
    MUST(softanvil_scenario_set_by_name(&scenario, "layers[1].thickness", 1e-3, &error));
    return softanvil_init(memory, sizeof memory, &scenario, &simulation, &error) == SOFTANVIL_STATUS_LAYER_THICKNESS &&
           error.parameter == SOFTANVIL_PARAMETER_OF_LAYER(2, SOFTANVIL_LAYER_THICKNESS);
}

int main(void)
{
    const uint64_t whole = drop(stacks[0]);
    int failed = !missing_thickness_is_refused();
    for (size_t i = 1; i < sizeof stacks / sizeof stacks[0]; i++) {
        const uint64_t stack = drop(stacks[i]);
        printf("%zu layers: %s\n", i + 1, stack == whole ? "as one" : "FAILED");
        failed += stack != whole;
    }
    return failed == 0 ? 0 : 1;
}
