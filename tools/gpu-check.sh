#!/usr/bin/env bash
# tools/gpu-check.sh [BUNDLE] [FLAGS]: judges a CUDA card on a machine with CUDA, cmake and a C++ compiler, and nothing else.
# Builds accel, render and enfilade_gpu for this card, compares all its pictures and rays with the scalar tracer, asks
# compute-sanitizer, measures, and writes tables in Markdown to standard output and to a file. Progress goes to standard error.
#   BUNDLE           what tools/gpu-bundle.sh made, or the folder that was in it (the sources that this script lies in)
#   --scenes DIR     where the scenes are (scenes/ beside the sources)
#   --only STEP      build, check, sanitize or bench alone; what is built already is built no more
#   --quick          small pictures, few rounds: two minutes
#   --report FILE    where the tables go as well (gpu-report.md beside the sources)
#   --device N       which card, counted from 0 (0)
#   --build DIR      the build folder (build/gpu-check beside the sources)
#   --on host        no card: the same kernels on this machine's cores, to try all of this out; nothing is measured
# Ends with 0 when all is well, 1 when an answer is wrong, 2 when a flag is, 3 when something needed is not there.
set -euo pipefail
shopt -s nullglob
script=$(readlink -f "${BASH_SOURCE[0]}")

refuse() { echo "$1 See tools/gpu-check.sh --help." >&2; exit 2; }
give_up() { echo "$1" >&2; exit 3; }
say() { printf '[%3d s] %s\n' "$SECONDS" "$1" >&2; }

root=$(dirname "$(dirname "$script")")
scenes="" only="" quick="" report="" device=0 build="" on=card
value() { [ $# -ge 2 ] || refuse "$1 stands without its value."; }
while [ $# -gt 0 ]; do
    case $1 in
    -h | --help)
        sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//p}' "$script"
        exit 0
        ;;
    --scenes | --only | --report | --device | --build | --on)
        value "$@"
        case $1 in
        --scenes) scenes=$2 ;;
        --only) only=$2 ;;
        --report) report=$2 ;;
        --device) device=$2 ;;
        --build) build=$2 ;;
        --on) on=$2 ;;
        esac
        shift
        ;;
    --quick) quick=--quick ;;
    -*) refuse "There is no $1." ;;
    *.tar.gz | *.tgz)
        [ -f "$1" ] || refuse "There is no $1."
        tar xzf "$1" || give_up "$1 cannot be unpacked here."
        root=$PWD/enfilade-gpu
        ;;
    *)
        [ -d "$1" ] || refuse "There is no folder $1."
        root=$(cd "$1" && pwd)
        ;;
    esac
    shift
done
case $only in "" | build | check | sanitize | bench) ;; *) refuse "--only takes build, check, sanitize or bench, not \"$only\"." ;; esac
case $on in card | host) ;; *) refuse "--on takes card or host, not \"$on\"." ;; esac
case $device in "" | *[!0-9]*) refuse "--device takes a number, not \"$device\"." ;; esac
[ -f "$root/tools/gpu/main.cpp" ] || refuse "$root holds no sources of enfilade_gpu."
scenes=${scenes:-$root/scenes}
build=${build:-$root/build/gpu-check}
report=${report:-$root/gpu-report.md}
program=$build/tools/gpu/enfilade_gpu
wants() { [ -z "$only" ] || [ "$only" = "$1" ]; }

# --- what is here ---
PATH=$PATH:/usr/local/cuda/bin
command -v cmake >/dev/null || give_up "cmake is missing: install it, 3.25 or newer."
cmake_version=$(cmake --version | sed -n '1s/[^0-9]*\([0-9]*\)\.\([0-9]*\).*/\1 \2/p')
[ "${cmake_version% *}" -gt 3 ] || [ "${cmake_version#* }" -ge 25 ] || give_up "cmake is older than 3.25: install a newer one."
command -v c++ >/dev/null || command -v g++ >/dev/null || give_up "There is no C++ compiler: install g++ 11 or newer."
architectures=75-real\;80-real\;86-real\;89-real\;90
cuda=OFF
if [ "$on" = card ]; then
    cuda=ON
    command -v nvcc >/dev/null || give_up "There is no nvcc: install CUDA 12 or newer, or put it into PATH."
    if command -v nvidia-smi >/dev/null; then
        nvidia-smi -i "$device" >/dev/null 2>&1 || give_up "nvidia-smi knows no card $device: this needs an NVIDIA card and its driver."
        found=$(nvidia-smi -i "$device" --query-gpu=compute_cap --format=csv,noheader 2>/dev/null | head -1 | tr -d '. ') || found=""
        case $found in "" | *[!0-9]*) ;; *) architectures=$found-real ;; esac
    elif ! compgen -G '/dev/nvidia[0-9]*' >/dev/null; then
        give_up "There is no card: this needs an NVIDIA card and its driver."
    fi
fi

# --- build ---
if wants build || [ ! -x "$program" ]; then
    if command -v ninja >/dev/null; then generator=Ninja; else generator="Unix Makefiles"; fi
    if [ "$generator" != Ninja ] && ! command -v make >/dev/null; then
        give_up "There is neither ninja nor make: install one of them."
    fi
    # A folder that another generator, or another place, has set up is set up anew.
    if [ -f "$build/CMakeCache.txt" ] &&
        { ! grep -qxF "CMAKE_GENERATOR:INTERNAL=$generator" "$build/CMakeCache.txt" ||
            ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; }; then
        rm -rf "$build"
    fi
    jobs=$(nproc)
    memory=$(($(awk '$1 == "MemAvailable:" {print $2}' /proc/meminfo) / (2 * 1024 * 1024)))
    [ "$memory" -ge "$jobs" ] || jobs=$((memory > 0 ? memory : 1))
    say "building for $([ "$on" = card ] && echo "compute capability ${architectures//-real/}" || echo "this machine's cores") with $jobs jobs of $generator"
    mkdir -p "$build"
    log=$build/gpu-check.log
    {
        (cd "$root" && cmake --preset gpu-bare -G "$generator" -B "$build" -DENFILADE_CUDA=$cuda "-DCMAKE_CUDA_ARCHITECTURES=$architectures") &&
            cmake --build "$build" -j "$jobs" --target enfilade_gpu
    } >"$log" 2>&1 || {
        grep -m 3 -A 2 -iE 'error|fatal|cannot|could not' "$log" >&2 || tail -5 "$log" >&2
        give_up "The build failed; all that it said is in $log."
    }
    say "built"
fi
[ "$only" != build ] || exit 0
[ -x "$program" ] || give_up "$program is not there: build it with --only build."

# --- scenes ---
[ -d "$scenes" ] || give_up "There is no folder $scenes of scenes: make it with tools/gpu-bundle.sh, or name another by --scenes."
present=()
add_scenes() { for name in "$@"; do [ ! -f "$scenes/$name.enf" ] || present+=("$scenes/$name.enf"); done; }
known="bare-9 bare-46 bare-135 bare-1000 outside-46 furnished-9 furnished-46 furnished-135 mesh-bunny mesh-armadillo mesh-dragon"
# shellcheck disable=SC2086
add_scenes $known
for file in "$scenes"/*.enf; do
    name=$(basename "$file" .enf)
    case " $known small-9 " in *" $name "*) ;; *) present+=("$file") ;; esac
done
for name in $known; do [ -f "$scenes/$name.enf" ] || echo "left out: there is no $name.enf in $scenes" >&2; done
[ ${#present[@]} -gt 0 ] || give_up "There is no scene in $scenes."

where=(--on "$on" --device "$device")
[ "$on" = host ] || "$program" card --device "$device" >&2 || exit 3
[ -n "$only" ] || : >"$report"
status=0 broken=0
# A step's tables go to standard output and to the report; its exit code is kept.
run_step() {
    local code=0
    "$program" "$@" "${where[@]}" | tee -a "$report" || code=${PIPESTATUS[0]}
    echo | tee -a "$report"
    [ "$code" -ne 1 ] || status=1
    [ "$code" -lt 2 ] || broken=3  # what follows may still go
}

if wants check; then
    say "comparing with the scalar tracer"
    size=()
    [ -z "$quick" ] || size=(--side 256 --views 1 --rays 65536)
    run_step check "${size[@]}" "${present[@]}"
fi

if wants sanitize; then
    {
        echo "## compute-sanitizer"
        echo
        if [ "$on" = host ]; then
            echo "skipped: these are no kernels of a card."
        elif ! command -v compute-sanitizer >/dev/null; then
            echo "skipped: compute-sanitizer is not installed."
        else
            small=()
            for name in small-9 mesh-bunny; do [ ! -f "$scenes/$name.enf" ] || small+=("$scenes/$name.enf"); done
            [ ${#small[@]} -gt 0 ] || small=("${present[0]}")
            for tool in memcheck racecheck initcheck synccheck; do
                say "compute-sanitizer $tool"
                log=$build/$tool.log
                code=0
                timeout 100 compute-sanitizer --tool "$tool" --error-exitcode 99 "$program" check --side 24 --views 1 --rays 512 \
                    "${where[@]}" "${small[@]}" >"$log" 2>&1 || code=$?
                if [ "$code" -eq 0 ]; then echo "- $tool: clean"
                elif [ "$code" -eq 124 ]; then echo "- $tool: not ended after 100 s; nothing found until then"
                elif grep -q 'Device not supported\|not supported on this' "$log"; then echo "- $tool: skipped, it does not know this device"
                elif [ "$code" -eq 99 ]; then echo "- $tool: FAULTS: $(grep -m 1 'ERROR SUMMARY\|RACECHECK SUMMARY' "$log" | tr -d '='), all in $log"
                else echo "- $tool: failed with $code; what it said is in $log"
                fi
            done
        fi
        echo
    } >"$build/sanitize.md"
    tee -a "$report" <"$build/sanitize.md"
    ! grep -q 'FAULTS\|: failed with' "$build/sanitize.md" || status=1
fi

if wants bench; then
    say "measuring"
    # shellcheck disable=SC2086
    run_step bench $quick "${present[@]}"
fi
say "done; the tables are in $report"
[ "$status" -ne 0 ] || exit $broken
exit "$status"
