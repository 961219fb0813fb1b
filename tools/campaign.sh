#!/usr/bin/env bash
# tools/campaign.sh [COUNT [SERIES]]: puts COUNT random faults of each code into random sound buildings, one at a time (1000), and
# prints the table of docs/checks.md: how many were found, and what else was. Ends with 1 where one was missed, found
# elsewhere, or not alone. Each SERIES (a number, 0) draws other buildings and faults.
# tools/campaign.sh rooms [COUNT [SERIES]]: cuts COUNT random rooms (100000) in every way, and prints what
# tests/modeler/cutting says of the pieces. Ends with 1 where a partition was none; the rooms are kept in the temporary folder.
# tools/campaign.sh rays [COUNT [SERIES]]: walks COUNT rays (1000000000) of every family through offices, generated buildings and
# the homes of ../shared, by every tracer, on all cores, and prints what leaked, what was recovered and what differs from the
# scalar walk in float. Ends with 1 where a ray leaked, or differs without an edge near.
# tools/campaign.sh octrees [COUNT [SERIES]]: asks octrees of random meshes and options COUNT rays of thirteen families (10000000), in
# every layout, by every walk and instruction set, and prints what differed from brute force. Ends with 1 where any did without
# running along a triangle's plane.
# tools/campaign.sh lights [COUNT [SERIES]]: asks light trees whether COUNT random places (10000000) see random lamps, in offices,
# generated buildings and the homes of ../shared, and a tenth as many among furniture, and prints what walks in double precision
# answer otherwise. Ends with 1 where a lamp was missed, or differs without an edge near.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# campaign FOLDER TEST FILTER WORD HEAD...: builds tests/FOLDER/TEST and runs what of it the filter names. Prints the head, then
# the rows that the test wrote behind the WORD; where it failed, all else that it said.
campaign() {
    local folder=$1 program=$2 filter=$3 word=$4 status=0 column
    shift 4
    tools/build.sh release "$program"
    log=$(mktemp)
    trap 'rm -f "$log"' EXIT
    "build/release/tests/$folder/$program" --gtest_filter="$filter" >"$log" 2>&1 || status=1
    printf '| %s ' "$@"
    echo "|"
    for column in "$@"; do printf '|---'; done
    echo "|"
    sed -n "s/^$word | /| /p" "$log"
    [ "$status" -eq 0 ] || grep -vE "^$word \||RUN|OK" "$log" >&2
    return "$status"
}

case ${1:-} in
rooms)
    export ENFILADE_ROOMS=${2:-100000} ENFILADE_ROOMS_SERIES=${3:-0}
    campaign modeler/cutting random_rooms_test '*RandomRooms*' rooms rooms cutter cut failed pieces "to ceil(r/2)+1" "cuts moved" \
        "fallen back" "thin between walls" "thin between corners" "thin by new cuts" "unused points" stray dent
    exit
    ;;
rays)
    export ENFILADE_RAYS=${2:-1000000000} ENFILADE_RAYS_SERIES=${3:-0}
    campaign render tracers_in_buildings_test Leaks.AreNone rays family tracer rays leaks "several exits" "no exit" "other face" \
        "of these looked at" "no edge near"
    exit
    ;;
lights)
    export ENFILADE_LAMP_PAIRS=${2:-10000000} ENFILADE_LAMP_SERIES=${3:-0}
    campaign render lamp_campaign_test 'LampCampaign.MissesNoLamp*' lights building "places and lamps" seen "missed by lists" \
        "other light" "no edge near"
    exit
    ;;
octrees)
    export ENFILADE_OCTREE_RAYS=${2:-10000000} ENFILADE_OCTREE_SERIES=${3:-0}
    campaign render octree_properties_test AnyOctree.AnswersAsBruteForceInCampaigns octrees family rays hits \
        "other answers along planes" "other answers"
    exit
    ;;
esac
tools/build.sh release campaign_test
log=$(mktemp)
trap 'rm -f "$log"' EXIT
status=0
ENFILADE_CAMPAIGN=${1:-1000} ENFILADE_CAMPAIGN_SERIES=${2:-0} build/release/tests/modeler/constraints/campaign_test >"$log" 2>&1 || status=1
echo "| code | injected | found | other codes | out of place | found more than once |"
echo "|---|---|---|---|---|---|"
sed -n 's/^campaign | /| /p' "$log"
sed -n 's/^sound | \([0-9]*\) | \([0-9]*\) |/\1 sound buildings, false alarms in \2./p' "$log"
[ "$status" -eq 0 ] || grep -E "Failure|seed|found|and |campaign_test" "$log" >&2
exit "$status"
