#!/usr/bin/env bash
# tools/build.sh PRESET [TARGET...]: configures build/PRESET and builds it with as many jobs as cores and memory allow.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=${1:?which preset of CMakePresets.json?}
shift

# A CGAL translation unit takes up to 1.7 GB: two gigabytes a job.
cores=$(nproc)
free_kib=$(awk '$1 == "MemAvailable:" {print $2}' /proc/meminfo)
jobs=$((free_kib / (2 * 1024 * 1024)))
[ "$jobs" -le "$cores" ] || jobs=$cores
[ "$jobs" -ge 1 ] || jobs=1

targets=()
for target in "$@"; do targets+=(--target "$target"); done
cmake --preset "$preset"
cmake --build "build/$preset" -j "$jobs" "${targets[@]}"
