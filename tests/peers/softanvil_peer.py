"""Softanvil, through the C ABI."""
import ctypes
import re
import time
from pathlib import Path

import problem

PARAMETERS = {
    "geometry.core_radius": problem.CORE_RADIUS,
    "impactor.drop_energy": problem.ENERGY,
    "impactor.gap": problem.GAP,
    "core.interface": 0,  # bonded
    "face.friction_coefficient": 0.0,
    "layers[0].density": problem.DENSITY,
    "layers[0].law": 0,  # neo-Hooke
    "layers[0].c10": problem.SHEAR / 2,
    "layers[0].volumetric_by": 0,  # bulk modulus
    "layers[0].bulk_modulus": problem.BULK,
    "layers[0].prony_g_1": 0.0,
    "layers[0].prony_g_2": 0.0,
    "layers[0].slider_stiffness": 0.0,
}
# The solid is a quarter of a prism with free ends, the default, and its face reaches past all corners.
OWN = {"section": {}, "solid": {"geometry.formulation": 2, "impactor.face_diameter": 0.2}}
HEADER = Path(__file__).resolve().parents[2] / "include/softanvil.h"
REPEATS = {"section": 200, "solid": 5}


class Library:
    """The functions of the C ABI, of which none may fail."""

    def __init__(self, path):
        self.functions = ctypes.CDLL(path)
        set_by_name, run = self.functions.softanvil_scenario_set_by_name, self.functions.softanvil_run
        set_by_name.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double, ctypes.c_void_p]
        run.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]
        self.functions.softanvil_version_text.restype = ctypes.c_char_p

    def call(self, name, *arguments):
        status = getattr(self.functions, name)(*arguments)
        assert status == 0, f"{name} returned {status}"

    def version(self):
        return self.functions.softanvil_version_text().decode()


def scenario(library, of):
    # A SoftanvilScenario: six words of 4 bytes, and the slots of the parameters.
    made = (ctypes.c_double * (3 + int(re.search(r"PARAMETER_SLOTS (\d+)", HEADER.read_text())[1])))()
    library.call("softanvil_scenario_default", 0, made)
    own = {"geometry.length": of.length, "time.duration": of.duration}
    for name, value in {**PARAMETERS, **own, **OWN[of.name]}.items():
        library.call("softanvil_scenario_set_by_name", made, name.encode(), value, None)
    return made


def fastest_run(library, simulation, of):
    """Wall time of the fastest of some drops, s."""
    fastest = float("inf")
    for _ in range(REPEATS[of.name]):
        library.call("softanvil_reset", simulation)
        start = time.perf_counter()
        library.call("softanvil_run", simulation, of.duration, None, None)
        fastest = min(fastest, time.perf_counter() - start)
    return fastest


def peer(of, path):
    library = Library(path)
    made = scenario(library, of)
    size, alignment = ctypes.c_size_t(), ctypes.c_size_t()
    library.call("softanvil_memory_size", made, ctypes.byref(size), ctypes.byref(alignment), None)
    memory = (ctypes.c_double * (size.value // 8 + 1))()
    simulation = ctypes.c_void_p()
    library.call("softanvil_init", memory, size, made, ctypes.byref(simulation), None)
    fastest = fastest_run(library, simulation, of)
    steps, peak = ctypes.c_uint64(), ctypes.c_double()
    library.call("softanvil_step_index", simulation, ctypes.byref(steps))
    library.call("softanvil_output_by_name", simulation, b"result.peak_force", ctypes.byref(peak))
    what = f"fastest of {REPEATS[of.name]} drops"
    return problem.row(of, "Softanvil", library.version(), what, steps.value, fastest, fastest, peak.value)


if __name__ == "__main__":
    problem.main(peer)
