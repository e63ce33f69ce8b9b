print [0..10 step 2]
