/* Every function with arguments that it must refuse: the status is the right one, no output is written, the error
 * says why, and the simulation still gives the same trace afterwards. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "softanvil.h"

/* Number of a parameter of a layer. */
#define LAYER(layer, name) SOFTANVIL_PARAMETER_OF_LAYER(layer, SOFTANVIL_LAYER_##name)

enum { MEMORY = 1 << 18, SNAPSHOT = 1 << 16, PATTERN = 0xA5 };

/* Everything that calls write to. */
struct outputs {
    SoftanvilScenario scenario;
    SoftanvilInput input;
    SoftanvilParameterInfo parameter_info;
    SoftanvilOutputInfo output_info;
    SoftanvilFieldInfo field_info;
    SoftanvilView view;
    double values[2];
    SoftanvilSimulation *simulation;
    double number;
    uint64_t count;
    size_t size;
    size_t alignment;
    uint32_t id;
    char text[SOFTANVIL_NAME_SIZE];
    uint8_t bytes[SNAPSHOT];
};

static struct outputs out;
static struct outputs untouched;
static SoftanvilError error;
static SoftanvilError no_error;
static _Alignas(64) unsigned char memory[MEMORY];
static _Alignas(64) unsigned char spare[MEMORY];
static _Alignas(64) unsigned char noise[MEMORY];
static uint8_t snapshot[SNAPSHOT];
static int checks;

static void fail(const char *call, const char *what)
{
    fprintf(stderr, "failed: %s: %s\n", call, what);
    exit(1);
}

/* The status is the right one and nothing else was written. */
static void refused(SoftanvilStatus got, SoftanvilStatus wanted, int explained, const char *call)
{
    checks++;
    if (got != wanted) {
        fprintf(stderr, "failed: %s gave %d, not %d\n", call, (int)got, (int)wanted);
        exit(1);
    }
    if (memcmp(&out, &untouched, sizeof out) != 0) {
        fail(call, "an output was written");
    }
    if (explained) {
        if (error.status != wanted || memchr(error.text, 0, sizeof error.text) == NULL || error.text[0] == 0) {
            fail(call, "the error does not explain the status");
        }
    } else if (memcmp(&error, &no_error, sizeof error) != 0) {
        fail(call, "an error was written");
    }
    memset(&error, PATTERN, sizeof error);
}

/* A call that takes no error, or one whose error pointer is the fault. */
#define REFUSE(status, call) refused((call), SOFTANVIL_STATUS_##status, 0, #call)
/* A call that is given &error. */
#define EXPLAIN(status, call) refused((call), SOFTANVIL_STATUS_##status, 1, #call)

static void must(SoftanvilStatus status, const char *call)
{
    if (status != SOFTANVIL_STATUS_OK) {
        fail(call, softanvil_status_text(status));
    }
}
#define MUST(call) must((call), #call)

/* An address that is aligned for nothing. */
static void *odd(void *pointer)
{
    return (unsigned char *)pointer + 1;
}

static SoftanvilScenario study(void)
{
    SoftanvilScenario scenario;
    MUST(softanvil_scenario_default(SOFTANVIL_PRESET_STUDY, &scenario));
    return scenario;
}

static SoftanvilScenario with(uint32_t parameter, double value)
{
    SoftanvilScenario scenario = study();
    scenario.value[parameter] = value;
    return scenario;
}

static SoftanvilSimulation *build(unsigned char *where, const SoftanvilScenario *scenario)
{
    SoftanvilSimulation *simulation;
    MUST(softanvil_init(where, MEMORY, scenario, &simulation, NULL));
    return simulation;
}

/* A trace that no refused call reaches. */
static int32_t unreachable(const SoftanvilSimulation *simulation, void *context)
{
    (void)simulation;
    (void)context;
    fail("softanvil_run_traced", "a refused call has called back");
    return 1;
}

static void tables(void)
{
    char endless[4 * SOFTANVIL_NAME_SIZE];
    memset(endless, 'x', sizeof endless);
    REFUSE(NULL_POINTER, softanvil_parameter_find(NULL, &out.id));
    REFUSE(NULL_POINTER, softanvil_parameter_find("impactor.mass", NULL));
    REFUSE(MISALIGNED, softanvil_parameter_find("impactor.mass", odd(&out.id)));
    REFUSE(UNKNOWN_NAME, softanvil_parameter_find("", &out.id));
    REFUSE(UNKNOWN_NAME, softanvil_parameter_find("impactor.mas", &out.id));
    REFUSE(UNKNOWN_NAME, softanvil_parameter_find("impactor.mass ", &out.id));
    REFUSE(UNKNOWN_NAME, softanvil_parameter_find(endless, &out.id));
    REFUSE(NULL_POINTER, softanvil_output_find(NULL, &out.id));
    REFUSE(NULL_POINTER, softanvil_output_find("contact.force", NULL));
    REFUSE(MISALIGNED, softanvil_output_find("contact.force", odd(&out.id)));
    REFUSE(UNKNOWN_NAME, softanvil_output_find("contact", &out.id));
    REFUSE(UNKNOWN_NAME, softanvil_output_find(endless, &out.id));
    REFUSE(NULL_POINTER, softanvil_parameter_info(0, NULL));
    REFUSE(MISALIGNED, softanvil_parameter_info(0, odd(&out.parameter_info)));
    REFUSE(UNKNOWN_ID, softanvil_parameter_info(SOFTANVIL_PARAMETER_SLOTS, &out.parameter_info));
    REFUSE(UNKNOWN_ID, softanvil_parameter_info(SOFTANVIL_LAYERS_BEGIN - 1, &out.parameter_info));
    REFUSE(UNKNOWN_ID, softanvil_parameter_info(LAYER(SOFTANVIL_MAX_LAYERS, THICKNESS), &out.parameter_info));
    REFUSE(NULL_POINTER, softanvil_parameter_at(0, NULL));
    REFUSE(MISALIGNED, softanvil_parameter_at(0, odd(&out.id)));
    REFUSE(UNKNOWN_ID, softanvil_parameter_at(softanvil_parameter_count(), &out.id));
    REFUSE(NULL_POINTER, softanvil_output_info(0, NULL));
    REFUSE(MISALIGNED, softanvil_output_info(0, odd(&out.output_info)));
    REFUSE(UNKNOWN_ID, softanvil_output_info(SOFTANVIL_NONE, &out.output_info));
    REFUSE(NULL_POINTER, softanvil_field_find(NULL, &out.id));
    REFUSE(NULL_POINTER, softanvil_field_find("node.position", NULL));
    REFUSE(MISALIGNED, softanvil_field_find("node.position", odd(&out.id)));
    REFUSE(UNKNOWN_NAME, softanvil_field_find(endless, &out.id));
    REFUSE(NULL_POINTER, softanvil_field_info(0, NULL));
    REFUSE(MISALIGNED, softanvil_field_info(0, odd(&out.field_info)));
    REFUSE(UNKNOWN_ID, softanvil_field_info(softanvil_field_count(), &out.field_info));
    REFUSE(NULL_POINTER, softanvil_parameter_choice(SOFTANVIL_PARAMETER_IMPACTOR_MOTION, 0, NULL, 8));
    REFUSE(UNKNOWN_ID, softanvil_parameter_choice(SOFTANVIL_NONE, 0, out.text, sizeof out.text));
    REFUSE(UNKNOWN_ID, softanvil_parameter_choice(SOFTANVIL_PARAMETER_IMPACTOR_MOTION, 3, out.text, sizeof out.text));
    REFUSE(UNKNOWN_ID, softanvil_parameter_choice(SOFTANVIL_PARAMETER_IMPACTOR_MASS, 0, out.text, sizeof out.text));
    REFUSE(SHORT_BUFFER, softanvil_parameter_choice(SOFTANVIL_PARAMETER_IMPACTOR_MOTION, 0, out.text, 4));
    REFUSE(SHORT_BUFFER, softanvil_parameter_choice(SOFTANVIL_PARAMETER_IMPACTOR_MOTION, 0, out.text, 0));
    REFUSE(SHORT_BUFFER, softanvil_parameter_choice(SOFTANVIL_PARAMETER_IMPACTOR_MOTION, 0, out.text, SIZE_MAX));
}

static void scenarios(void)
{
    enum { MASS = SOFTANVIL_PARAMETER_IMPACTOR_MASS };
    SoftanvilScenario good = study();
    SoftanvilScenario bad;
    memset(&bad, PATTERN, sizeof bad);
    REFUSE(NULL_POINTER, softanvil_scenario_default(0, NULL));
    REFUSE(MISALIGNED, softanvil_scenario_default(0, odd(&out.scenario)));
    REFUSE(UNKNOWN_ID, softanvil_scenario_default(999, &out.scenario));
    EXPLAIN(NULL_POINTER, softanvil_scenario_set(NULL, MASS, 5.0, &error));
    EXPLAIN(MISALIGNED, softanvil_scenario_set(odd(&bad), MASS, 5.0, &error));
    EXPLAIN(UNINITIALISED, softanvil_scenario_set(&out.scenario, MASS, 5.0, &error));
    EXPLAIN(UNKNOWN_ID, softanvil_scenario_set(&good, SOFTANVIL_PARAMETER_SLOTS, 5.0, &error));
    EXPLAIN(ILLEGAL_VALUE, softanvil_scenario_set(&good, MASS, (double)NAN, &error));
    EXPLAIN(ILLEGAL_VALUE, softanvil_scenario_set(&good, MASS, (double)INFINITY, &error));
    EXPLAIN(ILLEGAL_VALUE, softanvil_scenario_set(&good, MASS, -1.0, &error));
    EXPLAIN(ILLEGAL_VALUE, softanvil_scenario_set(&good, SOFTANVIL_PARAMETER_IMPACTOR_DROP_BY, 0.5, &error));
    REFUSE(MISALIGNED, softanvil_scenario_set(&good, MASS, 5.0, odd(&error)));
    EXPLAIN(NULL_POINTER, softanvil_scenario_set_by_name(NULL, "impactor.mass", 5.0, &error));
    EXPLAIN(NULL_POINTER, softanvil_scenario_set_by_name(&good, NULL, 5.0, &error));
    EXPLAIN(UNKNOWN_NAME, softanvil_scenario_set_by_name(&good, "mass", 5.0, &error));
    EXPLAIN(ILLEGAL_VALUE, softanvil_scenario_set_by_name(&good, "impactor.mass", 0.0, &error));
    REFUSE(NULL_POINTER, softanvil_scenario_get(NULL, MASS, &out.number));
    REFUSE(NULL_POINTER, softanvil_scenario_get(&good, MASS, NULL));
    REFUSE(MISALIGNED, softanvil_scenario_get(&good, MASS, odd(&out.number)));
    REFUSE(UNINITIALISED, softanvil_scenario_get(&bad, MASS, &out.number));
    REFUSE(UNKNOWN_ID, softanvil_scenario_get(&good, SOFTANVIL_NONE, &out.number));
    REFUSE(NULL_POINTER, softanvil_scenario_get_by_name(NULL, "impactor.mass", &out.number));
    REFUSE(NULL_POINTER, softanvil_scenario_get_by_name(&good, NULL, &out.number));
    REFUSE(NULL_POINTER, softanvil_scenario_get_by_name(&good, "impactor.mass", NULL));
    REFUSE(UNKNOWN_NAME, softanvil_scenario_get_by_name(&good, "impactor", &out.number));
    const SoftanvilScenario same = study();
    if (memcmp(&good, &same, sizeof good) != 0) {
        fail("softanvil_scenario_set", "a refused value changed the scenario");
    }
}

/* What the error says about one refused value. */
static void details(void)
{
    SoftanvilScenario scenario = study();
    const SoftanvilStatus status = softanvil_scenario_set(&scenario, SOFTANVIL_PARAMETER_IMPACTOR_MASS, -1.0, &error);
    const char *text = "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg";
    const int right = status == error.status && error.parameter == SOFTANVIL_PARAMETER_IMPACTOR_MASS &&
                      error.element == SOFTANVIL_NONE && error.value == -1.0 && error.min == 1e-3 &&
                      error.max == 1e4 && isnan(error.time) && strcmp(error.text, text) == 0;
    if (!right) {
        fail("softanvil_scenario_set", error.text);
    }
    memset(&error, PATTERN, sizeof error);
    checks++;
}

static SoftanvilStatus init(const SoftanvilScenario *scenario)
{
    return softanvil_init(spare, sizeof spare, scenario, &out.simulation, &error);
}

static SoftanvilStatus size_of(const SoftanvilScenario *scenario)
{
    return softanvil_memory_size(scenario, &out.size, &out.alignment, &error);
}

static void setting_up(void)
{
    const SoftanvilScenario good = study();
    size_t size;
    size_t alignment;
    MUST(softanvil_memory_size(&good, &size, &alignment, NULL));
    EXPLAIN(NULL_POINTER, size_of(NULL));
    EXPLAIN(UNINITIALISED, size_of(&out.scenario));
    EXPLAIN(NULL_POINTER, softanvil_memory_size(&good, NULL, &out.alignment, &error));
    EXPLAIN(NULL_POINTER, softanvil_memory_size(&good, &out.size, NULL, &error));
    EXPLAIN(MISALIGNED, softanvil_memory_size(&good, odd(&out.size), &out.alignment, &error));
    REFUSE(MISALIGNED, softanvil_memory_size(&good, &out.size, &out.alignment, odd(&error)));
    EXPLAIN(NULL_POINTER, softanvil_init(NULL, MEMORY, &good, &out.simulation, &error));
    EXPLAIN(MISALIGNED, softanvil_init(odd(spare), MEMORY - 1, &good, &out.simulation, &error));
    EXPLAIN(MISALIGNED, softanvil_init(spare + 4, MEMORY - 4, &good, &out.simulation, &error));
    EXPLAIN(SHORT_BUFFER, softanvil_init(spare, size - 1, &good, &out.simulation, &error));
    EXPLAIN(SHORT_BUFFER, softanvil_init(spare, 0, &good, &out.simulation, &error));
    EXPLAIN(NULL_POINTER, softanvil_init(spare, MEMORY, NULL, &out.simulation, &error));
    EXPLAIN(NULL_POINTER, softanvil_init(spare, MEMORY, &good, NULL, &error));
    EXPLAIN(UNINITIALISED, init(&out.scenario));
    if (memcmp(spare, noise, sizeof spare) != 0) {
        fail("softanvil_init", "refused memory was written to");
    }
}

/* Scenarios whose values, or their combination, are illegal. */
static void illegal_scenarios(void)
{
    static const struct {
        uint32_t parameter;
        double value;
        SoftanvilStatus status;
    } cases[] = {
        { SOFTANVIL_PARAMETER_IMPACTOR_MASS, (double)NAN, SOFTANVIL_STATUS_ILLEGAL_VALUE },
        { SOFTANVIL_PARAMETER_IMPACTOR_MOTION, 7.0, SOFTANVIL_STATUS_ILLEGAL_VALUE },
        { LAYER(0, PRONY_G_2), 0.9, SOFTANVIL_STATUS_PRONY_SUM },
        { LAYER(0, C10), -1e6, SOFTANVIL_STATUS_SHEAR_MODULUS },
        { SOFTANVIL_PARAMETER_IMPACTOR_FACE_DIAMETER, 5e-3, SOFTANVIL_STATUS_FACE_TOO_SMALL },
        { SOFTANVIL_PARAMETER_MESH_ELEMENT_SIZE, 1e-5, SOFTANVIL_STATUS_TOO_MANY_CELLS },
        { LAYER(0, PRONY_TAU_2), 0.1, SOFTANVIL_STATUS_NO_EFFECT },
        { LAYER(3, DENSITY), 900.0, SOFTANVIL_STATUS_NO_EFFECT },
        { SOFTANVIL_PARAMETER_LAYERS_COUNT, 2.0, SOFTANVIL_STATUS_LAYER_THICKNESS },
        { SOFTANVIL_PARAMETER_LAYERS_COUNT, 5.0, SOFTANVIL_STATUS_ILLEGAL_VALUE },
        { SOFTANVIL_PARAMETER_SLOTS - 1, 1.0, SOFTANVIL_STATUS_RESERVED_SLOT },
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const SoftanvilScenario scenario = with(cases[i].parameter, cases[i].value);
        refused(size_of(&scenario), cases[i].status, 1, "softanvil_memory_size of an illegal scenario");
        refused(init(&scenario), cases[i].status, 1, "softanvil_init of an illegal scenario");
    }
    SoftanvilScenario stiff = with(LAYER(0, BULK_MODULUS), 1e12);
    stiff.value[LAYER(0, VOLUMETRIC_BY)] = SOFTANVIL_LAYER_VOLUMETRIC_BY_BULK_MODULUS;
    stiff.value[LAYER(0, DENSITY)] = 10.0;
    stiff.value[SOFTANVIL_PARAMETER_TIME_SAFETY_FACTOR] = 0.01;
    EXPLAIN(STEP_TOO_SMALL, init(&stiff));
    SoftanvilScenario slow = with(SOFTANVIL_PARAMETER_TIME_STEP_BY, SOFTANVIL_TIME_STEP_BY_GIVEN);
    slow.value[SOFTANVIL_PARAMETER_TIME_STEP] = 5e-5;
    EXPLAIN(STEP_TOO_LARGE, init(&slow));
    SoftanvilScenario twice = with(SOFTANVIL_PARAMETER_IMPACTOR_DROP_HEIGHT, 0.1);
    twice.value[SOFTANVIL_PARAMETER_IMPACTOR_DROP_ENERGY] = 9.8;
    EXPLAIN(CONTRADICTION, init(&twice));
    memset(spare, PATTERN, sizeof spare);
}

/* Reading from `s`, which gives `STATUS`, into good places. */
#define READ_ALL(STATUS, s)                                                        \
    do {                                                                           \
        REFUSE(STATUS, softanvil_output((s), 0, &out.number));                     \
        REFUSE(STATUS, softanvil_output_by_name((s), "contact.force", &out.number)); \
        REFUSE(STATUS, softanvil_time((s), &out.number));                          \
        REFUSE(STATUS, softanvil_dt((s), &out.number));                            \
        REFUSE(STATUS, softanvil_step_index((s), &out.count));                     \
        REFUSE(STATUS, softanvil_steps_per_sample((s), &out.count));               \
        REFUSE(STATUS, softanvil_trace_hash((s), &out.count));                     \
        REFUSE(STATUS, softanvil_snapshot_size((s), &out.size));                   \
        REFUSE(STATUS, softanvil_input_default((s), &out.input));                  \
        REFUSE(STATUS, softanvil_field_view((s), 0, 0, &out.view));                \
        EXPLAIN(STATUS, softanvil_field_read((s), 0, 0, out.values, 2, 1, &error)); \
        EXPLAIN(STATUS, softanvil_snapshot_save((s), out.bytes, sizeof out.bytes, &error)); \
    } while (0)

/* Changing `s`, which gives `STATUS`. */
#define CHANGE_ALL(STATUS, s)                                                             \
    do {                                                                                  \
        REFUSE(STATUS, softanvil_close(s));                                               \
        REFUSE(STATUS, softanvil_reset(s));                                               \
        EXPLAIN(STATUS, softanvil_next_impact((s), 60.0, &error));                        \
        EXPLAIN(STATUS, softanvil_step((s), 1, NULL, &error));                            \
        EXPLAIN(STATUS, softanvil_step_to_sample((s), NULL, &error));                     \
        EXPLAIN(STATUS, softanvil_run((s), 1e-3, NULL, &error));                          \
        EXPLAIN(STATUS, softanvil_run_until((s), 1e-3, NULL, &error));                    \
        EXPLAIN(STATUS, softanvil_run_traced((s), 1e-3, NULL, unreachable, NULL, &error)); \
        EXPLAIN(STATUS, softanvil_snapshot_restore((s), snapshot, sizeof snapshot, &error)); \
    } while (0)

/* Null, misaligned, never initialised, closed. */
static void bad_simulations(SoftanvilSimulation *good)
{
    SoftanvilSimulation *misaligned = odd(good);
    SoftanvilSimulation *garbage = (SoftanvilSimulation *)(void *)noise;
    const SoftanvilScenario scenario = study();
    SoftanvilSimulation *closed = build(spare, &scenario);
    MUST(softanvil_close(closed));
    READ_ALL(NULL_POINTER, NULL);
    CHANGE_ALL(NULL_POINTER, NULL);
    READ_ALL(MISALIGNED, misaligned);
    CHANGE_ALL(MISALIGNED, misaligned);
    READ_ALL(UNINITIALISED, garbage);
    CHANGE_ALL(UNINITIALISED, garbage);
    READ_ALL(UNINITIALISED, closed);
    CHANGE_ALL(UNINITIALISED, closed);
}

static void reading(const SoftanvilSimulation *good)
{
    REFUSE(NULL_POINTER, softanvil_output(good, 0, NULL));
    REFUSE(MISALIGNED, softanvil_output(good, 0, odd(&out.number)));
    REFUSE(UNKNOWN_ID, softanvil_output(good, softanvil_output_count(), &out.number));
    REFUSE(NULL_POINTER, softanvil_output_by_name(good, NULL, &out.number));
    REFUSE(NULL_POINTER, softanvil_output_by_name(good, "contact.force", NULL));
    REFUSE(UNKNOWN_NAME, softanvil_output_by_name(good, "force", &out.number));
    REFUSE(NULL_POINTER, softanvil_time(good, NULL));
    REFUSE(MISALIGNED, softanvil_time(good, odd(&out.number)));
    REFUSE(NULL_POINTER, softanvil_dt(good, NULL));
    REFUSE(NULL_POINTER, softanvil_step_index(good, NULL));
    REFUSE(MISALIGNED, softanvil_step_index(good, odd(&out.count)));
    REFUSE(NULL_POINTER, softanvil_steps_per_sample(good, NULL));
    REFUSE(NULL_POINTER, softanvil_trace_hash(good, NULL));
    REFUSE(NULL_POINTER, softanvil_snapshot_size(good, NULL));
    REFUSE(NULL_POINTER, softanvil_input_default(good, NULL));
    REFUSE(MISALIGNED, softanvil_input_default(good, odd(&out.input)));
    REFUSE(NULL_POINTER, softanvil_field_view(good, 0, 0, NULL));
    REFUSE(MISALIGNED, softanvil_field_view(good, 0, 0, odd(&out.view)));
    REFUSE(UNKNOWN_ID, softanvil_field_view(good, softanvil_field_count(), 0, &out.view));
    REFUSE(UNKNOWN_ID, softanvil_field_view(good, 0, 2, &out.view));
    EXPLAIN(NULL_POINTER, softanvil_field_read(good, 0, 0, NULL, 2, 1, &error));
    EXPLAIN(MISALIGNED, softanvil_field_read(good, 0, 0, odd(out.values), 1, 1, &error));
    EXPLAIN(SHORT_BUFFER, softanvil_field_read(good, 0, 0, out.values, 2, 1, &error));
    EXPLAIN(SHORT_BUFFER, softanvil_field_read(good, 0, 0, out.values, 2, SIZE_MAX, &error));
    EXPLAIN(SHORT_BUFFER, softanvil_field_read(good, 0, 0, out.values, SIZE_MAX, 1, &error));
    EXPLAIN(UNKNOWN_ID, softanvil_field_read(good, SOFTANVIL_NONE, 0, out.values, 2, 1, &error));
    EXPLAIN(UNKNOWN_ID, softanvil_field_read(good, 0, SOFTANVIL_NONE, out.values, 2, 1, &error));
}

static void stepping(SoftanvilSimulation *good)
{
    SoftanvilInput input;
    REFUSE(MISALIGNED, softanvil_step(good, 1, NULL, odd(&error)));
    EXPLAIN(MISALIGNED, softanvil_step(good, 1, odd(&out.input), &error));
    EXPLAIN(UNINITIALISED, softanvil_step(good, 1, &out.input, &error));
    EXPLAIN(UNINITIALISED, softanvil_step_to_sample(good, &out.input, &error));
    MUST(softanvil_input_default(good, &input));
    input.external_force = (double)NAN;
    EXPLAIN(ILLEGAL_INPUT, softanvil_step(good, 1, &input, &error));
    MUST(softanvil_input_default(good, &input));
    input.driven_position = (double)INFINITY;
    EXPLAIN(ILLEGAL_INPUT, softanvil_step_to_sample(good, &input, &error));
    /* What acts has a range; what does not may be any number. */
    MUST(softanvil_input_default(good, &input));
    input.external_force = 1e300;
    input.driven_position = 5.0;
    EXPLAIN(ILLEGAL_INPUT, softanvil_step(good, 3, &input, &error));
    softanvil_step(good, 3, &input, &error);
    if (error.value != 1e300 || error.min != -1e6 || error.max != 1e6 || strstr(error.text, "external_force") == NULL
        || strstr(error.text, " N ") == NULL) {
        fail("softanvil_step", "the error does not tell input, value, unit and range");
    }
    input.external_force = 0.0;
    MUST(softanvil_step(good, 3, &input, NULL));
    memset(&error, PATTERN, sizeof error);
    MUST(softanvil_input_default(good, &input));
    input.reserved[3] = 1.0;
    EXPLAIN(RESERVED_SLOT, softanvil_step(good, 1, &input, &error));
    EXPLAIN(ILLEGAL_VALUE, softanvil_run(good, (double)NAN, NULL, &error));
    EXPLAIN(ILLEGAL_VALUE, softanvil_run(good, -1.0, NULL, &error));
    EXPLAIN(ILLEGAL_VALUE, softanvil_run(good, 1e300, NULL, &error));
    double now = 0.0, dt = 0.0;
    MUST(softanvil_time(good, &now));
    MUST(softanvil_dt(good, &dt));
    EXPLAIN(ILLEGAL_TIME, softanvil_run_until(good, (double)NAN, NULL, &error));
    EXPLAIN(ILLEGAL_TIME, softanvil_run_until(good, (double)INFINITY, NULL, &error));
    EXPLAIN(ILLEGAL_TIME, softanvil_run_until(good, now - 0.6 * dt, NULL, &error));
    EXPLAIN(ILLEGAL_TIME, softanvil_run_until(good, now + 100.1, NULL, &error));
    softanvil_run_until(good, now + 100.1, NULL, &error);
    if (error.value != now + 100.1 || error.min > now || error.max < now + 99.0) {
        fail("softanvil_run_until", "the error does not tell what is legal");
    }
    memset(&error, PATTERN, sizeof error);
    EXPLAIN(UNINITIALISED, softanvil_run_until(good, now, &out.input, &error));
    MUST(softanvil_run_until(good, now - 0.4 * dt, NULL, NULL));
    EXPLAIN(NULL_POINTER, softanvil_run_traced(good, 1e-3, NULL, NULL, NULL, &error));
    EXPLAIN(UNINITIALISED, softanvil_run_traced(good, 1e-3, &out.input, unreachable, NULL, &error));
    EXPLAIN(ILLEGAL_VALUE, softanvil_run_traced(good, (double)NAN, NULL, unreachable, NULL, &error));
    MUST(softanvil_step(good, 0, NULL, NULL));
}

static void snapshots(SoftanvilSimulation *good)
{
    size_t size;
    MUST(softanvil_snapshot_size(good, &size));
    MUST(softanvil_snapshot_save(good, snapshot, sizeof snapshot, NULL));
    EXPLAIN(NULL_POINTER, softanvil_snapshot_save(good, NULL, size, &error));
    EXPLAIN(SHORT_BUFFER, softanvil_snapshot_save(good, out.bytes, size - 1, &error));
    EXPLAIN(SHORT_BUFFER, softanvil_snapshot_save(good, out.bytes, 0, &error));
    EXPLAIN(NULL_POINTER, softanvil_snapshot_restore(good, NULL, size, &error));
    EXPLAIN(SHORT_BUFFER, softanvil_snapshot_restore(good, snapshot, size - 1, &error));
    EXPLAIN(SNAPSHOT_FORMAT, softanvil_snapshot_restore(good, out.bytes, size, &error));
    /* One of another format version, which may be shorter, is named by its number. */
    snapshot[8] ^= 1;
    (void)softanvil_snapshot_restore(good, snapshot, size - 8, &error);
    if (error.value != (double)snapshot[8] || error.min != (double)(snapshot[8] ^ 1)) {
        fail("softanvil_snapshot_restore", "the version of the snapshot is not told");
    }
    EXPLAIN(SNAPSHOT_FORMAT, softanvil_snapshot_restore(good, snapshot, size - 8, &error));
    snapshot[8] ^= 1;
    for (size_t at = 32; at < size; at += 977) {
        snapshot[at] ^= 1;
        EXPLAIN(SNAPSHOT_CORRUPT, softanvil_snapshot_restore(good, snapshot, size, &error));
        snapshot[at] ^= 1;
    }
    const SoftanvilScenario other = with(SOFTANVIL_PARAMETER_IMPACTOR_MASS, 6.0);
    SoftanvilSimulation *foreign = build(spare, &other);
    EXPLAIN(SNAPSHOT_FOREIGN, softanvil_snapshot_restore(foreign, snapshot, size, &error));
    MUST(softanvil_close(foreign));
}

/* Impacts one after the other: without damage and overstress each is the first again; what is no time changes nothing. */
static void impacts(void)
{
    const double illegal[] = {-1.0, NAN, INFINITY, 2e9};
    SoftanvilScenario elastic;
    SoftanvilSimulation *simulation;
    double time;
    uint64_t wanted, found;
    MUST(softanvil_scenario_default(SOFTANVIL_PRESET_ELASTIC, &elastic));
    simulation = build(spare, &elastic);
    MUST(softanvil_run(simulation, 10e-3, NULL, NULL));
    MUST(softanvil_trace_hash(simulation, &wanted));
    for (size_t i = 0; i < sizeof illegal / sizeof *illegal; i++) {
        EXPLAIN(ILLEGAL_INPUT, softanvil_next_impact(simulation, illegal[i], &error));
    }
    MUST(softanvil_time(simulation, &time));
    MUST(softanvil_trace_hash(simulation, &found));
    if (time != 10e-3 || found != wanted) {
        fail("softanvil_next_impact", "a refused rest changed something");
    }
    MUST(softanvil_next_impact(simulation, 60.0, &error));
    MUST(softanvil_time(simulation, &time));
    MUST(softanvil_run(simulation, 10e-3, NULL, NULL));
    MUST(softanvil_trace_hash(simulation, &found));
    if (time != 0.0 || found != wanted) {
        fail("softanvil_next_impact", "an elastic anvil is not as it was");
    }
    MUST(softanvil_close(simulation));
}

/* To absolute times, whatever lies between them: as one run, never more than half a step away, with no step for the
 * shortest; a tie goes up. A driven face moves evenly. */
static void times(void)
{
    const double lengths[] = {1.0 / 60.0, 30e-6, 1e-6, 1.4142135623730951e-5, 3.141592653589793e-6, 15e-3 / 500};
    const SoftanvilScenario falling = study();
    const SoftanvilScenario driven = with(SOFTANVIL_PARAMETER_IMPACTOR_MOTION, SOFTANVIL_IMPACTOR_MOTION_DRIVEN);
    SoftanvilSimulation *simulation = build(spare, &falling);
    SoftanvilInput input;
    double dt, time, height;
    uint64_t wanted, found;
    MUST(softanvil_dt(simulation, &dt));
    MUST(softanvil_run(simulation, 15e-3, NULL, NULL));
    MUST(softanvil_trace_hash(simulation, &wanted));
    for (size_t i = 0; i <= sizeof lengths / sizeof *lengths; i++) {
        /* Last, lengths without a pattern. */
        uint32_t dice = 1;
        double asked = 0.0;
        MUST(softanvil_reset(simulation));
        while (asked < 15e-3) {
            dice = 1664525u * dice + 1013904223u;
            asked += i < sizeof lengths / sizeof *lengths ? lengths[i] : 3e-5 * (double)dice / 4294967296.0;
            asked = asked < 15e-3 ? asked : 15e-3;
            MUST(softanvil_run_until(simulation, asked, NULL, &error));
            MUST(softanvil_time(simulation, &time));
            if (!(fabs(time - asked) <= 0.5 * dt + 1e-14)) {
                fail("softanvil_run_until", "more than half a step away");
            }
        }
        MUST(softanvil_trace_hash(simulation, &found));
        if (found != wanted || time != 15e-3) {
            fail("softanvil_run_until", "another trace than that of one run");
        }
    }
    MUST(softanvil_reset(simulation));
    MUST(softanvil_run_until(simulation, 0.49 * dt, NULL, NULL));
    MUST(softanvil_step_index(simulation, &found));
    MUST(softanvil_run_until(simulation, 1.5 * dt, NULL, NULL));
    MUST(softanvil_step_index(simulation, &wanted));
    if (found != 0 || wanted != 2) {
        fail("softanvil_run_until", "not the nearest step, or a tie that goes down");
    }
    MUST(softanvil_close(simulation));
    simulation = build(spare, &driven);
    MUST(softanvil_dt(simulation, &dt));
    MUST(softanvil_input_default(simulation, &input));
    const double top = input.driven_position;
    for (int i = 1; i <= 100; i++) {
        /* The position belongs to the step that is nearest. */
        const double nearest = floor(i * 30e-6 / dt + 0.5) * dt;
        input.driven_position = top - nearest;
        MUST(softanvil_run_until(simulation, i * 30e-6, &input, NULL));
        MUST(softanvil_output(simulation, SOFTANVIL_OUTPUT_IMPACTOR_POSITION, &height));
        if (!(fabs(height - (top - nearest)) < 1e-15)) {
            fail("softanvil_run_until", "the face is not where it was driven to");
        }
        MUST(softanvil_output(simulation, SOFTANVIL_OUTPUT_IMPACTOR_VELOCITY, &height));
        if (i > 1 && !(fabs(height + 1.0) < 1e-6)) {
            fail("softanvil_run_until", "the face did not move evenly");
        }
    }
    MUST(softanvil_close(simulation));
}

/* The height of a driven face, and its velocity. */
static double height_of(const SoftanvilSimulation *simulation, double *velocity)
{
    double height = 0.0;
    MUST(softanvil_output(simulation, SOFTANVIL_OUTPUT_IMPACTOR_POSITION, &height));
    MUST(softanvil_output(simulation, SOFTANVIL_OUTPUT_IMPACTOR_VELOCITY, velocity));
    return height;
}

static int note_height(const SoftanvilSimulation *simulation, void *heights)
{
    double velocity, time;
    MUST(softanvil_time(simulation, &time));
    const int sample = (int)(time / 50e-6 + 0.5);
    ((double *)heights)[sample] = height_of(simulation, &velocity);
    return 0;
}

/* Whatever the call, a driven face is where its input says after the last step, moves there without a jump, and is told to be
 * as fast as it is; an input that is refused makes no step and stops nothing. */
static void driven(void)
{
    const SoftanvilScenario scenario = with(SOFTANVIL_PARAMETER_IMPACTOR_MOTION, SOFTANVIL_IMPACTOR_MOTION_DRIVEN);
    SoftanvilSimulation *simulation = build(spare, &scenario);
    SoftanvilInput input;
    double dt, velocity, heights[8] = {0};
    uint64_t before, after;
    MUST(softanvil_dt(simulation, &dt));
    MUST(softanvil_input_default(simulation, &input));
    const double top = height_of(simulation, &velocity);
    /* 1 m/s from the first step on, and a stop. */
    input.driven_position = top - 7.0 * dt;
    MUST(softanvil_step(simulation, 7, &input, NULL));
    if (height_of(simulation, &velocity) != input.driven_position || !(fabs(velocity + 1.0) < 1e-9)) {
        fail("softanvil_step", "not on a straight line to the end of the call");
    }
    MUST(softanvil_step(simulation, 5, NULL, NULL));
    if (height_of(simulation, &velocity) != input.driven_position || velocity != 0.0) {
        fail("softanvil_step", "without an input the face does not stay");
    }
    /* With a velocity: a cubic, half way at the mean of both ends and an eighth of the difference of the velocities. */
    MUST(softanvil_reset(simulation));
    MUST(softanvil_input_default(simulation, &input));
    input.driven_velocity = -2.0;
    input.driven_position = top - 200e-6;
    MUST(softanvil_run_traced(simulation, 200e-6, &input, note_height, heights, NULL));
    if (height_of(simulation, &velocity) != input.driven_position || velocity != -2.0
        || !(fabs(heights[2] - (top - 100e-6 + 200e-6 * 2.0 / 8.0)) < 1e-15)) {
        fail("softanvil_run_traced", "not along the cubic to the end of the run");
    }
    MUST(softanvil_step_index(simulation, &before));
    const double bad[][2] = {{(double)NAN, 0.0}, {1.1, 0.0}, {-1e300, 0.0}, {0.0, 101.0}, {0.0, (double)-INFINITY}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        input.driven_position = bad[i][0];
        input.driven_velocity = bad[i][1];
        EXPLAIN(ILLEGAL_INPUT, softanvil_step(simulation, 2, &input, &error));
        EXPLAIN(ILLEGAL_INPUT, softanvil_step_to_sample(simulation, &input, &error));
        EXPLAIN(ILLEGAL_INPUT, softanvil_run(simulation, 1e-3, &input, &error));
        EXPLAIN(ILLEGAL_INPUT, softanvil_run_until(simulation, 1e-3, &input, &error));
        EXPLAIN(ILLEGAL_INPUT, softanvil_run_traced(simulation, 1e-3, &input, note_height, heights, &error));
    }
    MUST(softanvil_step_index(simulation, &after));
    MUST(softanvil_step(simulation, 1, NULL, NULL));
    if (before != after) {
        fail("softanvil_step", "an input that is refused made a step");
    }
    MUST(softanvil_close(simulation));
}

/* A step that fails stops the simulation until it is restored. */
static void failed_step(void)
{
    const SoftanvilScenario driven = with(SOFTANVIL_PARAMETER_IMPACTOR_MOTION, SOFTANVIL_IMPACTOR_MOTION_DRIVEN);
    SoftanvilSimulation *simulation = build(spare, &driven);
    SoftanvilInput input;
    SoftanvilStatus status;
    MUST(softanvil_step(simulation, 10, NULL, NULL));
    MUST(softanvil_snapshot_save(simulation, snapshot, sizeof snapshot, NULL));
    MUST(softanvil_input_default(simulation, &input));
    input.driven_position = -0.05;
    status = softanvil_step(simulation, 1000, &input, &error);
    if (status != SOFTANVIL_STATUS_INVERTED && status != SOFTANVIL_STATUS_UNSTABLE) {
        fail("softanvil_step", "an impossible position was not refused");
    }
    if (error.element == SOFTANVIL_NONE || isnan(error.time)) {
        fail("softanvil_step", "the error names neither element nor time");
    }
    refused(softanvil_step(simulation, 1, NULL, &error), status, 1, "softanvil_step after a failure");
    EXPLAIN(SNAPSHOT_FAILED, softanvil_snapshot_save(simulation, out.bytes, sizeof out.bytes, &error));
    MUST(softanvil_snapshot_restore(simulation, snapshot, sizeof snapshot, NULL));
    MUST(softanvil_step(simulation, 1, NULL, NULL));
}

static uint64_t trace(SoftanvilSimulation *simulation)
{
    uint64_t hash;
    MUST(softanvil_run(simulation, 2e-3, NULL, NULL));
    MUST(softanvil_trace_hash(simulation, &hash));
    return hash;
}

int main(void)
{
    memset(&out, PATTERN, sizeof out);
    memset(&untouched, PATTERN, sizeof untouched);
    memset(&error, PATTERN, sizeof error);
    memset(&no_error, PATTERN, sizeof no_error);
    memset(spare, PATTERN, sizeof spare);
    memset(noise, PATTERN, sizeof noise);
    const SoftanvilScenario scenario = study();
    const uint64_t undisturbed = trace(build(memory, &scenario));
    SoftanvilSimulation *simulation = build(memory, &scenario);
    tables();
    scenarios();
    details();
    setting_up();
    illegal_scenarios();
    bad_simulations(simulation);
    reading(simulation);
    stepping(simulation);
    snapshots(simulation);
    impacts();
    times();
    driven();
    failed_step();
    if (trace(simulation) != undisturbed) {
        fail("trace", "refused calls have changed the simulation");
    }
    printf("%d faults refused\n", checks);
    return 0;
}
