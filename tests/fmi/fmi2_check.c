/* A C master that includes the standard's own headers (FMPy carries them): every function is called through a pointer of
 * the header's type, in a whole life of an instance, and then with null pointers and in the wrong order. Prints the
 * trace hash of the drop. Build it with address and undefined-behaviour sanitizers to see that nothing goes wrong. */
#include <math.h>
#include <stdarg.h>

#include "check.h"
#include "fmi2Functions.h"
#include "load.h"

static int errors_logged = 0;

/* A pointer of the header's type for every function, filled from the library by name. */
#define FUNCTIONS(X)                                                                                              \
    X(fmi2GetTypesPlatform) X(fmi2GetVersion) X(fmi2SetDebugLogging) X(fmi2Instantiate) X(fmi2FreeInstance)       \
    X(fmi2SetupExperiment) X(fmi2EnterInitializationMode) X(fmi2ExitInitializationMode) X(fmi2Terminate)          \
    X(fmi2Reset) X(fmi2GetReal) X(fmi2GetInteger) X(fmi2GetBoolean) X(fmi2GetString) X(fmi2SetReal)               \
    X(fmi2SetInteger) X(fmi2SetBoolean) X(fmi2SetString) X(fmi2GetFMUstate) X(fmi2SetFMUstate)                    \
    X(fmi2FreeFMUstate) X(fmi2SerializedFMUstateSize) X(fmi2SerializeFMUstate) X(fmi2DeSerializeFMUstate)         \
    X(fmi2GetDirectionalDerivative) X(fmi2SetRealInputDerivatives) X(fmi2GetRealOutputDerivatives) X(fmi2DoStep)  \
    X(fmi2CancelStep) X(fmi2GetStatus) X(fmi2GetRealStatus) X(fmi2GetIntegerStatus) X(fmi2GetBooleanStatus)       \
    X(fmi2GetStringStatus) X(fmi2EnterEventMode) X(fmi2NewDiscreteStates) X(fmi2EnterContinuousTimeMode)          \
    X(fmi2CompletedIntegratorStep) X(fmi2SetTime) X(fmi2SetContinuousStates) X(fmi2GetDerivatives)                \
    X(fmi2GetEventIndicators) X(fmi2GetContinuousStates) X(fmi2GetNominalsOfContinuousStates)

static struct {
#define POINTER(name) name##TYPE *name;
    FUNCTIONS(POINTER)
} fmu;

static void load(const char *path)
{
    void *library = open_library(path);
    if (library == NULL) exit(1);
    FUNCTIONS(LOAD)
}

/* Formats as loggers do, so that a stray conversion would show. */
static void logger(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category,
                   fmi2String message, ...)
{
    char text[1024];
    va_list arguments;
    va_start(arguments, message);
    vsnprintf(text, sizeof text, message, arguments);
    va_end(arguments);
    CHECK(environment == (void *)&failures && name != NULL && category != NULL && text[0] != '\0');
    errors_logged += status == fmi2Error;
}

static const fmi2CallbackFunctions CALLBACKS = {logger, calloc, free, NULL, &failures};

static void run(fmi2Component c, int first, int last)
{
    for (int i = first; i < last; i++) CHECK(fmu.fmi2DoStep(c, i * 50e-6, 50e-6, fmi2True) == fmi2OK);
}

static void start(fmi2Component c)
{
    CHECK(fmu.fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2True, 0.015) == fmi2OK);
    CHECK(fmu.fmi2EnterInitializationMode(c) == fmi2OK);
    CHECK(fmu.fmi2ExitInitializationMode(c) == fmi2OK);
}

/* Steps of any length, from any start time, by a master that adds up its times: the same trace. A step that is refused is an
 * error, and leaves everything as it is. */
static void any_steps(const char *guid, const char *expected)
{
    static const struct { double start, size; } RUNS[] = {
        {0.0, 1.0 / 60.0}, {0.0, 30e-6}, {0.0, 1e-6}, {0.0, 1.4142135623730951e-5}, {1e7, 50e-6}, {1.7e9, 100e-6}, {1.7e9, 30e-6},
    };
    const fmi2ValueReference hash = 5001, force = 3000;
    for (size_t i = 0; i < sizeof RUNS / sizeof *RUNS; i++) {
        const double start = RUNS[i].start, size = RUNS[i].size;
        const int count = (int)(0.015 / size + 1e-9);
        double time = start;
        fmi2Real real = 0.0;
        fmi2String text = NULL;
        fmi2Component c = fmu.fmi2Instantiate("impact", fmi2CoSimulation, guid, NULL, &CALLBACKS, 0, 0);
        CHECK(fmu.fmi2SetupExperiment(c, fmi2False, 0.0, start, fmi2True, start + 0.015) == fmi2OK);
        CHECK(fmu.fmi2EnterInitializationMode(c) == fmi2OK && fmu.fmi2ExitInitializationMode(c) == fmi2OK);
        for (int j = 0; j < count; j++) {
            CHECK(fmu.fmi2DoStep(c, time, size, fmi2True) == fmi2OK);
            time += size;
            CHECK(fmu.fmi2GetRealStatus(c, fmi2LastSuccessfulTime, &real) == fmi2OK);
            CHECK(fabs(real - time) <= 1e-14 + 4e-16 * start);
        }
        const double rest = 0.015 - count * size;
        CHECK(rest < 1e-12 || fmu.fmi2DoStep(c, time, rest, fmi2True) == fmi2OK);
        const int logged = errors_logged;
        CHECK(fmu.fmi2DoStep(c, start + 0.015, 0.0, fmi2True) == fmi2Error && errors_logged == logged + 1);
        CHECK(fmu.fmi2DoStep(c, start + 0.015, 50e-6, fmi2True) == fmi2Error && errors_logged == logged + 2);
        CHECK(fmu.fmi2GetString(c, &hash, 1, &text) == fmi2OK && strcmp(text, expected) == 0);
        fmu.fmi2FreeInstance(c);
    }
    /* The table of FMI 2.0 has no results before initialization. */
    fmi2Real real = 0.0;
    fmi2Component c = fmu.fmi2Instantiate("impact", fmi2CoSimulation, guid, NULL, &CALLBACKS, 0, 0);
    CHECK(fmu.fmi2GetReal(c, &force, 1, &real) == fmi2Error);
    fmu.fmi2FreeInstance(c);
    errors_logged = 0;
}

static void whole_life(const char *guid, int is_brief)
{
    const fmi2ValueReference force = 3000, shape = 1000, active = 5000, hash = 5001, push = 2000;
    fmi2Real real = 0.0;
    fmi2Integer integer = -1;
    fmi2Boolean boolean = -1;
    fmi2String text = NULL, again = NULL;
    fmi2FMUstate state = NULL, copy = NULL;
    size_t size = 0;
    fmi2Status status = fmi2Fatal;

    fmi2Component c = fmu.fmi2Instantiate("impact", fmi2CoSimulation, guid, "file:///no%20where", &CALLBACKS, 0, 0);
    CHECK(c != NULL);
    if (c == NULL) return;
    start(c);
    run(c, 0, 60);
    CHECK(fmu.fmi2GetReal(c, &force, 1, &real) == fmi2OK && real > 0.0);
    CHECK(fmu.fmi2GetInteger(c, &shape, 1, &integer) == fmi2OK && integer == 0);
    CHECK(fmu.fmi2GetBoolean(c, &active, 1, &boolean) == fmi2OK && boolean == fmi2True);
    CHECK(fmu.fmi2GetFMUstate(c, &state) == fmi2OK);
    CHECK(fmu.fmi2SerializedFMUstateSize(c, state, &size) == fmi2OK && size > 0);
    char *bytes = malloc(size);
    CHECK(fmu.fmi2SerializeFMUstate(c, state, bytes, size) == fmi2OK);
    run(c, 60, 300);
    CHECK(fmu.fmi2GetString(c, &hash, 1, &text) == fmi2OK && strlen(text) == 16);
    char first[17];
    snprintf(first, sizeof first, "%s", text);
    CHECK(fmu.fmi2DeSerializeFMUstate(c, bytes, size, &copy) == fmi2OK);
    CHECK(fmu.fmi2SetFMUstate(c, copy) == fmi2OK);
    run(c, 60, 300);
    CHECK(fmu.fmi2GetString(c, &hash, 1, &again) == fmi2OK && strcmp(first, again) == 0);
    real = 1.0;
    CHECK(fmu.fmi2SetReal(c, &push, 1, &real) == fmi2OK);
    CHECK(fmu.fmi2GetStatus(c, fmi2DoStepStatus, &status) == fmi2OK && status == fmi2OK);
    CHECK(fmu.fmi2GetStatus(c, fmi2PendingStatus, &status) == fmi2Discard);
    CHECK(fmu.fmi2GetRealStatus(c, fmi2LastSuccessfulTime, &real) == fmi2OK && fabs(real - 0.015) < 1e-12);
    CHECK(fmu.fmi2GetIntegerStatus(c, fmi2DoStepStatus, &integer) == fmi2Discard);
    CHECK(fmu.fmi2GetBooleanStatus(c, fmi2Terminated, &boolean) == fmi2OK && boolean == fmi2False);
    CHECK(fmu.fmi2GetStringStatus(c, fmi2PendingStatus, &text) == fmi2Discard);
    CHECK(fmu.fmi2FreeFMUstate(c, &state) == fmi2OK && state == NULL);
    CHECK(fmu.fmi2FreeFMUstate(c, &copy) == fmi2OK && fmu.fmi2FreeFMUstate(c, &copy) == fmi2OK);
    CHECK(fmu.fmi2Terminate(c) == fmi2OK);
    CHECK(fmu.fmi2Reset(c) == fmi2OK);
    CHECK(errors_logged == 0);
    fmu.fmi2FreeInstance(c);
    free(bytes);
    if (!is_brief) any_steps(guid, first);
    printf("%s\n", first);
}

/* Every function that takes an instance, with nulls for everything else. */
static void with_nulls(fmi2Component c)
{
    CHECK(fmu.fmi2SetDebugLogging(c, fmi2True, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetReal(c, NULL, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetInteger(c, NULL, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetBoolean(c, NULL, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetString(c, NULL, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2SetReal(c, NULL, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2SetInteger(c, NULL, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2SetBoolean(c, NULL, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2SetString(c, NULL, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetFMUstate(c, NULL) == fmi2Error);
    CHECK(fmu.fmi2SetFMUstate(c, NULL) == fmi2Error);
    CHECK(fmu.fmi2SerializedFMUstateSize(c, NULL, NULL) == fmi2Error);
    CHECK(fmu.fmi2SerializeFMUstate(c, NULL, NULL, 1) == fmi2Error);
    CHECK(fmu.fmi2DeSerializeFMUstate(c, NULL, 1, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetDirectionalDerivative(c, NULL, 1, NULL, 1, NULL, NULL) == fmi2Error);
    CHECK(fmu.fmi2SetRealInputDerivatives(c, NULL, 1, NULL, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetRealOutputDerivatives(c, NULL, 1, NULL, NULL) == fmi2Error);
    CHECK(fmu.fmi2DoStep(c, NAN, NAN, fmi2False) == fmi2Error);
    CHECK(fmu.fmi2CancelStep(c) == fmi2Error);
    CHECK(fmu.fmi2GetStatus(c, fmi2DoStepStatus, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetRealStatus(c, fmi2LastSuccessfulTime, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetIntegerStatus(c, fmi2DoStepStatus, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetBooleanStatus(c, fmi2Terminated, NULL) == fmi2Error);
    CHECK(fmu.fmi2GetStringStatus(c, fmi2PendingStatus, NULL) == fmi2Error);
    CHECK(fmu.fmi2EnterEventMode(c) == fmi2Error && fmu.fmi2EnterContinuousTimeMode(c) == fmi2Error);
    CHECK(fmu.fmi2NewDiscreteStates(c, NULL) == fmi2Error && fmu.fmi2SetTime(c, 0.0) == fmi2Error);
    CHECK(fmu.fmi2CompletedIntegratorStep(c, fmi2True, NULL, NULL) == fmi2Error);
    CHECK(fmu.fmi2SetContinuousStates(c, NULL, 1) == fmi2Error && fmu.fmi2GetContinuousStates(c, NULL, 1) == fmi2Error);
    CHECK(fmu.fmi2GetDerivatives(c, NULL, 1) == fmi2Error && fmu.fmi2GetEventIndicators(c, NULL, 1) == fmi2Error);
    CHECK(fmu.fmi2GetNominalsOfContinuousStates(c, NULL, 1) == fmi2Error);
}

static void wrong_calls(const char *guid)
{
    const fmi2CallbackFunctions silent = {NULL, NULL, NULL, NULL, NULL};
    with_nulls(NULL);
    CHECK(fmu.fmi2FreeFMUstate(NULL, NULL) == fmi2Error);
    CHECK(fmu.fmi2Reset(NULL) == fmi2Error && fmu.fmi2Terminate(NULL) == fmi2Error);
    CHECK(fmu.fmi2SetupExperiment(NULL, 0, 0.0, 0.0, 0, 0.0) == fmi2Error);
    CHECK(fmu.fmi2EnterInitializationMode(NULL) == fmi2Error && fmu.fmi2ExitInitializationMode(NULL) == fmi2Error);
    fmu.fmi2FreeInstance(NULL);

    CHECK(fmu.fmi2Instantiate("impact", fmi2CoSimulation, guid, NULL, NULL, 0, 0) == NULL);
    CHECK(fmu.fmi2Instantiate(NULL, fmi2CoSimulation, guid, NULL, &CALLBACKS, 0, 0) == NULL);
    CHECK(fmu.fmi2Instantiate("", fmi2CoSimulation, guid, NULL, &CALLBACKS, 0, 0) == NULL);
    CHECK(fmu.fmi2Instantiate("impact", fmi2ModelExchange, guid, NULL, &CALLBACKS, 0, 0) == NULL);
    CHECK(fmu.fmi2Instantiate("impact", fmi2CoSimulation, NULL, NULL, &CALLBACKS, 0, 0) == NULL);
    CHECK(fmu.fmi2Instantiate("impact", fmi2CoSimulation, "{}", NULL, &CALLBACKS, 0, 0) == NULL);
    CHECK(errors_logged == 5);

    fmi2Component c = fmu.fmi2Instantiate("impact", fmi2CoSimulation, guid, NULL, &silent, 0, 1);
    CHECK(c != NULL);
    with_nulls(c);
    start(c);
    with_nulls(c);
    run(c, 0, 60);
    with_nulls(c);
    run(c, 60, 300);
    CHECK(fmu.fmi2Terminate(c) == fmi2OK);
    with_nulls(c);
    fmu.fmi2FreeInstance(c);
}

int main(int argc, char **argv)
{
    if (argc != 3 && argc != 4) {
        fprintf(stderr, "usage: %s LIBRARY GUID [brief]\n", argv[0]);
        return 2;
    }
    load(argv[1]);
    CHECK(strcmp(fmu.fmi2GetTypesPlatform(), fmi2TypesPlatform) == 0);
    CHECK(strcmp(fmu.fmi2GetVersion(), fmi2Version) == 0);
    whole_life(argv[2], argc == 4);
    wrong_calls(argv[2]);
    return failures != 0;
}
