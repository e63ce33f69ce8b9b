"""The operations of the language as functions of Python.

Written by ``generate.py`` from the registry of the library; not by hand.
"""

from __future__ import annotations

from ._session import _called, _called_for

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any, overload

    from ._geometry import (
        Curve,
        Face,
        FloatArray,
        Frame,
        FunctionLike,
        Mesh,
        PointLike,
        PointsLike,
        Quantity,
        Region,
        Solid,
        Surface,
        Table,
    )

__all__: list[str] = [
    "acos",
    "angle_between",
    "approximate",
    "arc",
    "arc_tangent",
    "arc_through",
    "area",
    "argmax",
    "argmin",
    "arrows",
    "asin",
    "at",
    "atan",
    "atan2",
    "basis",
    "basis_table",
    "beta_spline",
    "bezier",
    "bilinear",
    "binormal",
    "binormal_line",
    "bodies",
    "border",
    "bounds",
    "box",
    "bspline",
    "cbrt",
    "ceil",
    "center_of_curvature",
    "centroid",
    "check_mesh",
    "circle",
    "clamp",
    "clamped",
    "classify",
    "closest",
    "compatible",
    "cone",
    "conic",
    "conic_kind",
    "contains",
    "continue_bezier",
    "continuity",
    "contours",
    "control_net",
    "control_polygon",
    "coons",
    "coons_bicubic",
    "coons_bspline",
    "coons_cubic",
    "corner_surface",
    "corners",
    "cos",
    "cosh",
    "cosspace",
    "cross",
    "cubic_spline",
    "curvature",
    "curvature_comb",
    "curvature_map",
    "curvature_table",
    "cusps",
    "cut",
    "cylinder",
    "de_casteljau",
    "decompose",
    "derivative",
    "describe",
    "deviation",
    "difference",
    "disc",
    "distance",
    "divide",
    "dot",
    "edge",
    "edge_surface",
    "edges",
    "edit_points",
    "elevate",
    "ellipse",
    "every",
    "exp",
    "extend",
    "extrema",
    "extrude",
    "face",
    "faces",
    "ferguson",
    "fillet",
    "first",
    "first_form",
    "flatten",
    "flip",
    "floor",
    "fold",
    "frame",
    "frame_of",
    "gaussian",
    "genus",
    "gordon",
    "gradient",
    "greville",
    "grid_mesh",
    "helix",
    "hermite",
    "hodograph",
    "hyperbolic_paraboloid",
    "hypot",
    "index_of",
    "inertia",
    "inflections",
    "insert_knot",
    "integrate",
    "interpolate",
    "intersect",
    "intersection",
    "is_closed",
    "is_developable",
    "is_minimal",
    "is_planar",
    "is_straight",
    "isophotes",
    "join",
    "knot_class",
    "knot_points",
    "lagrange",
    "last",
    "length",
    "lerp",
    "line",
    "line_tangent",
    "linspace",
    "ln",
    "load",
    "loft",
    "log10",
    "lower",
    "maximize",
    "mean",
    "mesh",
    "midpoint",
    "minimize",
    "mirror",
    "norm",
    "normal",
    "normal_curvature",
    "normal_line",
    "normal_plane",
    "num",
    "nurbs",
    "ode",
    "offset",
    "orient",
    "osculating_circle",
    "osculating_plane",
    "pad",
    "parameter_at_length",
    "parametric",
    "place",
    "planar_mesh",
    "plane",
    "plane_patch",
    "polar",
    "polyline",
    "polynomial",
    "power_coefficients",
    "principal",
    "product",
    "project",
    "radius_of_curvature",
    "random",
    "rectifying_plane",
    "reduce",
    "refine",
    "reflection_lines",
    "region",
    "regions",
    "remove_knot",
    "reparametrize",
    "replace",
    "report",
    "reverse",
    "reverse_u",
    "reverse_v",
    "revolve",
    "reweight",
    "rotate",
    "ruled",
    "sample",
    "scale",
    "scan",
    "second_form",
    "section",
    "self_intersections",
    "shells",
    "sign",
    "signed_curvature",
    "sin",
    "sinh",
    "skin",
    "solid",
    "solve",
    "sort",
    "sphere",
    "split",
    "sqrt",
    "standard_form",
    "station",
    "substring",
    "swap_uv",
    "sweep",
    "swung",
    "table",
    "tan",
    "tangent",
    "tangent_line",
    "tangent_plane",
    "tangent_u",
    "tangent_v",
    "tanh",
    "tessellate",
    "to_bezier",
    "to_clamped",
    "to_coons",
    "to_hermite",
    "to_nurbs",
    "torsion",
    "torus",
    "transform",
    "translate",
    "transpose",
    "trim",
    "twist",
    "union",
    "unique",
    "unit_vector",
    "upper",
    "vertices",
    "volume",
    "wireframe",
    "zebra",
]

#: Operations called like functions of Python; here they end in a stroke.
SHADOWS = [
    "abs",
    "any",
    "assert",
    "filter",
    "format",
    "len",
    "map",
    "max",
    "min",
    "range",
    "reversed",
    "round",
    "str",
    "sum",
    "zip",
]


def abs_(x: Quantity) -> float:
    """Magnitude of a number, without its sign.

    :param x: A number of any dimension.

    In scripts: ``abs(x: number) -> number``
    """
    return _called("abs", (), {"x": x})  # type: ignore[no-any-return]


def acos(x: float) -> float:
    """The angle whose cosine is `x`.

    :param x: A number from -1 to 1.

    In scripts: ``acos(x: number) -> angle``
    """
    return _called("acos", (), {"x": x})  # type: ignore[no-any-return]


def angle_between(a: PointLike, b: PointLike) -> float:
    """Angle between two vectors, from 0 to 180 degrees.

    Kahan's formula by half differences of the unit vectors, exact also where they nearly agree or oppose.

    :param a: One vector that is not zero.
    :param b: The other one.

    In scripts: ``angle_between(a: point, b: point) -> angle``
    """
    return _called("angle_between", (), {"a": a, "b": b})  # type: ignore[no-any-return]


def any_(list: Any, f: FunctionLike | None = None) -> bool:
    """Whether the test holds for some element; of an empty list it is false.

    :param list: The list; a range of whole numbers counts as one.
    :param f: The test; left out where the elements are true or false themselves.

    In scripts: ``any(list: list of values, f: function = none) -> bool``
    """
    return _called("any", (), {"list": list, "f": f})  # type: ignore[no-any-return]


def approximate(*args: Any, points: Any = None, degree: Any = None, control_points: Any = None, tolerance: Any = None, parameters: Any = None, second_pass: Any = None) -> Any:
    """Spline near points, through the first and the last, on 0..1 or over the parameters that
    are listed.

    One of `control_points` and `tolerance` is given. With `control_points` it is the one whose
    squared distances at the parameters sum to least, over knots that spread the parameters
    evenly. With `tolerance` it comes that near to every point, with as few control points as
    are found; it moves the parameters along the curve unless they are listed, and has corners
    where the points turn sharply, if that takes no more control points. Points that scatter by more
    than the tolerance are followed one by one, without detours, which gives a warning. `report` has
    `{control_points, deviation, corners, parameters}`. Piegl & Tiller, *The NURBS Book*,
    §9.4.1, (9.68), (9.69); Hoschek & Lasser, *Fundamentals of Computer Aided Geometric
    Design*, §4.4.

    :param points: The points, more than the degree.
    :param degree: The degree. Default: ``3``.
    :param control_points: How many control points, from degree + 1 to the number of points.
    :param tolerance: How far the curve may pass from a point.
    :param parameters: Where on the curve the points lie: by a rule, or listed. Default: ``"chord"``.

    In scripts: ``approximate(points: list of points, degree: integer = 3, control_points: integer = none, tolerance: length = none, parameters: "uniform" | "chord" | "centripetal" | "foley" | list of numbers without units = "chord") -> curve``

    Spline surface near a grid of points, through its corners, on 0..1 by 0..1 or over the
    parameters that are listed.

    One of `control_points` and `tolerance` is given. Least squares along u, then along v of the
    control points found: with `control_points` over knots that spread the parameters evenly; with
    `tolerance` over knots that are added where points are missed and taken away where they are not
    needed, until every point is that near to the surface at its parameters and no knot can go.
    `report` has `{degree, control_points, deviation, parameters}`.
    Piegl & Tiller, *The NURBS Book*, §9.4.3, A9.7; Lyche & Mørken, *Knot removal for parametric
    B-spline curves and surfaces*, CAGD 4 (1987).
    :param points: The points: `points[i][j]`, i along u, j along v.
    :param degree: The degree, or `{u: , v: }`. Default: ``3``.
    :param control_points: How many control points, or `{u: , v: }`: from degree + 1 to the number of points.
    :param tolerance: How far the surface may pass from a point.
    :param parameters: Where the points lie, by a rule or listed; for both directions or `{u: , v: }`. Default: ``"chord"``.
    :param second_pass: Whose distances give the parameters along v. Default: ``"data"``.

    In scripts: ``approximate(points: grid of points, degree: integer | record = 3, control_points: integer | record = none, tolerance: length = none, parameters: "uniform" | "chord" | "centripetal" | "foley" | list of numbers without units | record = "chord", second_pass: "data" | "control" = "data") -> surface``
    """
    return _called("approximate", args, {"points": points, "degree": degree, "control_points": control_points, "tolerance": tolerance, "parameters": parameters, "second_pass": second_pass})


def arc(center: PointLike, radius: Quantity, from_: Quantity, to: Quantity, *, normal: PointLike | None = None, x: PointLike | None = None) -> Curve:
    """Exact arc of a circle as a rational curve on 0..1, in equal pieces of at most a quarter
    turn.

    It runs counter-clockwise about the normal from the angle `from` up to the angle `to`, or
    where that is less up to its next place, once around at most; angles count from x, which is (1, 0, 0) made normal to the normal unless
    given, or (0, 1, 0) where those are parallel. Piegl & Tiller, *The NURBS Book*, A7.1.

    :param center: The centre of its circle.
    :param radius: Its radius, positive.
    :param from_: The angle at which it starts.
    :param to: The angle at which it ends; `from + 1turn` makes the full circle.
    :param normal: The direction that it runs around. Default: ``(0, 0, 1)``.
    :param x: The direction of angle zero; its part normal to the normal counts.

    In scripts: ``arc(center: point, radius: length, from: angle, to: angle, normal: point = (0, 0, 1), x: point = none) -> curve``
    """
    return _called("arc", (), {"center": center, "radius": radius, "from_": from_, "to": to, "normal": normal, "x": x})  # type: ignore[no-any-return]


def arc_tangent(a: PointLike | Curve, b: PointLike | Curve, radius: Quantity, *, near: PointLike | None = None, long: bool | None = None) -> Curve | list[Curve]:
    """Exact arcs of a radius from a point or curve to another that touch each curve where they end: all of them, as a
    list in the order of the parameters of the places of contact, or the one that comes nearest to the point `near`.

    Both lie in one plane. An arc touches where the curve is, its ends included, but not in a corner; a point it
    goes through. Of each circle it is the shorter arc, with `long = true` the rest of it. Centres are found where
    offsets of the curves by the radius meet, which is complete up to the document's tolerance, and made exact by
    Newton's method. Curves that run alongside at twice the radius have as many arcs as places, which is an error.

    :param a: Where it starts: a point, or a curve that it touches.
    :param b: Where it ends.
    :param radius: Its radius, positive.
    :param near: A point to which the one that is meant comes nearest.
    :param long: Whether it goes the longer way around. Default: ``false``.

    In scripts: ``arc_tangent(a: point | curve, b: point | curve, radius: length, near: point = none, long: bool = false) -> curve | list of curves``
    """
    return _called("arc_tangent", (), {"a": a, "b": b, "radius": radius, "near": near, "long": long})  # type: ignore[no-any-return]


def arc_through(a: PointLike, b: PointLike, c: PointLike) -> Curve:
    """Exact arc of a circle from `a` by way of `b` to `c`, on 0..1.

    In equal pieces of at most a quarter turn, like `arc`.

    :param a: Where it starts.
    :param b: A point on the way.
    :param c: Where it ends.

    In scripts: ``arc_through(a: point, b: point, c: point) -> curve``
    """
    return _called("arc_through", (), {"a": a, "b": b, "c": c})  # type: ignore[no-any-return]


def area(*args: Any, s: Any = None, r: Any = None, m: Any = None) -> float:
    """Area of a surface or face, or of several together.

    The integral of |Su × Sv|, to some 12 digits where the surface is smooth.

    :param s: The surface or face, or a list of them.

    In scripts: ``area(s: surface | face | list of surfaces or faces) -> area``

    Area of a region: Green's theorem along its borders, to rounding.
    :param r: The region.

    In scripts: ``area(r: region) -> area``

    Area of all faces of a solid, those of its voids among them.
    :param s: The solid.

    In scripts: ``area(s: solid) -> area``

    Area of a mesh: the sum over its triangles.
    :param m: The mesh.

    In scripts: ``area(m: mesh) -> area``
    """
    return _called("area", args, {"s": s, "r": r, "m": m})  # type: ignore[no-any-return]


def argmax(list: Any, *, by: FunctionLike | None = None) -> float:
    """Index of the greatest number of a list, the first of equal ones.

    :param list: Numbers of one dimension, or strings.
    :param by: A function whose value decides, instead of the element itself.

    In scripts: ``argmax(list: list of values, by: function = none) -> integer``
    """
    return _called("argmax", (), {"list": list, "by": by})  # type: ignore[no-any-return]


def argmin(list: Any, *, by: FunctionLike | None = None) -> float:
    """Index of the least number of a list, the first of equal ones.

    :param list: Numbers of one dimension, or strings.
    :param by: A function whose value decides, instead of the element itself.

    In scripts: ``argmin(list: list of values, by: function = none) -> integer``
    """
    return _called("argmin", (), {"list": list, "by": by})  # type: ignore[no-any-return]


def arrows(g: Any, field: str, *, samples: float | None = None, scale: float | None = None, head: float | None = None) -> list[Curve]:
    """Arrows that show vectors of a curve or surface, each from its point.

    Along a curve `"derivative"`, `"second"` (derivative), `"tangent"`, `"normal"` and
    `"binormal"`; over a surface `"tangent_u"`, `"tangent_v"`, `"twist"` and `"normal"`. Tangents
    and normals are unit vectors. Where there is no such vector there is no arrow.

    An arrow is one polyline that starts at the point and ends at the tip: the segment, and around
    its head, a triangle two thirds as wide as long. The head lies in the osculating plane of the
    curve, that of a flat curve's arrow in the curve's plane, and in the tangent plane of the surface,
    if the vector does. A vector of length zero has no head; with `head = 0` none has, and
    arrows are segments.

    :param g: A curve or surface, or a list of them.
    :param field: Which vectors.
    :param samples: How many along a curve, and in each direction of a surface; two or more. Default: ``20``.
    :param scale: Length of a unit vector. Default: ``1``.
    :param head: Length of the head as a part of the arrow's, from 0, which draws none, to 1. Default: ``0.2``.

    In scripts: ``arrows(g: geometry, field: "derivative" | "second" | "tangent" | "normal" | "binormal" | "tangent_u" | "tangent_v" | "twist", samples: integer = 20, scale: number = 1, head: number = 0.2) -> list of curves``
    """
    return _called("arrows", (), {"g": g, "field": field, "samples": samples, "scale": scale, "head": head})  # type: ignore[no-any-return]


def asin(x: float) -> float:
    """The angle whose sine is `x`.

    :param x: A number from -1 to 1.

    In scripts: ``asin(x: number) -> angle``
    """
    return _called("asin", (), {"x": x})  # type: ignore[no-any-return]


def assert_(condition: bool, message: str) -> bool:
    """The condition, if it holds; else an error with the message. For conditions on the arguments of functions; claims about results are for `check`.

    :param condition: What must hold.
    :param message: What to say if it does not.

    In scripts: ``assert(condition: bool, message: string) -> bool``
    """
    return _called("assert", (), {"condition": condition, "message": message})  # type: ignore[no-any-return]


def at(*args: Any, c: Any = None, t: Any = None, s: Any = None, u: Any = None, v: Any = None) -> FloatArray:
    """Point of a curve at a parameter; `c(t)` is the same.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.

    In scripts: ``at(c: curve, t: number) -> point``

    Point of a surface at its parameters; `s(u, v)` is the same.
    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``at(s: surface | face, u: number, v: number) -> point``
    """
    return _called("at", args, {"c": c, "t": t, "s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def atan(x: float) -> float:
    """The angle between -90 and 90 degrees whose tangent is `x`.

    :param x: A number.

    In scripts: ``atan(x: number) -> angle``
    """
    return _called("atan", (), {"x": x})  # type: ignore[no-any-return]


def atan2(y: Quantity, x: Quantity) -> float:
    """The angle from the x-axis to the direction (x, y), from -180 to 180 degrees; zero for no direction.

    :param y: The y-coordinate.
    :param x: The x-coordinate.

    In scripts: ``atan2(y: length, x: length) -> angle``
    """
    return _called("atan2", (), {"y": y, "x": x})  # type: ignore[no-any-return]


def basis(c: Curve, t: float) -> FloatArray:
    """Values at a parameter of the functions that blend a curve's control points, one a point.

    They sum to one. With weights they are the rational ones, so that the point of the curve
    is always the sum of points times values.
    Piegl & Tiller, *The NURBS Book*, (2.5) and (4.2).

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.

    In scripts: ``basis(c: curve, t: number) -> list of numbers``
    """
    return _called_for(1, "basis", (), {"c": c, "t": t})  # type: ignore[no-any-return]


def basis_table(c: Curve, *, samples: float | None = None) -> Table:
    """Table of the basis functions of a curve: `t`, and a column for each control point, `n0`,
    `n1` and so on.

    Of a rational curve the rational basis, so that the curve is always the sum of its points
    times their functions. Samples are evenly spaced in the parameter, both ends among them.
    Piegl & Tiller, *The NURBS Book*, (2.5) and (4.2).

    :param c: The curve.
    :param samples: How many rows, two or more. Default: ``100``.

    In scripts: ``basis_table(c: curve, samples: integer = 100) -> table``
    """
    return _called("basis_table", (), {"c": c, "samples": samples})  # type: ignore[no-any-return]


def beta_spline(*args: Any, points: Any = None, bias: Any = None, tension: Any = None, closed: Any = None) -> Curve:
    """Barsky's uniformly shaped cubic Beta-spline, one unit of parameter a segment.

    Segments meet with one tangent and one curvature vector (G2). Behind a joint the
    derivative is `bias` times the one before it; `tension` pulls the curve towards its
    points. Bias 1 and tension 0 give the Coons cubic B-spline; below tension 0 the curve may
    leave the hull of its points. A closed one begins with the segment of points 0 to 3.
    Barsky, *The Beta-spline*, University of Utah 1981.

    :param points: The control points: four or more, for a closed curve three or more.
    :param bias: The ratio of the derivatives behind and before a joint, positive. Default: ``1``.
    :param tension: How strongly the points attract the curve. Default: ``0``.
    :param closed: Whether the curve closes without a seam. Default: ``false``.

    In scripts: ``beta_spline(points: list of points, bias: number = 1, tension: number = 0, closed: bool = false) -> curve``
    """
    return _called("beta_spline", args, {"points": points, "bias": bias, "tension": tension, "closed": closed})  # type: ignore[no-any-return]


def bezier(*args: Any, points: Any = None, weights: Any = None) -> Any:
    """Bézier curve of a control polygon, of degree one less than its points, on 0..1.

    It starts at the first point and ends at the last, tangent to the polygon there, and lies
    in the convex hull of its points. One point makes a curve of degree 0.
    Piegl & Tiller, *The NURBS Book*, §1.3.

    :param points: The control points, as a list or as the arguments themselves.
    :param weights: A weight for each point; without them the curve is polynomial.

    In scripts: ``bezier(points: list of points, weights: list of numbers without units = none) -> curve``

    Bézier surface of a grid of control points, on 0..1 in both directions.

    Its degrees are one less than the numbers of rows and of points in a row; its corners are
    the grid's. Piegl & Tiller, *The NURBS Book*, §1.5.
    :param points: The control points: `points[i][j]`, i along u, j along v.
    :param weights: A weight for each point, in the same grid; without them the surface is polynomial.

    In scripts: ``bezier(points: grid of points, weights: list of lists of numbers without units = none) -> surface``
    """
    return _called("bezier", args, {"points": points, "weights": weights})


def bilinear(p00: PointLike, p01: PointLike, p10: PointLike, p11: PointLike) -> Surface:
    """Surface of four corners, ruled by straight lines in both directions.

    The first index of a corner runs along u. Its corners in one plane make a plane piece, else
    it is a hyperbolic paraboloid. Piegl & Tiller, *The NURBS Book*, §8.3.

    :param p00: The corner at u = 0, v = 0.
    :param p01: The corner at u = 0, v = 1.
    :param p10: The corner at u = 1, v = 0.
    :param p11: The corner at u = 1, v = 1.

    In scripts: ``bilinear(p00: point, p01: point, p10: point, p11: point) -> surface``
    """
    return _called("bilinear", (), {"p00": p00, "p01": p01, "p10": p10, "p11": p11})  # type: ignore[no-any-return]


def binormal(c: Curve, t: float, *, side: str | None = None) -> FloatArray:
    """Unit binormal of a curve: tangent × principal normal, the axis that it turns about.

    Where the curve is straight there is none. Frenet's frame; do Carmo, *Differential Geometry of
    Curves and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``binormal(c: curve, t: number, side: "right" | "left" = "right") -> point``
    """
    return _called("binormal", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def binormal_line(c: Curve, t: float, *, length: Quantity | None = None, side: str | None = None) -> Curve:
    """Segment from a point of a curve along its binormal.

    Where the curve is straight there is none.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param length: Its length; a negative one runs the other way. Default: ``1``.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``binormal_line(c: curve, t: number, length: length = 1, side: "right" | "left" = "right") -> curve``
    """
    return _called("binormal_line", (), {"c": c, "t": t, "length": length, "side": side})  # type: ignore[no-any-return]


def bodies(s: Solid) -> list[Solid]:
    """The bodies of a solid, each a solid: an outer shell, with the voids directly within it.

    What lies in a void is a body of its own.

    :param s: The solid.

    In scripts: ``bodies(s: solid) -> list of solids``
    """
    return _called("bodies", (), {"s": s})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def border(s: Surface) -> Curve: ...

    @overload
    def border(m: Mesh) -> list[Curve]: ...


def border(*args: Any, s: Any = None, m: Any = None) -> Any:
    """Boundary of a surface as one closed curve, counter-clockwise about its normal from the
    corner where both parameters start.

    Exact, of the highest degree of the sides: along the first v, the last u, back along the
    last v and the first u. A side that is one point, such as that at a pole, is left out; the
    seam of a closed surface is run along in both directions.

    :param s: The surface.

    In scripts: ``border(s: surface) -> curve``

    Boundary of a mesh as polylines, the mesh to the left of each; none of one that is closed.

    Vertices within the document's tolerance are one, so that seams and creases are no boundary.
    The polylines are closed, but for those that end where more than two triangles meet in an
    edge. Such that touch in a vertex are several.
    :param m: The mesh.

    In scripts: ``border(m: mesh) -> list of curves``
    """
    return _called("border", args, {"s": s, "m": m})


def bounds(g: Any) -> dict[str, Any]:
    """Smallest box along the axes around geometry, as `{min, max}`; of a list around all of it.

    It touches curves and surfaces themselves, not only their control points.
    Of a parametric curve it goes through its extrema, as `extrema` finds them; of a parametric
    surface it is that of a spline within 1e-8 of its size, or 1e-5 where that
    takes too many patches.

    :param g: A point, curve, surface or mesh, or a list of them.

    In scripts: ``bounds(g: geometry) -> record``
    """
    return _called("bounds", (), {"g": g})  # type: ignore[no-any-return]


def box(corner: PointLike, size: Quantity | PointLike) -> list[Surface]:
    """Six flat sides of a box along the axes, in the order lower x, upper x, lower y, upper y,
    lower z, upper z.

    Each is on 0..1 in both directions, with Su × Sv outward.

    :param corner: The corner with the lowest coordinates.
    :param size: Its extents along x, y and z as a point, all positive; one number makes a cube.

    In scripts: ``box(corner: point, size: length | point) -> list of surfaces``
    """
    return _called("box", (), {"corner": corner, "size": size})  # type: ignore[no-any-return]


def bspline(*args: Any, points: Any = None, degree: Any = None, knots: Any = None, closed: Any = None) -> Any:
    """B-spline of control points on given knots, or on uniform clamped ones over 0..1.

    A closed one is periodic over 0..1: it has as many segments as points, three or more, begins
    with the segment of the first points, and its seam is as smooth as its other joints. Piegl & Tiller, *The NURBS Book*, §3.2.

    :param points: The control points, more than the degree.
    :param degree: The degree. Default: ``3``.
    :param knots: All knots: one more than points and degree together; a closed curve makes its own.
    :param closed: Whether the curve closes without a seam. Default: ``false``.

    In scripts: ``bspline(points: list of points, degree: integer = 3, knots: list of numbers without units = none, closed: bool = false) -> curve``

    B-spline surface of a grid on given knots, or on uniform clamped ones over 0..1.

    Piegl & Tiller, *The NURBS Book*, §3.4.
    :param points: The control points: `points[i][j]`, i along u, j along v.
    :param degree: The degree, or `{u: , v: }`. Default: ``3``.
    :param knots: All knots, for both directions or `{u: , v: }`.

    In scripts: ``bspline(points: grid of points, degree: integer | record = 3, knots: list of numbers without units | record = none) -> surface``
    """
    return _called("bspline", args, {"points": points, "degree": degree, "knots": knots, "closed": closed})


def cbrt(x: Quantity) -> float:
    """Cube root; of a volume it is a length.

    :param x: A number.

    In scripts: ``cbrt(x: number) -> number``
    """
    return _called("cbrt", (), {"x": x})  # type: ignore[no-any-return]


def ceil(x: Quantity) -> float:
    """The smallest whole number that is not below `x`.

    :param x: A number that is no angle.

    In scripts: ``ceil(x: number) -> number``
    """
    return _called("ceil", (), {"x": x})  # type: ignore[no-any-return]


def center_of_curvature(c: Curve, t: float, *, side: str | None = None) -> FloatArray:
    """Centre of the osculating circle of a curve: its point plus the radius along the principal normal.

    Where the curve is straight there is none.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``center_of_curvature(c: curve, t: number, side: "right" | "left" = "right") -> point``
    """
    return _called("center_of_curvature", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def centroid(*args: Any, f: Any = None, s: Any = None, of: Any = None, r: Any = None, m: Any = None, points: Any = None) -> FloatArray:
    """Centre of gravity of a face, as of a skin.

    :param f: The face.

    In scripts: ``centroid(f: face) -> point``

    Centre of gravity of what closed surfaces enclose, or of the surfaces themselves.

    Of the volume the surfaces must close, as for `volume`; of the area they need not.
    Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).
    :param s: The surface, or a list of surfaces.
    :param of: What is heavy: the inside or the skin. Default: ``"volume"``.

    In scripts: ``centroid(s: surface | list of surfaces or faces, of: "volume" | "area" = "volume") -> point``

    Centre of gravity of a region.
    :param r: The region.

    In scripts: ``centroid(r: region) -> point``

    Centre of gravity of a solid, or of its faces.
    :param s: The solid.
    :param of: What is heavy: the inside or the skin. Default: ``"volume"``.

    In scripts: ``centroid(s: solid, of: "volume" | "area" = "volume") -> point``

    Centre of gravity of what a closed mesh encloses, or of its triangles.

    Of the volume the mesh must close, as for `volume`; of the area it need not.
    :param m: The mesh.
    :param of: What is heavy: the inside or the skin. Default: ``"volume"``.

    In scripts: ``centroid(m: mesh, of: "volume" | "area" = "volume") -> point``

    Mean of some points, all of the same weight.
    :param points: The points, as a list or as the arguments themselves.

    In scripts: ``centroid(points: list of points) -> point``
    """
    return _called("centroid", args, {"f": f, "s": s, "of": of, "r": r, "m": m, "points": points})  # type: ignore[no-any-return]


def check_mesh(m: Mesh) -> dict[str, Any]:
    """How the triangles of a mesh hang together: `{closed, manifold, oriented, euler, degenerate,
    boundaries, components, vertices, edges, triangles}`.

    Vertices within the document's tolerance are one, so that seams and creases, where several
    stand at one place, hang together. `closed`: every edge has two triangles or more;
    `manifold`: none has more than two, and around each vertex they are one fan; `oriented`:
    neighbours face alike. `euler` is vertices − edges + triangles: 2 of what is
    like a sphere, 0 of what is like a torus. `degenerate` counts the triangles without area,
    which count for nothing else; `boundaries` the holes that `border` goes around; `components`
    the parts that share no vertex.

    :param m: The mesh.

    In scripts: ``check_mesh(m: mesh) -> record``
    """
    return _called("check_mesh", (), {"m": m})  # type: ignore[no-any-return]


def circle(center: PointLike, radius: Quantity, *, normal: PointLike | None = None, form: str | None = None) -> Curve:
    """Exact full circle as a rational curve on 0..1.

    It starts at center + radius·x and runs counter-clockwise about the normal, where x is
    (1, 0, 0) made normal to the normal, or (0, 1, 0) where those are parallel. The forms trace
    the same circle with other control points. Piegl & Tiller, *The NURBS Book*, §7.5.

    :param center: Its centre.
    :param radius: Its radius, positive.
    :param normal: The direction that it runs around. Default: ``(0, 0, 1)``.
    :param form: Nine points in four quarters, seven on a square or a triangle, or degree 5 without inner knots. Default: ``"9-point"``.

    In scripts: ``circle(center: point, radius: length, normal: point = (0, 0, 1), form: "9-point" | "7-square" | "7-triangle" | "degree-5" = "9-point") -> curve``
    """
    return _called("circle", (), {"center": center, "radius": radius, "normal": normal, "form": form})  # type: ignore[no-any-return]


def clamp(x: Quantity, low: Quantity, high: Quantity) -> float:
    """The number nearest to `x` between two limits.

    :param x: The number.
    :param low: The lower limit.
    :param high: The upper limit.

    In scripts: ``clamp(x: number, low: number, high: number) -> number``
    """
    return _called("clamp", (), {"x": x, "low": low, "high": high})  # type: ignore[no-any-return]


def clamped(*args: Any, points: Any = None, degree: Any = None) -> Any:
    """Uniform B-spline that starts at its first point and ends at its last, one unit of parameter
    a segment.

    Its first and last knots are repeated, those between are 1 apart: of degree 3 with n + 1
    points {0, 0, 0, 0, 1, …, n - 3, n - 2, n - 2, n - 2, n - 2}. Linkeová, *Curves and
    Surfaces for Computer Graphics*, §2.5.

    :param points: The control points, more than the degree.
    :param degree: The degree. Default: ``3``.

    In scripts: ``clamped(points: list of points, degree: integer = 3) -> curve``

    Uniform clamped B-spline surface of a grid, one unit of parameter a patch.

    Its corners are the grid's. Linkeová, *Curves and Surfaces for Computer Graphics*, §3.6.
    :param points: The control points: `points[i][j]`, i along u, j along v.
    :param degree: The degree, or `{u: , v: }`. Default: ``3``.

    In scripts: ``clamped(points: grid of points, degree: integer | record = 3) -> surface``
    """
    return _called("clamped", args, {"points": points, "degree": degree})


def classify(*args: Any, c: Any = None, t: Any = None, s: Any = None, u: Any = None, v: Any = None) -> str:
    """Kind of place that a parameter of a curve is.

    At a corner the tangent jumps, at a cusp it turns back; at an inflection it goes on and the
    curve bends to the other side. The ends of a closed curve are one place, those of an open
    one are regular.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.

    In scripts: ``classify(c: curve, t: number) -> "regular" | "inflection" | "cusp" | "corner"``

    Kind of place of a surface.

    `"elliptic"` where it bends to one side, `"hyperbolic"` where it bends to both, `"parabolic"` where
    it is straight in one direction only and `"planar"` where it is in all; `"singular"` where Su × Sv
    vanishes, as at the apex of a cone or at a pole, whatever the shape is there.

    Linkeová, *Curves and Surfaces for Computer Graphics*, Definitions 1.26 and 1.29.
    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``classify(s: surface | face, u: number, v: number) -> "elliptic" | "parabolic" | "hyperbolic" | "planar" | "singular"``
    """
    return _called("classify", args, {"c": c, "t": t, "s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def closest(*args: Any, f: Any = None, p: Any = None, c: Any = None, s: Any = None, r: Any = None) -> dict[str, Any]:
    """Nearest point of a face to a point, its border included, as `{u, v, point, distance}`.

    The nearest of all, by branch and bound over the part of the surface that the face is.

    :param f: The face.
    :param p: The point.

    In scripts: ``closest(f: face, p: point) -> record``

    Nearest point of a curve to a point, as `{t, point, distance, count}`.

    The nearest of the whole curve, ends included, by branch and bound. `count` tells how many places
    are as near as that, within the document's tolerance; `t` is the first of them. A whole stretch that
    is all as near, as a circle is to its centre, counts once, and a warning tells its parameters.
    At the end of a part before a jump `t` is the last number before the jump, where the curve is there.
    Ma & Hewitt, *Point inversion and projection for NURBS curve and surface*, CAGD 20 (2003).
    :param c: The curve.
    :param p: The point.

    In scripts: ``closest(c: curve, p: point) -> record``

    Nearest point of a surface to a point, as `{u, v, point, distance}`.

    Of a NURBS the nearest of the whole surface, its boundary included, by branch and bound. At a
    seam and at a pole, where several parameters have the point, they are the start of the domain;
    of places that are equally near one is told. Of a `parametric` surface, of which only values
    can be known, the best that a search from 49 x 49 places comes to.
    Ma & Hewitt, *Point inversion and projection for NURBS curve and surface*, CAGD 20 (2003).
    :param s: The surface.
    :param p: The point.

    In scripts: ``closest(s: surface, p: point) -> record``

    Nearest point of a region to a point, as `{point, distance}`: of the inside where the point is above
    that, else of the border.
    :param r: The region.
    :param p: The point.

    In scripts: ``closest(r: region, p: point) -> record``

    Nearest point of the faces of a solid to a point, as `{face, point, distance}`; `face` is its number among `s.faces`.

    Also from inside it is that of the skin: `contains` tells on which side a point is. Of faces that are equally near the first.
    :param s: The solid.
    :param p: The point.

    In scripts: ``closest(s: solid, p: point) -> record``
    """
    return _called("closest", args, {"f": f, "p": p, "c": c, "s": s, "r": r})  # type: ignore[no-any-return]


def compatible(*args: Any, curves: Any = None, surfaces: Any = None) -> Any:
    """The same curves on one degree and one knot vector, in the order given.

    The degree is the highest among them, the domain that of the first curve, and every knot of
    one is a knot of all. Parametric curves are followed within the document's
    tolerance. Piegl & Tiller, *The NURBS Book*, §10.3.

    :param curves: The curves.

    In scripts: ``compatible(curves: list of curves) -> list of curves``

    The same surfaces on one pair of degrees and one pair of knot vectors, in the order given.

    The degrees are the highest among them, the domains those of the first surface, and every
    knot of one is a knot of all. Knots of different surfaces nearer to one another than 2e-9 of
    the domain become one. Piegl & Tiller, *The NURBS Book*, §10.3.
    :param surfaces: The surfaces.

    In scripts: ``compatible(surfaces: list of surfaces) -> list of surfaces``
    """
    return _called("compatible", args, {"curves": curves, "surfaces": surfaces})


def cone(base: PointLike, r0: Quantity, r1: Quantity, height: Quantity, *, axis: PointLike | None = None) -> Surface:
    """Exact wall of a circular cone as a rational surface on 0..1 in both directions, without its
    ends.

    u goes around the axis counter-clockwise, from the place of (1, 0, 0) made normal to the axis,
    or of (0, 1, 0) where those are parallel; v goes up from the base. Su × Sv points outward.
    A radius of zero makes a tip. Piegl & Tiller, *The NURBS Book*, §8.5.

    :param base: The centre of its lower circle.
    :param r0: The radius below.
    :param r1: The radius above; one of both may be zero.
    :param height: Its height along the axis, positive.
    :param axis: The direction of its axis. Default: ``(0, 0, 1)``.

    In scripts: ``cone(base: point, r0: length, r1: length, height: length, axis: point = (0, 0, 1)) -> surface``
    """
    return _called("cone", (), {"base": base, "r0": r0, "r1": r1, "height": height, "axis": axis})  # type: ignore[no-any-return]


def conic(a: PointLike, b: PointLike, c: PointLike, weight: float) -> Curve:
    """Exact conic section from `a` to `c`, tangent there to the lines to `b`, on 0..1.

    A rational quadratic Bézier curve whose ends have weight 1. A weight of the middle point
    below 1 makes an ellipse, 1 a parabola, above 1 a hyperbola; 0 the straight line.
    Piegl & Tiller, *The NURBS Book*, §7.3.

    :param a: Where it starts.
    :param b: Where the tangents of the ends meet.
    :param c: Where it ends.
    :param weight: The weight of `b`, not negative.

    In scripts: ``conic(a: point, b: point, c: point, weight: number) -> curve``
    """
    return _called("conic", (), {"a": a, "b": b, "c": c, "weight": weight})  # type: ignore[no-any-return]


def conic_kind(c: Curve) -> str:
    """Which conic section a curve of degree 2 is; a circle is an ellipse.

    By the shape factor w1²/(w0·w2) of its weights: below 1 an ellipse, 1 a parabola, above 1
    a hyperbola. Piegl & Tiller, *The NURBS Book*, (7.22).

    :param c: The curve, of degree 2.

    In scripts: ``conic_kind(c: curve) -> "ellipse" | "parabola" | "hyperbola"``
    """
    return _called("conic_kind", (), {"c": c})  # type: ignore[no-any-return]


def contains(*args: Any, f: Any = None, p: Any = None, r: Any = None, s: Any = None, list: Any = None, element: Any = None, text: Any = None, part: Any = None) -> Any:
    """Where a point is: `"inside"`, `"outside"`, or on the `"border"` of a face, which is as wide as the
    document's tolerance on either side. A point further than the tolerance from the surface is outside.

    :param f: The face.
    :param p: The point.

    In scripts: ``contains(f: face, p: point) -> "inside" | "outside" | "border"``

    Where a point is: `"inside"`, `"outside"`, or on the `"border"` of a region, which is as wide as the
    document's tolerance on either side. A point beside the plane is outside.
    :param r: The region.
    :param p: The point.

    In scripts: ``contains(r: region, p: point) -> "inside" | "outside" | "border"``

    Where a point is: `"inside"`, `"outside"`, or on the `"border"` of a solid, which is as wide as the document's
    tolerance on either side of its faces. What is in a void is outside.
    :param s: The solid.
    :param p: The point.

    In scripts: ``contains(s: solid, p: point) -> "inside" | "outside" | "border"``

    Whether a value is among the elements of a list, equal as `==` says.
    :param list: The list; a range of whole numbers counts as one.
    :param element: The value.

    In scripts: ``contains(list: list of values, element: any) -> bool``

    Whether a part occurs in a text.
    :param text: The text.
    :param part: The part.

    In scripts: ``contains(text: string, part: string) -> bool``
    """
    return _called("contains", args, {"f": f, "p": p, "r": r, "s": s, "list": list, "element": element, "text": text, "part": part})


if TYPE_CHECKING:

    @overload
    def continue_bezier(*args: Any, c: Any = None, order: Any = None, points: Any = None) -> Curve: ...

    @overload
    def continue_bezier(s: Surface, side: str, order: float, net: Any) -> Surface: ...


def continue_bezier(*args: Any, c: Any = None, order: Any = None, points: Any = None, s: Any = None, side: Any = None, net: Any = None) -> Any:
    """Bézier curve on 0..1 that starts where a curve ends, with the same derivatives up to an
    order, by its own parameter.

    Its first control points, one more than the order, follow from that; the free ones come
    behind them, so that the degree is the order and the number of free points.
    Linkeová, *Curves and Surfaces for Computer Graphics*, §2.2.

    :param c: The curve that it goes on from.
    :param order: The order of continuity, from 0 to 3.
    :param points: The free control points, the last of which is its end.

    In scripts: ``continue_bezier(c: curve, order: integer, points: list of points) -> curve``

    Patch that goes on from a side of a surface with the same derivatives across it up to an
    order, by its own parameter; it is a Bézier patch where the surface is one along the side.

    Parametrized in the directions of the surface: beyond "u1" it begins at its own "u0", before
    "u0" it ends at its own "u1"; across the side its domain is 0..1, along it that of the
    surface. The control points at the side, one more than the order, follow from that; the free
    ones come beyond them, in a grid with its rows along u like all grids. The points beyond
    a rational surface take the weights of its side.
    Linkeová, *Curves and Surfaces for Computer Graphics*, (3.51).
    :param s: The surface that it goes on from.
    :param side: The side where it does.
    :param order: The order of continuity, from 0 to 3.
    :param net: The free control points: as many along the side as the surface has there, one or more across.

    In scripts: ``continue_bezier(s: surface, side: "u0" | "u1" | "v0" | "v1", order: integer, net: grid of points) -> surface``
    """
    return _called("continue_bezier", args, {"c": c, "order": order, "points": points, "s": s, "side": side, "net": net})


def continuity(*args: Any, a: Any = None, b: Any = None, tolerance: Any = None, angle: Any = None, curvature_gap: Any = None, edge_a: Any = None, edge_b: Any = None) -> dict[str, Any]:
    """How smoothly a face goes on in another across the edges that they share, as `{g, gap, angle, curvature_gap, at}`.

    `g` is the largest order up to 2 that holds along all of them: 0 an edge in common, 1 the same tangent plane, 2 the
    same second fundamental tensor. `gap`, `angle` and `curvature_gap` tell how far edges, tangent planes and normal
    curvatures differ at most, and `at` where: the place of the largest angle, or curvature gap where the planes agree.
    An edge is shared as far as it runs within the document's tolerance of one of the other face. Each is looked at in
    129 places. Planes are one within 1e-9 rad and what edges leave open, which are known within an eighth of the
    tolerance; curvatures within a millionth. `tolerance`, `angle` and `curvature_gap` ask for other limits.

    :param a: The first face.
    :param b: The face that goes on.
    :param tolerance: How far the edges may be apart; otherwise the document's tolerance, at most a thousandth of the size.
    :param angle: By how much tangent planes may differ for G1.
    :param curvature_gap: By how much normal curvatures may differ for G2.

    In scripts: ``continuity(a: face, b: face, tolerance: length = none, angle: angle = none, curvature_gap: curvature = none) -> record``

    How smoothly a curve goes on in another, the end of `a` in the start of `b`; of one curve
    alone the worst of its inner knots, of its seam where it is closed, and of the places where
    it stands still.

    `c` and `g` are the largest orders up to 3 that hold, -1 where the points are apart: `c` of
    equal derivatives by the parameter, `g` of equal ones by arc length: 1 the same direction,
    2 the same curvature vector, 3 the same change of it. `c_homogeneous` compares the
    homogeneous curves; `gap`, `angle` and `curvature_gap` tell how far points, tangents and
    curvature vectors differ, the last `none` where a curvature has no bound. Where a derivative
    vanishes the direction is that of the next one that does not: a cusp is C3 but only G0.
    A parametric curve has inner joints where its derivatives jump.

    What counts as equal is decided by the document's tolerance: points by its distance,
    directions within 1e-9 rad, and all that is higher to 1e-9 of its size. `tolerance`, `angle`
    and `curvature_gap` ask for other limits of the fields `gap`, `angle` and `curvature_gap`; an
    order fails where the field exceeds its limit, and `c` is then no higher than `g`.

    Linkeová, *Curves and Surfaces for Computer Graphics*, §1.2; Barsky & DeRose, *Geometric
    continuity of parametric curves*.
    :param a: The first curve.
    :param b: The curve that goes on, if it is another.
    :param tolerance: How far points may be apart at a joint; otherwise the document's tolerance, at most a thousandth of the size.
    :param angle: By how much tangents may differ for G1.
    :param curvature_gap: By how much curvature vectors may differ for G2.

    In scripts: ``continuity(a: curve, b: curve = none, tolerance: length = none, angle: angle = none, curvature_gap: curvature = none) -> record``

    How smoothly a surface goes on in another across an edge; of one surface alone the worst
    across the lines of its inner knots, and across its seam where it is closed.

    `c` and `g` are the largest orders up to 3 that hold along the whole edge, -1 where the edges
    are apart. `c` wants equal derivatives across the edge, at places of equal fractions along it.
    `g` does not look at the parameters: 1 wants the same tangent plane, 2 the same second
    fundamental tensor, 3 the same third derivatives of the height over that plane.
    `c_homogeneous` compares the homogeneous surfaces. `gap`, `angle` and `curvature_gap` tell how far
    points, tangent planes and normal curvatures differ at most, and `at` is where: the place of the
    largest gap if the edges are apart, else of the largest angle, or curvature gap where the planes
    agree. The edges may run opposite ways.

    What counts as equal is decided by the document's tolerance: points by its distance, tangent
    planes within 1e-9 rad, and all that is higher to 1e-9 of its size. `tolerance`, `angle` and
    `curvature_gap` ask for other limits of the fields `gap`, `angle` and `curvature_gap`; an order
    fails where the field exceeds its limit, and `c` is then no higher than `g`.

    Of NURBS each piece is compared in more places than a difference of its degree could have
    zeros; of `parametric` surfaces in 129. Linkeová, *Curves and Surfaces for Computer Graphics*,
    Definitions 1.32 to 1.34; Peters, *Geometric continuity*.
    :param a: The first surface.
    :param b: The surface that goes on, if it is another.
    :param edge_a: The edge of the first where it goes on.
    :param edge_b: The edge of the second where it begins.
    :param tolerance: How far the edges may be apart; otherwise the document's tolerance, at most a thousandth of the size.
    :param angle: By how much tangent planes may differ for G1.
    :param curvature_gap: By how much normal curvatures may differ for G2.

    In scripts: ``continuity(a: surface, b: surface = none, edge_a: "u0" | "u1" | "v0" | "v1" = none, edge_b: "u0" | "u1" | "v0" | "v1" = none, tolerance: length = none, angle: angle = none, curvature_gap: curvature = none) -> record``
    """
    return _called("continuity", args, {"a": a, "b": b, "tolerance": tolerance, "angle": angle, "curvature_gap": curvature_gap, "edge_a": edge_a, "edge_b": edge_b})  # type: ignore[no-any-return]


def contours(s: Surface, direction: PointLike, levels: Any) -> list[Curve]:
    """Curves on a surface along which the height in a direction is one of the levels, in the order of
    the levels.

    Heights are lengths along the direction from (0, 0, 0): the planes stand at `level` times the unit
    vector. Complete, and of the kind that `section` gives; a level that the surface does not reach
    has no curves.

    :param s: The surface.
    :param direction: The direction in which the surface is high or low.
    :param levels: The heights.

    In scripts: ``contours(s: surface, direction: point, levels: list of lengths) -> list of curves``
    """
    return _called("contours", (), {"s": s, "direction": direction, "levels": levels})  # type: ignore[no-any-return]


def control_net(s: Surface) -> list[Curve]:
    """Control net of a surface as polylines: those along u, then those along v.

    Points of weight zero are left out.

    :param s: The surface.

    In scripts: ``control_net(s: surface) -> list of curves``
    """
    return _called("control_net", (), {"s": s})  # type: ignore[no-any-return]


def control_polygon(c: Curve) -> Curve:
    """Polyline through a curve's control points, one unit of parameter a leg.

    Points that a weight of zero takes away are left out.

    :param c: The curve.

    In scripts: ``control_polygon(c: curve) -> curve``
    """
    return _called("control_polygon", (), {"c": c})  # type: ignore[no-any-return]


def coons(u: Sequence[Curve], v: Sequence[Curve], *, blend: str | None = None) -> Surface:
    """Coons surface within four curves: the surface between the u-curves plus the one between the
    v-curves less the one of the corners.

    Exact for curves of any degrees and knots. Curves of different weights are brought over one
    denominator, which adds their degrees; parametric ones are converted within the document's
    tolerance. Its domains are those of `u[0]` and `v[0]`. Blend `"linear"` goes straight across,
    `"cubic"` leaves each boundary level, so that neighbours whose other boundaries go on
    smoothly meet smoothly. Piegl & Tiller, *The NURBS Book*, (10.34) to (10.36).

    :param u: The two curves along u: at v = 0 and at v = 1.
    :param v: The two curves along v: at u = 0 and at u = 1.
    :param blend: How it goes from each boundary to the opposite one. Default: ``"linear"``.

    In scripts: ``coons(u: list of curves, v: list of curves, blend: "linear" | "cubic" = "linear") -> surface``
    """
    return _called("coons", (), {"u": u, "v": v, "blend": blend})  # type: ignore[no-any-return]


def coons_bicubic(u: Sequence[Curve], v: Sequence[Curve], cross_u: Sequence[Curve], cross_v: Sequence[Curve], *, twists: str | None = None, angle: Quantity | None = None) -> Surface:
    """Coons surface within four curves that also takes derivatives across them.

    Exact as `coons` is. At each corner the data must agree: a cross field begins with the
    derivative of the boundary that it crosses to, else it is an error; and the derivatives of
    both cross fields, the twists, are one. Where these differ, `"average"` takes their mean and
    moves the control points of the fields next to that corner, which a warning and `report`
    tell; `"error"` refuses. Where the surface fills a hole, that turns it against its
    neighbours beside the corner: `report` tells the largest angle reached along the boundary as `angle`,
    and that along each of the four curves as `angles`; the parameter `angle` demands one. Its domains are those of `u[0]` and `v[0]`, by which derivatives
    count. Piegl & Tiller, *The NURBS Book*, (10.37) to (10.43), A10.4.

    :param u: The two curves along u: at v = 0 and at v = 1.
    :param v: The two curves along v: at u = 0 and at u = 1.
    :param cross_u: Derivatives Sv along each of the u-curves, as curves of vectors.
    :param cross_v: Derivatives Su along each of the v-curves, as curves of vectors.
    :param twists: What to do where the twists of the fields differ. Default: ``"average"``.
    :param angle: The largest angle along the boundary between the surface and the tangent plane that the cross fields ask for; more is an error.

    In scripts: ``coons_bicubic(u: list of curves, v: list of curves, cross_u: list of curves, cross_v: list of curves, twists: "average" | "error" = "average", angle: angle = none) -> surface``
    """
    return _called("coons_bicubic", (), {"u": u, "v": v, "cross_u": cross_u, "cross_v": cross_v, "twists": twists, "angle": angle})  # type: ignore[no-any-return]


def coons_bspline(*args: Any, points: Any = None, closed: Any = None) -> Any:
    """Coons cubic B-spline: uniform, not clamped, one unit of parameter a segment.

    Every four consecutive points make one segment, a Coons cubic; segments meet with two
    derivatives (C2). A closed one has as many segments as points, begins with that of points
    0 to 3, and its seam is as smooth as its other joints.
    Linkeová, *Curves and Surfaces for Computer Graphics*, Definition 2.4.

    :param points: The control points: four or more, for a closed curve three or more.
    :param closed: Whether the curve closes without a seam. Default: ``false``.

    In scripts: ``coons_bspline(points: list of points, closed: bool = false) -> curve``

    Coons bicubic B-spline surface: uniform, not clamped, one unit of parameter a patch.

    Every 4 by 4 neighbouring points make one patch; patches meet with two derivatives (C2).
    Where it is closed it has as many patches as points, begins with that of points 0 to 3, and
    its seam is as smooth as its other joints.
    Linkeová, *Curves and Surfaces for Computer Graphics*, Definition 2.4.
    :param points: The control points, `points[i][j]`, i along u, j along v: four or more in each direction, three or more where it closes.
    :param closed: Whether the surface closes without a seam, in both directions or `{u: , v: }`. Default: ``false``.

    In scripts: ``coons_bspline(points: grid of points, closed: bool | record = false) -> surface``
    """
    return _called("coons_bspline", args, {"points": points, "closed": closed})


def coons_cubic(*args: Any, points: Any = None) -> Curve:
    """Coons cubic of four points: one segment of the uniform cubic B-spline, on 0..1.

    It starts a third of the way from the second point to the middle of its neighbours and
    ends likewise at the third point, with the derivatives (P2 - P0)/2 and (P3 - P1)/2.
    Linkeová, *Curves and Surfaces for Computer Graphics*, Definition 2.3.

    :param points: The four control points.

    In scripts: ``coons_cubic(points: list of points) -> curve``
    """
    return _called("coons_cubic", args, {"points": points})  # type: ignore[no-any-return]


def corner_surface(*args: Any, points: Any = None) -> Surface:
    """Surface of three or four corners in order around it, ruled by straight lines.

    The first corner is at u = 0, v = 0, the second at u = 1, v = 0, the third at u = 1, v = 1;
    of three the last one is the whole edge v = 1. Flat if the corners are in one plane, else a
    hyperbolic paraboloid. Linkeová, *Curves and Surfaces for Computer Graphics*, §3.3.3.

    :param points: The corners, three or four.

    In scripts: ``corner_surface(points: list of points) -> surface``
    """
    return _called("corner_surface", args, {"points": points})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def corners(s: Surface) -> list[FloatArray]: ...

    @overload
    def corners(c: Curve) -> FloatArray: ...


def corners(*args: Any, s: Any = None, c: Any = None) -> Any:
    """The corners of a surface, `[[p00, p01], [p10, p11]]`: the first index counts along u.

    :param s: The surface.

    In scripts: ``corners(s: surface) -> list of lists of points``

    Parameters where the tangent of a curve jumps to another direction, in order.

    Where it turns back there is a cusp instead. The seam of a closed curve counts.
    Of a parametric curve they are where its derivatives jump, known to the last digits.
    :param c: The curve.

    In scripts: ``corners(c: curve) -> list of numbers``
    """
    return _called("corners", args, {"s": s, "c": c})


def cos(angle: Quantity) -> float:
    """Cosine of an angle; a bare number counts as radians.

    :param angle: An angle, or a number of radians.

    In scripts: ``cos(angle: angle | number) -> number``
    """
    return _called("cos", (), {"angle": angle})  # type: ignore[no-any-return]


def cosh(x: float) -> float:
    """Hyperbolic cosine.

    :param x: A number.

    In scripts: ``cosh(x: number) -> number``
    """
    return _called("cosh", (), {"x": x})  # type: ignore[no-any-return]


def cosspace(a: Quantity, b: Quantity, n: float) -> FloatArray:
    """`n` numbers from `a` to `b`, both included, denser towards the ends as the cosine of equal angles: the usual stations of an aerofoil.

    :param a: The first number.
    :param b: The last number.
    :param n: How many; one gives the first alone.

    In scripts: ``cosspace(a: number, b: number, n: integer) -> list of numbers``
    """
    return _called_for(1, "cosspace", (), {"a": a, "b": b, "n": n})  # type: ignore[no-any-return]


def cross(a: PointLike, b: PointLike) -> FloatArray:
    """Vector product of two vectors, normal to both and right-handed.

    :param a: The first vector.
    :param b: The second vector.

    In scripts: ``cross(a: point, b: point) -> point``
    """
    return _called("cross", (), {"a": a, "b": b})  # type: ignore[no-any-return]


def cubic_spline(*args: Any, points: Any = None, tangents: Any = None) -> Curve:
    """Chain of Hermite cubics through points, one unit of parameter each, whose inner derivatives
    are those that make it C2.

    The derivatives follow from P′ᵢ₋₁ + 4 P′ᵢ + P′ᵢ₊₁ = 3 (Pᵢ₊₁ − Pᵢ₋₁), solved for all
    points together. Hsu, *Curve representation*, (23) and (24).

    :param points: The points, two or more.
    :param tangents: The derivatives at the start and at the end.

    In scripts: ``cubic_spline(points: list of points, tangents: list of points) -> curve``
    """
    return _called("cubic_spline", args, {"points": points, "tangents": tangents})  # type: ignore[no-any-return]


def curvature(c: Curve, t: float, *, side: str | None = None) -> float:
    """Curvature of a curve: the reciprocal of the radius of the osculating circle, never negative.

    |C' × C''| / |C'|³, and 0 where the curve is straight. Where the first derivative vanishes it is
    the limit, if there is one: at a cusp there is none. do Carmo, *Differential Geometry of Curves
    and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``curvature(c: curve, t: number, side: "right" | "left" = "right") -> curvature``
    """
    return _called("curvature", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def curvature_comb(*args: Any, c: Any = None, samples: Any = None, scale: Any = None, side: Any = None, s: Any = None, u: Any = None, v: Any = None) -> dict[str, Any]:
    """Curvature comb of a curve, `{teeth, envelope}`: segments from the curve as long as its
    curvature times the scale, and the polyline of their tips.

    Samples are evenly spaced in the parameter, both ends among them. At each the envelope has
    the tip of its tooth. Where the curvature has no bound there is no tooth, and a warning
    says so.

    :param c: The curve.
    :param samples: How many teeth, two or more. Default: ``100``.
    :param scale: Length of a tooth where the curvature is 1. Default: ``1``.
    :param side: Away from the centre of curvature or towards it. Default: ``"outside"``.

    In scripts: ``curvature_comb(c: curve, samples: integer = 100, scale: number = 1, side: "outside" | "inside" = "outside") -> record``

    Curvature combs along isocurves of a surface, `{teeth, envelopes}`: the teeth of all, and the
    polyline of the tips of each.

    A tooth is as long as the curvature of the isocurve as a curve in space, and lies along its
    principal normal, as in the surface combs of modelling programs: on a circle of latitude
    of a sphere it is square to the axis. It is not the normal curvature of the surface, which
    `normal_curvature` tells. First come the isocurves at the parameters `u`, which run along
    v, then those at `v`; without both those that a picture draws, at even steps and at edges.
    :param s: The surface.
    :param u: The parameters u of isocurves.
    :param v: The parameters v of isocurves.
    :param samples: How many teeth each isocurve has, two or more. Default: ``100``.
    :param scale: Length of a tooth where the curvature is 1. Default: ``1``.
    :param side: Away from the centre of curvature or towards it. Default: ``"outside"``.

    In scripts: ``curvature_comb(s: surface, u: list of numbers without units = none, v: list of numbers without units = none, samples: integer = 100, scale: number = 1, side: "outside" | "inside" = "outside") -> record``
    """
    return _called("curvature_comb", args, {"c": c, "samples": samples, "scale": scale, "side": side, "s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def curvature_map(s: Surface, kind: str, *, tolerance: Quantity | None = None, range: tuple[Quantity, Quantity] | None = None) -> dict[str, Any]:
    """How a surface bends, by the colours of a mesh:
    `{mesh, kind, min, max, scale, below, above, values}`.

    Kinds are `"gaussian"`, `"mean"`, the principal curvatures `"k1"` and `"k2"`, `"absolute"`
    (the larger of them without its sign) and `"difference"` (k2 − k1, zero at umbilics); and the
    least and the greatest radius of curvature along the principal directions, without sign:
    `"min_radius"`, 1/max(|k1|, |k2|), and `"max_radius"`, 1/min(|k1|, |k2|). The
    values are those at the vertices, `none` where the surface has none, which are grey, and where
    a radius has no bound, which have the colour of the largest. `min` and
    `max` are the ends of the scale, those of the values unless a `range` is given; the scale of a
    radius ends at ten times the surface's size, from where on all looks flat. Values beyond
    have the colours of the ends; `below` and `above` count the vertices that have them, and the
    legend of a picture has ≤ or ≥ there. Values that are the same but for rounding are one value,
    and white. The scale goes through white at zero where it holds both signs, blue
    below and red above, and else from blue over white to red; `scale` lists
    `{value, color}` at nine places, colours as red, green and blue from 0 to 1.
    Beck, Farouki & Hinds, *Surface analysis methods*, IEEE CG&A 6 (1986).

    :param s: The surface.
    :param kind: Which curvature, or which radius of curvature.
    :param tolerance: How far the mesh may be from the surface; when left out a thousandth of its size.
    :param range: The values at the ends of the scale.

    In scripts: ``curvature_map(s: surface, kind: "gaussian" | "mean" | "k1" | "k2" | "absolute" | "difference" | "min_radius" | "max_radius", tolerance: length = none, range: range = none) -> record``
    """
    return _called("curvature_map", (), {"s": s, "kind": kind, "tolerance": tolerance, "range": range})  # type: ignore[no-any-return]


def curvature_table(*args: Any, c: Any = None, samples: Any = None, s: Any = None, u: Any = None, v: Any = None) -> Table:
    """Table of points, unit tangents, curvature, radius of curvature and torsion along a curve.

    Its columns are `t x y z tx ty tz curvature radius torsion`. Samples are evenly spaced in
    the parameter, both ends among them. A cell is empty, `none` in a script, where the curve
    has no such value: the radius and the torsion of a straight place, the curvature of a cusp.

    :param c: The curve.
    :param samples: How many rows, two or more. Default: ``100``.

    In scripts: ``curvature_table(c: curve, samples: integer = 100) -> table``

    Table of points, unit normals, principal, Gaussian and mean curvatures over a surface.

    Its columns are `u v x y z nx ny nz k1 k2 gaussian mean`. Samples are evenly spaced in both
    parameters, the edges among them, row after row along v. A cell is empty, `none` in a
    script, where the surface has no such value, as at the apex of a cone.
    :param s: The surface.
    :param u: How many samples along u, two or more. Default: ``20``.
    :param v: How many samples along v, two or more. Default: ``20``.

    In scripts: ``curvature_table(s: surface, u: integer = 20, v: integer = 20) -> table``
    """
    return _called("curvature_table", args, {"c": c, "samples": samples, "s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def cusps(c: Curve) -> FloatArray:
    """Parameters where a curve turns back on itself, in order.

    Its derivative vanishes there and its tangent reverses, or two of its pieces meet so.
    Of a parametric curve found near it and then on the function itself.

    :param c: The curve.

    In scripts: ``cusps(c: curve) -> list of numbers``
    """
    return _called_for(1, "cusps", (), {"c": c})  # type: ignore[no-any-return]


def cut(s: Solid, plane: Frame, *, keep: str | None = None) -> Solid | None:
    """The part of a solid on one side of a plane, closed by plane faces; `none` where there is nothing.

    Above is where the plane's normal points. Its faces are the parts of the solid's faces there, then the plane ones. Where the side
    falls apart, it is one solid of several shells. Its volume must be what its faces tell. What the plane has of the solid is
    `section(s, plane)`.

    :param s: The solid.
    :param plane: The plane.
    :param keep: Which side stays. Default: ``"below"``.

    In scripts: ``cut(s: solid, plane: plane, keep: "below" | "above" = "below") -> solid | none``
    """
    return _called("cut", (), {"s": s, "plane": plane, "keep": keep})  # type: ignore[no-any-return]


def cylinder(base: PointLike, radius: Quantity, height: Quantity, *, axis: PointLike | None = None) -> Surface:
    """Exact wall of a circular cylinder as a rational surface on 0..1 in both directions, without
    its ends.

    u goes around the axis counter-clockwise, from the place of (1, 0, 0) made normal to the axis,
    or of (0, 1, 0) where those are parallel; v goes up from the base. Su × Sv points outward.
    Piegl & Tiller, *The NURBS Book*, §8.3.

    :param base: The centre of its lower circle.
    :param radius: Its radius, positive.
    :param height: Its height along the axis, positive.
    :param axis: The direction of its axis. Default: ``(0, 0, 1)``.

    In scripts: ``cylinder(base: point, radius: length, height: length, axis: point = (0, 0, 1)) -> surface``
    """
    return _called("cylinder", (), {"base": base, "radius": radius, "height": height, "axis": axis})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def de_casteljau(c: Curve, t: float) -> list[FloatArray]: ...

    @overload
    def de_casteljau(s: Surface, u: float, v: float) -> list[list[FloatArray]]: ...


def de_casteljau(*args: Any, c: Any = None, t: Any = None, s: Any = None, u: Any = None, v: Any = None) -> Any:
    """All levels of points of de Casteljau's algorithm for a Bézier curve.

    Level 0 is the control polygon, each next one divides the legs of the one before it in the
    ratio of the parameter, the last is the point of the curve. With weights the legs are
    divided in homogeneous space. Farin, *Curves and Surfaces for CAGD*, §4.2.

    :param c: The curve, of one Bézier segment.
    :param t: The parameter, inside the curve's domain.

    In scripts: ``de_casteljau(c: curve, t: number) -> list of lists of points``

    All levels of nets of de Casteljau's algorithm for a Bézier surface.

    Level 0 is the control net; each next one divides the cells of the one before it in the ratio
    of both parameters, and where one direction is used up the legs of the other; the last is
    the point of the surface. With weights they are divided in homogeneous space. The
    algorithm by curves is that of the isocurves: `de_casteljau(s(_, v), u)`.
    Linkeová, *Curves and Surfaces for Computer Graphics*, (3.43) to (3.45).
    :param s: The surface, of one Bézier patch.
    :param u: The first parameter, inside the surface's domain.
    :param v: The second parameter.

    In scripts: ``de_casteljau(s: surface, u: number, v: number) -> list of lists of lists of points``
    """
    return _called("de_casteljau", args, {"c": c, "t": t, "s": s, "u": u, "v": v})


if TYPE_CHECKING:

    @overload
    def decompose(c: Curve) -> list[Curve]: ...

    @overload
    def decompose(s: Surface) -> list[list[Surface]]: ...


def decompose(*args: Any, c: Any = None, s: Any = None) -> Any:
    """Bézier curves that a curve consists of, each on its own part of the domain.

    Exact. `join` makes the same curve of them, unless it jumps. Piegl & Tiller, *The NURBS Book*, A5.6.

    :param c: The curve.

    In scripts: ``decompose(c: curve) -> list of curves``

    Bézier patches that a surface consists of, as a grid: `[i][j]`, i along u, j along v, each
    on its own part of the domains.

    Exact. `join` makes the same surface of them. Piegl & Tiller, *The NURBS Book*, A5.7.
    :param s: The surface.

    In scripts: ``decompose(s: surface) -> list of lists of surfaces``
    """
    return _called("decompose", args, {"c": c, "s": s})


def derivative(*args: Any, c: Any = None, t: Any = None, order: Any = None, side: Any = None, s: Any = None, u: Any = None, v: Any = None, du: Any = None, dv: Any = None) -> FloatArray:
    """Derivative vector of a curve by its parameter, of any order; order 0 is the point.

    At a knot it is that of the piece to the right, unless the side says otherwise; at the end that
    of the piece to the left. Piegl & Tiller, *The NURBS Book*, A3.2 and A4.2.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param order: The order. Default: ``1``.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``derivative(c: curve, t: number, order: integer = 1, side: "right" | "left" = "right") -> point``

    Partial derivative vector of a surface, of order `du` by u and `dv` by v.

    Piegl & Tiller, *The NURBS Book*, A3.6 and A4.4.
    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.
    :param du: The order by u. Default: ``1``.
    :param dv: The order by v. Default: ``0``.

    In scripts: ``derivative(s: surface | face, u: number, v: number, du: integer = 1, dv: integer = 0) -> point``
    """
    return _called("derivative", args, {"c": c, "t": t, "order": order, "side": side, "s": s, "u": u, "v": v, "du": du, "dv": dv})  # type: ignore[no-any-return]


def describe(g: Any) -> Any:
    """All data of geometry, of a mesh or of a table, under the names of its fields and after its
    `kind`; a list element by element.

    A curve also tells its `order`, degree + 1, the `count` of its control points, and the class of
    its knots as `knot_class` does; a table
    the `count` of its rows. `form` is what a curve or surface is whatever made it or was done to it
    since, as far as its coefficients prove it: `"line"`, `"circle"`, `"arc"`; of a surface the quadric
    that it lies on, `"plane"`, `"sphere"`, `"cylinder"`, `"cone"`, `"ellipsoid"`, `"elliptic paraboloid"`,
    `"hyperbolic paraboloid"`, `"hyperboloid of one sheet"`, `"hyperboloid of two sheets"`,
    `"elliptic cylinder"`, `"hyperbolic cylinder"`, `"parabolic cylinder"`, `"elliptic cone"`, or a
    `"torus"` of which it covers a part once; otherwise `none`. The equation is proven to hold at all
    points, up to rounding; where several kinds are as near, the one with the fewest terms is told. A parametric curve or surface has no control points to tell.

    A surface tells both numbers for u and for v, and where it is not regular: the edges that are
    `collapsed` to a point, the other corners that are `singular` because Su × Sv vanishes there,
    and the first `folds`, where the normal turns over, each as a point of parameters (u, v): those
    that a grid of places shows, or else, of a NURBS surface, those that the coefficients of its
    normals tell, however narrow. So are its isolated `umbilics`, as far as a search from that grid comes to them:
    there it bends equally in all directions.

    :param g: A point, curve, surface, mesh, plane or table, or a list of them.

    In scripts: ``describe(g: geometry | table) -> any``
    """
    return _called("describe", (), {"g": g})


def deviation(a: Surface | Mesh | Sequence[PointLike], b: Surface | Mesh) -> dict[str, Any]:
    """How far a surface, a mesh, or points are from a surface or a mesh: `{max, mean, at}`.

    Of each place the distance to the nearest of `b` counts, whatever the parameters are; `at` is
    the place that is farthest. Of a surface places are taken evenly in its parameters, and from
    the farthest of them a search goes on uphill. What is missing of `b` on the other side shows in
    `deviation(b, a)`. Of a mesh the vertices, the middles of edges and triangles are places; from
    the farthest triangles the search goes on inside of them, and the mean is that of the area.
    From a mesh the distance is that to its nearest triangle.

    :param a: The surface, the mesh, or the points.
    :param b: The surface or the mesh from which they are measured.

    In scripts: ``deviation(a: surface | mesh | list of points, b: surface | mesh) -> record``
    """
    return _called("deviation", (), {"a": a, "b": b})  # type: ignore[no-any-return]


def difference(*args: Any, regions: Any = None, meshes: Any = None) -> Any:
    """What is in the first of several regions and in none of the others, as a list of its parts, the
    largest first; `[]` where there is nothing.

    The borders of the result are parts of the given ones, exactly. Borders that run within the
    document's tolerance of one another are one; those that come as near without being one are
    refused with the place. Where a list of several comes first and others follow, a warning tells that only its first
    region is kept (W0013).

    :param regions: The regions, in one plane; lists count as their members.

    In scripts: ``difference(regions: list of regions or lists of regions) -> list of regions``

    What is in the first of several closed meshes and in none of the others; `none` where there is nothing.

    The meshes must close within the document's tolerance, with triangles that face outward and cross
    nowhere: `tessellate` makes such of surfaces that close. Faces that coincide are one. The result
    is of triangles without normals; its new vertices are rounded, and no further away than that.
    It is checked before it is given: it closes, and its volume and that of what the meshes have in
    common add up to theirs. What would touch itself in an edge or a point is refused with the place. Where a list of several
    comes first and others follow, a warning tells that only its first mesh is kept (W0013).
    :param meshes: The closed meshes; lists count as their members.

    In scripts: ``difference(meshes: list of meshes or lists of meshes) -> mesh | none``
    """
    return _called("difference", args, {"regions": regions, "meshes": meshes})


def disc(*args: Any, plane: Any = None, radius: Any = None, center: Any = None, normal: Any = None) -> Surface:
    """Flat round part of a plane about its origin, as an exact rational surface on 0..1 in both
    directions.

    u goes around counter-clockwise from the plane's x, v from the rim to the centre, so that
    Su × Sv is the plane's normal.

    :param plane: The plane; its origin is the centre.
    :param radius: The radius, positive.

    In scripts: ``disc(plane: plane, radius: length) -> surface``

    Flat round surface about a point, as an exact rational surface on 0..1 in both directions.

    u goes around counter-clockwise about the normal from where a `circle` of that normal starts, v from the
    rim to the centre, so that Su × Sv is the normal.
    :param center: Its centre.
    :param radius: Its radius, positive.
    :param normal: The direction that it faces. Default: ``(0, 0, 1)``.

    In scripts: ``disc(center: point, radius: length, normal: point = (0, 0, 1)) -> surface``
    """
    return _called("disc", args, {"plane": plane, "radius": radius, "center": center, "normal": normal})  # type: ignore[no-any-return]


def distance(a: PointLike, b: PointLike) -> float:
    """Distance of two points.

    :param a: One point.
    :param b: The other point.

    In scripts: ``distance(a: point, b: point) -> length``
    """
    return _called("distance", (), {"a": a, "b": b})  # type: ignore[no-any-return]


def divide(c: Curve, n: float) -> FloatArray:
    """Points that divide a curve into `n` parts of equal length: n + 1 of them, from its start to
    its end.

    Of a parametric curve they are points of the function, at lengths that `length` tells.

    :param c: The curve.
    :param n: How many parts.

    In scripts: ``divide(c: curve, n: integer) -> list of points``
    """
    return _called_for(3, "divide", (), {"c": c, "n": n})  # type: ignore[no-any-return]


def dot(a: PointLike, b: PointLike) -> float:
    """Scalar product of two vectors.

    :param a: One vector.
    :param b: The other vector.

    In scripts: ``dot(a: point, b: point) -> number``
    """
    return _called("dot", (), {"a": a, "b": b})  # type: ignore[no-any-return]


def edge(s: Surface, side: str) -> Curve:
    """Side of a surface as a curve: exact, with the surface's parameter along it.

    "u0" and "u1" are where u starts and ends, so that v runs along them; "v0" and "v1"
    likewise.

    :param s: The surface.
    :param side: Which side.

    In scripts: ``edge(s: surface, side: "u0" | "u1" | "v0" | "v1") -> curve``
    """
    return _called("edge", (), {"s": s, "side": side})  # type: ignore[no-any-return]


def edge_surface(curves: Sequence[Curve]) -> Surface:
    """Surface within two, three or four edges, in any order and direction.

    Two make a ruled surface, u along the first. Of three and four the ends must meet in a
    ring: these make a Coons surface, with the first edge at v = 0, u along it; opposite to it
    three have a corner, at which the edge v = 1 is collapsed. `report` tells the order and what
    was reversed. Parametric curves are converted within the document's tolerance.

    :param curves: The edges, two to four.

    In scripts: ``edge_surface(curves: list of curves) -> surface``
    """
    return _called("edge_surface", (), {"curves": curves})  # type: ignore[no-any-return]


def edges(*args: Any, s: Any = None, f: Any = None) -> list[Curve]:
    """The four sides of a surface as curves, `[u0, u1, v0, v1]`, each with the surface's
    parameter along it.

    :param s: The surface.

    In scripts: ``edges(s: surface) -> list of curves``

    The border of a face from corner to corner, with the face to the left, seen from the tip of Su × Sv.

    A loop without corners is one closed curve. A seam over which the face goes is no border. Along lines
    of constant parameters, on planes, and where they are conics, edges are exact; elsewhere cubic or quintic
    splines within an eighth of the document's tolerance; `report` of an edge bounds how far from the surface it is.
    :param f: The face.

    In scripts: ``edges(f: face) -> list of curves``

    The edges that faces of a solid have in common, each once, from vertex to vertex.

    Where three faces meet edges end, and where an edge of one of them does. A seam over which one face goes is no edge. Along lines of
    constant parameters, on planes, and where they are conics, edges are exact; elsewhere splines within an eighth
    of the document's tolerance; `report` of an edge bounds how far from both faces it is. It tells as well whether it
    is `convex`, the least `angle` between its faces through the inside by what 24 places show (90deg of a box, 270deg
    of a notch), the numbers of its `faces`, and its `length`.
    :param s: The solid.

    In scripts: ``edges(s: solid) -> list of curves``
    """
    return _called("edges", args, {"s": s, "f": f})  # type: ignore[no-any-return]


def edit_points(c: Curve) -> FloatArray:
    """Points of a curve at its Greville parameters.

    Of a curve that is not clamped only those inside its domain.

    :param c: The curve.

    In scripts: ``edit_points(c: curve) -> list of points``
    """
    return _called_for(3, "edit_points", (), {"c": c})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def elevate(c: Curve, degree: float) -> Curve: ...

    @overload
    def elevate(s: Surface, *, u: float | None = None, v: float | None = None) -> Surface: ...


def elevate(*args: Any, c: Any = None, degree: Any = None, s: Any = None, u: Any = None, v: Any = None) -> Any:
    """The same curve at a higher degree, which is named.

    Exact: points, parameters and continuity stay; each inner knot stands once more for each
    degree. The result begins at its first control point and ends at its last.
    Prautzsch, *Degree elevation of B-spline curves*, CAGD 1 (1984).

    :param c: The curve.
    :param degree: The degree of the result, not below that of the curve.

    In scripts: ``elevate(c: curve, degree: integer) -> curve``

    The same surface at a higher degree along u, along v, or both; the degrees of the result are
    named.

    Exact: points, parameters and continuity stay. Along an elevated direction the result begins
    and ends at its control points. Piegl & Tiller, *The NURBS Book*, §5.5.
    :param s: The surface.
    :param u: The degree along u, not below that of the surface.
    :param v: The degree along v.

    In scripts: ``elevate(s: surface, u: integer = none, v: integer = none) -> surface``
    """
    return _called("elevate", args, {"c": c, "degree": degree, "s": s, "u": u, "v": v})


def ellipse(center: PointLike, rx: Quantity, ry: Quantity, *, normal: PointLike | None = None, x: PointLike | None = None) -> Curve:
    """Exact full ellipse as a rational curve on 0..1: the affine image of a circle.

    It starts at center + rx·x and runs counter-clockwise about the normal, where x is
    (1, 0, 0) made normal to the normal unless given, or (0, 1, 0) where those are parallel.
    Piegl & Tiller, *The NURBS Book*, §7.5.

    :param center: Its centre.
    :param rx: Its radius along x, positive.
    :param ry: Its radius across x, positive.
    :param normal: The direction that it runs around. Default: ``(0, 0, 1)``.
    :param x: The direction of the first radius; its part normal to the normal counts.

    In scripts: ``ellipse(center: point, rx: length, ry: length, normal: point = (0, 0, 1), x: point = none) -> curve``
    """
    return _called("ellipse", (), {"center": center, "rx": rx, "ry": ry, "normal": normal, "x": x})  # type: ignore[no-any-return]


def every(list: Any, f: FunctionLike | None = None) -> bool:
    """Whether the test holds for every element; of an empty list it is true.

    :param list: The list; a range of whole numbers counts as one.
    :param f: The test; left out where the elements are true or false themselves.

    In scripts: ``every(list: list of values, f: function = none) -> bool``
    """
    return _called("every", (), {"list": list, "f": f})  # type: ignore[no-any-return]


def exp(x: float) -> float:
    """The exponential function, e to the power `x`.

    :param x: The exponent.

    In scripts: ``exp(x: number) -> number``
    """
    return _called("exp", (), {"x": x})  # type: ignore[no-any-return]


def extend(c: Curve, length: Quantity, *, at: str | None = None) -> Curve:
    """Curve prolonged at an end by an arc length: its last polynomial piece goes on.

    The old part keeps its points and parameters, the domain grows, and there is no joint: all
    derivatives are continuous. Lines and circular arcs go on as such, an arc around its circle
    as often as the length says, with a joint where its polynomials reach no further.
    A parametric curve goes on as its function does beyond the domain.

    :param c: The curve.
    :param length: By how much, measured along the curve.
    :param at: Which end. Default: ``"end"``.

    In scripts: ``extend(c: curve, length: length, at: "end" | "start" = "end") -> curve``
    """
    return _called("extend", (), {"c": c, "length": length, "at": at})  # type: ignore[no-any-return]


def extrema(c: Curve, direction: PointLike) -> FloatArray:
    """Parameters where a curve reaches furthest in a direction, or furthest against it, compared
    with its neighbourhood; in order.

    Ends of an open curve are none. Found completely, as changes of sign of C'·d.
    Of a parametric curve they are followed as for `inflections`.

    :param c: The curve.
    :param direction: The direction, of any length but zero.

    In scripts: ``extrema(c: curve, direction: point) -> list of numbers``
    """
    return _called_for(1, "extrema", (), {"c": c, "direction": direction})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def extrude(c: Curve, vector: PointLike) -> Surface: ...

    @overload
    def extrude(r: Region, vector: PointLike) -> Solid: ...


def extrude(*args: Any, c: Any = None, vector: Any = None, r: Any = None) -> Any:
    """Surface that a curve leaves behind when it is moved along a vector.

    Exact: u runs along the curve on its own domain, v on 0..1 along the vector.
    A parametric curve is followed within the document's tolerance. Piegl & Tiller, *The NURBS Book*, §8.3.

    :param c: The curve.
    :param vector: Where each point of it goes.

    In scripts: ``extrude(c: curve, vector: point) -> surface``

    Solid that a region passes when it is moved along a vector, with both ends closed.

    Exact: the sides are the surfaces of the region's curves, the ends have its own borders. Its faces are the region where it was, where
    it comes to, and a side for each smooth part of its borders. Each hole goes through.
    :param r: The region.
    :param vector: Where each point of it goes.

    In scripts: ``extrude(r: region, vector: point) -> solid``
    """
    return _called("extrude", args, {"c": c, "vector": vector, "r": r})


def face(*args: Any, s: Any = None, loops: Any = None, space: Any = None, r: Any = None) -> Face:
    """Part of a surface that lies to the left of closed curves on it; without loops all of it.

    Left is seen from the tip of Su × Sv: a hole runs clockwise. Loops lie on the surface within the
    document's tolerance, or are curves of its parameters, `(u, v)`, with `space = "uv"`, which are kept
    exactly. They may run over the seam of a closed surface and around its poles. A list of curves is joined
    first, as `join` does. Loops that cross, touch or contradict one another make no face.

    What is asked of a surface at parameters is asked of a face too, inside of it: `f(u, v)`, `normal`,
    `principal` ... `f.surface` is the surface, `f.edges` the border from corner to corner, `f.loops` one
    closed curve for each loop.

    :param s: The surface.
    :param loops: Closed curves, or lists of curves that are joined to one.
    :param space: Whether loops are curves in space or of parameters. Default: ``"xyz"``.

    In scripts: ``face(s: surface | face, loops: list of curves or lists of curves = none, space: "xyz" | "uv" = "xyz") -> face``

    Face of a plane patch that holds what a region holds, with the same borders.

    Its normal points up, as that of the region; u and v are lengths along its plane.
    :param r: The region.

    In scripts: ``face(r: region) -> face``
    """
    return _called("face", args, {"s": s, "loops": loops, "space": space, "r": r})  # type: ignore[no-any-return]


def faces(s: Solid) -> list[Face]:
    """The faces of a solid, which look outward: `s.faces`.

    :param s: The solid.

    In scripts: ``faces(s: solid) -> list of faces``
    """
    return _called("faces", (), {"s": s})  # type: ignore[no-any-return]


def ferguson(*args: Any, points: Any = None, tangents: Any = None) -> Curve:
    """Cubic through points with given derivatives (Ferguson's curve), one unit of parameter a
    segment.

    Each segment has the Bézier points A, A + a/3, B - b/3, B. Segments meet with one
    derivative (C1); a tangent of length zero makes the curve stand still at its point, where
    it may have a corner. Linkeová, *Curves and Surfaces for Computer Graphics*, (2.1), (2.13).

    :param points: The points, two or more.
    :param tangents: The derivative at each point.

    In scripts: ``hermite(points: list of points, tangents: list of points) -> curve``
    """
    return _called("ferguson", args, {"points": points, "tangents": tangents})  # type: ignore[no-any-return]


def fillet(r: Region, radius: Quantity, *, at: PointsLike | None = None) -> Region:
    """Region with its corners rounded by arcs that touch both sides: all corners, or those at points.

    Outer corners lose what is beyond the arc, inner ones gain it. Beside lines, arcs and any other
    curves the arc touches both to the last bits.

    :param r: The region.
    :param radius: The radius of the arcs.
    :param at: Where the corners are; all when left out.

    In scripts: ``fillet(r: region, radius: length, at: list of points = none) -> region``
    """
    return _called("fillet", (), {"r": r, "radius": radius, "at": at})  # type: ignore[no-any-return]


def filter_(list: Any, f: FunctionLike) -> Any:
    """List of the elements of which `f` is true, in their order.

    :param list: The list; a range of whole numbers counts as one.
    :param f: The test.

    In scripts: ``filter(list: list of values, f: function) -> list of values``
    """
    return _called("filter", (), {"list": list, "f": f})


def first(list: Any) -> Any:
    """First element of a list.

    :param list: The list; one element or more.

    In scripts: ``first(list: list of values) -> any``
    """
    return _called("first", (), {"list": list})


def first_form(s: Surface | Face, u: float, v: float) -> dict[str, Any]:
    """Coefficients of the first fundamental form of a surface: `E` = Su·Su, `F` = Su·Sv, `G` = Sv·Sv.

    They measure lengths, angles and areas on the surface. do Carmo, *Differential Geometry of Curves
    and Surfaces*, §2-5.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``first_form(s: surface | face, u: number, v: number) -> record``
    """
    return _called("first_form", (), {"s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def flatten(list: Any, depth: float | None = None) -> Any:
    """The elements of the lists in a list, one level down or more; other elements stay.

    :param list: The list; a range of whole numbers counts as one.
    :param depth: How many levels down.

    In scripts: ``flatten(list: list of values, depth: integer = none) -> list of values``
    """
    return _called("flatten", (), {"list": list, "depth": depth})


if TYPE_CHECKING:

    @overload
    def flip(s: Surface) -> Surface: ...

    @overload
    def flip(f: Face) -> Face: ...


def flip(*args: Any, s: Any = None, f: Any = None) -> Any:
    """The same surface with its normal turned around: v runs backwards, as with `reverse_v`.

    `swap_uv` and `reverse_u` turn it around as well, and change something else.

    :param s: The surface.

    In scripts: ``flip(s: surface) -> surface``

    The same face with its normal turned around: v of its surface runs backwards.
    :param f: The face.

    In scripts: ``flip(f: face) -> face``
    """
    return _called("flip", args, {"s": s, "f": f})


def floor(x: Quantity) -> float:
    """The largest whole number that is not above `x`.

    :param x: A number that is no angle.

    In scripts: ``floor(x: number) -> number``
    """
    return _called("floor", (), {"x": x})  # type: ignore[no-any-return]


def fold(list: Any, start: Any, f: FunctionLike) -> Any:
    """Value that grows from `start` by `f(value, element)` through the list.

    :param list: The list; a range of whole numbers counts as one.
    :param start: The value before the first element.
    :param f: The function of the value so far and the element.

    In scripts: ``fold(list: list of values, start: any, f: function) -> any``
    """
    return _called("fold", (), {"list": list, "start": start, "f": f})


def format_(value: Any, *, digits: float | None = None, unit: str | None = None) -> str:
    """Text of a value with its numbers in one format: so many digits behind the point, and a unit.

    In a string `{x:.3}`, `{x:mm}` and `{x:.3mm}` say the same. A number without a unit counts as
    document units; an angle is told in degrees unless another unit is given. Numbers of points,
    lists and records are written alike, and texts stay as they are.

    :param value: A number, or a point, list or record of numbers.
    :param digits: Digits behind the point; as many as matter unless given.
    :param unit: The unit, such as "mm", "m^2", "1/m" or "deg", which stands behind the number.

    In scripts: ``format(value: any, digits: integer = none, unit: string = none) -> string``
    """
    return _called("format", (), {"value": value, "digits": digits, "unit": unit})  # type: ignore[no-any-return]


def frame(c: Curve, t: float, *, side: str | None = None) -> Frame:
    """Moving trihedron of a curve at its point: `.tangent`, `.normal` and `.binormal`, which are also
    x, y and z.

    Where the curve is straight there is none. Frenet's frame; do Carmo, *Differential Geometry of
    Curves and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``frame(c: curve, t: number, side: "right" | "left" = "right") -> plane``
    """
    return _called("frame", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def frame_of(origin: PointLike, x: PointLike, y: PointLike) -> Frame:
    """Frame at a point, with x along one direction and y in the half plane of another.

    Its axes are unit vectors at right angles; z makes them right-handed.

    :param origin: Where it stands.
    :param x: The direction of x.
    :param y: The direction whose part normal to x is y.

    In scripts: ``frame_of(origin: point, x: point, y: point) -> plane``
    """
    return _called("frame_of", (), {"origin": origin, "x": x, "y": y})  # type: ignore[no-any-return]


def gaussian(s: Surface | Face, u: float, v: float) -> float:
    """Gaussian curvature of a surface: the product of the principal curvatures.

    (LN − M²)/(EG − F²): positive where the surface is like a dome or bowl, negative at a saddle, zero
    where it can be unrolled. At the pole of a closed shape, where the parametrization is singular, it is the limit if the shape has one.

    do Carmo, *Differential Geometry of Curves and Surfaces*, §3-3.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``gaussian(s: surface | face, u: number, v: number) -> number``
    """
    return _called("gaussian", (), {"s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def genus(s: Solid) -> float:
    """How many handles a solid has, all of its shells together: 0 of a ball, 1 of a ring, and as many as there are holes of a plate with
    holes.

    By Euler and Poincaré, from the number of vertices, edges and faces.

    :param s: The solid.

    In scripts: ``genus(s: solid) -> integer``
    """
    return _called("genus", (), {"s": s})  # type: ignore[no-any-return]


def gordon(u: Sequence[Curve], v: Sequence[Curve], *, at_u: Any = None, at_v: Any = None, blend: str | None = None, tolerance: Quantity | None = None) -> Surface:
    """Surface through a network of curves, those along u and those along v.

    Where the curves meet is found unless it is given; they may be of any degree, direction,
    order and parameters. The first curve of each list gives the direction; others are reversed
    and reordered to it, and what stands out beyond the network is cut off. Where all curves of
    a direction close, so does the surface, as smooth at its seam as they are, and a curve across
    them that comes again, as one at their seam often does, counts once. Curves that meet
    the others at one set of parameters stay as they are, and are isocurves exactly, rational
    ones of one denominator too; others are run through with another parameter, twice
    continuously differentiable, and become splines of their degree, 3 or more, on as few knots
    as the tolerance needs. `report` tells what was done, and for each curve a bound of
    its distance from the surface, which is within the tolerance. Two and two curves make the
    Coons patch.
    Gordon (1969); Piegl & Tiller, *The NURBS Book*, §10.5.

    :param u: The curves along u, two or more.
    :param v: The curves along v, two or more.
    :param at_u: The u of each v-curve.
    :param at_v: The v of each u-curve.
    :param blend: Cubic splines between the curves, or one polynomial through all. Default: ``"spline"``.
    :param tolerance: How far curves may be apart where they meet, and the surface from them; the document's.

    In scripts: ``gordon(u: list of curves, v: list of curves, at_u: list of numbers without units = none, at_v: list of numbers without units = none, blend: "spline" | "lagrange" = "spline", tolerance: length = none) -> surface``
    """
    return _called("gordon", (), {"u": u, "v": v, "at_u": at_u, "at_v": at_v, "blend": blend, "tolerance": tolerance})  # type: ignore[no-any-return]


def gradient(f: FunctionLike, at: Any, *, differences: bool | None = None) -> Any:
    """Derivatives of a function's value by each of its unknowns at a place, exact but for rounding: of the
    shape of the place.

    The function is run on numbers that carry a derivative by each unknown along, once unless there are
    thousands, through operators,
    the functions of numbers and points, the making of geometry that grows evenly with what it is made of
    (of control points, of points at listed parameters, of curves; moved, scaled, turned, cut), and the
    questions about it: places, lengths, areas, volumes, nearest points. The first operation through which
    no derivative passes is named in the error; differences do without. Conditions of `if` and other
    comparisons decide by the value alone; what does not depend on an unknown has the derivative 0 by it.
    Griewank & Walther, *Evaluating Derivatives*, §3.1.

    :param f: A function of the unknowns that yields a number.
    :param at: The place: a number, a point, or a list or record of such.
    :param differences: Whether differences of the function's values are taken instead, some twenty for each unknown, through whatever it does: to some eight digits of what is computed to all, fewer of what is within a tolerance. Default: ``false``.

    In scripts: ``gradient(f: function, at: any, differences: bool = false) -> any``
    """
    return _called("gradient", (), {"f": f, "at": at, "differences": differences})


def greville(c: Curve) -> FloatArray:
    """Greville parameters of a curve, one a control point: means of as many consecutive knots as
    the degree says.

    There the point has most of its influence. Those of a curve that is not clamped may lie
    outside its domain. Farin, *Curves and Surfaces for CAGD*, §8.6.

    :param c: The curve.

    In scripts: ``greville(c: curve) -> list of numbers``
    """
    return _called_for(1, "greville", (), {"c": c})  # type: ignore[no-any-return]


def grid_mesh(s: Surface, nu: float, nv: float, *, quads: bool | None = None) -> Mesh:
    """Mesh of a surface over a regular grid of its parameters, two triangles a cell, with unit
    normals.

    Triangles run counter-clockwise seen from the side of Su × Sv. Those that a pole makes
    empty are left out. With `quads` the two of a cell are one face, which files that can hold
    quadrilaterals keep (`.obj`, `.ply`), and which is drawn without the diagonal.

    :param s: The surface.
    :param nu: Cells along u.
    :param nv: Cells along v.
    :param quads: Whether a cell is one face of four corners. Default: ``false``.

    In scripts: ``grid_mesh(s: surface, nu: integer, nv: integer, quads: bool = false) -> mesh``
    """
    return _called("grid_mesh", (), {"s": s, "nu": nu, "nv": nv, "quads": quads})  # type: ignore[no-any-return]


def helix(center: PointLike, radius: Quantity, pitch: Quantity, turns: float) -> Curve:
    """Helix around the z direction, on 0..1, nowhere further off than the document's tolerance.

    It starts at center + (radius, 0, 0) and runs counter-clockwise, upward for a positive
    pitch, with the parameter proportional to the angle. No NURBS curve is a helix: this one
    has pieces of degree 5 that share its points and first two derivatives at their ends (C2).

    :param center: The point of its axis beside which it starts.
    :param radius: Its radius, positive.
    :param pitch: How far it rises in a turn; below zero it goes down.
    :param turns: How many turns, positive, not necessarily a whole number.

    In scripts: ``helix(center: point, radius: length, pitch: length, turns: number) -> curve``
    """
    return _called("helix", (), {"center": center, "radius": radius, "pitch": pitch, "turns": turns})  # type: ignore[no-any-return]


def hermite(*args: Any, points: Any = None, tangents: Any = None) -> Curve:
    """Cubic through points with given derivatives (Ferguson's curve), one unit of parameter a
    segment.

    Each segment has the Bézier points A, A + a/3, B - b/3, B. Segments meet with one
    derivative (C1); a tangent of length zero makes the curve stand still at its point, where
    it may have a corner. Linkeová, *Curves and Surfaces for Computer Graphics*, (2.1), (2.13).

    :param points: The points, two or more.
    :param tangents: The derivative at each point.

    In scripts: ``hermite(points: list of points, tangents: list of points) -> curve``
    """
    return _called("hermite", args, {"points": points, "tangents": tangents})  # type: ignore[no-any-return]


def hodograph(c: Curve) -> Curve:
    """Curve of a curve's derivative vectors, on the same domain; exact, also with weights.

    Its degree is one less; with weights it is twice as high. At a corner it jumps.
    That of a parametric curve is parametric.
    Piegl & Tiller, *The NURBS Book*, (3.8) and (4.8).

    :param c: The curve.

    In scripts: ``hodograph(c: curve) -> curve``
    """
    return _called("hodograph", (), {"c": c})  # type: ignore[no-any-return]


def hyperbolic_paraboloid(p00: PointLike, p01: PointLike, p10: PointLike, p11: PointLike) -> Surface:
    """Surface of four corners, ruled by straight lines in both directions.

    The first index of a corner runs along u. Its corners in one plane make a plane piece, else
    it is a hyperbolic paraboloid. Piegl & Tiller, *The NURBS Book*, §8.3.

    :param p00: The corner at u = 0, v = 0.
    :param p01: The corner at u = 0, v = 1.
    :param p10: The corner at u = 1, v = 0.
    :param p11: The corner at u = 1, v = 1.

    In scripts: ``bilinear(p00: point, p01: point, p10: point, p11: point) -> surface``
    """
    return _called("hyperbolic_paraboloid", (), {"p00": p00, "p01": p01, "p10": p10, "p11": p11})  # type: ignore[no-any-return]


def hypot(x: Quantity, y: Quantity) -> float:
    """Length of the hypotenuse, the square root of x² + y² without overflow on the way.

    :param x: One leg.
    :param y: The other leg.

    In scripts: ``hypot(x: number, y: number) -> number``
    """
    return _called("hypot", (), {"x": x, "y": y})  # type: ignore[no-any-return]


def index_of(*args: Any, list: Any = None, element: Any = None, text: Any = None, part: Any = None) -> Any:
    """Index of the first element that is equal to a value as `==` says; none where there is none.

    :param list: The list; a range of whole numbers counts as one.
    :param element: The value.

    In scripts: ``index_of(list: list of values, element: any) -> any``

    Letter of a text at which a part first begins, counted from 0; none where it does not occur.
    :param text: The text.
    :param part: The part.

    In scripts: ``index_of(text: string, part: string) -> any``
    """
    return _called("index_of", args, {"list": list, "element": element, "text": text, "part": part})


def inertia(*args: Any, f: Any = None, s: Any = None, of: Any = None, r: Any = None) -> dict[str, Any]:
    """Inertia of a face about its centroid, of a skin with density one: `{tensor, moments, axes}` as for
    surfaces.

    :param f: The face.

    In scripts: ``inertia(f: face) -> record``

    Inertia about the centroid of what closed surfaces enclose, or of the surfaces themselves.

    `tensor` is the matrix of three rows about axes through the centroid, with density one;
    `moments` are its principal values in ascending order, and `axes` their directions, which are
    unit vectors and right-handed. Derivatives pass through. Of the volume the surfaces must close, as for `volume`.
    Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).
    :param s: The surface, or a list of surfaces.
    :param of: What is heavy: the inside or the skin. Default: ``"volume"``.

    In scripts: ``inertia(s: surface | list of surfaces or faces, of: "volume" | "area" = "volume") -> record``

    Inertia of a region about its centroid, of a skin with density one: `{tensor, moments, axes}` as
    for surfaces. The moments in the plane are those by which a beam of this section resists
    bending.
    :param r: The region.

    In scripts: ``inertia(r: region) -> record``

    Inertia of a solid about its centroid, or of its faces: `{tensor, moments, axes}` as for surfaces.
    :param s: The solid.
    :param of: What is heavy: the inside or the skin. Default: ``"volume"``.

    In scripts: ``inertia(s: solid, of: "volume" | "area" = "volume") -> record``
    """
    return _called("inertia", args, {"f": f, "s": s, "of": of, "r": r})  # type: ignore[no-any-return]


def inflections(c: Curve) -> FloatArray:
    """Parameters where a curve goes over from one way of bending to the other, in order.

    Of a planar curve, where its signed curvature changes sign; of a curve in space, where its
    curvature vanishes. Found completely, as changes of sign of C' × C''.
    Of a parametric curve the sign is followed between exact derivatives at the ends of small
    pieces, and each place is found on the function itself to the last digits.
    Farin, *Curves and Surfaces for CAGD*, §23.1.

    :param c: The curve.

    In scripts: ``inflections(c: curve) -> list of numbers``
    """
    return _called_for(1, "inflections", (), {"c": c})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def insert_knot(c: Curve, t: float, *, times: float | None = None) -> Curve: ...

    @overload
    def insert_knot(s: Surface, *, u: float | None = None, v: float | None = None, times: float | None = None) -> Surface: ...


def insert_knot(*args: Any, c: Any = None, t: Any = None, times: Any = None, s: Any = None, u: Any = None, v: Any = None) -> Any:
    """The same curve with one knot more, or with the same knot several times more.

    Exact: each time one control point more, and the control polygon nearer to the curve. A knot
    that stands as often as the degree is a control point on the curve; once more is the most.
    Piegl & Tiller, *The NURBS Book*, A5.1.

    :param c: The curve.
    :param t: The knot, inside the curve's domain.
    :param times: How many times. Default: ``1``.

    In scripts: ``insert_knot(c: curve, t: number, times: integer = 1) -> curve``

    The same surface with one knot more along u or v, or with the same knot several times more.

    Exact: each time one row, or column, of control points more. A knot that stands as often as
    the degree has control points on its isocurve. Piegl & Tiller, *The NURBS Book*, A5.3.
    :param s: The surface.
    :param u: The knot of u, inside the surface's domain.
    :param v: The knot of v; one of both is given.
    :param times: How many times. Default: ``1``.

    In scripts: ``insert_knot(s: surface, u: number = none, v: number = none, times: integer = 1) -> surface``
    """
    return _called("insert_knot", args, {"c": c, "t": t, "times": times, "s": s, "u": u, "v": v})


def integrate(f: FunctionLike, over: tuple[Quantity, Quantity] | Sequence[tuple[Quantity, Quantity]] | Curve | Region | Face | Surface | Sequence[Curve | Region | Face | Surface], *, tolerance: Quantity | None = None, report: bool | None = None) -> Any:
    """Integral of a function over a range; or over a box of two or three ranges, the length of a curve, the area
    of a region, a face or a surface, or several curves or several areas together. Of numbers it is a number,
    of points a point.

    It is known to thirteen digits of the integral of the function's size, or within `tolerance`; over boxes
    and areas to twelve. A region or face is divided into strips, so that the function is asked inside of it only;
    where the border of a face is known within a tolerance, so is the integral. Kinks and jumps are found, and the
    range is cut there. What none of the places that are asked shows is not seen: of a smooth function these are some
    30, and 200 evenly spread more before the answer is believed, along a curve as well; 16 for each range of several and
    each direction of an area, so that a peak that is narrower than a hundredth of the range, or there than a tenth,
    may lie between them; add up the integrals on both sides of its top. Ends of
    ranges and borders are never asked for, so that a function may grow without bound there: at 0 to all digits,
    elsewhere as near as numbers are apart, which a `tolerance` of 1e-6 allows for. An integral that has no finite
    value, or does not settle, is refused with the place.

    Over a range whose end lies before its start it is the negative, over one of no length 0. Derivatives pass
    through: that of an integral is the integral of the derivative, by an end of the range the function there, and
    by a place at which the function jumps, the jump.
    Piessens et al., *QUADPACK*, §2.2.1.

    :param f: A function that yields a number or a point: of a number over a range, of as many as there are ranges over a box, of a point over a curve or an area.
    :param over: The range; or a list of two or three, a curve, a region, a face, a surface, a list of curves or of areas.
    :param tolerance: How far the integral may be off, in units of its own; thirteen digits unless given.
    :param report: Whether a record tells how it was found: the `integral`, the `error` that two rules leave, and `evaluations`. Default: ``false``.

    In scripts: ``integrate(f: function, over: range | list of ranges | curve | region | face | surface | list of curves, regions, faces or surfaces, tolerance: number = none, report: bool = false) -> any``
    """
    return _called("integrate", (), {"f": f, "over": over, "tolerance": tolerance, "report": report})


def interpolate(*args: Any, points: Any = None, degree: Any = None, parameters: Any = None, ends: Any = None, tangents: Any = None, derivatives: Any = None, closed: Any = None, second_pass: Any = None) -> Any:
    """Spline through points, on 0..1 or over the parameters that are listed.

    A cubic has its knots at the points and obeys a condition at each end: the tangent of the
    parabola through three points ("bessel"), no bending ("natural"), a parabola as the last
    segment ("quadratic"), given derivatives ("clamped"), no knot at the second point
    ("not-a-knot"). With "averaged", and of any other degree, the knots are averages of the
    parameters and no condition is needed. Fewer points than degree + 1 lower the degree,
    except where tangents or "natural" make up for them. A closed curve is periodic: its seam
    is as smooth as its other joints. Farin, *Curves and Surfaces for CAGD*, §9; Piegl &
    Tiller, *The NURBS Book*, (9.8), (9.22), (9.23).

    :param points: The points, two or more.
    :param degree: The degree. Default: ``3``.
    :param parameters: Where on the curve the points lie: by a rule, or listed. A closed curve takes one more, for its return to the first point. Default: ``"chord"``.
    :param ends: What a cubic does where it begins and ends. Default: ``"bessel"``.
    :param tangents: The derivatives by the parameter at the start and at the end, of a cubic.
    :param derivatives: A derivative by the parameter for each point; of degree 2 or 3.
    :param closed: Whether the curve goes back to its first point, which may stand at the end again. Default: ``false``.

    In scripts: ``interpolate(points: list of points, degree: integer = 3, parameters: "uniform" | "chord" | "centripetal" | "foley" | list of numbers without units = "chord", ends: "bessel" | "natural" | "quadratic" | "clamped" | "not-a-knot" | "averaged" = "bessel", tangents: list of points = none, derivatives: list of points = none, closed: bool = false) -> curve``

    Spline surface through a grid of points, on 0..1 by 0..1 or over the parameters that are
    listed.

    First the lines along u become splines, then the rows of their control points along v, all
    with the same parameters: means over the lines. Along v these are means over the rows of
    the points ("data"), or over the rows of the control points of the first pass ("control").
    Too few lines lower the degree; three are enough for a cubic that has ends.
    Piegl & Tiller, *The NURBS Book*, §9.2.5; Vukašinović & Duhovnik, *Advanced CAD Modeling*,
    §1.3.
    :param points: The points: `points[i][j]`, i along u, j along v.
    :param degree: The degree, or `{u: , v: }`. Default: ``3``.
    :param parameters: Where the points lie, by a rule or listed; for both directions or `{u: , v: }`. Default: ``"chord"``.
    :param ends: What a cubic does where it begins and ends, or `{u: , v: }`. Default: ``"bessel"``.
    :param second_pass: Whose distances give the parameters along v. Default: ``"data"``.

    In scripts: ``interpolate(points: grid of points, degree: integer | record = 3, parameters: "uniform" | "chord" | "centripetal" | "foley" | list of numbers without units | record = "chord", ends: "bessel" | "natural" | "quadratic" | "clamped" | "not-a-knot" | "averaged" | record = "bessel", second_pass: "data" | "control" = "data") -> surface``
    """
    return _called("interpolate", args, {"points": points, "degree": degree, "parameters": parameters, "ends": ends, "tangents": tangents, "derivatives": derivatives, "closed": closed, "second_pass": second_pass})


if TYPE_CHECKING:

    @overload
    def intersect(a: Curve, b: Curve | Surface | Face) -> list[dict[str, Any]]: ...

    @overload
    def intersect(a: Surface | Face, b: Surface | Face | Curve) -> Any: ...

    @overload
    def intersect(s: Solid, c: Curve) -> list[dict[str, Any]]: ...


def intersect(*args: Any, a: Any = None, b: Any = None, s: Any = None, c: Any = None) -> Any:
    """Every place where two curves come within the document's tolerance of one another, as
    `[{t, s, point}]` in the order of `t`: `t` on the first, `s` on the second; or of a curve and a
    surface, as `[{t, u, v, point}]`.

    Found completely, by halving pairs of pieces until they are apart, cross clearly or touch.
    Where they touch, in whatever order, is one place: the nearest, from which the distance rises on
    both sides. Curves that share a stretch are an error that tells which.
    A parametric curve is searched as the spline that `length` tells of; each place is then found
    on the function itself.
    Where two curves cross clearly, inside of both, derivatives pass through; of what moves out of the plane of both
    tangents there is none in `t` and `s`. So they do where a curve crosses a surface.
    Sederberg & Nishita, *Curve intersection using Bézier clipping*, CAD 22 (1990).

    :param a: One curve.
    :param b: The other, or a surface or face.

    In scripts: ``intersect(a: curve, b: curve | surface | face) -> list of records``

    Curves in which two surfaces cross; or the places of a curve on a surface, as
    `[{t, u, v, point}]` in the order of `t`.

    Found completely, by halving pairs of parts until they are apart or cross in one arc at most,
    which is then followed: no loop is too small. Curves are exact lines and conics
    where a plane or another sphere cuts a plane, sphere, cylinder or cone, and cubic splines within
    the document's tolerance of both surfaces elsewhere, parametrized about by their length; they
    run along the product of the normal of `a` and that of `b`. They end at boundaries, and where several cross, as surfaces
    do where they touch. Neighbours meet in the edge that they share, which is among the curves as it
    is. A line along which they only touch is among the curves, and a warning
    tells of it, and of a touch in a single point, as of a corner. An edge that comes within the tolerance of
    the other surface without reaching it is told by such a warning alone. Surfaces that share an area are an error, and so
    is a curve that lies in the surface for a stretch. A parametric surface is taken as a spline
    within a part of the tolerance. `report` of a curve tells whether it is proven, and how far from both surfaces it may be.
    Where a curve crosses clearly, inside of both, derivatives pass through.
    Sederberg & Meyers, *Loop detection in surface patch intersections*, CAGD 5 (1988);
    Ye & Maekawa, *Differential geometry of intersection curves of two surfaces*, CAGD 16 (1999).
    :param a: A surface or face.
    :param b: Another surface or face, or a curve.

    In scripts: ``intersect(a: surface | face, b: surface | face | curve) -> list of values``

    Every place that a curve has in common with the faces of a solid, within the document's tolerance, as
    `[{t, face, u, v, point}]` in the order of `t`; `face` is its number among `s.faces`, on an edge the first.

    A curve that runs along the surface of a face, on the face or beside it, is an error.

    Between two of these places the curve is inside or outside, which `contains` of a point between them tells.
    :param s: The solid.
    :param c: The curve.

    In scripts: ``intersect(s: solid, c: curve) -> list of records``
    """
    return _called("intersect", args, {"a": a, "b": b, "s": s, "c": c})


def intersection(*args: Any, regions: Any = None, meshes: Any = None) -> Any:
    """What is in all of several regions, as a list of its parts, the largest first; `[]` where there is
    nothing.

    The borders of the result are parts of the given ones, exactly. Borders that run within the
    document's tolerance of one another are one; those that come as near without being one are
    refused with the place. Where nothing is in all of them, and a list of several stands among others, a warning
    tells that each of its members counts (W0013).

    :param regions: The regions, in one plane; lists count as their members.

    In scripts: ``intersection(regions: list of regions or lists of regions) -> list of regions``

    What is in all of several closed meshes; `none` where there is nothing.

    The meshes must close within the document's tolerance, with triangles that face outward and cross
    nowhere: `tessellate` makes such of surfaces that close. Faces that coincide are one. The result
    is of triangles without normals; its new vertices are rounded, and no further away than that.
    It is checked before it is given: it closes, and its volume and that of what the meshes have in
    common add up to theirs. What would touch itself in an edge or a point is refused with the place. Where nothing is in all
    of them, and a list of several stands among others, a warning tells that each of its members counts (W0013).
    :param meshes: The closed meshes; lists count as their members.

    In scripts: ``intersection(meshes: list of meshes or lists of meshes) -> mesh | none``
    """
    return _called("intersection", args, {"regions": regions, "meshes": meshes})


def is_closed(c: Curve) -> bool:
    """Whether a curve ends where it starts, to within the tolerance; `c.closed` is the same.

    :param c: The curve.

    In scripts: ``is_closed(c: curve) -> bool``
    """
    return _called("is_closed", (), {"c": c})  # type: ignore[no-any-return]


def is_developable(s: Surface) -> bool:
    """Whether a surface can be unrolled into a plane without being stretched: K = 0 everywhere.

    A curvature counts as none below 1e-9 over the size of the surface, or of the other curvature. Of a
    NURBS up to degree 8 that is looked at in enough places to hold for all of it; of a `parametric`
    surface at 49 × 49 places.

    Linkeová, *Curves and Surfaces for Computer Graphics*, §1.4.

    :param s: The surface.

    In scripts: ``is_developable(s: surface) -> bool``
    """
    return _called("is_developable", (), {"s": s})  # type: ignore[no-any-return]


def is_minimal(s: Surface) -> bool:
    """Whether a surface is minimal, like a soap film: its mean curvature is zero everywhere.

    A curvature counts as none below 1e-9 over the size of the surface, or of the largest curvature. Of a
    NURBS up to degree 8 that is looked at in enough places to hold for all of it; of a `parametric`
    surface at 49 × 49 places.

    do Carmo, *Differential Geometry of Curves and Surfaces*, §3-5.

    :param s: The surface.

    In scripts: ``is_minimal(s: surface) -> bool``
    """
    return _called("is_minimal", (), {"s": s})  # type: ignore[no-any-return]


def is_planar(*args: Any, c: Any = None, s: Any = None) -> bool:
    """Whether a curve lies in one plane, to within the tolerance.

    A straight curve does. Told from its control points, which lie in a plane with it.
    Of a parametric curve those of the spline that `length` tells of.

    :param c: The curve.

    In scripts: ``is_planar(c: curve) -> bool``

    Whether a surface lies in one plane, within the tolerance.

    One that is collapsed to a straight line does too. Told from the control points; of a `parametric` surface from points of it.
    :param s: The surface.

    In scripts: ``is_planar(s: surface) -> bool``
    """
    return _called("is_planar", args, {"c": c, "s": s})  # type: ignore[no-any-return]


def is_straight(c: Curve) -> bool:
    """Whether a curve lies on one line, to within the tolerance.

    Told from its control points, which lie on a line with it.
    Of a parametric curve those of the spline that `length` tells of.

    :param c: The curve.

    In scripts: ``is_straight(c: curve) -> bool``
    """
    return _called("is_straight", (), {"c": c})  # type: ignore[no-any-return]


def isophotes(s: Surface, light: PointLike, angles: Any) -> list[Curve]:
    """Curves on a surface along which its normal stands at one of the angles to the light, in the
    order of the angles: lines of equal brightness of a dull surface under a distant lamp.

    At `0deg` the surface faces the light, at `90deg` is the edge of the shade, at `180deg` it
    faces away; the lighter side is to the left of a curve, seen from the side of Su × Sv. Where
    surfaces meet with one tangent plane isophotes do not jump, with one curvature they
    have no kink. Found completely, by the signs of Bernstein coefficients, as `section` does.
    A patch that has an angle all over is told by its border, as a plane is. A parametric
    surface is taken as a spline within a thousandth of the tolerance.
    Poeschl, *Detecting surface irregularities using isophotes*, CAGD 1 (1984).

    :param s: The surface.
    :param light: The direction towards the light.
    :param angles: The angles between normal and light.

    In scripts: ``isophotes(s: surface, light: point, angles: list of angles) -> list of curves``
    """
    return _called("isophotes", (), {"s": s, "light": light, "angles": angles})  # type: ignore[no-any-return]


def join(*args: Any, curves: Any = None, patches: Any = None, texts: Any = None, separator: Any = None) -> Any:
    """Several curves, each starting where the one before ends, as one curve.

    Exact: each keeps the length of its domain, behind that of the one before; all get the
    highest degree among them, and weights that go on from one to the next. A joint keeps only
    the knots that its continuity needs, so that Bézier curves that meet C² become one
    spline with simple knots. Gaps up to the document's tolerance are closed halfway. A
    parametric curve is joined as a spline of degree 11 within 1e-13 of its size.

    :param curves: The curves in order, one or more.

    In scripts: ``join(curves: list of curves) -> curve``

    A grid of patches as one surface: `patches[i][j]`, i along u, j along v, as `decompose` gives
    them.

    Exact: each keeps the lengths of its domains, behind those before it; all get the highest
    degrees among them. A joint keeps only the knots that its continuity needs, so that
    bicubic patches that meet C² become one spline surface with simple knots. Gaps up to the
    document's tolerance are closed halfway. One strip of patches is `[[a, b]]` along v and
    `[[a], [b]]` along u. Linkeová, *Curves and Surfaces for Computer Graphics*, §3.7.
    :param patches: The patches, of which a single one stays as it is.

    In scripts: ``join(patches: list of lists of surfaces) -> surface``

    One text of several, with a separator between them.
    :param texts: The texts.
    :param separator: What stands between them.

    In scripts: ``join(texts: list of strings, separator: string) -> string``
    """
    return _called("join", args, {"curves": curves, "patches": patches, "texts": texts, "separator": separator})


def knot_class(c: Curve) -> dict[str, Any]:
    """What kind of knots a curve has, as `{class, clamped, uniform, periodic, bezier}`.

    `clamped` (also called open): both ends of the domain stand degree + 1 times. `uniform`: all
    spans of the domain are equally wide and no inner knot stands twice. `periodic`: the spans
    beyond each end repeat those at the other. `bezier`: clamped, and every inner knot stands
    degree times or more. `class` is the word that says most: `"bezier"`, `"clamped"`,
    `"periodic"` or `"unclamped"`, the last three also with `"uniform "` before them.
    Piegl & Tiller, *The NURBS Book*, §2.2 and §12.2.

    :param c: The curve.

    In scripts: ``knot_class(c: curve) -> record``
    """
    return _called("knot_class", (), {"c": c})  # type: ignore[no-any-return]


def knot_points(c: Curve) -> FloatArray:
    """Points of a curve at its knots, each once, the ends of its domain among them.

    :param c: The curve.

    In scripts: ``knot_points(c: curve) -> list of points``
    """
    return _called_for(3, "knot_points", (), {"c": c})  # type: ignore[no-any-return]


def lagrange(*args: Any, points: Any = None, parameters: Any = None) -> Curve:
    """The one polynomial through all points, of one degree less than there are points.

    On 0..1, or from the first to the last of the parameters that are listed. With many points
    it swings out between them (Runge's phenomenon), which gives a warning; `interpolate`
    does not. Farin, *Curves and Surfaces for CAGD*, §6.2.

    :param points: The points, two or more.
    :param parameters: Where on the curve they lie: evenly spaced, by another rule, or listed. Default: ``"uniform"``.

    In scripts: ``lagrange(points: list of points, parameters: "uniform" | "chord" | "centripetal" | "foley" | list of numbers without units = "uniform") -> curve``
    """
    return _called("lagrange", args, {"points": points, "parameters": parameters})  # type: ignore[no-any-return]


def last(list: Any) -> Any:
    """Last element of a list.

    :param list: The list; one element or more.

    In scripts: ``last(list: list of values) -> any``
    """
    return _called("last", (), {"list": list})


def len_(of: Any) -> float:
    """How many elements a list has, how many rows a table, or how many characters a string.

    :param of: A list, range of whole numbers, table or string.

    In scripts: ``len(of: any) -> integer``
    """
    return _called("len", (), {"of": of})  # type: ignore[no-any-return]


def length(*args: Any, f: Any = None, c: Any = None, range: Any = None, r: Any = None) -> float:
    """Length of all edges of a face together.

    :param f: The face.

    In scripts: ``length(f: face) -> length``

    Arc length of a curve, or of its part over a range of the parameter.

    Gaussian quadrature of |C'| over each polynomial piece, halved until its error is
    negligible; of degree 1 the sum of its legs.

    Of a parametric curve it is that of a spline of degree 11 with the function's exact
    derivatives at its knots, which agrees with it to 1e-13 of its size where it is compared: at
    16 places of each piece. Beside a place without derivatives that is 1e-6.
    :param c: The curve.
    :param range: The range, inside the curve's domain; all of it when left out.

    In scripts: ``length(c: curve, range: range = none) -> length``

    Length of all borders of a region together.
    :param r: The region.

    In scripts: ``length(r: region) -> length``
    """
    return _called("length", args, {"f": f, "c": c, "range": range, "r": r})  # type: ignore[no-any-return]


def lerp(a: Quantity | PointLike, b: Quantity | PointLike, t: float) -> Any:
    """The value at fraction `t` of the way from `a` to `b`, of numbers or points; exact at 0 and 1, and beyond them it goes on.

    :param a: The value at 0.
    :param b: The value at 1.
    :param t: The fraction.

    In scripts: ``lerp(a: number | point, b: number | point, t: number) -> any``
    """
    return _called("lerp", (), {"a": a, "b": b, "t": t})


def line(a: PointLike, b: PointLike) -> Curve:
    """Straight curve from one point to another, of degree 1 on 0..1.

    :param a: Where it starts.
    :param b: Where it ends.

    In scripts: ``line(a: point, b: point) -> curve``
    """
    return _called("line", (), {"a": a, "b": b})  # type: ignore[no-any-return]


def line_tangent(a: PointLike | Curve, b: PointLike | Curve, *, near: PointLike | None = None) -> Curve | list[Curve]:
    """Straight lines from a point or curve to another that touch each curve where they end: all of them, as a list in
    the order of the parameters of the places of contact, or the one that comes nearest to the point `near`.

    Both lie in one plane. A line touches where the curve is, its ends included, but not in a corner, nor where the
    curve stands still; straight parts of a curve touch nothing. Found completely, as lines that the tangents of
    both have in common, up to what touches within a millionth of a piece beside a standstill, and made exact by
    Newton's method. Curves that have a stretch in common have as many tangents as that has places, which is an
    error.

    :param a: Where it starts: a point, or a curve that it touches.
    :param b: Where it ends.
    :param near: A point to which the one that is meant comes nearest.

    In scripts: ``line_tangent(a: point | curve, b: point | curve, near: point = none) -> curve | list of curves``
    """
    return _called("line_tangent", (), {"a": a, "b": b, "near": near})  # type: ignore[no-any-return]


def linspace(a: Quantity, b: Quantity, n: float) -> FloatArray:
    """`n` numbers at equal distances from `a` to `b`, both included.

    :param a: The first number.
    :param b: The last number.
    :param n: How many; one gives the first alone.

    In scripts: ``linspace(a: number, b: number, n: integer) -> list of numbers``
    """
    return _called_for(1, "linspace", (), {"a": a, "b": b, "n": n})  # type: ignore[no-any-return]


def ln(x: float) -> float:
    """Natural logarithm, to the base e.

    :param x: A positive number.

    In scripts: ``ln(x: number) -> number``
    """
    return _called("ln", (), {"x": x})  # type: ignore[no-any-return]


def load(path: str) -> Any:
    """Data from a file, whose path is relative to the script. The ending tells the format.

    `.obj` gives a mesh, whose polygons are its `faces`. `.bpt` gives a list of Bézier surfaces: a
    count, then for each patch its two degrees and its points row by row. `.csv` gives a table:
    the first line names its columns, with their units as in `x [mm]`, `turn [deg]` or `area [mm^2]`, from which
    numbers are brought into the document's unit and radians; an empty cell is none. `.dat` gives the points of an aerofoil, in the form of Selig or of
    Lednicer, around the profile from the trailing edge over the upper side. `.json` gives what an
    export wrote, to the same bits, or lists and records of other JSON. Of an export in another unit the
    columns of tables are brought into the document's, all other numbers are taken as they stand, with a
    warning; so are those of a mesh whose `.obj` says `# unit: m`. Files are text in UTF-8, or in UTF-16 with its byte-order mark.
    The example's `points.csv` has the lines `x,y`, `0,0`, `1,2` and `4,3`.

    :param path: The path.

    In scripts: ``load(path: string) -> any``
    """
    return _called("load", (), {"path": path})


def loft(*args: Any, sections: Any = None, degree: Any = None, spine: Any = None, at: Any = None, parameters: Any = None, closed: Any = None, align: Any = None, start_tangent: Any = None, end_tangent: Any = None, shape: Any = None, pairing: Any = None, tolerance: Any = None) -> Any:
    """Surface through sections: u along them, v from one to the next.

    Sections of other degrees and knots are made compatible, exactly; rational ones are skinned
    in homogeneous space after their weights are normalised, so that a common factor of a
    section's weights changes nothing. A section may be a point where the surface begins or
    ends. Sections that run against their neighbour are reversed, closed ones as the way between
    them passes both, and seams of closed ones that are far from their neighbour's are moved. Where closed sections have corners, such as the tails
    of aerofoils, all seams go to corners that belong together, smooth ones beside them;
    neighbours with as many corners have them at the same parameters, so that edges of the
    surface run through them. The sections stand at parameters averaged from
    the distances of their control points, over knots averaged from these; of sections of unlike weights from distances
    in homogeneous space about the first control point, in which a weight counts as a length of the document's unit,
    or with "places" from those of their places, whatever the unit. With a spine the
    derivatives by v at the sections point along its tangents, and v is its parameter. Where
    weights between rational sections do not stay positive, a warning says so; with a tolerance,
    or where they would vanish, these sections become splines within it.
    "monotone" keeps each coordinate of the control points between its values at two
    neighbouring sections, so that nothing swings out, with C1 where that needs it.
    Piegl & Tiller, *The NURBS Book*, §10.3.

    :param sections: The sections in order, two or more: curves, and points at the ends.
    :param degree: The degree along v, from 1; fewer sections than degree + 1 lower it. Default: ``3``.
    :param spine: A curve whose tangents the surface takes at the sections; degree 2 or 3.
    :param at: The parameters of the spine at the sections.
    :param parameters: Where in v the sections stand: by a rule, or listed. A closed skin takes one more, for its return to the first section. Default: ``"average"``.
    :param closed: Whether the surface goes on from the last section to the first, as smooth there as anywhere. Default: ``false``.
    :param align: Whether sections are turned around, and seams moved, to run beside their neighbours. Default: ``true``.
    :param start_tangent: The derivative by v along the first section: a vector, or a curve of vectors.
    :param end_tangent: The derivative by v along the last section.
    :param shape: Whether the surface may swing out between sections. Default: ``"free"``.
    :param pairing: Whether points of equal parameter or of equal fraction of the length belong together; by "length", sections of uneven speed become cubic splines within the tolerance. Default: ``"parameter"``.
    :param tolerance: How far sections may move so that the surface has fewer knots along them.

    In scripts: ``skin(sections: list of curves or points, degree: integer = 3, spine: curve = none, at: list of numbers without units = none, parameters: "average" | "places" | "centripetal" | "uniform" | list of numbers without units = "average", closed: bool = false, align: bool = true, start_tangent: point | curve = none, end_tangent: point | curve = none, shape: "free" | "monotone" = "free", pairing: "parameter" | "length" = "parameter", tolerance: length = none) -> surface``

    Solid through regions, whose ends are the first and the last of them.

    Their borders are skinned as curves are, the outer ones, and holes in their order: u along them, v from one region
    to the next. All regions have as many holes. A closed skin goes on from the last region to the first, without
    ends.
    :param sections: The regions in order, two or more.
    :param degree: The degree along v, from 1; fewer regions than degree + 1 lower it. Default: ``3``.
    :param spine: A curve whose tangents the sides take at the regions; degree 2 or 3.
    :param at: The parameters of the spine at the regions.
    :param parameters: Where in v the regions stand: by a rule, or listed. A closed skin takes one more, for its return to the first region. Default: ``"places"``.
    :param closed: Whether the solid goes on from the last region to the first, as smooth there as anywhere. Default: ``false``.
    :param align: Whether borders are turned around, and seams moved, to run beside their neighbours. Default: ``true``.
    :param start_tangent: The derivative by v along the borders of the first region: a vector, or a curve of vectors.
    :param end_tangent: The derivative by v along those of the last region.
    :param shape: Whether the sides may swing out between regions. Default: ``"free"``.
    :param pairing: Whether points of equal parameter or of equal fraction of the length belong together; by "length", borders of uneven speed become cubic splines within the tolerance. Default: ``"parameter"``.
    :param tolerance: How far borders may move so that the sides have fewer knots along them.

    In scripts: ``skin(sections: list of regions, degree: integer = 3, spine: curve = none, at: list of numbers without units = none, parameters: "average" | "places" | "centripetal" | "uniform" | list of numbers without units = "places", closed: bool = false, align: bool = true, start_tangent: point | curve = none, end_tangent: point | curve = none, shape: "free" | "monotone" = "free", pairing: "parameter" | "length" = "parameter", tolerance: length = none) -> solid``
    """
    return _called("loft", args, {"sections": sections, "degree": degree, "spine": spine, "at": at, "parameters": parameters, "closed": closed, "align": align, "start_tangent": start_tangent, "end_tangent": end_tangent, "shape": shape, "pairing": pairing, "tolerance": tolerance})


def log10(x: float) -> float:
    """Decimal logarithm, to the base 10.

    :param x: A positive number.

    In scripts: ``log10(x: number) -> number``
    """
    return _called("log10", (), {"x": x})  # type: ignore[no-any-return]


def lower(text: str) -> str:
    """Text in small letters.

    :param text: The text.

    In scripts: ``lower(text: string) -> string``
    """
    return _called("lower", (), {"text": text})  # type: ignore[no-any-return]


def map_(list: Any, f: FunctionLike) -> Any:
    """List of what `f` makes of each element.

    :param list: The list; a range of whole numbers counts as one.
    :param f: The function; a curve or surface is one too.

    In scripts: ``map(list: list of values, f: function) -> list of values``
    """
    return _called("map", (), {"list": list, "f": f})


def max_(*args: Any, numbers: Any = None) -> float:
    """The largest of some numbers, given as a list or as the arguments themselves.

    :param numbers: The numbers; one or more.

    In scripts: ``max(numbers: list of numbers) -> number``
    """
    return _called("max", args, {"numbers": numbers})  # type: ignore[no-any-return]


def maximize(f: FunctionLike, *, within: tuple[Quantity, Quantity] | Sequence[tuple[Quantity, Quantity]] | dict[str, Any] | None = None, start: Any = None, subject: Any = None, report: bool | None = None) -> Any:
    """Unknowns at which a function is greatest: a number within a range, or several unknowns within bounds,
    from a start, and under conditions.

    Of one number in a range, which may be an end of it: seventeen places at nearly equal distances, and up to 257
    where the function turns often, tell near which the greatest value is; from there on the search goes by
    parabolas and golden sections. Where derivatives pass through the function they tell the last digits of the place,
    which has half of those that numbers have without; the value there has all. Brent, *Algorithms for Minimization
    without Derivatives*, ch. 5.

    Several unknowns are a point, or a list or record of numbers and points. The search begins at `start`,
    or at the best of 32 places that are spread over the bounds, and ends at the nearest valley's floor,
    which need not be the greatest of all. Its steps are those of sequential quadratic programming; gradients
    are exact where derivatives pass through all that the function does (see `gradient`), else central
    differences. What would be higher a little beside the answer is looked at before it is given: along each unknown, and
    of up to 200 along the ways that the conditions leave free and the function bends up, so that no saddle, nor
    the least value on a circle, is taken for the greatest. What does not settle in 5000 steps is refused. Nocedal &
    Wright, *Numerical Optimization*, ch. 18, §12.5.

    :param f: A function of the unknowns that yields a number; all may have a dimension.
    :param within: The range of one number, or a list or record of ranges for several; one range serves all of them. Unknowns of a record that it does not name are free, and so is what is left out of a point.
    :param start: Where the search begins; inside the bounds where there are any.
    :param subject: Conditions: a function of the unknowns that compares, `u => u.a + u.b <= 5 and u.a == 2*u.b`, or a list of such. They hold to eight digits of the unknowns; `<` is taken for `<=`.
    :param report: Whether a record tells how it was found: `at`, the `value` there, `evaluations`, and whether `derivatives` were `"exact"`, `"differences"` or `"none"`. Default: ``false``.

    In scripts: ``maximize(f: function, within: range | list of ranges | record = none, start: any = none, subject: any = none, report: bool = false) -> any``
    """
    return _called("maximize", (), {"f": f, "within": within, "start": start, "subject": subject, "report": report})


def mean(*args: Any, s: Any = None, u: Any = None, v: Any = None, list: Any = None) -> Any:
    """Mean curvature of a surface: the mean of the principal curvatures.

    (EN − 2FM + GL)/(2(EG − F²)). A curvature is positive where its centre lies on the side of Su × Sv.
    At the pole of a closed shape it is the limit, if the shape has one. do Carmo, *Differential
    Geometry of Curves and Surfaces*, §3-3.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``mean(s: surface | face, u: number, v: number) -> curvature``

    Arithmetic mean of numbers, or of points.
    :param list: The list; one element or more.

    In scripts: ``mean(list: list of values) -> any``
    """
    return _called("mean", args, {"s": s, "u": u, "v": v, "list": list})


def mesh(*args: Any, vertices: Any = None, faces: Any = None) -> Mesh:
    """Mesh of vertices and of faces over them: each the list of its corners, which are indices of
    vertices from 0, counter-clockwise seen from outside.

    A face of more than three corners stays a face, in `faces`, in the drawing and in files that can
    hold it (`.obj`, `.ply`); for everything else it is split into triangles. A quadrilateral is cut by
    the diagonal that leaves the larger least triangle, a convex polygon from its first corner, any
    other by a Delaunay triangulation within it. Faces need not be plane. The mesh has no normals, so
    that pictures show it faceted.

    :param vertices: The vertices.
    :param faces: The faces, a list of indices each.

    In scripts: ``mesh(vertices: list of points, faces: list of lists of values) -> mesh``
    """
    return _called("mesh", args, {"vertices": vertices, "faces": faces})  # type: ignore[no-any-return]


def midpoint(a: PointLike, b: PointLike) -> FloatArray:
    """The point halfway between two points.

    :param a: One point.
    :param b: The other point.

    In scripts: ``midpoint(a: point, b: point) -> point``
    """
    return _called("midpoint", (), {"a": a, "b": b})  # type: ignore[no-any-return]


def min_(*args: Any, numbers: Any = None) -> float:
    """The smallest of some numbers, given as a list or as the arguments themselves.

    :param numbers: The numbers; one or more.

    In scripts: ``min(numbers: list of numbers) -> number``
    """
    return _called("min", args, {"numbers": numbers})  # type: ignore[no-any-return]


def minimize(f: FunctionLike, *, within: tuple[Quantity, Quantity] | Sequence[tuple[Quantity, Quantity]] | dict[str, Any] | None = None, start: Any = None, subject: Any = None, report: bool | None = None) -> Any:
    """Unknowns at which a function is least: a number within a range, or several unknowns within bounds,
    from a start, and under conditions.

    Of one number in a range, which may be an end of it: seventeen places at nearly equal distances, and up to 257
    where the function turns often, tell near which the least value is; from there on the search goes by parabolas
    and golden sections. Where derivatives pass through the function they tell the last digits of the place, which has
    half of those that numbers have without; the value there has all. Where a whole stretch is least it is one place of
    it; a function that is the same everywhere is refused. Brent, *Algorithms for Minimization without Derivatives*,
    ch. 5.

    Several unknowns are a point, or a list or record of numbers and points. The search begins at `start`,
    or at the best of 32 places that are spread over the bounds, and ends at the nearest valley's floor,
    which need not be the least of all. Its steps are those of sequential quadratic programming; gradients
    are exact where derivatives pass through all that the function does (see `gradient`), else central
    differences. Exact ones tell the place to its last digits, by steps of Newton's method, but between kinks and on
    floors that are flat as that of a fourth power. What would be lower a little beside the answer is looked at before it is given: along each unknown, and
    of up to 200 along the ways that the conditions leave free and the function bends down, so that no saddle, nor
    the greatest value on a circle, is taken for the least. A start tells sizes that may be far from those over which the
    function bends: without conditions it is looked nearer and farther off by the sizes that the answer itself has, down to
    a billionth of the start and out by any power of it, and what is lower there is where the search begins anew. A level
    that the function only tends to, as far as numbers tell, is refused. What does not settle in 5000 steps is refused. Nocedal &
    Wright, *Numerical Optimization*, ch. 18, §12.5.

    Functions and conditions may have kinks, as sums of `abs` and the greatest of several have, which fit the most points
    or tolerate the least, straight or bent: the planes of what meets near the answer must hold one another off from
    whatever is lower, within a hundredth of the unknowns' sizes down to a hundred-millionth, and it is looked along the
    kinks whether they fall there; what is promised without its being found is refused, and kinks of more than 60
    unknowns may be. Without derivatives more is refused, and answers have some six digits. Lewis & Overton, *Nonsmooth
    optimization via quasi-Newton methods*, Math. Programming 141 (2013); Goldstein, *Optimization of Lipschitz continuous
    functions*, Math. Programming 13 (1977); Schramm & Zowe, *A version of the bundle idea*, SIAM J. Optim. 2 (1992).

    :param f: A function of the unknowns that yields a number; all may have a dimension.
    :param within: The range of one number, or a list or record of ranges for several; one range serves all of them. Unknowns of a record that it does not name are free, and so is what is left out of a point.
    :param start: Where the search begins; inside the bounds where there are any.
    :param subject: Conditions: a function of the unknowns that compares, `u => u.a + u.b <= 5 and u.a == 2*u.b`, or a list of such. They hold to eight digits of the unknowns; `<` is taken for `<=`.
    :param report: Whether a record tells how it was found: `at`, the `value` there, `evaluations`, and whether `derivatives` were `"exact"`, `"differences"` or `"none"`. Default: ``false``.

    In scripts: ``minimize(f: function, within: range | list of ranges | record = none, start: any = none, subject: any = none, report: bool = false) -> any``
    """
    return _called("minimize", (), {"f": f, "within": within, "start": start, "subject": subject, "report": report})


def mirror(g: Any, plane: Frame) -> Any:
    """Geometry reflected in a plane.

    :param g: What is reflected.
    :param plane: The plane that stays.

    In scripts: ``mirror(g: geometry, plane: plane) -> geometry``
    """
    return _called("mirror", (), {"g": g, "plane": plane})


def norm(v: PointLike) -> float:
    """Length of a vector.

    :param v: A vector.

    In scripts: ``norm(v: point) -> number``
    """
    return _called("norm", (), {"v": v})  # type: ignore[no-any-return]


def normal(*args: Any, c: Any = None, t: Any = None, side: Any = None, s: Any = None, u: Any = None, v: Any = None) -> FloatArray:
    """Principal unit normal of a curve: normal to the tangent, towards the centre of curvature.

    Where the curve is straight there is none. Frenet's frame; do Carmo, *Differential Geometry of
    Curves and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``normal(c: curve, t: number, side: "right" | "left" = "right") -> point``

    Unit normal of a surface, in the direction of Su × Sv.

    At a pole or a collapsed edge it is the limit, where that exists.
    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``normal(s: surface | face, u: number, v: number) -> point``
    """
    return _called("normal", args, {"c": c, "t": t, "side": side, "s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def normal_curvature(s: Surface | Face, u: float, v: float, direction: PointLike) -> float:
    """Normal curvature of a surface in a direction: the curvature of its section by the plane of the
    normal and that direction.

    Of a direction in space that is not tangent to the surface its part in the tangent plane counts.
    A curvature is positive where its centre lies on the side of Su × Sv. do Carmo, *Differential Geometry of
    Curves and Surfaces*, §3-2.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.
    :param direction: A direction of the tangent plane, of any length.

    In scripts: ``normal_curvature(s: surface | face, u: number, v: number, direction: point) -> curvature``
    """
    return _called("normal_curvature", (), {"s": s, "u": u, "v": v, "direction": direction})  # type: ignore[no-any-return]


def normal_line(*args: Any, c: Any = None, t: Any = None, length: Any = None, side: Any = None, s: Any = None, u: Any = None, v: Any = None) -> Curve:
    """Segment from a point of a curve along its principal normal.

    Where the curve is straight there is none.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param length: Its length; a negative one runs the other way. Default: ``1``.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``normal_line(c: curve, t: number, length: length = 1, side: "right" | "left" = "right") -> curve``

    Segment from a point of a surface along its normal.

    It runs along Su × Sv. At a pole or a collapsed edge it is the limit, where that exists.
    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.
    :param length: Its length; a negative one runs the other way. Default: ``1``.

    In scripts: ``normal_line(s: surface | face, u: number, v: number, length: length = 1) -> curve``
    """
    return _called("normal_line", args, {"c": c, "t": t, "length": length, "side": side, "s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def normal_plane(c: Curve, t: float, *, side: str | None = None) -> Frame:
    """Plane at a point of a curve that is normal to its tangent.

    Its z is the tangent; its x is the principal normal where there is one, else as for `plane`.
    do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``normal_plane(c: curve, t: number, side: "right" | "left" = "right") -> plane``
    """
    return _called("normal_plane", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def num(text: str) -> float:
    """Number that a text spells. Nobody has said what it measures, as of a coordinate. No derivative passes through a text: where one was made of what is differentiated, it is refused.

    :param text: The text, such as "12.5" or "1e-3".

    In scripts: ``num(text: string) -> number``
    """
    return _called("num", (), {"text": text})  # type: ignore[no-any-return]


def nurbs(*args: Any, points: Any = None, weights: Any = None, degree: Any = None, knots: Any = None) -> Any:
    """Rational B-spline (NURBS) of control points with weights, on given knots or on uniform
    clamped ones over 0..1.

    A larger weight pulls the curve towards its point, a weight of zero takes the point away.
    Piegl & Tiller, *The NURBS Book*, §4.2.

    :param points: The control points, more than the degree.
    :param weights: A weight for each point: none negative, the first and the last positive.
    :param degree: The degree. Default: ``3``.
    :param knots: All knots: one more than points and degree together.

    In scripts: ``nurbs(points: list of points, weights: list of numbers without units = none, degree: integer = 3, knots: list of numbers without units = none) -> curve``

    Rational B-spline surface (NURBS) of a grid with weights, on given knots or on uniform
    clamped ones over 0..1.

    Piegl & Tiller, *The NURBS Book*, §4.4.
    :param points: The control points: `points[i][j]`, i along u, j along v.
    :param weights: A weight for each point, in the same grid.
    :param degree: The degree, or `{u: , v: }`. Default: ``3``.
    :param knots: All knots, for both directions or `{u: , v: }`.

    In scripts: ``nurbs(points: grid of points, weights: list of lists of numbers without units = none, degree: integer | record = 3, knots: list of numbers without units | record = none) -> surface``
    """
    return _called("nurbs", args, {"points": points, "weights": weights, "degree": degree, "knots": knots})


def ode(f: FunctionLike, start: Any, range: tuple[Quantity, Quantity], *, tolerance: Quantity | None = None) -> Any:
    """Curve of a point that starts somewhere and changes at the rate that a function tells: the solution of an
    ordinary differential equation, such as a streamline or a curve of given curvature.

    Its parameter is the variable of the function, over the range. Several points that depend on one
    another, such as a place and a velocity, are a list: the function is given a list and yields one, and the
    result is a list of curves. Numbers are coordinates of points.

    The curve is a spline of degree 5 with two continuous derivatives. It is followed again with smaller
    errors in each step until it stays the same within the tolerance, so that the last one is nearer still;
    `report` tells by how much they differ as `error`, and has `steps` and `evaluations`. The rate is looked at
    between the places of its steps as well, so that what acts on a hundredth of the range is seen; what acts on less
    may lie between them: let ranges end where it begins and ends. Where the point
    grows without bound, or more than 50000 steps are needed, as for stiff equations, that is refused with
    the place. Derivatives pass through, by what the function and the start depend on, within the tolerance.
    Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, §II.4-II.6.

    :param f: A function of the variable and the point, or the list of points, that yields the derivative.
    :param start: Where the point is at the start of the range, or a list of points.
    :param range: The range of the variable.
    :param tolerance: How far the curve may be off, 1e-12 of its size at least; the document's tolerance unless given.

    In scripts: ``ode(f: function, start: any, range: range, tolerance: length = none) -> any``
    """
    return _called("ode", (), {"f": f, "start": start, "range": range, "tolerance": tolerance})


if TYPE_CHECKING:

    @overload
    def offset(c: Curve, distance: Quantity, *, normal: PointLike | None = None) -> Curve: ...

    @overload
    def offset(s: Surface, distance: Quantity, tolerance: Quantity) -> Surface: ...

    @overload
    def offset(f: Face, distance: Quantity, *, tolerance: Quantity | None = None) -> Face: ...

    @overload
    def offset(r: Region, distance: Quantity, *, corner: str | None = None) -> list[Region]: ...


def offset(*args: Any, c: Any = None, distance: Any = None, normal: Any = None, s: Any = None, tolerance: Any = None, f: Any = None, r: Any = None, corner: Any = None) -> Any:
    """Curve at a distance beside another one, to the right of it seen against the normal: a curve
    that runs counter-clockwise about the normal grows for a positive distance.

    A parametric curve is first replaced by the spline that `length` tells of.
    Each point goes to C + d·(T × n) / |T × n|. Circular arcs and polygons in a plane normal to
    the normal have exact offsets, polygons with their corners kept; others are splines of
    degree 5 on the same parameters, proven to be nowhere further from the true offset than the
    document's tolerance. At other corners an arc is put in, with parameters of its own, so that
    the later ones move. Nothing is cut off: where the distance is a radius of curvature on the
    side of the centre, the offset has a cusp; where the curve turns to its side within the
    distance, it folds back and crosses itself. Warnings tell all that, and `report` has
    `{distance, deviation, cusps, folds, crossings}`: cusps and folds by parameters of the
    curve, crossings `{t, s, point}` by those of the offset.
    Maekawa, *An overview of offset curves and surfaces*, CAD 31 (1999).

    :param c: The curve.
    :param distance: The distance; a negative one goes to the left.
    :param normal: What the curve turns about. Default: ``(0, 0, 1)``.

    In scripts: ``offset(c: curve, distance: length, normal: point = (0, 0, 1)) -> curve``

    Surface at a distance beside another one, on the side of its normal for a positive distance:
    the points S + d·N, on the same parameters.

    Exact, with the degrees, knots and weights of the surface, where that is possible: planes,
    spheres, cylinders, cones, tori. Others are quintic splines through points of the true
    offset, with knots added until its distance, measured at 16 places of each patch, is
    below half of the tolerance; `report` tells the largest with its parameters. At a pole the limit of the normal
    counts. A crease, and a place where the normal has no limit, are errors. Where the distance is
    beyond a radius of curvature on that side the offset turns back: it is kept, and a
    warning tells the tightest place.
    Piegl & Tiller, *Computing offsets of NURBS curves and surfaces*, CAD 31 (1999).
    :param s: The surface.
    :param distance: The distance; a negative one goes against the normal.
    :param tolerance: How far the result may be from the true offset.

    In scripts: ``offset(s: surface, distance: length, tolerance: length) -> surface``

    Face at a distance beside another one, on the side of its normal for a positive distance: the part of the offset
    of its surface within the same curves of parameters.

    Exact on planes, spheres, cylinders, cones and tori; other surfaces as `offset` of a surface tells. Where the
    whole surface has no offset, because of a crease beside the face for one, that of the part around the face is
    taken. A distance that passes a centre of curvature is refused.
    :param f: The face.
    :param distance: The distance; a negative one goes against the normal.
    :param tolerance: How far the result may be from the true offset; otherwise the document's tolerance.

    In scripts: ``offset(f: face, distance: length, tolerance: length = none) -> face``

    Region grown by a distance, shrunk by a negative one, as a list of its parts, the largest first, as
    it may fall apart; `[]` where nothing is left.

    The result is what lies within the distance (or further than it from the outside), so that holes
    close, narrow bridges go, and nothing crosses itself. At corners that are torn open `"round"` puts an
    arc, `"miter"` lets both sides go on until they meet, no further than ten times the distance, where they
    are cut off straight across, and `"bevel"` cuts straight across at once. Lines and arcs stay such; other borders keep the document's
    tolerance.
    :param r: The region.
    :param distance: The distance; a negative one shrinks.
    :param corner: What becomes of corners. Default: ``"round"``.

    In scripts: ``offset(r: region, distance: length, corner: "round" | "miter" | "bevel" = "round") -> list of regions``
    """
    return _called("offset", args, {"c": c, "distance": distance, "normal": normal, "s": s, "tolerance": tolerance, "f": f, "r": r, "corner": corner})


def orient(surfaces: Any) -> list[Face | Surface]:
    """The surfaces and faces of a list, some of them flipped so that all that hang together face alike:
    outward where they enclose a volume, otherwise as the first of them.

    They hang together where their edges run within the document's tolerance; each part of the
    list that does is taken on its own. Surfaces that make a one-sided whole, and edges that three
    surfaces share, are refused. Exports of meshes turn what encloses a volume by themselves, and
    tell of it.

    :param surfaces: The surfaces and faces.

    In scripts: ``orient(surfaces: list of surfaces or faces) -> list of surfaces or faces``
    """
    return _called("orient", (), {"surfaces": surfaces})  # type: ignore[no-any-return]


def osculating_circle(c: Curve, t: float, *, side: str | None = None) -> Curve:
    """Circle that agrees with a curve up to the second derivative, as an exact curve on 0..1.

    It starts at the point of the curve and runs in its direction. Where the curve is straight there
    is none.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``osculating_circle(c: curve, t: number, side: "right" | "left" = "right") -> curve``
    """
    return _called("osculating_circle", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def osculating_plane(c: Curve, t: float, *, side: str | None = None) -> Frame:
    """Plane of the osculating circle of a curve, which holds tangent and principal normal.

    Its z is the binormal, its x the tangent. Where the curve is straight there is none.
    do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``osculating_plane(c: curve, t: number, side: "right" | "left" = "right") -> plane``
    """
    return _called("osculating_plane", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def pad(text: str, width: float, *, side: str | None = None, fill: str | None = None) -> str:
    """Text with spaces on one side, so that it has at least so many letters.

    Numbers stand under one another with their spaces on the left: `pad("{x:.2}", 8)`.

    :param text: The text.
    :param width: How many letters it is to have; a longer text stays as it is.
    :param side: Where the spaces stand. Default: ``"left"``.
    :param fill: What stands there instead of a space: one letter.

    In scripts: ``pad(text: string, width: integer, side: "left" | "right" = "left", fill: string = none) -> string``
    """
    return _called("pad", (), {"text": text, "width": width, "side": side, "fill": fill})  # type: ignore[no-any-return]


def parameter_at_length(c: Curve, s: Quantity) -> float:
    """Parameter at which a curve is so long from its start: the inverse of `length`.

    Newton's method on the arc length, kept inside a bracket.
    Of a parametric curve on the same spline as `length`.

    :param c: The curve.
    :param s: The length from the start, not above the curve's own.

    In scripts: ``parameter_at_length(c: curve, s: length) -> number``
    """
    return _called("parameter_at_length", (), {"c": c, "s": s})  # type: ignore[no-any-return]


def parametric(*args: Any, f: Any = None, domain: Any = None, domain_u: Any = None, domain_v: Any = None) -> Any:
    """Curve of any function that yields a point for a parameter.

    It is the function itself and no approximation. Its derivatives are exact, not differences:
    they are carried through everything that the function computes, through `if`, blocks, calls
    and lists too. The function is tried at some places when the curve is made, and refused where
    it has no derivative at any of them, because an operation in it passes none: such a curve could
    not be drawn, measured or exported. Griewank & Walther, *Evaluating Derivatives*, ch. 13.

    :param f: The function, of one parameter without a unit.
    :param domain: The range of the parameter.

    In scripts: ``parametric(f: function, domain: range) -> curve``

    Surface of any function that yields a point for two parameters.

    It is the function itself and no approximation, and its derivatives are exact, as those of
    a parametric curve are. Griewank & Walther, *Evaluating Derivatives*, ch. 13.
    :param f: The function, of two parameters without a unit.
    :param domain_u: The range of the first parameter.
    :param domain_v: The range of the second parameter.

    In scripts: ``parametric(f: function, domain_u: range, domain_v: range) -> surface``
    """
    return _called("parametric", args, {"f": f, "domain": domain, "domain_u": domain_u, "domain_v": domain_v})


def place(g: Any, frame: Frame) -> Any:
    """Geometry drawn about the origin, carried to a frame: its x, y and z along those of the
    frame.

    :param g: What is carried.
    :param frame: Where it goes.

    In scripts: ``place(g: geometry, frame: plane) -> geometry``
    """
    return _called("place", (), {"g": g, "frame": frame})


def planar_mesh(*args: Any, r: Any = None, tolerance: Any = None, curve: Any = None) -> Mesh:
    """Mesh of a region, whose borders are nowhere further from the curves than the tolerance.

    All vertices are on the borders; the triangles are as far from slivers as that allows.

    :param r: The region.
    :param tolerance: The tolerance; when left out a thousandth of the size of the region.

    In scripts: ``planar_mesh(r: region, tolerance: length = none) -> mesh``

    Mesh of the plane region within a closed curve, or within the first of a list and outside of
    the others, which are holes.

    The normals are on the side from which the (outer) curve runs counter-clockwise. All vertices
    are on the borders, whose polygons are nowhere further from the curves than the tolerance;
    their triangles are as far from slivers as that allows.
    Chew, *Constrained Delaunay triangulations*, Algorithmica 4 (1989).
    :param curve: The closed curve, or a list of the outer one and the holes.
    :param tolerance: The tolerance; when left out a thousandth of the size of the region.

    In scripts: ``planar_mesh(curve: curve | list of curves, tolerance: length = none) -> mesh``
    """
    return _called("planar_mesh", args, {"r": r, "tolerance": tolerance, "curve": curve})  # type: ignore[no-any-return]


def plane(origin: PointLike, normal: PointLike, *, x: PointLike | None = None) -> Frame:
    """Plane through a point, with the normal as its z.

    Its x is (1, 0, 0) made normal to the normal unless given, or (0, 1, 0) where those are
    parallel; its y makes them right-handed.

    :param origin: A point of it, the origin of its coordinates.
    :param normal: The direction that stands on it.
    :param x: The direction of its x; the part that is normal to the normal counts.

    In scripts: ``plane(origin: point, normal: point, x: point = none) -> plane``
    """
    return _called("plane", (), {"origin": origin, "normal": normal, "x": x})  # type: ignore[no-any-return]


def plane_patch(origin: PointLike, x: PointLike, y: PointLike) -> Surface:
    """Flat surface of two edges that meet at a corner: origin + u·x + v·y, u and v on 0..1.

    :param origin: The corner at u = 0, v = 0.
    :param x: The edge from there along u.
    :param y: The edge from there along v, not parallel to the other.

    In scripts: ``plane_patch(origin: point, x: point, y: point) -> surface``
    """
    return _called("plane_patch", (), {"origin": origin, "x": x, "y": y})  # type: ignore[no-any-return]


def polar(r: Quantity, angle: Quantity) -> FloatArray:
    """Point of the xy-plane at a distance and an angle from the origin, counter-clockwise from the x-axis.

    :param r: The distance.
    :param angle: The angle.

    In scripts: ``polar(r: length, angle: angle) -> point``
    """
    return _called("polar", (), {"r": r, "angle": angle})  # type: ignore[no-any-return]


def polyline(*args: Any, points: Any = None, closed: Any = None) -> Curve:
    """Straight legs from point to point, a curve of degree 1 with one unit of parameter a leg.

    :param points: The corners, two or more.
    :param closed: Whether a last leg leads back to the first point, unless the last point is there. Default: ``false``.

    In scripts: ``polyline(points: list of points, closed: bool = false) -> curve``
    """
    return _called("polyline", args, {"points": points, "closed": closed})  # type: ignore[no-any-return]


def polynomial(*args: Any, coefficients: Any = None, domain: Any = None) -> Curve:
    """Polynomial curve of its coefficients, the lowest power first.

    The point at t is c0 + c1·t + c2·t² + …; the curve is held as a Bézier curve over the
    domain. Piegl & Tiller, *The NURBS Book*, §1.2.

    :param coefficients: The coefficients, as a list or as the arguments themselves.
    :param domain: The parameters that have a point. Default: ``0..1``.

    In scripts: ``polynomial(coefficients: list of points, domain: range = 0..1) -> curve``
    """
    return _called("polynomial", args, {"coefficients": coefficients, "domain": domain})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def power_coefficients(c: Curve) -> FloatArray: ...

    @overload
    def power_coefficients(s: Surface) -> list[FloatArray]: ...


def power_coefficients(*args: Any, c: Any = None, s: Any = None) -> Any:
    """Coefficients of a curve of one polynomial segment, the lowest power of its parameter first.

    The inverse of `polynomial`. Of a curve of several segments take one by `to_bezier`.
    Piegl & Tiller, *The NURBS Book*, §1.2.

    :param c: The curve, without weights and of one segment.

    In scripts: ``power_coefficients(c: curve) -> list of points``

    Coefficients of a surface of one polynomial patch: that of u^i v^j is `[i][j]`.

    Of a surface of several patches take one by `decompose`.
    Piegl & Tiller, *The NURBS Book*, §1.5.
    :param s: The surface, without weights and of one patch.

    In scripts: ``power_coefficients(s: surface) -> list of lists of points``
    """
    return _called("power_coefficients", args, {"c": c, "s": s})


def principal(s: Surface | Face, u: float, v: float) -> dict[str, Any]:
    """Principal curvatures of a surface, `k1` ≤ `k2`, and their directions `d1`, `d2`, unit vectors of
    the tangent plane.

    A curvature is positive where its centre lies on the side of Su × Sv. The directions are at right angles,
    d1 to the side of Su and d2 = normal × d1. At an umbilic both curvatures are equal and every
    direction is a principal one: d1 is then that of Su.

    do Carmo, *Differential Geometry of Curves and Surfaces*, §3-2.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``principal(s: surface | face, u: number, v: number) -> record``
    """
    return _called("principal", (), {"s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def product(list: Any) -> float:
    """Product of numbers; of an empty list 1. Units multiply too.

    :param list: The numbers.

    In scripts: ``product(list: list of numbers) -> number``
    """
    return _called("product", (), {"list": list})  # type: ignore[no-any-return]


def project(c: Curve, plane: Frame) -> Any:
    """Curve projected onto a plane along the plane's normal; exact.

    Piegl & Tiller, *The NURBS Book*, §6.3.

    :param c: The curve.
    :param plane: The plane.

    In scripts: ``project(c: curve, plane: plane) -> geometry``
    """
    return _called("project", (), {"c": c, "plane": plane})


def radius_of_curvature(c: Curve, t: float, *, side: str | None = None) -> float:
    """Radius of the osculating circle of a curve: the reciprocal of the curvature.

    Where the curve is straight there is none.
    do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``radius_of_curvature(c: curve, t: number, side: "right" | "left" = "right") -> length``
    """
    return _called("radius_of_curvature", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def random(n: float, *, seed: float | None = None) -> FloatArray:
    """`n` random numbers from 0 to 1 without 1, uniformly spread; the same on every machine for the same seed.

    Vigna's SplitMix64 (Steele, Lea & Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014), the upper 53 bits of each word.

    :param n: How many.
    :param seed: A whole number that chooses the sequence. Default: ``0``.

    In scripts: ``random(n: integer, seed: integer = 0) -> list of numbers``
    """
    return _called_for(1, "random", (), {"n": n, "seed": seed})  # type: ignore[no-any-return]


def range_(a: Quantity, b: Quantity, step: Quantity) -> FloatArray:
    """Numbers from `a` towards `b` at a step; `b` is included when it is reached.

    Each number is a + i*step, so that no error adds up.

    :param a: The first number.
    :param b: Where it ends.
    :param step: The step; negative to go down.

    In scripts: ``range(a: number, b: number, step: number) -> list of numbers``
    """
    return _called_for(1, "range", (), {"a": a, "b": b, "step": step})  # type: ignore[no-any-return]


def rectifying_plane(c: Curve, t: float, *, side: str | None = None) -> Frame:
    """Plane at a point of a curve that holds its tangent and its binormal.

    Its z is the principal normal, its x the binormal. Where the curve is straight there is none.
    do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``rectifying_plane(c: curve, t: number, side: "right" | "left" = "right") -> plane``
    """
    return _called("rectifying_plane", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def reduce(c: Curve, tolerance: Quantity, *, degree: float | None = None) -> Curve:
    """Curve at the lowest degree that leaves every point within a tolerance, or at a degree that
    is named.

    Both ends stay. Where not even one degree less is within the tolerance it is an error that
    tells how far the curve would move, as an upper bound rarely more than 2% above the truth. Undoes
    `elevate`. Piegl & Tiller, *The NURBS Book*, §5.6.

    :param c: The curve, of degree 2 or more.
    :param tolerance: How far a point of the curve may move.
    :param degree: The degree of the result.

    In scripts: ``reduce(c: curve, tolerance: length, degree: integer = none) -> curve``
    """
    return _called("reduce", (), {"c": c, "tolerance": tolerance, "degree": degree})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def refine(c: Curve, knots: Any) -> Curve: ...

    @overload
    def refine(s: Surface, *, u: Any = None, v: Any = None) -> Surface: ...


def refine(*args: Any, c: Any = None, knots: Any = None, s: Any = None, u: Any = None, v: Any = None) -> Any:
    """The same curve with more knots; a knot that is to be there twice more is given twice.

    Exact: one control point more for each. A knot within rounding of one that is there already
    counts as that one. Piegl & Tiller, *The NURBS Book*, A5.4.

    :param c: The curve.
    :param knots: The knots to insert, in any order, inside the curve's domain.

    In scripts: ``refine(c: curve, knots: list of numbers without units) -> curve``

    The same surface with more knots along u, along v, or both; a knot that is to be there twice
    more is given twice.

    Exact: one row, or column, of control points more for each. A knot within rounding of one
    that is there already counts as that one. Piegl & Tiller, *The NURBS Book*, A5.5.
    :param s: The surface.
    :param u: The knots of u to insert, in any order, inside the surface's domain.
    :param v: The knots of v to insert.

    In scripts: ``refine(s: surface, u: list of numbers without units = none, v: list of numbers without units = none) -> surface``
    """
    return _called("refine", args, {"c": c, "knots": knots, "s": s, "u": u, "v": v})


def reflection_lines(s: Surface, eye: PointLike, lights: Sequence[Curve]) -> list[Curve]:
    """Curves on a surface where the eye sees straight lights mirrored, in the order of the lights.

    A light is endless: the straight line that the given one lies on. It is seen at S where the
    ray r = 2(N·e)N − e, e towards the eye, meets it ahead of the surface; the surface
    mirrors on both of its sides, and hides nothing. Complete, and of the kind that `section`
    gives. A parametric surface is taken as a spline within a thousandth of the tolerance.
    Klass, *Correction of local surface irregularities using reflection lines*, CAD 12 (1980).

    :param s: The surface.
    :param eye: Where the eye is.
    :param lights: The lights, straight curves.

    In scripts: ``reflection_lines(s: surface, eye: point, lights: list of curves) -> list of curves``
    """
    return _called("reflection_lines", (), {"s": s, "eye": eye, "lights": lights})  # type: ignore[no-any-return]


def region(outer: Curve | Sequence[Curve], *, holes: Any = None) -> Region:
    """What lies within a closed plane curve and outside of others, which are holes.

    A list of curves is joined first, as `join` does. The curves may run in either sense; seen from
    where the plane's normal points, which is up, borders run with the region to their left:
    `r.outer` counter-clockwise, `r.holes` clockwise. `r.plane` is the plane. Curves that cross or
    touch make no border; `regions` fills them by the even-odd rule, and `difference` cuts one
    region out of another. A parametric curve becomes a spline within 1e-13 of its size.

    :param outer: The closed curve, or curves that are joined to one.
    :param holes: Closed curves within it.

    In scripts: ``region(outer: curve | list of curves, holes: list of curves or lists of curves = none) -> region``
    """
    return _called("region", (), {"outer": outer, "holes": holes})  # type: ignore[no-any-return]


def regions(curves: Sequence[Curve]) -> list[Region]:
    """What an odd number of closed curves goes around, in one plane: outlines with their holes, sorted
    by what lies in what; the largest part first.

    Curves may cross themselves and one another, and run in either sense.

    :param curves: The closed curves.

    In scripts: ``regions(curves: list of curves) -> list of regions``
    """
    return _called("regions", (), {"curves": curves})  # type: ignore[no-any-return]


def remove_knot(c: Curve, t: float, tolerance: Quantity, *, times: float | None = None) -> Curve:
    """Curve without an inner knot, where no point of it moves further than a tolerance.

    One control point less each time. Where the curve would move further it is an error that
    tells how far, as an upper bound rarely more than 2% above the truth. Undoes `insert_knot`.
    Piegl & Tiller, *The NURBS Book*, §5.4.

    :param c: The curve.
    :param t: The knot, one between the ends of the domain.
    :param tolerance: How far a point of the curve may move.
    :param times: How many times. Default: ``1``.

    In scripts: ``remove_knot(c: curve, t: number, tolerance: length, times: integer = 1) -> curve``
    """
    return _called("remove_knot", (), {"c": c, "t": t, "tolerance": tolerance, "times": times})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def reparametrize(c: Curve, domain: tuple[Quantity, Quantity]) -> Curve: ...

    @overload
    def reparametrize(s: Surface, *, u: tuple[Quantity, Quantity] | None = None, v: tuple[Quantity, Quantity] | None = None) -> Surface: ...


def reparametrize(*args: Any, c: Any = None, domain: Any = None, s: Any = None, u: Any = None, v: Any = None) -> Any:
    """The same points over another domain, the parameter mapped evenly.

    Derivatives of order k are divided by the k-th power of the domain's growth.
    A parametric curve stays one.
    Piegl & Tiller, *The NURBS Book*, §6.4.

    :param c: The curve.
    :param domain: The new domain, such as `0..10`.

    In scripts: ``reparametrize(c: curve, domain: range) -> curve``

    The same surface over other domains of u, of v, or both: the parameters change linearly.

    Piegl & Tiller, *The NURBS Book*, §6.4.
    :param s: The surface.
    :param u: The new domain of u.
    :param v: The new domain of v.

    In scripts: ``reparametrize(s: surface, u: range = none, v: range = none) -> surface``
    """
    return _called("reparametrize", args, {"c": c, "domain": domain, "s": s, "u": u, "v": v})


def replace(text: str, old: str, new: str) -> str:
    """Text with another part wherever one occurs.

    :param text: The text.
    :param old: What is replaced.
    :param new: What stands there instead.

    In scripts: ``replace(text: string, old: string, new: string) -> string``
    """
    return _called("replace", (), {"text": text, "old": old, "new": new})  # type: ignore[no-any-return]


def report(g: Any) -> Any:
    """What was done to make a curve or surface, as a record: the `operation`, and what its result
    does not show, such as deviations with their places, parameters, gaps and whatever was
    reversed, reordered or refitted.

    Fits leave a report (`interpolate`, `approximate`), constructions through curves (networks,
    skins, sweeps), offsets, and edits within a tolerance. It belongs to the result of that one
    operation: whatever is made of the result has no report, or its own.
    A `deviation` is `{max, mean, at}` with `at` the parameter where it is largest; of one that
    is proven instead of measured only its bound is told.

    Of the curves that `intersect` gives of two surfaces, `section` of one, and `edges`, it tells what they are on
    them: the `kind` (`"crossing"`, `"border"` where a surface ends or `"contact"` where they only touch), a bound of
    the `deviation` from both (`none` where nothing is known), whether it is `proven` that they cross in one smooth
    arc within `radius` of it (of a border that the deviation is within the tolerance), its curves of parameters
    `on` both, over the parameter of the curve, in the plane of u and v, and what it is `between` (`"border"`,
    `"junction"`, `"closed"`, `"seam"`). It is found when somebody asks.

    Of any solid it tells what it is made of: the numbers of its `faces`, `edges`, `vertices`, `shells`, `bodies`
    and handles (`genus`), its `volume` and `area`, the length of its shortest edge (`least_edge`, `none` without
    edges), the sharpest angle between faces along an edge, inside or outside, by what 24 places of each show
    (`least_angle`), a bound of how far an edge is from its faces (`deviation`), how far ends of edges are apart that
    became one vertex (`welded`), and that it is `closed`. `volume_error` bounds what the volume may be off by: by what is known of the
    integral, and by what faces may miss one another within the document's tolerance along their edges.

    :param g: A curve or surface as a construction returned it, a solid, or a list of them.

    In scripts: ``report(g: geometry) -> any``
    """
    return _called("report", (), {"g": g})


def reverse(list: Any) -> Any:
    """The same elements from the last to the first.

    :param list: The list; a range of whole numbers counts as one.

    In scripts: ``reverse(list: list of values) -> list of values``
    """
    return _called("reverse", (), {"list": list})


def reverse_u(s: Surface) -> Surface:
    """The same surface with u run backwards over the same domain.

    Its normal turns around.
    Piegl & Tiller, *The NURBS Book*, §6.5.

    :param s: The surface.

    In scripts: ``reverse_u(s: surface) -> surface``
    """
    return _called("reverse_u", (), {"s": s})  # type: ignore[no-any-return]


def reverse_v(s: Surface) -> Surface:
    """The same surface with v run backwards over the same domain.

    Its normal turns around.
    Piegl & Tiller, *The NURBS Book*, §6.5.

    :param s: The surface.

    In scripts: ``reverse_v(s: surface) -> surface``
    """
    return _called("reverse_v", (), {"s": s})  # type: ignore[no-any-return]


def reversed_(c: Curve) -> Curve:
    """Curve run through backwards, on the same domain: its start is the end of `c`.

    A parametric curve stays one.
    Piegl & Tiller, *The NURBS Book*, §6.5.

    :param c: The curve.

    In scripts: ``reversed(c: curve) -> curve``
    """
    return _called("reversed", (), {"c": c})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def revolve(c: Curve, *, axis: PointLike | None = None, about: PointLike | None = None, angle: Quantity | None = None) -> Surface: ...

    @overload
    def revolve(r: Region, *, axis: PointLike | None = None, about: PointLike | None = None, angle: Quantity | None = None) -> Solid: ...


def revolve(*args: Any, c: Any = None, axis: Any = None, about: Any = None, angle: Any = None, r: Any = None) -> Any:
    """Surface that a curve leaves behind when it is turned about an axis.

    Exact, of a rational curve too: u goes around the axis on 0..1 from the curve's own place, in
    equal arcs of at most a quarter turn, v along the curve on its own domain. A positive angle
    turns counter-clockwise seen from where the axis points to, a negative one the other way.
    An end of the curve on the axis makes a pole. A parametric curve is followed within the document's tolerance.
    Piegl & Tiller, *The NURBS Book*, A8.1.

    :param c: The curve.
    :param axis: The direction of the axis. Default: ``(0, 0, 1)``.
    :param about: A point of the axis. Default: ``(0, 0, 0)``.
    :param angle: How far it turns: up to a full turn, either way. Default: ``360deg``.

    In scripts: ``revolve(c: curve, axis: point = (0, 0, 1), about: point = (0, 0, 0), angle: angle = 360deg) -> surface``

    Solid that a region passes when it is turned about an axis in its plane.

    Exact: its sides are the surfaces of the region's curves, each as `revolve` of the curve gives it; short of a full turn the
    region where it was and where it comes to are faces before them. The region may run along the axis and may not reach over it. Holes
    become voids in a full turn.
    :param r: The region.
    :param axis: The direction of the axis. Default: ``(0, 0, 1)``.
    :param about: A point of the axis. Default: ``(0, 0, 0)``.
    :param angle: How far it turns: up to a full turn, either way. Default: ``360deg``.

    In scripts: ``revolve(r: region, axis: point = (0, 0, 1), about: point = (0, 0, 0), angle: angle = 360deg) -> solid``
    """
    return _called("revolve", args, {"c": c, "axis": axis, "about": about, "angle": angle, "r": r})


def reweight(c: Curve, f: Curve) -> Curve:
    """The same curve in space with every homogeneous point times a scalar spline.

    The spline is a curve whose x coordinate is the factor, positive, over the same domain; the
    degrees add up. Piegl & Tiller, *The NURBS Book*, (10.15).

    :param c: The curve.
    :param f: The factor: a polynomial curve along the x axis.

    In scripts: ``reweight(c: curve, f: curve) -> curve``
    """
    return _called("reweight", (), {"c": c, "f": f})  # type: ignore[no-any-return]


def rotate(g: Any, angle: Quantity, *, axis: PointLike | None = None, about: PointLike | None = None) -> Any:
    """Geometry turned about an axis, counter-clockwise seen from the axis's tip.

    :param g: What is turned.
    :param angle: By how much.
    :param axis: The direction of the axis. Default: ``(0, 0, 1)``.
    :param about: A point of the axis. Default: ``(0, 0, 0)``.

    In scripts: ``rotate(g: geometry, angle: angle, axis: point = (0, 0, 1), about: point = (0, 0, 0)) -> geometry``
    """
    return _called("rotate", (), {"g": g, "angle": angle, "axis": axis, "about": about})


def round_(x: Quantity, digits: float | None = None) -> float:
    """The nearest whole number, or the nearest number of so many digits behind the point; halves go
    away from zero.

    A quantity is rounded in document units; `round(x / 1in) * 1in` rounds in others.

    :param x: A number that is no angle.
    :param digits: Digits behind the point; where negative, tens, hundreds and so on.

    In scripts: ``round(x: number, digits: integer = none) -> number``
    """
    return _called("round", (), {"x": x, "digits": digits})  # type: ignore[no-any-return]


def ruled(c0: Curve, c1: Curve) -> Surface:
    """Surface of straight lines between points of equal parameter on two curves.

    The first curve lies at v = 0, the second at v = 1; u runs along them, and along each line
    v is the fraction of its length. Curves of other degrees and knots are made compatible,
    exactly; where their weights differ by more than a common factor the degree is the sum.
    A parametric curve is followed within the document's tolerance. Piegl & Tiller, *The NURBS Book*, §8.4.

    :param c0: The curve at v = 0.
    :param c1: The curve at v = 1.

    In scripts: ``ruled(c0: curve, c1: curve) -> surface``
    """
    return _called("ruled", (), {"c0": c0, "c1": c1})  # type: ignore[no-any-return]


def sample(c: Curve, n: float) -> FloatArray:
    """Points of a curve at equal steps of its parameter, both ends included.

    :param c: The curve.
    :param n: How many points, two or more.

    In scripts: ``sample(c: curve, n: integer) -> list of points``
    """
    return _called_for(3, "sample", (), {"c": c, "n": n})  # type: ignore[no-any-return]


def scale(g: Any, s: Quantity | PointLike, *, about: PointLike | None = None) -> Any:
    """Geometry made larger or smaller from a point that stays, by one factor or by one along each
    axis.

    :param g: What is scaled.
    :param s: The factor, or three factors as a point; none is zero.
    :param about: The point that stays. Default: ``(0, 0, 0)``.

    In scripts: ``scale(g: geometry, s: number | point, about: point = (0, 0, 0)) -> geometry``
    """
    return _called("scale", (), {"g": g, "s": s, "about": about})


def scan(list: Any, start: Any, f: FunctionLike) -> Any:
    """List of all values of `fold` on its way, without the start: as many as there are elements.

    :param list: The list; a range of whole numbers counts as one.
    :param start: The value before the first element.
    :param f: The function of the value so far and the element.

    In scripts: ``scan(list: list of values, start: any, f: function) -> list of values``
    """
    return _called("scan", (), {"list": list, "start": start, "f": f})


def second_form(s: Surface | Face, u: float, v: float) -> dict[str, Any]:
    """Coefficients of the second fundamental form of a surface: `L` = n·Suu, `M` = n·Suv, `N` = n·Svv,
    with the unit normal n along Su × Sv.

    They are positive where the surface bends to the side of n. At a pole or a collapsed edge n is the
    limit, where that exists. do Carmo, *Differential Geometry of Curves and Surfaces*, §3-3.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``second_form(s: surface | face, u: number, v: number) -> record``
    """
    return _called("second_form", (), {"s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def section(*args: Any, g: Any = None, plane: Any = None, s: Any = None) -> Any:
    """Points where a curve passes through a plane or touches it, in the order of the parameter.

    Found completely; a piece that lies in the plane is told by its ends.
    A parametric curve is searched as the spline that `length` tells of; each place is then found
    on the function itself.

    :param g: The curve.
    :param plane: The plane.

    In scripts: ``section(g: curve, plane: plane) -> list of points``

    Curves in which a plane cuts a surface or touches it.

    Found completely, by the signs of Bernstein coefficients and not by samples: no loop is too small.
    Where the surface is a plane, sphere, cylinder or cone they are exact lines and conics, and the circles
    of a torus are exact; others are cubic splines in the plane, within the document's tolerance, parametrized
    about by their length. To their left, seen from the side of the surface's normal, the surface is above the
    plane. They end at the surface's boundary, and where several cross. A patch that lies in the plane is
    told by its border; of a touch in a single point a warning tells. A plane that misses gives an
    empty list. A parametric surface is cut as a spline within a quarter of the tolerance. `report` of a curve tells
    whether it is proven, and how far from the surface and the plane it may be.
    Sederberg & Meyers, *Loop detection in surface patch intersections*, CAGD 5 (1988).
    :param g: The surface, or a part of one.
    :param plane: The plane.

    In scripts: ``section(g: surface | face, plane: plane) -> list of curves``

    Points and curves in which a plane cuts the curves, surfaces and meshes of a list, those of all
    in one list.
    :param g: The curves, surfaces and meshes.
    :param plane: The plane.

    In scripts: ``section(g: list of curves, surfaces or meshes, plane: plane) -> list of values``

    Polylines in which a plane cuts the triangles of a mesh.

    To their left, seen from the side of the normals, the mesh is above the plane. What lies in
    the plane counts as above it: a face there is told by its border towards what is below.
    :param g: The mesh.
    :param plane: The plane.

    In scripts: ``section(g: mesh, plane: plane) -> list of curves``

    The regions that a plane has of a solid, the largest first: holes are holes.

    Faces that lie in the plane are among them. A plane that misses gives an empty list.
    :param s: The solid.
    :param plane: The plane.

    In scripts: ``section(s: solid, plane: plane) -> list of regions``
    """
    return _called("section", args, {"g": g, "plane": plane, "s": s})


def self_intersections(c: Curve) -> list[dict[str, Any]]:
    """Every place where a curve comes within the document's tolerance of itself, as
    `[{t, s, point}]` with `t` below `s`. The seam of a closed curve is none.

    Found completely: pieces that turn by less than half a turn cannot meet themselves, all
    others are halved. A cusp is no meeting of its two sides.
    A parametric curve is searched as the spline that `length` tells of; each place is then found
    on the function itself.

    :param c: The curve.

    In scripts: ``self_intersections(c: curve) -> list of records``
    """
    return _called("self_intersections", (), {"c": c})  # type: ignore[no-any-return]


def shells(s: Solid) -> list[list[Face]]:
    """The faces of each shell of a solid, outer ones and voids: `s.shells`.

    A shell is what hangs together over edges. `bodies` has each outer one with its voids.

    :param s: The solid.

    In scripts: ``shells(s: solid) -> list of lists of faces``
    """
    return _called("shells", (), {"s": s})  # type: ignore[no-any-return]


def sign(x: Quantity) -> float:
    """Sign of a number: -1, 0 or 1.

    :param x: A number of any dimension.

    In scripts: ``sign(x: number) -> number``
    """
    return _called("sign", (), {"x": x})  # type: ignore[no-any-return]


def signed_curvature(c: Curve, t: float, *, normal: PointLike | None = None, side: str | None = None) -> float:
    """Curvature of a curve with a sign: positive where it turns counter-clockwise, seen from the tip
    of the normal.

    (x'y'' − y'x'') / |C'|³ of a curve in the plane of x and y; of any other curve its curvature, with
    the sign of its turn about the normal. Where it bends in a plane that holds the normal there is
    no sign.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param normal: The direction that the curve is seen from. Default: ``(0, 0, 1)``.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``signed_curvature(c: curve, t: number, normal: point = (0, 0, 1), side: "right" | "left" = "right") -> curvature``
    """
    return _called("signed_curvature", (), {"c": c, "t": t, "normal": normal, "side": side})  # type: ignore[no-any-return]


def sin(angle: Quantity) -> float:
    """Sine of an angle; a bare number counts as radians.

    :param angle: An angle, or a number of radians.

    In scripts: ``sin(angle: angle | number) -> number``
    """
    return _called("sin", (), {"angle": angle})  # type: ignore[no-any-return]


def sinh(x: float) -> float:
    """Hyperbolic sine.

    :param x: A number.

    In scripts: ``sinh(x: number) -> number``
    """
    return _called("sinh", (), {"x": x})  # type: ignore[no-any-return]


def skin(*args: Any, sections: Any = None, degree: Any = None, spine: Any = None, at: Any = None, parameters: Any = None, closed: Any = None, align: Any = None, start_tangent: Any = None, end_tangent: Any = None, shape: Any = None, pairing: Any = None, tolerance: Any = None) -> Any:
    """Surface through sections: u along them, v from one to the next.

    Sections of other degrees and knots are made compatible, exactly; rational ones are skinned
    in homogeneous space after their weights are normalised, so that a common factor of a
    section's weights changes nothing. A section may be a point where the surface begins or
    ends. Sections that run against their neighbour are reversed, closed ones as the way between
    them passes both, and seams of closed ones that are far from their neighbour's are moved. Where closed sections have corners, such as the tails
    of aerofoils, all seams go to corners that belong together, smooth ones beside them;
    neighbours with as many corners have them at the same parameters, so that edges of the
    surface run through them. The sections stand at parameters averaged from
    the distances of their control points, over knots averaged from these; of sections of unlike weights from distances
    in homogeneous space about the first control point, in which a weight counts as a length of the document's unit,
    or with "places" from those of their places, whatever the unit. With a spine the
    derivatives by v at the sections point along its tangents, and v is its parameter. Where
    weights between rational sections do not stay positive, a warning says so; with a tolerance,
    or where they would vanish, these sections become splines within it.
    "monotone" keeps each coordinate of the control points between its values at two
    neighbouring sections, so that nothing swings out, with C1 where that needs it.
    Piegl & Tiller, *The NURBS Book*, §10.3.

    :param sections: The sections in order, two or more: curves, and points at the ends.
    :param degree: The degree along v, from 1; fewer sections than degree + 1 lower it. Default: ``3``.
    :param spine: A curve whose tangents the surface takes at the sections; degree 2 or 3.
    :param at: The parameters of the spine at the sections.
    :param parameters: Where in v the sections stand: by a rule, or listed. A closed skin takes one more, for its return to the first section. Default: ``"average"``.
    :param closed: Whether the surface goes on from the last section to the first, as smooth there as anywhere. Default: ``false``.
    :param align: Whether sections are turned around, and seams moved, to run beside their neighbours. Default: ``true``.
    :param start_tangent: The derivative by v along the first section: a vector, or a curve of vectors.
    :param end_tangent: The derivative by v along the last section.
    :param shape: Whether the surface may swing out between sections. Default: ``"free"``.
    :param pairing: Whether points of equal parameter or of equal fraction of the length belong together; by "length", sections of uneven speed become cubic splines within the tolerance. Default: ``"parameter"``.
    :param tolerance: How far sections may move so that the surface has fewer knots along them.

    In scripts: ``skin(sections: list of curves or points, degree: integer = 3, spine: curve = none, at: list of numbers without units = none, parameters: "average" | "places" | "centripetal" | "uniform" | list of numbers without units = "average", closed: bool = false, align: bool = true, start_tangent: point | curve = none, end_tangent: point | curve = none, shape: "free" | "monotone" = "free", pairing: "parameter" | "length" = "parameter", tolerance: length = none) -> surface``

    Solid through regions, whose ends are the first and the last of them.

    Their borders are skinned as curves are, the outer ones, and holes in their order: u along them, v from one region
    to the next. All regions have as many holes. A closed skin goes on from the last region to the first, without
    ends.
    :param sections: The regions in order, two or more.
    :param degree: The degree along v, from 1; fewer regions than degree + 1 lower it. Default: ``3``.
    :param spine: A curve whose tangents the sides take at the regions; degree 2 or 3.
    :param at: The parameters of the spine at the regions.
    :param parameters: Where in v the regions stand: by a rule, or listed. A closed skin takes one more, for its return to the first region. Default: ``"places"``.
    :param closed: Whether the solid goes on from the last region to the first, as smooth there as anywhere. Default: ``false``.
    :param align: Whether borders are turned around, and seams moved, to run beside their neighbours. Default: ``true``.
    :param start_tangent: The derivative by v along the borders of the first region: a vector, or a curve of vectors.
    :param end_tangent: The derivative by v along those of the last region.
    :param shape: Whether the sides may swing out between regions. Default: ``"free"``.
    :param pairing: Whether points of equal parameter or of equal fraction of the length belong together; by "length", borders of uneven speed become cubic splines within the tolerance. Default: ``"parameter"``.
    :param tolerance: How far borders may move so that the sides have fewer knots along them.

    In scripts: ``skin(sections: list of regions, degree: integer = 3, spine: curve = none, at: list of numbers without units = none, parameters: "average" | "places" | "centripetal" | "uniform" | list of numbers without units = "places", closed: bool = false, align: bool = true, start_tangent: point | curve = none, end_tangent: point | curve = none, shape: "free" | "monotone" = "free", pairing: "parameter" | "length" = "parameter", tolerance: length = none) -> solid``
    """
    return _called("skin", args, {"sections": sections, "degree": degree, "spine": spine, "at": at, "parameters": parameters, "closed": closed, "align": align, "start_tangent": start_tangent, "end_tangent": end_tangent, "shape": shape, "pairing": pairing, "tolerance": tolerance})


def solid(g: Surface | Face | Solid | Sequence[Surface | Face], *, cap: bool | None = None) -> Solid:
    """What surfaces and faces enclose that close, whichever way each of them faces.

    Every place of every edge lies on one other edge within the document's tolerance, as for `volume`. Surfaces that hang together are a
    shell; shells keep apart. One within another is a void in it, one within a void a body of its own. With `cap` plane rims are closed
    by plane faces; rims in one plane together, what an odd number of them goes around.
    `s.faces` are its faces, which look outward, in the order of the argument, then the caps; `s.shells` those of each shell. A solid is
    itself.

    :param g: A surface or face, or a list of them.
    :param cap: Whether plane rims are closed. Default: ``false``.

    In scripts: ``solid(g: surface | face | solid | list of surfaces or faces, cap: bool = false) -> solid``
    """
    return _called("solid", (), {"g": g, "cap": cap})  # type: ignore[no-any-return]


def solve(f: FunctionLike, *, within: tuple[Quantity, Quantity] | Sequence[tuple[Quantity, Quantity]] | dict[str, Any] | None = None, start: Any = None, all: bool | None = None, report: bool | None = None) -> Any:
    """Number within a range at which a function is zero: `solve(h => volume(bottle(h)) - 0.75e6, within = 10cm..40cm)`.

    Where the function has different signs at both ends, the root between them is found in some ten steps, as
    exactly as numbers tell it. Where it has the same sign, the range is divided until it has not, and at last the
    place where it is nearest to zero is looked at, since it may only touch zero there; of such a place half of the digits are known.
    What a bare unknown measures stays open where the function's values are open, as of coordinates. A jump over zero, such as
    a pole, is no root, and a stretch along which the function is 0 is refused. With `all = true` the answer is a
    list. Of a function of arithmetic, `if` and the functions of one number the range is divided until bounds of
    its values and slopes prove where its roots are and that there are no others; where roots coincide, lie at the
    border or only touch zero it is looked at closely what that proof leaves open: what is zero as far as rounding
    tells is a root, and a pole or a step is passed over. Of any other function the list holds every root that 256
    places at equal distances tell apart, a clear jump over zero is passed over as well, and it is refused where more than
    every fourth part between them holds one.
    Chandrupatla, *A new hybrid quadratic/bisection algorithm*, Adv. Eng. Software 28 (1997); Moore, Kearfott & Cloud,
    *Introduction to Interval Analysis*, §8.1.

    Derivatives pass through roots by the theorem of implicit functions, where the functions cross zero and are
    as many as the unknowns.

    From a `start` instead of a range, the unknowns may be a number, a point, or a list or record of such,
    and the function yields as many numbers or more, each of which is to be zero: of more than there are
    unknowns the squares are made least. Steps to where the function has no value are taken shorter. The search may
    end at another root than the nearest one; with `within` beside the start the unknowns stay between those bounds.
    Moré, *The Levenberg-Marquardt algorithm*, LNM 630 (1978).

    :param f: A function of the unknown that yields what is to be zero; both may have a dimension.
    :param within: The range in which the root is; beside a start also a list or record of ranges for several unknowns, or one for all of them. Unknowns of a record that it does not name are free, and so is what is left out of a point.
    :param start: Where the search begins, inside of `within` where there is that; of one number in a range there is none.
    :param all: Whether all roots are wanted, as a list; without it one is. Default: ``false``.
    :param report: Whether a record tells how it was found: `root`, the `residual` there, of several numbers the largest, with a unit where they have one together, `evaluations`, and whether it is `proven`: that a root is there, and with `all` that there is no other. Default: ``false``.

    In scripts: ``solve(f: function, within: range | list of ranges | record = none, start: any = none, all: bool = false, report: bool = false) -> any``
    """
    return _called("solve", (), {"f": f, "within": within, "start": start, "all": all, "report": report})


def sort(list: Any, *, by: FunctionLike | None = None) -> Any:
    """The same numbers, or strings, in ascending order; equal ones keep their order.

    :param list: Numbers of one dimension, or strings.
    :param by: A function whose value decides the order, instead of the element itself.

    In scripts: ``sort(list: list of values, by: function = none) -> list of values``
    """
    return _called("sort", (), {"list": list, "by": by})


def sphere(center: PointLike, radius: Quantity) -> Surface:
    """Exact sphere as a rational surface on 0..1 in both directions.

    u goes around the z direction counter-clockwise from x, in quarters; v goes from the lower
    pole to the upper one. Su × Sv points outward. Piegl & Tiller, *The NURBS Book*, §8.5.

    :param center: Its centre.
    :param radius: Its radius, positive.

    In scripts: ``sphere(center: point, radius: length) -> surface``
    """
    return _called("sphere", (), {"center": center, "radius": radius})  # type: ignore[no-any-return]


def split(*args: Any, c: Any = None, t: Any = None, s: Any = None, u: Any = None, v: Any = None, by: Any = None, text: Any = None, separator: Any = None) -> Any:
    """Both parts of a curve at a parameter, `[left, right]`, each with the parameters it had.

    Exact. `join` makes the same curve of them, unless it jumps.
    A parametric curve gives two of its kind.
    Piegl & Tiller, *The NURBS Book*, §5.2.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain and none of its ends.

    In scripts: ``split(c: curve, t: number) -> list of curves``

    Both parts of a surface at a parameter of one direction, each with the parameters it had.

    Exact: `[left, right]`, the first with the smaller parameters. `join` makes the same surface
    of them.
    :param s: The surface.
    :param u: Where to cut u, inside the domain and at none of its ends.
    :param v: Where to cut v; one of both is given.

    In scripts: ``split(s: surface, u: number = none, v: number = none) -> list of surfaces``

    All parts into which curves on it, planes, surfaces and solids divide a surface or face.

    Where cutters run is found completely: of planes and surfaces by their exact crossings, so that areas
    are those of the true curves. A part goes over the seam of a closed surface as over any other place.
    The order of the parts depends on the surface and the cutters alone; `trim` takes the part beside a point. A
    cutter that misses the face, ends inside of it, or only touches it, in points or along a line that ends inside,
    is an error; a line along which it touches the face from border to border, or around, divides it. A cutter that
    lies on the face, on its plane, cylinder, cone, sphere or torus or as a part of its own surface, divides it by
    the border of what both have in common; one that lies on all of it, and another surface that runs together with
    it, is an error.
    :param s: The surface or face.
    :param by: A curve on it, a plane, a surface or face, a solid, or a list of them.

    In scripts: ``split(s: surface | face, by: plane | surface | face | curve | solid | list of planes, surfaces, faces, curves or solids) -> list of faces``

    Parts of a text between separators, `["a", "b"]` of "a,b".

    Without a separator the words: what stands between white space.
    :param text: The text.
    :param separator: What stands between the parts; white space unless given.

    In scripts: ``split(text: string, separator: string = none) -> list of strings``
    """
    return _called("split", args, {"c": c, "t": t, "s": s, "u": u, "v": v, "by": by, "text": text, "separator": separator})


def sqrt(x: Quantity) -> float:
    """Square root; of an area it is a length.

    :param x: A number that is not negative.

    In scripts: ``sqrt(x: number) -> number``
    """
    return _called("sqrt", (), {"x": x})  # type: ignore[no-any-return]


def standard_form(c: Curve) -> Curve:
    """The same curve with weight 1 at both ends.

    A rational linear change of the parameter: no point leaves the curve, each has another
    parameter of the same domain. Weights and inner knots change with it. An unclamped curve is
    clamped first.
    Farin, *Curves and Surfaces for CAGD*, §13.4; Piegl & Tiller, *The NURBS Book*, §6.4.

    :param c: The curve.

    In scripts: ``standard_form(c: curve) -> curve``
    """
    return _called("standard_form", (), {"c": c})  # type: ignore[no-any-return]


def station(section: Curve, spine: Curve, at: float, *, anchor: float | None = None) -> Any:
    """A planar section moved so that it stands across a spine.

    Its point at the parameter `anchor` comes to lie on `spine(at)`, without an anchor that
    point of its plane which is nearest to the origin, and its plane is turned by the smallest
    angle that makes it normal to the spine. Where two turns are equal, that counts which
    takes the upper side of the plane (z, else y, else x) forward. A straight section is
    turned to be normal to the spine. Piegl & Tiller, *The NURBS Book*, §10.4.

    :param section: The section.
    :param spine: The spine.
    :param at: The parameter of the spine where the section is to stand.
    :param anchor: The parameter of the section's point that is to lie on the spine.

    In scripts: ``station(section: curve, spine: curve, at: number, anchor: number = none) -> geometry``
    """
    return _called("station", (), {"section": section, "spine": spine, "at": at, "anchor": anchor})


def str_(value: Any) -> str:
    """Text of a value as `print` shows it; a string stays as it is.

    :param value: Any value.

    In scripts: ``str(value: any) -> string``
    """
    return _called("str", (), {"value": value})  # type: ignore[no-any-return]


def substring(text: str, start: float, end: float | None = None) -> str:
    """Part of a text from one letter up to another, which is not in it.

    Letters count from 0, and from the end where they are negative, as the elements of a list do.

    :param text: The text.
    :param start: The first letter.
    :param end: The letter behind the last; the end of the text unless given.

    In scripts: ``substring(text: string, start: integer, end: integer = none) -> string``
    """
    return _called("substring", (), {"text": text, "start": start, "end": end})  # type: ignore[no-any-return]


def sum_(list: Any) -> Any:
    """Sum of numbers, or of points, from the first to the last; of an empty list 0.

    :param list: The list; a range of whole numbers counts as one.

    In scripts: ``sum(list: list of values) -> any``
    """
    return _called("sum", (), {"list": list})


def swap_uv(s: Surface) -> Surface:
    """The same surface with u and v exchanged: `swap_uv(s)(a, b)` is `s(b, a)`.

    Its normal turns around.

    :param s: The surface.

    In scripts: ``swap_uv(s: surface) -> surface``
    """
    return _called("swap_uv", (), {"s": s})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def sweep(section: Curve, path: Curve, *, frame: str | None = None, scale: Any = None, twist: Quantity | FunctionLike | None = None, up: PointLike | None = None, rail: Curve | Sequence[Curve] | None = None, corner: str | None = None, keep_path: bool | None = None, sections: float | None = None, method: str | None = None, tolerance: Quantity | None = None) -> Surface: ...

    @overload
    def sweep(r: Region, path: Curve, *, frame: str | None = None, scale: Any = None, twist: Quantity | FunctionLike | None = None, up: PointLike | None = None, rail: Curve | None = None, corner: str | None = None, keep_path: bool | None = None, sections: float | None = None, method: str | None = None, tolerance: Quantity | None = None) -> Solid: ...


def sweep(*args: Any, section: Any = None, path: Any = None, frame: Any = None, scale: Any = None, twist: Any = None, up: Any = None, rail: Any = None, corner: Any = None, keep_path: Any = None, sections: Any = None, method: Any = None, tolerance: Any = None, r: Any = None) -> Any:
    """Surface that a section leaves behind along a path: u along the section, v along the path,
    with the path's parameter.

    The section's x lies along the path, its y and z across it, its origin on it. Its z is up
    and its y to the left of the way: z starts as near to `up` as can be, and goes on as `frame`
    says. "translate"
    only moves it: exact. "fixed" keeps z as near to `up` as can be; "frenet" takes the path's
    binormal for z; "rotation_minimizing" never turns it about the path; "projection" carries z
    on by projecting it from place to place, as the places come ever closer: in that limit it
    does not turn about the path either, and both are one. Along a closed path the angle by
    which these miss their start is spread over the length. With `keep_path` the path is met
    exactly (the isocurve of a section's point at the origin); without it the surface is a cubic
    skin through placements of the section, and has weights only where the section does. The rest
    is within the tolerance of the true surface, measured at 36 places between two knots after half
    of the tolerance is kept at fewer; a number of `sections` is kept instead, and `report` tells
    the deviation. Where the section reaches beyond the centre of curvature, shrinks to
    nothing between the ends, or lies along the path and covers a strip twice, a warning says so.
    Piegl & Tiller, *The NURBS Book*, §10.4, A10.1, A10.2; Wang, Jüttler, Zheng & Liu,
    *Computation of rotation minimizing frames* (2008); Bloomenthal & Riesenfeld,
    *Approximation of sweep surfaces by tensor product NURBS* (1991).

    :param section: The section.
    :param path: The path, without cusps.
    :param frame: How the section turns with the path. Default: ``"rotation_minimizing"``.
    :param scale: The size along the way: a factor, one for each axis as a point, a list of these at even parameters with straight lines between, or a function of v.
    :param twist: The turn about the path: an angle that is reached at the end, or a function of v.
    :param up: Where z points at the start; (0, 0, 1), or (1, 0, 0) where the path starts along it.
    :param rail: A curve that z points to, at the same fraction of its domain; or two, along which both ends of the section run, which is turned and sized for that.
    :param corner: What happens at corners of the path: an error, or both sides meet in the plane that halves the angle; straight legs stay prisms, bent ones are sheared near the corner. Default: ``"error"``.
    :param keep_path: Whether the path itself is met exactly. Default: ``true``.
    :param sections: How many placements of the section make the surface, instead of a tolerance; with `keep_path` no fewer than the path has control points, without it at even parameters.
    :param method: What the surface is made of: it passes through "placements" of the section; or "offsets" of the path's control points by those of the section, which take more columns and never swing out. Default: ``"placements"``.
    :param tolerance: How far the surface may be from the true one; the document's tolerance.

    In scripts: ``sweep(section: curve, path: curve, frame: "translate" | "fixed" | "frenet" | "projection" | "rotation_minimizing" = "rotation_minimizing", scale: number | point | list of numbers without units or points | function = none, twist: angle | function = none, up: point = none, rail: curve | list of curves = none, corner: "error" | "miter" = "error", keep_path: bool = true, sections: integer = none, method: "placements" | "offsets" = "placements", tolerance: length = none) -> surface``

    Solid that a region leaves behind along a path, with both ends closed by the region as it stands there; along a
    closed path there are none, unless it comes back in another size.

    The region lies across the path, in the plane x = 0, as the section of a swept surface does: its y is to the left
    of the way and its z up, its origin on the path. Each of its borders leaves the surface behind that `sweep` of it
    makes, holes too.
    :param r: The region, in the plane x = 0.
    :param path: The path, without cusps.
    :param frame: How the region turns with the path. Default: ``"rotation_minimizing"``.
    :param scale: The size along the way: a factor, one for each axis as a point, a list of these at even parameters with straight lines between, or a function of v.
    :param twist: The turn about the path: an angle that is reached at the end, or a function of v.
    :param up: Where z points at the start; (0, 0, 1), or (1, 0, 0) where the path starts along it.
    :param rail: A curve that z points to, at the same fraction of its domain.
    :param corner: What happens at corners of the path: an error, or both sides meet in the plane that halves the angle. Default: ``"error"``.
    :param keep_path: Whether the path itself is met exactly. Default: ``true``.
    :param sections: How many placements of the region make the sides, instead of a tolerance; with `keep_path` no fewer than the path has control points, without it at even parameters.
    :param method: What the sides are made of: they pass through "placements" of the borders; or "offsets" of the path's control points by those of the borders, which take more columns and never swing out. Default: ``"placements"``.
    :param tolerance: How far the sides may be from the true ones; the document's tolerance.

    In scripts: ``sweep(r: region, path: curve, frame: "translate" | "fixed" | "frenet" | "projection" | "rotation_minimizing" = "rotation_minimizing", scale: number | point | list of numbers without units or points | function = none, twist: angle | function = none, up: point = none, rail: curve = none, corner: "error" | "miter" = "error", keep_path: bool = true, sections: integer = none, method: "placements" | "offsets" = "placements", tolerance: length = none) -> solid``
    """
    return _called("sweep", args, {"section": section, "path": path, "frame": frame, "scale": scale, "twist": twist, "up": up, "rail": rail, "corner": corner, "keep_path": keep_path, "sections": sections, "method": method, "tolerance": tolerance, "r": r})


def swung(profile: Curve, trajectory: Curve, *, scale: float | None = None) -> Surface:
    """Surface of a profile in the xz-plane, swung about z along a trajectory in the xy-plane.

    Its point at (u, v) is (s·x·X, s·x·Y, z) of the profile's point (x, 0, z) at u and the
    trajectory's (X, Y, 0) at v, where s is the scale; exact. With the unit circle as its
    trajectory it is a surface of revolution. Parametric curves are followed
    within the document's tolerance. Piegl & Tiller, *The NURBS Book*, (10.1) to (10.6).

    :param profile: The profile, in the xz-plane; u runs along it.
    :param trajectory: The trajectory, in the xy-plane; v runs along it.
    :param scale: Factor of x and y. Default: ``1``.

    In scripts: ``swung(profile: curve, trajectory: curve, scale: number = 1) -> surface``
    """
    return _called("swung", (), {"profile": profile, "trajectory": trajectory, "scale": scale})  # type: ignore[no-any-return]


def table(*args: Any, columns: Any = None, rows: Any = None) -> Table:
    """Table of named columns, each a list of numbers or of strings, all of one length.

    A column of points becomes three, `name_x`, `name_y` and `name_z`. The unit of lengths and
    angles, the document's and `rad`, goes along into files.

    :param columns: The columns: `{x: [0, 1], y: [2, 3]}`.

    In scripts: ``table(columns: record) -> table``

    Table of records, a row each; all have the labels of the first.
    :param rows: The rows: `[{x: 0, y: 2}, {x: 1, y: 3}]`.

    In scripts: ``table(rows: list of records) -> table``
    """
    return _called("table", args, {"columns": columns, "rows": rows})  # type: ignore[no-any-return]


def tan(angle: Quantity) -> float:
    """Tangent of an angle; a bare number counts as radians.

    :param angle: An angle, or a number of radians.

    In scripts: ``tan(angle: angle | number) -> number``
    """
    return _called("tan", (), {"angle": angle})  # type: ignore[no-any-return]


def tangent(c: Curve, t: float, *, side: str | None = None) -> FloatArray:
    """Unit tangent of a curve, in the direction of growing parameter.

    Where the first derivative vanishes, the direction of the first one that does not. At a
    corner the side decides.
    do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The side of a corner: after it or before it. Default: ``"right"``.

    In scripts: ``tangent(c: curve, t: number, side: "right" | "left" = "right") -> point``
    """
    return _called("tangent", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def tangent_line(c: Curve, t: float, *, length: Quantity | None = None, side: str | None = None) -> Curve:
    """Segment from a point of a curve along its tangent.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param length: Its length; a negative one runs the other way. Default: ``1``.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``tangent_line(c: curve, t: number, length: length = 1, side: "right" | "left" = "right") -> curve``
    """
    return _called("tangent_line", (), {"c": c, "t": t, "length": length, "side": side})  # type: ignore[no-any-return]


def tangent_plane(s: Surface | Face, u: float, v: float) -> Frame:
    """Plane that touches a surface at a place.

    Its x axis runs along Su and its z axis, the normal of the plane, along Su × Sv. At a pole or a
    collapsed edge it is the limit, where that exists.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``tangent_plane(s: surface | face, u: number, v: number) -> plane``
    """
    return _called("tangent_plane", (), {"s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def tangent_u(s: Surface | Face, u: float, v: float) -> FloatArray:
    """Unit tangent of a surface along Su.

    On an edge that is collapsed to a point, such as the pole of a sphere, it is the limit from inside
    of the domain.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``tangent_u(s: surface | face, u: number, v: number) -> point``
    """
    return _called("tangent_u", (), {"s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def tangent_v(s: Surface | Face, u: float, v: float) -> FloatArray:
    """Unit tangent of a surface along Sv.

    On an edge that is collapsed to a point, such as the pole of a sphere, it is the limit from inside
    of the domain.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``tangent_v(s: surface | face, u: number, v: number) -> point``
    """
    return _called("tangent_v", (), {"s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def tanh(x: float) -> float:
    """Hyperbolic tangent.

    :param x: A number.

    In scripts: ``tanh(x: number) -> number``
    """
    return _called("tanh", (), {"x": x})  # type: ignore[no-any-return]


def tessellate(g: Any, *, tolerance: Quantity | None = None, angle: Quantity | None = None, max_edge: Quantity | None = None, quads: bool | None = None) -> Mesh:
    """Mesh of surfaces no further from them than a tolerance.

    No point of the triangles is further from the surface than the tolerance, and none of the
    surface further from the triangles, however small a feature is: bounds of the second
    derivatives tell how large a triangle may be. It has no cracks, at seams and poles neither;
    surfaces and faces of a list share the vertices where their edges run together, along the whole or from
    a corner of one to a corner of another, whatever their degrees, knots and parameters are. Normals are those of each side where there is a crease.
    The faces of one solid share theirs too, so that its mesh closes.
    Meshes in a list are taken along as they are. With `quads` the two triangles of a cell of the
    parameters are one face, which files that can hold quadrilaterals keep (`.obj`, `.ply`); at poles
    and along edges whose vertices are others than those of the lines inside there are triangles.
    Filip, Magedson & Markot, *Surface algorithms using bounds on derivatives*, CAGD 3 (1986).

    :param g: A surface, face or solid, or a list of them and meshes.
    :param tolerance: The tolerance; when left out a thousandth of the size of `g`.
    :param angle: How far the surface's normal may turn over a triangle. Default: ``15deg``.
    :param max_edge: The longest edge that triangles may have; any when left out.
    :param quads: Whether cells are faces of four corners where they can be. Default: ``false``.

    In scripts: ``tessellate(g: geometry, tolerance: length = none, angle: angle = 15deg, max_edge: length = none, quads: bool = false) -> mesh``
    """
    return _called("tessellate", (), {"g": g, "tolerance": tolerance, "angle": angle, "max_edge": max_edge, "quads": quads})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def to_bezier(c: Curve) -> list[Curve]: ...

    @overload
    def to_bezier(s: Surface) -> list[list[Surface]]: ...


def to_bezier(*args: Any, c: Any = None, s: Any = None) -> Any:
    """Bézier curves that a curve consists of, each on its own part of the domain.

    Exact. `join` makes the same curve of them, unless it jumps. Piegl & Tiller, *The NURBS Book*, A5.6.

    :param c: The curve.

    In scripts: ``decompose(c: curve) -> list of curves``

    Bézier patches that a surface consists of, as a grid: `[i][j]`, i along u, j along v, each
    on its own part of the domains.

    Exact. `join` makes the same surface of them. Piegl & Tiller, *The NURBS Book*, A5.7.
    :param s: The surface.

    In scripts: ``decompose(s: surface) -> list of lists of surfaces``
    """
    return _called("to_bezier", args, {"c": c, "s": s})


def to_clamped(c: Curve) -> Curve:
    """The same curve as a clamped B-spline, which starts at its first point and ends at its last,
    on the same domain.

    Inner knots stand as often as the smoothness of the curve needs, so that a chain of Bézier
    or Hermite cubics that is C2 becomes the uniform clamped cubic. Always exact; weights stay.
    Linkeová, *Curves and Surfaces for Computer Graphics*, (2.53).

    :param c: The curve.

    In scripts: ``to_clamped(c: curve) -> curve``
    """
    return _called("to_clamped", (), {"c": c})  # type: ignore[no-any-return]


def to_coons(c: Curve) -> Curve:
    """The same curve as a Coons cubic B-spline: uniform, not clamped, on the same domain.

    Knots that its smoothness does not need are left out. Refused where nothing but an
    approximation exists: for weights that differ, degrees above 3, segments that are not
    equally long in parameter, and joints that are not C2.
    Linkeová, *Curves and Surfaces for Computer Graphics*, (2.51) and (2.53).

    :param c: The curve.

    In scripts: ``to_coons(c: curve) -> curve``
    """
    return _called("to_coons", (), {"c": c})  # type: ignore[no-any-return]


def to_hermite(c: Curve) -> dict[str, Any]:
    """Points and derivatives at the joints of a cubic, `{points, tangents}`, of which `hermite`
    makes the same curve.

    The derivatives are those for one unit of parameter a segment, as `hermite` takes them.
    Refused where nothing but an approximation exists: for weights that differ, degrees above
    3, segments that are not equally long in parameter, and corners.
    Linkeová, *Curves and Surfaces for Computer Graphics*, (2.26).

    :param c: The curve.

    In scripts: ``to_hermite(c: curve) -> record``
    """
    return _called("to_hermite", (), {"c": c})  # type: ignore[no-any-return]


if TYPE_CHECKING:

    @overload
    def to_nurbs(s: Surface, tolerance: Quantity) -> Surface: ...

    @overload
    def to_nurbs(c: Curve, tolerance: Quantity) -> Curve: ...


def to_nurbs(*args: Any, s: Any = None, tolerance: Any = None, c: Any = None) -> Any:
    """NURBS near a surface: of a parametric one a biquintic spline on the same domain, of which no
    point is further from the function's than a tolerance; any other surface is one already.

    The spline has the function's points and its derivatives up to the second in each direction
    where its knots cross, and is C2 but along creases of the function, which must be lines of
    constant parameter. Its distance is measured at 36 places of each patch, where half of the
    tolerance is kept; `report` tells what is found in the middle of each. de Boor, *A Practical Guide to Splines*, ch. XVII.

    :param s: The surface.
    :param tolerance: How far the spline may be from the function at a pair of parameters.

    In scripts: ``to_nurbs(s: surface, tolerance: length) -> surface``

    NURBS near a curve: of a parametric one a quintic spline on the same domain, of which no
    point is further from the function's than a tolerance; any other curve is one already.

    The spline has the function's points, first and second derivatives at its knots; where the
    function's derivatives jump it has a corner. Its distance is measured at 16 places of each
    piece, where half of the tolerance is kept; `report` tells what was found.
    de Boor, *A Practical Guide to Splines*, ch. I.
    :param c: The curve.
    :param tolerance: How far the spline may be from the function at a parameter.

    In scripts: ``to_nurbs(c: curve, tolerance: length) -> curve``
    """
    return _called("to_nurbs", args, {"s": s, "tolerance": tolerance, "c": c})


def torsion(c: Curve, t: float, *, side: str | None = None) -> float:
    """Torsion of a curve: how fast its osculating plane turns about the tangent, by arc length.

    [C' C'' C‴] / |C' × C''|², positive for a right-handed screw and 0 for a plane curve. Where the
    curve is straight there is none. do Carmo, *Differential Geometry of Curves and Surfaces*, §1-5.

    :param c: The curve.
    :param t: The parameter, inside the curve's domain.
    :param side: The piece that is asked at a knot: after it or before it. Default: ``"right"``.

    In scripts: ``torsion(c: curve, t: number, side: "right" | "left" = "right") -> curvature``
    """
    return _called("torsion", (), {"c": c, "t": t, "side": side})  # type: ignore[no-any-return]


def torus(center: PointLike, major: Quantity, minor: Quantity, *, axis: PointLike | None = None) -> Surface:
    """Exact torus as a rational surface on 0..1 in both directions.

    u goes around the axis counter-clockwise, from the place of (1, 0, 0) made normal to the axis,
    or of (0, 1, 0) where those are parallel; v goes around the tube, from the outer equator
    upward. Su × Sv points outward. With the minor radius above the major one the tube passes
    through itself, which a warning tells. Piegl & Tiller, *The NURBS Book*, §8.5.

    :param center: Its centre.
    :param major: The distance of the middle of the tube from the centre, positive.
    :param minor: The radius of the tube, positive.
    :param axis: The direction of its axis. Default: ``(0, 0, 1)``.

    In scripts: ``torus(center: point, major: length, minor: length, axis: point = (0, 0, 1)) -> surface``
    """
    return _called("torus", (), {"center": center, "major": major, "minor": minor, "axis": axis})  # type: ignore[no-any-return]


def transform(g: Any, matrix: Any) -> Any:
    """Geometry under an affine map, given by three rows of four numbers.

    A row (a, b, c, d) makes the coordinate a·x + b·y + c·z + d; d may be a length.
    Piegl & Tiller, *The NURBS Book*, §6.3.

    :param g: What is moved.
    :param matrix: The rows for x, y and z; they must not flatten space.

    In scripts: ``transform(g: geometry, matrix: list of lists of lengths) -> geometry``
    """
    return _called("transform", (), {"g": g, "matrix": matrix})


def translate(g: Any, v: PointLike) -> Any:
    """Geometry moved by a vector.

    :param g: What is moved.
    :param v: By how much.

    In scripts: ``translate(g: geometry, v: point) -> geometry``
    """
    return _called("translate", (), {"g": g, "v": v})


def transpose(rows: Any) -> Any:
    """The columns of a list of rows of one length.

    :param rows: The rows.

    In scripts: ``transpose(rows: list of lists of values) -> list of values``
    """
    return _called("transpose", (), {"rows": rows})


def trim(*args: Any, c: Any = None, range: Any = None, s: Any = None, u: Any = None, v: Any = None, by: Any = None, keep: Any = None) -> Any:
    """Part of a curve over a range of its parameter, which it keeps: `trim(c, a..b)(t)` is `c(t)`.

    Exact. The result begins at its first control point and ends at its last.
    A parametric curve stays one.

    :param c: The curve.
    :param range: The range, inside the curve's domain.

    In scripts: ``trim(c: curve, range: range) -> curve``

    Part of a surface over ranges of its parameters, which it keeps; without `u` or `v` all of
    that direction.

    Exact. The result begins and ends at its control points where it was cut.
    :param s: The surface.
    :param u: The range of u, inside the surface's domain.
    :param v: The range of v.

    In scripts: ``trim(s: surface, u: range = none, v: range = none) -> surface``

    Part of a surface or face beside a point, of those into which cutters divide it as `split` does.

    `keep` is a point on the face, beside the cuts, or `"above"` or `"below"` where the cutter is a plane: above
    is where its normal points; or `"inside"` or `"outside"` where it is a solid. Where more than one part is on
    that side, all of them are the answer, as a list; `none` where nothing is. A plane or solid that misses or only
    touches leaves all of the face, or nothing. What lies on the border of the solid is inside: of a solid's own faces
    nothing is outside.
    :param s: The surface or face.
    :param by: A curve on it, a plane, a surface or face, a solid, or a list of them.
    :param keep: What stays.

    In scripts: ``trim(s: surface | face, by: plane | surface | face | curve | solid | list of planes, surfaces, faces, curves or solids, keep: point | "above" | "below" | "inside" | "outside") -> face | list of faces | none``
    """
    return _called("trim", args, {"c": c, "range": range, "s": s, "u": u, "v": v, "by": by, "keep": keep})


def twist(s: Surface | Face, u: float, v: float) -> FloatArray:
    """Twist of a surface: the vector Suv, the derivative by u and by v.

    Linkeová, *Curves and Surfaces for Computer Graphics*, Definition 1.28.

    :param s: The surface, or a part of one.
    :param u: The first parameter, inside its domain.
    :param v: The second parameter.

    In scripts: ``twist(s: surface | face, u: number, v: number) -> point``
    """
    return _called("twist", (), {"s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def union(*args: Any, regions: Any = None, meshes: Any = None) -> Any:
    """What is in any of several regions, as a list of its parts, the largest first.

    The borders of the result are parts of the given ones, exactly. Borders that run within the
    document's tolerance of one another are one; those that come as near without being one are
    refused with the place.

    :param regions: The regions, in one plane; lists count as their members.

    In scripts: ``union(regions: list of regions or lists of regions) -> list of regions``

    What is in any of several closed meshes. `none` among them counts for nothing.

    The meshes must close within the document's tolerance, with triangles that face outward and cross
    nowhere: `tessellate` makes such of surfaces that close. Faces that coincide are one. The result
    is of triangles without normals; its new vertices are rounded, and no further away than that.
    It is checked before it is given: it closes, and its volume and that of what the meshes have in
    common add up to theirs. What would touch itself in an edge or a point is refused with the place.
    :param meshes: The closed meshes; lists count as their members.

    In scripts: ``union(meshes: list of meshes or lists of meshes) -> mesh | none``
    """
    return _called("union", args, {"regions": regions, "meshes": meshes})


def unique(list: Any) -> Any:
    """The elements without those that are equal to an earlier one.

    :param list: The list; a range of whole numbers counts as one.

    In scripts: ``unique(list: list of values) -> list of values``
    """
    return _called("unique", (), {"list": list})


def unit_vector(v: PointLike) -> FloatArray:
    """Vector of length one in the direction of `v`.

    :param v: A vector that is not zero.

    In scripts: ``unit_vector(v: point) -> point``
    """
    return _called("unit_vector", (), {"v": v})  # type: ignore[no-any-return]


def upper(text: str) -> str:
    """Text in capital letters.

    :param text: The text.

    In scripts: ``upper(text: string) -> string``
    """
    return _called("upper", (), {"text": text})  # type: ignore[no-any-return]


def vertices(*args: Any, c: Any = None, s: Any = None) -> FloatArray:
    """Parameters where the curvature of a curve has a local extremum, in order.

    Of a planar curve the signed curvature counts. Ends of an open curve and corners are none, and
    a circle has none that stands out. An ellipse has four.
    Of a parametric curve the slope of the curvature is followed as for `inflections`; cusps,
    where the curvature has no bound, are none.
    do Carmo, *Differential Geometry of Curves and Surfaces*, §1-7.

    :param c: The curve.

    In scripts: ``vertices(c: curve) -> list of numbers``

    The points where edges of a solid end: `s.vertices`.

    A closed edge, as the rim of a cylinder, ends where it starts.
    :param s: The solid.

    In scripts: ``vertices(s: solid) -> list of points``
    """
    return _called("vertices", args, {"c": c, "s": s})  # type: ignore[no-any-return]


def volume(*args: Any, s: Any = None, accuracy: Any = None, m: Any = None) -> float:
    """Volume that closed surfaces enclose, or faces whose edges run together.

    The surfaces must close: every edge meets another one within the document's tolerance, or is
    collapsed to a point. Which way each of them faces does not matter, and a shell that is turned
    inward as a whole is a hole in another.

    The flux of the position through the surfaces by the theorem of Gauss, to some 12 digits.
    Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).

    :param s: The surface, or a list of surfaces and faces.

    In scripts: ``volume(s: surface | face | list of surfaces or faces) -> volume``

    Volume of a solid: the flux of the position through its faces by the theorem of Gauss, to some 12 digits where
    they are smooth.

    Edges that are cuts lie on both of their faces within the document's tolerance, and the volume is as near as that
    allows: `volume_error` of its `report` is a bound. With `accuracy` edges are compared within ever smaller distances
    until the bound is met; a volume that is not known as well is refused.
    :param s: The solid.
    :param accuracy: What the bound of the volume's error may be at most.

    In scripts: ``volume(s: solid, accuracy: volume = none) -> volume``

    Volume that a closed mesh encloses, on whichever side its triangles face.

    Exact for the mesh, which is inside of a convex surface that it was made of. The mesh must
    close, with vertices within the document's tolerance at one place, and its triangles must
    face alike. A part that is turned inward inside of another is a hole in it. `none`, which a
    boolean leaves where there is nothing, has the volume 0.
    :param m: The mesh.

    In scripts: ``volume(m: mesh | none) -> volume``
    """
    return _called("volume", args, {"s": s, "accuracy": accuracy, "m": m})  # type: ignore[no-any-return]


def wireframe(s: Surface, u: Any, v: Any) -> list[Curve]:
    """Isocurves of a surface: those of constant u, which run along v, then those of constant v.

    A number of curves is spread evenly over the domain, both ends among them; one alone stands
    in the middle. A list has the parameters themselves.

    :param s: The surface.
    :param u: How many curves of constant u, or at which u.
    :param v: How many curves of constant v, or at which v.

    In scripts: ``wireframe(s: surface, u: integer | list of numbers without units, v: integer | list of numbers without units) -> list of curves``
    """
    return _called("wireframe", (), {"s": s, "u": u, "v": v})  # type: ignore[no-any-return]


def zebra(s: Surface, light: PointLike, *, bands: float | None = None) -> list[Curve]:
    """Curves between the stripes that a polished surface mirrors, stripe by stripe.

    The surface is looked at along the light, from far away, inside a tube of equal stripes: what
    counts is the direction r = 2(N·l)N − l into which the ray is reflected, and not the angle
    of the normal, as it is for `isophotes`. The stripes are sectors about an axis across the
    light, z made normal to it, or x where the light comes along z; the light is in the middle of
    the last one. Stripes jump where surfaces meet with a corner, have kinks where they share a tangent
    plane only, and are smooth where they share curvature. Complete, and of the kind that
    `section` gives. A parametric surface is taken as a spline within a thousandth of the
    tolerance.

    :param s: The surface.
    :param light: The direction towards the light and the eye.
    :param bands: How many stripes there are all around, two or more. Default: ``16``.

    In scripts: ``zebra(s: surface, light: point, bands: integer = 16) -> list of curves``
    """
    return _called("zebra", (), {"s": s, "light": light, "bands": bands})  # type: ignore[no-any-return]


def zip_(a: Any, b: Any) -> Any:
    """List of pairs `[a, b]` of the elements of two lists of one length.

    :param a: The first list.
    :param b: The second list.

    In scripts: ``zip(a: list of values, b: list of values) -> list of values``
    """
    return _called("zip", (), {"a": a, "b": b})
