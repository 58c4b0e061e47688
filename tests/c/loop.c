/* A rig like hardware in the loop: a fixed cycle of real time hands the simulation a driven position and takes a force.
 * It counts the cycles whose computation did not end before the next cycle began, and tells the longest computation.
 * Nothing here depends on these times: an ordinary operating system promises none.
 *
 *     loop [CYCLES_PER_SECOND [ELEMENT_SIZE_MM]]      (1000, a divisor of 20000, and 7 unless told)
 */

#define _POSIX_C_SOURCE 200809L

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "must.h"
#include "softanvil.h"

enum { MEMORY = 1 << 18, SAMPLES_PER_SECOND = 20000 };

/* Real time that the rig runs, s; the stroke of the actuator, m; and the time of one stroke, s. */
static const double DURATION = 0.2;
static const double STROKE = 4e-3;
static const double PERIOD = 40e-3;

static _Alignas(64) unsigned char memory[MEMORY];
static double seconds(const struct timespec *from, const struct timespec *to)
{
    return (double)(to->tv_sec - from->tv_sec) + 1e-9 * (double)(to->tv_nsec - from->tv_nsec);
}

static void advance(struct timespec *time, long nanoseconds)
{
    time->tv_nsec += nanoseconds;
    time->tv_sec += time->tv_nsec / 1000000000L;
    time->tv_nsec %= 1000000000L;
}

/* Sleeps until shortly before `time`, then watches the clock: a sleeper may wake tens of microseconds late. */
static void wait_for(const struct timespec *time)
{
    const struct timespec nap = { 0, 100000L };
    struct timespec now;
    for (clock_gettime(CLOCK_MONOTONIC, &now); seconds(&now, time) > 0.0; clock_gettime(CLOCK_MONOTONIC, &now)) {
        if (seconds(&now, time) > 300e-6) {
            nanosleep(&nap, NULL);
        }
    }
}

/* The actuator: down and up again by parabolas, from 1 mm above the anvil to 3 mm into it. */
static double commanded(double time)
{
    const double phase = time / PERIOD - (double)(int)(time / PERIOD);
    return 1e-3 - STROKE * 4.0 * phase * (1.0 - phase);
}

/* What one cycle computes: the steps that cover it, along a straight line to the next command. */
static double cycle(SoftanvilSimulation *simulation, uint64_t steps, double to)
{
    SoftanvilInput input;
    double force = 0.0;
    MUST(softanvil_input_default(simulation, &input));
    input.driven_position = to;
    MUST(softanvil_step(simulation, steps, &input, &error));
    MUST(softanvil_output(simulation, SOFTANVIL_OUTPUT_CONTACT_FORCE, &force));
    return force;
}

static SoftanvilSimulation *start(double element_size, uint64_t *steps_per_sample)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation = NULL;
    MUST(softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario));
    MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_MOTION, SOFTANVIL_IMPACTOR_MOTION_DRIVEN,
                                &error));
    MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_GAP, commanded(0.0), &error));
    MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_MESH_ELEMENT_SIZE, element_size, &error));
    MUST(softanvil_init(memory, sizeof memory, &scenario, &simulation, &error));
    MUST(softanvil_steps_per_sample(simulation, steps_per_sample));
    return simulation;
}

int main(int argc, char **argv)
{
    const int rate = argc > 1 ? atoi(argv[1]) : 1000;
    if (rate < 1 || SAMPLES_PER_SECOND % rate != 0) {
        fprintf(stderr, "%d cycles per second are refused: expected a divisor of %d\n", rate, SAMPLES_PER_SECOND);
        return 2;
    }
    uint64_t steps_per_sample = 0;
    SoftanvilSimulation *simulation = start(argc > 2 ? 1e-3 * strtod(argv[2], NULL) : 7e-3, &steps_per_sample);
    const uint64_t steps = steps_per_sample * (uint64_t)(SAMPLES_PER_SECOND / rate);
    const int cycles = (int)(DURATION * rate);
    const long period = 1000000000L / rate;
    double worst = 0.0, total = 0.0, largest = 0.0;
    int misses = 0;
    struct timespec next, before, after;
    clock_gettime(CLOCK_MONOTONIC, &next);
    for (int i = 0; i < cycles; i++) {
        clock_gettime(CLOCK_MONOTONIC, &before);
        const double force = cycle(simulation, steps, commanded((double)(i + 1) / rate));
        clock_gettime(CLOCK_MONOTONIC, &after);
        const double taken = seconds(&before, &after);
        worst = taken > worst ? taken : worst;
        largest = force > largest ? force : largest;
        total += taken;
        advance(&next, period);
        misses += seconds(&next, &after) > 0.0;
        /* After a miss the rig falls in with the next beat that it can still keep. */
        while (seconds(&next, &after) > 0.0) {
            advance(&next, period);
        }
        wait_for(&next);
    }
    printf("%d Hz: %d cycles of %d us, %llu steps each; computation %.1f us on average, %.1f us at worst;"
           " %d deadline misses; largest force %.1f N\n", rate, cycles, 1000000 / rate, (unsigned long long)steps,
           1e6 * total / cycles, 1e6 * worst, misses, largest);
    return largest > 100.0 ? 0 : 1;
}
