"""What the package costs, as docs/python.md has it: measure.py [--drops N]... [--element-size SIZE] [--fmu MODEL.fmu], a table.

Seconds of processors, the least of several, hardly depend on what else runs on the machine; those of the clock do.
"""

import argparse
import contextlib
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from scipy.stats import qmc

import softanvil as sa

HEAD = ("what", "clock, ms", "processors, ms", "note")


def least(*works, times):
    """The least milliseconds (of the clock, of processors) that each of `works` takes; they take turns."""
    taken = [(float("inf"),) * 2] * len(works)
    for _ in range(times):
        for place, work in enumerate(works):
            before = time.perf_counter(), time.process_time()
            work()
            after = time.perf_counter(), time.process_time()
            taken[place] = tuple(min(old, 1e3 * (b - a)) for old, a, b in zip(taken[place], before, after, strict=True))
    return taken


def row(what, milliseconds, note="", drops=1):
    """A row of the table, shown on the way as well."""
    clock, processors = (number / drops for number in milliseconds)
    print(f"{what}: {clock:.2f} ms, {processors:.2f} ms of processors; {note}", file=sys.stderr, flush=True)
    return what, f"{clock:.2f}", f"{processors:.2f}", note


def overhead():
    """What `run` adds to a drop: recording 300 samples, the table of results, the way there and back."""
    scenario = sa.preset("study")
    result = sa.run(scenario)

    def kernel():
        sa._softanvil.Simulation(scenario._settings).step(result.steps, 0.0, None, None)

    alone, whole, traced = least(kernel, lambda: sa.run(scenario), lambda: sa.run(scenario).trace, times=200)
    yield row("the kernel alone, model and steps", alone, f"preset study, {result.elements} triangles, {result.steps} steps")
    yield row("`sa.run` of it", whole, f"{100 * (whole[1] / alone[1] - 1):+.1f} % of processors")
    yield row("the same with its trace as a data frame", traced)


#: Starts, and repeats a drop as often as it is told.
COUNTED = """
import gc, sys
import softanvil as sa
scenario = sa.preset("study")
steps = sa.run(scenario).steps
gc.disable()
for _ in range(int(sys.argv[1])):
    {statement}
"""


def instructions(statement):
    """Instructions of a statement, by valgrind, from what two numbers of repetitions take."""
    def count(times):
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", sys.executable, "-P", "-c",
                   COUNTED.format(statement=statement), str(times)]
        # The order of what is hashed changes what the start takes.
        said = subprocess.run(command, check=True, capture_output=True, text=True, env=os.environ | {"PYTHONHASHSEED": "0"}).stderr
        return int(re.search(r"Collected : (\d+)", said)[1])

    return (count(12) - count(2)) / 10


def counted():
    """What `run` adds to a drop in instructions, which depend on nothing else that the machine does."""
    alone, whole = (instructions(statement) for statement in (
        "sa._softanvil.Simulation(scenario._settings).step(steps, 0.0, None, None)", "sa.run(scenario)"))
    note = f"{alone / 1e6:.1f} million instructions alone, {100 * (whole / alone - 1):+.1f} % by `sa.run`, by valgrind"
    yield "`sa.run` over the kernel, counted", "-", "-", note


def many(drops=256):
    """Drops on all cores: `run_many` and `sweep` beside `softanvil sweep`, which is the Rust side, and one after the other."""
    low, high = 14.0, 15.0
    energies = np.linspace(low, high, drops)
    scenarios = [sa.preset("study").update({"impactor.energy": energy}) for energy in energies]
    base, design = sa.preset("study"), sa.design({"impactor.energy": (low, high)}, np.linspace(0, 1, drops)[:, None])
    listed = ",".join(map(repr, energies.tolist()))
    one, rust, batch, swept = least(
        lambda: [sa.run(scenario) for scenario in scenarios],
        lambda: sa._softanvil.command(["sweep", f"impactor.drop_energy={listed}", "--json"]),
        lambda: sa.run_many(scenarios),
        lambda: sa.sweep(base, design, progress=False, batch=drops),
        times=5)
    cores = f"{os.cpu_count()} cores"
    yield row(f"a drop of {drops}, one after the other", one, "one core", drops)
    # The scenario's own value is always among those of the command.
    yield row(f"a drop of {drops}, `softanvil sweep`", rust, cores, drops + 1)
    for what, taken in (("sa.run_many", batch), ("sa.sweep", swept)):
        reached = 100 * (rust[0] / (drops + 1)) / (taken[0] / drops)
        yield row(f"a drop of {drops}, `{what}`", taken, f"{cores}, {reached:.0f} % of the speed of `softanvil sweep`", drops)


def fmpy_loop(model, folder):
    """The same drop by fmpy, with the FMU unpacked and its description read once, and a trace every 50 us."""
    import fmpy

    if model is None:
        sa._softanvil.command(["fmu", "--fmi", "2", "--out", str(folder)])
        model = folder / "softanvil-fmi2.fmu"
    unpacked, description = fmpy.extract(model, unzipdir=str(folder / "fmu")), fmpy.read_model_description(model)
    scenario = sa.preset("study")
    result = sa.run(scenario)
    duration = result.steps * result.time_step

    def drop():
        return fmpy.simulate_fmu(unpacked, model_description=description, stop_time=duration, output_interval=50e-6,
                                 output=["contact.force", "impactor.position", "result.peak_force"])

    assert drop()["result.peak_force"][-1] == result.peak_force
    fmu, whole = least(drop, lambda: sa.run(scenario).trace, times=30)
    yield row("the drop of preset study by a loop over fmpy", fmu,
              f"a trace every 50 us; {fmu[1] / whole[1]:.2f} times `sa.run` with its trace")


#: A block, plane strain, bonded below, pressed down by a flat face without friction: sizes in m, moduli in Pa. The half of it to
#: the right of its middle is meshed, with the same nodes by both programs.
BLOCK = {"width": 0.06, "height": 0.015, "length": 0.15, "depth": 3e-3, "mu": 2e5, "nu": 0.45, "size": 2.5e-3}


def felupe_press(steps):
    """Force on the face in N, by felupe in so many static steps."""
    import felupe as fem

    across, up = (round(BLOCK[side] / BLOCK["size"]) for side in ("width", "height"))
    mesh = fem.Rectangle(b=(BLOCK["width"] / 2, BLOCK["height"]), n=(across // 2 + 1, up + 1))
    field = fem.FieldContainer([fem.FieldPlaneStrain(fem.RegionQuad(mesh), dim=2)])
    bulk = 2 * BLOCK["mu"] * (1 + BLOCK["nu"]) / (3 * (1 - 2 * BLOCK["nu"]))
    solid = fem.SolidBody(fem.NeoHooke(mu=BLOCK["mu"], bulk=bulk), field)
    boundaries = {"core": fem.Boundary(field[0], fy=0), "middle": fem.Boundary(field[0], fx=0, skip=(False, True)),
                  "face": fem.Boundary(field[0], fy=BLOCK["height"], skip=(True, False))}
    ramp = {boundaries["face"]: np.linspace(0, -BLOCK["depth"], steps + 1)[1:]}
    press = fem.CharacteristicCurve(steps=[fem.Step(items=[solid], ramp=ramp, boundaries=boundaries)],
                                    boundary=boundaries["face"])
    press.evaluate(verbose=0)
    return abs(2 * BLOCK["length"] * press.y[-1][1])


def felupe_block():
    """The block in felupe, which is implicit and quasi-static, and by the kernel, which is explicit: slowly, in 40 ms."""
    pressed = sa.preset("block").update({
        "geometry.block_width": BLOCK["width"], "geometry.length": BLOCK["length"], "silicone.thickness": BLOCK["height"],
        "silicone.c10": BLOCK["mu"] / 2, "silicone.poissons_ratio": BLOCK["nu"], "mesh.element_size": BLOCK["size"],
        "impactor.motion": "prescribed", "impactor.prescribed_depth": BLOCK["depth"], "impactor.prescribed_speed": 0.1,
        "impactor.prescribed_rise": 10e-3, "impactor.gap": 0.0, "face.friction_coefficient": 0.0, "time.duration": 40e-3})
    result, force = sa.run(pressed), felupe_press(10)
    nearby = abs(force / result["contact.force"] - 1)
    assert nearby < 0.03, f"felupe {force} N, softanvil {result['contact.force']} N"
    ten, one, ours = least(lambda: felupe_press(10), lambda: felupe_press(1), lambda: sa.run(pressed), times=5)
    yield row("a block pressed by 20 %, `sa.run`", ours, f"{result.elements} triangles, {result.steps} explicit steps, "
              f"{result['contact.force']:.0f} N at the end")
    for steps, taken in ((10, ten), (1, one)):
        yield row(f"the same block by felupe, static steps: {steps}", taken, "implicit, quasi-static, cells of 4 nodes at the same "
                  f"places, {felupe_press(steps):.0f} N at the end; {taken[1] / ours[1]:.1f} times `sa.run`")


@contextlib.contextmanager
def cluster(folder):
    """A scheduler and two workers, each a process, and a client of theirs."""
    import psutil
    from distributed import Client

    address, processes = folder / "scheduler.json", []

    def start(*arguments):
        command = [sys.executable, "-m", "dask", *arguments, "--scheduler-file", str(address), "--no-dashboard"]
        with open(folder / f"{arguments[0]}.log", "ab") as log:
            processes.append(psutil.Popen(command, stdout=log, stderr=log, cwd=folder))

    try:
        start("scheduler", "--port", "0", "--host", "127.0.0.1")
        deadline = time.monotonic() + 60
        while not address.exists():
            if processes[0].poll() is not None or time.monotonic() > deadline:
                raise RuntimeError(f"no scheduler: {(folder / 'scheduler.log').read_text()}")
            time.sleep(0.1)
        for _ in range(2):
            start("worker", "--nthreads", "1", "--no-nanny")
        with Client(scheduler_file=str(address)) as client:
            client.wait_for_workers(2, timeout=60)
            yield client, processes[0], processes[1:]
    finally:
        for process in processes:
            process.kill()


def spent(*processes):
    """Milliseconds of processors that processes have taken."""
    return 1e3 * sum(sum(process.cpu_times()[:2]) for process in processes)


def swept(client, scheduler, workers, base, number, folder):
    """Sweeps so many drops on the cluster, into a folder."""
    import psutil

    design = sa.design({"impactor.energy": (3.0, 15.0), "silicone.thickness": (10e-3, 20e-3)}, qmc.LatinHypercube(2, rng=1).random(number))
    groups = workers, [scheduler], [psutil.Process()]
    before, start = [spent(*group) for group in groups], time.perf_counter()
    table = sa.sweep(base, design, client=client, out=folder / f"sweep-{number}", progress=False)
    clock = 1e3 * (time.perf_counter() - start)
    work, scheduling, writing = (spent(*group) - old for group, old in zip(groups, before, strict=True))
    assert len(table) == number and (table["error"] == "").all()
    beside = 100 * (scheduling + writing) / number / 10
    return row(f"a drop of {number} swept by 2 workers", (clock, work + scheduling + writing),
               f"{clock / 1e3:.0f} s; workers {work / number:.2f}, scheduler {scheduling / number:.3f}, client {writing / number:.3f} "
               f"ms; the last two are {beside:.1f} % of a drop of 10 ms", number)


def on_cluster(numbers, size, folder):
    """The cost of a drop on a cluster, for numbers of drops, with a mesh that says how much work a drop is."""
    base = sa.preset("study").update({"mesh.element_size": size})
    with cluster(folder) as members:
        # What is done once (modules, first touches of memory) is no cost of a drop.
        sa.sweep(base, {"impactor.energy": [9.8] * 8}, client=members[0], batch=1, progress=False)
        for number in numbers:
            yield swept(*members, base, number, folder)


def absent(package, what):
    """The row of a comparison whose package is not there."""
    return [(what, "-", "-", f"{package} is not installed")] if importlib.util.find_spec(package) is None else []


def main():
    """Measures what is asked for, and prints the table."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--drops", type=int, action="append", default=[], metavar="N",
                         help="measure a sweep of so many drops on a cluster of Dask, as often as needed, instead of single drops")
    options.add_argument("--element-size", default="7.5 mm", metavar="SIZE",
                         help="mesh of those drops: 7.5 mm is 2 to 3 ms a drop")
    options.add_argument("--fmu", type=Path, metavar="MODEL.fmu", help="FMU for fmpy; without it one is built")
    asked = options.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if asked.drops:
            rows = list(on_cluster(asked.drops, asked.element_size, folder))
        else:
            rows = [*overhead(), *(counted() if shutil.which("valgrind") else []), *many(), *(absent("fmpy", "a loop over fmpy") or fmpy_loop(asked.fmu, folder)),
                    *(absent("felupe", "a block in felupe") or felupe_block())]
    for cells in (HEAD, ("---",) * len(HEAD), *rows):
        print(f"| {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
