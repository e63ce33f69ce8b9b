param neck = 25mm in 8mm..20mm step 0.5mm "Neck radius"
