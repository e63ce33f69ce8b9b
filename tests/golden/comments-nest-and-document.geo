// to the end of the line; /* opens nothing here
let a = 1 /* inside /* nested */ still inside */ let b = 2
/// The sum of both.
/// On two lines.
let c = a /* between */ + b
check c == 3 // at the end
print "/* text */"
