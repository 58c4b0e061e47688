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
# # Peak force over energy and thickness
# A design of Sobol points, a smooth surface through them, and how well it predicts drops that it has not seen.

# %%
import os

import matplotlib.pyplot as plt
import numpy as np
from scipy.interpolate import RBFInterpolator
from scipy.stats import qmc

import softanvil as sa

QUICK = "SOFTANVIL_QUICK" in os.environ
ranges = {"impactor.energy": (3.0, 15.0), "silicone.thickness": (8e-3, 20e-3)}
design = sa.design(ranges, qmc.Sobol(2, rng=1).random(32 if QUICK else 256))

# %% [markdown]
# On a cluster this call gets `client=`; with `out="folder"` it can be continued.

# %%
table = sa.sweep(sa.preset("study"), design, progress=False)
table.head()

# %% [markdown]
# A thin-plate spline of the peak force, fitted to three quarters of the drops.

# %%
low, high = np.array(list(ranges.values())).T
unit = (table[list(ranges)].to_numpy() - low) / (high - low)
force = 1e-3 * table["peak_force"].to_numpy()
seen = np.arange(len(table)) % 4 != 0
surface = RBFInterpolator(unit[seen], force[seen])
error = surface(unit[~seen]) / force[~seen] - 1
print(f"drops that the surface has not seen: {100 * np.sqrt(np.mean(error**2)):.2f} % off (root mean square)")

# %%
energy, thickness = np.meshgrid(*np.linspace(low, high, 60).T)
grid = np.column_stack([energy.ravel(), thickness.ravel()])
values = surface((grid - low) / (high - low)).reshape(energy.shape)
figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
lines = axes.contourf(energy, 1e3 * thickness, values, levels=14, cmap="viridis")
axes.scatter(table["impactor.energy"], 1e3 * table["silicone.thickness"], c="white", s=6)
axes.set(xlabel="impact energy (J)", ylabel="thickness (mm)", title="peak force")
figure.colorbar(lines, label="kN");
