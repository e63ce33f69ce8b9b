// Linkeová: Figure eight of Exercise 2.2 as Bezier cubics (Exercise 2.6)
geo 1
curve k = hermite([(0, 0), (6, 0), (0, 0), (-6, 0), (0, 0)],
  [(9, 9), (0, -9), (-9, 9), (0, -9), (9, 9)])
check decompose(k)[0].points ~= [(0, 0, 0), (3, 3, 0), (6, 3, 0), (6, 0, 0)] within 6e-12
check k(1/2) ~= (33/8, 9/4, 0) within 4.12e-12
check decompose(k)[1].points ~= [(6, 0, 0), (6, -3, 0), (3, -3, 0), (0, 0, 0)] within 6e-12
check k(3/2) ~= (33/8, -9/4, 0) within 4.12e-12
check decompose(k)[2].points ~= [(0, 0, 0), (-3, 3, 0), (-6, 3, 0), (-6, 0, 0)] within 6e-12
check k(5/2) ~= (-33/8, 9/4, 0) within 4.12e-12
check decompose(k)[3].points ~= [(-6, 0, 0), (-6, -3, 0), (-3, -3, 0), (0, 0, 0)] within 6e-12
check k(7/2) ~= (-33/8, -9/4, 0) within 4.12e-12
check continuity(trim(k, 0..1), trim(k, 1..2)).c == 1
check continuity(trim(k, 0..1), trim(k, 1..2)).g >= 2
check continuity(trim(k, 1..2), trim(k, 2..3)).c == 1
check continuity(trim(k, 1..2), trim(k, 2..3)).g == 1
check continuity(trim(k, 2..3), trim(k, 3..4)).c == 1
check continuity(trim(k, 2..3), trim(k, 3..4)).g >= 2
check continuity(trim(k, 3..4), trim(k, 0..1)).c == 1
check continuity(trim(k, 3..4), trim(k, 0..1)).g == 1
