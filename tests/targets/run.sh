#!/usr/bin/env bash
# Builds the golden traces' runner (tests/golden) for every kind of target, runs the scenes there, carries a snapshot
# there and back, and prints the digests as a table: all must be equal. The rows are made side by side, as many as there
# are processors. Installs what it needs if it may; what it cannot have is skipped by name (with CI=true a skip is a
# failure), what this processor cannot run is not applicable (never a failure).
#
#     tests/targets/run.sh [WORD]    only rows whose name contains WORD
set -uo pipefail
cd "$(dirname "$0")/../.."
root=$PWD out=$PWD/target/targets only=${1:-}
table=$out/table.txt rows=$out/rows host=$(rustc -vV | sed -n 's/^host: //p')
. tests/need.sh
. tests/processor.sh
vectors=
rm -rf "$rows" && mkdir -p "$rows"
{ rustc --version && echo; } >"$table"
printf '%-44s %-6s  %-16s  %-16s  %s\n' target scenes 'until 2.5 ms' 'whole scenes' 'snapshot there and back' >>"$table"

# The scene whose snapshots travel, and the records (0.25 ms each) at which they are saved.
scene=yeoh leave=6 return=8
count=0 home=()

wanted() { [[ $1 == *"$only"* ]]; }

# Each row has a folder to work in, whose name keeps the order, and leaves its line there, in a file that says how it ended.
next_row() { count=$((count + 1)); work=$rows/$(printf %02d $count); mkdir "$work"; }
line() { printf '%s\n' "$2" | tee "$work/$1"; }
# not_run FILE KIND NAME REASON
not_run() { next_row; printf '%-44s %s: %s\n' "$3" "${2,,}" "$4" >"$work/$1"; hand_up "${@:2}"; }
skip() { not_run skipped SKIPPED "$@"; }
not_applicable() { not_run not_applicable 'NOT APPLICABLE' "$@"; }
fail() { line failed "$(printf '%-44s FAILED: %s' "$1" "$2")"; }

# beside COMMAND...: makes a row while others are made, and notes the seconds of processors that it took.
processors=$(nproc)
beside() {
    while [ "$(jobs -rp | wc -l)" -ge "$processors" ]; do wait -n; done
    next_row
    {
        "$@"
        # In a shell of its own, as behind a pipe, it would have spent nothing.
        times >"$work/times"
        awk -F '[ms ]+' 'END { printf "%5d s  ", 60 * ($1 + $3) + $2 + $4 }' "$work/times" >"$work/seconds"
    } &
}

# The runner, and the folder of its firmware; at the end those in single precision take their place.
runner=softanvil-golden firmware=tests/firmware/rust

# compiled KEPT BUILT CARGO_ARGUMENT...: builds in a folder of many rows, so that what several take is compiled once, and keeps
# of it the program KEPT, a copy of BUILT there, which the next row replaces. So there is one build at a time in a folder.
built_in=$out/cargo
compiled() {
    local kept=$1 built=$2; shift 2
    mkdir -p "${kept%/*}" "$built_in"
    (flock 9 && cargo build -q --target-dir "$built_in" "$@" && cp "$built_in/$built" "$kept") 9>"$built_in/lock"
}

# build NAME PROFILE TARGET EXTENSION CARGO_ARGUMENT...: the runner. The target is named even if it is this machine's, because
# flags for the compiler then are not those of procedural macros, which all rows share.
build() {
    local name=$1 profile=$2 target=$3 extension=$4; shift 4
    # What changes no bits is set to build fast.
    CARGO_PROFILE_DEV_DEBUG=0 CARGO_INCREMENTAL=0 \
        compiled "$out/$name/$runner$extension" "$target/${profile/dev/debug}/$runner$extension" -p "$runner" \
        --profile "$profile" --target "$target" "$@"
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

# at_home: what the first row's program, home, answers to the words of each check.
declare -A expected
at_home() {
    local check
    next_row
    for check in check 'check --short' 'check --short yeoh'; do expected[$check]=$(summary "$check" "${home[@]}"); done
}

# row NAME CHECK COMMAND...: a line of the table; CHECK is the words of the check.
row() {
    local name=$1 check=$2 verdict=same carried=same found scenes until_short until_end text; shift 2
    found=$(summary "$check" "$@") && [ -n "$found" ] && [ "$found" = "${expected[$check]}" ] || verdict=DIFFERENT
    snapshots "$@" || carried=DIFFERENT
    read -r scenes until_short until_end <<<"$found"
    printf -v text '%-44s %-6s  %-16s  %-16s  %s' "$name" "${scenes:--}" "${until_short:--}" "${until_end:--}" "$carried"
    if [ "$verdict $carried" = "same same" ]; then
        line same "$text"
    else
        line failed "$text"
        printf 'FAILED: %s; expected %s\n' "$name" "${expected[$check]}"
        grep -ahv '^summary\|same$' "$work/row.txt" "$work/errors.txt" "$work/snapshots.txt" | head -20
    fi
}

# native NAME FOLDER PROFILE CARGO_ARGUMENT...: a row of this machine.
native() {
    wanted "$1" && beside make_native "$@"
}
make_native() {
    local name=$1 folder=$2 profile=$3; shift 3
    build "$folder" "$profile" "$host" '' "$@" || { fail "$name" "does not build"; return; }
    row "$name" check "$out/$folder/$runner"
}

# have_target NAME TARGET: whether rustup has the target of a row.
have_target() {
    timeout 120 rustup target add "$2" >/dev/null 2>&1 || { skip "$1" "rustup has no $2"; false; }
}

# foreign NAME TARGET CHECK EXTENSION COMMAND...: a row of another target, by a command that runs its programs. With a name
# of an instruction set in $vectors the program has every set of the target, and is made to choose that one; with `any` it
# chooses itself.
foreign() {
    wanted "$1" && have_target "$1" "$2" && beside make_foreign "$@"
}
make_foreign() {
    local name=$1 target=$2 check=$3 extension=$4 folder=$2${vectors:+-$vectors} chosen=(); shift 4
    build "$folder" release "$target" "$extension" ${vectors:+--features $features} ||
        { fail "$name" "does not build"; return; }
    [ "${vectors:-any}" = any ] || chosen=(--instructions "$vectors")
    row "$name" "$check" "$@" "$out/$folder/$runner$extension" "${chosen[@]}"
}

# board NAME TARGET FLAGS CHECK: a row of a Cortex-M7 without an operating system; built where tests/firmware builds, which has
# compiled the kernel of a board with an FPU.
on_board() {
    local elf=$1 configuration=enable=on,target=native,arg=runner word; shift
    for word in "$@"; do configuration+=,arg=$word; done
    qemu-system-arm -M mps2-an500 -display none -monitor none -serial none -semihosting-config "$configuration" \
        -kernel "$elf"
}
export -f on_board
board() {
    wanted "$1" && have_target "$1" "$2" && beside make_board "$@"
}
make_board() {
    local name=$1 target=$2 flags=$3 check=$4 elf=$out/$2/$runner.elf
    (cd "$firmware" && RUSTFLAGS=$flags built_in=$root/target/firmware compiled "$elf" "$target/release/runner" --release --bin runner --target "$target") ||
        { fail "$name" "does not build"; return; }
    row "$name" "$check" bash -c 'on_board "$@"' board "$elf"
}

# released NAME FOLDER ARGUMENT...: the program with the features that other members of the workspace switch on: owned simulations,
# vectors chosen at run time. It is built where a release is, which has compiled its kernel.
released() {
    local name=$1 program=$out/$2/$runner; shift 2
    built_in=$root/target compiled "$program" "release/$runner" --release --workspace --bin "$runner" ||
        { fail "$name" "does not build"; return; }
    row "$name" check "$program" "$@"
}

# refused: without SSE2 the kernel does not build, and says why; also without what it depends on, which is not built for that.
refused() {
    rustup target add i586-unknown-linux-gnu >/dev/null 2>&1
    rustc --edition 2024 --crate-type lib --emit metadata --out-dir "$work" --target i586-unknown-linux-gnu kernel/src/lib.rs \
        >"$work/x87.txt" 2>&1
    if grep -q 'x86 without SSE2 is excluded' "$work/x87.txt"; then
        line same "$(printf '%-44s as it must be' "$1")"
    else
        fail "$1" "it builds, or for another reason not"
    fi
}

# The first row is what the others are compared with, so it is always there: built as the library is, and where install.sh builds that,
# so that what both take is compiled once.
library=$root/target/install/cargo
cargo build -q --profile library --target-dir "$library" -p softanvil-golden -p softanvil-golden-f32 || exit 1
home=("$library/library/$runner")
at_home
row "$(uname -m), opt-level 3" check "${home[@]}"
native "$(uname -m), opt-level 0, debug" o0 dev
for level in 2 s; do
    CARGO_PROFILE_RELEASE_OPT_LEVEL=$level native "$(uname -m), opt-level $level" "o$level" release
done
name="features as in the workspace"
wanted "$name" && beside released "$name" features
wanted "8 threads" && beside row "8 threads" check "${home[@]}" --threads 8
RUSTFLAGS='-C no-vectorize-loops -C no-vectorize-slp' native "scalar" scalar release
# Instruction sets: the compiler may use one anywhere, or the program with all of them is made to choose it. The first row is of the
# baseline already.
for set in 'SSE2 x86-64 baseline' 'AVX2 x86-64-v3 avx2' 'AVX-512 x86-64-v4 avx512'; do
    read -r name level word <<<"$set"
    [ "$word" != baseline ] && wanted "$name" && runs "$name" "$level" &&
        RUSTFLAGS="-C target-cpu=$level" native "$name" "$level" release
    name="chosen at run time, $name"
    wanted "$name" && runs "$name" "$level" && beside released "$name" "chosen-$word" --instructions "$word"
done

# Compilers that are installed beside this one.
compilers=$(rustc --version)
for toolchain in $(rustup toolchain list 2>/dev/null | awk '{ print $1 }'); do
    version=$(rustc "+$toolchain" --version | cut -d' ' -f1-2)
    [[ $compilers != *"$version"* ]] || continue
    compilers+=" $version"
    RUSTUP_TOOLCHAIN=$toolchain native "$version" "compiler-$toolchain" release
done

if ! command -v rustup >/dev/null; then
    skip "other targets" "rustup is missing"
else
    static='-C target-feature=+crt-static'
    if [ "$(uname -m)" = x86_64 ]; then
        export CARGO_TARGET_I686_UNKNOWN_LINUX_MUSL_RUSTFLAGS='-C linker=rust-lld -C linker-flavor=ld.lld'
        foreign "x86, 32 bit, SSE2" i686-unknown-linux-musl check ''
        wanted "x87 is refused" && beside refused "x87 is refused"
    else
        not_applicable "x86, 32 bit, SSE2" "the processor is no x86-64"
    fi
    # These and that of Windows have all instruction sets, and are compiled as the libraries that tests/fmi/matrix.py builds here, which
    # then find the kernel.
    features=softanvil-kernel/alloc,softanvil-kernel/dispatch
    export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
    if need qemu-aarch64 qemu-user && need aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu libc6-dev-arm64-cross; then
        for word in NEON:neon scalar:baseline; do
            vectors=${word#*:} foreign "aarch64, ${word%:*} (qemu-user)" aarch64-unknown-linux-gnu 'check --short' '' \
                qemu-aarch64 -L /usr/aarch64-linux-gnu
        done
    else
        skip "aarch64" "qemu-user or aarch64-linux-gnu-gcc is missing and cannot be installed"
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
        programs=$out/x86_64-pc-windows-gnu-any
        mkdir -p "$programs"
        x86_64-w64-mingw32-gcc -shared -o "$programs/bcryptprimitives.dll" tests/targets/bcryptprimitives.c
        WINEDEBUG=-all WINEPREFIX=$out/wine vectors=any foreign "Windows (wine)" x86_64-pc-windows-gnu check .exe wine
    else
        skip "Windows" "mingw-w64 or wine is missing and cannot be installed"
    fi
    if need node nodejs; then
        foreign "wasm32 (Node)" wasm32-wasip1 check .wasm node --no-warnings "$root/tests/targets/wasi.mjs"
        RUSTFLAGS='-C target-feature=+simd128' vectors=simd128 \
            foreign "wasm32, simd128 (Node)" wasm32-wasip1 check .wasm node --no-warnings "$root/tests/targets/wasi.mjs"
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
runner=softanvil-golden-f32 firmware=tests/firmware/rust/single
if wanted "f32: " || [[ $only == f32* ]]; then
    home=("$library/library/$runner")
    at_home
    row "f32: $(uname -m), opt-level 3" check "${home[@]}"
    native "f32: $(uname -m), opt-level 0, debug" f32-o0 dev
    # The skips of these tools were counted above.
    if command -v rustup >/dev/null; then
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
fi

wait
verdict() { find "$rows" -name "$1" | wc -l; }
for row in "$rows"/*/; do cat "$row"/{same,failed,skipped,not_applicable} 2>/dev/null; done >>"$table"
printf '\nseconds of processors:\n'
for row in "$rows"/*/; do [ ! -f "$row/seconds" ] || cat "$row"/{seconds,same} 2>/dev/null | cut -c1-54; done | sort -rn
printf '\n'
cat "$table"
printf '%d rows, %d failed, %d skipped, %d not applicable; the table is in %s\n' "$count" "$(verdict failed)" \
    "$(verdict skipped)" "$(verdict not_applicable)" "${table#"$root"/}"
[ "$(verdict failed)" = 0 ] &&
    [ "$(($(verdict same) + $(verdict skipped) + $(verdict not_applicable)))" = "$count" ] &&
    { [ "${CI:-}" != true ] || [ "$(verdict skipped)" = 0 ]; }
