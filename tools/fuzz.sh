#!/usr/bin/env bash
# tools/fuzz.sh [SECONDS [SEED]]: builds the fuzz targets with clang and runs them, the seconds shared evenly (60). With
# one seed (1) the same inputs are tried each time, so that a change passes or fails by itself; 0 tries new ones.
# New inputs stay in build/fuzz/corpus; the kept ones are in tests/fuzz/corpus.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=${1:-60}
seed=${2:-1}
tools/build.sh fuzz fuzz_targets

mapfile -t targets < <(find build/fuzz/tests -type f -executable -name '*_fuzz' | sort)
[ ${#targets[@]} -gt 0 ] || { echo "No fuzz target was built." >&2; exit 1; }
share=$((seconds / ${#targets[@]}))
[ "$share" -ge 1 ] || share=1
for target in "${targets[@]}"; do
    name=$(basename "$target")
    corpus=build/fuzz/corpus/$name
    kept=tests/fuzz/corpus/$name
    mkdir -p "$corpus"
    # Inputs too large to keep in the tree are made by a program beside the target.
    [ ! -x "${target}_corpus" ] || "${target}_corpus" "$corpus"
    folders=("$corpus")
    [ ! -d "$kept" ] || folders+=("$kept")
    log=build/fuzz/$name.log
    if ! "$target" -seed="$seed" -max_total_time="$share" -rss_limit_mb=4096 -timeout=10 -print_final_stats=1 \
        -artifact_prefix="build/fuzz/$name-" "${folders[@]}" >"$log" 2>&1; then
        tail -n 60 "$log" >&2
        echo "$name found an input that the reader does not survive: it is named above." >&2
        exit 1
    fi
    echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs in $share s, no crash"
done
