"""Fits by Softanvil and by Python packages side by side, in one run: peers.py BUILD_FOLDER, which needs
`pip install -r peers.txt`, `cargo build --release -p softanvil` and `cargo build --release -p softanvil-identify --example
fit_law`. Rewrites peers.csv and the table of docs/fits.md.

Laws: the three tests of Treloar in data/treloar, residuals of the nominal stress, each point with weight one. Relaxation:
two Prony terms, made up, with 1 kPa of noise. Two times of each program, both the best of several:

* fit: the fit alone of this one law, with the data in memory (Softanvil: tools/identify/examples/fit_law.rs, with
  statistics and stability).
* process: from the start of the process to its end. Softanvil's is `softanvil fit`, which reads the files and fits all ten
  laws, or five series, however many are asked for; a peer's is Python's start, its imports, and the one fit.

The residual is computed by each program from its own stresses. Peers start where their documentation starts, from ones,
or from exponents 2, 5 and -2, because they have no starts of their own. MODE `one` fits one law and is for the runs
themselves: peers.py one PEER LAW FILE...
"""

import csv
import json
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DATA = [ROOT / "data" / "treloar" / f"{mode}.csv" for mode in ("uniaxial", "planar", "equibiaxial")]
HEAD = ["law", "program", "version", "rms [kPa]", "fit [ms]", "process [ms]", "machine"]
PEERS = {
    "neo_hookean": ["felupe", "hyperelastic"],
    "mooney_rivlin_2": ["felupe", "hyperelastic"],
    "mooney_rivlin_3": ["felupe", "hyperelastic"],
    # No peer has a term of (I2 - 3)^2; felupe takes a function of one's own.
    "mooney_rivlin_5": ["felupe"],
    "yeoh_2": ["felupe", "hyperelastic"],
    "yeoh_3": ["felupe", "hyperelastic"],
    "ogden_1": ["felupe", "hyperelastic"],
    "ogden_2": ["felupe", "hyperelastic"],
    "ogden_3": ["felupe", "hyperelastic"],
    "prony_2": ["pyvisco"],
}
POLYNOMIALS = {
    "neo_hookean": ["C10"],
    "mooney_rivlin_2": ["C10", "C01"],
    "mooney_rivlin_3": ["C10", "C01", "C11"],
    "mooney_rivlin_5": ["C10", "C01", "C11", "C20", "C02"],
    "yeoh_2": ["C10", "C20"],
    "yeoh_3": ["C10", "C20", "C30"],
}
# (mu, alpha) of each term in MPa, of the energy sum mu / alpha (l1^alpha + l2^alpha + l3^alpha - 3).
OGDEN = {
    "ogden_1": [(1.0, 2.0)],
    "ogden_2": [(0.5, 2.0), (-0.1, -2.0)],
    "ogden_3": [(0.5, 2.0), (0.01, 5.0), (-0.1, -2.0)],
}
# Packages whose versions a row names.
PACKAGES = {"felupe": ["felupe", "tensortrax"], "hyperelastic": ["hyperelastic"], "pyvisco": ["pyvisco"]}


def read(file):
    """Columns of a file of numbers."""
    import numpy as np

    rows = [line for line in Path(file).read_text().splitlines() if line[0].isdigit()]
    return np.array([[float(cell) for cell in row.split(",")] for row in rows]).T


def rms(residual):
    import numpy as np

    return float(np.sqrt(np.mean(residual**2)))


def felupe(law, files):
    """A fit by felupe, which returns the residuals.

    The stresses are felupe's and the minimiser is that of its `optimize`, scipy's least_squares. `optimize` itself is not
    called: in felupe 11.3 it takes the stresses of the planar test for those of the equibiaxial one when it is given
    both.
    """
    import felupe
    import numpy as np
    from felupe.constitution.tensortrax.models import hyperelastic as models
    from scipy.optimize import least_squares
    from tensortrax.math import trace
    from tensortrax.math.linalg import det

    def polynomial(C, C10, C01=0.0, C11=0.0, C20=0.0, C02=0.0, C30=0.0):
        scale = det(C) ** (-1 / 3)
        i1 = scale * trace(C) - 3
        i2 = (scale**2 * (trace(C) ** 2 - trace(C @ C))) / 2 - 3
        return C10 * i1 + C01 * i2 + C11 * i1 * i2 + C20 * i1**2 + C02 * i2**2 + C30 * i1**3

    def ogden(C, mu, alpha):
        # felupe's moduli are those at rest.
        return models.ogden(C, [m * a / 2 for m, a in zip(mu, alpha)], alpha)

    ready = {
        "neo_hookean": lambda C, C10: models.neo_hooke(C, 2 * C10),
        "mooney_rivlin_2": models.mooney_rivlin,
        "mooney_rivlin_3": lambda C, C10, C01, C11: models.third_order_deformation(C, C10, C01, C11, 0.0, 0.0),
        "yeoh_2": lambda C, C10, C20: models.third_order_deformation(C, C10, 0.0, 0.0, C20, 0.0),
        "yeoh_3": models.yeoh,
    }
    data = [read(file) for file in files]
    (ux, ps, bx) = (points[0] for points in data)
    stress = np.concatenate([points[1] for points in data])

    def residual(values):
        if law in OGDEN:
            parameters = {"mu": list(values[::2]), "alpha": list(values[1::2])}
            material = felupe.Hyperelastic(ogden, **parameters)
        else:
            material = felupe.Hyperelastic(ready.get(law, polynomial), **dict(zip(POLYNOMIALS[law], values)))
        curves = material.view(incompressible=True, ux=ux, ps=ps, bx=bx).evaluate()
        return np.concatenate([curve[1] for curve in curves]) - stress

    return lambda: least_squares(residual, start(law), method="lm").fun


def start(law):
    return [value for term in OGDEN[law] for value in term] if law in OGDEN else [1.0] * len(POLYNOMIALS[law])


def hyperelastic(law, files):
    """A fit by hyperelastic, which returns the residuals."""
    import hyperelastic as package
    import numpy as np
    from hyperelastic import lab

    def invariants(**parameters):
        model = package.models.invariants.ThirdOrderDeformation(**parameters)
        return package.DeformationSpace(package.InvariantsFramework(model))

    def ogden(**parameters):
        values = list(parameters.values())
        model = package.models.stretches.Ogden(mu=values[::2], alpha=values[1::2])
        return package.DeformationSpace(package.StretchesFramework(model))

    data = [read(file) for file in files]
    if law in OGDEN:
        labels = [f"{name}{k}" for k in range(len(OGDEN[law])) for name in ("mu", "alpha")]
    else:
        labels = POLYNOMIALS[law]
    # An experiment is made of displacements, here of a specimen of length 1.
    experiments = [lab.Experiment(file.stem, d[0] - 1.0, d[1]) for file, d in zip(map(Path, files), data)]
    material = ogden if law in OGDEN else invariants
    cases = [lab.Uniaxial(), lab.Planar(), lab.Biaxial()]
    simulations = [lab.Simulation(c, e.stretch, labels, material) for c, e in zip(cases, experiments)]

    def fit():
        # Of its own each time, because it begins where its last fit ended.
        optimize = lab.Optimize(experiments, simulations, np.array(start(law)))
        values = optimize.curve_fit(method="lm", maxfev=20000)[0]
        predicted = [s.stress_curve_fit(d[0], *values) for s, d in zip(simulations, data)]
        return np.concatenate(predicted) - np.concatenate([d[1] for d in data])

    return fit


def pyvisco(law, files):
    """A fit by pyvisco, which returns the residuals."""
    import numpy as np
    import pandas as pd
    from pyvisco import prony

    t, modulus = read(files[0])
    columns = {"t": t, "E_relax": modulus, "E_relax_filt": modulus, "omega": 1 / t, "f": 1 / (2 * np.pi * t)}
    frame = pd.DataFrame(columns)
    frame.modul, frame.domain, frame.RefT = "E", "time", 20

    def fit():
        found, _ = prony.fit(prony.discretize(frame, "min", 2), frame, opt=True)
        alpha, tau = found["df_terms"]["alpha_i"].to_numpy(), found["df_terms"]["tau_i"].to_numpy()
        predicted = found["E_0"] * (1.0 - alpha.sum() + np.exp(-np.outer(t, 1.0 / tau)) @ alpha)
        return (predicted - modulus) / 1e6

    return fit


def one(peer, law, files):
    """Fits five times; prints what the fit leaves in kPa and the shortest time in ms. Called with `once`, one fit."""
    once = files[-1] == "once"
    fit = globals()[peer](law, files[:-1] if once else files)
    times = []
    for _ in range(1 if once else 5):
        begin = time.perf_counter()
        residual = fit()
        times.append(time.perf_counter() - begin)
    print(json.dumps([rms(residual) * 1e3, min(times) * 1e3]))


def best(command):
    """Shortest of five times of a process in ms, and what it printed."""
    times = []
    for _ in range(5):
        begin = time.perf_counter()
        done = subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True)
        times.append((time.perf_counter() - begin) * 1e3)
    return min(times), done.stdout


def relaxation(file):
    import numpy as np

    t = np.geomspace(1e-3, 1e2, 120)
    modulus = 0.33e6 + 0.15e6 * np.exp(-t / 0.02) + 0.12e6 * np.exp(-t / 1.5)
    modulus += np.random.default_rng(1).normal(0.0, 1e3, t.size)
    lines = (f"{a!r},{b!r}\n" for a, b in zip(t.tolist(), modulus.tolist()))
    file.write_text("Time (s),Modulus (Pa)\n" + "".join(lines))


def softanvil(build, law, files):
    """What `softanvil fit` leaves in kPa, its time in ms, and that of the one fit."""
    if law.startswith("prony"):
        n_term = law[-1]
        options, example = ["--relaxation", files[0], "--terms", n_term], ["prony", n_term, *files]
    else:
        names = ["--uniaxial", "--planar", "--equibiaxial"]
        options = [option for pair in zip(names, files) for option in pair] + ["--law", law]
        example = [law, *files]
    process, printed = best([build / "softanvil", "fit", "--json", *options])
    found = json.loads(printed)
    if law.startswith("prony"):
        left = next(s for s in found["relaxation"]["series"] if len(s["g"]) == int(n_term))
    else:
        left = next(fit for fit in found["laws"] if fit["law"] == law)
    _, printed = best([build / "examples" / "fit_law", *example])
    alone, seconds = map(float, printed.split(","))
    assert abs(alone / left["residual_rms"] - 1) < 1e-9, (alone, left)
    return left["residual_rms"] / 1e3, float(seconds) * 1e3, process


def rows(build):
    from importlib.metadata import version

    cpu = next(line.split(":")[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines() if "model name" in line)
    machine = f"{cpu}; Python {platform.python_version()}, numpy {version('numpy')}, scipy {version('scipy')}"
    own = subprocess.run([build / "softanvil", "--version"], check=True, capture_output=True, text=True).stdout.split()[-1]
    with tempfile.TemporaryDirectory() as folder:
        relax = Path(folder) / "relax.csv"
        relaxation(relax)
        for law, peers in PEERS.items():
            files = [relax] if law.startswith("prony") else DATA
            left, fit, process = softanvil(build, law, files)
            yield [law, "Softanvil", own, f"{left:.4g}", f"{fit:.3g}", f"{process:.3g}", machine]
            for peer in peers:
                command = [sys.executable, __file__, "one", peer, law, *files]
                process, _ = best([*command, "once"])
                printed = subprocess.run(map(str, command), check=True, capture_output=True, text=True).stdout
                left, fit = json.loads(printed.splitlines()[-1])
                versions = " ".join(version(package) for package in PACKAGES[peer])
                yield [law, peer, versions, f"{left:.4g}", f"{fit:.3g}", f"{process:.3g}", machine]


def document(table):
    """Puts the rows into docs/fits.md, between the marks."""
    page = ROOT / "docs" / "fits.md"
    lines = [line for line in page.read_text().split("\n")]
    first, last = (lines.index(f"<!-- peers.csv {mark} -->") for mark in ("begins", "ends"))
    shown = [[*row[:2], *row[3:6]] for row in [HEAD, *table]]
    text = ["| " + " | ".join(row) + " |" for row in shown]
    text.insert(1, "|" + "---|" * len(shown[0]))
    page.write_text("\n".join([*lines[: first + 1], *text, *lines[last:]]))


def main():
    table = list(rows(Path(sys.argv[1]).resolve()))
    with open(HERE / "peers.csv", "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([HEAD, *table])
    document(table)
    for row in table:
        print(*row[:6])


if sys.argv[1] == "one":
    one(sys.argv[2], sys.argv[3], sys.argv[4:])
else:
    main()
