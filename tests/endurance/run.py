"""The long run, part after part, each for its share of the time; ends with a table of counts, and the same as JSON.

Counts of a recorded run go to runs.json, from which page.py writes docs/reliability.md.
"""

import argparse
import json
import os
import platform
import subprocess
import sys
import time
from pathlib import Path

import page
from parts import PARTS, Run

ROOT = Path(__file__).resolve().parents[2]


def options():
    parser = argparse.ArgumentParser(prog="tests/endurance/run.sh", description=__doc__.splitlines()[0])
    parser.add_argument("--minutes", type=float, default=60, help="how long, without what is built first (60)")
    parser.add_argument("--part", action="append", choices=PARTS, help="this part alone; may be given again (all)")
    parser.add_argument("--target", action="append", default=[], help="this target of the fuzzed parts alone; may be given again")
    parser.add_argument("--seed", type=int, default=1, help="which random numbers (1)")
    parser.add_argument("--out", type=Path, default=ROOT / "target/endurance",
                        help="where findings, counts and the inputs that cover more go (target/endurance)")
    parser.add_argument("--record", action="store_true", help="add the counts to runs.json and docs/reliability.md")
    return parser.parse_args()


def commit():
    words = ["git", "-C", ROOT, "describe", "--always", "--dirty", "--abbrev=12"]
    found = subprocess.run(words, capture_output=True, text=True)
    return found.stdout.strip() or "unknown"


def main():
    asked = options()
    names = asked.part or list(PARTS)
    arguments = [f"--minutes {asked.minutes:g}", f"--seed {asked.seed}"]
    arguments += [f"--part {name}" for name in asked.part or []] + [f"--target {name}" for name in asked.target]
    run = Run(ROOT, asked.out.resolve(), asked.seed, asked.target)
    start = time.strftime("%Y-%m-%d")
    share = sum(PARTS[name].share for name in names)
    for name in names:
        PARTS[name].carry_out(run, asked.minutes * 60 * PARTS[name].share / share)
    result = {
        "command": " ".join(["tests/endurance/run.sh", *arguments]),
        "commit": commit(),
        "date": start,
        "machine": f"{platform.machine()}, {os.cpu_count()} processors",
        "rows": run.rows,
        "skipped": run.skipped,
    }
    run.out.joinpath("counts.json").write_text(json.dumps(result, indent=1) + "\n")
    print("\n" + page.table(run.rows))
    for name, reason in run.skipped:
        print(f"SKIPPED: {name} ({reason})")
    found = [finding for row in run.rows for finding in row["findings"]]
    for finding in found:
        print(f"FOUND: {finding}")
    print(f"{len(found)} findings, {len(run.skipped)} skipped; counts in {run.out / 'counts.json'}")
    if asked.record:
        page.record(result)
    return 1 if found or (run.skipped and os.environ.get("CI") == "true") else 0


if __name__ == "__main__":
    sys.exit(main())
