check any([1, 2, 3], x => x > 5)
check any([], x => x > 5)
check not any([1, 2, 3], x => x > 2)
