radius = 10
print radius
