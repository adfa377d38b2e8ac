#!/bin/sh
# Kills runs, damages what they wrote, and lets them go on: each must end with the files of the run
# that nothing happened to, or say what is lost.
#   faults.sh SABO [KILLS [MINUTES]]    with MINUTES, kills go on for so long
set -eu
sabo=$1
kills=${2:-3}
minutes=${3:-0}
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work"

fail() {
  echo "faults: $*" >&2
  exit 1
}

mkdir -p whole changed
cat > case.toml <<'CASE'
[terrain.plane]
extent = [-0.5, -0.5, 2.5, 1.1]
[release]
box = [0, 0, 0, 0.8, 0.6, 0.4]
[[body]]
name = "tank"
kind = "tank"
min = [0, 0, 0]
max = [2, 0.6, 1]
[[section]]
line = [[1.1, 0.6], [1.1, 0]]
[material]
density = 1600
rheology = "bingham"
viscosity = 1
cohesion = 60
friction_angle = 0
[numerics]
spacing = 0.1
threads = 1
[run]
duration = 2
stop_at_rest = false
output_interval = 0.2
series_interval = 0.02
checkpoint_interval = 0.02
CASE

# What a run leaves, without what tells of its computing or names its folder.
results() {
  (cd "$1" && find maps series frames pictures view -type f ! -name paraview.pvsm \
    -exec cksum {} + | sort -k 3)
}
same() {
  results whole/run > expected
  results "$1" > given
  cmp -s expected given || { diff expected given >&2; fail "$2: other results"; }
  grep -q '^end = "finished"' "$1/manifest.toml" || fail "$2: the manifest says no end"
  [ -z "$(find "$1" -name '*.part.*')" ] || fail "$2: parts of files are left"
}
# Expects an exit code and a text: refused CODE TEXT COMMAND...
refused() {
  code=$1 text=$2
  shift 2
  status=0
  "$@" > out 2>&1 || status=$?
  [ $status -eq "$code" ] || { cat out >&2; fail "exit code $status, expected $code: $*"; }
  grep -q -- "$text" out || { cat out >&2; fail "does not say '$text': $*"; }
}
number() { od -An -N2 -tu2 /dev/urandom | tr -d ' '; }

start=$(date +%s%N)
"$sabo" run case.toml -o whole/run > out 2>&1 || { cat out >&2; fail "the run itself"; }
length=$((($(date +%s%N) - start) / 1000000)) # ms

# kill -9 at random moments, also while it writes a checkpoint or its results.
mkdir -p killed
until_time=$(($(date +%s) + minutes * 60))
rounds=0
killed=0
early=0
while [ $killed -lt "$kills" ] || [ "$(date +%s)" -lt $until_time ]; do
  rm -rf killed/run
  how=--overwrite
  in_round=0
  while :; do
    "$sabo" run case.toml -o killed/run $how --threads $((1 + killed % 2)) > out 2>&1 &
    pid=$!
    if [ $in_round -lt 4 ]; then
      wait_ms=$(($(number) % (length + 1)))
      sleep "$(printf '%d.%03d' $((wait_ms / 1000)) $((wait_ms % 1000)))"
      kill -9 $pid 2> /dev/null || true
    fi
    status=0
    wait $pid || status=$?
    case $status in
      137)
        killed=$((killed + 1))
        in_round=$((in_round + 1))
        ls killed/run/checkpoint/*[0-9].sabo > /dev/null 2>&1 && how=--resume || how=--overwrite
        [ $how = --resume ] || early=$((early + 1))
        ;;
      0) break ;;
      2) # killed after its manifest said that it had finished
        grep -q 'has finished' out || { cat out >&2; fail "kill -9: refused"; }
        break
        ;;
      *) cat out >&2; fail "kill -9: exit code $status" ;;
    esac
  done
  same killed/run "kill -9"
  rounds=$((rounds + 1))
done
echo "faults: $killed kills in $rounds runs, $early before the first checkpoint: same results"

# SIGTERM: it writes its results, then goes on as if nothing had been.
mkdir -p term
"$sabo" run case.toml -o term/run > out 2>&1 &
pid=$!
while ! ls term/run/checkpoint/*[0-9].sabo > /dev/null 2>&1; do sleep 0.05; done
kill -TERM $pid
status=0
wait $pid || status=$?
if [ $status -eq 130 ]; then
  grep -q 'sabo run term/run --resume' out || fail "SIGTERM: does not say how to go on"
  [ -s term/run/maps/pfd.tif ] || fail "SIGTERM: no maps"
  "$sabo" run term/run --resume > out 2>&1 || { cat out >&2; fail "SIGTERM: does not go on"; }
elif [ $status -ne 0 ]; then
  cat out >&2
  fail "SIGTERM: exit code $status"
fi
same term/run "SIGTERM"
refused 2 'has finished, at 2 s; give a longer --duration' "$sabo" run term/run --resume
"$sabo" run term/run --resume --duration 2.2 > out 2>&1 || { cat out >&2; fail "longer duration"; }
grep -q '^simulated_s = 2.2' term/run/manifest.toml || fail "longer duration: not reached"
refused 2 'numerics.spacing: is 0.2 and was 0.1' "$sabo" run term/run --resume --spacing 0.2

# A run that was killed once, to be damaged.
mkdir -p once
while :; do
  rm -rf once/run
  "$sabo" run case.toml -o once/run > out 2>&1 &
  pid=$!
  while [ "$(ls once/run/checkpoint/*[0-9].sabo 2> /dev/null | wc -l)" -lt 2 ]; do
    kill -0 $pid 2> /dev/null || break
    sleep 0.02
  done
  refused_run=$(cd "$work" && "$sabo" run case.toml -o once/run --overwrite 2>&1) && locked=0 || locked=$?
  kill -9 $pid 2> /dev/null || true
  wait $pid 2> /dev/null || true
  [ "$(ls once/run/checkpoint/*[0-9].sabo 2> /dev/null | wc -l)" -ge 2 ] || continue
  grep -q '^end = "running"' once/run/manifest.toml || continue
  break
done
[ $locked -eq 2 ] || fail "two runs in one folder: exit code $locked"
case $refused_run in
  *'another run is writing to it'*) ;;
  *) fail "two runs in one folder: $refused_run" ;;
esac
again() { rm -rf now && mkdir now && cp -r once/run now/run; }
newest() { ls now/run/checkpoint/*[0-9].sabo | tail -n 1; }

again # truncated: the one before
size=$(wc -c < "$(newest)")
truncate -s $((size / 2)) "$(newest)"
"$sabo" run now/run --resume > out 2>&1 || { cat out >&2; fail "truncated checkpoint"; }
grep -q "is damaged or cut off" out || fail "truncated checkpoint: not said"
same now/run "truncated checkpoint"

again # a flipped bit
printf '\377' | dd of="$(newest)" bs=1 seek=$((size / 3)) conv=notrunc 2> /dev/null
"$sabo" run now/run --resume > out 2>&1 || { cat out >&2; fail "flipped checkpoint"; }
same now/run "flipped checkpoint"

again # both
for file in now/run/checkpoint/*[0-9].sabo; do truncate -s 1000 "$file"; done
refused 2 'what it had computed is lost' "$sabo" run now/run --resume

again # a series that somebody has changed
sed -i '2s/^0/1/' now/run/series/front.csv
refused 3 'front.csv is no longer as it was then' "$sabo" run now/run --resume

again # a frame is gone
rm now/run/frames/flow_00000.vtp
refused 3 'flow_00000.vtp is missing' "$sabo" run now/run --resume

again # a full disk, as far as a limit on files is one
status=0
(ulimit -f 40 && trap '' XFSZ && "$sabo" run now/run --resume) > out 2>&1 || status=$?
[ $status -eq 3 ] || { cat out >&2; fail "full disk: exit code $status"; }
grep -q 'File too large' out || { cat out >&2; fail "full disk: no reason"; }
grep -q '^end = "failed"' now/run/manifest.toml || fail "full disk: the manifest says otherwise"
"$sabo" run now/run --resume > out 2>&1 || { cat out >&2; fail "full disk: does not go on"; }
same now/run "full disk"

# No memory: half a million particles in 400 MB.
status=0
(ulimit -v 400000 && "$sabo" run case.toml -o big --spacing 0.01) > out 2>&1 || status=$?
[ $status -eq 3 ] || { cat out >&2; fail "no memory: exit code $status"; }
grep -q 'not enough memory' out || { cat out >&2; fail "no memory: not said"; }

if [ "$(id -u)" -ne 0 ]; then # root writes everywhere
  again
  chmod -R a-w now/run
  refused 3 'cannot write' "$sabo" run now/run --resume
  chmod -R u+w now/run
fi
refused 2 'cannot be made' "$sabo" run case.toml -o /proc/sabo

# A lost and a changed input.
mkdir -p input
printf '0 0\n' > input/unused
python3 - << 'DEM' || fail "cannot make a DEM"
rows = ["ncols 12", "nrows 8", "xllcorner -0.5", "yllcorner -0.5", "cellsize 0.25",
        "NODATA_value -9999"] + [" ".join(["0"] * 12)] * 8
open("input/dem.asc", "w").write("\n".join(rows) + "\n")
DEM
sed -e 's/^\[terrain.plane\]/[terrain]/' -e 's/^extent.*/dem = "dem.asc"\nassume_metres = true/' \
  -e 's/^duration.*/duration = 0.2/' case.toml > input/case.toml
"$sabo" run input -o input-run > out 2>&1 || { cat out >&2; fail "a DEM"; }
mv input/dem.asc input/away.asc
refused 2 'dem.asc' "$sabo" run input-run --resume --duration 0.3
sed 's/0 0$/0 1/' input/away.asc > input/dem.asc
refused 2 'has changed since the run began' "$sabo" run input-run --resume --duration 0.3
mv input/away.asc input/dem.asc
"$sabo" run input-run --resume --duration 0.3 > out 2>&1 || { cat out >&2; fail "input put back"; }

# Branches: a wall that stands free, one in the flow, another release.
wall() {
  cat case.toml
  printf '[[structure]]\nname = "wall"\nline = [[%s, 0], [%s, 0.6]]\nheight = 0.3\nthickness = 0.4\n' \
    "$1" "$1"
}
"$sabo" run case.toml -o early --duration 0.3 > out 2>&1 || { cat out >&2; fail "early"; }
wall 1.7 > changed/case.toml
"$sabo" run changed -o branch --branch-at 0.3 --from early > out 2>&1 ||
  { cat out >&2; fail "branch"; }
grep -q 'Starts from 0.3 s of early/checkpoint' out || fail "branch: not said from where"
grep -q '^branched_at_s = 0.3' branch/manifest.toml || fail "branch: not in the manifest"
[ "$(sed -n 2p branch/series/front.csv | cut -d, -f1)" = 0.3 ] || fail "branch: series"
wall 1.1 > changed/case.toml
refused 2 'wall: would hold' "$sabo" run changed -o no --branch-at 0.3 --from early
refused 2 'no checkpoint at or before' "$sabo" run case.toml -o no --branch-at 0.01 --from early
sed 's/0.8, 0.6, 0.4\]/0.7, 0.6, 0.4]/' case.toml > changed/case.toml
refused 2 'release.box: is' "$sabo" run changed -o no --branch-at 0.3 --from early
[ ! -e no ] || fail "branch: a refused run has left a folder"
echo "faults: all as it should be"
