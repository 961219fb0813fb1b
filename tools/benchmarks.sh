#!/usr/bin/env bash
# tools/benchmarks.sh [--quick]: runs every benchmark and writes docs/benchmarks.md and its plots from what they measured.
# Without arguments it takes some minutes; run it on a machine that does nothing else.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools/build.sh release enfilade
mkdir -p out/bench
build/release/tools/enfilade bench all "$@" --json out/bench/all.json
/usr/bin/python3 tools/plot_growth.py out/bench/all.json docs/growth.svg
/usr/bin/python3 tools/plot_dial.py out/bench/all.json docs/dial.svg
/usr/bin/python3 tools/plot_convexify.py out/bench/all.json docs/convexify.svg
/usr/bin/python3 tools/plot_octree.py out/bench/all.json docs/octree.svg
/usr/bin/python3 tools/plot_lights.py out/bench/all.json docs/lights.svg
/usr/bin/python3 tools/benchmarks_page.py out/bench/all.json "tools/benchmarks.sh${*:+ $*}" >docs/benchmarks.md
echo "docs/benchmarks.md is written."
