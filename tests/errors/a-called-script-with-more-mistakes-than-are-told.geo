// Five are told, with how many are left; of five none are.
fn of(n) = script("lib/seven-mistakes.geo", n = n).fine
print of(3)
print script("lib/five-mistakes.geo").fine
