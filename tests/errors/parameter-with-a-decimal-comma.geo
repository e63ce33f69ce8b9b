// --set neck=3,5mm --set n=2,5 --set on=yes --set tilt=?
param neck: length = 10mm
param n: number = 3
param on: bool = true
param tilt: angle = 30deg
