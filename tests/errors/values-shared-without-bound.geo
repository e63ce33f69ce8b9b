// Each step doubles what the one before it holds; nothing could print or compare the result.
fn lists(n) = if n == 0 then [1] else { let half = lists(n - 1); [half, half] }
fn texts(n) = if n == 0 then "x" else { let half = texts(n - 1); "{half}{half}" }
let deep = lists(40)
let long = texts(40)
