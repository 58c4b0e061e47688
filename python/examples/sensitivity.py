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
# # What the peak force depends on
# Sobol indices through SALib: first-order indices say what a parameter explains alone, total ones what it explains with all its
# interactions.

# %%
import os

import matplotlib.pyplot as plt
import pandas as pd
from SALib.analyze import sobol as analysis
from SALib.sample import sobol

import softanvil as sa

QUICK = "SOFTANVIL_QUICK" in os.environ
ranges = {
    "impactor.energy": [8.8, 10.8],
    "silicone.thickness": [13e-3, 17e-3],
    "silicone.c10": [1.2e5, 1.8e5],
    "silicone.prony_g_1": [0.955, 0.975],
    "core.friction_coefficient": [0.1, 0.5],
}
problem = {"num_vars": len(ranges), "names": list(ranges), "bounds": list(ranges.values())}
design = pd.DataFrame(sobol.sample(problem, 16 if QUICK else 256, calc_second_order=False, seed=1), columns=list(ranges))
base = sa.preset("study").update({"core.interface": "frictional"})
if QUICK:
    base.mesh.element_size = "5 mm"

# %%
table = sa.sweep(base, design, progress=False)
assert (table["ending"] == "complete").all(), table["error"].unique()
print(f"{len(table)} drops")

# %%
figure, columns = plt.subplots(1, 2, figsize=(10, 3.5), layout="constrained", sharey=True)
for axes, name in zip(columns, ["peak_force", "max_deformation"], strict=True):
    found = analysis.analyze(problem, table[name].to_numpy(), calc_second_order=False, seed=1)
    indices = pd.DataFrame({"first order": found["S1"], "total": found["ST"]}, index=list(ranges))
    indices.plot.barh(ax=axes, xerr=pd.DataFrame({"first order": found["S1_conf"], "total": found["ST_conf"]}, index=list(ranges)))
    axes.set(xlabel="part of the variance", title=name.replace("_", " "))
    axes.invert_yaxis()
