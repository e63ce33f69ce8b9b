unit cm
param plate = 150mm^2 in 2cm^2..100mm^2
