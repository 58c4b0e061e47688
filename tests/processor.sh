# shellcheck shell=bash
# For scripts to read in: what this processor can run. What it cannot is not applicable here, which is no failure; what
# could be installed and is not is skipped, which is one with CI=true.

# Levels of x86-64, and the flags of a processor, as Linux calls them, that their programs need.
declare -A flags_of=([x86-64]='sse2' [x86-64-v2]='cx16 lahf_lm pni popcnt sse4_1 sse4_2 ssse3')
flags_of[x86-64-v3]="${flags_of[x86-64-v2]} abm avx avx2 bmi1 bmi2 f16c fma movbe xsave"
flags_of[x86-64-v4]="${flags_of[x86-64-v3]} avx512f avx512bw avx512cd avx512dq avx512vl"

# lacking LEVEL FLAG...: the flags that programs for this level need and that are not among those given.
lacking() {
    local flag needed=${flags_of[$1]} missing=(); shift
    for flag in $needed; do [[ " $* " == *" $flag "* ]] || missing+=("$flag"); done
    printf '%s' "${missing[*]}"
}

# processor_flags: those of this processor, or of the one that the file in SOFTANVIL_CPUINFO tells of (for tests).
processor_flags() {
    local flags
    flags=$(sed -n 's/^flags[[:space:]]*: //p' "${SOFTANVIL_CPUINFO:-/proc/cpuinfo}" 2>/dev/null | head -n 1)
    [ -n "$flags" ] && printf '%s' "$flags"
}

# runs NAME LEVEL: whether this processor runs programs for this level. If not, or if nothing tells, says so of NAME by the
# caller's not_applicable or skip.
runs() {
    local flags missing
    [ "$(uname -m)" = x86_64 ] || { not_applicable "$1" "the processor is no x86-64"; return 1; }
    flags=$(processor_flags) || { skip "$1" "the flags of the processor cannot be read"; return 1; }
    # shellcheck disable=SC2086
    missing=$(lacking "$2" $flags)
    [ -z "$missing" ] || { not_applicable "$1" "the processor lacks $missing"; return 1; }
}

# hand_up KIND NAME REASON: says what is not run, also to test.sh if that has called.
hand_up() {
    printf '%s: %s (%s)\n' "$@" >&2
    [ -z "${SOFTANVIL_NOT_RUN:-}" ] || printf '%s: %s (%s)\n' "$@" >>"$SOFTANVIL_NOT_RUN"
}
