/* A C master of FMI 3.0 with the standard's own headers (FMPy carries them): every function is called through a pointer of
 * the header's type, in whole lives of an instance, with events, early returns and intermediate updates, and then with null
 * pointers, values out of range and in the wrong order, by a table of cases. Prints the trace hash of the drop. Build it
 * with address and undefined-behaviour sanitizers to see that nothing goes wrong. */
#include <math.h>

#include "check.h"
#include "fmi3Functions.h"
#include "load.h"

static int errors_logged = 0, discards_logged = 0, messages_logged = 0;

/* A pointer of the header's type for every function, filled from the library by name. */
#define FUNCTIONS(X) \
    X(fmi3GetVersion) X(fmi3SetDebugLogging) X(fmi3InstantiateModelExchange) X(fmi3InstantiateCoSimulation)      \
    X(fmi3InstantiateScheduledExecution) X(fmi3FreeInstance) X(fmi3EnterInitializationMode)                      \
    X(fmi3ExitInitializationMode) X(fmi3EnterEventMode) X(fmi3Terminate) X(fmi3Reset) X(fmi3GetFloat32)          \
    X(fmi3GetFloat64) X(fmi3GetInt8) X(fmi3GetUInt8) X(fmi3GetInt16) X(fmi3GetUInt16) X(fmi3GetInt32)            \
    X(fmi3GetUInt32) X(fmi3GetInt64) X(fmi3GetUInt64) X(fmi3GetBoolean) X(fmi3GetString) X(fmi3GetBinary)        \
    X(fmi3GetClock) X(fmi3SetFloat32) X(fmi3SetFloat64) X(fmi3SetInt8) X(fmi3SetUInt8) X(fmi3SetInt16)           \
    X(fmi3SetUInt16) X(fmi3SetInt32) X(fmi3SetUInt32) X(fmi3SetInt64) X(fmi3SetUInt64) X(fmi3SetBoolean)         \
    X(fmi3SetString) X(fmi3SetBinary) X(fmi3SetClock) X(fmi3GetNumberOfVariableDependencies)                     \
    X(fmi3GetVariableDependencies) X(fmi3GetFMUState) X(fmi3SetFMUState) X(fmi3FreeFMUState)                     \
    X(fmi3SerializedFMUStateSize) X(fmi3SerializeFMUState) X(fmi3DeserializeFMUState)                            \
    X(fmi3GetDirectionalDerivative) X(fmi3GetAdjointDerivative) X(fmi3EnterConfigurationMode)                    \
    X(fmi3ExitConfigurationMode) X(fmi3GetIntervalDecimal) X(fmi3GetIntervalFraction) X(fmi3GetShiftDecimal)     \
    X(fmi3GetShiftFraction) X(fmi3SetIntervalDecimal) X(fmi3SetIntervalFraction) X(fmi3SetShiftDecimal)          \
    X(fmi3SetShiftFraction) X(fmi3EvaluateDiscreteStates) X(fmi3UpdateDiscreteStates)                            \
    X(fmi3EnterContinuousTimeMode) X(fmi3CompletedIntegratorStep) X(fmi3SetTime) X(fmi3SetContinuousStates)      \
    X(fmi3GetContinuousStateDerivatives) X(fmi3GetEventIndicators) X(fmi3GetContinuousStates)                    \
    X(fmi3GetNominalsOfContinuousStates) X(fmi3GetNumberOfEventIndicators) X(fmi3GetNumberOfContinuousStates)    \
    X(fmi3EnterStepMode) X(fmi3GetOutputDerivatives) X(fmi3DoStep) X(fmi3ActivateModelPartition)

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

enum {
    TIME = 0, SHAPE = 1000, MOTION = 1006, MASS = 1007, GAP = 1010, SAFETY = 1025, N_POINTS = 1900, PUSH = 2000, HEIGHT = 2001, SPEED = 2002, FORCE = 3000,
    FILTERED = 3028, POSITION = 3003, VELOCITY = 3004,
    PEAK = 3007, KERNEL_TIME = 3500, STEP = 4000, ELEMENTS = 4001, ACTIVE = 5000, HASH = 5001, PROFILE = 6001, PRESSURE = 6002, LAYER_COUNT = 1019, SECOND_THICKNESS = 7100, UNKNOWN = 999
};

static const double SAMPLE = 50e-6;

static void logger(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    CHECK(environment == (void *)&failures && category != NULL && message[0] != '\0');
    errors_logged += status == fmi3Error;
    discards_logged += status == fmi3Discard;
    messages_logged++;
}

/* What the last step told. */
static struct {
    fmi3Boolean event, terminate, early;
    fmi3Float64 time;
} told;

/* The communication step on its way, with the rounding of its end, and the last time that was shown. */
static double step_from, step_to, shown;

static fmi3Status step(fmi3Instance c, double point, double size)
{
    step_from = shown = point;
    step_to = point + size + 1e-15;
    return fmu.fmi3DoStep(c, point, size, fmi3True, &told.event, &told.terminate, &told.early, &told.time);
}

static double real(fmi3Instance c, fmi3ValueReference reference)
{
    fmi3Float64 value = NAN;
    CHECK(fmu.fmi3GetFloat64(c, &reference, 1, &value, 1) == fmi3OK);
    return value;
}

static fmi3String text(fmi3Instance c)
{
    const fmi3ValueReference hash = HASH;
    fmi3String value = "";
    CHECK(fmu.fmi3GetString(c, &hash, 1, &value, 1) == fmi3OK);
    return value;
}

static void run(fmi3Instance c, int first, int last, double size)
{
    for (int i = first; i < last; i++) {
        CHECK(step(c, i * size, size) == fmi3OK && !told.event && !told.early && !told.terminate);
        CHECK(fabs(told.time - (i + 1) * size) < 1e-12);
    }
}

static void start(fmi3Instance c)
{
    CHECK(fmu.fmi3EnterInitializationMode(c, fmi3False, 0.0, 0.0, fmi3True, 0.015) == fmi3OK);
    CHECK(fmu.fmi3ExitInitializationMode(c) == fmi3OK);
}

static fmi3Instance plain(const char *token, fmi3Boolean events, fmi3Boolean early, fmi3IntermediateUpdateCallback update)
{
    fmi3Instance c = fmu.fmi3InstantiateCoSimulation("impact", token, "/no where/", fmi3False, fmi3True, events, early, NULL,
                                                     0, &failures, logger, update);
    CHECK(c != NULL);
    if (c == NULL) exit(1);
    return c;
}

static char expected[17];
static double expected_peak;

static void whole_life(const char *token)
{
    const fmi3ValueReference points = N_POINTS, profile[2] = {FORCE, PROFILE}, active = ACTIVE, elements = ELEMENTS, shape = SHAPE;
    fmi3UInt64 n = 7;
    fmi3Float64 values[8];
    fmi3Boolean boolean = fmi3False;
    fmi3Int32 count = 0;
    fmi3Int64 choice = -1;
    fmi3FMUState state = NULL, copy = NULL;
    size_t size = 0;

    fmi3Instance c = plain(token, fmi3False, fmi3False, NULL);
    CHECK(fmu.fmi3EnterConfigurationMode(c) == fmi3OK && fmu.fmi3SetUInt64(c, &points, 1, &n, 1) == fmi3OK);
    CHECK(fmu.fmi3ExitConfigurationMode(c) == fmi3OK);
    start(c);
    run(c, 0, 60, SAMPLE);
    CHECK(fmu.fmi3GetFloat64(c, profile, 2, values, 8) == fmi3OK && values[0] > 0.0 && values[1] < 0.0);
    CHECK(fmu.fmi3GetBoolean(c, &active, 1, &boolean, 1) == fmi3OK && boolean);
    CHECK(fmu.fmi3GetInt32(c, &elements, 1, &count, 1) == fmi3OK && count > 0);
    CHECK(fmu.fmi3GetInt64(c, &shape, 1, &choice, 1) == fmi3OK && choice == 0);
    CHECK(fmu.fmi3GetUInt64(c, &points, 1, &n, 1) == fmi3OK && n == 7);
    CHECK(fmu.fmi3GetFMUState(c, &state) == fmi3OK);
    CHECK(fmu.fmi3SerializedFMUStateSize(c, state, &size) == fmi3OK && size > 0);
    fmi3Byte *bytes = malloc(size);
    CHECK(fmu.fmi3SerializeFMUState(c, state, bytes, size) == fmi3OK);
    run(c, 60, 300, SAMPLE);
    snprintf(expected, sizeof expected, "%s", text(c));
    expected_peak = real(c, PEAK);
    CHECK(strlen(expected) == 16);
    CHECK(fmu.fmi3DeserializeFMUState(c, bytes, size, &copy) == fmi3OK && fmu.fmi3SetFMUState(c, copy) == fmi3OK);
    run(c, 60, 300, SAMPLE);
    CHECK(strcmp(text(c), expected) == 0);
    for (size_t i = 0; i < size; i += 1 + size / 64) {
        bytes[i] ^= 1;
        CHECK(fmu.fmi3DeserializeFMUState(c, bytes, size, &copy) == fmi3Error);
        CHECK(fmu.fmi3DeserializeFMUState(c, bytes, i, &copy) == fmi3Error);
        bytes[i] ^= 1;
    }
    CHECK(fmu.fmi3FreeFMUState(c, &state) == fmi3OK && state == NULL);
    CHECK(fmu.fmi3FreeFMUState(c, &copy) == fmi3OK && fmu.fmi3FreeFMUState(c, &copy) == fmi3OK);
    CHECK(fmu.fmi3Terminate(c) == fmi3OK && strcmp(text(c), expected) == 0);
    CHECK(fmu.fmi3Reset(c) == fmi3OK);
    start(c);
    run(c, 0, 15, 1e-3);
    CHECK(strcmp(text(c), expected) == 0);
    fmu.fmi3FreeInstance(c);
    free(bytes);
    printf("%s\n", expected);
}

static int updates = 0;
static fmi3Instance updating = NULL;
static double return_at = INFINITY;
/* For when to ask once, before that time. */
static double ask_for = INFINITY;
/* Reads in the middle of a step, and is refused what is not legal there. */
static void update(fmi3InstanceEnvironment environment, fmi3Float64 time, fmi3Boolean set, fmi3Boolean get,
                   fmi3Boolean finished, fmi3Boolean early, fmi3Boolean *requested, fmi3Float64 *until)
{
    (void)early;
    CHECK(environment == (void *)&failures && !set && get && finished);
    CHECK(real(updating, TIME) == time);
    CHECK(time > step_from && time <= step_to && time >= shown);
    /* Within the step it is the kernel's time; at the end the kernel is up to half a step away. */
    CHECK(fabs(real(updating, KERNEL_TIME) - time) <= (time < step_to - 2e-15 ? 1e-15 : 0.5 * real(updating, STEP) + 1e-15));
    shown = time;
    if (updates++ == 0) {
        const double from = step_from, to = step_to;
        CHECK(step(updating, time, SAMPLE) == fmi3Error && fmu.fmi3Reset(updating) == fmi3Error);
        step_from = from, step_to = to;
        fmu.fmi3FreeInstance(updating);
        CHECK(real(updating, TIME) == time);
    }
    if (ask_for < INFINITY) {
        *requested = fmi3True;
        *until = ask_for;
        ask_for = INFINITY;
    }
    if (time >= return_at) {
        *requested = fmi3True;
        *until = time;
        return_at = INFINITY;
    }
}

static void step_mode(fmi3Instance c)
{
    fmi3Boolean flag[5] = {1, 1, 1, 1, 1};
    fmi3Float64 next = 1.0;
    CHECK(fmu.fmi3UpdateDiscreteStates(c, flag, flag + 1, flag + 2, flag + 3, flag + 4, &next) == fmi3OK);
    CHECK(!flag[0] && !flag[1] && !flag[2] && !flag[3] && !flag[4]);
    CHECK(fmu.fmi3EnterStepMode(c) == fmi3OK);
}

/* From one communication point to the next, with whatever returns early on the way; counts events. */
static int march(fmi3Instance c, double from, double size)
{
    int events = 0;
    double time = from;
    do {
        CHECK(step(c, time, from + size - time) == fmi3OK);
        CHECK(told.time > time && told.early == (told.time < from + size - 1e-9) && real(c, TIME) == told.time);
        CHECK(fabs(real(c, KERNEL_TIME) - told.time) <= (told.early ? 1e-15 : 0.5 * real(c, STEP) + 1e-15));
        time = told.time;
        if (told.event) {
            events++;
            CHECK(fmu.fmi3EnterEventMode(c) == fmi3OK);
            step_mode(c);
        }
    } while (told.early);
    return events;
}

/* However a step is interrupted, the result is the same. */
static void interrupted(const char *token)
{
    for (int kind = 0; kind < 12; kind++) {
        const fmi3Boolean events = kind & 1, early = kind % 6 >= 2, looks = kind % 6 >= 4;
        /* The second round is in steps that are no whole number of kernel steps. */
        const int count = kind < 6 ? 15 : 301;
        const int before = updates;
        fmi3Instance c = updating = plain(token, events, early, looks ? update : NULL);
        int found = 0;
        start(c);
        if (events) step_mode(c);
        return_at = early ? 1.23e-3 : INFINITY;
        for (int i = 0; i < count; i++) found += march(c, i * (15e-3 / count), 15e-3 / count);
        CHECK(strcmp(text(c), expected) == 0 && real(c, PEAK) == expected_peak);
        CHECK(events ? found >= 2 : found == 0);
        CHECK(!looks || updates - before == (int)(0.015 / real(c, STEP) + 0.5));
        CHECK(fmu.fmi3Terminate(c) == fmi3OK);
        fmu.fmi3FreeInstance(c);
    }
}

/* An early return that is asked for once, ahead of its time, comes at the kernel step nearest to it. */
static void asked_ahead(const char *token)
{
    fmi3Instance c = updating = plain(token, fmi3False, fmi3True, update);
    start(c);
    ask_for = 4.1e-4;
    CHECK(step(c, 0.0, 1e-3) == fmi3OK && told.early);
    CHECK(fabs(told.time - 4.1e-4) <= 0.5 * real(c, STEP) + 1e-15 && ask_for == INFINITY);
    /* It holds for one step. */
    CHECK(step(c, told.time, 1e-3) == fmi3OK && !told.early);
    CHECK(fmu.fmi3Terminate(c) == fmi3OK);
    fmu.fmi3FreeInstance(c);
}

static void set(fmi3Instance c, fmi3ValueReference reference, double value)
{
    CHECK(fmu.fmi3SetFloat64(c, &reference, 1, &value, 1) == fmi3OK);
}

/* An upward force on the falling mass: a softer impact, the same however a step is interrupted. */
static void pushed(const char *token)
{
    char hash[17] = "";
    for (int kind = 0; kind < 2; kind++) {
        fmi3Instance c = updating = plain(token, kind == 1, kind == 1, kind == 1 ? update : NULL);
        start(c);
        if (kind == 1) step_mode(c);
        set(c, PUSH, 1000.0);
        for (int i = 0; i < 15; i++) march(c, i * 1e-3, 1e-3);
        CHECK(kind == 0 || strcmp(text(c), hash) == 0);
        snprintf(hash, sizeof hash, "%s", text(c));
        CHECK(strcmp(hash, expected) != 0 && real(c, PEAK) > 1e3 && real(c, PEAK) < 5.2e3);
        fmu.fmi3FreeInstance(c);
    }
}

/* Steps of any length, in a whole drop that ends at its stop time, whatever time it starts at and whether the master adds up
 * its times or not: the same trace, the kernel never more than half a step away. */
static void any_steps(const char *token)
{
    static const struct { double start, size; } RUNS[] = {
        {0.0, 1.0 / 60.0}, {0.0, 30e-6}, {0.0, 1e-6}, {0.0, 1.4142135623730951e-5}, {0.0, 3.141592653589793e-6}, {0.0, 15e-3 / 500},
        {1e7, 50e-6}, {1e7, 30e-6}, {1.7e9, 50e-6}, {1.7e9, 100e-6}, {1.7e9, 30e-6}, {-1.7e9, 3.3e-6},
    };
    for (size_t i = 0; i < 2 * sizeof RUNS / sizeof *RUNS; i++) {
        const double start = RUNS[i / 2].start, size = RUNS[i / 2].size, stop = start + 0.015;
        const int count = (int)(0.015 / size + 1e-9), accumulates = i & 1;
        fmi3Instance c = plain(token, fmi3False, fmi3False, NULL);
        CHECK(fmu.fmi3EnterInitializationMode(c, fmi3False, 0.0, start, fmi3True, stop) == fmi3OK);
        CHECK(fmu.fmi3ExitInitializationMode(c) == fmi3OK);
        const double half = 0.5 * real(c, STEP) + 1e-14 + 4e-16 * fabs(start);
        double time = start;
        for (int j = 0; j < count; j++) {
            CHECK(step(c, time, size) == fmi3OK && !told.early && !told.event && !told.terminate);
            time = accumulates ? time + size : start + (j + 1) * size;
            CHECK(fabs(told.time - time) <= 1e-14 + 4e-16 * fabs(start) && fabs(real(c, KERNEL_TIME) - time) <= half);
        }
        const double rest = 0.015 - count * size;
        CHECK(rest < 1e-12 || step(c, time, rest) == fmi3OK);
        CHECK(strcmp(text(c), expected) == 0 && real(c, PEAK) == expected_peak);
        fmu.fmi3FreeInstance(c);
    }
}

enum { N_PROFILE = 25 };

/* A face that the master moves: 1 m/s downwards into the layer and up again, with a command for the end of every step, also
 * after an early return. Leaves the pressures at the lowest point in `pressure` and returns the peak force. */
static double moved(const char *token, int kind, double *pressure)
{
    const fmi3ValueReference motion = MOTION, profiles[2] = {PROFILE, PRESSURE};
    const fmi3Int64 driven = 1;
    fmi3Float64 values[2 * N_PROFILE];
    int events = 0;
    fmi3Instance c = updating = plain(token, kind >= 1, kind >= 1, kind == 2 ? update : NULL);
    CHECK(fmu.fmi3SetInt64(c, &motion, 1, &driven, 1) == fmi3OK);
    start(c);
    if (kind >= 1) step_mode(c);
    return_at = kind == 2 ? 3.33e-3 : INFINITY;
    double height = real(c, GAP), time = 0.0;
    const double top = height;
    for (int i = 1; i <= 100; i++) {
        const double speed = i <= 50 ? -1.0 : 1.0;
        height += speed * 1e-4;
        do {
            set(c, HEIGHT, height);
            set(c, SPEED, speed);
            CHECK(step(c, time, i * 1e-4 - time) == fmi3OK);
            time = told.time;
            CHECK(told.early || (fabs(real(c, POSITION) - height) < 1e-15 && fabs(real(c, VELOCITY) - speed) < 1e-9));
            if (told.event) {
                events++;
                CHECK(fmu.fmi3EnterEventMode(c) == fmi3OK);
                step_mode(c);
            }
        } while (told.early);
        if (i == 50) {
            CHECK(fmu.fmi3GetFloat64(c, profiles, 2, values, 2 * N_PROFILE) == fmi3OK);
            CHECK(real(c, FORCE) > 100.0 && real(c, FILTERED) > 0.0);
            /* Under the middle of the face the surface is where the face is; outside it falls away from the face. */
            CHECK(fabs(values[0] - height) < 1e-12 && values[N_PROFILE - 1] < height && values[N_PROFILE] > 0.0);
            CHECK(values[2 * N_PROFILE - 1] == 0.0);
            memcpy(pressure, values + N_PROFILE, N_PROFILE * sizeof *pressure);
        }
    }
    CHECK(fabs(height - top) < 1e-15 && real(c, FORCE) == 0.0 && (kind == 0 ? events == 0 : events >= 2));
    const double peak = real(c, PEAK);
    CHECK(fmu.fmi3Terminate(c) == fmi3OK);
    fmu.fmi3FreeInstance(c);
    return peak;
}

/* However the motion is cut into pieces, the rounding of the commands alone makes a difference. */
static void driven(const char *token)
{
    double first[N_PROFILE], again[N_PROFILE];
    const double peak = moved(token, 0, first);
    for (int kind = 1; kind <= 2; kind++) {
        CHECK(fabs(moved(token, kind, again) - peak) < 1e-9 * peak);
        for (int i = 0; i < N_PROFILE; i++) CHECK(fabs(again[i] - first[i]) <= 1e-6 * first[0]);
    }
}

/* Every function that takes an instance, with nulls for everything else. */
static void with_nulls(fmi3Instance c)
{
    CHECK(fmu.fmi3SetDebugLogging(c, fmi3True, 1, NULL) == fmi3Error);
#define NULL_VALUES(type)                                              \
    CHECK(fmu.fmi3Get##type(c, NULL, 1, NULL, 1) == fmi3Error);        \
    CHECK(fmu.fmi3Set##type(c, NULL, 1, NULL, 1) == fmi3Error);
    NULL_VALUES(Float32) NULL_VALUES(Float64) NULL_VALUES(Int8) NULL_VALUES(UInt8) NULL_VALUES(Int16) NULL_VALUES(UInt16)
    NULL_VALUES(Int32) NULL_VALUES(UInt32) NULL_VALUES(Int64) NULL_VALUES(UInt64) NULL_VALUES(Boolean) NULL_VALUES(String)
    CHECK(fmu.fmi3GetBinary(c, NULL, 1, NULL, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3SetBinary(c, NULL, 1, NULL, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3GetClock(c, NULL, 1, NULL) == fmi3Error && fmu.fmi3SetClock(c, NULL, 1, NULL) == fmi3Error);
    CHECK(fmu.fmi3GetNumberOfVariableDependencies(c, FORCE, NULL) == fmi3Error);
    CHECK(fmu.fmi3GetVariableDependencies(c, FORCE, NULL, NULL, NULL, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3GetFMUState(c, NULL) == fmi3Error && fmu.fmi3SetFMUState(c, NULL) == fmi3Error);
    CHECK(fmu.fmi3SerializedFMUStateSize(c, NULL, NULL) == fmi3Error);
    CHECK(fmu.fmi3SerializeFMUState(c, NULL, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3DeserializeFMUState(c, NULL, 1, NULL) == fmi3Error);
    CHECK(fmu.fmi3GetDirectionalDerivative(c, NULL, 1, NULL, 1, NULL, 1, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3GetAdjointDerivative(c, NULL, 1, NULL, 1, NULL, 1, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3GetIntervalDecimal(c, NULL, 1, NULL, NULL) == fmi3Error);
    CHECK(fmu.fmi3GetIntervalFraction(c, NULL, 1, NULL, NULL, NULL) == fmi3Error);
    CHECK(fmu.fmi3GetShiftDecimal(c, NULL, 1, NULL) == fmi3Error);
    CHECK(fmu.fmi3GetShiftFraction(c, NULL, 1, NULL, NULL) == fmi3Error);
    CHECK(fmu.fmi3SetIntervalDecimal(c, NULL, 1, NULL) == fmi3Error);
    CHECK(fmu.fmi3SetIntervalFraction(c, NULL, 1, NULL, NULL) == fmi3Error);
    CHECK(fmu.fmi3SetShiftDecimal(c, NULL, 1, NULL) == fmi3Error);
    CHECK(fmu.fmi3SetShiftFraction(c, NULL, 1, NULL, NULL) == fmi3Error);
    CHECK(fmu.fmi3EvaluateDiscreteStates(c) == fmi3Error && fmu.fmi3EnterContinuousTimeMode(c) == fmi3Error);
    CHECK(fmu.fmi3UpdateDiscreteStates(c, NULL, NULL, NULL, NULL, NULL, NULL) == fmi3Error);
    CHECK(fmu.fmi3CompletedIntegratorStep(c, fmi3True, NULL, NULL) == fmi3Error && fmu.fmi3SetTime(c, 0.0) == fmi3Error);
    CHECK(fmu.fmi3SetContinuousStates(c, NULL, 1) == fmi3Error && fmu.fmi3GetContinuousStates(c, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3GetContinuousStateDerivatives(c, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3GetEventIndicators(c, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3GetNominalsOfContinuousStates(c, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3GetNumberOfEventIndicators(c, NULL) == fmi3Error);
    CHECK(fmu.fmi3GetNumberOfContinuousStates(c, NULL) == fmi3Error);
    CHECK(fmu.fmi3GetOutputDerivatives(c, NULL, 1, NULL, NULL, 1) == fmi3Error);
    CHECK(fmu.fmi3DoStep(c, 0.0, SAMPLE, fmi3False, NULL, NULL, NULL, NULL) == fmi3Error);
    CHECK(fmu.fmi3ActivateModelPartition(c, 0, 0.0) == fmi3Error);
}

/* Values, steps and references that are refused in step mode, each without a trace in the state. */
static const struct { fmi3ValueReference reference; double value; } REALS[] = {
    {PUSH, NAN}, {PUSH, INFINITY}, {PUSH, -INFINITY}, {PUSH, 1e300}, {HEIGHT, 2.0}, {MASS, 4.0}, {FORCE, 1.0}, {TIME, 1.0},
    {SHAPE, 1.0}, {ELEMENTS, 1.0}, {UNKNOWN, 1.0}, {PROFILE, 1.0}, {UINT32_MAX, 0.0},
};
static const struct { double point, size; fmi3Status status; } STEPS[] = {
    {0.0, 50e-6, fmi3Discard}, {NAN, 50e-6, fmi3Discard}, {INFINITY, 50e-6, fmi3Discard}, {1.0, 50e-6, fmi3Discard},
    {3e-3, NAN, fmi3Discard}, {3e-3, INFINITY, fmi3Discard}, {3e-3, -INFINITY, fmi3Discard}, {3e-3, 0.0, fmi3Discard},
    {3e-3, -50e-6, fmi3Discard}, {3e-3, 1e300, fmi3Discard}, {3.01e-3, 50e-6, fmi3Discard}, {2.99e-3, 50e-6, fmi3Discard},
    /* The standard has a rule of its own for the stop time. */
    {3e-3, 20e-3, fmi3Error}, {3e-3, 12.001e-3, fmi3Error},
};

static size_t saved(fmi3Instance c, fmi3Byte **bytes)
{
    fmi3FMUState state = NULL;
    size_t size = 0;
    CHECK(fmu.fmi3GetFMUState(c, &state) == fmi3OK && fmu.fmi3SerializedFMUStateSize(c, state, &size) == fmi3OK);
    *bytes = malloc(size);
    CHECK(fmu.fmi3SerializeFMUState(c, state, *bytes, size) == fmi3OK && fmu.fmi3FreeFMUState(c, &state) == fmi3OK);
    return size;
}

static void refusals(const char *token)
{
    const fmi3ValueReference points = N_POINTS, push[2] = {PUSH, HEIGHT}, profile = PROFILE, active = ACTIVE;
    const fmi3UInt64 seven = 7;
    const fmi3Float64 pair[2] = {5.0, NAN};
    const fmi3Boolean yes = fmi3True;
    fmi3Byte *before, *after;
    fmi3Float64 values[4];

    fmi3Instance c = plain(token, fmi3False, fmi3False, NULL);
    CHECK(fmu.fmi3SetUInt64(c, &points, 1, &seven, 1) == fmi3Error);
    CHECK(fmu.fmi3EnterStepMode(c) == fmi3Error && fmu.fmi3EnterEventMode(c) == fmi3Error);
    CHECK(fmu.fmi3ExitConfigurationMode(c) == fmi3Error && fmu.fmi3ExitInitializationMode(c) == fmi3Error);
    CHECK(fmu.fmi3Terminate(c) == fmi3Error && step(c, 0.0, SAMPLE) == fmi3Error);
    CHECK(fmu.fmi3EnterInitializationMode(c, 0, 0.0, NAN, 0, 0.0) == fmi3Error);
    CHECK(fmu.fmi3EnterInitializationMode(c, 0, 0.0, 1.0, 1, 0.5) == fmi3Error);
    CHECK(fmu.fmi3EnterConfigurationMode(c) == fmi3OK);
    CHECK(fmu.fmi3SetFloat64(c, push, 1, pair, 1) == fmi3Error);
    for (fmi3UInt64 bad = 0; bad < 2; bad++) CHECK(fmu.fmi3SetUInt64(c, &points, 1, &bad, 1) == fmi3Error);
    CHECK(fmu.fmi3ExitConfigurationMode(c) == fmi3OK);
    start(c);
    run(c, 0, 60, SAMPLE);
    const size_t size = saved(c, &before);
    for (size_t i = 0; i < sizeof REALS / sizeof *REALS; i++) {
        const int logged = errors_logged;
        CHECK(fmu.fmi3SetFloat64(c, &REALS[i].reference, 1, &REALS[i].value, 1) == fmi3Error && errors_logged == logged + 1);
    }
    for (size_t i = 0; i < sizeof STEPS / sizeof *STEPS; i++) {
        const int logged = errors_logged, discarded = discards_logged, is_error = STEPS[i].status == fmi3Error;
        CHECK(step(c, STEPS[i].point, STEPS[i].size) == STEPS[i].status);
        CHECK(errors_logged == logged + is_error && discards_logged == discarded + !is_error);
        CHECK(fabs(told.time - 3e-3) < 1e-12 && !told.early && !told.event);
    }
    CHECK(fmu.fmi3SetFloat64(c, push, 2, pair, 2) == fmi3Error);
    CHECK(fmu.fmi3SetFloat64(c, push, 1, pair, 2) == fmi3Error && fmu.fmi3GetFloat64(c, &profile, 1, values, 4) == fmi3Error);
    CHECK(fmu.fmi3SetFloat64(c, push, SIZE_MAX, pair, SIZE_MAX) == fmi3Error);
    CHECK(fmu.fmi3SetBoolean(c, &active, 1, &yes, 1) == fmi3Error && fmu.fmi3SetUInt64(c, &points, 1, &seven, 1) == fmi3Error);
    CHECK(fmu.fmi3EnterEventMode(c) == fmi3Error && fmu.fmi3EnterConfigurationMode(c) == fmi3Error);
    CHECK(fmu.fmi3EnterInitializationMode(c, 0, 0.0, 0.0, 0, 0.0) == fmi3Error);
    with_nulls(c);
    CHECK(saved(c, &after) == size && memcmp(before, after, size) == 0);
    run(c, 60, 300, SAMPLE);
    CHECK(strcmp(text(c), expected) == 0);
    CHECK(fmu.fmi3Terminate(c) == fmi3OK && fmu.fmi3Terminate(c) == fmi3Error && step(c, 0.015, SAMPLE) == fmi3Error);
    with_nulls(c);
    fmu.fmi3FreeInstance(c);
    free(before);
    free(after);
}

/* A step that the kernel cannot complete: an error, the results readable, and a reset that works. */
static void unstable(const char *token)
{
    const fmi3ValueReference parameters[2] = {SAFETY, 1014};
    const fmi3Float64 values[2] = {1.0, 1e5};
    fmi3FMUState state = NULL;
    fmi3Instance c = plain(token, fmi3False, fmi3False, NULL);
    CHECK(fmu.fmi3SetFloat64(c, parameters, 2, values, 2) == fmi3OK);
    start(c);
    CHECK(step(c, 0.0, 0.015) == fmi3Error && told.time < 0.015);
    CHECK(isfinite(real(c, PEAK)) && fmu.fmi3GetFMUState(c, &state) == fmi3Error && step(c, told.time, SAMPLE) == fmi3Error);
    CHECK(fmu.fmi3Reset(c) == fmi3OK);
    start(c);
    run(c, 0, 300, SAMPLE);
    CHECK(strcmp(text(c), expected) == 0);
    fmu.fmi3FreeInstance(c);
}

/* Start values, and what follows from them, before initialization. */
static void new_instance(const char *token)
{
    const fmi3ValueReference points = N_POINTS, profile = PROFILE, active = ACTIVE, elements = ELEMENTS, shape = SHAPE;
    fmi3Float64 values[25];
    fmi3UInt64 n = 0;
    fmi3Boolean boolean = fmi3True;
    fmi3Int32 count = 0;
    fmi3Int64 choice = -1;
    fmi3Instance c = plain(token, fmi3False, fmi3False, NULL);
    CHECK(real(c, TIME) == 0.0 && real(c, KERNEL_TIME) == 0.0 && real(c, MASS) == 5.0 && real(c, PUSH) == 0.0);
    CHECK(real(c, POSITION) == real(c, GAP) && real(c, FORCE) == 0.0 && real(c, STEP) > 0.0 && strlen(text(c)) == 16);
    CHECK(fmu.fmi3GetUInt64(c, &points, 1, &n, 1) == fmi3OK && n == 25);
    CHECK(fmu.fmi3GetFloat64(c, &profile, 1, values, 25) == fmi3OK && values[0] == 0.0);
    CHECK(fmu.fmi3GetBoolean(c, &active, 1, &boolean, 1) == fmi3OK && !boolean);
    CHECK(fmu.fmi3GetInt32(c, &elements, 1, &count, 1) == fmi3OK && count > 0);
    CHECK(fmu.fmi3GetInt64(c, &shape, 1, &choice, 1) == fmi3OK && choice == 0);
    start(c);
    run(c, 0, 300, SAMPLE);
    CHECK(strcmp(text(c), expected) == 0);
    fmu.fmi3FreeInstance(c);
}

/* With logging off the logger is not called, whatever happens; of categories, those that are on. */
static void logging(const char *token)
{
    const fmi3String error[] = {"logStatusError"}, all[] = {"logAll"}, wrong[] = {"logEvents", "log"};
    fmi3Instance c = fmu.fmi3InstantiateCoSimulation("impact", token, NULL, 0, fmi3False, 0, 0, NULL, 0, &failures, logger, NULL);
    messages_logged = 0;
    CHECK(fmu.fmi3InstantiateCoSimulation("impact", "{}", NULL, 0, fmi3False, 0, 0, NULL, 0, &failures, logger, NULL) == NULL);
    CHECK(fmu.fmi3Terminate(c) == fmi3Error);
    start(c);
    CHECK(step(c, 1.0, SAMPLE) == fmi3Discard && fmu.fmi3EnterStepMode(c) == fmi3Error && messages_logged == 0);
    CHECK(fmu.fmi3SetDebugLogging(c, fmi3True, 1, error) == fmi3OK && messages_logged == 0);
    CHECK(fmu.fmi3EnterStepMode(c) == fmi3Error && messages_logged == 1);
    CHECK(step(c, 1.0, SAMPLE) == fmi3Discard && messages_logged == 1);
    CHECK(fmu.fmi3SetDebugLogging(c, fmi3True, 0, NULL) == fmi3OK && step(c, 1.0, SAMPLE) == fmi3Discard && messages_logged == 2);
    CHECK(fmu.fmi3SetDebugLogging(c, fmi3False, 1, error) == fmi3OK && fmu.fmi3EnterStepMode(c) == fmi3Error);
    CHECK(messages_logged == 2 && step(c, 1.0, SAMPLE) == fmi3Discard && messages_logged == 3);
    CHECK(fmu.fmi3SetDebugLogging(c, fmi3False, 2, wrong) == fmi3Error && fmu.fmi3SetDebugLogging(c, fmi3False, 1, all) == fmi3OK);
    CHECK(step(c, 1.0, SAMPLE) == fmi3Discard && fmu.fmi3Terminate(c) == fmi3OK && fmu.fmi3Reset(c) == fmi3OK);
    CHECK(messages_logged == 3);
    fmu.fmi3FreeInstance(c);
}

static void no_instances(const char *token)
{
    const fmi3ValueReference unknown = UNKNOWN;
#define MAKE(name, token, required, n) \
    fmu.fmi3InstantiateCoSimulation(name, token, NULL, 0, fmi3True, 0, 0, required, n, &failures, logger, NULL)
    CHECK(MAKE(NULL, token, NULL, 0) == NULL && MAKE("", token, NULL, 0) == NULL);
    CHECK(MAKE("impact", NULL, NULL, 0) == NULL && MAKE("impact", "{}", NULL, 0) == NULL);
    CHECK(MAKE("impact", token, NULL, 1) == NULL && MAKE("impact", token, &unknown, 1) == NULL);
    CHECK(fmu.fmi3InstantiateModelExchange("impact", token, NULL, 0, fmi3True, &failures, logger) == NULL);
    CHECK(fmu.fmi3InstantiateScheduledExecution("impact", token, NULL, 0, fmi3True, &failures, logger, NULL, NULL, NULL) == NULL);
    CHECK(errors_logged == 8);
    with_nulls(NULL);
    fmu.fmi3FreeInstance(NULL);
    /* A master without a logger. */
    fmi3Instance c = fmu.fmi3InstantiateCoSimulation("quiet", token, NULL, 0, 1, 0, 0, NULL, 0, NULL, NULL, NULL);
    CHECK(c != NULL);
    with_nulls(c);
    fmu.fmi3FreeInstance(c);
}

/* The number of layers is a count, which has a setter of its own. */
static void layers(const char *token)
{
    const fmi3ValueReference count = LAYER_COUNT, mass = MASS;
    const fmi3Int32 two = 2, five = 5;
    fmi3Int32 found = 0;
    fmi3Instance c = plain(token, fmi3False, fmi3False, NULL);
    CHECK(fmu.fmi3SetInt32(c, &count, 1, &five, 1) == fmi3Error && fmu.fmi3SetInt32(c, &mass, 1, &two, 1) == fmi3Error);
    CHECK(fmu.fmi3GetInt32(c, &count, 1, &found, 1) == fmi3OK && found == 1);
    CHECK(fmu.fmi3SetInt32(c, &count, 1, &two, 1) == fmi3OK);
    set(c, SECOND_THICKNESS, 1e-3);
    start(c);
    run(c, 0, 40, SAMPLE);
    CHECK(fmu.fmi3GetInt32(c, &count, 1, &found, 1) == fmi3OK && found == 2);
    CHECK(fmu.fmi3SetInt32(c, &count, 1, &two, 1) == fmi3Error);
    fmu.fmi3FreeInstance(c);
}

int main(int argc, char **argv)
{
    if (argc != 3 && argc != 4) {
        fprintf(stderr, "usage: %s LIBRARY TOKEN [brief]\n", argv[0]);
        return 2;
    }
    load(argv[1]);
    CHECK(strcmp(fmu.fmi3GetVersion(), fmi3Version) == 0);
    no_instances(argv[2]);
    errors_logged = 0;
    whole_life(argv[2]);
    new_instance(argv[2]);
    logging(argv[2]);
    if (argc == 3) any_steps(argv[2]);
    if (argc == 3) interrupted(argv[2]);
    if (argc == 3) asked_ahead(argv[2]);
    if (argc == 3) pushed(argv[2]);
    if (argc == 3) driven(argv[2]);
    layers(argv[2]);
    refusals(argv[2]);
    if (argc == 3) unstable(argv[2]);
    return failures != 0;
}
