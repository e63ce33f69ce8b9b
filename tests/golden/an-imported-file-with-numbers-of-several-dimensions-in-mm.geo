// One file with parameters whose digits agree and whose dimensions do not: each import has its own.
unit mm
import "lib/scaled.geo" as bare with (k = 5)
import "lib/scaled.geo" as wide with (k = 2mm*2.5mm)
import "lib/scaled.geo" as high with (k = 2mm*2.5mm*1mm)
import "lib/scaled.geo" as again with (k = 5)

print bare.doubled, wide.doubled, high.doubled, again.doubled
check wide.doubled == 10mm*1mm
check high.doubled == 10mm*1mm*1mm
check bare.doubled * 1mm*1mm == wide.doubled
