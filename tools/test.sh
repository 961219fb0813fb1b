#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test. The summary of the tests is the last thing printed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools/install-packages.sh
tools/build.sh release
# One program at a time: the tests that measure speed share the machine with nothing else.
ctest --test-dir build/release --output-on-failure --no-tests=error
