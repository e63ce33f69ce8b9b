// --set neck=1m --set n=2.5 --set on=maybe --set tilt=30
param neck = 13mm in 8mm..20mm
param n: integer = 5
param on = true
param tilt = 30deg
