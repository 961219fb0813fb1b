#!/usr/bin/env bash
# Runs the commands that README.md shows (its ```sh blocks, in order, in one shell), so that it keeps telling the truth.
# Cloning is left out, and so is tools/test.sh: whoever checks the README runs it anyway.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
commands=$(awk '/^```sh$/ {inside = 1; next} /^```/ {inside = 0} inside' README.md | grep -vE '^(git clone|cd |tools/test\.sh)')
[ -n "$commands" ] || { echo "README.md shows no command." >&2; exit 1; }
bash -euxo pipefail -c "$commands" </dev/null
