"""Softanvil, through the C ABI."""
import ctypes
import sys
import time

import problem

PARAMETERS = {
    "geometry.length": problem.LENGTH,
    "geometry.core_radius": problem.CORE_RADIUS,
    "impactor.drop_energy": problem.ENERGY,
    "impactor.gap": problem.GAP,
    "face.friction_coefficient": 0.0,
    "layers[0].density": problem.DENSITY,
    "layers[0].law": 0,  # neo-Hooke
    "layers[0].c10": problem.SHEAR / 2,
    "layers[0].volumetric_by": 0,  # bulk modulus
    "layers[0].bulk_modulus": problem.BULK,
    "layers[0].prony_g_1": 0.0,
    "layers[0].prony_g_2": 0.0,
    "layers[0].slider_stiffness": 0.0,
    "time.duration": problem.DURATION,
}
# Bytes of a SoftanvilScenario: a header of six words, and the slots of the parameters.
SCENARIO_BYTES = 24 + 384 * 8
REPEATS = 200


def main(path):
    library = ctypes.CDLL(path)
    library.softanvil_scenario_set_by_name.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double, ctypes.c_void_p]
    library.softanvil_run.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]
    library.softanvil_version_text.restype = ctypes.c_char_p

    def call(name, *arguments):
        status = getattr(library, name)(*arguments)
        assert status == 0, f"{name} returned {status}"

    scenario = (ctypes.c_double * (SCENARIO_BYTES // 8))()
    call("softanvil_scenario_default", 0, scenario)
    for name, value in PARAMETERS.items():
        call("softanvil_scenario_set_by_name", scenario, name.encode(), value, None)
    size, alignment = ctypes.c_size_t(), ctypes.c_size_t()
    call("softanvil_memory_size", scenario, ctypes.byref(size), ctypes.byref(alignment), None)
    memory = (ctypes.c_double * (size.value // 8 + 1))()
    simulation = ctypes.c_void_p()
    call("softanvil_init", memory, size, scenario, ctypes.byref(simulation), None)
    fastest = float("inf")
    for _ in range(REPEATS):
        call("softanvil_reset", simulation)
        start = time.perf_counter()
        call("softanvil_run", simulation, problem.DURATION, None, None)
        fastest = min(fastest, time.perf_counter() - start)
    steps, peak = ctypes.c_uint64(), ctypes.c_double()
    call("softanvil_step_index", simulation, ctypes.byref(steps))
    call("softanvil_output_by_name", simulation, b"result.peak_force", ctypes.byref(peak))
    elements = len(problem.triangles())
    return problem.row("Softanvil", library.softanvil_version_text().decode(), f"fastest of {REPEATS} drops", elements, steps.value, fastest, fastest, peak.value)


if __name__ == "__main__":
    problem.write(sys.argv[1], main(sys.argv[2]))
