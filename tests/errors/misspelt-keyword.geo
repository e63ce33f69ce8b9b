crve c = bezier((0, 0), (1, 1))
lett a = 1
pirnt a
