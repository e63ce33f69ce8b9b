print 3
export report to "review.md" with (picture = true)
export report to "plain.md"
