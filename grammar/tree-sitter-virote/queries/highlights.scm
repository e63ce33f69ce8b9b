; Colours, by the capture names that editors share.

[
  "geo" "unit" "tolerance" "param" "let" "fn" "check" "print" "export" "import" "test"
  "in" "with" "as" "to" "step" "all" "expect" "error" "within"
] @keyword

["if" "then" "else"] @keyword.conditional
"for" @keyword.repeat
["and" "or" "not"] @keyword.operator

(kind) @type
(unit) @type
(digits) @number
(boolean) @boolean
(none) @constant.builtin
(placeholder) @variable.builtin

(string) @string
(escape) @string.escape
(interpolation ["{" "}"] @punctuation.special)
(format) @string.special

(line_comment) @comment
(block_comment) @comment
(doc_comment) @comment.documentation

[
  "=" "=>" "|>" "==" "!=" "<" "<=" ">" ">=" "~=" "+" "-" "*" "/" "%" "^" ".." "..<" "..."
] @operator

["(" ")" "[" "]" "{" "}"] @punctuation.bracket
["," ":" ";" "."] @punctuation.delimiter

(identifier) @variable
(param name: (identifier) @variable.parameter)
(parameter name: (identifier) @variable.parameter)
(lambda_parameters (identifier) @variable.parameter)
(function name: (identifier) @function)
(call function: (identifier) @function.call)
(call function: (field label: (identifier) @function.call))
(argument label: (identifier) @property)
(pair label: (identifier) @property)
(field label: (identifier) @property)
(import name: (identifier) @module)
