let xs = [for i in 0..100000000: i]
