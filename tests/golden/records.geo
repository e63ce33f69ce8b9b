let part = { name: "rib", at: (1, 2, 3), holes: [{ r: 1 }, { r: 2 }], if: 5 }
print part, part.holes[1].r, part.if, {}
check part.at.y == 2
check part.holes[-1].r == 2
check part.if == 5 "keywords may be labels"
let { name, at } = part
check name == "rib" and at == (1, 2, 3)
check { a: 1, b: 2 } == { a: 1, b: 2 }
check { a: 1 } ~= { a: 1 + 1e-9 }
check { a: 1 } != { a: 2 }
