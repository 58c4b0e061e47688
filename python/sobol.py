"""What the four numbers of a drop depend on: Sobol indices over the ranges in which calibration/all.toml searches.

    python -P python/sobol.py [--drops 512] [--energy 14.7]

writes docs/sensitivity.svg and docs/sensitivity.md. The seed decides everything. (-P: the package that is
installed, not the sources beside this file.) Indices are of the logarithms of the numbers,
which spread over decades in such ranges. First-order indices are what a parameter explains alone, total ones with all its
interactions; both have 95 % intervals by resampling (SALib).
"""

import argparse
import tomllib
from pathlib import Path

import matplotlib
import numpy as np
import pandas as pd
from SALib.analyze import sobol as analysis
from SALib.sample import sobol

import softanvil as sa

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = Path(__file__).parent.parent
PROBLEM = "calibration/all.toml"
NUMBERS = {
    "peak_force": "peak force",
    "max_deformation": "max deformation",
    "impact_duration": "impact duration",
    "impulse": "impulse",
}


def read_problem():
    """Ranges, with how each is searched, and the drop."""
    problem = tomllib.loads((ROOT / PROBLEM).read_text())
    base = sa.preset(problem["preset"]).update(problem["fixed"])
    return base, problem["parameters"]


def values(ranges, parts):
    """A data frame of parameters at these parts (0 to 1) of the ranges."""
    table = {}
    for (name, about), part in zip(ranges.items(), parts.T, strict=True):
        low, high = about["min"], about["max"]
        logarithmic = about.get("scale") == "log"
        table[name] = low * (high / low) ** part if logarithmic else low + part * (high - low)
    # The kernel's share of a Prony term, of the overstress that is searched for.
    overstress = table.pop("silicone.overstress_1")
    table["silicone.prony_g_1"] = overstress / (1 + overstress)
    return pd.DataFrame(table)


def indices(problem, table):
    """First-order and total indices of each number, with the halves of their intervals."""
    found = {}
    for name in NUMBERS:
        result = analysis.analyze(problem, np.log(table[name].to_numpy()), calc_second_order=False, seed=1)
        found[name] = pd.DataFrame({key: result[key] for key in ("S1", "S1_conf", "ST", "ST_conf")}, index=problem["names"])
    return found


def draw(found):
    """The picture."""
    plt.rcParams.update({"svg.hashsalt": "softanvil", "svg.fonttype": "none", "font.size": 9})
    figure, columns = plt.subplots(1, len(NUMBERS), figsize=(11, 3), layout="constrained", sharey=True)
    for axes, (name, label) in zip(columns, NUMBERS.items(), strict=True):
        table, places = found[name], np.arange(len(found[name]))
        for shift, key, colour, legend in ((-0.2, "S1", "#0072b2", "first order"), (0.2, "ST", "#d55e00", "total")):
            axes.barh(places + shift, table[key], 0.38, xerr=table[f"{key}_conf"], color=colour, label=legend)
        axes.set(title=label, xlabel="part of the variance", yticks=places, yticklabels=table.index, xlim=(-0.05, 1.05))
    columns[0].invert_yaxis()
    columns[-1].legend(loc="lower right")
    figure.savefig(ROOT / "docs/sensitivity.svg", metadata={"Date": None})


def page(found, drops, unfinished, energy):
    """The page with the table."""
    lines = [
        "# Sensitivity",
        "",
        "Written by `python -P python/sobol.py`, which draws the picture, too.",
        "",
        f"How much of the variance of each of the four numbers of a drop with {energy:g} J each parameter explains, over the",
        f"ranges in which `{PROBLEM}` searches, by {drops} drops: Sobol indices of the logarithms of the numbers (SALib). The",
        "first-order index is what a parameter explains alone, the total one what it explains with all its interactions. After",
        "each stands half of its 95 % interval.",
        f"In {unfinished} of the drops the impactor never left the layer: their durations and impulses are those so far.",
        "",
        "![Sobol indices of the four numbers](sensitivity.svg)",
        "",
        "| number | parameter | first order | total |",
        "|---|---|---:|---:|",
    ]
    for name, label in NUMBERS.items():
        for parameter, row in found[name].iterrows():
            first, total = f"{row.S1:.2f} +- {row.S1_conf:.2f}", f"{row.ST:.2f} +- {row.ST_conf:.2f}"
            lines.append(f"| {label} | {parameter} | {first} | {total} |")
    (ROOT / "docs/sensitivity.md").write_text("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--drops", type=int, default=512, help="points of the base sample, a power of two")
    parser.add_argument("--energy", type=float, default=14.7, help="impact energy in J")
    arguments = parser.parse_args()
    base, ranges = read_problem()
    base.impactor.energy = arguments.energy
    problem = {"num_vars": len(ranges), "names": list(ranges), "bounds": [[0, 1]] * len(ranges)}
    parts = sobol.sample(problem, arguments.drops, calc_second_order=False, seed=1)
    table = sa.sweep(base, values(ranges, parts), progress=False)
    failed = table[table[list(NUMBERS)].isna().any(axis=1)]
    if len(failed):
        raise SystemExit(f"{len(failed)} of {len(table)} drops failed: {failed['error'].iloc[0]}")
    found = indices(problem, table)
    draw(found)
    page(found, len(table), (table["ending"] != "complete").sum(), arguments.energy)


if __name__ == "__main__":
    main()
