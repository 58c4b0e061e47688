/* The anvil in three dimensions: the same calls as for a section. A snapshot in the middle continues with the same bits, the
 * fields along z are there, and the memory is within its limit. Prints the trace hash.
 *
 *     solid [ELEMENT_SIZE]
 */

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "must.h"
#include "softanvil.h"

/* Bytes that a tetrahedron may take of the memory of a simulation. */
#define BYTES_PER_TETRAHEDRON 1000.0

static void *room(size_t size)
{
    void *memory = malloc(size);
    if (memory == NULL) {
        fprintf(stderr, "no memory for %zu bytes\n", size);
        exit(1);
    }
    return memory;
}

/* Numbers of a component of a field. */
static size_t numbers(const SoftanvilSimulation *simulation, uint32_t field)
{
    SoftanvilView view;
    MUST(softanvil_field_view(simulation, field, 0, &view));
    return view.rows * view.columns;
}

/* Largest displacement along z, m, of whatever sign. */
static double bulge(const SoftanvilSimulation *simulation)
{
    const size_t count = numbers(simulation, SOFTANVIL_FIELD_NODE_DISPLACEMENT_Z);
    double *z = room(count * sizeof *z);
    double largest = 0.0;
    MUST(softanvil_field_read(simulation, SOFTANVIL_FIELD_NODE_DISPLACEMENT_Z, 0, z, count, 1, &error));
    for (size_t i = 0; i < count; i++) {
        const double size = z[i] < 0.0 ? -z[i] : z[i];
        largest = size > largest ? size : largest;
    }
    free(z);
    return largest;
}

int main(int argc, char **argv)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation;
    size_t size, alignment, bytes;
    uint64_t hash = 0, again = 1;
    MUST(softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario));
    MUST(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_GEOMETRY_FORMULATION, SOFTANVIL_GEOMETRY_FORMULATION_SOLID,
                                &error));
    MUST(softanvil_scenario_set_by_name(&scenario, "mesh.element_size", argc > 1 ? atof(argv[1]) : 7.5e-3, &error));
    MUST(softanvil_memory_size(&scenario, &size, &alignment, &error));
    void *memory = room(size);
    MUST(softanvil_init(memory, size, &scenario, &simulation, &error));
    const size_t tetrahedra = numbers(simulation, SOFTANVIL_FIELD_ELEMENT_PRESSURE);
    const double share = (double)size / (double)tetrahedra;

    MUST(softanvil_run(simulation, 5e-3, NULL, &error));
    const double bulged = bulge(simulation);
    MUST(softanvil_snapshot_size(simulation, &bytes));
    unsigned char *saved = room(bytes);
    MUST(softanvil_snapshot_save(simulation, saved, bytes, &error));
    MUST(softanvil_run(simulation, 10e-3, NULL, &error));
    MUST(softanvil_trace_hash(simulation, &hash));
    MUST(softanvil_snapshot_restore(simulation, saved, bytes, &error));
    MUST(softanvil_run(simulation, 10e-3, NULL, &error));
    MUST(softanvil_trace_hash(simulation, &again));

    printf("%zu tetrahedra, %.0f bytes each, %.2f mm along z, hash %016" PRIx64 "\n", tetrahedra, share, 1e3 * bulged, hash);
    free(saved);
    free(memory);
    return hash == again && share <= BYTES_PER_TETRAHEDRON && bulged > 1e-4 ? 0 : 1;
}
