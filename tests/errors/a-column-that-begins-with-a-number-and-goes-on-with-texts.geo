let t = load("data/stations.csv")
