unit mm
// Its unit is called by another name, and two of its faces are none, which is told.
mesh square = load("lib/written-elsewhere.obj")
check area(square) ~= 4
check len(square.faces) == 1
// It says nothing of its unit.
mesh corner = load("lib/without-a-unit.obj")
check area(corner) ~= 2
// Written in another unit, taken as it stands.
check area(load("lib/in-inches.obj")) ~= 2
