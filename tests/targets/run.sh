#!/usr/bin/env bash
# Builds the golden traces' runner (tests/golden) for every kind of target, runs the scenes there, carries a snapshot
# there and back, and prints the digests as a table: all must be equal. Installs what it needs if it may; what it cannot
# have is skipped by name (with CI=true a skip is a failure).
#
#     tests/targets/run.sh [WORD]    only rows whose name contains WORD
set -uo pipefail
cd "$(dirname "$0")/../.."
root=$PWD out=$PWD/target/targets only=${1:-}
work=$out/work table=$out/table.txt
. tests/need.sh
mkdir -p "$work"
printf '%-44s %-6s  %-16s  %-16s  %s\n' target scenes 'until 2.5 ms' 'whole scenes' 'snapshot there and back' >"$table"

# The scene whose snapshots travel, and the records (0.25 ms each) at which they are saved.
scene=yeoh leave=6 return=8
rows=0 failed=0 skipped=0 home=()

wanted() { [[ $1 == *"$only"* ]]; }
skip() { skipped=$((skipped + 1)); printf '%-44s skipped: %s\n' "$1" "$2" | tee -a "$table"; }

# The runner, and the folder of its firmware; at the end those in single precision take their place.
runner=softanvil-golden firmware=tests/firmware/rust

# build NAME CARGO_ARGUMENT...: the runner in a folder of its own; what changes no bits is set to build fast.
build() {
    local name=$1; shift
    CARGO_PROFILE_RELEASE_LTO=${LTO:-off} CARGO_PROFILE_RELEASE_CODEGEN_UNITS=${UNITS:-16} \
        cargo build -q -p "$runner" --target-dir "$out/$name" "$@"
}

# snapshots COMMAND...: a state saved at home goes on there, is saved, is the same file as one that never left, and goes
# on at home to the end of the scene.
snapshots() {
    (cd "$work" && "${home[@]}" save $scene $leave leaves && "${home[@]}" save $scene $return stayed &&
        rm -f returns && "$@" resume $scene leaves $return returns && cmp stayed returns &&
        "${home[@]}" resume $scene returns) >"$work/snapshots.txt" 2>&1
}

# summary CHECK COMMAND...: number of scenes and digests that a check ends with, into row.txt and errors.txt its output.
summary() {
    local check=$1; shift
    # shellcheck disable=SC2086
    (cd "$work" && timeout 300 "$@" $check) </dev/null >"$work/row.txt" 2>"$work/errors.txt"
    local status=$?
    tr -d '\r' <"$work/row.txt" | sed -n 's/^summary //p'
    return $status
}

# row NAME CHECK COMMAND...: a line of the table; CHECK is the words of the check, which the first row's program, home,
# answers too.
row() {
    local name=$1 check=$2 verdict=same carried=same expected found scenes until_short until_end; shift 2
    [ ${#home[@]} -gt 0 ] || home=("$@")
    expected=$(summary "$check" "${home[@]}")
    found=$(summary "$check" "$@") && [ -n "$found" ] && [ "$found" = "$expected" ] || verdict=DIFFERENT
    snapshots "$@" || carried=DIFFERENT
    rows=$((rows + 1))
    read -r scenes until_short until_end <<<"$found"
    printf '%-44s %-6s  %-16s  %-16s  %s\n' "$name" "${scenes:--}" "${until_short:--}" "${until_end:--}" "$carried" |
        tee -a "$table"
    if [ "$verdict $carried" != "same same" ]; then
        failed=$((failed + 1))
        printf 'FAILED: %s; expected %s\n' "$name" "$expected"
        grep -ahv '^summary\|same$' "$work/row.txt" "$work/errors.txt" "$work/snapshots.txt" | head -20
    fi
}

# native NAME FOLDER PROFILE CARGO_ARGUMENT...: a row of this machine.
native() {
    local name=$1 folder=$2 profile=$3; shift 3
    wanted "$name" || return 0
    if build "$folder" --profile "$profile" "$@"; then
        [ "$profile" = dev ] && profile=debug
        row "$name" check "$out/$folder/$profile/$runner"
    else
        failed=$((failed + 1)); printf 'FAILED: %s does not build\n' "$name"
    fi
}

# foreign NAME TARGET CHECK EXTENSION COMMAND...: a row of another target, by a command that runs its programs.
foreign() {
    local name=$1 target=$2 check=$3 extension=$4; shift 4
    wanted "$name" || return 0
    timeout 120 rustup target add "$target" >/dev/null 2>&1 || { skip "$name" "rustup has no $target"; return; }
    if build "$target" --release --target "$target"; then
        row "$name" "$check" "$@" "$out/$target/$target/release/$runner$extension"
    else
        failed=$((failed + 1)); printf 'FAILED: %s does not build\n' "$name"
    fi
}

# board NAME TARGET FLAGS CHECK: a row of a Cortex-M7 without an operating system.
on_board() {
    local elf=$1 configuration=enable=on,target=native,arg=runner word; shift
    for word in "$@"; do configuration+=,arg=$word; done
    qemu-system-arm -M mps2-an500 -display none -monitor none -serial none -semihosting-config "$configuration" \
        -kernel "$elf"
}
export -f on_board
board() {
    local name=$1 target=$2 flags=$3 check=$4
    wanted "$name" || return 0
    timeout 120 rustup target add "$target" >/dev/null 2>&1 || { skip "$name" "rustup has no $target"; return; }
    if (cd "$firmware" && RUSTFLAGS=$flags CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 \
        cargo build -q --release --bin runner --target "$target" --target-dir "$out/firmware"); then
        row "$name" "$check" bash -c 'on_board "$@"' board "$out/firmware/$target/release/runner"
    else
        failed=$((failed + 1)); printf 'FAILED: %s does not build\n' "$name"
    fi
}

# The first row is what the others are compared with, so it is always there: as it is shipped.
LTO=thin UNITS=1 build o3 --release || exit 1
row "$(uname -m), opt-level 3" check "$out/o3/release/softanvil-golden"
native "$(uname -m), opt-level 0, debug" o0 dev
for level in 2 s; do
    CARGO_PROFILE_RELEASE_OPT_LEVEL=$level native "$(uname -m), opt-level $level" "o$level" release
done
# With the features that other members of the workspace switch on: owned simulations, vectors chosen at run time.
native "kernel with all its features" features release -p softanvil-kernel --all-features
wanted "8 threads" && row "8 threads" check "$out/o3/release/softanvil-golden" --threads 8
RUSTFLAGS='-C no-vectorize-loops -C no-vectorize-slp' native "scalar" scalar release
if [ "$(uname -m)" = x86_64 ]; then
    RUSTFLAGS='-C target-cpu=x86-64' native "SSE2" sse2 release
    for set in 'avx2 v3 AVX2' 'avx512f v4 AVX-512'; do
        read -r flag level name <<<"$set"
        if grep -qw "$flag" /proc/cpuinfo; then
            RUSTFLAGS="-C target-cpu=x86-64-$level" native "$name" "$flag" release
        else
            skip "$name" "the processor does not have it"
        fi
    done
fi

if ! command -v rustup >/dev/null; then
    skip "other targets" "rustup is missing"
else
    static='-C target-feature=+crt-static'
    if [ "$(uname -m)" = x86_64 ]; then
        export CARGO_TARGET_I686_UNKNOWN_LINUX_MUSL_RUSTFLAGS='-C linker=rust-lld -C linker-flavor=ld.lld'
        foreign "x86, 32 bit, SSE2" i686-unknown-linux-musl check ''
        # Without SSE2 the kernel does not build, and says why.
        if wanted "x87 is refused"; then
            rustup target add i586-unknown-linux-gnu >/dev/null 2>&1
            cargo check -q -p softanvil-kernel --target i586-unknown-linux-gnu --target-dir "$out/x87" \
                >"$work/x87.txt" 2>&1
            if grep -q 'x86 without SSE2 is excluded' "$work/x87.txt"; then
                printf '%-44s as it must be\n' "x87 is refused" | tee -a "$table"
            else
                failed=$((failed + 1)); printf 'FAILED: x87 is refused\n'
            fi
        fi
    fi
    export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_MUSL_RUSTFLAGS='-C linker=rust-lld -C linker-flavor=ld.lld'
    if need qemu-aarch64 qemu-user; then
        foreign "aarch64 (qemu-user)" aarch64-unknown-linux-musl 'check --short' '' qemu-aarch64
    else
        skip "aarch64" "qemu-user is missing and cannot be installed"
    fi
    export CARGO_TARGET_RISCV64GC_UNKNOWN_LINUX_GNU_LINKER=riscv64-linux-gnu-gcc
    export CARGO_TARGET_RISCV64GC_UNKNOWN_LINUX_GNU_RUSTFLAGS=$static
    if need qemu-riscv64 qemu-user && need riscv64-linux-gnu-gcc gcc-riscv64-linux-gnu libc6-dev-riscv64-cross; then
        foreign "riscv64 (qemu-user)" riscv64gc-unknown-linux-gnu 'check --short' '' qemu-riscv64
    else
        skip "riscv64" "qemu-user or riscv64-linux-gnu-gcc is missing and cannot be installed"
    fi
    export CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_LINKER=s390x-linux-gnu-gcc
    export CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_RUSTFLAGS=$static
    if need qemu-s390x qemu-user && need s390x-linux-gnu-gcc gcc-s390x-linux-gnu libc6-dev-s390x-cross; then
        foreign "s390x, big-endian (qemu-user)" s390x-unknown-linux-gnu 'check --short' '' qemu-s390x
    else
        skip "s390x, big-endian" "qemu-user or s390x-linux-gnu-gcc is missing and cannot be installed"
    fi
    if need x86_64-w64-mingw32-gcc gcc-mingw-w64-x86-64 && need wine wine wine64; then
        programs=$out/x86_64-pc-windows-gnu/x86_64-pc-windows-gnu/release
        mkdir -p "$programs"
        x86_64-w64-mingw32-gcc -shared -o "$programs/bcryptprimitives.dll" tests/targets/bcryptprimitives.c
        WINEDEBUG=-all WINEPREFIX=$out/wine foreign "Windows (wine)" x86_64-pc-windows-gnu check .exe wine
    else
        skip "Windows" "mingw-w64 or wine is missing and cannot be installed"
    fi
    if need node nodejs; then
        foreign "wasm32 (Node)" wasm32-wasip1 check .wasm node --no-warnings "$root/tests/targets/wasi.mjs"
    else
        skip "wasm32" "node is missing and cannot be installed"
    fi
    if need qemu-system-arm qemu-system-arm; then
        board "Cortex-M7, double-precision FPU (QEMU)" thumbv7em-none-eabihf '-C target-cpu=cortex-m7' 'check --short'
        board "Cortex-M7, without FPU (QEMU)" thumbv7em-none-eabi '' 'check --short yeoh'
    else
        skip "Cortex-M7" "qemu-system-arm is missing and cannot be installed"
    fi
fi

# In single precision, with digests of its own.
runner=softanvil-golden-f32 firmware=tests/firmware/rust/single home=()
LTO=thin UNITS=1 native "f32: $(uname -m), opt-level 3" f32-o3 release
native "f32: $(uname -m), opt-level 0, debug" f32-o0 dev
if [ ${#home[@]} -gt 0 ] && command -v rustup >/dev/null; then
    # The skips of these tools were counted above.
    if command -v qemu-s390x >/dev/null && command -v s390x-linux-gnu-gcc >/dev/null; then
        foreign "f32: s390x, big-endian (qemu-user)" s390x-unknown-linux-gnu 'check --short' '' qemu-s390x
    fi
    if command -v node >/dev/null; then
        foreign "f32: wasm32 (Node)" wasm32-wasip1 check .wasm node --no-warnings "$root/tests/targets/wasi.mjs"
    fi
    if command -v qemu-system-arm >/dev/null; then
        board "f32: Cortex-M7, single-precision FPU (QEMU)" thumbv7em-none-eabihf '' 'check --short'
        board "f32: Cortex-M7, without FPU (QEMU)" thumbv7em-none-eabi '' 'check --short yeoh'
    fi
fi

printf '\n'
cat "$table"
printf '%d targets, %d failed, %d skipped; the table is in %s\n' "$rows" "$failed" "$skipped" "${table#"$root"/}"
[ "$failed" = 0 ] && { [ "${CI:-}" != true ] || [ "$skipped" = 0 ]; }
