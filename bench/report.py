#!/usr/bin/env python3
"""Writes the tables of docs/performance.md: report.py TARGET_FOLDER, after the benchmarks (report.sh).

A table stands between a line `<!-- table: NAME -->` and the next `<!-- end -->`. Of the times that criterion has sampled
the fastest counts: what other programs on the machine add is never negative.
"""
import csv
import json
import platform
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/performance.md"
PEERS = ROOT / "tests/peers/peers.csv"
SETS = {"Baseline": "SSE2", "Neon": "NEON", "Simd128": "simd128", "Avx2": "AVX2", "Avx512": "AVX-512"}


class Figures:
    """What the benchmarks have left in the target folder."""

    def __init__(self, target):
        self.target = Path(target)
        self.files = {}

    def path(self, file):
        return self.target / "softanvil-bench" / f"{file}.csv"

    def __call__(self, file, figure, default=None):
        if file not in self.files:
            with self.path(file).open() as lines:
                self.files[file] = {row["figure"]: float(row["value"]) for row in csv.DictReader(lines)}
        return self.files[file].get(figure, default)

    def drop(self, instruction_set=None):
        """File of the drops on a processor that has no wider instruction set; none if they were not made."""
        made = [f"drop-{name}" for name in SETS if instruction_set in (name, None) and self.path(f"drop-{name}").is_file()]
        return made[-1] if made else None

    def names(self, file, start):
        self(file, "")
        return [name for name in self.files[file] if name.startswith(start)]

    def samples(self, group):
        """Name, time of an iteration in ns, and triangles, of every benchmark of criterion's group, the least first."""
        found = []
        for sample in (self.target / "criterion" / group).glob("*/new/sample.json"):
            data, about = (json.loads(path.read_text()) for path in (sample, sample.with_name("benchmark.json")))
            fastest = min(time / n for time, n in zip(data["times"], data["iters"]))
            name = about["value_str"] or about["function_id"]
            found.append((name, fastest, (about["throughput"] or {}).get("Elements")))
        return sorted(found, key=lambda row: (row[2] or 0, row[1]))

    def instructions(self):
        with (self.target / "softanvil-bench/instructions.csv").open() as lines:
            return list(csv.DictReader(lines))


def table(head, rows):
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def processor():
    text = Path("/proc/cpuinfo")
    found = re.search(r"model name\s*: (.*)", text.read_text()) if text.is_file() else None
    return found[1] if found else platform.processor() or platform.machine()


def machine(_):
    compiler = subprocess.run(["rustc", "--version"], check=True, capture_output=True, text=True).stdout.strip()
    return f"Measured on: {processor()}, {compiler}."


def ratios(f):
    simulated, triangles, steps = (f(f.drop(), name) for name in ("simulated time s", "triangles", "steps"))
    hosts = [("C ABI", "C ABI, 50 us a call")]
    hosts += [(f"FMU {version}", f"FMU {version}, 50 us a step, four outputs read") for version in ("2.0", "3.0")]
    rows = []
    for name, label in SETS.items():
        # Without an own run only the kernel can be told which instruction set to take.
        file = f.drop(name)
        walls = [("kernel", f(file or f.drop(), f"kernel {name}"))]
        walls += [(about, f(file, host)) for host, about in hosts] if file else []
        for about, wall in walls:
            if wall is not None:
                update = 1e9 * wall / triangles / steps
                rows.append([f"{label}: {about}", f"{1e3 * wall:.1f}", f"{wall / simulated:.2f}", f"{update:.1f}"])
    head = ["the study's drop", "wall time ms", "real-time factor (wall / simulated)", "ns per triangle and step"]
    return table(head, rows)


def summary(f):
    kinds = ("registers alone", "own memory", "memory side by side")
    efficiencies = " / ".join(f"{f('scaling', 'efficiency, ' + kind):.2f}" for kind in kinds)
    rows = [[f"efficiency of {f('scaling', 'threads'):.0f} threads: registers alone / memory on own pages / side by side",
             efficiencies]]
    commands = {name.removeprefix("efficiency: "): f("commands", name) for name in f.names("commands", "efficiency: ")}
    rows.append([f"efficiency of {f('commands', 'threads'):.0f} threads, whole commands: {' / '.join(commands)}",
                 " / ".join(f"{value:.2f}" for value in commands.values())])
    rows += [[name.replace(':', ' of a call:'), f"{f('calls', name):.0f} ns"] for name in f.names("calls", "overhead")]
    for row in f.instructions():
        rows.append([f"instructions per triangle and step, {SETS[row['instruction set']]}; dearest step / cheapest",
                     f"{row['instructions per triangle and step']}; {row['dearest step over cheapest']}"])
    rows += [[f"snapshot of the study's state: {name}", f"{1e-3 * time:.1f} us"] for name, time, _ in f.samples("snapshot")]
    return table(["ratio or cost", "figure"], rows)


def steps(f, group):
    rows = [[SETS.get(name, name), f"{1e-3 * time:.2f}", f"{time / n:.1f}"] for name, time, n in f.samples(group)]
    return table([group, "us per step", "ns per triangle and step"], rows)


def solid(f):
    """A step of a solid on one core and on all, of each instruction set, mesh and overlay."""
    rows, one = [], ", one core"
    for name in f.names("solid", ""):
        if not name.endswith(one):
            continue
        label = name.removesuffix(one)
        instruction_set, mesh, overlay = label.split("; ")
        times = [f("solid", name), f("solid", label + ", all cores")]
        rows.append([f"{mesh}: {f('solid', mesh + ', tetrahedra'):.0f}", overlay, SETS[instruction_set],
                     *(f"{time:.1f}" for time in times), f"{times[0] / times[1]:.2f}"])
    head = ["tetrahedra", "overlay", "instruction set", "ns per tetrahedron and step, one core",
            f"{f('solid', 'threads'):.0f} cores", "times faster"]
    return f"Measured on: {processor()}.\n\n" + table(head, rows)


def many(f):
    start = "ns per update: "
    rows = [[name.removeprefix(start), f"{f('scaling', name):.1f}"] for name in f.names("scaling", start)]
    return table(["small models, one after another", "ns per triangle and step"], rows)


def stages(f):
    names = f.names("anatomy", "share: ")
    return table(["stage", "part of the instructions"],
                 [[name.removeprefix("share: "), f"{100 * f('anatomy', name):.1f} %"] for name in names])


def roofline(f):
    """Lower bounds of the time per triangle and step, from operations, and from bytes that come from the second cache."""
    operations = f("anatomy", "floating-point operations")
    streamed = sum(f(f.drop(), name) * passes for name, passes in STREAMED.items())
    measured = {name: time / n for name, time, n in f.samples("instruction set")}
    rows = []
    for name, label in SETS.items():
        peak, cache = f("peak", f"{name} Gflop/s"), f("peak", f"{name} L2 GB/s")
        if peak is None:
            continue
        compute, memory = operations / peak, streamed / cache
        wall = measured[name]
        bound = max(compute, memory)
        rows.append([label, f"{peak:.1f}", f"{cache:.0f}", f"{compute:.1f}", f"{memory:.1f}", f"{wall:.1f}",
                     f"{100 * bound / wall:.0f} %"])
    text = (f"{operations:.0f} floating-point operations, {f('anatomy', 'divisions and roots'):.1f} of them divisions and "
            f"roots, and {streamed:.0f} bytes of constants and history per triangle and step; with AVX2, "
            f"{f('anatomy', 'bytes read'):.0f} bytes are read and {f('anatomy', 'bytes written'):.0f} written between "
            "registers and the first cache.")
    head = ["instruction set", "peak Gflop/s", "L2 GB/s", "ns by operations", "ns by L2", "ns measured", "achieved"]
    return text + "\n\n" + table(head, rows)


# Passes over what a triangle keeps in memory: read once, or read and written.
STREAMED = {"bytes a triangle, constants": 1, "bytes a triangle, history": 2, "bytes a triangle, viscous terms": 2}


def memory(f):
    return table(["memory of the study's drop", "bytes"],
                 [[name, f"{f(f.drop(), name):.0f}"] for name in f.names(f.drop(), "bytes a ")])


def peers(problem):
    """The results of tests/peers for a problem, and how many times Softanvil's each code takes."""
    if not PEERS.is_file():
        return "Not run."
    with PEERS.open() as lines:
        rows = [row for row in csv.DictReader(lines) if row["problem"] == problem]
    time, ours = "ns per element and step", float(rows[0]["ns per element and step"])
    head = [name for name in rows[0] if name not in ("problem", "what runs", "processor")] + ["times ours", "what runs"]
    cells = [{**row, "times ours": f"{float(row[time]) / ours:.0f}"} for row in rows]
    return f"Measured on: {rows[0]['processor']}.\n\n" + table(head, [[row[name] for name in head] for row in cells])


TABLES = {
    "machine": machine, "ratios": ratios, "summary": summary, "many": many, "stages": stages, "roofline": roofline,
    "memory": memory, "solid": solid,
    "peers section": lambda _: peers("section"), "peers solid": lambda _: peers("solid"),
    **{name: lambda f, name=name: steps(f, name) for name in ("size", "law", "overlay", "instruction set")},
}


def main():
    figures = Figures(sys.argv[1])
    only = sys.argv[2:]

    def fill(match):
        name = match[2]
        return match[0] if only and name not in only else f"{match[1]}\n{TABLES[name](figures)}\n{match[3]}"

    page = PAGE.read_text()
    PAGE.write_text(re.sub(r"(<!-- table: ([a-z ]+) -->)\n.*?(<!-- end -->)", fill, page, flags=re.S))


if __name__ == "__main__":
    main()
