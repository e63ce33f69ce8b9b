#!/usr/bin/env bash
# Builds the wheel that is handed out, in ../target/wheels or the folder that is named: optimized when it is linked, and
# small, as everybody loads it.
#
# Wants `maturin`, and packs once more with `advzip` (of AdvanceCOMP), if that is there.

set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")"
out=${1:-../target/wheels}

# What is not that small is not inlined: it takes no longer, and a tenth less room.
flags=("-C" "llvm-args=--inline-threshold=30")
if [[ $(uname -sm) == "Linux x86_64" ]]; then
    # Of rustc's own linker: code that is alike stands together, which packs better.
    flags+=("-C" "link-arg=-Wl,--bp-compression-sort=both")
fi
export RUSTFLAGS="${RUSTFLAGS:-} ${flags[*]}"

maturin build --profile dist --out "$out" --compression-level 9
wheels=("$out"/virote-*.whl)
if command -v advzip >/dev/null; then
    advzip --recompress --shrink-extra "${wheels[@]}"
fi
for wheel in "${wheels[@]}"; do
    echo "${wheel##*/}: $(wc -c <"$wheel") bytes"
done
