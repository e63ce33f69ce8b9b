let r = {if: 1, curve: 2, in: 3, export: 4, not: 5}
print r.if + r.curve + r.in, r.export, r.not
check (1..2).end == 2
