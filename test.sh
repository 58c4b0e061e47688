#!/usr/bin/env bash
# Installs what the tests need and runs them all. What cannot be installed without root is skipped by name and counted;
# with CI=true a skip is a failure. What this processor cannot run is not applicable, which never is one.
set -uo pipefail
cd "$(dirname "$0")"

# How every test ended, a line each; the scripts below add what they did not run.
export SOFTANVIL_NOT_RUN
SOFTANVIL_NOT_RUN=$(mktemp)
endings=$SOFTANVIL_NOT_RUN
trap 'rm -f "$endings"' EXIT

pass() { printf 'PASSED: %s\n' "$1" >>"$endings"; }
fail() { printf 'FAILED: %s\n' "$1" | tee -a "$endings" >&2; }
skip() { if [ "${CI:-}" = true ]; then fail "$1 (skipped: $2)"; else hand_up SKIPPED "$@"; fi; }
not_applicable() { hand_up 'NOT APPLICABLE' "$@"; }

# spend: the seconds of processors that this shell has waited for, in `spent`. Other shells, as of $( ), have spent nothing.
spend() {
    local file=$endings.$BASHPID
    times >"$file"
    spent=$(awk -F '[ms ]+' 'END { printf "%d", 60 * ($1 + $3) + $2 + $4 }' "$file")
    rm -f "$file"
}

# run NAME COMMAND...: one test, the seconds it took, and those of processors, which depend less on what else is running.
run() {
    local name=$1 start=$SECONDS before spent; shift
    printf '\n== %s\n' "$name"
    spend && before=$spent
    if "$@"; then pass "$name"; else fail "$name"; fi
    spend
    printf -- '-- %s: %d s, %d s of processors\n' "$name" $((SECONDS - start)) $((spent - before))
}

# beside GROUP: a function of tests, of which one more run side by side than there are processors: most keep one busy, and some
# wait for what they have started.
# What a group prints comes when it is done.
beside() {
    while [ "$(jobs -rp | wc -l)" -gt "$(nproc)" ]; do wait -n; done
    { printed=$(mktemp) && "$1" >"$printed" 2>&1; cat "$printed" && rm "$printed"; } &
}

. tests/need.sh
. tests/processor.sh

# The README's first command, as a user gives it; the report goes to a folder that is removed.
main_job() {
    local out status
    out=$(mktemp -d) && cargo run -q --release -- --out "$out/report" && [ -s "$out/report/force-time.svg" ]
    status=$?
    rm -rf "$out"
    return $status
}

# What the groups need is installed before they start: two installations at once are refused.
have_board() {
    command -v rustup >/dev/null && need arm-none-eabi-gcc gcc-arm-none-eabi && need qemu-system-arm qemu-system-arm
}
have_c() { need gcc gcc libc6-dev && need g++ g++ && need valgrind valgrind libc6-dbg; }
# Debian packs virtual environments apart.
have_venv() {
    python3 -c 'import ensurepip' 2>/dev/null || { need no-such-command python3-venv; python3 -c 'import ensurepip'; }
}
have_python() { need python3 python3 && have_venv && need gcc gcc libc6-dev; }
# A library of the importer ecos.
have_tbb() { PATH=$PATH:/usr/sbin:/sbin ldconfig -p | grep 'libtbb\.so\.12' >/dev/null; }

# The groups by what they take, the longest first, so that no processor has nothing to do at the end.
groups=() python=
if have_python; then
    python=1
    groups+=(fmu_tests)
    # Other platforms, and a library of the importer ecos; without them their tests are skipped.
    need aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu libc6-dev-arm64-cross && need qemu-aarch64 qemu-user \
        || skip "FMU on aarch64" "the cross compiler or qemu is missing and cannot be installed"
    need x86_64-w64-mingw32-gcc gcc-mingw-w64-x86-64 && need wine wine wine64 \
        || skip "FMU on Windows" "mingw or wine is missing and cannot be installed"
    have_tbb || { need no-such-command libtbb12; have_tbb; } \
        || skip "FMU in ecos" "libtbb12 is missing and cannot be installed"
    page=1
    need chromium chromium || { page=; skip "page in a browser" "chromium is missing and cannot be installed"; }
else
    for name in "FMU in other tools" "first programs and pictures of the README" "fitted material files in other tools" \
        "series for ParaView" "page in a browser" "Python package" "files for a host of the repository"; do
        skip "$name" "python3 with venv, or gcc, is missing and cannot be installed"
    done
fi
groups+=(target_tests rust_tests ${python:+wheel_tests python_tests page_tests})
if have_c && need cmake cmake && need pkg-config pkg-config; then
    groups+=(package_tests)
else
    skip "installed package, and its library in C and C++ rigs" \
        "gcc, g++, valgrind, cmake or pkg-config is missing and cannot be installed"
fi
if have_c; then
    groups+=(c_tests)
else
    skip "C and C++ rigs" "gcc, g++ or valgrind is missing and cannot be installed"
fi

rust_tests() {
    # They take every instruction set that the processor has.
    runs "Rust tests with AVX2" x86-64-v3
    runs "Rust tests with AVX-512" x86-64-v4
    run "Rust tests" cargo test -q --profile checked "${checked[@]}" --no-fail-fast
}
fmu_tests() {
    run "FMU in other tools, release library" tests/fmi/run.sh target/release
    run "FMU in other tools, checked program" tests/fmi/run.sh target/checked test_results.py -k "last_bit"
}
python_tests() {
    run "first programs and pictures of the README" tests/readme.sh target/release "$SOFTANVIL_VENV"
    run "fitted material files in other tools" tests/identify/run.sh target/release "$SOFTANVIL_VENV"
    run "series for ParaView" tests/report/run.sh target/release "$SOFTANVIL_VENV"
}
page_tests() {
    [ -z "$page" ] || run "page in a browser" tests/page/run.sh target/release "$SOFTANVIL_VENV"
    run "page is of these sources" tests/page/rebuilt.sh target/release
}
wheel_tests() { run "Python package" python/test.sh; }
target_tests() { run "same digests on every target" tests/targets/run.sh; }
# The second takes the library that the first has built.
package_tests() {
    run "installed package" tests/c/package.sh
    run "library within another project" tests/packages/run.sh sources target/install/cargo
    run "C and C++ rigs, library as installed" tests/c/run.sh target/install/lib
}
c_tests() {
    run "C and C++ rigs, library with checks" tests/c/run.sh target/checked
    run "instructions of a step" bench/instructions.sh target/release
}

# A Cortex-M7 without an operating system, in QEMU; the footprint takes its RAM and stack from there. They need nothing that
# is built here, and so run beside the builds, which often keep one processor busy.
board_tests() {
    run "firmware on a Cortex-M7" tests/firmware/run.sh
    [ -z "$footprint" ] || run "footprint" tests/footprint/run.sh
}
export SOFTANVIL_CLI=$PWD/target/release/softanvil
export SOFTANVIL_VENV=${SOFTANVIL_VENV:-$PWD/.venv}
if have_board; then
    footprint=1
    need readelf binutils || { footprint=; skip "footprint" "readelf is missing"; }
    beside board_tests
else
    skip "firmware on a Cortex-M7" "rustup, arm-none-eabi-gcc or qemu-system-arm is missing and cannot be installed"
    skip "footprint" "rustup, arm-none-eabi-gcc or qemu-system-arm is missing and cannot be installed"
fi

run "format" cargo fmt --all --check
# With the profile of the build that follows, which then has its procedural macros.
run "clippy" cargo clippy -q --release --workspace --all-targets -- -D warnings
if need python3 python3; then
    run "imports run one way" python3 tests/imports.py kernel ffi fmu specimen tools tools/identify tools/page \
        tools/records tests/verification python python/softanvil
    run "counts of reliability are those recorded" python3 tests/endurance/page.py --check
else
    for name in "imports run one way" "counts of reliability are those recorded"; do
        skip "$name" "python3 is missing and cannot be installed"
    done
fi
run "documentation" env RUSTDOCFLAGS=-Dwarnings cargo doc -q --release --workspace --no-deps
# With the package for Python, so that all has the features that it has in the whole workspace, and is not built anew for
# `cargo run` or for a wheel.
run "build, release" cargo build -q --release -p softanvil -p softanvil-ffi -p softanvil-bench -p softanvil-python
# Everything that the Rust tests take, at once: parts of the workspace built alone may have other features, and libraries of
# the same name would take each other's place. The package for Python has no tests in Rust.
checked=(--workspace --exclude softanvil-python)
run "build, checked" cargo build -q --profile checked "${checked[@]}" --lib --bins --examples --tests
# Without the features that the rest of the workspace switches on, and without pads; where the rows of tests/targets are built, which
# take the same libraries.
kernel_alone() {
    local alone=(--release --no-default-features --target-dir target/targets/cargo --target "$(rustc -vV | sed -n 's/^host: //p')")
    cargo test -q "${alone[@]}" -p softanvil-kernel --lib && cargo run -q "${alone[@]}" -p softanvil-golden -- check
}
run "kernel alone, no_std and without pads" kernel_alone
run "packages of the crates" tests/package.sh
if [ -n "$python" ]; then
    run "Python packages of the tests" tests/fmi/venv.sh "$SOFTANVIL_VENV"
    run "files for a host of the repository" tests/host.sh "$SOFTANVIL_VENV"
fi
run "main job" main_job
run "processors that lack something" tests/targets/processors.sh

for group in "${groups[@]}"; do beside "$group"; done
wait

# ended KIND: how many tests ended so.
ended() { grep -c "^$1: " "$endings"; }

printf '\n'
grep -v '^PASSED: ' "$endings"
printf '%d not applicable to this processor\n' "$(ended 'NOT APPLICABLE')"
printf '%d passed, %d failed, %d skipped\n' "$(ended PASSED)" "$(ended FAILED)" "$(ended SKIPPED)"
[ "$(ended FAILED)" = 0 ]
