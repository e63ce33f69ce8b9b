let a = 1 / 0
print 3
export report to "review.md"
