#!/usr/bin/env bash
# Installs the packages of tools/packages.txt that this machine lacks; needs root and apt-get.
# Where it may not install, it prints the missing ones and ends with 3.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

wanted=()
while read -r package _; do
    case "$package" in '' | '#'*) ;; *) wanted+=("$package") ;; esac
done <"$here/packages.txt"

if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "This machine has no dpkg, so its packages cannot be checked. Enfilade is built on Debian 12 with: ${wanted[*]}" >&2
    exit 3
fi

missing=()
for package in "${wanted[@]}"; do
    status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
    [ "$status" = "install ok installed" ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

refuse() {
    echo "These packages are missing: ${missing[*]}" >&2
    echo "$1 Install them (on Debian 12: apt-get install ${missing[*]}), then run this again." >&2
    exit 3
}
command -v apt-get >/dev/null 2>&1 || refuse "There is no apt-get here."
[ "$(id -u)" -eq 0 ] || refuse "Installing needs root."

echo "Installing ${#missing[@]} packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
apt=(apt-get -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 -qq)
"${apt[@]}" update </dev/null
"${apt[@]}" install -y --no-install-recommends "${missing[@]}" </dev/null >/dev/null
