#!/usr/bin/env bash
# What a processor lacks is not applicable, never a failure, and what nothing is known of is: with the flags of made-up
# processors, first the decision alone (tests/processor.sh), then the scripts that take it, as CI runs them.
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/processor.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# same NAME EXPECTED FOUND
same() {
    [ "$2" = "$3" ] && echo "ok      $1" && return
    printf 'FAILED  %s: "%s" expected, "%s" found\n' "$@"
    failed=1
}

oldest='fpu sse sse2 fxsr lm'
second="$oldest pni ssse3 cx16 sse4_1 sse4_2 popcnt lahf_lm"
avx="$second avx f16c xsave"
avx2="$avx abm avx2 bmi1 bmi2 fma movbe"
avx512="$avx2 avx512f avx512bw avx512cd avx512dq avx512vl"

# decided NAME FLAGS LEVEL EXPECTED
# shellcheck disable=SC2086
decided() { same "$1, $3" "$4" "$(lacking "$3" $2)"; }
decided "oldest" "$oldest" x86-64 ''
decided "oldest" "$oldest" x86-64-v2 'cx16 lahf_lm pni popcnt sse4_1 sse4_2 ssse3'
decided "no AVX2" "$avx" x86-64-v2 ''
decided "no AVX2" "$avx" x86-64-v3 'abm avx2 bmi1 bmi2 fma movbe'
decided "no AVX-512" "$avx2" x86-64-v3 ''
decided "no AVX-512" "$avx2" x86-64-v4 'avx512f avx512bw avx512cd avx512dq avx512vl'
decided "first AVX-512" "$avx2 avx512f avx512cd avx512er avx512pf" x86-64-v4 'avx512bw avx512dq avx512vl'
decided "AVX2 without FMA" "${avx512/ fma/}" x86-64-v3 'fma'
decided "flags that contain others" "${avx512/avx512vl/avx512vlx}" x86-64-v4 'avx512vl'
decided "everything" "$avx512" x86-64-v4 ''

# called FLAGS COMMAND...: what the command leaves out, as CI runs it on this processor, one name a line, and whether it fails.
called() {
    local flags=$1; shift
    printf 'processor\t: 0\nflags\t\t: %s\nbugs\t\t: avx512f\n' "$flags" >"$work/cpuinfo"
    [ -n "$flags" ] || rm "$work/cpuinfo"
    : >"$work/not-run"
    if CI=true SOFTANVIL_CPUINFO=$work/cpuinfo SOFTANVIL_NOT_RUN=$work/not-run "$@" >"$work/output" 2>&1; then
        echo passes
    else
        echo fails
    fi
    sed 's/ (.*//' "$work/not-run"
}

# count: what the table that the targets have just printed ends with.
count() { sed -n '$s/;.*//p' "$work/output"; }

if [ "$(uname -m)" = x86_64 ]; then
    targets=tests/targets/run.sh
    narrow=$'\nNOT APPLICABLE: AVX2\nNOT APPLICABLE: chosen at run time, AVX2'
    wide=$'\nNOT APPLICABLE: AVX-512\nNOT APPLICABLE: chosen at run time, AVX-512'
    same "targets, no AVX2" "passes$narrow$wide" "$(called "$avx" $targets AVX)"
    same "its count" '5 rows, 0 failed, 0 skipped, 4 not applicable' "$(count)"
    same "targets, no AVX-512" "passes$wide" "$(called "$avx2" $targets AVX-512)"
    same "its count" '3 rows, 0 failed, 0 skipped, 2 not applicable' "$(count)"
    same "targets, first AVX-512" "passes$wide" "$(called "$avx2 avx512f avx512cd" $targets AVX-512)"
    same "targets, nothing known" $'fails\nSKIPPED: AVX-512\nSKIPPED: chosen at run time, AVX-512' \
        "$(called '' $targets AVX-512)"
    same "its count" '3 rows, 0 failed, 2 skipped, 0 not applicable' "$(count)"
fi
exit $failed
