; Lines are indented by the brackets that are open.

[
  (test)
  (block)
  (list)
  (comprehension)
  (record)
  (point)
  (group)
  (call)
  (with)
] @indent.begin

[")" "]" "}"] @indent.branch @indent.end

[(line_comment) (doc_comment) (block_comment) (string)] @indent.ignore
