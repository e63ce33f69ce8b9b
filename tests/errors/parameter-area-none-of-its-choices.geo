// --set plate=3cm^2
unit cm
param plate = 2cm^2 in [1cm^2, 200mm^2, 5]
