; Lines are indented by the brackets that are open; the names of captures are those of Zed.

(test "}" @end) @indent
(block "}" @end) @indent
(record "}" @end) @indent
(list "]" @end) @indent
(comprehension "]" @end) @indent
(point ")" @end) @indent
(group ")" @end) @indent
(call ")" @end) @indent
(with ")" @end) @indent
