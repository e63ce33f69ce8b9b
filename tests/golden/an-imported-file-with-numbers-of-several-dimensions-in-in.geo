// One file with parameters whose digits agree and whose dimensions do not: each import has its own.
unit in
import "lib/scaled.geo" as bare with (k = 5)
import "lib/scaled.geo" as wide with (k = 2in*2.5in)
import "lib/scaled.geo" as high with (k = 2in*2.5in*1in)
import "lib/scaled.geo" as again with (k = 5)

print bare.doubled, wide.doubled, high.doubled, again.doubled
check wide.doubled == 10in*1in
check high.doubled == 10in*1in*1in
check bare.doubled * 1in*1in == wide.doubled
