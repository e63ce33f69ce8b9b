import math
let t = import "f.csv"
