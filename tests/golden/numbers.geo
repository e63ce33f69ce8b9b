print 1_000, 1e-3, 0.5, 1e21, 1/3, -0.0, 2^-1, 2^3^2, -2^2, 1e300 * 10
check 2^-1 == 0.5
check 2^3^2 == 512 "the power binds to the right"
check -2^2 == -4
check 7 / 2 == 3.5
check abs(-3) == 3 and sign(-3) == -1 and sign(0) == 0
check floor(-1.5) == -2 and ceil(-1.5) == -1
check round(2.5) == 3 and round(-2.5) == -3 "halves away from zero"
check cbrt(-27) == -3
check ln(e) == 1 and log10(1000) ~= 3 and exp(0) == 1
check clamp(5, 0, 3) == 3
check lerp(2, 4, 0.25) == 2.5
check hypot(3, 4) == 5
check sinh(0) == 0 and cosh(0) == 1 and tanh(0) == 0
check tau == 2 * pi
