#!/bin/sh
# Builds the playground into playground/dist, a folder of files for any web server: `npm ci` once, then this.
# WASM names the compiled module; without it cargo builds it.
set -eu
cd "$(dirname "$0")"
out=${1:-dist}
root=../..
[ -d ../node_modules ] || (cd .. && npm ci --no-audit --no-fund)
if [ -z "${WASM:-}" ]; then
    cargo build --manifest-path "$root/Cargo.toml" --release -p virote-wasm --target wasm32-unknown-unknown
    WASM=$root/target/wasm32-unknown-unknown/release/virote_wasm.wasm
fi
rm -rf "$out"
mkdir -p "$out/gallery"
esbuild=../node_modules/.bin/esbuild
for entry in main:app worker:worker; do
    "$esbuild" "src/${entry%:*}.ts" --bundle --minify --format=iife --target=es2022 --charset=utf8 --legal-comments=eof \
        --log-level=warning --outfile="$out/${entry#*:}.js"
done
"$esbuild" src/style.css --bundle --minify --target=chrome111,firefox113,safari16.4 --charset=utf8 --legal-comments=eof \
    --log-level=warning --outfile="$out/app.css"
for package in three three-mesh-bvh @codemirror/state @codemirror/view; do
    printf '/*! %s\n%s\n*/\n' "$package" "$(cat "../node_modules/$package/LICENSE")"
done >>"$out/app.js"
gzip -9nc "$WASM" >"$out/virote.wasm.gz"
node examples.mjs "$root/examples" >"$out/examples.json"
cp "$root"/examples/gallery/*.png "$out/gallery"
cp index.html "$out/index.html"
