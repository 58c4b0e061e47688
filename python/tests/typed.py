"""What type checkers must accept, and, by `# type: ignore` that they need, refuse."""

from typing import assert_type

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

import softanvil as sa

scenario = sa.preset("study")
scenario.impactor.energy = 9.8
scenario.impactor.energy = "9.8 J"
scenario.impactor.gap = np.float64(2e-3)
scenario.impactor.motion = "drop"
scenario.impactor.motion = "dropped"  # type: ignore[assignment]  # pyright: ignore[reportAttributeAccessIssue]
scenario.impactor.mas = 5.0  # type: ignore[attr-defined]  # pyright: ignore[reportAttributeAccessIssue]
scenario.layers[0].rows = 3
scenario.layers.add("pad", thickness="8 mm", law="neo_hookean", c10=1e5)
assert_type(scenario.impactor.mass, float)
assert_type(scenario.layers[0].rows, int)
assert_type(scenario.layers[0].thickness, float)
assert_type(scenario.silicone, sa.Layer)

result = sa.run(scenario, frames=0.5e-3)
assert_type(result.peak_force, float)
assert_type(result.trace, pd.DataFrame)
assert_type(result.plot(), Figure)
assert_type(result.frames, list[sa.State])
assert_type(sa.run_many([scenario]), list[sa.Result])
assert_type(sa.run_many([scenario], errors="return"), list[sa.Result | Exception])
assert_type(sa.sweep(scenario, {"impactor.energy": [4.9, 9.8], "impactor.mass": 5.0}), pd.DataFrame)
assert_type(sa.Simulation(scenario).drive([0.0, -1e-3]), pd.DataFrame)
