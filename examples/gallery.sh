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

draw aerofoil --only foil --only measured --show control
draw at-sign --only stroke_clamped --only bowl_clamped --show control
draw bottle --only wall --only foot --only label
draw bottle-volume --camera 160,-420,260 --only walls --only glass_section --only liquid
draw bolt --only bolt
draw car-bonnet --only bonnet --show stripes
draw circles --only circles --show control
draw curvature-comb
draw curvature-map --only map
draw first-steps --show control
draw cut-and-fill --only cut --only fill --only zero --only heights_of_ground --no-edges --camera -120,-160,330 --perspective
draw frigate-hull --only port --only starboard --only waterlines --only frames
draw fuselage --only shell --only port --camera -14,20,7 --perspective
draw handrail --only rail --only treads --only bars --no-isocurves
draw hull-offsets --camera 110,70,30 --perspective --no-isocurves --only port --only starboard --only frames --only waterlines
draw hull-study --only stable --only tender --only chosen --camera 700,0,330 --perspective --no-isocurves --no-edges
draw involute-gear --only pair
draw lens --camera 60,-150,60 --only light --only half --only section_plane
draw linkeova-2-3 --only c --only at_half --show control
draw linkeova-2-4 --only before --only after --only parts --show control
draw linkeova-2-7 --only c --only triangle --show control
draw linkeova-exercise-2-26 --only side_by_side --show control
draw naca --only wing
draw pipe-along-a-curve
draw propeller-blade --only all --only hub
size=400x300 draw teapot --only patches
draw road --only carriageway --only centre --camera 60,-200,420 --perspective --no-isocurves
draw textbook-joints --show control
draw textbook-surfaces --only filled --show control
draw units
draw gasket --only gasket --only path
draw cut-hull --only wetted --only waterplane --only dry
draw glyph --only stencil
draw lampshade --only shade
draw laser-box --only drawing
draw wind-blade --camera -6,-14,2 --perspective --only rotor
draw wing-root --only outer --only skin_of_body --only joint
draw wheel-hub --only rim --only top --only blend --only shell --only lip --only mouth --only inner --only seal --only holes
draw wigley-hull --only port --only starboard --only lines --only frames
draw wing-and-nacelle --only wing --only nacelle
