let area = { let a = 3mm  fn f(x) = x * a  curve c = line((0, 0), (a, 0))  f(c.end.x) }
check area == 9
let late = { let b = a + 1; let a = 1; b }
check late == 2 "a name may be used above its definition, in blocks too"
let pair = { let p = 1; (p, 2) }
check pair == (1, 2) "on one line ; ends a definition"
fn outer(x) = {
    fn inner(y) = if y == 0 then x else inner(y - 1)
    inner(3)
}
check outer(7) == 7 "functions of a block recurse and see what is around them"
