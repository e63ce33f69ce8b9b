#!/bin/sh
# The packed extension in a whole VS Code: code-server, which npm has, in a headless Chromium. 800 MB and some minutes at the
# first time. VIROTE names the command to test (target/release/virote without it).
set -eu
cd "$(dirname "$0")"
VIROTE=${VIROTE:-$PWD/../../target/release/virote}
export VIROTE
# Scripts of packages would compile what is not needed here: terminals of VS Code, its logs, watchers of processes.
[ -d node_modules ] || npm ci --ignore-scripts --no-audit --no-fund
server=node_modules/code-server/lib/vscode
[ -d "$server/node_modules" ] || (cd "$server" && npm install --omit=dev --ignore-scripts --no-audit --no-fund)
../vscode/package.sh
node --test test/*.test.mjs
