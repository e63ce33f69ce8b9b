check [3, 1, 2] |> sort == [1, 2, 3]
