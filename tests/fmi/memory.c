/* A master whose heap refuses one allocation after the other, in every call that needs one, of both versions of FMI: what
 * cannot be made is null, what cannot be done is an error, the instance is as before, and the next try works. Prints the
 * number of refusals and the trace hash of the drop. */
#include "check.h"
#include "fmi2Functions.h"
#include "fmi3Functions.h"
#include "load.h"

#define FUNCTIONS(X)                                                                                              \
    X(fmi2Instantiate) X(fmi2FreeInstance) X(fmi2EnterInitializationMode) X(fmi2ExitInitializationMode)           \
    X(fmi2GetFMUstate) X(fmi2SetFMUstate) X(fmi2FreeFMUstate) X(fmi2SerializedFMUstateSize)                       \
    X(fmi2SerializeFMUstate) X(fmi2DeSerializeFMUstate) X(fmi2DoStep) X(fmi2GetString) X(fmi2GetReal)             \
    X(fmi3InstantiateCoSimulation) X(fmi3FreeInstance) X(fmi3EnterInitializationMode)                             \
    X(fmi3ExitInitializationMode) X(fmi3GetFMUState) X(fmi3SetFMUState) X(fmi3FreeFMUState)                       \
    X(fmi3DeserializeFMUState) X(fmi3DoStep) X(fmi3GetString)

static struct {
#define POINTER(name) name##TYPE *name;
    FUNCTIONS(POINTER)
} fmu;

void *__libc_malloc(size_t size);

/* Allocations that succeed before one is refused; none is refused if it is negative. */
static int left = -1;
static int refused = 0;

/* The library's calls of malloc come here, because the program is searched first. */
void *malloc(size_t size)
{
    if (left >= 0 && left-- == 0) {
        refused++;
        return NULL;
    }
    return __libc_malloc(size);
}

/* Repeats `call` with the first allocation refused, then the second, and so on, until none is; `failed` has to hold each
 * time. */
#define WITHOUT_MEMORY(call, failed)                 \
    for (int nth = 0, before;; nth++) {              \
        before = refused;                            \
        left = nth;                                  \
        call;                                        \
        left = -1;                                   \
        if (refused == before) break;                \
        CHECK(failed);                               \
    }

static void logger2(fmi2ComponentEnvironment environment, fmi2String name, fmi2Status status, fmi2String category,
                    fmi2String message, ...)
{
    (void)environment, (void)name, (void)status, (void)category;
    CHECK(message[0] != '\0');
}

static void logger3(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    (void)environment, (void)status, (void)category;
    CHECK(message[0] != '\0');
}

static const fmi2CallbackFunctions CALLBACKS = {logger2, NULL, NULL, NULL, NULL};
static const fmi2ValueReference HASH = 5001;

static void version_2(const char *guid)
{
    fmi2Component c;
    fmi2Status status;
    fmi2FMUstate state = NULL, copy = NULL;
    size_t size = 0;
    const char *hash = "";

    WITHOUT_MEMORY(c = fmu.fmi2Instantiate("drop", fmi2CoSimulation, guid, "", &CALLBACKS, 0, 1), c == NULL)
    CHECK(c != NULL && fmu.fmi2EnterInitializationMode(c) == fmi2OK);
    WITHOUT_MEMORY(status = fmu.fmi2ExitInitializationMode(c), status == fmi2Error)
    CHECK(status == fmi2OK);
    for (int i = 0; i < 60; i++) CHECK(fmu.fmi2DoStep(c, i * 50e-6, 50e-6, fmi2True) == fmi2OK);
    WITHOUT_MEMORY(status = fmu.fmi2GetFMUstate(c, &state), status == fmi2Error && state == NULL)
    CHECK(status == fmi2OK && fmu.fmi2SerializedFMUstateSize(c, state, &size) == fmi2OK);
    fmi2Byte *bytes = malloc(size);
    CHECK(fmu.fmi2SerializeFMUstate(c, state, bytes, size) == fmi2OK);
    WITHOUT_MEMORY(status = fmu.fmi2DeSerializeFMUstate(c, bytes, size, &copy), status == fmi2Error && copy == NULL)
    CHECK(status == fmi2OK);
    free(bytes);
    fmu.fmi2FreeInstance(c);
    /* Another instance, which has to build the model for the state. */
    c = fmu.fmi2Instantiate("drop", fmi2CoSimulation, guid, "", &CALLBACKS, 0, 1);
    WITHOUT_MEMORY(status = fmu.fmi2SetFMUstate(c, copy), status == fmi2Error)
    CHECK(status == fmi2OK);
    /* A step takes no memory, and neither does a refusal. */
    left = 0;
    for (int i = 60; i < 300; i++) CHECK(fmu.fmi2DoStep(c, i * 50e-6, 50e-6, fmi2True) == fmi2OK);
    CHECK(fmu.fmi2DoStep(c, 0.0, -1.0, fmi2True) == fmi2Error && fmu.fmi2GetString(c, &HASH, 1, &hash) == fmi2OK && left == 0);
    left = -1;
    printf("%d %s\n", refused, hash);
    CHECK(fmu.fmi2FreeFMUstate(c, &state) == fmi2OK && fmu.fmi2FreeFMUstate(c, &copy) == fmi2OK);
    fmu.fmi2FreeInstance(c);
}

static void version_3(const char *token)
{
    fmi3Instance c;
    fmi3Status status;
    fmi3FMUState state = NULL;
    fmi3Boolean told[3];
    fmi3Float64 time;
    const char *hash = "";

    refused = 0;
    WITHOUT_MEMORY(c = fmu.fmi3InstantiateCoSimulation("drop", token, "", 0, 1, 0, 0, NULL, 0, NULL, logger3, NULL), c == NULL)
    CHECK(c != NULL && fmu.fmi3EnterInitializationMode(c, 0, 0.0, 0.0, 0, 0.0) == fmi3OK);
    WITHOUT_MEMORY(status = fmu.fmi3ExitInitializationMode(c), status == fmi3Error)
    CHECK(status == fmi3OK);
    WITHOUT_MEMORY(status = fmu.fmi3GetFMUState(c, &state), status == fmi3Error && state == NULL)
    CHECK(status == fmi3OK);
    left = 0;
    for (int i = 0; i < 300; i++) {
        CHECK(fmu.fmi3DoStep(c, i * 50e-6, 50e-6, fmi3True, told, told + 1, told + 2, &time) == fmi3OK);
    }
    CHECK(fmu.fmi3DoStep(c, 0.0, -1.0, fmi3True, told, told + 1, told + 2, &time) == fmi3Discard);
    CHECK(fmu.fmi3GetString(c, &HASH, 1, &hash, 1) == fmi3OK && left == 0);
    left = -1;
    printf("%d %s\n", refused, hash);
    CHECK(fmu.fmi3FreeFMUState(c, &state) == fmi3OK);
    fmu.fmi3FreeInstance(c);
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "usage: %s LIBRARY TOKEN\n", argv[0]);
        return 2;
    }
    void *library = open_library(argv[1]);
    if (library == NULL) return 1;
    FUNCTIONS(LOAD)
    version_2(argv[2]);
    version_3(argv[2]);
    return failures != 0;
}
