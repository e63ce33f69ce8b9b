geo 1
unit m

// What a script in millimetres exported.
print load("lib/data/millimetres.json")
print load("lib/data/furlongs.json")
