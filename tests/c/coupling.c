/* A drop in two parts: the anvil with a driven face, and the falling mass here, as in a model of a machine. They exchange
 * motion and force every 50 us, then every 200 us; the peak force is compared with that of the drop with the mass inside.
 *
 *     coupling [LARGEST_DEVIATION_PERCENT]      (unless told, 0.5 at 50 us and 2 at 200 us)
 *
 * The mass predicts its motion over the next exchange with the force that it expects, the last mean force carried on along a
 * straight line, and tells the anvil where it will be and how fast. Then it corrects itself by the impulse that came.
 */

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "must.h"
#include "softanvil.h"

enum { MEMORY = 1 << 20 };

static const double MASS = 5.0, GRAVITY = 9.81, GAP = 2e-3, ENERGY = 14.7, DURATION = 15e-3, SAMPLE = 50e-6;

static _Alignas(64) unsigned char memory[MEMORY];
static SoftanvilSimulation *anvil(double motion)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation = NULL;
    MUST(softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario));
    MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_MOTION, motion, &error));
    MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_GAP, GAP, &error));
    if (motion == SOFTANVIL_IMPACTOR_MOTION_DROP) {
        MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_MASS, MASS, &error));
        MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_GRAVITY, GRAVITY, &error));
        MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_DROP_ENERGY, ENERGY, &error));
    } else {
        /* How far a driven face may press the layer. */
        MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_TIME_DESIGN_COMPRESSION, 0.8, &error));
    }
    MUST(softanvil_init(memory, sizeof memory, &scenario, &simulation, &error));
    return simulation;
}

static double output(const SoftanvilSimulation *simulation, uint32_t which)
{
    double value = 0.0;
    MUST(softanvil_output(simulation, which, &value));
    return value;
}

/* Peak force of the drop with the mass inside, N. */
static double inside(void)
{
    SoftanvilSimulation *simulation = anvil(SOFTANVIL_IMPACTOR_MOTION_DROP);
    MUST(softanvil_run(simulation, DURATION, NULL, &error));
    return output(simulation, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE);
}

/* Peak force with the mass here and an exchange every `samples` sampling intervals, N. */
static double outside(int samples)
{
    SoftanvilSimulation *simulation = anvil(SOFTANVIL_IMPACTOR_MOTION_DRIVEN);
    const double size = samples * SAMPLE;
    double position = GAP, velocity = -sqrt(2.0 * ENERGY / MASS), impulse = 0.0, force = 0.0, force_before = 0.0;
    SoftanvilInput input;
    MUST(softanvil_input_default(simulation, &input));
    for (int i = 1; i * samples <= (int)(DURATION / SAMPLE + 0.5); i++) {
        const double expected = fmax(0.0, 2.0 * force - force_before) / MASS - GRAVITY;
        /* Where the face shall be at the end of the exchange, and how fast. */
        input.driven_position = position + size * (velocity + 0.5 * size * expected);
        input.driven_velocity = velocity + size * expected;
        MUST(softanvil_run_until(simulation, i * size, &input, &error));
        /* What the impulse made of it. */
        const double now = output(simulation, SOFTANVIL_OUTPUT_RESULT_IMPULSE);
        force_before = force;
        force = (now - impulse) / size;
        impulse = now;
        const double change = size * (force / MASS - GRAVITY);
        position += size * (velocity + 0.5 * change);
        velocity += change;
    }
    return output(simulation, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE);
}

int main(int argc, char **argv)
{
    static const struct { int samples; double percent; } EXCHANGES[] = { { 1, 0.5 }, { 4, 2.0 } };
    const double expected = inside();
    int failures = 0;
    printf("mass inside: %.1f N\n", expected);
    for (size_t i = 0; i < sizeof EXCHANGES / sizeof *EXCHANGES; i++) {
        const double peak = outside(EXCHANGES[i].samples);
        const double deviation = 100.0 * (peak / expected - 1.0);
        printf("mass outside, %3d us: %.1f N, %+.2f %%\n", 50 * EXCHANGES[i].samples, peak, deviation);
        failures += !(fabs(deviation) <= (argc > 1 ? strtod(argv[1], NULL) : EXCHANGES[i].percent));
    }
    return failures == 0 ? 0 : 1;
}
