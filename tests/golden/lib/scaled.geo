// A number of any dimension, and what comes of it.
param k: number = 1
let doubled = 2*k
