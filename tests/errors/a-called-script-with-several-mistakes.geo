// All of them are told where it is called.
fn of(n) = script("lib/two-mistakes.geo", n = n).fine
print of(3)
