let k = 10
