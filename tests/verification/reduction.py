#!/usr/bin/env python3
"""Drops of preset study as a section and as a solid, over one parameter after another: table and pictures of docs/studies.md.

    cargo build --release && tests/verification/reduction.py

Writes tests/verification/examples/studies/drops.txt, which the example `studies` puts into the page, and the pictures.
"""

import json
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Parameter, values, what the page calls it, and its values there.
STUDIES = [
    ("impactor.drop_energy", [4.9, 9.8, 14.7], "energy (J)", 1.0),
    ("silicone.poissons_ratio", [0.45, 0.48, 0.49], "Poisson's ratio", 1.0),
    ("core.friction_coefficient", [0.0, 0.3, 0.6], "friction on the core", 1.0),
    ("face.friction_coefficient", [0.0, 0.3, 0.6], "friction under the face", 1.0),
    ("geometry.length", [0.1, 0.15, 0.2], "length of the anvil (mm)", 1e3),
    ("impactor.face_diameter", [0.11, 0.12, 0.13], "diameter of the face (mm)", 1e3),
    ("mesh.element_size", [0.002, 0.003, 0.004], "element size (mm)", 1e3),
]


def row(name, scale, case):
    value = scale * next(iter(case["settings"].values()))
    length = case["effective_length"]
    found = f"{1e3 * length:.1f}" if length else "none: the solid bears more"
    difference = case["section_difference_percent"]
    solid, section = case["solid"], case["section"]
    others = [100 * (section[key] / solid[key] - 1) for key in ("max_deformation", "impact_duration", "impulse")]
    return (f"| {name} | {value:.4g} | {solid['peak_force']:.0f} | {section['peak_force']:.0f} ({difference:+.1f} %) | "
            + " | ".join(f"{other:+.1f} %" for other in others) + f" | {found} |")


def main():
    lines = ["| over | value | peak force of the solid (N) | of the section (N) | deformation | duration | impulse | "
             "length for the same force (mm) |", "|---|---:|---:|---:|---:|---:|---:|---:|"]
    pictures = ROOT / "docs/reduction"
    pictures.mkdir(exist_ok=True)
    for parameter, values, name, scale in STUDIES:
        picture = pictures / f"{parameter.replace('.', '-')}.svg"
        words = ["target/release/softanvil", "reduction", f"{parameter}={','.join(map(str, values))}", "--json", "--overwrite",
                 "--plot", picture]
        cases = json.loads(subprocess.run(words, cwd=ROOT, check=True, capture_output=True, text=True).stdout)["cases"]
        cases.sort(key=lambda case: next(iter(case["settings"].values())))
        lines += [row(name, scale, case) for case in cases]
        print("\n".join(lines[-len(cases):]), flush=True)
    (ROOT / "tests/verification/examples/studies/drops.txt").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
