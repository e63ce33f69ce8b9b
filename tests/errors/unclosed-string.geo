let name = "frame
print name
