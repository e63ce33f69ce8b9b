let turn = {angle: 30}
print rotate(line((0, 0), (1, 0)), turn.angle)
