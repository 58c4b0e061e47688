#!/usr/bin/env bash
# What a host of the repository reads is as it asks (.github, CITATION.cff), by the schemas of check-jsonschema; and what the workflows
# call is there. host.sh VENV, with the packages of tests/fmi/requirements.txt.
set -euo pipefail
venv=$(cd "${1:?usage: host.sh VENV}" && pwd)
cd "$(dirname "$0")/.."
check() { "$venv/bin/check-jsonschema" --quiet --builtin-schema "vendor.$1" "${@:2}"; }
check github-workflows .github/workflows/*.yml
check github-issue-config .github/ISSUE_TEMPLATE/config.yml
check github-issue-forms .github/ISSUE_TEMPLATE/d*.yml
check citation-file-format CITATION.cff
grep -hoE '(^| )(\./|python/|packaging/)[a-z./]+\.sh' .github/workflows/*.yml | while read -r script; do
    [ -x "$script" ] || { echo "$script of a workflow is not there" >&2; exit 1; }
done
