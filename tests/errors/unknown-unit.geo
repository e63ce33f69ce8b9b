let a = 12mn
let b = 30degree
unit mile
