"""One table of the three drops of the study over everything that computes them: the command line, the C ABI and the FMUs of
both versions, on every platform that runs here, in communication steps of several lengths, saved and restored in mid-impact,
and in eight threads at once. Peak force, impulse and trace hash have to be equal to the last bit.

    run.sh BUILD_FOLDER matrix            builds the FMUs and prints the table
    run.sh BUILD_FOLDER matrix --brief    makes eight drops where it makes twenty-three, on platforms that are emulated

Every drop goes to matrix.csv in the folder named by --out, with all digits.
"""

import argparse
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import fmpy

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parent.parent
HEADERS = pathlib.Path(fmpy.__file__).parent / "c-code"
ENERGIES = [14.7, 9.8, 4.9]
WAYS = ["50 us", "100 us", "1 ms", "30 us", "restored", "8 threads"]
INTERFACES = {"C ABI": "c_abi", "FMI 2": "fmi2", "FMI 3": "fmi3"}


@dataclass(frozen=True)
class Platform:
    """How programs for a platform are built and run; `members` are the libraries in the FMUs by interface."""

    name: str
    target: str
    compiler: str
    runner: list
    members: dict
    system: list

    def missing(self):
        """The first tool that is not there."""
        tools = [self.compiler, *self.runner[:1]]
        return next((tool for tool in tools if not shutil.which(tool)), None)


LINUX = ["-ldl", "-lm", "-pthread"]
PLATFORMS = [
    Platform("Linux x86-64", "x86_64-unknown-linux-gnu", "gcc", [],
             {"FMI 2": "linux64/softanvil.so", "FMI 3": "x86_64-linux/softanvil.so"}, LINUX),
    Platform("Linux aarch64", "aarch64-unknown-linux-gnu", "aarch64-linux-gnu-gcc",
             ["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"], {"FMI 3": "aarch64-linux/softanvil.so"}, LINUX),
    Platform("Windows x86-64", "x86_64-pc-windows-gnu", "x86_64-w64-mingw32-gcc", ["wine"],
             {"FMI 2": "win64/softanvil.dll", "FMI 3": "x86_64-windows/softanvil.dll"},
             ["-static", "-lpthread", "-lws2_32", "-luserenv", "-lntdll", "-lbcrypt"]),
]


def static_library(platform):
    """The C ABI for a platform: here the one beside the command line, elsewhere built as the tests of other targets build,
    in their folder, with the same linker, by which cargo tells builds apart."""
    if not platform.runner:
        return pathlib.Path(os.environ["SOFTANVIL_CLI"]).with_name("libsoftanvil.a")
    folder = ROOT / "target/targets/cargo"
    linker = {"CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER": "aarch64-linux-gnu-gcc"}
    subprocess.run(["cargo", "rustc", "--quiet", "--release", "--lib", "--crate-type", "staticlib", "--target", platform.target,
                    "--manifest-path", ROOT / "ffi/Cargo.toml", "--target-dir", folder], check=True, env={**os.environ, **linker})
    return folder / platform.target / "release/libsoftanvil.a"


def library(platform, interface, scratch):
    """The library in the FMU. FMI 2.0 has one folder for all of Linux, so its library for aarch64 is that of FMI 3.0, which
    exports both versions."""
    held = interface if interface in platform.members else "FMI 3"
    fmu = os.environ["SOFTANVIL_FMU" if held == "FMI 2" else "SOFTANVIL_FMU3"]
    with zipfile.ZipFile(fmu) as archive:
        member = f"binaries/{platform.members[held]}"
        return archive.extract(member, scratch / interface) if member in archive.namelist() else None


def run(platform, interface, scratch, token, brief):
    """Rows (energy, way, peak force, impulse, trace hash) as texts; a message instead if something is missing."""
    program = scratch / f"{platform.target}-{INTERFACES[interface]}.exe"
    command = [platform.compiler, "-std=c11", "-D_GNU_SOURCE", "-O2", "-Wall", "-Wextra", "-Werror", f"-I{HEADERS}",
               f"-I{ROOT / 'include'}", HERE / "matrix/matrix.c", HERE / f"matrix/{INTERFACES[interface]}.c", "-o", program]
    arguments, libraries = ["", ""], []
    if interface == "C ABI":
        libraries = [static_library(platform)]
        if platform.compiler.endswith("mingw32-gcc"):
            # Rust's standard library asks for it, and older versions of wine lack it.
            stub = ROOT / "tests/targets/bcryptprimitives.c"
            subprocess.run([platform.compiler, "-shared", "-o", scratch / "bcryptprimitives.dll", stub], check=True)
    else:
        path = library(platform, interface, scratch)
        if path is None:
            return "the FMU has no library for it"
        arguments = [path, token]
    arguments += ["brief"] if brief and "qemu" in "".join(platform.runner[:1]) else []
    subprocess.run([*command, *libraries, *platform.system], check=True)
    environment = {**os.environ, "WINEDEBUG": "-all", "WINEPREFIX": os.environ.get("SOFTANVIL_WINE", str(scratch / "wine"))}
    done = subprocess.run([*platform.runner, program, *arguments], capture_output=True, text=True, env=environment)
    if done.returncode != 0:
        return f"the program fails: {done.stderr.strip()}"
    return [line.split(",") for line in done.stdout.splitlines()]


def kernel(energy):
    """Peak force, impulse and trace hash by the command line."""
    command = [os.environ["SOFTANVIL_CLI"], "run", "--energy", str(energy), "--json"]
    result = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return result["peak_force"], result["impulse"], result["trace_hash"]


def verdict(rows, expected):
    """What the table says of some drops: how many are the command line's, or what is not."""
    if not rows:
        return "MISSING"
    different = [row for row in rows if (float(row[2]), float(row[3]), row[4]) != expected[row[0]]]
    return f"{len(rows)} same" if not different else "DIFFERENT"


def table(scratch, out, brief):
    """Prints the table; tells whether everything is there and equal."""
    token = fmpy.read_model_description(os.environ["SOFTANVIL_FMU"]).guid
    expected = {str(energy): kernel(energy) for energy in ENERGIES}
    print("drop    peak force [N]       impulse [N s]        trace hash        by the command line")
    for energy, (peak, impulse, trace_hash) in expected.items():
        print(f"{energy:>4} J  {peak!r:<19}  {impulse!r:<19}  {trace_hash}")
    print(f"\n{'platform':<15} {'interface':<10}" + "".join(f"{way:<11}" for way in WAYS))
    jobs = [(platform, interface) for platform in PLATFORMS for interface in INTERFACES]
    good, records = True, []
    with ThreadPoolExecutor(2) as pool:
        found = pool.map(lambda job: job[0].missing() and f"{job[0].missing()} is missing" or run(*job, scratch, token, brief), jobs)
        for (platform, interface), rows in zip(jobs, found):
            if isinstance(rows, str):
                # A tool that is not there is a gap in the table; anything else is a failure.
                good &= platform.missing() is not None and os.environ.get("CI") != "true"
                print(f"{platform.name:<15} {interface:<10}{rows}", flush=True)
                continue
            verdicts = [verdict([row for row in rows if row[1] == way], expected) for way in WAYS]
            good &= all("same" in text for text in verdicts)
            print(f"{platform.name:<15} {interface:<10}" + "".join(f"{text:<11}" for text in verdicts), flush=True)
            records += [[platform.name, interface, *row] for row in rows]
    with (out / "matrix.csv").open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["platform", "interface", "energy_J", "way", "peak_force_N", "impulse_Ns", "trace_hash"])
        writer.writerows(records)
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "target", help="folder for matrix.csv (default: target)")
    parser.add_argument("--brief", action="store_true", help="fewer drops on platforms that are emulated, where one takes seconds")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        sys.exit(0 if table(pathlib.Path(scratch), arguments.out, arguments.brief) else 1)


if __name__ == "__main__":
    main()
