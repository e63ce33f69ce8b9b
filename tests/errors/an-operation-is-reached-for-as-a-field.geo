curve c = line((0, 0), (1, 0))
print c.length
print [1, 2].length
print c.reverse()
