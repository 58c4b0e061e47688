#!/usr/bin/env python3
"""What a step is made of: anatomy.py PROGRAM OUT.csv, with a `softanvil-bench` built by `cargo build --profile bench`.

Callgrind counts how often each machine instruction of the study's drop runs (AVX2), objdump tells what it is, addr2line
which stage of the step it belongs to. From that: floating-point operations, bytes between registers and memory, and the
share of each stage, per triangle and step.
"""
import collections
import csv
import re
import subprocess
import sys
import tempfile
from pathlib import Path

# What kernel/src/step.rs calls in a step, by name.
STAGES = {
    "monitor": "monitor of the time step",
    "internal_forces": "internal forces",
    "react": "core",
    "contact": "contact with the face",
    "contact_half_width": "contact with the face",
    "move_nodes": "motion",
}
REST = "impactor, energies, samples"
LIBRARY = "filling and copying memory (C library)"
ARITHMETIC = re.compile(r"v?(add|sub|mul|div|sqrt)(p|s)d$")
WIDTH = {"zmm": 8, "ymm": 4, "xmm": 2}
BYTES = {"ZMMWORD": 64, "YMMWORD": 32, "XMMWORD": 16, "QWORD": 8, "DWORD": 4, "WORD": 2, "BYTE": 1}
SET = "Avx2"


def counts(program, folder):
    """How often each address of the program runs within steps, instructions elsewhere, triangles, and steps."""
    out = folder / "callgrind.out"
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", "--dump-instr=yes", "--compress-pos=no",
               "--compress-strings=no", "--toggle-collect=measured_step", str(program), SET]
    told = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    count, elsewhere = collections.Counter(), 0
    inside, is_call = False, False
    for line in out.read_text().splitlines():
        if line.startswith("ob="):
            inside = line.endswith(program.name)
        elif line.startswith("calls="):
            is_call = True
        elif line.startswith("0x"):
            address, _, cost = line.split()
            if is_call:
                is_call = False
            elif inside:
                count[int(address, 16)] += int(cost)
            else:
                elsewhere += int(cost)
    return count, elsewhere, int(told[0]), int(told[1])


def instructions(program):
    """Mnemonic and operands at each address."""
    text = subprocess.run(["objdump", "-d", "-M", "intel", "--no-show-raw-insn", str(program)], check=True,
                          capture_output=True, text=True).stdout
    found = {}
    for line in text.splitlines():
        match = re.match(r"\s*([0-9a-f]+):\s+(\S+)\s*(.*)", line)
        if match:
            found[int(match[1], 16)] = (match[2], match[3].split("#")[0])
    return found


def operations(mnemonic, operands):
    """Floating-point operations of an instruction."""
    match = ARITHMETIC.match(mnemonic)
    if not match:
        return 0
    return 1 if match[2] == "s" else WIDTH[operands.strip()[:3]]


def traffic(mnemonic, operands):
    """Bytes that an instruction reads and writes in memory."""
    match = re.search(r"(\w+) (?:PTR|BCST) ", operands)
    if not match or mnemonic == "lea" or mnemonic.startswith("prefetch") or mnemonic == "nop":
        return 0, 0
    size = BYTES[match[1]]
    first = operands.split(",")[0]
    is_destination = "[" in first and "mov" in mnemonic
    return (0, size) if is_destination else (size, 0)


def stages(program, addresses):
    """The stage of each address: the inlined call that `advance` makes, or the function itself if it is not inlined."""
    text = subprocess.run(["addr2line", "-afiC", "-e", str(program)], check=True, capture_output=True, text=True,
                          input="\n".join(hex(address) for address in addresses)).stdout
    found = {}
    for block in re.split(r"^0x(?=[0-9a-f]{16}$)", text, flags=re.M)[1:]:
        address, *lines = block.splitlines()
        if "::corners::" in lines[-2]:
            # The nodes of a block, gathered by a function of its own.
            found[int(address, 16)] = STAGES["internal_forces"]
            continue
        names = [re.sub(r".*::", "", re.sub(r"<.*", "", name)) for name in lines[::2]]
        depth = names.index("advance") - 1 if "advance" in names else len(names) - 1
        found[int(address, 16)] = STAGES.get(names[max(depth, 0)], REST)
    return found


def main():
    program, out = Path(sys.argv[1]), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        count, elsewhere, triangles, steps = counts(program, Path(folder))
    known, stage = instructions(program), stages(program, sorted(count))
    total = collections.Counter()
    share = collections.Counter({LIBRARY: elsewhere})
    for address, times in count.items():
        mnemonic, operands = known[address]
        read, written = traffic(mnemonic, operands)
        total["instructions"] += times
        total["floating-point operations"] += times * operations(mnemonic, operands)
        total["divisions and roots"] += times * operations(mnemonic, operands) * bool(re.match("v?(div|sqrt)", mnemonic))
        total["bytes read"] += times * read
        total["bytes written"] += times * written
        share[stage[address]] += times
    total["instructions"] += elsewhere
    with out.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["figure", "value"])
        for name, value in total.items():
            writer.writerow([name, f"{value / triangles / steps:.1f}"])
        for name, value in share.most_common():
            writer.writerow([f"share: {name}", f"{value / total['instructions']:.4f}"])
    print(out.read_text())


if __name__ == "__main__":
    main()
