#!/usr/bin/env bash
# The long run: fuzzing, random drops, checkers of memory, for as long as is asked for (run.sh --help; docs/reliability.md).
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/need.sh
need python3 python3 || { echo "python3 is missing and cannot be installed" >&2; exit 1; }
# run.py skips by name what is missing then.
need g++ g++ && need valgrind valgrind libc6-dbg || echo "g++ or valgrind is missing and cannot be installed" >&2
exec python3 tests/endurance/run.py "$@"
