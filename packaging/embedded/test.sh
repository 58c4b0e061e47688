#!/usr/bin/env bash
# Tries the folder for microcontrollers without the SDKs, with arm-none-eabi-gcc: an application that takes the module of Zephyr runs the
# golden trace in QEMU, the sketch of Arduino is linked as a core does it and runs, Kconfig offers the library to the processors that it
# has, and PlatformIO accepts the manifest. What is missing is skipped by name.
#
#     packaging/embedded/test.sh FOLDER
set -euo pipefail
tree=$(cd "${1:?usage: test.sh FOLDER}" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
. "$root/tests/need.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
firmware=$root/tests/firmware/c

# run ELF: on the emulated Cortex-M7.
run() { timeout 120 qemu-system-arm -M mps2-an500 -nographic -semihosting-config enable=on,arg=drop -icount shift=0 -kernel "$1" 2>&1; }

flags() {
    case $1 in
        cortex-m4) echo "-mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=$2" ;;
        cortex-m7) echo "-mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=$2" ;;
    esac
}

if need arm-none-eabi-gcc gcc-arm-none-eabi && need qemu-system-arm qemu-system-arm && need cmake cmake; then
    awk '!/^#/ { printf "    { %su, %s, %s, 0x%su },\n", $1, $2, $3, $4 }' \
        "$root/tests/golden/traces/drop-14.7-J.txt" >"$work/golden.inc"
    for cpu in cortex-m7 cortex-m4; do
        for abi in hard softfp; do
            symbols="CONFIG_SOFTANVIL;CONFIG_CPU_${cpu^^}" && symbols=${symbols//-/_}
            [ $abi = hard ] || symbols+=";CONFIG_FP_SOFTABI"
            flags=$(flags $cpu $abi)
            cmake -S "$here/test/zephyr" -B "$work/$cpu-$abi" -DMODULE="$tree" -DFIRMWARE="$firmware" -DGOLDEN="$work" \
                -DCONFIGURED="$symbols" -DPROCESSOR="${flags// /;}" >"$work/log" 2>&1 &&
                cmake --build "$work/$cpu-$abi" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
            if [ $cpu = cortex-m7 ]; then
                run "$work/$cpu-$abi/application" | grep '^the bits of the golden trace$' >/dev/null
                echo "Zephyr-like application, $cpu, $abi: links, and gives the bits of the golden trace"
            else
                echo "Zephyr-like application, $cpu, $abi: links"
            fi

            # As a core compiles a sketch: the library by name, from the folder of processor and unit.
            unit=$(ls -d "$tree/src/$cpu"/*-$abi)
            for source in "$tree/examples/Drop/Drop.ino" "$here/test/sketch.cpp"; do
                # shellcheck disable=SC2086
                arm-none-eabi-g++ -std=gnu++11 -Wall -Wextra -Os -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffreestanding \
                    $flags -I "$here/test" -I "$tree/src" -I "$firmware" -x c++ "$source" -c -o "$work/$(basename "$source").o"
            done
            # shellcheck disable=SC2086
            arm-none-eabi-gcc -std=c11 -O2 -ffreestanding -ffunction-sections $flags "$firmware"/{board,startup}.c "$work"/*.o \
                -nostdlib -T "$firmware/board.ld" -Wl,--gc-sections -Wl,--no-warn-rwx-segments -L "$unit" -lsoftanvil -lgcc \
                -o "$work/sketch.elf"
            rm -f "$work"/*.o
            if [ $cpu = cortex-m7 ]; then
                run "$work/sketch.elf" | grep '^peak force in N: 5444$' >/dev/null
                echo "Arduino-like sketch, $cpu, $abi: links, and has the peak of 5444 N"
            else
                echo "Arduino-like sketch, $cpu, $abi: links"
            fi
        done
    done
else
    echo "SKIPPED: programs for microcontrollers: arm-none-eabi-gcc, qemu-system-arm or cmake is missing" >&2
fi

venv=$root/target/packaging-embedded
if { [ -x "$venv/bin/python" ] || python3 -m venv "$venv"; } &&
    "$venv/bin/python" -m pip install --quiet --disable-pip-version-check kconfiglib==14.1.0 'platformio>=6,<7'; then
    "$venv/bin/python" "$here/test/kconfig.py" "$tree/zephyr/Kconfig"
    "$venv/bin/python" "$here/test/manifest.py" "$tree/library.json"
else
    echo "SKIPPED: manifests for microcontrollers: kconfiglib or platformio cannot be installed" >&2
fi
