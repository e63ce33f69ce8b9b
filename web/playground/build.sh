#!/bin/sh
# Builds the playground into playground/dist, a folder of files for any web server: `npm ci` once, then this.
# The book of docs/ goes with it. WASM names the compiled module; without it cargo builds it.
set -eu
cd "$(dirname "$0")"
out=${1:-dist}
root=../..
[ -d ../node_modules ] || (cd .. && npm ci --no-audit --no-fund)
if [ -z "${WASM:-}" ]; then
    cargo build --manifest-path "$root/Cargo.toml" --profile page -p virote-wasm --target wasm32-unknown-unknown
    WASM=$root/target/wasm32-unknown-unknown/page/virote_wasm.wasm
fi
rm -rf "$out"
mkdir -p "$out/gallery"
esbuild=../node_modules/.bin/esbuild
for entry in begin:begin main:app worker:worker; do
    "$esbuild" "src/${entry%:*}.ts" --bundle --minify --format=iife --target=es2022 --charset=utf8 --legal-comments=eof \
        --log-level=warning --outfile="$out/${entry#*:}.js"
done
for style in style:app book:book; do
    "$esbuild" "src/${style%:*}.css" --bundle --minify --target=chrome123,firefox120,safari17.5 --charset=utf8 --legal-comments=eof \
        --log-level=warning --outfile="$out/${style#*:}.css"
done
for package in three three-mesh-bvh @codemirror/state @codemirror/view; do
    printf '/*! %s\n%s\n*/\n' "$package" "$(cat "../node_modules/$package/LICENSE")"
done >>"$out/app.js"
node compress.mjs "$WASM" "$out/virote.wasm.gz"
node examples.mjs "$root/examples" >"$out/examples.json"
cp "$root"/examples/gallery/*.png "$out/gallery"
node book.mjs "$root/docs" "$out" "$WASM"
cp index.html "$out/index.html"
