#!/bin/sh
# The language server with real clients: the protocol's own from npm, and Neovim and Emacs where they are installed. Packs the
# extension.
# VIROTE names the command to test (target/debug/virote without it).
set -eu
cd "$(dirname "$0")"
VIROTE=${VIROTE:-$PWD/../target/debug/virote}
export VIROTE
if command -v npm >/dev/null; then
    vscode/test.sh
else
    echo "NOT CHECKED: there is no npm" >&2
fi
if command -v nvim >/dev/null; then
    nvim --headless -u NONE -c 'luafile neovim/test.lua'
else
    echo "NOT CHECKED: there is no Neovim" >&2
fi
if command -v emacs >/dev/null; then
    emacs -q --batch -l emacs/test.el
else
    echo "NOT CHECKED: there is no Emacs" >&2
fi
