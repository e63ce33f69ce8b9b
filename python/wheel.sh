#!/usr/bin/env bash
# Builds the wheel that is handed out, in ../target/wheels or the folder that is named: optimized when it is linked, and
# small, as everybody loads it.
#
# Wants `maturin`, and packs once more with `advzip` (of AdvanceCOMP), if that is there.

set -euo pipefail

out=${1:+$(realpath "$1")}
cd "$(dirname "${BASH_SOURCE[0]}")"
out=${out:-../target/wheels}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# What is not that small is not inlined: a tenth less room, for about a fifteenth of the time.
flags=("-C" "llvm-args=--inline-threshold=30")
if [[ $(uname -sm) == "Linux x86_64" ]]; then
    # Of rustc's own linker: code that is alike stands together, which packs better.
    flags+=("-C" "link-arg=-Wl,--bp-compression-sort=both")
fi
export RUSTFLAGS="${RUSTFLAGS:-} ${flags[*]}"

maturin build --profile dist --out "$folder" --compression-level 9
wheel=("$folder"/virote-*.whl)
if command -v advzip >/dev/null; then
    advzip --quiet --recompress --shrink-extra "${wheel[0]}"
fi
mkdir -p "$out"
mv "${wheel[0]}" "$out"
echo "$out/${wheel[0]##*/}: $(wc -c <"$out/${wheel[0]##*/}") bytes"
