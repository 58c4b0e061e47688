"""Softanvil: drop tests on a soft anvil, by explicit finite elements that give the same bits everywhere.

    import softanvil as sa

    s = sa.preset("study")
    s.impactor.energy = 9.8        # J; also "9.8 J", or a quantity of pint
    r = sa.run(s)
    r.peak_force                   # N
    r.trace                        # a pandas.DataFrame by time
    r.plot()

`Scenario` says what is dropped on what, `run` and `run_many` simulate it, `Simulation` goes step by step, `sweep` studies many
on one machine or on a cluster of Dask; `fit`, `measure`, `protect`, `reduction`, `calibrate` and `read_trace` are the commands of
the command line. All numbers are in SI units.
"""

from . import _softanvil
from ._animation import Animation
from ._commands import (
    Calibration,
    Fit,
    Measurement,
    Reduction,
    Verdict,
    calibrate,
    fit,
    material_front,
    measure,
    protect,
    read_trace,
    reduction,
)
from ._design import design
from ._errors import FileError, ParameterError, ScenarioError, SimulationError, SoftanvilError
from ._plot import compare
from ._result import Result, run, run_many
from ._scenario import Layer, Layers, Scenario, preset, presets
from ._simulation import Simulation
from ._state import State
from ._sweep import sweep
from ._tables import fields, outputs, parameters

__version__: str = _softanvil.version()
#: Digest of what the kernel computes: packages with the same digest give the same bits.
kernel_digest: str = _softanvil.kernel_digest()
#: What the package was compiled for.
target: str = _softanvil.target()

__all__ = [
    "Animation",
    "Calibration",
    "FileError",
    "Fit",
    "Layer",
    "Layers",
    "Measurement",
    "ParameterError",
    "Reduction",
    "Result",
    "Scenario",
    "ScenarioError",
    "Simulation",
    "SimulationError",
    "SoftanvilError",
    "State",
    "Verdict",
    "calibrate",
    "compare",
    "design",
    "fields",
    "fit",
    "kernel_digest",
    "material_front",
    "measure",
    "outputs",
    "parameters",
    "preset",
    "presets",
    "protect",
    "read_trace",
    "reduction",
    "run",
    "run_many",
    "sweep",
    "target",
]
