#!/usr/bin/env bash
# tools/demo.sh [--furnished] [PLAN]: installs what is missing, builds the program, models a house from its plan, checks
# it, renders it, and says where the pictures and the report are (out/demo/NAME). --furnished: with furniture in all its
# rooms, of our own pieces, and of Debian's libraries for Sweet Home 3D where those are installed. The last pictures are
# lit by its lamps.
set -euo pipefail
furnished=
if [ "${1:-}" = --furnished ]; then
    furnished=yes
    shift
fi
plan=$(realpath -- "${1:-$(dirname "${BASH_SOURCE[0]}")/../plans/examples/townhouse.json}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ -f "$plan" ] || { echo "There is no plan $plan." >&2; exit 2; }

tools/install-packages.sh
tools/build.sh release enfilade
enfilade=build/release/tools/enfilade

name=$(basename "${plan%.*}")
out=out/demo/$name${furnished:+-furnished}
rm -rf "$out"
mkdir -p "$out"

flags=(--lamps)
if [ -n "$furnished" ]; then
    flags=(--lamps --furnish --detail 3)
    libraries=(/usr/share/sweethome3d/furniture/*.sh3f)
    found=
    for library in "${libraries[@]}"; do
        [ -f "$library" ] || continue
        flags+=(--catalogue "$library")
        found=yes
    done
    [ -n "$found" ] || echo "Our own pieces stand in the rooms; for 800 more: apt-get install sweethome3d-furniture"
fi

# Real plans have faults: the model is made of what can be used, and the report names the rest.
verdict=0
"$enfilade" build "$plan" -o "$out/$name.enf" --keep-going --report "$out/report.html" "${flags[@]}" || verdict=$?
[ "$verdict" -le 1 ] || exit "$verdict"
"$enfilade" check "$out/$name.enf" --report "$out/report.json" --quiet || [ $? -eq 1 ]
"$enfilade" info "$out/$name.enf" >"$out/info.txt"

"$enfilade" render "$out/$name.enf" -o "$out/exterior.png" --camera exterior --size 1280x960 --spp 4
storeys=$("$enfilade" info "$out/$name.enf" --json | /usr/bin/python3 -c '
import json, sys
print(json.load(sys.stdin)["counts"]["storeys"])')
for ((storey = 0; storey < storeys; storey++)); do
    "$enfilade" render "$out/$name.enf" -o "$out/storey-$storey.png" --camera "dollhouse:$storey" --size 1280x960 --spp 4
done
# A look into the largest room; of a furnished building into eight.
most=1
samples=4
if [ -n "$furnished" ]; then
    most=8
    samples=9
    "$enfilade" info "$out/$name.enf" --svg "$out/furniture.svg" >"$out/info.txt"
fi
mapfile -t rooms < <("$enfilade" info "$out/$name.enf" --json | /usr/bin/python3 -c '
import json, sys
info = json.load(sys.stdin)
full = {space["id"] for space in (info["furniture"] or {"spaces": []})["spaces"]}
rooms = sorted(info["rooms"], key=lambda r: (r["id"] in full, r["name"] != "", r["area_m2"]), reverse=True)
print("\n".join(r["id"] for r in rooms[:int(sys.argv[1])]))' "$most")
for ((k = 0; k < ${#rooms[@]}; k++)); do
    "$enfilade" render "$out/$name.enf" -o "$out/room-$k.png" --room "${rooms[$k]}" --size 1280x960 --spp "$samples"
done
# The same in the evening, by its lamps: cut open, and the largest room as light really goes in it.
"$enfilade" render "$out/$name.enf" -o "$out/evening.png" --camera dollhouse:0 --size 1280x960 --lights tree
"$enfilade" render "$out/$name.enf" -o "$out/evening-room.png" --room "${rooms[0]}" --size 640x480 --lights tree \
    --integrator path --spp 64
"$enfilade" export "$out/$name.enf" -o "$out/$name.glb"

echo
echo "The pictures:"
for picture in "$out"/*.png; do echo "  $PWD/$picture"; done
echo "The report, a page for the browser: $PWD/$out/report.html (for programs: report.json beside it)"
echo "The model, for other 3D programs: $PWD/$out/$name.glb"
