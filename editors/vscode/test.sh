#!/bin/sh
# Packs the extension, and tests its parts and the language server with the protocol's own client.
# VIROTE names the command to test (target/debug/virote without it).
set -eu
cd "$(dirname "$0")"
./package.sh
VIROTE=${VIROTE:-$PWD/../../target/debug/virote} node --test test/*.test.mjs
