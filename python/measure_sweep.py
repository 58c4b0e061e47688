"""What a sweep on a cluster costs, as docs/python.md has it: measure_sweep.py ELEMENT_SIZE NUMBER...

A scheduler and two workers, each a process; seconds of processors of each, which hardly depend on what else runs on the machine.
ELEMENT_SIZE, such as "6 mm", says how much work a drop is.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import psutil
from distributed import Client
from scipy.stats import qmc

import softanvil as sa


def spent(process):
    """Seconds of processors that a process has taken, with its children."""
    family = [process, *process.children(recursive=True)]
    return sum(sum(one.cpu_times()[:2]) for one in family)


def start(folder, *arguments):
    """A process of Dask."""
    command = [sys.executable, "-m", "dask", *arguments, "--scheduler-file", str(folder / "scheduler.json"), "--no-dashboard"]
    return psutil.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def measure(client, scheduler, workers, base, number, folder):
    """Sweeps so many drops; prints what it took."""
    design = sa.design({"impactor.energy": (3.0, 15.0), "silicone.thickness": (10e-3, 20e-3)}, qmc.Sobol(2, rng=1).random(number))
    mine, before, start = psutil.Process(os.getpid()), [], time.perf_counter()
    before = [sum(map(spent, workers)), spent(scheduler), sum(mine.cpu_times()[:2])]
    table = sa.sweep(base, design, client=client, out=folder / f"sweep-{number}", progress=False)
    after = [sum(map(spent, workers)), spent(scheduler), sum(mine.cpu_times()[:2])]
    work, scheduling, writing = (b - a for a, b in zip(before, after, strict=True))
    assert len(table) == number and (table["error"] == "").all()
    print(f"{number} drops, {time.perf_counter() - start:.0f} s: a drop {1e3 * work / number:.2f} ms of workers, "
          f"{1e3 * scheduling / number:.3f} ms of the scheduler, {1e3 * writing / number:.3f} ms here (plan, files, table)",
          flush=True)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        scheduler = start(folder, "scheduler", "--port", "0", "--host", "127.0.0.1")
        while not (folder / "scheduler.json").exists():
            time.sleep(0.1)
        workers = [start(folder, "worker", "--nthreads", "1", "--no-nanny") for _ in range(2)]
        base = sa.preset("study").update({"mesh.element_size": sys.argv[1]})
        with Client(scheduler_file=str(folder / "scheduler.json")) as client:
            client.wait_for_workers(2)
            for number in map(int, sys.argv[2:]):
                measure(client, scheduler, workers, base, number, folder)
        for process in [*workers, scheduler]:
            process.kill()
