; Lines are indented by the brackets that are open; the names of captures are those of Helix.

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
] @indent

[")" "]" "}"] @outdent
