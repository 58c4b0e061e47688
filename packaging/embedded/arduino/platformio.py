"""Links the library of the board's processor, with the calling convention that the board's flags ask for."""

import os

Import("env")  # noqa: F821

#: The floating-point unit of each processor, as the folders are named.
UNITS = {"cortex-m4": "fpv4-sp-d16", "cortex-m7": "fpv5-d16"}

cpu = env.BoardConfig().get("build.cpu", "")  # noqa: F821
if cpu not in UNITS:
    raise SystemExit(f"Softanvil has no library for the processor {cpu!r}: expected one of {', '.join(UNITS)}")
flags = " ".join(str(flag) for key in ("CCFLAGS", "LINKFLAGS") for flag in env.get(key, []))  # noqa: F821
convention = "softfp" if "softfp" in flags else "hard"
folder = os.path.join(os.getcwd(), "src", cpu, f"{UNITS[cpu]}-{convention}")
env.Append(LIBPATH=[folder], LIBS=["softanvil"])  # noqa: F821
