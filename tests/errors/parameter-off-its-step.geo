// --set neck=13.2mm
param neck = 13mm in 8mm..20mm step 0.5mm "Neck radius"
