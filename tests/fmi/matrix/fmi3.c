/* An FMU of FMI 3.0 for matrix.c. */
#include "../load.h"
#include "fmi3Functions.h"
#include "matrix.h"

#define FUNCTIONS(X)                                                                                              \
    X(fmi3InstantiateCoSimulation) X(fmi3FreeInstance) X(fmi3EnterInitializationMode)                             \
    X(fmi3ExitInitializationMode) X(fmi3GetFloat64) X(fmi3GetString) X(fmi3SetFloat64) X(fmi3GetFMUState)         \
    X(fmi3SetFMUState) X(fmi3FreeFMUState) X(fmi3SerializedFMUStateSize) X(fmi3SerializeFMUState)                 \
    X(fmi3DeserializeFMUState) X(fmi3DoStep)

static struct {
#define POINTER(name) name##TYPE *name;
    FUNCTIONS(POINTER)
} fmu;

static const fmi3ValueReference ENERGY = 1014, RESULTS[2] = {3007, 3010}, TRACE_HASH = 5001;

struct Drop {
    fmi3Instance c;
};

static const char *instantiation_token;

static void logger(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    (void)environment;
    fprintf(stderr, "%d %s %s\n", (int)status, category, message);
}

void prepare(const char *path, const char *token)
{
    void *library = open_library(path);
    MUST(library != NULL);
    FUNCTIONS(LOAD)
    instantiation_token = token;
}

Drop *begin(double energy)
{
    Drop *drop = malloc(sizeof *drop);
    MUST(drop != NULL);
    drop->c = fmu.fmi3InstantiateCoSimulation("drop", instantiation_token, "", fmi3False, fmi3False, fmi3False, fmi3False, NULL,
                                              0, NULL, logger, NULL);
    MUST(drop->c != NULL);
    MUST(fmu.fmi3SetFloat64(drop->c, &ENERGY, 1, &energy, 1) == fmi3OK);
    MUST(fmu.fmi3EnterInitializationMode(drop->c, fmi3False, 0.0, 0.0, fmi3True, 0.015) == fmi3OK);
    MUST(fmu.fmi3ExitInitializationMode(drop->c) == fmi3OK);
    return drop;
}

void advance(Drop *drop, int made, int count, double size)
{
    fmi3Boolean event, terminate, early;
    fmi3Float64 time;
    for (int i = made; i < made + count; i++) {
        MUST(fmu.fmi3DoStep(drop->c, i * size, size, fmi3True, &event, &terminate, &early, &time) == fmi3OK);
        MUST(!event && !terminate && !early);
    }
}

unsigned char *save(Drop *drop, size_t *size)
{
    fmi3FMUState state = NULL;
    MUST(fmu.fmi3GetFMUState(drop->c, &state) == fmi3OK);
    MUST(fmu.fmi3SerializedFMUStateSize(drop->c, state, size) == fmi3OK);
    unsigned char *bytes = malloc(*size);
    MUST(bytes != NULL && fmu.fmi3SerializeFMUState(drop->c, state, bytes, *size) == fmi3OK);
    MUST(fmu.fmi3FreeFMUState(drop->c, &state) == fmi3OK);
    return bytes;
}

void restore(Drop *drop, const unsigned char *bytes, size_t size)
{
    fmi3FMUState state = NULL;
    MUST(fmu.fmi3DeserializeFMUState(drop->c, bytes, size, &state) == fmi3OK);
    MUST(fmu.fmi3SetFMUState(drop->c, state) == fmi3OK && fmu.fmi3FreeFMUState(drop->c, &state) == fmi3OK);
}

Outcome outcome(Drop *drop)
{
    Outcome found;
    fmi3Float64 numbers[2];
    fmi3String text;
    MUST(fmu.fmi3GetFloat64(drop->c, RESULTS, 2, numbers, 2) == fmi3OK);
    MUST(fmu.fmi3GetString(drop->c, &TRACE_HASH, 1, &text, 1) == fmi3OK);
    found.peak_force = numbers[0];
    found.impulse = numbers[1];
    snprintf(found.trace_hash, sizeof found.trace_hash, "%s", text);
    return found;
}

void end(Drop *drop)
{
    fmu.fmi3FreeInstance(drop->c);
    free(drop);
}
