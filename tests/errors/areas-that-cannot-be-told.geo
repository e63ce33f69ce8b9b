let rippled = parametric((u, v) => (u, v, sin(1rad/(u + 0.00001))), 0..1, 0..1)
print area(rippled)
