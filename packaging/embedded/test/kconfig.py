"""kconfig.py KCONFIG: offers the library where Zephyr has the processor and an FPU, and nowhere else."""

import os
import sys
import tempfile

import kconfiglib

#: What Zephyr's own Kconfig files define.
BEFORE = """
config CPU_CORTEX_M4
	bool "M4"
config CPU_CORTEX_M7
	bool "M7"
config FPU
	bool "FPU"
source "{}"
"""

with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "Kconfig")
    with open(path, "w") as file:
        file.write(BEFORE.format(os.path.abspath(sys.argv[1])))
    os.environ["srctree"] = folder
    for present, offered in [
        ([], False), (["FPU"], False), (["CPU_CORTEX_M7"], False), (["CPU_CORTEX_M7", "FPU"], True),
        (["CPU_CORTEX_M4", "FPU"], True)]:
        config = kconfiglib.Kconfig(path)
        assert not config.warnings, config.warnings
        for symbol in present:
            config.syms[symbol].set_value("y")
        config.syms["SOFTANVIL"].set_value("y")
        assert (config.syms["SOFTANVIL"].str_value == "y") == offered, present
        assert config.syms["SOFTANVIL_STACK_SIZE"].str_value == ("32768" if offered else ""), present
print("Kconfig offers the library to Cortex-M4 and Cortex-M7 with an FPU")
