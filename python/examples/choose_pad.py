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
# # Choose a pad
# Which stiffness and thickness keep the force below a limit with the least material? A pad is a layer on the anvil; too soft a
# pad bottoms out, too stiff a one passes the blow on.

# %%
import os

import matplotlib.pyplot as plt

import softanvil as sa

QUICK = "SOFTANVIL_QUICK" in os.environ
anvil = sa.preset("study")
anvil.impactor.energy = "9.8 J"
anvil.mesh.element_size = "6 mm" if QUICK else "4 mm"
bare = sa.run(anvil)
print(f"bare: {1e-3 * bare.peak_force:.2f} kN")

# %%
padded = anvil.copy()
padded.layers.add("pad", thickness="6 mm", law="neo_hookean", c10="100 kPa", poissons_ratio=0.45)
stiffness = [20e3, 60e3, 200e3] if QUICK else [10e3, 20e3, 40e3, 80e3, 160e3, 320e3]
thickness = ["4 mm", "12 mm"] if QUICK else ["4 mm", "6 mm", "8 mm", "10 mm", "12 mm"]
table = sa.sweep(padded, {"pad.c10": stiffness, "pad.thickness": thickness}, progress=False)
table.loc[table["error"] != "", ["pad.c10", "pad.thickness", "error"]]

# %%
figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
for depth, rows in table.groupby("pad.thickness"):
    axes.semilogx(1e-3 * rows["pad.c10"], 1e-3 * rows["peak_force"], "o-", label=f"{1e3 * depth:.0f} mm")
axes.axhline(1e-3 * bare.peak_force, color="0.5", ls="--", label="bare")
axes.set_xticks([1e-3 * c10 for c10 in stiffness], [f"{1e-3 * c10:g}" for c10 in stiffness], minor=False)
axes.minorticks_off()
axes.set(xlabel="c10 of the pad (kPa)", ylabel="peak force (kN)", ylim=(0, None))
axes.legend(frameon=False, title="thickness");

# %% [markdown]
# The thinnest pad that halves the force, beside the bare anvil.

# %%
good = table[table["peak_force"] < 0.5 * bare.peak_force].sort_values(["pad.thickness", "peak_force"])
best = good.iloc[0] if len(good) else table.sort_values("peak_force").iloc[0]
chosen = padded.copy().update({"pad.c10": best["pad.c10"], "pad.thickness": best["pad.thickness"]})
result = sa.run(chosen, frames=0.5e-3)
figure = sa.compare([bare, result], ["bare", f"{1e3 * chosen.pad.thickness:.0f} mm, c10 {1e-3 * chosen.pad.c10:.0f} kPa"])

# %%
deepest = max(result.frames, key=lambda state: state.output("impactor.deformation"))
axes = deepest.plot("element.pressure")

# %% [markdown]
# `protect` gives what a standard asks for, energies and how far every layer is pressed.

# %%
sa.protect(chosen)
