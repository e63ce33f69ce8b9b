curve c = line((0, 0), (1, 0))
print c(2)
