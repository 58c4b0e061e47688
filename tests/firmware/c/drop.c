/*
 * The study's drop with 14.7 J on a Cortex-M7 without an operating system, a heap or a C library: runs it, compares it
 * with the golden trace on the device, and says what it took. The template for a program of your own: see the README.
 */

#include <stddef.h>
#include <stdint.h>

#include "board.h"
#include "softanvil.h"

/* The golden trace as { step, force, position, digest of the state }, written by run.sh. */
static const struct {
    uint64_t step;
    double force;
    double position;
    uint64_t state;
} golden[] = {
#include "golden.inc"
};

enum {
    RECORDS = sizeof golden / sizeof golden[0],
    MEMORY = 72 << 10,
    SNAPSHOT = 44 << 10,
    /* Words of a snapshot around the state: four in front, the checksum behind. */
    SNAPSHOT_HEADER = 32,
    SNAPSHOT_FOOTER = 8
};

/* Memory of the simulation, and of one snapshot, from which the state's digest is taken. */
static _Alignas(64) unsigned char memory[MEMORY];
static uint8_t snapshot[SNAPSHOT];
static SoftanvilError error;

static void must(SoftanvilStatus status)
{
    if (status != SOFTANVIL_STATUS_OK) {
        board_print(error.text);
        board_exit("\na call failed\n", 0);
    }
}

/* FNV-1a, 64 bit, over the numbers of the state. */
static uint64_t state_digest(const SoftanvilSimulation *simulation, size_t size)
{
    uint64_t digest = 0xcbf29ce484222325u;
    must(softanvil_snapshot_save(simulation, snapshot, sizeof snapshot, &error));
    for (size_t i = SNAPSHOT_HEADER; i < size - SNAPSHOT_FOOTER; i++) {
        digest = (digest ^ snapshot[i]) * 0x00000100000001b3u;
    }
    return digest;
}

static double output(const SoftanvilSimulation *simulation, uint32_t id)
{
    double value = 0.0;
    must(softanvil_output(simulation, id, &value));
    return value;
}

/* Whether the simulation is where the trace has it; tells the first quantity that is not. */
static int same_as(int record, const SoftanvilSimulation *simulation, size_t snapshot_size)
{
    uint64_t step = 0;
    const char *quantity = NULL;
    must(softanvil_step_index(simulation, &step));
    if (step != golden[record].step) {
        quantity = "step";
    } else if (output(simulation, SOFTANVIL_OUTPUT_CONTACT_FORCE_STEP) != golden[record].force) {
        quantity = "contact force";
    } else if (output(simulation, SOFTANVIL_OUTPUT_IMPACTOR_POSITION) != golden[record].position) {
        quantity = "position";
    } else if (state_digest(simulation, snapshot_size) != golden[record].state) {
        quantity = "state";
    }
    if (quantity != NULL) {
        board_print("step ");
        board_print_number(step);
        board_print(": ");
        board_print(quantity);
        board_print(" differs from the golden trace\n");
    }
    return quantity == NULL;
}

static void print_line(const char *what, uint64_t number, const char *unit)
{
    board_print(what);
    board_print_number(number);
    board_print(unit);
}

int main(void)
{
    SoftanvilScenario scenario;
    SoftanvilSimulation *simulation = NULL;
    size_t size = 0, alignment = 0, snapshot_size = 0;
    uint32_t least = UINT32_MAX, most = 0;
    uint64_t sum = 0, hash = 0;
    int same = 1;

    must(softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario));
    must(softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_DROP_ENERGY, 14.7, &error));
    must(softanvil_memory_size(&scenario, &size, &alignment, &error));
    must(softanvil_init(memory, sizeof memory, &scenario, &simulation, &error));
    must(softanvil_snapshot_size(simulation, &snapshot_size));
    same = same_as(0, simulation, snapshot_size);
    board_start_counter();
    for (int record = 1; record < RECORDS; record++) {
        for (uint64_t step = golden[record - 1].step; step < golden[record].step; step++) {
            (void)board_ticks();
            must(softanvil_step(simulation, 1, NULL, &error));
            uint32_t ticks = board_ticks();
            least = ticks < least ? ticks : least;
            most = ticks > most ? ticks : most;
            sum += ticks;
        }
        same = same && same_as(record, simulation, snapshot_size);
    }

    must(softanvil_trace_hash(simulation, &hash));
    print_line("peak force ", (uint64_t)output(simulation, SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE), " N, deformation ");
    print_line("", (uint64_t)(1e6 * output(simulation, SOFTANVIL_OUTPUT_RESULT_MAX_DEFORMATION)), " um, ");
    print_line("", golden[RECORDS - 1].step, " steps\nstate ");
    board_print_hex(state_digest(simulation, snapshot_size));
    board_print(", trace ");
    board_print_hex(hash);
    print_line("\nflash ", board_flash(), " bytes, ");
    print_line("static RAM ", board_static_ram(), " bytes, of which ");
    print_line("", size, " bytes simulation\n");
    print_line("stack ", board_stack_high_water(), " bytes at most\n");
    print_line("instructions per step ", sum * INSTRUCTIONS_PER_TICK / golden[RECORDS - 1].step, ", ");
    print_line("from ", (uint64_t)least * INSTRUCTIONS_PER_TICK, " ");
    print_line("to ", (uint64_t)most * INSTRUCTIONS_PER_TICK, "\n");
    board_print(same ? "the bits of the golden trace\n" : "DIFFERENT from the golden trace\n");
    return same ? 0 : 1;
}
