let m = load("data/missing.xls")
