curve nothing = arc((0, 0), 2, 30deg, 30deg)
curve too_long = arc((0, 0), 2, 0deg, 400deg)
curve bare = arc((0, 0), 2, 0, 90)
curve no_axis = arc((0, 0), 2, 0deg, 90deg, x = (0, 0, 3))
