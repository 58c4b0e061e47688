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

/** Version of this header. */
#define SOFTANVIL_VERSION_MAJOR 0
/** Version of this header. */
#define SOFTANVIL_VERSION_MINOR 2
/** Version of this header. */
#define SOFTANVIL_VERSION_PATCH 0
/** Version of this header as one number, to be compared with softanvil_version(). */
#define SOFTANVIL_VERSION \
    (SOFTANVIL_VERSION_MAJOR * 1000000 + SOFTANVIL_VERSION_MINOR * 1000 + SOFTANVIL_VERSION_PATCH)
/** Version of this header as text. */
#define SOFTANVIL_VERSION_TEXT "0.2.0"
/** Digest of what the kernel of this version computes, to be compared with softanvil_kernel_digest(). */
#define SOFTANVIL_KERNEL_DIGEST UINT64_C(0x4c9961584d3151ab)

/* ================================================================================================================ */
/* Status and errors                                                                                                */
/* ================================================================================================================ */

/**
 * Result of a call. Numbers are stable: a retired one stays reserved, new ones are added. Treat an unknown number as
 * a failure.
 *
 * 100 to 199: the call itself; 200 to 299: the scenario; 300 to 399: a step; 400 to 499: a snapshot.
 */
enum SoftanvilStatus
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
    /** Done. */
    SOFTANVIL_STATUS_OK = 0,
    /** A pointer that must point to something is null. */
    SOFTANVIL_STATUS_NULL_POINTER = 100,
    /** A pointer is not aligned as its type or the simulation's memory needs it. */
    SOFTANVIL_STATUS_MISALIGNED = 101,
    /** A buffer is too short. */
    SOFTANVIL_STATUS_SHORT_BUFFER = 102,
    /** A structure was never initialised by this library, was closed, or was overwritten. */
    SOFTANVIL_STATUS_UNINITIALISED = 103,
    /** No such parameter, output, choice or preset. */
    SOFTANVIL_STATUS_UNKNOWN_ID = 104,
    /** No such name. */
    SOFTANVIL_STATUS_UNKNOWN_NAME = 105,
    /** A parameter's value is not a number, is outside its legal range, or is not one of its choices. */
    SOFTANVIL_STATUS_ILLEGAL_VALUE = 200,
    /** The Prony coefficients leave no long-term stiffness. */
    SOFTANVIL_STATUS_PRONY_SUM = 201,
    /** The elastic coefficients give no positive shear modulus at rest. */
    SOFTANVIL_STATUS_SHEAR_MODULUS = 202,
    /** The impactor's face is narrower than two cells of the mesh. */
    SOFTANVIL_STATUS_FACE_TOO_SMALL = 203,
    /** The element size asks for more cells than a mesh may have. */
    SOFTANVIL_STATUS_TOO_MANY_CELLS = 204,
    /** The stable time step is smaller than any that is offered. */
    SOFTANVIL_STATUS_STEP_TOO_SMALL = 205,
    /** The given time step is above the stability limit at rest. */
    SOFTANVIL_STATUS_STEP_TOO_LARGE = 206,
    /** A slot of a scenario or an input that has no meaning in this version is not zero. */
    SOFTANVIL_STATUS_RESERVED_SLOT = 207,
    /** The stretch at which a layer begins to tear is below 1. */
    SOFTANVIL_STATUS_TEAR_STRETCH = 208,
    /** A layer has no thickness, or next to none; a layer that the preset does not have needs one. */
    SOFTANVIL_STATUS_LAYER_THICKNESS = 209,
    /** An axisymmetric anvil has no full section. */
    SOFTANVIL_STATUS_FULL_AXISYMMETRIC = 210,
    /** Only a full section can have an impactor beside the centre line. */
    SOFTANVIL_STATUS_OFFSET_OF_HALF = 211,
    /** An element has no area. */
    SOFTANVIL_STATUS_NO_AREA = 212,
    /** A value differs from the preset's and has no effect beside the others. */
    SOFTANVIL_STATUS_NO_EFFECT = 213,
    /** Two values that state the same thing differ from the preset's. */
    SOFTANVIL_STATUS_CONTRADICTION = 214,
    /** The formulation of the section cannot have a face of this shape. */
    SOFTANVIL_STATUS_FACE_OF_FORMULATION = 215,
    /** The r of a layer's softening is below 1. */
    SOFTANVIL_STATUS_SOFTENING = 218,
    /** The coefficients of a compressible law give no positive bulk modulus at rest. */
    SOFTANVIL_STATUS_BULK_MODULUS = 219,
    /** A layer is wider than what it lies on. */
    SOFTANVIL_STATUS_LAYER_WIDTH = 216,
    /** The library was built without pads, which the scenario needs. */
    SOFTANVIL_STATUS_WITHOUT_PADS = 217,
    /** A solid does not have what the scenario asks for. */
    SOFTANVIL_STATUS_NOT_IN_SOLID = 220,
    /** An element turned inside out or is no longer finite. */
    SOFTANVIL_STATUS_INVERTED = 300,
    /** The time step is above the current stability limit of an element. */
    SOFTANVIL_STATUS_UNSTABLE = 301,
    /** The input of a step is not a finite number. */
    SOFTANVIL_STATUS_ILLEGAL_INPUT = 302,
    /** The time to run to is not a number, is past, or is too far ahead. */
    SOFTANVIL_STATUS_ILLEGAL_TIME = 303,
    /** The bytes are not a snapshot of this format version. */
    SOFTANVIL_STATUS_SNAPSHOT_FORMAT = 400,
    /** The snapshot belongs to a different scenario. */
    SOFTANVIL_STATUS_SNAPSHOT_FOREIGN = 401,
    /** The snapshot's checksum does not match its content. */
    SOFTANVIL_STATUS_SNAPSHOT_CORRUPT = 402,
    /** The simulation has failed in a step and is not worth saving. */
    SOFTANVIL_STATUS_SNAPSHOT_FAILED = 403,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum SoftanvilStatus SoftanvilStatus;
#else
typedef int32_t SoftanvilStatus;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

/** No parameter, no element. */
#define SOFTANVIL_NONE UINT32_MAX

/** Bytes of the text of a `SoftanvilError`, its NUL included. */
#define SOFTANVIL_ERROR_TEXT_SIZE 256

/**
 * Why a call failed. The caller owns it; a function writes the whole of it when it fails and leaves it alone when it
 * succeeds. Numbers that do not apply are NaN.
 */
typedef struct SoftanvilError {
    /** The status that the function returned, a `SoftanvilStatus`. */
    int32_t status;
    /** Number of the refused parameter, a `SoftanvilParameter`; otherwise SOFTANVIL_NONE. */
    uint32_t parameter;
    /** Index of the element that failed; otherwise SOFTANVIL_NONE. */
    uint32_t element;
    /** Always 0. */
    uint32_t reserved_word;
    /** The refused value, in the unit of what was refused: a parameter, a length in bytes, a time step in s. */
    double value;
    /** Smallest legal value. */
    double min;
    /** Largest legal value. */
    double max;
    /** Simulated time of a failed step, s. */
    double time;
    /** Always 0. */
    double reserved[4];
    /** One line for people, with the value, its unit and what is legal; ends with a NUL. */
    char text[SOFTANVIL_ERROR_TEXT_SIZE];
} SoftanvilError;

/* ================================================================================================================ */
/* Library                                                                                                          */
/* ================================================================================================================ */

/**
 * Version of the library that is running, to be compared with `SOFTANVIL_VERSION` of the header: an equal major number
 * (while it is 0: an equal minor number too) promises that the two fit together.
 *
 * @return `SOFTANVIL_VERSION` of the library: major * 1000000 + minor * 1000 + patch.
 */
uint32_t softanvil_version(void);

/**
 * Version of the library that is running, as text.
 *
 * @return A static string such as "1.2.3".
 */
const char *softanvil_version_text(void);

/**
 * Digest of what the kernel computes: that of the last states of its golden traces, which `softanvil golden check` computes anew
 * on any machine. Libraries with the same digest give the same bits, whatever their version and target.
 *
 * @return 64 bits, which packages state as 16 hexadecimal digits.
 */
uint64_t softanvil_kernel_digest(void);

/**
 * What a status means, in general. `SoftanvilError` says more about one failure.
 *
 * @param status A `SoftanvilStatus`, or any other number.
 * @return A static string; "unknown status" for an unknown number.
 */
const char *softanvil_status_text(int32_t status);

/* ================================================================================================================ */
/* Numbers of presets, parameters, choices and outputs                                                              */
/* ================================================================================================================ */

/** Ready-made scenarios. */
enum SoftanvilPreset {
    /** the study's soft anvil, 5 parameters fitted to the 12 numbers of its 3 drops */
    SOFTANVIL_PRESET_STUDY = 0,
    /** the study's soft anvil, 4 parameters fitted to the 4 numbers of 14.7 J alone */
    SOFTANVIL_PRESET_STUDY_14_7 = 1,
    /** the study's soft anvil, incompressible, 5 parameters fitted to the 12 numbers */
    SOFTANVIL_PRESET_STUDY_INCOMPRESSIBLE = 2,
    /** the study's anvil of a plain elastic silicone, to start from with a material of one's own */
    SOFTANVIL_PRESET_ELASTIC = 3,
    /** a flat block of the plain elastic silicone on a flat core, bonded */
    SOFTANVIL_PRESET_BLOCK = 4,
    /** the study's anvil of Ecoflex 00-30, elastic, from tension tests of Marechal et al. (2021) */
    SOFTANVIL_PRESET_ECOFLEX_00_30 = 5,
    /** the study's anvil of Dragon Skin 30, elastic, from tension tests of Marechal et al. (2021) */
    SOFTANVIL_PRESET_DRAGON_SKIN_30 = 6,
    /** the study's anvil of Treloar's vulcanised natural rubber, elastic, by Ogden (1972) */
    SOFTANVIL_PRESET_NATURAL_RUBBER = 7,
    /** 10 mm of body padding of rugby union, an elastomeric foam, on the study's soft anvil */
    SOFTANVIL_PRESET_RUGBY_SOFT_ANVIL = 8,
    /** the same body padding on the standard's steel cylinder of 115 mm */
    SOFTANVIL_PRESET_RUGBY_STEEL_ANVIL = 9,
    /** 20 mm of a stiff foam as a motorcyclist's limb protector on a dome of 50 mm radius, 50 J */
    SOFTANVIL_PRESET_EN1621_1 = 10,
    /** 20 mm of a stiff foam as a motorcyclist's back protector under a bar, 50 J; set-up mostly assumed */
    SOFTANVIL_PRESET_EN1621_2 = 11,
    /** 5 mm of a stiff foam as a football player's shin guard, 1 kg with 2 J; set-up mostly assumed */
    SOFTANVIL_PRESET_EN13061 = 12
};

/** Parameters that belong to no layer: name, unit, legal range, meaning. */
enum SoftanvilParameter {
    /** geometry.shape, a SoftanvilGeometryShape: layer on a round core, or a flat block on a flat core. */
    SOFTANVIL_PARAMETER_GEOMETRY_SHAPE = 0,
    /** geometry.formulation, a SoftanvilGeometryFormulation: kinematics: a section in plane strain or turned about its centre line, or a solid in three dimensions. */
    SOFTANVIL_PARAMETER_GEOMETRY_FORMULATION = 1,
    /** geometry.section, a SoftanvilGeometrySection: half of the section with symmetry, or all of it (not of a solid). */
    SOFTANVIL_PARAMETER_GEOMETRY_SECTION = 2,
    /** geometry.core_radius, m, from 0.001 to 1: radius of the rigid core (round shape). */
    SOFTANVIL_PARAMETER_GEOMETRY_CORE_RADIUS = 3,
    /** geometry.length, m, from 0.001 to 10: largest out-of-plane thickness in plane strain (effective length of the layers), or length of a solid prism. */
    SOFTANVIL_PARAMETER_GEOMETRY_LENGTH = 4,
    /** geometry.block_width, m, from 1e-4 to 10: full width, or diameter if axisymmetric (block shape). */
    SOFTANVIL_PARAMETER_GEOMETRY_BLOCK_WIDTH = 5,
    /** impactor.motion, a SoftanvilImpactorMotion: a falling mass, a position given from outside with every call, or down at a speed to a depth and hold. */
    SOFTANVIL_PARAMETER_IMPACTOR_MOTION = 6,
    /** impactor.mass, kg, from 0.001 to 10000: mass of the impactor. */
    SOFTANVIL_PARAMETER_IMPACTOR_MASS = 7,
    /** impactor.face_diameter, m, from 0.001 to 10: diameter of a round face, a sphere or a bar; the chord of a round face that covers a round section is its thickness in plane strain, and a narrower one counts as a rectangle of its area and width. */
    SOFTANVIL_PARAMETER_IMPACTOR_FACE_DIAMETER = 8,
    /** impactor.offset, m, from -1 to 1: distance of the face's centre from the centre line, to the right (full section; half or full solid). */
    SOFTANVIL_PARAMETER_IMPACTOR_OFFSET = 9,
    /** impactor.gap, m, from 0 to 1: height of the face above the anvil at the start. */
    SOFTANVIL_PARAMETER_IMPACTOR_GAP = 10,
    /** impactor.gravity, m/s2, from 0 to 100: acceleration of gravity. */
    SOFTANVIL_PARAMETER_IMPACTOR_GRAVITY = 11,
    /** impactor.drop_by, a SoftanvilImpactorDropBy: which of the next three states the drop. */
    SOFTANVIL_PARAMETER_IMPACTOR_DROP_BY = 12,
    /** impactor.drop_height, m, from 0 to 100: free fall before the start. */
    SOFTANVIL_PARAMETER_IMPACTOR_DROP_HEIGHT = 13,
    /** impactor.drop_energy, J, from 0 to 1e5: kinetic energy at the start. */
    SOFTANVIL_PARAMETER_IMPACTOR_DROP_ENERGY = 14,
    /** impactor.drop_speed, m/s, from 0 to 100: downward speed at the start. */
    SOFTANVIL_PARAMETER_IMPACTOR_DROP_SPEED = 15,
    /** impactor.prescribed_speed, m/s, from 1e-6 to 100: downward speed of the prescribed motion. */
    SOFTANVIL_PARAMETER_IMPACTOR_PRESCRIBED_SPEED = 16,
    /** impactor.prescribed_depth, m, from 0 to 1: depth below the undeformed anvil at which the prescribed motion ends and holds. */
    SOFTANVIL_PARAMETER_IMPACTOR_PRESCRIBED_DEPTH = 17,
    /** impactor.prescribed_rise, s, from 0 to 100: time over which the prescribed speed rises at the start and falls at the end, smoothly; at most travel / speed. */
    SOFTANVIL_PARAMETER_IMPACTOR_PRESCRIBED_RISE = 18,
    /** layers.count, a whole number from 1 to 4: number of layers between core and face, layers[0] next to the core. */
    SOFTANVIL_PARAMETER_LAYERS_COUNT = 19,
    /** core.interface, a SoftanvilCoreInterface: how the layer sits on the core: glued, in contact with friction, on rollers (neither lifts nor rubs), or in contact that lifts and does not rub. */
    SOFTANVIL_PARAMETER_CORE_INTERFACE = 20,
    /** core.friction_coefficient, from 0 to 10: Coulomb coefficient of a frictional core. */
    SOFTANVIL_PARAMETER_CORE_FRICTION_COEFFICIENT = 21,
    /** face.friction_coefficient, from 0 to 10: Coulomb coefficient under the impactor. */
    SOFTANVIL_PARAMETER_FACE_FRICTION_COEFFICIENT = 22,
    /** mesh.element_size, m, from 1e-5 to 0.1: edge length that the structured mesh aims at. */
    SOFTANVIL_PARAMETER_MESH_ELEMENT_SIZE = 23,
    /** time.step_by, a SoftanvilTimeStepBy: which of the next two states the time step. */
    SOFTANVIL_PARAMETER_TIME_STEP_BY = 24,
    /** time.safety_factor, from 0.01 to 1: fraction of the smallest stability limit that a trial of the scenario finds. */
    SOFTANVIL_PARAMETER_TIME_SAFETY_FACTOR = 25,
    /** time.step, s, from 1e-10 to 5e-5: requested step; the largest whole divisor of 50 us not above it is used. */
    SOFTANVIL_PARAMETER_TIME_STEP = 26,
    /** time.design_compression, from 0.01 to 0.95: part of the layer's thickness that a driven face presses it by at most, for which the step is chosen. */
    SOFTANVIL_PARAMETER_TIME_DESIGN_COMPRESSION = 27,
    /** time.duration, s, from 5e-5 to 100: simulated time of a run. */
    SOFTANVIL_PARAMETER_TIME_DURATION = 28,
    /** measurement.force_threshold, N, from 0 to 1e5: force that begins and ends the impact duration. */
    SOFTANVIL_PARAMETER_MEASUREMENT_FORCE_THRESHOLD = 29,
    /** measurement.channel_class, Hz, from 1 to 2000: channel frequency class (SAE J211, ISO 6487) of contact.force_filtered, such as 60, 180, 600 or 1000. */
    SOFTANVIL_PARAMETER_MEASUREMENT_CHANNEL_CLASS = 30,
    /** impactor.shape, a SoftanvilImpactorShape: a flat disc, a flat rectangle, a ball (axisymmetric) or a round bar along the anvil (plane strain). */
    SOFTANVIL_PARAMETER_IMPACTOR_SHAPE = 31,
    /** impactor.face_width, m, from 0.001 to 10: width of a rectangular face across the section. */
    SOFTANVIL_PARAMETER_IMPACTOR_FACE_WIDTH = 32,
    /** impactor.face_length, m, from 0.001 to 10: length of a rectangular face or of a bar along the anvil: the thickness of the section in plane strain, up to geometry.length; over a dome a rectangular face counts as a disc of its area. */
    SOFTANVIL_PARAMETER_IMPACTOR_FACE_LENGTH = 33,
    /** impactor.rail_friction, N, from 0 to 1e5: friction of the rails that guide the falling mass: against its motion, and what holds it at rest. */
    SOFTANVIL_PARAMETER_IMPACTOR_RAIL_FRICTION = 34,
    /** impactor.rail_damping, N.s/m, from 0 to 1e6: force of the rails against the motion, over the speed. */
    SOFTANVIL_PARAMETER_IMPACTOR_RAIL_DAMPING = 35,
    /** geometry.body, a SoftanvilGeometryBody: what a solid makes of its section: drawn along z, or turned about its centre line. */
    SOFTANVIL_PARAMETER_GEOMETRY_BODY = 60,
    /** geometry.symmetry, a SoftanvilGeometrySymmetry: part of a solid that is meshed: x >= 0 and z >= 0 with symmetry, z >= 0 with symmetry, or all of it. */
    SOFTANVIL_PARAMETER_GEOMETRY_SYMMETRY = 61,
    /** geometry.ends, a SoftanvilGeometryEnds: ends of a solid prism: free, or held along z as a section in plane strain. */
    SOFTANVIL_PARAMETER_GEOMETRY_ENDS = 62
};

/** Parameters of a layer, to be given to SOFTANVIL_PARAMETER_OF_LAYER: name, unit, legal range, meaning. */
enum SoftanvilLayer {
    /** layer.thickness, m, from 0 to 0.5: thickness at rest, at least 0.01 mm. */
    SOFTANVIL_LAYER_THICKNESS = 0,
    /** layer.rows, a whole number from 0 to 10000: rows of cells through the thickness; 0 takes as many as come nearest to mesh.element_size. */
    SOFTANVIL_LAYER_ROWS = 1,
    /** layer.density, kg/m3, from 10 to 20000: density. */
    SOFTANVIL_LAYER_DENSITY = 2,
    /** layer.law, a SoftanvilLayerLaw: hyperelastic law, isochoric but for hyperfoam (mooney_rivlin has 2, 3 or 5 parameters, by coefficients of zero). */
    SOFTANVIL_LAYER_LAW = 3,
    /** layer.moduli, a SoftanvilLayerModuli: what the elastic coefficients are: after full relaxation, or before any. */
    SOFTANVIL_LAYER_MODULI = 4,
    /** layer.volumetric_law, a SoftanvilLayerVolumetricLaw: energy of volume change: K/2 (J-1)^2, or K/4 (J^2 - 1 - 2 ln J), which no compression brings to J = 0. */
    SOFTANVIL_LAYER_VOLUMETRIC_LAW = 5,
    /** layer.volumetric_by, a SoftanvilLayerVolumetricBy: which of the next two states the compressibility. */
    SOFTANVIL_LAYER_VOLUMETRIC_BY = 6,
    /** layer.bulk_modulus, Pa, from 100 to 1e12: bulk modulus. */
    SOFTANVIL_LAYER_BULK_MODULUS = 7,
    /** layer.poissons_ratio, from 0 to 0.4999: Poisson's ratio of the long-term law. */
    SOFTANVIL_LAYER_POISSONS_RATIO = 8,
    /** layer.prony_g_1, from 0 to 0.9999: Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off. */
    SOFTANVIL_LAYER_PRONY_G_1 = 9,
    /** layer.prony_tau_1, s, from 1e-7 to 1e6: relaxation time of the Prony term. */
    SOFTANVIL_LAYER_PRONY_TAU_1 = 10,
    /** layer.prony_g_2, from 0 to 0.9999: Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off. */
    SOFTANVIL_LAYER_PRONY_G_2 = 11,
    /** layer.prony_tau_2, s, from 1e-7 to 1e6: relaxation time of the Prony term. */
    SOFTANVIL_LAYER_PRONY_TAU_2 = 12,
    /** layer.prony_g_3, from 0 to 0.9999: Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off. */
    SOFTANVIL_LAYER_PRONY_G_3 = 13,
    /** layer.prony_tau_3, s, from 1e-7 to 1e6: relaxation time of the Prony term. */
    SOFTANVIL_LAYER_PRONY_TAU_3 = 14,
    /** layer.prony_g_4, from 0 to 0.9999: Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off. */
    SOFTANVIL_LAYER_PRONY_G_4 = 15,
    /** layer.prony_tau_4, s, from 1e-7 to 1e6: relaxation time of the Prony term. */
    SOFTANVIL_LAYER_PRONY_TAU_4 = 16,
    /** layer.prony_g_5, from 0 to 0.9999: Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off. */
    SOFTANVIL_LAYER_PRONY_G_5 = 17,
    /** layer.prony_tau_5, s, from 1e-7 to 1e6: relaxation time of the Prony term. */
    SOFTANVIL_LAYER_PRONY_TAU_5 = 18,
    /** layer.maxwell_g_1, Pa, from 0 to 1e11: shear modulus of an additive Maxwell term; 0 switches the term off. */
    SOFTANVIL_LAYER_MAXWELL_G_1 = 19,
    /** layer.maxwell_beta_1, 1/s, from 1e-6 to 1e7: decay constant of the Maxwell term, one over its relaxation time. */
    SOFTANVIL_LAYER_MAXWELL_BETA_1 = 20,
    /** layer.maxwell_g_2, Pa, from 0 to 1e11: shear modulus of an additive Maxwell term; 0 switches the term off. */
    SOFTANVIL_LAYER_MAXWELL_G_2 = 21,
    /** layer.maxwell_beta_2, 1/s, from 1e-6 to 1e7: decay constant of the Maxwell term, one over its relaxation time. */
    SOFTANVIL_LAYER_MAXWELL_BETA_2 = 22,
    /** layer.maxwell_g_3, Pa, from 0 to 1e11: shear modulus of an additive Maxwell term; 0 switches the term off. */
    SOFTANVIL_LAYER_MAXWELL_G_3 = 23,
    /** layer.maxwell_beta_3, 1/s, from 1e-6 to 1e7: decay constant of the Maxwell term, one over its relaxation time. */
    SOFTANVIL_LAYER_MAXWELL_BETA_3 = 24,
    /** layer.maxwell_g_4, Pa, from 0 to 1e11: shear modulus of an additive Maxwell term; 0 switches the term off. */
    SOFTANVIL_LAYER_MAXWELL_G_4 = 25,
    /** layer.maxwell_beta_4, 1/s, from 1e-6 to 1e7: decay constant of the Maxwell term, one over its relaxation time. */
    SOFTANVIL_LAYER_MAXWELL_BETA_4 = 26,
    /** layer.maxwell_g_5, Pa, from 0 to 1e11: shear modulus of an additive Maxwell term; 0 switches the term off. */
    SOFTANVIL_LAYER_MAXWELL_G_5 = 27,
    /** layer.maxwell_beta_5, 1/s, from 1e-6 to 1e7: decay constant of the Maxwell term, one over its relaxation time. */
    SOFTANVIL_LAYER_MAXWELL_BETA_5 = 28,
    /** layer.slider_stiffness, Pa, from 0 to 1e11: shear modulus G of the damping spring; 0 switches the spring-slider off. */
    SOFTANVIL_LAYER_SLIDER_STIFFNESS = 29,
    /** layer.slider_yield_stress, Pa, from 0 to 1e10: von Mises stress SIGF at which the slider slips. */
    SOFTANVIL_LAYER_SLIDER_YIELD_STRESS = 30,
    /** layer.tear_stretch, from 0 to 100: largest principal stretch at which the material begins to tear, at least 1; 0 switches tearing off. */
    SOFTANVIL_LAYER_TEAR_STRETCH = 31,
    /** layer.tear_width, from 0.001 to 10: stretch over which the deviatoric stress falls. */
    SOFTANVIL_LAYER_TEAR_WIDTH = 32,
    /** layer.tear_residual, from 0 to 1: part of the deviatoric stress that remains after the tear. */
    SOFTANVIL_LAYER_TEAR_RESIDUAL = 33,
    /** layer.width, m, from 0 to 10: width along its lower side, full or, of a dome, the diameter; 0 is as wide as what is below it. */
    SOFTANVIL_LAYER_WIDTH = 34,
    /** layer.interface, a SoftanvilLayerInterface: how it sits on the layer below: glued, or free to lift and slide, with friction or without. */
    SOFTANVIL_LAYER_INTERFACE = 35,
    /** layer.friction_coefficient, from 0 to 10: Coulomb coefficient of a frictional interface below it. */
    SOFTANVIL_LAYER_FRICTION_COEFFICIENT = 36,
    /** layer.gap, m, from 0 to 0.1: distance to the layer below at rest, where they are not bonded. */
    SOFTANVIL_LAYER_GAP = 37,
    /** layer.softening_r, from 0 to 100: r of the softening after the first load (Ogden and Roxburgh 1999), at least 1; 0 switches it off. */
    SOFTANVIL_LAYER_SOFTENING_R = 40,
    /** layer.softening_m, Pa, from 1 to 1e9: m of the softening, the energy that its scale starts from. */
    SOFTANVIL_LAYER_SOFTENING_M = 41,
    /** layer.softening_beta, from 0 to 10: beta of the softening, the part of the largest energy so far in its scale. */
    SOFTANVIL_LAYER_SOFTENING_BETA = 42,
    /** layer.c10, Pa, from -1e9 to 1e9: coefficient of (I1 - 3) in neo_hookean, mooney_rivlin and yeoh. */
    SOFTANVIL_LAYER_C10 = 48,
    /** layer.c01, Pa, from -1e9 to 1e9: mooney_rivlin coefficient of (I2 - 3). */
    SOFTANVIL_LAYER_C01 = 49,
    /** layer.c11, Pa, from -1e9 to 1e9: mooney_rivlin coefficient of (I1 - 3)(I2 - 3). */
    SOFTANVIL_LAYER_C11 = 50,
    /** layer.c20, Pa, from -1e9 to 1e9: mooney_rivlin and yeoh coefficient of (I1 - 3)^2. */
    SOFTANVIL_LAYER_C20 = 51,
    /** layer.c02, Pa, from -1e9 to 1e9: mooney_rivlin coefficient of (I2 - 3)^2. */
    SOFTANVIL_LAYER_C02 = 52,
    /** layer.c30, Pa, from -1e9 to 1e9: yeoh coefficient of (I1 - 3)^3. */
    SOFTANVIL_LAYER_C30 = 53,
    /** layer.ogden_mu_1, Pa, from -1e9 to 1e9: ogden coefficient, W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3); 0 switches the term off. */
    SOFTANVIL_LAYER_OGDEN_MU_1 = 54,
    /** layer.ogden_alpha_1, from -30 to 30: ogden exponent; the shear modulus at rest is sum mu alpha / 2. */
    SOFTANVIL_LAYER_OGDEN_ALPHA_1 = 55,
    /** layer.ogden_mu_2, Pa, from -1e9 to 1e9: ogden coefficient, W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3); 0 switches the term off. */
    SOFTANVIL_LAYER_OGDEN_MU_2 = 56,
    /** layer.ogden_alpha_2, from -30 to 30: ogden exponent; the shear modulus at rest is sum mu alpha / 2. */
    SOFTANVIL_LAYER_OGDEN_ALPHA_2 = 57,
    /** layer.ogden_mu_3, Pa, from -1e9 to 1e9: ogden coefficient, W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3); 0 switches the term off. */
    SOFTANVIL_LAYER_OGDEN_MU_3 = 58,
    /** layer.ogden_alpha_3, from -30 to 30: ogden exponent; the shear modulus at rest is sum mu alpha / 2. */
    SOFTANVIL_LAYER_OGDEN_ALPHA_3 = 59,
    /** layer.gent_mu, Pa, from 0 to 1e9: gent shear modulus at rest, W = -mu Jm/2 ln(1 - (I1 - 3)/Jm). */
    SOFTANVIL_LAYER_GENT_MU = 60,
    /** layer.gent_jm, from 0.01 to 1e6: gent limit Jm of I1 - 3. */
    SOFTANVIL_LAYER_GENT_JM = 61,
    /** layer.arruda_boyce_mu, Pa, from 0 to 1e9: arruda_boyce modulus; that of shear at rest is mu (1 + 3/5 lambda_m^-2 + ...), series of five terms. */
    SOFTANVIL_LAYER_ARRUDA_BOYCE_MU = 62,
    /** layer.arruda_boyce_lambda_m, from 1 to 100: arruda_boyce stretch at which the chains are fully extended, the root of their number of links. */
    SOFTANVIL_LAYER_ARRUDA_BOYCE_LAMBDA_M = 63,
    /** layer.foam_mu_1, Pa, from -1e9 to 1e9: hyperfoam modulus, W = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3 + (J^(-alpha beta) - 1)/beta); the shear modulus at rest is their sum; 0 switches the term off. */
    SOFTANVIL_LAYER_FOAM_MU_1 = 64,
    /** layer.foam_alpha_1, from -30 to 30: hyperfoam exponent; 0 switches the term off. */
    SOFTANVIL_LAYER_FOAM_ALPHA_1 = 65,
    /** layer.foam_nu_1, from 0 to 0.499: hyperfoam Poisson's ratio of the term, beta = nu/(1 - 2 nu). */
    SOFTANVIL_LAYER_FOAM_NU_1 = 66,
    /** layer.foam_mu_2, Pa, from -1e9 to 1e9: hyperfoam modulus, W = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3 + (J^(-alpha beta) - 1)/beta); the shear modulus at rest is their sum; 0 switches the term off. */
    SOFTANVIL_LAYER_FOAM_MU_2 = 67,
    /** layer.foam_alpha_2, from -30 to 30: hyperfoam exponent; 0 switches the term off. */
    SOFTANVIL_LAYER_FOAM_ALPHA_2 = 68,
    /** layer.foam_nu_2, from 0 to 0.499: hyperfoam Poisson's ratio of the term, beta = nu/(1 - 2 nu). */
    SOFTANVIL_LAYER_FOAM_NU_2 = 69,
    /** layer.foam_mu_3, Pa, from -1e9 to 1e9: hyperfoam modulus, W = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3 + (J^(-alpha beta) - 1)/beta); the shear modulus at rest is their sum; 0 switches the term off. */
    SOFTANVIL_LAYER_FOAM_MU_3 = 70,
    /** layer.foam_alpha_3, from -30 to 30: hyperfoam exponent; 0 switches the term off. */
    SOFTANVIL_LAYER_FOAM_ALPHA_3 = 71,
    /** layer.foam_nu_3, from 0 to 0.499: hyperfoam Poisson's ratio of the term, beta = nu/(1 - 2 nu). */
    SOFTANVIL_LAYER_FOAM_NU_3 = 72
};

/** Number of a parameter of a layer, 0 next to the core: SOFTANVIL_PARAMETER_OF_LAYER(1, SOFTANVIL_LAYER_C10). */
#define SOFTANVIL_PARAMETER_OF_LAYER(layer, parameter) \
    (SOFTANVIL_LAYERS_BEGIN + SOFTANVIL_LAYER_NUMBERS * (uint32_t)(layer) + (uint32_t)(parameter))

/** geometry.shape: layer on a round core, or a flat block on a flat core. */
enum SoftanvilGeometryShape {
    SOFTANVIL_GEOMETRY_SHAPE_ROUND = 0,
    SOFTANVIL_GEOMETRY_SHAPE_BLOCK = 1
};

/** geometry.formulation: kinematics: a section in plane strain or turned about its centre line, or a solid in three dimensions. */
enum SoftanvilGeometryFormulation {
    SOFTANVIL_GEOMETRY_FORMULATION_PLANE_STRAIN = 0,
    SOFTANVIL_GEOMETRY_FORMULATION_AXISYMMETRIC = 1,
    SOFTANVIL_GEOMETRY_FORMULATION_SOLID = 2
};

/** geometry.section: half of the section with symmetry, or all of it (not of a solid). */
enum SoftanvilGeometrySection {
    SOFTANVIL_GEOMETRY_SECTION_HALF = 0,
    SOFTANVIL_GEOMETRY_SECTION_FULL = 1
};

/** geometry.body: what a solid makes of its section: drawn along z, or turned about its centre line. */
enum SoftanvilGeometryBody {
    SOFTANVIL_GEOMETRY_BODY_PRISM = 0,
    SOFTANVIL_GEOMETRY_BODY_REVOLVED = 1
};

/** geometry.symmetry: part of a solid that is meshed: x >= 0 and z >= 0 with symmetry, z >= 0 with symmetry, or all of it. */
enum SoftanvilGeometrySymmetry {
    SOFTANVIL_GEOMETRY_SYMMETRY_QUARTER = 0,
    SOFTANVIL_GEOMETRY_SYMMETRY_HALF = 1,
    SOFTANVIL_GEOMETRY_SYMMETRY_FULL = 2
};

/** geometry.ends: ends of a solid prism: free, or held along z as a section in plane strain. */
enum SoftanvilGeometryEnds {
    SOFTANVIL_GEOMETRY_ENDS_FREE = 0,
    SOFTANVIL_GEOMETRY_ENDS_HELD = 1
};

/** impactor.motion: a falling mass, a position given from outside with every call, or down at a speed to a depth and hold. */
enum SoftanvilImpactorMotion {
    SOFTANVIL_IMPACTOR_MOTION_DROP = 0,
    SOFTANVIL_IMPACTOR_MOTION_DRIVEN = 1,
    SOFTANVIL_IMPACTOR_MOTION_PRESCRIBED = 2
};

/** impactor.shape: a flat disc, a flat rectangle, a ball (axisymmetric) or a round bar along the anvil (plane strain). */
enum SoftanvilImpactorShape {
    SOFTANVIL_IMPACTOR_SHAPE_ROUND = 0,
    SOFTANVIL_IMPACTOR_SHAPE_RECTANGULAR = 1,
    SOFTANVIL_IMPACTOR_SHAPE_SPHERE = 2,
    SOFTANVIL_IMPACTOR_SHAPE_BAR = 3
};

/** impactor.drop_by: which of the next three states the drop. */
enum SoftanvilImpactorDropBy {
    SOFTANVIL_IMPACTOR_DROP_BY_HEIGHT = 0,
    SOFTANVIL_IMPACTOR_DROP_BY_ENERGY = 1,
    SOFTANVIL_IMPACTOR_DROP_BY_SPEED = 2
};

/** core.interface: how the layer sits on the core: glued, in contact with friction, on rollers (neither lifts nor rubs), or in contact that lifts and does not rub. */
enum SoftanvilCoreInterface {
    SOFTANVIL_CORE_INTERFACE_BONDED = 0,
    SOFTANVIL_CORE_INTERFACE_FRICTIONAL = 1,
    SOFTANVIL_CORE_INTERFACE_SLIDING = 2,
    SOFTANVIL_CORE_INTERFACE_SEPARATING = 3
};

/** time.step_by: which of the next two states the time step. */
enum SoftanvilTimeStepBy {
    SOFTANVIL_TIME_STEP_BY_SAFETY_FACTOR = 0,
    SOFTANVIL_TIME_STEP_BY_GIVEN = 1
};

/** layer.interface: how it sits on the layer below: glued, or free to lift and slide, with friction or without. */
enum SoftanvilLayerInterface {
    SOFTANVIL_LAYER_INTERFACE_BONDED = 0,
    SOFTANVIL_LAYER_INTERFACE_FRICTIONAL = 1,
    SOFTANVIL_LAYER_INTERFACE_SEPARATING = 2
};

/** layer.law: hyperelastic law, isochoric but for hyperfoam (mooney_rivlin has 2, 3 or 5 parameters, by coefficients of zero). */
enum SoftanvilLayerLaw {
    SOFTANVIL_LAYER_LAW_NEO_HOOKEAN = 0,
    SOFTANVIL_LAYER_LAW_MOONEY_RIVLIN = 1,
    SOFTANVIL_LAYER_LAW_YEOH = 2,
    SOFTANVIL_LAYER_LAW_OGDEN = 3,
    SOFTANVIL_LAYER_LAW_GENT = 4,
    SOFTANVIL_LAYER_LAW_ARRUDA_BOYCE = 5,
    SOFTANVIL_LAYER_LAW_HYPERFOAM = 6
};

/** layer.moduli: what the elastic coefficients are: after full relaxation, or before any. */
enum SoftanvilLayerModuli {
    SOFTANVIL_LAYER_MODULI_LONG_TERM = 0,
    SOFTANVIL_LAYER_MODULI_INSTANTANEOUS = 1
};

/** layer.volumetric_law: energy of volume change: K/2 (J-1)^2, or K/4 (J^2 - 1 - 2 ln J), which no compression brings to J = 0. */
enum SoftanvilLayerVolumetricLaw {
    SOFTANVIL_LAYER_VOLUMETRIC_LAW_QUADRATIC = 0,
    SOFTANVIL_LAYER_VOLUMETRIC_LAW_SIMO = 1
};

/** layer.volumetric_by: which of the next two states the compressibility. */
enum SoftanvilLayerVolumetricBy {
    SOFTANVIL_LAYER_VOLUMETRIC_BY_BULK_MODULUS = 0,
    SOFTANVIL_LAYER_VOLUMETRIC_BY_POISSONS_RATIO = 1
};

/** Outputs of a simulation: name, unit, meaning. */
enum SoftanvilOutput {
    /** contact.force, N: contact force on the impactor, mean over the last complete sampling interval of 50 us. */
    SOFTANVIL_OUTPUT_CONTACT_FORCE = 0,
    /** contact.force_step, N: contact force on the impactor in the last step alone, with the impulses of single nodes in it. */
    SOFTANVIL_OUTPUT_CONTACT_FORCE_STEP = 1,
    /** core.reaction, N: force of the layer on the core (what load cells under it see), mean over the last sampling interval. */
    SOFTANVIL_OUTPUT_CORE_REACTION = 2,
    /** impactor.position, m: height of the face above the undeformed anvil; negative while it presses. */
    SOFTANVIL_OUTPUT_IMPACTOR_POSITION = 3,
    /** impactor.velocity, m/s: velocity of the impactor, upwards. */
    SOFTANVIL_OUTPUT_IMPACTOR_VELOCITY = 4,
    /** impactor.acceleration, m/s2: acceleration of the impactor in the last step, upwards. */
    SOFTANVIL_OUTPUT_IMPACTOR_ACCELERATION = 5,
    /** impactor.deformation, m: depth of the face below the undeformed anvil. */
    SOFTANVIL_OUTPUT_IMPACTOR_DEFORMATION = 6,
    /** result.peak_force, N: largest contact force so far (of contact.force). */
    SOFTANVIL_OUTPUT_RESULT_PEAK_FORCE = 7,
    /** result.max_deformation, m: largest deformation so far. */
    SOFTANVIL_OUTPUT_RESULT_MAX_DEFORMATION = 8,
    /** result.impact_duration, s: time covered by contact.force at or above measurement.force_threshold. */
    SOFTANVIL_OUTPUT_RESULT_IMPACT_DURATION = 9,
    /** result.impulse, N.s: impulse of the contact force so far. */
    SOFTANVIL_OUTPUT_RESULT_IMPULSE = 10,
    /** result.impact_speed, m/s: downward speed before the first contact. */
    SOFTANVIL_OUTPUT_RESULT_IMPACT_SPEED = 11,
    /** result.rebound_speed, m/s: upward speed after the last contact so far; negative while the impactor still falls. */
    SOFTANVIL_OUTPUT_RESULT_REBOUND_SPEED = 12,
    /** result.restitution: rebound speed over impact speed. */
    SOFTANVIL_OUTPUT_RESULT_RESTITUTION = 13,
    /** result.contact_time, s: time from the first to the last contact so far. */
    SOFTANVIL_OUTPUT_RESULT_CONTACT_TIME = 14,
    /** energy.impactor_kinetic, J: kinetic energy of the impactor. */
    SOFTANVIL_OUTPUT_ENERGY_IMPACTOR_KINETIC = 15,
    /** energy.layer_kinetic, J: kinetic energy of the layer. */
    SOFTANVIL_OUTPUT_ENERGY_LAYER_KINETIC = 16,
    /** energy.elastic, J: long-term elastic energy of the layer. */
    SOFTANVIL_OUTPUT_ENERGY_ELASTIC = 17,
    /** energy.viscous, J: work done on the viscous overstress, dissipated or still in its springs. */
    SOFTANVIL_OUTPUT_ENERGY_VISCOUS = 18,
    /** energy.slider_stored, J: energy in the damping springs. */
    SOFTANVIL_OUTPUT_ENERGY_SLIDER_STORED = 19,
    /** energy.slider_dissipation, J: energy dissipated by the sliders. */
    SOFTANVIL_OUTPUT_ENERGY_SLIDER_DISSIPATION = 20,
    /** energy.friction, J: energy dissipated by friction. */
    SOFTANVIL_OUTPUT_ENERGY_FRICTION = 21,
    /** energy.contact, J: energy lost in catching nodes of finite mass. */
    SOFTANVIL_OUTPUT_ENERGY_CONTACT = 22,
    /** energy.external, J: energy at the start and work from outside. */
    SOFTANVIL_OUTPUT_ENERGY_EXTERNAL = 23,
    /** energy.residual, J: external energy that the other terms leave unexplained. */
    SOFTANVIL_OUTPUT_ENERGY_RESIDUAL = 24,
    /** contact.half_width, m: half of the width over which the face touches the anvil (radius if axisymmetric). */
    SOFTANVIL_OUTPUT_CONTACT_HALF_WIDTH = 25,
    /** energy.tear, J: energy dissipated by tearing. */
    SOFTANVIL_OUTPUT_ENERGY_TEAR = 27,
    /** contact.force_filtered, N: contact.force after the forward pass of the channel filter measurement.channel_class, which lags as any running filter does; the standards' figure without lag needs a second pass backwards over the whole record. */
    SOFTANVIL_OUTPUT_CONTACT_FORCE_FILTERED = 28,
    /** model.design_stretch: smallest principal stretch in the section that the time step was chosen for; 1 where the step was given. */
    SOFTANVIL_OUTPUT_MODEL_DESIGN_STRETCH = 29,
    /** result.complete: 1 once the face has touched and is clear of the layer for a whole sampling interval; at 0 the other results are those so far. */
    SOFTANVIL_OUTPUT_RESULT_COMPLETE = 30,
    /** energy.softening, J: energy dissipated by softening. */
    SOFTANVIL_OUTPUT_ENERGY_SOFTENING = 31,
    /** energy.guide, J: energy dissipated on the rails of the impactor. */
    SOFTANVIL_OUTPUT_ENERGY_GUIDE = 32
};

/** Fields of a simulation: name, unit, components, meaning. */
enum SoftanvilField {
    /** node.reference_position, m, 2 components: position at rest, x outwards from the centre line and y upwards from the centre of the core. */
    SOFTANVIL_FIELD_NODE_REFERENCE_POSITION = 0,
    /** node.position, m, 2 components: current position, x and y. */
    SOFTANVIL_FIELD_NODE_POSITION = 1,
    /** node.displacement, m, 2 components: displacement from rest, x and y. */
    SOFTANVIL_FIELD_NODE_DISPLACEMENT = 2,
    /** node.velocity, m/s, 2 components: velocity half a step back, x and y. */
    SOFTANVIL_FIELD_NODE_VELOCITY = 3,
    /** node.force, N, 2 components: force in the last step on the meshed section, contact and friction included, x and y. */
    SOFTANVIL_FIELD_NODE_FORCE = 4,
    /** surface.contact_force, N, 2 components: force of the face in the last step on the meshed section, pressing and, outwards, by friction. */
    SOFTANVIL_FIELD_SURFACE_CONTACT_FORCE = 5,
    /** surface.contact_pressure, Pa: contact pressure in the last step, over the area halfway to the neighbouring nodes. */
    SOFTANVIL_FIELD_SURFACE_CONTACT_PRESSURE = 6,
    /** element.pressure, Pa: hydrostatic pressure of the last step, positive in compression. */
    SOFTANVIL_FIELD_ELEMENT_PRESSURE = 7,
    /** element.von_mises_stress, Pa: von Mises stress of the last step, viscous and damping parts included. */
    SOFTANVIL_FIELD_ELEMENT_VON_MISES_STRESS = 8,
    /** element.principal_stress, Pa, 3 components: principal Cauchy stresses of the last step: larger and smaller in the section, then out of its plane; of a solid from the largest to the smallest. */
    SOFTANVIL_FIELD_ELEMENT_PRINCIPAL_STRESS = 9,
    /** element.cauchy_stress, Pa, 4 components: Cauchy stress of the last step, positive in tension: xx, yy, xy, and zz out of the section. */
    SOFTANVIL_FIELD_ELEMENT_CAUCHY_STRESS = 10,
    /** element.principal_stretch, 3 components: principal stretches of the last step: larger and smaller in the section, then out of its plane; of a solid from the largest to the smallest. */
    SOFTANVIL_FIELD_ELEMENT_PRINCIPAL_STRETCH = 11,
    /** node.reference_z, m: position at rest along z, of a solid; 0 in a section. */
    SOFTANVIL_FIELD_NODE_REFERENCE_Z = 12,
    /** node.displacement_z, m: displacement along z, of a solid. */
    SOFTANVIL_FIELD_NODE_DISPLACEMENT_Z = 13,
    /** node.velocity_z, m/s: velocity half a step back along z, of a solid. */
    SOFTANVIL_FIELD_NODE_VELOCITY_Z = 14,
    /** surface.friction_z, N: friction force of the face along z in the last step, on the meshed solid. */
    SOFTANVIL_FIELD_SURFACE_FRICTION_Z = 15,
    /** element.shear_stress_z, Pa, 2 components: Cauchy stress of the last step of a solid: yz and zx. */
    SOFTANVIL_FIELD_ELEMENT_SHEAR_STRESS_Z = 16,
    /** node.force_z, N: force along z in the last step on the meshed solid, contact and friction included. */
    SOFTANVIL_FIELD_NODE_FORCE_Z = 17
};

/* ================================================================================================================ */
/* Tables of parameters and outputs                                                                                 */
/* ================================================================================================================ */

/** Bytes of a name, its NUL included. */
#define SOFTANVIL_NAME_SIZE 64

/** Bytes of a unit, its NUL included. */
#define SOFTANVIL_UNIT_SIZE 16

/** Bytes of a description, its NUL included. */
#define SOFTANVIL_DESCRIPTION_SIZE 256

/** One row of the table of parameters. */
typedef struct SoftanvilParameterInfo {
    /** Its number: a `SoftanvilParameter`, or SOFTANVIL_PARAMETER_OF_LAYER of a layer and a `SoftanvilLayer`. */
    uint32_t id;
    /** Number of choices, numbered from 0; 0 for a number. */
    uint32_t choices;
    /** 1 if the value is a whole number, 0 if not. */
    uint32_t is_whole;
    /** The layer that it belongs to, 0 next to the core; SOFTANVIL_NONE if it belongs to none. */
    uint32_t layer;
    /** Smallest legal value. */
    double min;
    /** Largest legal value. */
    double max;
    /** Always 0. */
    double reserved[4];
    /** Name, such as "impactor.mass". */
    char name[SOFTANVIL_NAME_SIZE];
    /** SI unit; "1" for ratios and choices. */
    char unit[SOFTANVIL_UNIT_SIZE];
    /** Meaning, one line. */
    char description[SOFTANVIL_DESCRIPTION_SIZE];
} SoftanvilParameterInfo;

/** One row of the table of outputs. */
typedef struct SoftanvilOutputInfo {
    /** Its number, a `SoftanvilOutput`. */
    uint32_t id;
    /** Always 0. */
    uint32_t reserved_word;
    /** Always 0. */
    double reserved[4];
    /** Name, such as "contact.force". */
    char name[SOFTANVIL_NAME_SIZE];
    /** SI unit; "1" for ratios. */
    char unit[SOFTANVIL_UNIT_SIZE];
    /** Meaning, one line. */
    char description[SOFTANVIL_DESCRIPTION_SIZE];
} SoftanvilOutputInfo;

/**
 * Number of parameters of the library that is running, those of all layers that there can be included. Their numbers have
 * gaps: `softanvil_parameter_at` tells them.
 */
uint32_t softanvil_parameter_count(void);

/**
 * Tells the number of a parameter by its place in the table: what belongs to the test, then what belongs to each layer from
 * the core to the surface, then the rest.
 *
 * @param place Place, 0 to `softanvil_parameter_count()` less one.
 * @param parameter Its number.
 * @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
 */
SoftanvilStatus softanvil_parameter_at(uint32_t place,
                                       uint32_t *parameter);

/** Outputs are numbered from 0 to this less one in the library that is running; a retired number is refused. */
uint32_t softanvil_output_count(void);

/**
 * Finds a parameter by its name.
 *
 * @param name Name, such as "impactor.mass".
 * @param parameter Its number.
 * @return NULL_POINTER, MISALIGNED, UNKNOWN_NAME.
 */
SoftanvilStatus softanvil_parameter_find(const char *name, uint32_t *parameter);

/**
 * Finds an output by its name.
 *
 * @param name Name, such as "contact.force".
 * @param output Its number.
 * @return NULL_POINTER, MISALIGNED, UNKNOWN_NAME.
 */
SoftanvilStatus softanvil_output_find(const char *name, uint32_t *output);

/**
 * Describes a parameter.
 *
 * @param parameter A `SoftanvilParameter`.
 * @param info Its row.
 * @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
 */
SoftanvilStatus softanvil_parameter_info(uint32_t parameter, SoftanvilParameterInfo *info);

/**
 * Names a choice of a parameter.
 *
 * @param parameter A `SoftanvilParameter`.
 * @param choice Number of the choice.
 * @param name Room for the name.
 * @param size Bytes of room; `SOFTANVIL_NAME_SIZE` is always enough.
 * @return NULL_POINTER, UNKNOWN_ID, SHORT_BUFFER.
 */
SoftanvilStatus softanvil_parameter_choice(uint32_t parameter, uint32_t choice, char *name, size_t size);

/**
 * Describes an output.
 *
 * @param output A `SoftanvilOutput`.
 * @param info Its row.
 * @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
 */
SoftanvilStatus softanvil_output_info(uint32_t output, SoftanvilOutputInfo *info);

/* ================================================================================================================ */
/* Scenario                                                                                                         */
/* ================================================================================================================ */

/** Most layers between core and face. */
#define SOFTANVIL_MAX_LAYERS 4

/** Numbers for parameters that belong to no layer, those of future versions included: the layers' begin here. */
#define SOFTANVIL_LAYERS_BEGIN 64

/** Numbers for the parameters of a layer, those of future versions included. */
#define SOFTANVIL_LAYER_NUMBERS 96

/** Room for parameters in a `SoftanvilScenario`, those of future versions included. */
#define SOFTANVIL_PARAMETER_SLOTS 448

/**
 * Description of a drop test. It always comes from `softanvil_scenario_default`; its values may then be changed by
 * `softanvil_scenario_set`, which checks them at once, or directly in `value`, which is checked when it is used.
 *
 * What differs from the preset counts as said. Of values that state the same thing (drop height, energy and speed; bulk
 * modulus and Poisson's ratio; time step and safety factor) the one that is said decides; two of them are refused, and so
 * is a value that has no effect beside the others. With another law than the preset's, coefficients that still have the
 * preset's value are 0: those of the law, Prony and Maxwell terms, the slider and tearing.
 *
 * `layers.count` (SOFTANVIL_PARAMETER_LAYERS_COUNT) says how many layers there are, layer 0 next to the core. Values of layers
 * that are not there have no effect. A layer that the preset does not have needs a thickness, and is else a plain elastic
 * silicone.
 */
typedef struct SoftanvilScenario {
    /** Tells an initialised scenario; do not change. */
    uint32_t marker;
    /** Bytes of this structure; do not change. */
    uint32_t struct_size;
    /** The `SoftanvilPreset` that it came from; do not change. */
    uint32_t preset;
    /**
     * Numbers in use of parameters that belong to no layer; do not change. A library with more parameters takes the preset's
     * values for the rest.
     */
    uint32_t count;
    /** Numbers in use of the parameters of a layer, likewise; do not change. */
    uint32_t layer_count;
    /** Always 0. */
    uint32_t reserved_word;
    /** Value of every parameter, SI, at the place of its number; a choice as its number. The rest is 0. */
    double value[SOFTANVIL_PARAMETER_SLOTS];
} SoftanvilScenario;

/**
 * Fills a scenario with a preset.
 *
 * @param preset A `SoftanvilPreset`.
 * @param scenario The scenario to fill.
 * @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
 */
SoftanvilStatus softanvil_scenario_default(uint32_t preset, SoftanvilScenario *scenario);

/**
 * Sets a parameter. A value that is refused changes nothing. What several parameters say together is checked by
 * `softanvil_memory_size` and `softanvil_init`.
 *
 * @param scenario The scenario to change.
 * @param parameter A `SoftanvilParameter`, or SOFTANVIL_PARAMETER_OF_LAYER of a layer and a `SoftanvilLayer`.
 * @param value Value in the parameter's SI unit; a choice as its number.
 * @param error Details of a failure, or NULL.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID, ILLEGAL_VALUE.
 */
SoftanvilStatus softanvil_scenario_set(SoftanvilScenario *scenario,
                                       uint32_t parameter,
                                       double value,
                                       SoftanvilError *error);

/**
 * As `softanvil_scenario_set`, by the parameter's name.
 *
 * @param scenario The scenario to change.
 * @param name Name, such as "impactor.mass", or `layers[0].c10` of a layer.
 * @param value Value in the parameter's SI unit; a choice as its number.
 * @param error Details of a failure, or NULL.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_NAME, ILLEGAL_VALUE.
 */
SoftanvilStatus softanvil_scenario_set_by_name(SoftanvilScenario *scenario,
                                               const char *name,
                                               double value,
                                               SoftanvilError *error);

/**
 * Reads a parameter.
 *
 * @param scenario The scenario.
 * @param parameter A `SoftanvilParameter`, or SOFTANVIL_PARAMETER_OF_LAYER of a layer and a `SoftanvilLayer`.
 * @param value Value in the parameter's SI unit; a choice as its number.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID.
 */
SoftanvilStatus softanvil_scenario_get(const SoftanvilScenario *scenario,
                                       uint32_t parameter,
                                       double *value);

/**
 * As `softanvil_scenario_get`, by the parameter's name.
 *
 * @param scenario The scenario.
 * @param name Name, such as "impactor.mass", or `layers[0].c10` of a layer.
 * @param value Value in the parameter's SI unit; a choice as its number.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_NAME.
 */
SoftanvilStatus softanvil_scenario_get_by_name(const SoftanvilScenario *scenario,
                                               const char *name,
                                               double *value);

/* ================================================================================================================ */
/* Simulation                                                                                                       */
/* ================================================================================================================ */

/** A simulation. Its content is private; it lives at the front of the memory given to `softanvil_init`. */
typedef struct SoftanvilSimulation SoftanvilSimulation;

/**
 * What acts on the impactor from outside during a call that makes steps, of one or of many. It always comes from
 * `softanvil_input_default`.
 *
 * A driven face is at `driven_position` at the end of the call, that is, after its last step, and moves there from where it
 * is: along a straight line, or, if `driven_velocity` is given, along the cubic that starts with the velocity that
 * `impactor.velocity` tells before the call and ends with `driven_velocity`. So a master that cuts time into calls gives
 * with each where the face is to be at the end of that call, and the motion has no jump.
 *
 * A value that is not legal, NaN among them, is refused as ILLEGAL_INPUT; the call makes no step then, changes nothing, and
 * the next one may go on. An input that does not act (a force on a driven impactor, a position of a falling one) may be
 * any finite number.
 */
typedef struct SoftanvilInput {
    /** Tells an initialised input; do not change. */
    uint32_t marker;
    /** Bytes of this structure; do not change. */
    uint32_t struct_size;
    /** Upward force on a falling impactor besides gravity and contact, from -1e6 to 1e6 N; held over the call. */
    double external_force;
    /**
     * Height of the face of a driven impactor above the undeformed anvil at the end of the call, from -1 to 1 m; negative
     * presses.
     */
    double driven_position;
    /** Always 0. */
    double reserved[4];
    /**
     * Upward velocity of the face of a driven impactor at the end of the call, from -100 to 100 m/s; NaN, which stands there
     * at first, for a straight line.
     */
    double driven_velocity;
} SoftanvilInput;

/**
 * Tells how much memory a simulation of a scenario needs; checks the scenario.
 *
 * @param scenario The scenario.
 * @param size Bytes.
 * @param alignment Bytes that the address must be a multiple of; any malloc gives at least as much. On a cache line
 *        (64 bytes) steps are some per cents faster; simulations of different threads run best on pages of their own.
 * @param error Details of a failure, or NULL.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, or a status of the scenario (200 to 299).
 */
SoftanvilStatus softanvil_memory_size(const SoftanvilScenario *scenario,
                                      size_t *size,
                                      size_t *alignment,
                                      SoftanvilError *error);

/**
 * Builds a simulation, at the start of its drop, in memory that the caller lends. The scenario is copied.
 *
 * The simulation holds no address: between calls the memory may be copied or moved to any address of the same
 * alignment in the same process, and the copy is a simulation of its own at its address. If the function fails because
 * of the time step (STEP_TOO_SMALL, STEP_TOO_LARGE), the content of the memory is lost; if for anything else, untouched.
 *
 * @param memory The memory; it stays the caller's, who keeps it until the simulation is no longer used.
 * @param size Bytes of it, at least those of `softanvil_memory_size`.
 * @param scenario The scenario.
 * @param simulation The simulation, which is the address of the memory.
 * @param error Details of a failure, or NULL.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, SHORT_BUFFER, or a status of the scenario (200 to 299).
 */
SoftanvilStatus softanvil_init(void *memory,
                               size_t size,
                               const SoftanvilScenario *scenario,
                               SoftanvilSimulation **simulation,
                               SoftanvilError *error);

/**
 * Ends a simulation: from now on its address is refused as UNINITIALISED, as long as the memory is not used otherwise.
 * There is nothing to free; forgetting this call leaks nothing.
 *
 * @param simulation The simulation.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED.
 */
SoftanvilStatus softanvil_close(SoftanvilSimulation *simulation);

/**
 * Takes a simulation back to the start of its drop.
 *
 * @param simulation The simulation.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED.
 */
SoftanvilStatus softanvil_reset(SoftanvilSimulation *simulation);

/**
 * Lets the anvil rest and the impactor fall again on it, as it is: time, samples, numbers of the test and energies begin anew.
 *
 * The anvil keeps its damage (tears, and what has softened), comes back to its shape and stands still; overstresses decay
 * by e^(-rest/tau). It may be called at any time of an impact.
 *
 * @param simulation The simulation.
 * @param rest Time between the impacts, 0 to 1e9 s.
 * @param error Details of a failure, or NULL.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, ILLEGAL_INPUT for a rest that is not legal, INVERTED or UNSTABLE of a
 *         simulation that has failed.
 */
SoftanvilStatus softanvil_next_impact(SoftanvilSimulation *simulation,
                                      double rest,
                                      SoftanvilError *error);

/**
 * Fills an input that leaves things as they are: no external force, and a driven impactor stays where it is, without a
 * velocity for the end.
 *
 * @param simulation The simulation.
 * @param input The input to fill.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED.
 */
SoftanvilStatus softanvil_input_default(const SoftanvilSimulation *simulation,
                                        SoftanvilInput *input);

/**
 * Makes steps of the simulation's fixed time step: the force is held, and a driven face is at `driven_position` after the
 * last of them. The work of a step is bounded and does not depend on the state.
 *
 * A step that fails (INVERTED, UNSTABLE) leaves the steps before it done and stops the simulation: every further step fails
 * alike until the simulation is reset or restored. Arguments that are refused, an ILLEGAL_INPUT among them, change nothing.
 *
 * @param simulation The simulation.
 * @param steps Number of steps; 0 does nothing.
 * @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
 * @param error Details of a failure, or NULL.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, RESERVED_SLOT, or a status of a step (300 to 399).
 */
SoftanvilStatus softanvil_step(SoftanvilSimulation *simulation,
                               uint64_t steps,
                               const SoftanvilInput *input,
                               SoftanvilError *error);

/**
 * Makes the steps up to the end of the running sampling interval of 50 us, where `contact.force` and `core.reaction`
 * get a new value, and where a driven face is at `driven_position`.
 *
 * @param simulation The simulation.
 * @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
 * @param error Details of a failure, or NULL.
 * @return As `softanvil_step`.
 */
SoftanvilStatus softanvil_step_to_sample(SoftanvilSimulation *simulation,
                                         const SoftanvilInput *input,
                                         SoftanvilError *error);

/**
 * Makes the steps that cover a time, rounded up to whole sampling intervals of 50 us, at whose end a driven face is at
 * `driven_position`. A drop of the study is over after the 15 ms of `time.duration`.
 *
 * @param simulation The simulation.
 * @param duration Time, s, in the legal range of `time.duration`.
 * @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
 * @param error Details of a failure, or NULL.
 * @return As `softanvil_step`, and ILLEGAL_VALUE for the duration.
 */
SoftanvilStatus softanvil_run(SoftanvilSimulation *simulation,
                              double duration,
                              const SoftanvilInput *input,
                              SoftanvilError *error);

/**
 * Makes the steps to the one nearest to a time, of two equally near to the later; none if the simulation is there. So it is
 * never more than half a step away from the time asked for, and makes the same steps however time is cut. A driven face is
 * at `driven_position` after the last step, at the time that `softanvil_time` tells then.
 *
 * @param simulation The simulation.
 * @param time Time since the start of the drop, s: from half a step before the present to 100 s after it.
 * @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
 * @param error Details of a failure, or NULL.
 * @return As `softanvil_step`, and ILLEGAL_TIME.
 */
SoftanvilStatus softanvil_run_until(SoftanvilSimulation *simulation,
                                    double time,
                                    const SoftanvilInput *input,
                                    SoftanvilError *error);

/**
 * Reads an output at the current time.
 *
 * @param simulation The simulation.
 * @param output A `SoftanvilOutput`.
 * @param value Value in the output's SI unit.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID.
 */
SoftanvilStatus softanvil_output(const SoftanvilSimulation *simulation, uint32_t output, double *value);

/**
 * As `softanvil_output`, by the output's name.
 *
 * @param simulation The simulation.
 * @param name Name, such as "contact.force".
 * @param value Value in the output's SI unit.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_NAME.
 */
SoftanvilStatus softanvil_output_by_name(const SoftanvilSimulation *simulation,
                                         const char *name,
                                         double *value);

/**
 * Tells the simulated time, from the number of steps made and never an accumulated sum: whole sampling intervals of 50 us,
 * for which it is the double nearest to the time, and the steps beyond them times the step.
 *
 * @param simulation The simulation.
 * @param time Time since the start of the drop, s.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED.
 */
SoftanvilStatus softanvil_time(const SoftanvilSimulation *simulation,
                               double *time);

/**
 * Tells the number of steps made since the start of the drop.
 *
 * @param simulation The simulation.
 * @param step_index Number of steps.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED.
 */
SoftanvilStatus softanvil_step_index(const SoftanvilSimulation *simulation, uint64_t *step_index);

/**
 * Tells the fixed time step, a whole divisor of 50 us.
 *
 * @param simulation The simulation.
 * @param dt Time step, s.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED.
 */
SoftanvilStatus softanvil_dt(const SoftanvilSimulation *simulation, double *dt);

/**
 * Tells the number of steps in a sampling interval of 50 us.
 *
 * @param simulation The simulation.
 * @param steps Number of steps.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED.
 */
SoftanvilStatus softanvil_steps_per_sample(const SoftanvilSimulation *simulation, uint64_t *steps);

/**
 * Tells the digest of all samples so far (FNV-1a, 64 bit, over the bits of contact force, core reaction and impactor
 * position at every 50 us): equal digests mean equal traces to the last bit, on whatever machine.
 *
 * @param simulation The simulation.
 * @param trace_hash The digest.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED.
 */
SoftanvilStatus softanvil_trace_hash(const SoftanvilSimulation *simulation,
                                     uint64_t *trace_hash);

/* ================================================================================================================ */
/* Trace                                                                                                            */
/* ================================================================================================================ */

/**
 * What `softanvil_run_traced` calls after every sample. It may call every function that takes a `const` simulation; it
 * must not change the simulation, throw, or jump out.
 *
 * @param simulation The simulation, at the time of the sample.
 * @param context What was given to `softanvil_run_traced`.
 * @return 0 to go on, anything else to end the run here.
 */
typedef int32_t (*SoftanvilTrace)(const SoftanvilSimulation *simulation, void *context);

/**
 * As `softanvil_run`, and calls `trace` after every sampling interval of 50 us. A run that `trace` ends early has
 * succeeded; the simulation stands at that sample.
 *
 * @param simulation The simulation.
 * @param duration Time, s, in the legal range of `time.duration`.
 * @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
 * @param trace What to call.
 * @param context Handed to `trace` untouched; may be NULL.
 * @param error Details of a failure, or NULL.
 * @return As `softanvil_run`.
 */
SoftanvilStatus softanvil_run_traced(SoftanvilSimulation *simulation,
                                     double duration,
                                     const SoftanvilInput *input,
                                     SoftanvilTrace trace,
                                     void *context,
                                     SoftanvilError *error);

/* ================================================================================================================ */
/* Fields                                                                                                           */
/* ================================================================================================================ */

/** One row of the table of fields. */
typedef struct SoftanvilFieldInfo {
    /** Its number, a `SoftanvilField`. */
    uint32_t id;
    /** Numbers per value: 1, 2 (x and y) or 3. */
    uint32_t components;
    /** Always 0. */
    double reserved[4];
    /** Name, such as "node.displacement". */
    char name[SOFTANVIL_NAME_SIZE];
    /** SI unit. */
    char unit[SOFTANVIL_UNIT_SIZE];
    /** Meaning, one line. */
    char description[SOFTANVIL_DESCRIPTION_SIZE];
} SoftanvilFieldInfo;

/**
 * One component of a field: the number at (row, column) is `data[row * row_stride + column * column_stride]`.
 *
 * Nodes lie in rows from the core to the surface and in columns from one edge of the section to the other; the surface
 * is one row; triangles lie in the rows of their cells, two columns per cell, so that triangle `element` of a
 * `SoftanvilError` is in row `element / columns`, column `element % columns`.
 */
typedef struct SoftanvilView {
    /** First number, inside the memory of the simulation; NULL if the field is computed when it is read. */
    const double *data;
    /** Rows. */
    size_t rows;
    /** Columns. */
    size_t columns;
    /** Numbers from one row to the next; 0 if the field is computed. */
    size_t row_stride;
    /** Numbers from one column to the next; 0 if the field is computed. */
    size_t column_stride;
    /** Always 0. */
    size_t reserved[3];
} SoftanvilView;

/** Fields are numbered from 0 to this less one in the library that is running; a retired number is refused. */
uint32_t softanvil_field_count(void);

/**
 * Finds a field by its name.
 *
 * @param name Name, such as "node.displacement".
 * @param field Its number.
 * @return NULL_POINTER, MISALIGNED, UNKNOWN_NAME.
 */
SoftanvilStatus softanvil_field_find(const char *name, uint32_t *field);

/**
 * Describes a field.
 *
 * @param field A `SoftanvilField`.
 * @param info Its row.
 * @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
 */
SoftanvilStatus softanvil_field_info(uint32_t field, SoftanvilFieldInfo *info);

/**
 * Shows one component of a field: its shape and, unless the field is computed, its numbers where they lie. The view
 * shows the present of the simulation for as long as its memory is neither moved nor used otherwise.
 *
 * @param simulation The simulation.
 * @param field A `SoftanvilField`.
 * @param component Component, from 0.
 * @param view The view.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID.
 */
SoftanvilStatus softanvil_field_view(const SoftanvilSimulation *simulation,
                                     uint32_t field,
                                     uint32_t component,
                                     SoftanvilView *view);

/**
 * Copies one component of a field, stored or computed, to where the caller wants it: the number at (row, column) goes
 * to `values[(row * columns + column) * stride]`, and nothing in between is touched.
 *
 * @param simulation The simulation.
 * @param field A `SoftanvilField`.
 * @param component Component, from 0.
 * @param values Room for the numbers.
 * @param count Numbers of room there, at least `(rows * columns - 1) * stride + 1`.
 * @param stride Numbers from one value to the next; the number of components interleaves them, 0 counts as 1.
 * @param error Details of a failure, or NULL.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID, SHORT_BUFFER.
 */
SoftanvilStatus softanvil_field_read(const SoftanvilSimulation *simulation,
                                     uint32_t field,
                                     uint32_t component,
                                     double *values,
                                     size_t count,
                                     size_t stride,
                                     SoftanvilError *error);

/* ================================================================================================================ */
/* Snapshot                                                                                                         */
/* ================================================================================================================ */

/**
 * Tells how long a snapshot of a simulation is.
 *
 * @param simulation The simulation.
 * @param size Bytes.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED.
 */
SoftanvilStatus softanvil_snapshot_size(const SoftanvilSimulation *simulation, size_t *size);

/**
 * Saves the state of a simulation. The bytes mean the same on every machine; equal states give equal bytes.
 *
 * @param simulation The simulation.
 * @param bytes Where the snapshot goes.
 * @param size Bytes there, at least those of `softanvil_snapshot_size`; the rest stays untouched.
 * @param error Details of a failure, or NULL.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, SHORT_BUFFER, SNAPSHOT_FAILED.
 */
SoftanvilStatus softanvil_snapshot_save(const SoftanvilSimulation *simulation,
                                        uint8_t *bytes,
                                        size_t size,
                                        SoftanvilError *error);

/**
 * Restores the state of a simulation from a snapshot of the same scenario, whichever machine saved it. What follows
 * has the same bits as if nothing had been saved. A snapshot that is refused changes nothing.
 *
 * The checksum finds damage, not malice: restore only what comes from a trusted place.
 *
 * @param simulation The simulation, which may have failed.
 * @param bytes The snapshot.
 * @param size Bytes of it, at least those of `softanvil_snapshot_size`; the rest is not read.
 * @param error Details of a failure, or NULL.
 * @return NULL_POINTER, MISALIGNED, UNINITIALISED, SHORT_BUFFER, or a status of a snapshot (400 to 499).
 */
SoftanvilStatus softanvil_snapshot_restore(SoftanvilSimulation *simulation,
                                           const uint8_t *bytes,
                                           size_t size,
                                           SoftanvilError *error);

#ifdef __cplusplus
}
#endif

#endif /* SOFTANVIL_H */
