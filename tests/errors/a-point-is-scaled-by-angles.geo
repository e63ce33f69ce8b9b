// A point has no product with anything that holds an angle, whatever its power.
let half = 30deg
print (1, 0, 0) * half
print (1, 0, 0) * (half * half)
print (2mm / half) * (1, 0, 0)
print (1, 0, 0) / half ^ 2
print (1, 0, 0) * (half / 1deg) * 2mm
