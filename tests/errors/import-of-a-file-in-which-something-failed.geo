// What did not fail in an imported file is there, and what uses the rest is silent.
import "lib/partly-wrong.geo" as lib
import "lib/partly-wrong.geo" (good, further)
print lib.good, lib.bad, lib.twice(2), lib.worse(1)
print length(lib.c)
print lib, lib.further
print good, further
fn more(x) = x + lib.good
fn fails(x) = x + lib.worse(x)
print more(4), fails(4)
let whole = lib
print whole.good
import "lib/one-failed.geo" as other
print other.good, other.bad
// What it never had is a mistake of its own.
print other.gut
// Of a text with a mistake in its form nothing is used: names may mean something else.
import "lib/garbled.geo" as garbled
print garbled.a, garbled.b
