#!/usr/bin/env bash
# Draws the pictures of examples/README.md, all of them or those named.
#
#     examples/gallery.sh FOLDER [NAME...]
#
# FOLDER is examples/gallery for those in the checkout. The command is target/release/virote, or the
# one that $VIROTE names. Pictures are the same bytes on every machine.

set -euo pipefail

virote=$(realpath "${VIROTE:-"$(dirname "${BASH_SOURCE[0]}")/../target/release/virote"}")
mkdir -p "$1"
folder=$(realpath "$1")
shift
cd "$(dirname "${BASH_SOURCE[0]}")"
wanted=" $* "

# draw NAME [OPTION...]: the picture of NAME.geo.
draw() {
    local name=$1
    shift
    if [[ $wanted == "  " || $wanted == *" $name "* ]]; then
        "$virote" render "$name.geo" --out "$folder/$name.png" --size "${size:-480x360}" --quiet "$@"
    fi
}

draw aerofoil --only foil
draw at-sign --only stroke_coons --only bowl_coons
draw bottle --only wall --only foot --only label
draw car-bonnet --only bonnet --only stripes
draw circles --only circles
draw curvature-comb
draw first-steps
draw frigate-hull --only port --only starboard --only waterlines --only frames
draw linkeova-2-3 --only c --only at_half
draw linkeova-2-4 --only before --only after --only parts
draw linkeova-2-7 --only c --only triangle
draw linkeova-exercise-2-26
draw naca --only wing
draw pipe-along-a-curve
draw propeller-blade --only all --only hub
size=400x300 draw teapot --only patches
draw textbook-joints
draw textbook-surfaces --only filled
draw units
draw wheel-hub --only rim --only top --only blend --only shell --only lip --only mouth --only inner --only seal --only holes
draw wigley-hull --only port --only starboard --only lines --only frames
draw wing-and-nacelle --only wing --only nacelle
