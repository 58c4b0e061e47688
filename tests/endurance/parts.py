"""The parts of the long run. Each adds rows of counts to the run: what was tried, how often, for how long, and findings."""

import json
import os
import re
import shutil
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

NIGHTLY = "+nightly"
# Findings of one target after which it is given up: more would be the same again.
MOST_FINDINGS = 5
# Seconds that one input may take, and memory of a target, MB: more of either is a finding.
SLOWEST, LARGEST = 60, 4096

# Where the targets are, and which of them belong to which part.
FILES = ("tools", ["scenario_file", "scenario_values", "problem_file", "sweep_file", "posterior_file", "trace",
                   "material_test", "material_card"])
CALLS = ("ffi", ["scenario", "snapshot", "calls", "fmi2", "fmi3"])
DRIVEN = ("ffi", ["driven"])


@dataclass
class Run:
    """What all parts share."""

    root: Path
    out: Path
    seed: int
    only: list
    rows: list = field(default_factory=list)
    skipped: list = field(default_factory=list)
    built: dict = field(default_factory=dict)

    def __post_init__(self):
        (self.out / "findings").mkdir(parents=True, exist_ok=True)

    def add(self, part, what, count, unit, seconds, findings):
        row = {"part": part, "what": what, "count": count, "unit": unit, "seconds": round(seconds), "findings": findings}
        self.rows.append(row)
        print(f"{part}, {what}: {count} {unit} in {seconds:.0f} s, {len(findings)} findings", flush=True)

    def skip(self, name, reason):
        if (name, reason) not in self.skipped:
            self.skipped.append((name, reason))
        print(f"SKIPPED: {name} ({reason})", flush=True)

    def build(self, name, words, folder="."):
        """Whether `words` build what a part needs; what does not build is a finding, for it is the project's own."""
        if name not in self.built:
            print(f"building {name}", flush=True)
            built = subprocess.run(words, cwd=self.root / folder, capture_output=True, text=True)
            self.built[name] = built.returncode == 0
            if built.returncode:
                self.add("build", name, 0, "builds", 0, [f"{name} does not build: {built.stderr.strip()[-2000:]}"])
        return self.built[name]


def has(*words):
    try:
        return subprocess.run(words, capture_output=True).returncode == 0
    except OSError:
        return False


def binaries(run, crate, sanitizer):
    """The folder of the targets of a crate; none if they cannot be had."""
    if not has("cargo", NIGHTLY, "fuzz", "--version"):
        return run.skip(f"fuzzing of {crate}", "cargo-fuzz or the nightly toolchain is missing")
    folder = run.root / crate / "fuzz/target" / ("" if sanitizer == "none" else sanitizer)
    # Without a look at every comparison, which takes more than half of the time: the edits have the words and numbers that matter.
    words = ["cargo", NIGHTLY, "fuzz", "build", "-s", sanitizer, "--no-trace-compares", "--target-dir", folder]
    host = subprocess.run(["rustc", "-vV"], capture_output=True, text=True).stdout
    triple = re.search(r"^host: (.*)$", host, re.M)[1]
    return folder / triple / "release" if run.build(f"targets of {crate}, {sanitizer}", words, crate) else None


def fuzz(run, part, crate, target, binary, seconds):
    """Runs a target for so long; goes on with another seed after a finding."""
    corpus = run.out / "corpus" / target
    corpus.mkdir(parents=True, exist_ok=True)
    kept = run.root / crate / "fuzz/corpus" / target
    count, findings, start = 0, [], time.monotonic()
    while (left := seconds - (time.monotonic() - start)) >= 1 and len(findings) < MOST_FINDINGS:
        seed = run.seed + len(findings)
        words = [binary, corpus, *([kept] if kept.is_dir() else []), f"-seed={seed}", f"-max_total_time={max(1, round(left))}",
                 "-print_final_stats=1", f"-timeout={SLOWEST}", f"-rss_limit_mb={LARGEST}", "-verbosity=1",
                 f"-artifact_prefix={run.out / 'findings'}/{target}-"]
        done = subprocess.run(words, capture_output=True, text=True, errors="replace")
        executed = re.findall(r"number_of_executed_units: (\d+)", done.stderr)
        count += int(executed[-1]) if executed else 0
        if done.returncode == 0:
            break
        artifact = re.findall(r"Test unit written to (\S+)", done.stderr)
        reason = re.findall(r"panicked at [^\n]*\n[^\n]*|ERROR: [^\n]*", done.stderr)
        # Without the folders of the machine: the input is in that of the findings.
        reason = re.sub(r"\S*/registry/src/[^/]+/", "", (reason or ["ended with an error"])[0])
        findings.append(f"{target}: {' '.join(reason.split())}; input "
                        f"{Path(artifact[-1]).name if artifact else 'unknown'}, seed {seed}")
    run.add(part, target, count, "executions", time.monotonic() - start, findings)


def fuzzed(part, of, sanitizer="none"):
    def carry_out(run, seconds):
        crate, targets = of
        targets = [target for target in targets if not run.only or target in run.only]
        folder = binaries(run, crate, sanitizer) if targets else None
        for target in targets if folder else []:
            fuzz(run, part, crate, target, folder / target, seconds / len(targets))
    return carry_out


# What the program for drops tells besides their count and its findings.
OF_DROPS = ("solids", "too_coarse", "unbearable", "residual", "penetration", "momentum")


def drops(run, seconds):
    """Random drops, each in several ways."""
    words = ["cargo", "build", "-q", "--release", "-p", "softanvil-verification", "--bin", "plausible-drops"]
    if not run.build("random drops", words):
        return
    report, start = run.out / "drops.json", time.monotonic()
    report.unlink(missing_ok=True)
    words = [run.root / "target/release/plausible-drops", str(10**9), str(run.seed), "--coarse", "--ways",
             "--seconds", str(round(seconds)), "--json", report]
    done = subprocess.run(words, capture_output=True, text=True)
    if not report.is_file():
        return run.add("drops", "random drops", 0, "drops", seconds, [f"ended without a report: {done.stderr[-500:]}"])
    counts = json.loads(report.read_text())
    run.add("drops", "random drops", counts["drops"], "drops", time.monotonic() - start, counts["findings"])
    run.rows[-1]["of_drops"] = {key: counts[key] for key in OF_DROPS}


def memory(run, seconds):
    """The targets of the C ABI and of FMI under the address sanitizer, the rigs, and a sample of tests under Miri."""
    number = sum(len(targets) for _, targets in (CALLS, DRIVEN))
    for of in (CALLS, DRIVEN):
        fuzzed("memory", of, "address")(run, seconds * len(of[1]) / number)
    rigs(run)
    miri(run)


def rigs(run):
    """The rigs in C and C++ with sanitizers, valgrind and helgrind, as test.sh runs them."""
    if not (shutil.which("gcc") and shutil.which("g++") and shutil.which("valgrind")):
        return run.skip("rigs in C and C++", "gcc, g++ or valgrind is missing")
    if not run.build("library", ["cargo", "build", "-q", "--release", "-p", "softanvil-ffi"]):
        return
    start = time.monotonic()
    environment = {key: value for key, value in os.environ.items() if key != "SOFTANVIL_CLI"}
    done = subprocess.run(["tests/c/run.sh", "target/release"], cwd=run.root, capture_output=True, text=True, env=environment)
    passed = re.findall(r"^ok +", done.stdout, re.M)
    findings = [f"rigs: {name}" for name in re.findall(r"^FAILED +(.*)$", done.stdout, re.M)]
    if done.returncode and not findings:
        findings = [f"rigs: {done.stderr.strip()[-500:]}"]
    run.add("memory", "rigs in C and C++", len(passed), "checks", time.monotonic() - start, findings)


# Tests that Miri interprets in minutes: memory that the caller lends, snapshots, tables, numbers.
MIRI = {
    "softanvil-kernel": ["--lib", "--", "number::", "state::", "model::"],
    "softanvil-ffi": ["--lib", "--", "c_api::", "variables::"],
}


# Where libm and the library have no assembly, which Miri does not interpret.
MIRI_TARGET = "powerpc64le-unknown-linux-gnu"


def miri(run):
    if not has("cargo", NIGHTLY, "miri", "--version"):
        return run.skip("Miri", "the component miri of the nightly toolchain is missing")
    for package, arguments in MIRI.items():
        start = time.monotonic()
        words = ["cargo", NIGHTLY, "miri", "test", "-q", "--target", MIRI_TARGET, "--target-dir", "target/miri", "-p", package, *arguments]
        environment = os.environ | {"MIRIFLAGS": "-Zmiri-disable-isolation"}
        done = subprocess.run(words, cwd=run.root, capture_output=True, text=True, env=environment)
        passed = sum(map(int, re.findall(r"(\d+) passed", done.stdout)))
        findings = [] if done.returncode == 0 else [f"Miri, {package}: {(done.stderr or done.stdout).strip()[-500:]}"]
        run.add("memory", f"Miri, {package}", passed, "tests", time.monotonic() - start, findings)


@dataclass
class Part:
    """A part, and its share of the time."""

    share: float
    carry_out: Callable


PARTS = {
    "files": Part(30, fuzzed("files", FILES)),
    "calls": Part(20, fuzzed("calls", CALLS)),
    "driven": Part(5, fuzzed("driven", DRIVEN)),
    "drops": Part(35, drops),
    "memory": Part(10, memory),
}
