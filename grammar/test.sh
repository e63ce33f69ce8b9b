#!/usr/bin/env bash
# Generates the tree-sitter parser, runs its corpus, and parses every script of the repository that
# is free of mistakes: examples, golden programs, and the scripts of the parser's own tests.
#
# Wants the command `tree-sitter`, else installs it below target/ with cargo, and `node`, which
# reads grammar.js. What is generated stays below target/; not optimized, the command is there in less than half the time.

set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly VERSION=0.27.1
tools=$PWD/target/tree-sitter
work=$tools/work

skip() {
    echo "the tree-sitter grammar is not tested: $*"
    exit 0
}

command -v node >/dev/null || skip "there is no node to read grammar.js"
command -v cc >/dev/null || skip "there is no C compiler"
if ! command -v tree-sitter >/dev/null; then
    export PATH=$tools/bin:$PATH
fi
if ! command -v tree-sitter >/dev/null; then
    echo "installing tree-sitter-cli $VERSION"
    mkdir -p "$tools"
    # What is used once need not tell of faults in itself, and in few units it is built in two thirds of the time.
    export CARGO_PROFILE_DEV_DEBUG=0 CARGO_PROFILE_DEV_DEBUG_ASSERTIONS=false CARGO_PROFILE_DEV_OVERFLOW_CHECKS=false \
        CARGO_PROFILE_DEV_PANIC=abort CARGO_PROFILE_DEV_CODEGEN_UNITS=4 CARGO_PROFILE_DEV_BUILD_OVERRIDE_CODEGEN_UNITS=4
    cargo install --quiet --debug --locked --no-default-features --version "$VERSION" --root "$tools" tree-sitter-cli ||
        skip "cargo could not install tree-sitter-cli $VERSION"
fi

# The grammar, and the command's own files, out of the way of the sources.
rm -rf "$work"
mkdir -p "$work"
cp -R grammar/tree-sitter-virote/. "$work"
export XDG_CACHE_HOME=$tools/cache XDG_CONFIG_HOME=$tools/config

shopt -s nullglob
printf '%s\n' "$PWD"/examples/*.geo "$PWD"/tests/golden/*.geo "$PWD"/tests/golden/lib/*.geo "$PWD"/tests/syntax/scripts/*.geo >"$tools/scripts"

cd "$work"
tree-sitter generate
tree-sitter test
# Fails if any tree has an ERROR or a MISSING node; then the trees tell where.
tree-sitter parse --quiet --stat --paths "$tools/scripts"
# The queries name only what the grammar has.
for query in queries/*.scm "$OLDPWD"/editors/helix/queries/virote/*.scm "$OLDPWD"/editors/zed/languages/virote/*.scm; do
    tree-sitter query --quiet "$query" "$(head -1 "$tools/scripts")"
done
