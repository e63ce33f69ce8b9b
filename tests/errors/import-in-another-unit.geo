unit mm
import "lib/inches.geo"
