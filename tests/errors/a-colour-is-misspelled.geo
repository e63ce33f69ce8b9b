curve c = line((0, 0), (1, 0)) with (color = "rebeccapurpel")
curve d = line((0, 0), (1, 0)) with (color = "rebeccapurple")
