#!/bin/sh
# Runs every fuzz target for so many seconds and tells how many inputs it tried; fails at the first
# finding, whose file it names.
#   run.sh FOLDER_OF_TARGETS SECONDS [WORKPLACE]    the inputs found grow in WORKPLACE
set -eu
here=$(cd "$(dirname "$0")" && pwd)
targets=$1
seconds=$2
work=${3:-$(mktemp -d)}
for source in "$here"/fuzz_*.cpp; do
  name=$(basename "$source" .cpp)
  reader=${name#fuzz_}
  grown=$work/corpus/$reader
  mkdir -p "$grown" "$work/findings"
  set -- "$grown"
  [ ! -d "$here/corpus_$reader" ] || set -- "$@" "$here/corpus_$reader"
  [ "$reader" != hazard_rules ] || set -- "$@" "$here/../../src/io/case_file/hazard_rules"
  [ ! -f "$here/$reader.dict" ] || set -- "$@" "-dict=$here/$reader.dict"
  log=$work/$reader.log
  if ! TMPDIR=$work "$targets/$name" "$@" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2500 \
    -artifact_prefix="$work/findings/$reader-" -print_final_stats=1 > "$log" 2>&1; then
    tail -n 40 "$log" >&2
    echo "fuzz: $reader: a finding, see $work/findings" >&2
    exit 1
  fi
  tried=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  echo "fuzz: $reader: $tried inputs, no finding"
done
