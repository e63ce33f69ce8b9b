#!/bin/sh
# Checks the playground: builds it, and tries it in a headless browser.
# VIROTE names the command to compare with, WASM the module (see build.sh).
set -eu
cd "$(dirname "$0")"
[ -d ../node_modules ] || (cd .. && npm ci --no-audit --no-fund)
(cd .. && node_modules/.bin/tsc --noEmit)
PLAYGROUND=$(mktemp -d)
trap 'rm -rf "$PLAYGROUND"' EXIT
export PLAYGROUND
./build.sh "$PLAYGROUND"
node --test test/*.test.mjs
