#!/usr/bin/env bash
# Says which of our files are not formatted as .clang-format says, and which break a rule of the house that a script can see.
# tools/lint.sh --fix formats them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
format=$(command -v clang-format-14 || command -v clang-format)

mapfile -t sources < <(git ls-files '*.h' '*.cpp' '*.cu' '*.cuh')
if [ "${1:-}" = --fix ]; then
    "$format" -i "${sources[@]}"
    exit 0
fi

failed=0
"$format" --dry-run --Werror "${sources[@]}" || failed=1
/usr/bin/python3 tests/architecture/check_sources.py || failed=1
for script in $(git ls-files '*.sh' .ci/run); do
    bash -n "$script" || failed=1
    [ -x "$script" ] || { echo "$script is not executable: chmod +x it." >&2; failed=1; }
done
exit $failed
