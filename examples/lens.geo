// A lens that brings parallel light to one point: flat where the light comes in, a hyperboloid where it goes
// out. Rays are traced through its surface, and beside it through a sphere of the same curvature.
//
//     virote run lens.geo
//     virote run lens.geo --set focal=30mm --set aperture=40mm
//
// Light runs along z; the flat side lies in z = 0.

geo 1
unit mm
tolerance 1e-9mm

param focal    = 50mm in 20mm..500mm     "Focal length behind the vertex"
param aperture = 40mm in 5mm..60mm       "Diameter"
param rim      = 3mm in 1mm..10mm        "Thickness of the edge"
param index    = 1.5168 in 1.3..2        "Index of refraction; this one of N-BK7 for yellow light"
param density  = 2.51 in 1..7            "Of the glass, in grams for a cubic centimetre"

// Fermat: behind the height r and the sag s of the surface there, the way of the light to the focus is as long
// as along the axis if √(r² + (f + s)²) = f + n s, which is r² = 2 (n - 1) f s + (n² - 1) s². Hecht, Optics, §5.2.
let h = aperture / 2
fn sag(r) = r^2 / ((index - 1) * focal + sqrt((index - 1)^2 * focal^2 + (index^2 - 1) * r^2))
fn slope(r) = r / ((index - 1) * focal + (index^2 - 1) * sag(r))
let middle = rim + sag(h)
let focus  = middle + focal

// That is a hyperbola, exactly a conic: between two edges, with the tangents there, through the vertex.
let top = rim + slope(h) * h
curve section_out = conic((-h, 0, rim), (0, 0, top), (h, 0, rim), sag(h) / (top - middle))
curve profile = trim(section_out, 0.5..1)
check every(linspace(0.5, 1, 11), f = t => profile(t).z ~= middle - sag(profile(t).x * 1mm))

surface out  = revolve(profile) with (color = "#9ecae1")
surface side = cylinder((0, 0, 0), h, rim) with (color = "#9ecae1")
surface flat = disc(XY, h)
let glass = volume([out, side, flat])
print middle, glass
print "the lens weighs {glass / 1cm^3 * density:.2} g and works at f/{focal / aperture:.2}"

// A slice at the depth t below the vertex has the area π r², with r² of Fermat's hyperbola.
let depth = sag(h)
let bulge = pi * ((index - 1) * focal * depth^2 + (index^2 - 1) / 3 * depth^3)
check glass ~= pi * h^2 * rim + bulge within 1e-9 * glass

// A ray leaves the glass by Snell's law for its direction and the normal of the surface, and goes through the
// axis at some z; `way` is how long it takes, as a length in air.
fn refracted(d, normal) = {
    let across = index * (d - dot(d, normal) * normal)
    across + sqrt(1 - dot(across, across)) * normal
}
fn traced(surface_out, r) = {
    let hit = last(intersect(line((r, 0, 0), (r, 0, 2 * top)), surface_out))
    let outward = normal(surface_out, hit.u, hit.v)
    let d = refracted((0, 0, 1), outward * sign(outward.z))
    let z = hit.point.z - hit.point.x * d.z / d.x
    {r, hit: hit.point, z, way: index * hit.point.z + norm((0, 0, z) - hit.point)}
}
let rays = [for k in 1..8: traced(out, k / 8.5 * h)]
check every(rays, ray => ray.z ~= focus within 1e-9 * focal)                          "one focus"
check every(rays, ray => ray.way ~= index * middle + focal within 1e-9 * focal)       "no ray comes late"

// A sphere that is as round at the vertex lets outer rays cross the axis too early: in the triangle of its
// centre, the place where the ray leaves, and where it crosses, the sines are to one another as the sides.
let radius = (index - 1) * focal
surface ball = sphere((0, 0, middle - radius), radius) with (hidden = true)
let limit = min(h, radius / index)
let spherical = [for k in 1..8: traced(ball, k / 8.5 * limit)]
check every(spherical, ray => {
    let inside = asin(ray.r / radius)
    let outside = asin(index * ray.r / radius)
    ray.z ~= middle - radius + radius * sin(outside) / sin(outside - inside) within 1e-9 * focal
})
check traced(ball, 1e-4 * h).z ~= focus within 1e-6 * focal           "near the axis it is the same lens"

table aberration = table([for ray in spherical: {
    height: ray.r,
    sphere: round(ray.z - focus, 3),
    hyperboloid: round(traced(out, ray.r).z - focus, 3),
}])
print aberration

// For the grinder: the form by the height, and how far the sphere would fall below it.
export table([for r in linspace(0, 1, 11): {
    r: r * limit,
    sag: sag(r * limit),
    sphere_below: radius - sqrt(radius^2 - (r * limit)^2) - sag(r * limit),
}]) to "lens-form.csv"
export out, side, flat to "lens.step"

curves light = [
    for k in -5..5 if k != 0: {
        let ray = traced(out, k / 5.5 * h)
        polyline((ray.r, 0, -rim), ray.hit, (0, 0, focus))
    }
] with (color = "orange")
surfaces half = [
    for c in [profile, line((h, 0, rim), (h, 0, 0))]: revolve(c, angle = 180deg)
] with (color = "lightblue")
region section_plane = region([
    section_out,
    polyline((h, 0, rim), (h, 0, 0), (-h, 0, 0), (-h, 0, rim)),
]) with (color = "steelblue")
