// The imports of a test do not shift those of the file.
test "first" {
    import "missing.geo"
    import "lib/util.geo" as tools
    check tools.nothing == 1
}
import "lib/util.geo" (elephant)
print elephant
