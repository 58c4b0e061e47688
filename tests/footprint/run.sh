#!/usr/bin/env bash
# How large the kernel is: code as linked, RAM of the study's mesh, stack, and that there is no heap. Prints the table,
# compares every number with limits.txt and with the table that is kept, docs/footprint.md, from which a number may be a
# tenth away, for another compiler. Needs rustup and readelf; RAM and stack are what the firmware has printed, which is
# run if it was not.
#
#     tests/footprint/run.sh           compares
#     tests/footprint/run.sh write     writes docs/footprint.md
set -euo pipefail
cd "$(dirname "$0")/../.."
here=tests/footprint out=$PWD/target/footprint page=docs/footprint.md
targets=(thumbv7em-none-eabihf riscv32imac-unknown-none-elf x86_64-unknown-linux-gnu)
lld=$(rustc --print sysroot)/lib/rustlib/$(rustc -vV | sed -n 's/^host: //p')/bin/rust-lld
mkdir -p "$out"
failed=0
fail() { failed=1; printf 'FAILED: %s\n' "$1" >&2; }

firmware=target/firmware
grep -q '^the golden solid takes' $firmware/rust.txt 2>/dev/null && [ -s $firmware/c.txt ] || tests/firmware/run.sh >/dev/null

rustup target add "${targets[@]}" >/dev/null 2>&1
export CARGO_TARGET_THUMBV7EM_NONE_EABIHF_RUSTFLAGS='-C target-cpu=cortex-m7'
# libraries LEVEL SUFFIX ARGUMENT...: of each target that the arguments name, in the one folder of all, where what they share
# is compiled once, and keeps copies.
libraries() {
    local level=$1 suffix=$2 argument; shift 2
    CARGO_PROFILE_RELEASE_OPT_LEVEL=$level cargo build -q --release --manifest-path $here/Cargo.toml --target-dir "$out" "$@"
    for argument in "$@"; do
        [[ $argument != --target=* ]] || cp "$out/${argument#*=}/release/libsoftanvil_footprint.a" "$out/${argument#*=}-$level$suffix.a"
    done
}
# The kernel without pads for every target, and with each feature for one.
for level in s 3; do
    libraries $level '' "${targets[@]/#/--target=}" --no-default-features
    libraries $level -pads --target="${targets[0]}"
    libraries $level -solid --target="${targets[0]}" --no-default-features --features solid
done

# link ELF ARGUMENT...: what the linker keeps of a library for the functions asked for. What the C library gives on hosts
# may stay open.
link() {
    local elf=$1; shift
    "$lld" -flavor gnu --gc-sections --unresolved-symbols=ignore-all "$@" -o "$elf"
}

# sections ELF FLAG: bytes of the sections in memory that have the flag W of variables, or do not have it. What unwinding
# and loading need is left out.
sections() {
    local name type size flags sum=0
    while read -r name type size flags; do
        case $name in .eh_frame | .gcc_except_table | .ARM.exidx | .relro_padding | .got) continue ;; esac
        case $flags in *A*) ;; *) continue ;; esac
        # Pointers that are constants once they are loaded.
        [ "$name" != .data.rel.ro ] || flags=A
        case $2:$flags in W:*W* | R:*[!W]*) [[ $2 = R && $flags = *W* ]] || sum=$((sum + 16#$size)) ;; esac
    done < <(readelf -SW "$1" | sed -n 's/^ *\[ *[0-9]*\] *//p' | awk '$1 ~ /^\./ { print $1, $2, $5, $7 }')
    echo "$sum"
}

measured=$out/measured.txt
{
    for target in "${targets[@]}"; do
        for level in s 3; do
            name=${target%%-*} && name=${name/x86_64/x86-64}-$level
            elf=$out/$name.elf
            link "$elf" -e simulate -u prepare "$out/$target-$level.a"
            echo "$name $(sections "$elf" R)"
        done
    done
    for feature in pads solid; do
        for level in s 3; do
            name=thumbv7em-$level-$feature
            link "$out/$name.elf" -e simulate -u prepare "$out/${targets[0]}-$level-$feature.a"
            echo "$name $(sections "$out/$name.elf" R)"
        done
    done
    library=$firmware/thumbv7em-none-eabihf/library/libsoftanvil.a
    for source in include/softanvil.h tests/firmware/c/drop.c; do
        name=c-abi-thumbv7em && [ $source = include/softanvil.h ] || name+=-used
        mapfile -t wanted < <(grep -oE '\bsoftanvil_[a-z_]+\(' $source | tr -d '(' | sort -u | sed 's/^/--undefined=/')
        link "$out/$name.elf" -e softanvil_init "${wanted[@]}" "$library"
        echo "$name $(sections "$out/$name.elf" R)"
    done
    echo "static-ram $(sections "$out/thumbv7em-3.elf" W)"
    sed -n 's/^\([0-9]*\) triangles take \([0-9]*\) bytes, \([0-9]*\) nodes \([0-9]*\) bytes, a snapshot \([0-9]*\) bytes$/\1 \2 \3 \4 \5/p' \
        $firmware/rust.txt | {
        read -r triangles triangle_bytes nodes node_bytes snapshot
        echo "ram-per-triangle $((triangle_bytes / triangles))"
        echo "ram-per-node $((node_bytes / nodes))"
        echo "ram-study $((triangle_bytes + node_bytes))"
        echo "snapshot $snapshot"
    }
    sed -n 's/^a padded drop takes \([0-9]*\) bytes$/ram-pads \1/p; s/^the golden solid takes \([0-9]*\) bytes$/ram-solid \1/p' \
        $firmware/rust.txt
    sed -n 's/^instructions per step \([0-9]*\), from [0-9]* to \([0-9]*\)$/instructions-mean \1\ninstructions-most \2/p' $firmware/rust.txt
    echo "stack $(sed -n 's/^stack \([0-9]*\) bytes.*/\1/p' $firmware/rust.txt $firmware/c.txt | sort -n | tail -1)"
} >"$measured"

# No heap: on a board, where no C library is linked, nothing is missing and nothing allocates.
for elf in thumbv7em-3 thumbv7em-s-pads thumbv7em-3-pads thumbv7em-3-solid riscv32imac-3 c-abi-thumbv7em; do
    readelf -sW "$out/$elf.elf" >"$out/symbols.txt"
    ! awk '$7 == "UND" && $8 != ""' "$out/symbols.txt" | grep . || fail "$elf needs what is not in the library"
    ! grep -E '__rust_alloc|__rg_alloc|[^a-z](m|c|re)alloc$|sbrk' "$out/symbols.txt" || fail "$elf allocates"
done

describe() {
    case $1 in
        c-abi-thumbv7em) echo "C ABI on a Cortex-M7, every function, opt-level 3" ;;
        c-abi-thumbv7em-used) echo "C ABI on a Cortex-M7, what \`tests/firmware/c\` calls" ;;
        thumbv7em-s-pads) echo "kernel with pads on a Cortex-M7, opt-level s" ;;
        thumbv7em-3-pads) echo "kernel with pads on a Cortex-M7, opt-level 3" ;;
        thumbv7em-?-solid) set -- "${1%-solid}" && echo "kernel with the solid on a Cortex-M7, opt-level ${1##*-}" ;;
        thumbv7em-*) echo "kernel on a Cortex-M7 with its FPU, opt-level ${1##*-}" ;;
        riscv32imac-*) echo "kernel on riscv32 without an FPU, opt-level ${1##*-}" ;;
        x86-64-*) echo "kernel on x86-64, opt-level ${1##*-}" ;;
        static-ram) echo "variables of the kernel" ;;
        ram-per-triangle) echo "RAM per triangle, model and state" ;;
        ram-per-node) echo "RAM per node, model and state" ;;
        ram-pads) echo "RAM of the preset \`rugby-soft-anvil\`, model and state" ;;
        ram-solid) echo "RAM of the golden solid, model and state" ;;
        ram-study) echo "RAM of the study's mesh, model and state" ;;
        snapshot) echo "snapshot of the study's state" ;;
        instructions-mean) echo "instructions of a step of the study's drop, Cortex-M7, mean" ;;
        instructions-most) echo "instructions of a step of the study's drop, Cortex-M7, most" ;;
        stack) echo "most stack, set-up and steps, Cortex-M7" ;;
    esac
}

table=$out/footprint.md
cat >"$table" <<'END'
# Footprint

Code is what the linker keeps of the kernel for a whole life of a simulation (`tests/footprint/src/lib.rs`), or of the C
ABI: instructions and constants. The kernel is that without its features `pads` and `solid` unless a row says otherwise; the C ABI has `pads`. RAM is that of the study's mesh, or of what a row names, as the firmware for the Cortex-M7 prints it
(`tests/firmware`); its nodes and triangles include the padding of rows to whole vectors. There is no heap: linked for a
board, nothing allocates and no symbol is missing. `tests/footprint/run.sh write` writes this page; without `write` it
compares with it and with the limits, whose reasons stand in `tests/footprint/limits.txt`.

| what | bytes, or instructions | limit |
|---|---:|---:|
END
while read -r name bytes; do
    limit=$(awk -v name="$name" '$1 == name { print $2 }' $here/limits.txt)
    what=$(describe "$name")
    [ -n "$limit" ] && [ -n "$what" ] || { fail "$name has no limit or no description"; continue; }
    [ -n "$bytes" ] && [ "$bytes" -le "$limit" ] || fail "$what: $bytes bytes, the limit is $limit"
    printf '| %s | %s | %s |\n' "$what" "$bytes" "$limit" >>"$table"
    [ "${1:-}" != write ] || continue
    kept=$(awk -F ' [|] ' -v what="| $what" '$1 == what { print $2 }' $page)
    [ -n "$kept" ] && [ $((10 * (bytes > kept ? bytes - kept : kept - bytes))) -le "$kept" ] ||
        fail "$what: $bytes bytes, $page has ${kept:-nothing}; \`tests/footprint/run.sh write\` renews it"
done <"$measured"
[ "$(wc -l <"$measured")" = "$(grep -c '^[^#]' $here/limits.txt)" ] || fail "a limit is of nothing that was measured"
sed -n '/^|/p' "$table"
[ "${1:-}" != write ] || cp "$table" $page
exit $failed
