#!/bin/sh
# Checks the page: its types, that web/dist is what its sources make, and its behaviour in a headless browser.
# VIROTE names the command to test (target/debug/virote or target/release/virote without it).
set -eu
cd "$(dirname "$0")"
[ -d node_modules ] || npm ci --no-audit --no-fund
node_modules/.bin/tsc --noEmit
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
./build.sh "$fresh"
for file in index.html begin.js.gz app.js.gz app.css.gz; do
    cmp "$fresh/$file" "dist/$file" || { echo "web/dist/$file is not what the sources make: run web/build.sh and commit it" >&2; exit 1; }
done
node --test test/*.test.mjs
