#!/bin/sh
# Runs the tests of the pages: run.sh PROGRAM. Ends with 77 (skipped) and says why when Node.js, npm
# or Chromium is missing, or the registry of npm cannot be reached.
set -eu
SABO_PROGRAM=$1
export SABO_PROGRAM
cd "$(dirname "$0")"

skip() {
  echo "skipped: $1"
  exit 77
}
command -v node >/dev/null || skip 'node is missing (Debian package nodejs)'
command -v npm >/dev/null || skip 'npm is missing (Debian package npm)'
command -v chromium >/dev/null || command -v chromium-browser >/dev/null || skip 'chromium is missing'
if ! cmp -s package-lock.json node_modules/.sabo-lock; then
  npm ci --no-audit --no-fund --ignore-scripts || skip 'npm ci failed: is the registry reachable?'
  cp package-lock.json node_modules/.sabo-lock
fi
exec node --test --test-concurrency=1 ./*.test.mjs
