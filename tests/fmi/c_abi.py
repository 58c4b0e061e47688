"""A driven face by the C ABI, to compare the FMU with."""

import ctypes
import os
import re
from pathlib import Path

HEADER = Path(__file__).parents[2] / "include" / "softanvil.h"
# Bytes of a SoftanvilScenario: a header of six words, and the slots of the parameters.
SCENARIO_BYTES = 24 + 8 * int(re.search(r"#define SOFTANVIL_PARAMETER_SLOTS (\d+)", HEADER.read_text())[1])


class Input(ctypes.Structure):
    """SoftanvilInput."""

    _fields_ = [("marker", ctypes.c_uint32), ("struct_size", ctypes.c_uint32), ("external_force", ctypes.c_double),
                ("driven_position", ctypes.c_double), ("reserved", ctypes.c_double * 4), ("driven_velocity", ctypes.c_double)]


def driven(times, positions, outputs, **parameters):
    """Rows of `outputs` after each call of a face that is driven to `positions` at `times`, from the study's scenario with
    `parameters`; a parameter's dot is written as two underscores."""
    library = ctypes.CDLL(str(Path(os.environ["SOFTANVIL_CLI"]).with_name("libsoftanvil.so")))
    library.softanvil_scenario_set_by_name.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double, ctypes.c_void_p]
    library.softanvil_run_until.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]

    def call(name, *arguments):
        status = getattr(library, name)(*arguments)
        assert status == 0, f"{name} returned {status}"

    scenario = (ctypes.c_double * (SCENARIO_BYTES // 8))()
    call("softanvil_scenario_default", 0, scenario)
    for name, value in {"impactor__motion": 1, **parameters}.items():
        call("softanvil_scenario_set_by_name", scenario, name.replace("__", ".").encode(), value, None)
    size, alignment, simulation, value = ctypes.c_size_t(), ctypes.c_size_t(), ctypes.c_void_p(), ctypes.c_double()
    call("softanvil_memory_size", scenario, ctypes.byref(size), ctypes.byref(alignment), None)
    memory = (ctypes.c_double * (size.value // 8 + 1))()
    call("softanvil_init", memory, size, scenario, ctypes.byref(simulation), None)
    command, rows = Input(), []
    call("softanvil_input_default", simulation, ctypes.byref(command))
    for time, command.driven_position in zip(times, positions, strict=True):
        call("softanvil_run_until", simulation, time, ctypes.byref(command), None)
        rows.append([])
        for name in outputs:
            call("softanvil_output_by_name", simulation, name.encode(), ctypes.byref(value))
            rows[-1].append(value.value)
    call("softanvil_close", simulation)
    return rows
