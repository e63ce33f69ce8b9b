// --set nekc=15mm
param neck = 13mm in 8mm..20mm
