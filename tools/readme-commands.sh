#!/usr/bin/env bash
# Runs the commands that README.md shows (its ```sh blocks, in order, in one folder), so that it keeps telling the truth.
# tools/test.sh is left out: whoever checks the README runs it anyway.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mapfile -t commands < <(awk '/^```sh$/ {inside = 1; next} /^```/ {inside = 0} inside' README.md | grep -vE '^(#|$|git clone|cd |tools/test\.sh)')
[ ${#commands[@]} -gt 0 ] || { echo "README.md shows no command." >&2; exit 1; }
for command in "${commands[@]}"; do
    echo "README: $command"
    bash -euo pipefail -c "$command"
done
