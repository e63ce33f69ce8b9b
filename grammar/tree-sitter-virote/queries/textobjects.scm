; What is selected, moved over and swapped as one.

(function body: (_) @function.inner) @function.outer
(lambda body: (_) @function.inner) @function.outer
(definition value: (_) @assignment.rhs @assignment.inner) @assignment.outer
(param default: (_) @assignment.rhs @assignment.inner) @assignment.outer
(call) @call.outer
(argument) @parameter.inner
(parameter) @parameter.inner
(test) @class.outer
(block) @block.outer
(comprehension body: (_) @loop.inner) @loop.outer
(if) @conditional.outer
[(line_comment) (block_comment) (doc_comment)] @comment.outer
(number) @number.inner
