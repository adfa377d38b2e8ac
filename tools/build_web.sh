#!/bin/sh
# Builds the pages of web/*/ into their dist/, which is part of the repository, so that building the
# program needs no Node.js.
#
#     build_web.sh            builds all of them in place
#     build_web.sh --check    builds copies and fails where dist/ is not what the sources give; ends
#                             with 77 (skipped) without npm or its registry
set -eu
cd "$(dirname "$0")/.."

build() { # FOLDER
  (cd "$1" && npm ci --no-audit --no-fund --ignore-scripts && npm run build --if-present)
}

if [ "${1:-}" != --check ]; then
  for package in web/*/package.json; do build "$(dirname "$package")"; done
  exit 0
fi

command -v npm >/dev/null || { echo 'skipped: npm is missing (Debian packages nodejs, npm)'; exit 77; }
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
status=0
for folder in web/*/; do
  [ -d "$folder/dist" ] || continue
  name=$(basename "$folder")
  mkdir "$copy/$name"
  tar -C "$folder" --exclude=./node_modules --exclude=./dist -cf - . | tar -C "$copy/$name" -xf -
  (cd "$copy/$name" && npm ci --no-audit --no-fund --ignore-scripts) ||
    { echo 'skipped: npm ci failed: is the registry reachable?'; exit 77; }
  (cd "$copy/$name" && npm run build)
  diff -r "$folder/dist" "$copy/$name/dist" >/dev/null ||
    { echo "web/$name/dist is not what its sources give: make web"; status=1; }
done
exit $status
