let inner = [(1, 2), (2, 2)]
let all_points = [(0, 0), ...inner, (3, 0)]
print all_points
check len(all_points) == 4
check [...[1], ...[2, 3], ...[]] == [1, 2, 3]
check bezier([(0, 0), ...inner, (3, 0)]).points == all_points
