#!/bin/sh
# Builds web/dist from the sources, the same bytes each time: `npm ci` once, then this.
set -eu
cd "$(dirname "$0")"
out=${1:-dist}
[ -d node_modules ] || npm ci --no-audit --no-fund
mkdir -p "$out"
esbuild=node_modules/.bin/esbuild
for entry in begin:begin main:app; do
    "$esbuild" "src/${entry%:*}.ts" --bundle --minify --format=iife --target=es2022 --charset=utf8 --legal-comments=eof \
        --log-level=warning --outfile="$out/${entry#*:}.js"
done
"$esbuild" src/style/main.css --bundle --minify --target=chrome111,firefox113,safari16.4 --charset=utf8 --legal-comments=eof \
    --log-level=warning --outfile="$out/app.css"
# three.js keeps its notice in a comment; three-mesh-bvh only in a file.
{
    echo '/*! three-mesh-bvh'
    cat node_modules/three-mesh-bvh/LICENSE
    echo '*/'
    echo '/*! three.js'
    cat node_modules/three/LICENSE
    echo '*/'
} >>"$out/app.js"
cp src/index.html "$out/index.html"
gzip -9nf "$out/begin.js" "$out/app.js" "$out/app.css"
