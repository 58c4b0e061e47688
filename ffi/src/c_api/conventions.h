/*
 * Softanvil: deterministic explicit finite element simulation of drop-weight impact on a soft anvil.
 *
 * Generated from the Rust sources of the library; do not edit.
 *
 * A drop in seven calls:
 *
 *     SoftanvilScenario scenario;
 *     SoftanvilSimulation *simulation;
 *     size_t size, alignment;
 *     double peak;
 *
 *     softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario);
 *     softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_DROP_ENERGY, 14.7, NULL);
 *     softanvil_memory_size(&scenario, &size, &alignment, NULL);
 *     void *memory = malloc(size);                          // or static memory of that size
 *     softanvil_init(memory, size, &scenario, &simulation, NULL);
 *     softanvil_run(simulation, 15e-3, NULL, NULL);
 *     softanvil_output(simulation, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE, &peak);
 *
 * Conventions of every function:
 *
 * - Results. A function returns a `SoftanvilStatus`, SOFTANVIL_STATUS_OK or a failure; its documentation lists the
 *   failures without the prefix SOFTANVIL_STATUS_. Results go to out-parameters, which are written only on success. A
 *   `SoftanvilError` takes the details of a failure: what was refused, its value, its unit, its legal range. It is
 *   written only on failure, and may be NULL.
 * - Units are SI throughout. Upwards is positive; the impactor's height is 0 where it touches the undeformed anvil.
 * - Memory. The library owns none and allocates none. Simulations live in memory that the caller lends; structures are
 *   the caller's; strings that are returned are static. Pointers passed in are used during the call and not kept, except
 *   for the memory of a simulation. Arguments of one call must not overlap.
 * - Checks. Null and misaligned pointers, short buffers, uninitialised structures and values that are not legal are
 *   refused with a status. A pointer must otherwise point to what its type says; that no library can check.
 * - Threads. There is no global state. One simulation is used by one thread at a time; any number of simulations run in
 *   parallel. Functions that take only `const` pointers may run at the same time on the same object.
 * - Surroundings. No function uses the heap, files, clocks, locale, errno or signals, and none ends the process. A
 *   floating-point environment that the thread has changed (rounding, flush-to-zero, unmasked exceptions) is set to the
 *   default of C for the time of a call and put back, on x86, aarch64, arm with an FPU, and riscv; on other processors
 *   the caller must not have changed it.
 * - Stability. Numbers and structures keep their meaning and size; later versions add numbers, functions and parameters.
 *   `const` on a pointer means that the object is not changed.
 */

#ifndef SOFTANVIL_H
#define SOFTANVIL_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
