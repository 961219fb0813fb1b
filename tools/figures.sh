#!/usr/bin/env bash
# tools/figures.sh [BUILD]: draws docs/cuts.svg and docs/cuts.png anew, one room cut in every way that there is, with the
# cutters as they are now. BUILD: a build folder (build/release).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/release}
[ -f "$build/build.ninja" ] || { echo "There is no build in $build: tools/build.sh release" >&2; exit 2; }
command -v rsvg-convert >/dev/null || { echo "rsvg-convert is missing: apt-get install librsvg2-bin" >&2; exit 3; }

cmake --build "$build" --target cuts_figure
"$build/tools/cuts_figure" plans/examples/curved-room.json docs/cuts.svg
rsvg-convert --zoom 1.5 docs/cuts.svg -o docs/cuts.png
