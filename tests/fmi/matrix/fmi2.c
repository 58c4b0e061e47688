/* An FMU of FMI 2.0 for matrix.c. */
#include <stdarg.h>

#include "../load.h"
#include "fmi2Functions.h"
#include "matrix.h"

#define FUNCTIONS(X)                                                                                              \
    X(fmi2Instantiate) X(fmi2FreeInstance) X(fmi2SetupExperiment) X(fmi2EnterInitializationMode)                  \
    X(fmi2ExitInitializationMode) X(fmi2GetReal) X(fmi2GetString) X(fmi2SetReal) X(fmi2GetFMUstate)               \
    X(fmi2SetFMUstate) X(fmi2FreeFMUstate) X(fmi2SerializedFMUstateSize) X(fmi2SerializeFMUstate)                 \
    X(fmi2DeSerializeFMUstate) X(fmi2DoStep)

static struct {
#define POINTER(name) name##TYPE *name;
    FUNCTIONS(POINTER)
} fmu;

static const fmi2ValueReference ENERGY = 1014, RESULTS[2] = {3007, 3010}, TRACE_HASH = 5001;

struct Drop {
    fmi2Component c;
};

static const char *guid;

static void logger(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category,
                   fmi2String message, ...)
{
    (void)environment;
    fprintf(stderr, "%s %d %s %s\n", name, (int)status, category, message);
}

static const fmi2CallbackFunctions CALLBACKS = {logger, calloc, free, NULL, NULL};

void prepare(const char *path, const char *token)
{
    void *library = open_library(path);
    MUST(library != NULL);
    FUNCTIONS(LOAD)
    guid = token;
}

Drop *begin(double energy)
{
    Drop *drop = malloc(sizeof *drop);
    MUST(drop != NULL);
    drop->c = fmu.fmi2Instantiate("drop", fmi2CoSimulation, guid, "", &CALLBACKS, fmi2False, fmi2False);
    MUST(drop->c != NULL);
    MUST(fmu.fmi2SetupExperiment(drop->c, fmi2False, 0.0, 0.0, fmi2True, 0.015) == fmi2OK);
    MUST(fmu.fmi2SetReal(drop->c, &ENERGY, 1, &energy) == fmi2OK);
    MUST(fmu.fmi2EnterInitializationMode(drop->c) == fmi2OK && fmu.fmi2ExitInitializationMode(drop->c) == fmi2OK);
    return drop;
}

void advance(Drop *drop, int made, int count, double size)
{
    for (int i = made; i < made + count; i++) MUST(fmu.fmi2DoStep(drop->c, i * size, size, fmi2True) == fmi2OK);
}

unsigned char *save(Drop *drop, size_t *size)
{
    fmi2FMUstate state = NULL;
    MUST(fmu.fmi2GetFMUstate(drop->c, &state) == fmi2OK);
    MUST(fmu.fmi2SerializedFMUstateSize(drop->c, state, size) == fmi2OK);
    unsigned char *bytes = malloc(*size);
    MUST(bytes != NULL && fmu.fmi2SerializeFMUstate(drop->c, state, (fmi2Byte *)bytes, *size) == fmi2OK);
    MUST(fmu.fmi2FreeFMUstate(drop->c, &state) == fmi2OK);
    return bytes;
}

void restore(Drop *drop, const unsigned char *bytes, size_t size)
{
    fmi2FMUstate state = NULL;
    MUST(fmu.fmi2DeSerializeFMUstate(drop->c, (const fmi2Byte *)bytes, size, &state) == fmi2OK);
    MUST(fmu.fmi2SetFMUstate(drop->c, state) == fmi2OK && fmu.fmi2FreeFMUstate(drop->c, &state) == fmi2OK);
}

Outcome outcome(Drop *drop)
{
    Outcome found;
    fmi2Real numbers[2];
    fmi2String text;
    MUST(fmu.fmi2GetReal(drop->c, RESULTS, 2, numbers) == fmi2OK && fmu.fmi2GetString(drop->c, &TRACE_HASH, 1, &text) == fmi2OK);
    found.peak_force = numbers[0];
    found.impulse = numbers[1];
    snprintf(found.trace_hash, sizeof found.trace_hash, "%s", text);
    return found;
}

void end(Drop *drop)
{
    fmu.fmi2FreeInstance(drop->c);
    free(drop);
}
