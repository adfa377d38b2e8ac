#!/bin/sh
# Installs the packages of tools/packages.txt that are missing; says nothing when none is.
set -eu
list=$(dirname "$0")/packages.txt

if ! command -v dpkg-query >/dev/null 2>&1; then
  echo "No dpkg here: install what corresponds to $list by hand." >&2
  exit 0
fi

# Whether a package is installed, or another one that stands in for it (nodejs of other sources
# brings npm along).
is_there() {
  status=$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)
  [ "$status" = installed ] && return 0
  dpkg-query -W -f '${db:Status-Status} ${Provides}\n' | sed -n 's/^installed //p' |
    tr -d ' ' | tr ',' '\n' | sed 's/(.*//' | grep -qxF "$1"
}

missing=
for package in $(sed 's/#.*//' "$list"); do
  is_there "$package" || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null 2>&1; then
    echo "Missing packages:$missing" >&2
    echo "Install them as root: apt-get install --no-install-recommends$missing" >&2
    exit 1
  fi
  as_root=sudo
fi

echo "Installing:$missing"
$as_root apt-get update -q
# shellcheck disable=SC2086 # one word for each package
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends $missing
