let mean = 3
fn length(x) = 2 * x
check mean == 3
check length(2) == 4
check { let pi = 3 pi } == 3
