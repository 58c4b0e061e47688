# ---
# jupyter:
#   jupytext:
#     formats: py:percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Calibrate against your own traces
# Two measured traces of force, a problem file that says what may change, and a search. The traces of this notebook are made here,
# with a material that the search does not know; put your own files in their place.

# %%
import os
from pathlib import Path
from tempfile import mkdtemp

import matplotlib.pyplot as plt
import numpy as np

import softanvil as sa

QUICK = "SOFTANVIL_QUICK" in os.environ
folder = Path(mkdtemp())
truth = sa.preset("elastic").update({"silicone.c10": 1.5e5, "silicone.poissons_ratio": 0.35, "mesh.element_size": "7.5 mm"})
noise = np.random.default_rng(1)
for energy in (2.0, 4.0):
    drop = sa.run(truth.copy().update({"impactor.energy": energy}))
    force = drop.trace["contact.force"] + noise.normal(0, 0.01 * drop.peak_force, len(drop.trace))
    force.rename("force [N]").rename_axis("time [s]").to_csv(folder / f"drop-{energy:g}.csv")

# %% [markdown]
# The problem: which parameters, in which range, against which impacts.

# %%
problem = folder / "problem.toml"
problem.write_text(f"""
preset = "elastic"
[fixed]
"mesh.element_size" = 7.5e-3
[search]
seed = 1
evaluations = {60 if QUICK else 400}
[parameters]
"silicone.c10" = {{ min = 5e4, max = 5e5, scale = "log" }}
"silicone.poissons_ratio" = {{ min = 0.2, max = 0.48 }}
[[impact]]
energy = 2.0
trace = "drop-2.csv"
[[impact]]
energy = 4.0
trace = "drop-4.csv"
""")
found = sa.calibrate(problem, out=folder / "out")
found

# %% [markdown]
# What was found beside what the traces were made with, and the course of the search.

# %%
print(f"c10 {found.scenario.silicone.c10:.4g} Pa (150000), Poisson's ratio {found.scenario.silicone.poissons_ratio:.3f} (0.35)")
figure, (over_time, course) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
for energy in (2.0, 4.0):
    measured = sa.read_trace(folder / f"drop-{energy:g}.csv")
    scenario = found.scenario.copy().update({"impactor.energy": energy})
    compared = sa.measure(scenario, trace=folder / f"drop-{energy:g}.csv").trace
    over_time.plot(1e3 * compared.index, compared["measured force"], ".", ms=3, color="0.6")
    over_time.plot(1e3 * compared.index, compared["force"], label=f"{energy:g} J")
over_time.set(xlabel="time (ms)", ylabel="contact force (N)")
over_time.legend(frameon=False, title="simulated")
course.plot(found.evaluations["score [1]"].cummin())
course.set(xlabel="evaluations", ylabel="best score so far", ylim=(0, None));
