import "import-of-itself.geo" as me
print me.x
