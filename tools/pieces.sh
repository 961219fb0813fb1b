#!/usr/bin/env bash
# tools/pieces.sh [BUILD]: draws docs/furniture.png anew, all pieces of our own in one picture, and writes their sizes
# and triangles into docs/furniture.md. BUILD: a build folder (build/release).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/release}
[ -f "$build/build.ninja" ] || { echo "There is no build in $build: tools/build.sh release" >&2; exit 2; }

cmake --build "$build" --target pieces_sheet
"$build/tools/pieces_sheet" docs/furniture.png --tile 128 --columns 10 --samples 64 --tones 40

table=$(mktemp)
trap 'rm -f "$table"' EXIT
"$build/tools/pieces_sheet" --table > "$table"
sed -i -e "/<!-- table -->/,/<!-- end of table -->/ { /<!--/!d }" -e "/<!-- table -->/r $table" docs/furniture.md
