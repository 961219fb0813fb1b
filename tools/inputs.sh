#!/usr/bin/env bash
# tools/inputs.sh [FOLDER]: writes docs/inputs.md, the tables of what becomes of each real plan (../shared/data).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools/build.sh release enfilade
mkdir -p out
/usr/bin/python3 tools/inputs_table.py build/release/tools/enfilade "${1:-../shared/data}" >out/inputs.md
mv out/inputs.md docs/inputs.md
echo "docs/inputs.md is written."
