"""Fits by Softanvil and by Python packages side by side: peers.py SOFTANVIL, which rewrites peers.csv beside this file.

Needs `pip install hyperelastic==0.10.2 pyvisco==2.1.3`. Laws: the three tests of Treloar in data/treloar, absolute
residuals. Relaxation: two Prony terms, made up, with 1 kPa of noise. Every time is the best of three; that of Softanvil
is of its whole program, which reads the files and fits all ten laws, or series of one to five terms; a peer's is of its
one fit alone, from one start. Prints the rows of the table in docs/identification.md.
"""

import csv
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import hyperelastic
import numpy as np
import pandas as pd
from hyperelastic import lab
from pyvisco import prony

HERE = Path(__file__).resolve().parent
DATA = HERE.parents[1] / "data" / "treloar"
PROGRAM = str(Path(sys.argv[1]).resolve())
MODES = ["uniaxial", "planar", "equibiaxial"]


def best(call):
    """Result and shortest of three times in s."""
    times = []
    for _ in range(3):
        start = time.perf_counter()
        result = call()
        times.append(time.perf_counter() - start)
    return result, min(times)


def softanvil(*options):
    return json.loads(subprocess.run([PROGRAM, "fit", "--json", *options], check=True, capture_output=True).stdout)


def read(mode):
    rows = [line for line in (DATA / f"{mode}.csv").read_text().splitlines() if line[0].isdigit()]
    return np.array([[float(cell) for cell in row.split(",")] for row in rows])


def invariants(**parameters):
    model = hyperelastic.models.invariants.ThirdOrderDeformation(**parameters)
    return hyperelastic.DeformationSpace(hyperelastic.InvariantsFramework(model))


def ogden(**p):
    order = len(p) // 2
    model = hyperelastic.models.stretches.Ogden(
        mu=[p[f"mu{k}"] for k in range(order)], alpha=[p[f"alpha{k}"] for k in range(order)]
    )
    return hyperelastic.DeformationSpace(hyperelastic.StretchesFramework(model))


# Name, material, labels and start in MPa of the peer's fit.
LAWS = [
    ("neo_hookean", invariants, ["C10"], [1.0]),
    ("mooney_rivlin_2", invariants, ["C10", "C01"], [1.0] * 2),
    ("mooney_rivlin_3", invariants, ["C10", "C01", "C11"], [1.0] * 3),
    ("yeoh_3", invariants, ["C10", "C20", "C30"], [1.0] * 3),
    ("ogden_1", ogden, ["mu0", "alpha0"], [1.0, 2.0]),
    ("ogden_2", ogden, ["mu0", "mu1", "alpha0", "alpha1"], [0.5, -0.1, 2.0, -2.0]),
    ("ogden_3", ogden, ["mu0", "mu1", "mu2", "alpha0", "alpha1", "alpha2"], [0.5, 0.01, -0.1, 2.0, 5.0, -2.0]),
]


def laws():
    data = [read(mode) for mode in MODES]
    stress = np.concatenate([points[:, 1] for points in data])
    files = [option for mode in MODES for option in (f"--{mode}", str(DATA / f"{mode}.csv"))]
    for name, material, labels, start in LAWS:
        # The force of an experiment is taken at every stretch as it stands.
        experiments = [lab.Experiment(mode, d[:, 0] - 1.0, d[:, 1]) for mode, d in zip(MODES, data)]
        cases = [lab.Uniaxial(), lab.Planar(), lab.Biaxial()]
        simulations = [lab.Simulation(c, e.stretch, labels, material) for c, e in zip(cases, experiments)]

        def peer():
            optimize = lab.Optimize(experiments, simulations, np.array(start))
            return optimize.curve_fit(method="lm", maxfev=20000)[0]

        def residual(values):
            predicted = [s.stress_curve_fit(d[:, 0], *values) for s, d in zip(simulations, data)]
            return float(np.sqrt(np.mean((np.concatenate(predicted) - stress) ** 2)) * 1e3)

        ours, ours_s = best(lambda: softanvil(*files, "--law", name))
        ours = next(law for law in ours["laws"] if law["law"] == name)["residual_rms"] / 1e3
        try:
            values, peer_s = best(peer)
            theirs = f"{residual(values):.4g}"
        except RuntimeError as error:
            theirs, peer_s = f"failed ({str(error)[:40]})", float("nan")
        yield name, f"{ours:.4g}", f"{ours_s:.3f}", "hyperelastic", theirs, f"{peer_s:.3f}"


def relaxation():
    t = np.geomspace(1e-3, 1e2, 120)
    modulus = 0.33e6 + 0.15e6 * np.exp(-t / 0.02) + 0.12e6 * np.exp(-t / 1.5)
    modulus += np.random.default_rng(1).normal(0.0, 1e3, t.size)
    frame = pd.DataFrame({"t": t, "E_relax": modulus, "E_relax_filt": modulus, "omega": 1 / t, "f": 1 / (2 * np.pi * t)})
    frame.modul, frame.domain, frame.RefT = "E", "time", 20

    def peer():
        return prony.fit(prony.discretize(frame, "min", 2), frame, opt=True)

    (found, _), peer_s = best(peer)
    alpha, tau = found["df_terms"]["alpha_i"].to_numpy(), found["df_terms"]["tau_i"].to_numpy()
    predicted = found["E_0"] * (1.0 - alpha.sum() + np.exp(-np.outer(t, 1.0 / tau)) @ alpha)
    theirs = float(np.sqrt(np.mean((predicted - modulus) ** 2)) / 1e3)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "relax.csv"
        file.write_text("Time (s),Modulus (Pa)\n" + "".join(f"{a!r},{b!r}\n" for a, b in zip(t.tolist(), modulus.tolist())))
        ours, ours_s = best(lambda: softanvil("--relaxation", str(file), "--terms", "2"))
    series = next(s for s in ours["relaxation"]["series"] if len(s["g"]) == 2)
    yield "prony_2", f"{series['residual_rms'] / 1e3:.4g}", f"{ours_s:.3f}", "pyvisco", f"{theirs:.4g}", f"{peer_s:.3f}"


rows = [*laws(), *relaxation()]
with open(HERE / "peers.csv", "w", newline="") as file:
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["law", "softanvil rms [kPa]", "softanvil time [s]", "peer", "peer rms [kPa]", "peer time [s]"])
    table.writerows(rows)
for row in rows:
    print("| " + " | ".join(row) + " |")
