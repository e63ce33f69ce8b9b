param below: number = 4.75 in 0..<5
param up_to: number = 5 in 0..<5
param from: length = 0mm in 0mm..<5mm
param as_far_as: length = 5mm in 0mm..<5mm
print below, from
