; What folds.

[
  (test)
  (function)
  (block)
  (list)
  (comprehension)
  (record)
  (call)
  (with)
  (block_comment)
] @fold

(doc_comment)+ @fold
(line_comment)+ @fold
(import)+ @fold
