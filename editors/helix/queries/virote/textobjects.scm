; What is selected and moved over as one; the names of captures are those of Helix.

(function body: (_) @function.inside) @function.around
(lambda body: (_) @function.inside) @function.around
(test) @test.around
(argument) @parameter.inside
(parameter) @parameter.inside
(pair value: (_) @entry.inside) @entry.around
[(line_comment) (block_comment) (doc_comment)] @comment.inside
