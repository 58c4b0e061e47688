"""Writes docs/mechanisms.md from the folders in which the searches of calibration/mechanisms.sh left their results.

    python3 calibration/mechanisms.py FOLDER
"""

import csv
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROBLEMS = ROOT / "calibration" / "mechanisms"
QUANTITIES = ["peak_force", "max_deformation", "impact_duration", "impulse"]
# What is read into the tables stands in mechanisms.txt, because it is an opinion.
READING = (ROOT / "calibration" / "mechanisms.txt").read_text()


def table(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def meaning(name):
    """The comment at the head of a problem file."""
    lines = (PROBLEMS / f"{name}.toml").read_text().splitlines()
    head = lines[: next(i for i, line in enumerate(lines) if not line.startswith("#"))]
    return " ".join(line.removeprefix("# ") for line in head)


def errors(result):
    return [impact[key]["error_percent"] for impact in result["impacts"] for key in QUANTITIES]


def mechanism_row(name, result):
    found = errors(result)
    worst = max(found, key=abs)
    mean = sum(map(abs, found)) / len(found)
    converged = "yes" if result["convergence"]["converged"] else "no"
    return [f"`{name}`", meaning(name), str(len(result["parameters"])), f"{mean:.1f}", f"{worst:+.1f}", converged]


def error_row(name, result):
    return [f"`{name}`", *(f"{error:+.1f}" for error in errors(result))]


def front_row(point):
    def number(key, digits):
        return f"{float(point[key]):.{digits}f}"

    converged = "yes" if point["converged"] == "true" else "no"
    row = [point["weight [1]"], number("mean_error [%]", 1), number("worst_error [%]", 1)]
    return [*row, number("distance [1]", 2), number("farthest [1]", 2), converged]


def main(folder):
    names = sorted(path.stem for path in PROBLEMS.glob("*.toml"))
    names.sort(key=lambda name: name != "base")
    results = {name: json.loads((folder / name / "summary.json").read_text()) for name in names}
    front = list(csv.DictReader((folder / "front" / "front.csv").open()))
    short = ["F", "d", "T", "I"]
    header = ["mechanism", *(f"{energy} {key}" for energy in ("14.7", "9.8", "4.9") for key in short)]
    text = f"""# Mechanisms

Written by `calibration/mechanisms.sh`, which searches with each mechanism in `calibration/mechanisms/`: about half an hour on two
cores. Errors are against the paper's experiment, in %. The sets stand in `calibration/mechanisms/best/` and `calibration/front/`,
and a test computes the errors from them anew.

## One mechanism at a time
Each adds one mechanism to `base` and is searched for all twelve numbers from the same values, with a limit of 3 % on peaks and of
12 % on the other numbers, beyond which an error counts twice.

{table(["problem", "mechanism", "parameters", "mean of twelve", "largest", "converged"], [mechanism_row(*item) for item in results.items()])}
Every error, of peak force F, deformation d, duration T and impulse I at 14.7, 9.8 and 4.9 J:

{table(header, [error_row(*item) for item in results.items()])}
## Impacts against material tests
`softanvil calibrate calibration/material-tests.toml --evaluations 20000 --material-weights 0 0.03 0.1 0.3 1` searches once for each
weight of the material tests. Distances from them are in standard deviations, root mean square and largest. Poisson's ratio at once is
at least 0.2 in all of them.

{table(["weight", "mean of twelve", "largest", "distance", "largest", "converged"], [front_row(point) for point in front])}
![Impacts against material tests](front.svg)

{READING}"""
    (ROOT / "docs" / "mechanisms.md").write_text(text)


main(pathlib.Path(sys.argv[1]))
