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
# # A first drop
# A 5 kg flat mass falls on 15 mm of silicone over a steel core. Open this file as a notebook with jupytext.

# %%
import matplotlib.pyplot as plt
import numpy as np

import softanvil as sa

s = sa.preset("study")
s.impactor.energy = "9.8 J"
s

# %% [markdown]
# A drop takes some milliseconds. Its numbers are attributes, in SI units.

# %%
r = sa.run(s, frames=0.5e-3)
r

# %%
r.trace[["contact.force", "impactor.deformation"]].iloc[60:65]

# %%
figure = r.plot()

# %% [markdown]
# The section at the deepest point, and the whole impact.

# %%
deepest = max(r.frames, key=lambda state: state.output("impactor.deformation"))
axes = deepest.plot("element.von_mises_stress")

# %%
r.animate()

# %% [markdown]
# What a stiffer and a softer silicone change.

# %%
variants = {"as measured": s.copy()}
for name, factor in [("half as stiff", 0.5), ("twice as stiff", 2.0)]:
    variants[name] = s.copy().update({f"silicone.{c}": factor * s[f"silicone.{c}"] for c in ("c10", "c01", "c11", "c20", "c02")})
figure = sa.compare(sa.run_many(variants.values()), list(variants))

# %% [markdown]
# With a driven face the motion is yours: press 3 mm in and out, and read the force. The loop is what the silicone dissipates.

# %%
driven = sa.preset("study").update({"impactor.motion": "driven", "impactor.gap": 0.0})
sim = sa.Simulation(driven)
position = -3e-3 * np.sin(np.pi * np.linspace(0, 1, 201)[1:]) ** 2
table = sim.drive(position, steps=round(5e-5 / sim.time_step))
figure, axes = plt.subplots()
axes.plot(-1e3 * table["impactor.position"], 1e-3 * table["contact.force"])
axes.set(xlabel="depth (mm)", ylabel="contact force (kN)");
