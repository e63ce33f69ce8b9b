#!/bin/sh
# Builds web/dist from the sources, the same bytes each time: `npm ci` once, then this.
set -eu
cd "$(dirname "$0")"
out=${1:-dist}
[ -d node_modules ] || npm ci --no-audit --no-fund
mkdir -p "$out"
esbuild=node_modules/.bin/esbuild
"$esbuild" src/main.ts --bundle --minify --format=iife --target=es2022 --charset=utf8 --legal-comments=eof \
    --log-level=warning --outfile="$out/app.js"
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
gzip -9nf "$out/app.js" "$out/app.css"
