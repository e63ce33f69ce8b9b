; What the outline shows; the names of captures are those of Zed.

(param "param" @context name: (identifier) @name) @item
(function "fn" @context name: (identifier) @name) @item
(definition pattern: (identifier) @name) @item
(test "test" @context name: (string) @name) @item
(doc_comment) @annotation
