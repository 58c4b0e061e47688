"""Writes docs/protocols.md from the folders in which calibrations left their results.

    python3 calibration/table.py SOFTANVIL FOLDER

SOFTANVIL is the program; FOLDER holds a folder per protocol, as calibration/run.sh leaves them.
"""

import json
import pathlib
import subprocess
import sys

PROTOCOLS = {
    "all": "(b) all twelve numbers",
    "incompressible": "(b) all twelve numbers, incompressible",
    "only-14.7": "(a) 14.7 J alone, as in the paper",
    "without-14.7": "(c) without 14.7 J",
    "without-9.8": "(c) without 9.8 J",
    "without-4.9": "(c) without 4.9 J",
    "without-deformation-9.8": "(d) without the 9.8 J deformation",
    "material-tests": "(e) all twelve numbers and the material tests",
}
# Each preset with the protocol near whose result it is.
PRESETS = {"study": "all", "study-incompressible": "incompressible", "study-14.7": "only-14.7"}
QUANTITIES = {
    "peak_force": "peak force",
    "max_deformation": "max deformation",
    "impact_duration": "impact duration",
    "impulse": "impulse",
}
ROOT = pathlib.Path(__file__).resolve().parent.parent


def mean(errors):
    return f"{sum(map(abs, errors)) / len(errors):.1f}" if errors else ""


def table(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def validation(program, preset):
    text = subprocess.run([program, "validate", "--preset", preset, "--json"], check=True, capture_output=True).stdout
    return json.loads(text)


def fitted(found):
    """Parameters and numbers fitted, of a validation."""
    return f"{found['fitted']['parameters']} / {found['fitted']['numbers']}"


def summary_row(name, parameters, impacts):
    """Parameters and numbers fitted, and mean errors of a calibration: of all numbers, of those fitted, of the others."""
    cells = [impact[key] for impact in impacts for key in QUANTITIES]
    errors = [cell["error_percent"] for cell in cells]
    counted = [cell["error_percent"] for cell in cells if cell["counts"]]
    predicted = [cell["error_percent"] for cell in cells if not cell["counts"]]
    peaks = ", ".join(f"{impact['peak_force']['error_percent']:+.1f}" for impact in impacts)
    return [name, f"{parameters} / {len(counted)}", mean(errors), mean(counted), mean(predicted), peaks]


def error_rows(impacts_by_name):
    energies = [impact["energy"] for impact in next(iter(impacts_by_name.values()))]
    for i, energy in enumerate(energies):
        for key, label in QUANTITIES.items():
            cells = [impacts[i][key] for impacts in impacts_by_name.values()]
            shown = [f"{cell['error_percent']:+.1f}" if cell["counts"] else f"*{cell['error_percent']:+.1f}*" for cell in cells]
            yield [f"{energy} J", label, *shown]


def spread_rows(parameters):
    for name, row in parameters.items():
        spread = row["spread"]
        bound = f" ({row['bound']})" if row["bound"] else ""
        if spread["part"] is None:  # The search has not converged.
            yield [name, f"{row['value']:.3g}{bound}", row["unit"], "-", "-", "not converged"]
            continue
        best, low, high = (f"{value:.3g}" for value in (row["value"], spread["min"], spread["max"]))
        yield [name, best + bound, row["unit"], f"{low} to {high}", f"{spread['part']:.2f}", row["determined"]]


def of_validation(cases, key):
    """The cases of `softanvil validate --json` in the shape of a calibration's impacts."""
    return [
        {"energy": case["energy"], **{name: {"error_percent": case[key][name], "counts": True} for name in QUANTITIES}}
        for case in cases
    ]


def test_rows(tests):
    for test in tests:
        held = f", held for {test['hold']:g} s" if test["hold"] else ""
        kind = {"youngs_modulus": "E", "shear_modulus": "G", "stress": "stress"}[test["quantity"]]
        course = f"{kind} at {100 * test['strain']:g} %, {test['rate']:g} 1/s{held}"
        measured = f"{test['measured'] / 1e6:.3f} +- {test['standard_deviation'] / 1e6:.3f}"
        distance = f"{test['distance']:+.1f}" + ("" if test["counts"] else " (does not count)")
        yield [test["name"], course, measured, f"{test['model'] / 1e6:.3f}", distance]


def main(program, folder):
    results = {name: json.loads((folder / name / "summary.json").read_text()) for name in PROTOCOLS}
    validations = {name: validation(program, name) for name in PRESETS}
    presets = {name: found["cases"] for name, found in validations.items()}
    ls_dyna = of_validation(presets["study"], "ls_dyna_error_percent")
    rows = [summary_row("LS-DYNA, as printed in the paper", 0, ls_dyna)]
    rows[0][1] = fitted(validations["study"]["ls_dyna"])
    rows += [
        summary_row(label, len(results[name]["parameters"]), results[name]["impacts"]) for name, label in PROTOCOLS.items()
    ]
    for name, cases in presets.items():
        rows.append(summary_row(f"preset `{name}`, near `{PRESETS[name]}.toml`", 0, of_validation(cases, "error_percent")))
        rows[-1][1] = fitted(validations[name])
    for row in rows[0], *rows[-len(presets) :]:
        row[3] = row[4] = ""
    shown = {"LS-DYNA": ls_dyna, **{PROTOCOLS[name].split(" ")[0] + " " + name: results[name]["impacts"] for name in PROTOCOLS}}
    best = results["all"]
    with_tests = results["material-tests"]
    text = f"""# Calibration protocols

Written by `calibration/run.sh`, which runs every protocol and takes about half an hour on two cores. Errors are against the
paper's experiment, in %; beside each stands how many parameters were fitted to how many of the twelve numbers. The sets stand in
`calibration/best/`, and a test computes every error from them anew.

{table(["tuned with", "parameters / numbers fitted", "mean of twelve", "of the tuned", "of the predicted", "peaks at 14.7, 9.8, 4.9 J"], rows)}
Every error; those in italics were predicted:

{table(["energy", "quantity", *shown], error_rows(shown))}
What (b) pins: the best value of each parameter, and the spread among the {best["equally_good"]} evaluations that score within
5 % of it, with its part of the range searched. A part near 1 says that the impacts say nothing about the parameter.

{table(["parameter", "best", "unit", "spread", "of the range", "determined"], spread_rows(best["parameters"]))}
What (e) makes of the material tests, in MPa and in standard deviations, and what both kinds of data pin:

{table(["test", "of", "measured", "model", "distance"], test_rows(with_tests["material_tests"]))}
{table(["parameter", "best", "unit", "spread", "of the range", "determined"], spread_rows(with_tests["parameters"]))}"""
    (ROOT / "docs" / "protocols.md").write_text(text)


main(sys.argv[1], pathlib.Path(sys.argv[2]))
