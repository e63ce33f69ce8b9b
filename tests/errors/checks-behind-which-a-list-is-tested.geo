let xs = [1, 2, -3, 4]
let pass = every(xs, x => x > 0)
fn good(ys) = every(ys, y => y > 0)
fn is_good(ys) = len(ys) > 0 and good(ys)
check pass
check every(xs, x => x > 0) == true
check good(xs)
check is_good(xs)
check { let ok = every(xs, x => x > 0); ok }
check if every(xs, x => x > 0) then true else false
check if len(xs) > 2 then every(xs, x => x > 0) else true
check any(xs, x => x < 0) == false
check not good([1, 2])
check len(xs) > 9
fn endless(n) = if n > 0 then false else endless(n)
check endless(1)
print 1 / 0
