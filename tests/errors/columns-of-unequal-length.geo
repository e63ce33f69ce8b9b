table t = table({ x: [1, 2, 3], y: [1, 2] })
table u = table([{ a: 1 }, { b: 2 }])
