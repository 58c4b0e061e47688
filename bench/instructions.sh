#!/usr/bin/env bash
# Instructions of a step of the study's drop, counted by callgrind, against their limits in instructions.csv:
# instructions.sh BUILD_FOLDER, where cargo put the program `softanvil-bench`, in the tests that of a release. Every step of the drop is counted: the mean
# by the number of triangles, and the dearest step over the cheapest. SOFTANVIL_BLESS=1 writes new limits, a margin above
# what is counted, which other versions of the compiler need.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(cd "${1:?usage: instructions.sh BUILD_FOLDER}" && pwd)/softanvil-bench
. "$here/../tests/processor.sh"

not_applicable() { hand_up 'NOT APPLICABLE' "$@"; }
skip() { hand_up FAILED "$@"; exit 1; }

runs "instructions of a step" x86-64 || exit 0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# count SET: triangles, steps, instructions per triangle and step, dearest step over cheapest.
count() {
    local drop
    drop=$(valgrind --tool=callgrind --callgrind-out-file="$work/$1" --dump-line=no --toggle-collect=measured_step \
        --dump-after=measured_step "$program" "$1" 2>"$work/log") || { cat "$work/log" >&2; return 1; }
    # One file a step. By find, as there are too many for a command line.
    find "$work" -name "$1.*" -exec grep -h '^summary: ' {} + | awk -v drop="$drop" '
        $2 > 0 { n++; sum += $2; if (n == 1 || $2 < least) least = $2; if ($2 > most) most = $2 }
        END {
            split(drop, told, " ")
            if (n != told[2]) { print n " steps counted of " told[2] >"/dev/stderr"; exit 1 }
            printf "%d %d %.1f %.3f\n", told[1], n, sum / n / told[1], most / least
        }'
}

counted=$work/counted.csv
echo "instruction set,instructions per triangle and step,dearest step over cheapest" >"$counted"
for row in 'Baseline x86-64' 'Avx2 x86-64-v3'; do
    read -r set level <<<"$row"
    runs "instructions of a step, $set" "$level" || continue
    figures=$(count "$set")
    read -r triangles steps update ratio <<<"$figures"
    printf '%s: %s instructions per triangle and step, dearest step %s times the cheapest (%s triangles, %s steps)\n' \
        "$set" "$update" "$ratio" "$triangles" "$steps"
    echo "$set,$update,$ratio" >>"$counted"
done
if [ -n "${SOFTANVIL_INSTRUCTIONS:-}" ]; then cp "$counted" "$SOFTANVIL_INSTRUCTIONS"; fi
if [ "${SOFTANVIL_BLESS:-}" = 1 ]; then
    awk -F, 'BEGIN { OFS = "," } NR > 1 { $2 = sprintf("%.0f", 1.03 * $2); $3 = sprintf("%.2f", $3 + 0.01) } 1' \
        "$counted" >"$here/instructions.csv"
fi
awk -F, '
    NR == FNR { update[$1] = $2; ratio[$1] = $3; next }
    FNR > 1 && ($2 > update[$1] || $3 > ratio[$1]) {
        printf "%s: above the limit of %s instructions or of a ratio of %s\n", $1, update[$1], ratio[$1]; bad = 1
    }
    END { exit bad }' "$here/instructions.csv" "$counted" >&2
