#!/usr/bin/env python3
"""How whole commands scale with the cores: commands.py CLI OUT.csv.

A calibration and a sweep with one thread and with one per core take turns; of each the fastest counts. The efficiency is the
time of one thread over that of all of them times their number, start, files and the last unfinished batch included.
"""
import csv
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ROUNDS = 3
COMMANDS = {
    # Whole generations of the search, of three drops a member.
    "calibrate": ["calibrate", str(ROOT / "calibration/all.toml"), "--evaluations", "160"],
    "sweep": ["sweep", str(ROOT / "sweeps/friction-mechanisms.toml")],
}


def wall(cli, arguments, threads):
    with tempfile.TemporaryDirectory() as folder:
        command = [cli, *arguments, "--threads", str(threads), "--out", f"{folder}/out"]
        start = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return time.perf_counter() - start


def main(cli, out):
    cores = len(os.sched_getaffinity(0))
    rows = [("threads", cores)]
    for name, arguments in COMMANDS.items():
        one, all_of_them = (min(times) for times in zip(
            *((wall(cli, arguments, 1), wall(cli, arguments, cores)) for _ in range(ROUNDS))))
        rows.append((f"efficiency: {name}", one / (cores * all_of_them)))
    with open(out, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([("figure", "value"), *rows])


if __name__ == "__main__":
    main(*sys.argv[1:])
