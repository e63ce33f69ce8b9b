let width = 3
print widht * 2
curve c = beziér((0, 0), (1, 1))
curve d = bezeir((0, 0), (1, 1))
