print fold([1, 2], 5, (list, x) => [...list, x])
