#!/bin/sh
# Builds the extension and packs it: dist/virote.vsix. The grammar and the licences are those of the repository.
set -eu
cd "$(dirname "$0")"
[ -d node_modules ] || npm ci --no-audit --no-fund
mkdir -p dist syntaxes
cp ../../grammar/virote.tmLanguage.json syntaxes/
cp ../../LICENSE-APACHE ../../LICENSE-MIT .
npm run --silent build -- --minify --log-level=warning
node_modules/.bin/vsce package --no-dependencies --allow-missing-repository --skip-license --out dist/virote.vsix
