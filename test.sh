#!/usr/bin/env bash
# Installs what the tests need and runs them all. What cannot be installed without root is skipped by name and counted;
# with CI=true a skip is a failure. What this processor cannot run is not applicable, which never is one.
set -uo pipefail
cd "$(dirname "$0")"

passed=0 failed=0
failures=()
# What the scripts below did not run, a line each.
export SOFTANVIL_NOT_RUN
SOFTANVIL_NOT_RUN=$(mktemp)
trap 'rm -f "$SOFTANVIL_NOT_RUN"' EXIT

pass() { passed=$((passed + 1)); }
fail() { failed=$((failed + 1)); failures+=("$1"); printf 'FAILED: %s\n' "$1" >&2; }
skip() { if [ "${CI:-}" = true ]; then fail "$1 (skipped: $2)"; else hand_up SKIPPED "$@"; fi; }
not_applicable() { hand_up 'NOT APPLICABLE' "$@"; }

# run NAME COMMAND...: one test, and the seconds it took.
run() {
    local name=$1 start=$SECONDS; shift
    printf '\n== %s\n' "$name"
    if "$@"; then pass; else fail "$name"; fi
    printf -- '-- %s: %d s\n' "$name" $((SECONDS - start))
}

# told FILE ID: waits for a test that was started before, and gives what it printed into FILE.
told() {
    local status
    wait "$2"
    status=$?
    cat "$1" && rm "$1"
    return $status
}

. tests/need.sh
. tests/processor.sh

# drop_hashes CLI: the trace hashes of the three drops.
drop_hashes() {
    local energy
    for energy in 14.7 9.8 4.9; do "$1" run --energy "$energy" --json | grep -o '"trace_hash": *"[0-9a-f]*"' || return 1; done
}

same_hashes() {
    local release debug
    release=$(drop_hashes target/release/softanvil) && debug=$(drop_hashes target/debug/softanvil) || return 1
    printf 'release:\n%s\ndebug:\n%s\n' "$release" "$debug"
    [ -n "$release" ] && [ "$release" = "$debug" ]
}

# The README's first command, as a user gives it; the report goes to a folder that is removed.
main_job() {
    local out status
    out=$(mktemp -d) && cargo run -q --release -- --out "$out/report" && [ -s "$out/report/force-time.svg" ]
    status=$?
    rm -rf "$out"
    return $status
}

# The kernel alone, without the features that the rest of the workspace switches on.
kernel_alone() { cargo build -q --release -p softanvil-kernel --no-default-features; }

run "format" cargo fmt --all --check
run "clippy" cargo clippy -q --workspace --all-targets -- -D warnings
run "build, release" cargo build -q --release --workspace
run "build, debug" cargo build -q -p softanvil -p softanvil-ffi
run "kernel alone, no_std" kernel_alone
run "processors that lack something" tests/targets/processors.sh
# They take every instruction set that the processor has.
runs "Rust tests with AVX2" x86-64-v3
runs "Rust tests with AVX-512" x86-64-v4
run "Rust tests" cargo test -q --profile checked --workspace --no-fail-fast
run "same trace in debug and release" same_hashes
run "main job" main_job

# A Cortex-M7 without an operating system, in QEMU.
if command -v rustup >/dev/null && need arm-none-eabi-gcc gcc-arm-none-eabi && need qemu-system-arm qemu-system-arm; then
    run "firmware on a Cortex-M7" tests/firmware/run.sh
    if need readelf binutils; then run "footprint" tests/footprint/run.sh; else skip "footprint" "readelf is missing"; fi
else
    skip "firmware on a Cortex-M7" "rustup, arm-none-eabi-gcc or qemu-system-arm is missing and cannot be installed"
    skip "footprint" "rustup, arm-none-eabi-gcc or qemu-system-arm is missing and cannot be installed"
fi

run "same digests on every target" tests/targets/run.sh

export SOFTANVIL_CLI=$PWD/target/release/softanvil
if need gcc gcc libc6-dev && need g++ g++ && need valgrind valgrind libc6-dbg; then
    # The debug library takes its time on one core: what follows does not wait for it.
    debug_rigs=$(mktemp)
    tests/c/run.sh target/debug >"$debug_rigs" 2>&1 &
    debug_rigs_id=$!
    run "C and C++ rigs, release library" tests/c/run.sh target/release
    run "instructions of a step" bench/instructions.sh target/release
    if need cmake cmake && need pkg-config pkg-config; then
        run "installed package" tests/c/package.sh
    else
        skip "installed package" "cmake or pkg-config is missing and cannot be installed"
    fi
else
    skip "C and C++ rigs" "gcc, g++ or valgrind is missing and cannot be installed"
    skip "installed package" "gcc, g++ or valgrind is missing and cannot be installed"
fi

# have_venv: whether python3 makes virtual environments, which Debian packs apart.
have_venv() { python3 -c 'import ensurepip' 2>/dev/null || { need no-such-command python3-venv; python3 -c 'import ensurepip'; }; }

# have_tbb: whether the library of the importer ecos is there.
have_tbb() { PATH=$PATH:/usr/sbin:/sbin ldconfig -p | grep 'libtbb\.so\.12' >/dev/null; }

if need python3 python3 && have_venv && need gcc gcc libc6-dev; then
    # Other platforms, and a library of the importer ecos; without them their tests are skipped.
    need aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu libc6-dev-arm64-cross && need qemu-aarch64 qemu-user \
        || skip "FMU on aarch64" "the cross compiler or qemu is missing and cannot be installed"
    need x86_64-w64-mingw32-gcc gcc-mingw-w64-x86-64 && need wine wine wine64 \
        || skip "FMU on Windows" "mingw or wine is missing and cannot be installed"
    have_tbb || { need no-such-command libtbb12; have_tbb; } \
        || skip "FMU in ecos" "libtbb12 is missing and cannot be installed"
    export SOFTANVIL_VENV=${SOFTANVIL_VENV:-$PWD/.venv}
    run "FMU in other tools, release library" tests/fmi/run.sh target/release
    run "FMU in other tools, debug library" tests/fmi/run.sh target/debug test_results.py -k "last_bit"
    run "programs and picture of the README" tests/readme.sh target/release "$SOFTANVIL_VENV"
    run "fitted material files in other tools" tests/identify/run.sh target/release "$SOFTANVIL_VENV"
    if need chromium chromium; then
        run "report in a browser, series for ParaView" tests/report/run.sh target/release "$SOFTANVIL_VENV"
    else
        skip "report in a browser" "chromium is missing and cannot be installed"
        run "series for ParaView" tests/report/run.sh target/release "$SOFTANVIL_VENV" test_series.py
    fi
else
    skip "FMU in other tools" "python3 with venv, or gcc, is missing and cannot be installed"
    skip "programs and picture of the README" "python3 with venv, or gcc, is missing and cannot be installed"
    skip "fitted material files in other tools" "python3 with venv, or gcc, is missing and cannot be installed"
    skip "report in a browser, series for ParaView" "python3 with venv, or gcc, is missing and cannot be installed"
fi

if [ -n "${debug_rigs:-}" ]; then run "C and C++ rigs, debug library" told "$debug_rigs" "$debug_rigs_id"; fi

# not_run KIND: how many of these there are.
not_run() { grep -c "^$1: " "$SOFTANVIL_NOT_RUN"; }

printf '\n'
cat "$SOFTANVIL_NOT_RUN"
[ ${#failures[@]} -gt 0 ] && printf 'FAILED: %s\n' "${failures[@]}"
printf '%d passed, %d failed, %d skipped, %d not applicable\n' "$passed" "$failed" "$(not_run SKIPPED)" \
    "$(not_run 'NOT APPLICABLE')"
[ "$failed" = 0 ]
