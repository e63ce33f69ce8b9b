let width = 3
print "the width is {widht} mm"
