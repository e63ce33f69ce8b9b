; Brackets that belong together; the names of captures are those of Zed.

("(" @open ")" @close)
("[" @open "]" @close)
("{" @open "}" @close)
