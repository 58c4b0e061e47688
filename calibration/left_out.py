"""Prints, as a Markdown table, where the numbers of an energy lie that a posterior has not seen: left_out.py FOLDER"""

import json
import sys
from pathlib import Path

NUMBERS = {
    "peak_force": ("peak force (N)", 1, 0.5, 0),
    "max_deformation": ("max deformation (mm)", 1e3, 0.05, 2),
    "impact_duration": ("impact duration (ms)", 1e3, 0.05, 2),
    "impulse": ("impulse (N s)", 1, 0.5, 2),
}


def rows(folder, energy):
    """The numbers of the energy that was left out, and their bands."""
    run = Path(folder) / f"without-{energy}"
    summary, posterior = (json.loads((run / name).read_text()) for name in ("summary.json", "posterior.json"))
    measured = next(impact for impact in summary["impacts"] if impact["energy"] == energy)
    expected = next(impact for impact in posterior["impacts"] if impact["energy"] == energy)
    for index, (key, (label, scale, half, digits)) in enumerate(NUMBERS.items()):
        value = scale * measured[key]["measured"]
        bands = [[scale * expected[kind][index][end] for end in ("low", "high")] for kind in ("parameters", "measured")]
        holds = [value + half >= low and value - half <= high for low, high in bands]
        texts = [f"{low:.{digits}f} to {high:.{digits}f}" for low, high in bands]
        yield f"| {energy} J | {label} | {value:g} | {texts[0]} | {texts[1]} | {'yes' if holds[1] else 'no'} |", holds


def main(folder):
    found = []
    print("| left out | number | measured | parameters | with misfit | within |\n|---|---|---:|---:|---:|---|")
    for energy in (14.7, 9.8, 4.9):
        if not (Path(folder) / f"without-{energy}" / "posterior.json").exists():
            print(f"without-{energy} has no posterior", file=sys.stderr)
            continue
        for line, holds in rows(folder, energy):
            print(line)
            found.append(holds)
    inside = [sum(holds[kind] for holds in found) for kind in (0, 1)]
    print(f"\n{inside[0]} of {len(found)} lie within what the parameters leave open, {inside[1]} within the bands with misfit.")


main(sys.argv[1])
