#!/bin/sh
# Fails where clang-format would change a C++ file of src/ or tests/; with --fix it changes them.
# Versions of clang-format differ in small things: 14, that of Debian 12, is the one that counts.
set -eu
cd "$(dirname "$0")/.."

format=$(command -v clang-format-14 || command -v clang-format || true)
if [ -z "$format" ]; then
  echo "check_format: clang-format-14 is missing; run tools/install_packages.sh" >&2
  exit 1
fi

if [ "${1:-}" = --fix ]; then
  mode=-i
else
  mode='--dry-run -Werror'
fi
# shellcheck disable=SC2086 # two words
find src tests \( -name '*.hpp' -o -name '*.cpp' -o -name '*.cu' -o -name '*.cuh' \) -print0 |
  xargs -0 -r "$format" $mode
