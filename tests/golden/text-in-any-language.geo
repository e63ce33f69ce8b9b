/* comments /* nest */ here */
let größe = 3; let 点 = (größe, 0);
let _private = 1
print größe, 点, "α {点.x} ∞", _private,
check größe == 3 "die Größe stimmt"
