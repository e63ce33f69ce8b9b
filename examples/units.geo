// Lengths, angles and parameters.
//
//     virote run units.geo
//     virote run units.geo --set width=1in --set slope=0.125turn

geo 1
unit mm // the unit of every length without a unit, and of the files

// Inputs of the script. The range, the step and the text belong to the parameter;
// a value from the command line must respect them.
param width = 60mm in 10mm..200mm "Width of the gable"
param slope = 30deg in 5deg..80deg "Pitch of the roof"
param tiles: integer = 12 in 1..100 "Rows of tiles on one side"

// A length times a number is a length; a length times a length is an area.
let rise = width / 2 * tan(slope)
let side = hypot(width / 2, rise)
let area = width * rise / 2

print rise, side, area
print side / tiles

// Angles need their unit where an angle is wanted; inverse functions answer with angles.
print atan2(rise, width / 2)
check atan2(rise, width / 2) ~= slope                     "the pitch comes back"

// The same length in other units.
check 1in == 25.4mm
check 1m == 100cm and 1cm == 10_000um
check 1turn ~= 360deg and 180deg ~= pi

// A length and an angle do not add up: `width + slope` is an error that shows both.
// A bare number counts as the document's unit wherever a length is wanted.
check width == width + 0

curve roof = polyline((-width / 2, 0), (0, rise), (width / 2, 0))

check angle_between(tangent(roof, 0), (1, 0)) ~= slope    "the curve has the pitch that was asked for"
check length(roof) ~= 2 * side

// Questions about geometry answer in bare document units, which fit anywhere.
check bounds(roof).max.y ~= rise

export roof to "roof.obj"
