let a = 1
export all to "all.obj"
export [] to "none.obj"
