// The number after `within` is plain, or has the unit of what it limits.
check 3mm ~= 4mm within 2deg
check 30deg ~= 31deg within 2mm
check (0, 0) ~= (1, 0) within 90deg
check 3mm ~= 4mm within 2
check 3 ~= 4 within 2mm
check 3mm ~= 4mm within 2mm
check (0, 0) ~= (1, 0) within 2mm
