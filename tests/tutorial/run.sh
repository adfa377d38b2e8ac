#!/bin/sh
# Runs a page of the docs: its blocks of shell in one shell, in their order, stopping at the first
# that fails; blocks with a file name become that file.
#
#     run.sh PAGE PROGRAM    PROGRAM is what the page calls by its name
set -eu
page=$(realpath "$1")
PATH=$(dirname "$(realpath "$2")"):$PATH
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

awk '
  /^```sh$/ { in_shell = 1; next }
  /^```toml / { in_file = 1; print "cat > " $2 " <<\"END OF FILE\""; next }
  /^```/ { if (in_file) print "END OF FILE"; in_shell = in_file = 0; next }
  in_shell || in_file { print }
' "$page" >page.sh
grep -q sabo page.sh || { echo "no commands found in $page"; exit 1; }
sh -eux page.sh

# What the page promises.
for file in valley-check.svg without-dam/index.html without-dam/view/index.html \
  without-dam/states.html with-dam/series/filling.csv with-dam/series/loads.csv \
  difference/index.html valley-sweep/index.html with-dam/export with-dam/report.html \
  with-dam/report_ja.html; do
  [ -e "$file" ] || { echo "missing: $file"; exit 1; }
done
