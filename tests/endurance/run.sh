#!/usr/bin/env bash
# The long run: fuzzing, random drops, checkers of memory, for as long as is asked for (run.sh --help; docs/reliability.md).
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/need.sh
need python3 python3 || { echo "python3 is missing and cannot be installed" >&2; exit 1; }
# What is still missing then is skipped by name.
need g++ g++ || true
need valgrind valgrind libc6-dbg || true
exec python3 tests/endurance/run.py "$@"
