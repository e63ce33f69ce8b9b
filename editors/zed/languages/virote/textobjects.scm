; What is selected and moved over as one; the names of captures are those of Zed.

(function body: (_) @function.inside) @function.around
(lambda body: (_) @function.inside) @function.around
(test) @class.around
[(line_comment) (block_comment) (doc_comment)]+ @comment.around
