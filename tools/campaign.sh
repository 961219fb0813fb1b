#!/usr/bin/env bash
# tools/campaign.sh [COUNT [SERIES]]: puts COUNT random faults of each code into random sound buildings, one at a time (1000), and
# prints the table of docs/checks.md: how many were found, and what else was. Ends with 1 where one was missed, found
# elsewhere, or not alone. Each SERIES (a number, 0) draws other buildings and faults.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
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
