/* A master whose floating-point environment is not the default one: in every environment of tests/c/host_environment.h it
 * takes an instance of either version of FMI through a drop, with its environment set before each call. The trace, the
 * results and the saved state must be those of the default environment, and after each call the master must find its
 * environment as it left it. Prints the trace hash. */
#include <math.h>

#include "../c/host_environment.h"
#include "check.h"
#include "fmi2Functions.h"
#include "fmi3Functions.h"
#include "load.h"

/* Pointers of the headers' types, filled from the library by name. */
#define FUNCTIONS(X)                                                                                          \
    X(fmi2Instantiate) X(fmi2FreeInstance) X(fmi2SetupExperiment) X(fmi2EnterInitializationMode)               \
    X(fmi2ExitInitializationMode) X(fmi2Terminate) X(fmi2Reset) X(fmi2GetReal) X(fmi2SetReal) X(fmi2GetString) \
    X(fmi2GetFMUstate) X(fmi2SetFMUstate) X(fmi2FreeFMUstate) X(fmi2SerializedFMUstateSize)                    \
    X(fmi2SerializeFMUstate) X(fmi2DeSerializeFMUstate) X(fmi2DoStep)                                          \
    X(fmi3InstantiateCoSimulation) X(fmi3FreeInstance) X(fmi3EnterInitializationMode)                          \
    X(fmi3ExitInitializationMode) X(fmi3Terminate) X(fmi3Reset) X(fmi3GetFloat64) X(fmi3SetFloat64)            \
    X(fmi3GetString) X(fmi3GetFMUState) X(fmi3SetFMUState) X(fmi3FreeFMUState) X(fmi3SerializedFMUStateSize)   \
    X(fmi3SerializeFMUState) X(fmi3DeserializeFMUState) X(fmi3DoStep)

static struct {
#define POINTER(name) name##TYPE *name;
    FUNCTIONS(POINTER)
} fmu;

enum { ENERGY = 1014, FORCE = 3000, PEAK = 3007, HASH = 5001, STATE = 1 << 17 };

/* What a drop leaves behind. */
struct outcome {
    char hash[17];
    double force, peak;
    size_t size;
    unsigned char state[STATE];
};

static void *allocate(size_t count, size_t size) { return calloc(count, size); }

/* A call in the environment, after which the default is back; its arguments must need no arithmetic. */
#define CALL(call)                                              \
    do {                                                        \
        write_control(environment);                             \
        int status = (int)(call);                               \
        control left = read_control();                          \
        write_control(environments[0].value);                   \
        CHECK(status == 0);                                     \
        CHECK(same_environment(left, environment));             \
    } while (0)

/* A call that gives nothing, or a pointer. */
#define PLAIN_CALL(call)                                        \
    do {                                                        \
        write_control(environment);                             \
        call;                                                   \
        control left = read_control();                          \
        write_control(environments[0].value);                   \
        CHECK(same_environment(left, environment));             \
    } while (0)

static void drop2(control environment, const char *guid, int samples, struct outcome *outcome)
{
    const fmi2CallbackFunctions callbacks = { NULL, allocate, free, NULL, NULL };
    const fmi2ValueReference force = FORCE, peak = PEAK, hash = HASH, energy = ENERGY;
    fmi2String text = "";
    fmi2FMUstate state = NULL, copy = NULL;
    fmi2Real stated = 14.7;
    fmi2Component c = NULL;
    PLAIN_CALL(c = fmu.fmi2Instantiate("impact", fmi2CoSimulation, guid, NULL, &callbacks, 0, 0));
    if (c == NULL) exit(1);
    /* Twice, of which the first ends early. */
    for (int turn = 0; turn < 2; turn++) {
        CALL(fmu.fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2True, 0.015));
        CALL(fmu.fmi2SetReal(c, &energy, 1, &stated));
        CALL(fmu.fmi2EnterInitializationMode(c));
        CALL(fmu.fmi2ExitInitializationMode(c));
        for (int i = 0; i < (turn == 0 ? 2 : samples); i++) {
            volatile double time = i * 50e-6;
            CALL(fmu.fmi2DoStep(c, time, 50e-6, fmi2True));
        }
        if (turn == 0) CALL(fmu.fmi2Reset(c));
    }
    CALL(fmu.fmi2GetReal(c, &force, 1, &outcome->force));
    CALL(fmu.fmi2GetReal(c, &peak, 1, &outcome->peak));
    CALL(fmu.fmi2GetFMUstate(c, &state));
    CALL(fmu.fmi2SerializedFMUstateSize(c, state, &outcome->size));
    CHECK(outcome->size <= STATE);
    CALL(fmu.fmi2SerializeFMUstate(c, state, (fmi2Byte *)outcome->state, outcome->size));
    CALL(fmu.fmi2DeSerializeFMUstate(c, (const fmi2Byte *)outcome->state, outcome->size, &copy));
    CALL(fmu.fmi2SetFMUstate(c, copy));
    CALL(fmu.fmi2GetString(c, &hash, 1, &text));
    snprintf(outcome->hash, sizeof outcome->hash, "%s", text);
    CALL(fmu.fmi2FreeFMUstate(c, &state));
    CALL(fmu.fmi2FreeFMUstate(c, &copy));
    CALL(fmu.fmi2Terminate(c));
    PLAIN_CALL(fmu.fmi2FreeInstance(c));
}

static void drop3(control environment, const char *token, int samples, struct outcome *outcome)
{
    const fmi3ValueReference force = FORCE, peak = PEAK, hash = HASH, energy = ENERGY;
    fmi3Boolean event, terminate, early;
    fmi3Float64 reached;
    fmi3String text = "";
    fmi3FMUState state = NULL, copy = NULL;
    fmi3Float64 stated = 14.7;
    fmi3Instance c = NULL;
    PLAIN_CALL(c = fmu.fmi3InstantiateCoSimulation("impact", token, NULL, 0, 0, 0, 0, NULL, 0, NULL, NULL, NULL));
    if (c == NULL) exit(1);
    for (int turn = 0; turn < 2; turn++) {
        CALL(fmu.fmi3SetFloat64(c, &energy, 1, &stated, 1));
        CALL(fmu.fmi3EnterInitializationMode(c, fmi3False, 0.0, 0.0, fmi3True, 0.015));
        CALL(fmu.fmi3ExitInitializationMode(c));
        for (int i = 0; i < (turn == 0 ? 2 : samples); i++) {
            volatile double time = i * 50e-6;
            CALL(fmu.fmi3DoStep(c, time, 50e-6, fmi3True, &event, &terminate, &early, &reached));
            CHECK(fabs(reached - time - 50e-6) < 1e-12);
        }
        if (turn == 0) CALL(fmu.fmi3Reset(c));
    }
    CALL(fmu.fmi3GetFloat64(c, &force, 1, &outcome->force, 1));
    CALL(fmu.fmi3GetFloat64(c, &peak, 1, &outcome->peak, 1));
    CALL(fmu.fmi3GetFMUState(c, &state));
    CALL(fmu.fmi3SerializedFMUStateSize(c, state, &outcome->size));
    CHECK(outcome->size <= STATE);
    CALL(fmu.fmi3SerializeFMUState(c, state, outcome->state, outcome->size));
    CALL(fmu.fmi3DeserializeFMUState(c, outcome->state, outcome->size, &copy));
    CALL(fmu.fmi3SetFMUState(c, copy));
    CALL(fmu.fmi3GetString(c, &hash, 1, &text, 1));
    snprintf(outcome->hash, sizeof outcome->hash, "%s", text);
    CALL(fmu.fmi3FreeFMUState(c, &state));
    CALL(fmu.fmi3FreeFMUState(c, &copy));
    CALL(fmu.fmi3Terminate(c));
    PLAIN_CALL(fmu.fmi3FreeInstance(c));
}

typedef void drop(control environment, const char *token, int samples, struct outcome *outcome);

/* The outcome of every environment against that of the default one. */
static void sweep(drop *drop, const char *token, int samples, struct outcome *wanted)
{
    static struct outcome found;
    for (int i = 0; i < ENVIRONMENTS; i++) {
        struct outcome *outcome = i == 0 ? wanted : &found;
        const int before = failures;
        memset(outcome, 0, sizeof *outcome);
        drop(environments[i].value, token, samples, outcome);
        CHECK(memcmp(outcome, wanted, sizeof *wanted) == 0);
        if (failures > before) fprintf(stderr, "in the environment: %s\n", environments[i].name);
    }
}

int main(int argc, char **argv)
{
    static struct outcome two, three;
    if (argc != 4) {
        fprintf(stderr, "usage: %s LIBRARY TOKEN SAMPLES\n", argv[0]);
        return 2;
    }
    void *library = open_library(argv[1]);
    if (library == NULL) return 1;
    FUNCTIONS(LOAD)
    CHECK(environments_change_numbers());
    sweep(drop2, argv[2], atoi(argv[3]), &two);
    sweep(drop3, argv[2], atoi(argv[3]), &three);
    CHECK(strcmp(two.hash, three.hash) == 0 && two.force == three.force && two.peak == three.peak && two.peak > 0.0);
    printf("%s\n", two.hash);
    return failures != 0;
}
