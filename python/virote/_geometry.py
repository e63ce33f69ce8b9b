"""Curves, surfaces, meshes, tables, planes and functions as Python has them."""

from __future__ import annotations

from . import _virote
from ._session import _called

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from typing import Any

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._virote import Held

    FloatArray = NDArray[np.float64]
    #: What can be a point: two or three numbers.
    PointLike = Sequence[str | float] | FloatArray
    #: What can be points: an array of two or three columns, or a sequence of points.
    PointsLike = Sequence[PointLike] | FloatArray

__all__ = [
    "Curve",
    "Face",
    "Frame",
    "Function",
    "Mesh",
    "Range",
    "Region",
    "Solid",
    "Surface",
    "Table",
    "Value",
]

#: A number in the document's unit, or a text with a unit: ``15``, ``"15mm"``, ``"30deg"``.
Quantity = float | str


class Range(tuple["Any", "Any"]):
    """A range from one number to another: what a script writes as ``0..5``, and as ``0..<5`` without its end.

    It is a tuple of its two ends. Where an operation takes a range and no point, a plain tuple of two numbers
    or of two texts with a unit is one; a ``Range`` is one everywhere. Ranges that come from a script are such.

    >>> import virote
    >>> virote.integrate("x => x^2", virote.Range(0, 3))
    9.0
    >>> start, end = virote.Session().run_text("let r = 2..<5")["r"]
    >>> start, end
    (2.0, 5.0)

    :param start: where it begins: a number, or a text with a unit, ``"2cm"``.
    :param end: where it ends.
    :param closed: whether its end is in it.
    """

    closed: bool
    """Whether its end is in it."""

    def __new__(cls, start: Quantity, end: Quantity, closed: bool = True) -> Range:
        found = super().__new__(cls, (start, end))
        found.closed = bool(closed)
        return found

    def __getnewargs__(self) -> tuple[Any, Any, bool]:
        return (*self, self.closed)

    @property
    def start(self) -> Any:
        """Where it begins."""
        return self[0]

    @property
    def end(self) -> Any:
        """Where it ends."""
        return self[1]

    def __eq__(self, other: object) -> bool:
        return tuple.__eq__(self, other) is True and self.closed == getattr(other, "closed", True)

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = tuple.__hash__

    def __repr__(self) -> str:
        tail = "" if self.closed else ", closed=False"
        return f"Range({self[0]!r}, {self[1]!r}{tail})"


#: The highest order of derivatives that is told; beyond that of a curve's degree few are of use.
_HIGHEST_ORDER = 64

#: Rows of a table that a notebook shows.
_MOST_ROWS = 50

#: Bytes of derivatives that are told at a time.
_MOST_BYTES = 1 << 32


def _kept(part: Any) -> Any:
    """What is kept cannot be written to, lest it tell something else than the value that it is of."""
    if type(part) is tuple:
        return tuple(map(_kept, part))
    if isinstance(part, dict):
        return {name: _kept(member) for name, member in part.items()}
    if isinstance(part, list):
        return [_kept(item) for item in part]
    if hasattr(part, "setflags"):
        part.setflags(write=False)
    return part


class Value:
    """A value of the language that stays in the library.

    It never changes: its arrays, ``curve.control_points``, are read-only, and ``.copy()`` of one may be written to.
    """

    __slots__ = ("_held", "_parts")

    def __init__(self, held: Held) -> None:
        self._held = held
        self._parts: dict[str, Any] | None = None

    def _part(self, name: str) -> Any:
        if self._parts is None:
            self._parts = _kept(self._held.parts())
        try:
            return self._parts[name]
        except KeyError:
            text = f"a {type(self).__name__.lower()} of functions has no {name}; `virote.to_nurbs` gives it some"
            raise AttributeError(text) from None

    def __repr__(self) -> str:
        return f"<virote.{type(self).__name__} {_short(self._held.text())}>"

    def __str__(self) -> str:
        return self._held.text()

    def picture(self, size: tuple[int, int] = (800, 600), view: str | None = None) -> bytes:
        """A shaded picture in PNG, as ``virote render`` draws it.

        :param view: such as ``"front"``; by default from above what is flat, and all else from a corner.
        """
        picture = self._held.picture(list(size), view)
        if picture is None:
            raise ValueError(f"a {type(self).__name__.lower()} is nothing that can be drawn")
        return bytes(picture)

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a notebook shows: the picture, where there is one."""
        bundle: dict[str, Any] = {"text/plain": repr(self)}
        try:
            picture = self._held.picture([800, 600])
        except ValueError as err:
            bundle["text/plain"] += f" (no picture: {err})"
            return bundle
        if picture is not None:
            import base64

            bundle["image/png"] = base64.b64encode(bytes(picture)).decode()
        return bundle

    def __copy__(self) -> Value:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Value:
        # A value never changes.
        return self

    def __reduce__(self) -> Any:
        name = type(self).__name__
        raise TypeError(f"a virote.{name} cannot be pickled; send the script and its parameters")


def _cell(value: Any) -> str:
    return value if isinstance(value, str) else f"{float(value):.10g}"


def _short(text: str) -> str:
    line = text.replace("\n", " ")
    return line if len(line) <= 100 else line[:99] + "…"


def _parameters(*given: ArrayLike) -> tuple[list[FloatArray], tuple[int, ...]]:
    """Parameters as flat arrays of one length, and their common shape."""
    import numpy as np

    arrays = [_array(one) for one in given]
    for one in arrays:
        if one.dtype.kind not in "fiu":
            raise TypeError(f"parameters are numbers, found an array of {one.dtype}")
    together = np.broadcast_arrays(*arrays)
    shape = together[0].shape
    flat = [np.ascontiguousarray(one, dtype=np.float64).reshape(-1) for one in together]
    for one in flat:
        if not np.isfinite(one).all():
            raise ValueError("parameters are finite numbers, found NaN or infinity")
    return flat, shape


def _array(given: ArrayLike) -> NDArray[Any]:
    from decimal import Decimal
    from numbers import Real

    import numpy as np

    if isinstance(given, np.ma.MaskedArray) and np.ma.is_masked(given):
        raise ValueError("parameters have masked elements; `.compressed()` leaves them out")
    array = np.asarray(given)
    # Numbers of other classes, such as `Fraction` and `Decimal`.
    if array.dtype == object and all(isinstance(one, (Real, Decimal)) and not isinstance(one, bool) for one in array.flat):
        return array.astype(np.float64)
    return array


def _check_order(order: int, count: int, dimensions: int) -> None:
    """Refuses what would take all memory: the library gives back whole arrays."""
    if not 0 <= order <= _HIGHEST_ORDER:
        raise ValueError(f"an order is 0 to {_HIGHEST_ORDER}, found {order}")
    if _MOST_BYTES < 24 * count * (order + 1) ** dimensions:
        raise MemoryError(f"derivatives up to order {order} at {count} parameters take more than {_MOST_BYTES >> 30} GiB")


def _check_weights(spline: Curve | Surface, homogeneous: bool) -> None:
    if spline.rational and not homogeneous:
        kind = type(spline).__name__.lower()
        raise ValueError(
            f"this {kind} has weights, and SciPy has no rational splines; `to_scipy(homogeneous=True)` gives the "
            "spline of (w x, w y, w z, w), whose points divided by the last column are those of the "
            f"{kind}"
        )


def _coefficients(spline: Curve | Surface, homogeneous: bool) -> FloatArray:
    """Control points; homogeneous ones times their weight, with the weight behind them."""
    import numpy as np

    points, weights = spline.control_points, spline.weights[..., np.newaxis]
    if not homogeneous:
        # Those of SciPy may be written to.
        return points.copy()
    # Of weight zero they are directions, and kept as they are.
    return np.concatenate([np.where(weights == 0, points, points * weights), weights], axis=-1)


class _Spline(Value):
    """A curve or a surface. Two splines with the same knots, control points and weights are equal."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, _Spline):
            return NotImplemented
        return self is other or self._held.same(other._held)

    def __hash__(self) -> int:
        key = self._held.key()
        # Of functions nobody can tell whether they are the same: each is itself alone.
        return object.__hash__(self) if key is None else key

    def __reduce__(self) -> Any:
        """A spline goes to the last bit, without what ``virote.report`` tells of its construction."""
        parts = self._held.spline()
        if parts is None:
            name = type(self).__name__
            text = f"a virote.{name} of functions cannot be pickled; send the script and its parameters, or what `virote.to_nurbs` makes of it"
            raise TypeError(text)
        return _spline, (self._held.kind(), *parts)

    def bounds(self) -> dict[str, Any]:
        """The smallest box with edges along the axes: ``min``, ``max`` and what else :func:`virote.bounds` tells."""
        return _called("bounds", (self,), {})  # type: ignore[no-any-return]

    def closest(self, p: PointLike) -> dict[str, Any]:
        """The place that is nearest to a point, as :func:`virote.closest` tells it."""
        return _called("closest", (self, p), {})  # type: ignore[no-any-return]


def _spline(kind: str, degrees: list[int], knots: list[list[float]], points: list[float]) -> Value:
    """The spline that was pickled."""
    return _wrap(kind, _virote.spline(degrees, knots, points))


class Curve(_Spline):
    """A curve: a NURBS, or a function with exact derivatives.

    Call it with a parameter or with an array of parameters; ``curve @ t`` is the same. What operations there are for
    curves, such as :func:`virote.offset`, take it first; the commonest are methods, too.

    >>> import virote
    >>> c = virote.bezier([(0, 0), (1, 2), (2, 0)])
    >>> c(0.5).tolist()
    [1.0, 1.0, 0.0]
    >>> c([0, 0.5, 1]).shape
    (3, 3)
    """

    __slots__ = ()

    def __call__(self, t: ArrayLike) -> FloatArray:
        """Points at parameters: an array of the shape of ``t`` with three columns more."""
        (flat,), shape = _parameters(t)
        return self._held.curve_points(flat).reshape((*shape, 3))

    __matmul__ = __call__

    def derivatives(self, t: ArrayLike, order: int = 1) -> FloatArray:
        """Point and derivatives up to ``order``: of the shape of ``t``, then ``(order + 1, 3)``.

        At a knot those of the piece behind it. Exact, not differences.
        """
        (flat,), shape = _parameters(t)
        _check_order(order, len(flat), 1)
        return self._held.curve_derivatives(flat, order).reshape((*shape, order + 1, 3))

    def tangent(self, t: ArrayLike) -> FloatArray:
        """Unit vectors along the curve; NaN where it stands still. At a knot those of the piece behind it."""
        import numpy as np

        along = self.derivatives(t)[..., 1, :]
        with np.errstate(invalid="ignore"):
            return along / np.linalg.norm(along, axis=-1, keepdims=True)  # type: ignore[no-any-return]

    def curvature(self, t: ArrayLike) -> FloatArray:
        """Curvatures, never negative; NaN where the curve stands still. At a knot those of the piece behind it.

        >>> import virote
        >>> bool(abs(virote.circle((0, 0), 2).curvature([0.1, 0.3]) - 0.5).max() < 1e-12)
        True
        """
        import numpy as np

        found = self.derivatives(t, 2)
        along, bend = found[..., 1, :], found[..., 2, :]
        with np.errstate(invalid="ignore", divide="ignore"):
            across = np.linalg.norm(np.cross(along, bend), axis=-1)
            return across / np.linalg.norm(along, axis=-1) ** 3  # type: ignore[no-any-return]

    def length(self, range: tuple[Quantity, Quantity] | None = None) -> float:
        """Its length, or that over a range of parameters, in the document's unit."""
        return _called("length", (self,), {"range": range})  # type: ignore[no-any-return]

    def parameter_at_length(self, s: Quantity) -> float:
        """The parameter at an arc length from the start."""
        return _called("parameter_at_length", (self, s), {})  # type: ignore[no-any-return]

    def is_closed(self) -> bool:
        """Whether it ends where it begins."""
        return _called("is_closed", (self,), {})  # type: ignore[no-any-return]

    def reversed(self) -> Curve:
        """The same curve from its end to its start."""
        return _called("reversed", (self,), {})  # type: ignore[no-any-return]

    def split(self, t: float) -> list[Curve]:
        """The parts before and behind a parameter."""
        return _called("split", (self, t), {})  # type: ignore[no-any-return]

    def trim(self, start: float, end: float) -> Curve:
        """The part between two parameters."""
        return _called("trim", (self, Range(start, end)), {})  # type: ignore[no-any-return]

    def elevate(self, degree: int) -> Curve:
        """The same curve of a higher degree."""
        return _called("elevate", (self, degree), {})  # type: ignore[no-any-return]

    def insert_knot(self, t: float, times: int = 1) -> Curve:
        """The same curve with a knot more."""
        return _called("insert_knot", (self, t), {"times": times})  # type: ignore[no-any-return]

    @property
    def domain(self) -> tuple[float, float]:
        """Where its parameter begins and ends."""
        return self._part("domain")  # type: ignore[no-any-return]

    @property
    def degree(self) -> int:
        """Its degree."""
        return self._part("degree")  # type: ignore[no-any-return]

    @property
    def knots(self) -> FloatArray:
        """Its knot vector: as many as control points, and the degree plus one more."""
        return self._part("knots")  # type: ignore[no-any-return]

    @property
    def control_points(self) -> FloatArray:
        """Its control points, a row each."""
        return self._part("control_points")  # type: ignore[no-any-return]

    @property
    def weights(self) -> FloatArray:
        """The weight of each control point."""
        return self._part("weights")  # type: ignore[no-any-return]

    @property
    def rational(self) -> bool:
        """Whether the weights differ."""
        return self._part("rational")  # type: ignore[no-any-return]

    def to_scipy(self, homogeneous: bool = False) -> Any:
        """The same curve as a ``scipy.interpolate.BSpline``.

        SciPy has no rational splines. Of a curve with weights, ``homogeneous=True`` gives the spline of
        ``(w x, w y, w z, w)``, whose points divided by the last column are those of the curve:

        >>> import virote
        >>> circle = virote.circle((0, 0), 2)
        >>> h = circle.to_scipy(homogeneous=True)(0.1)  # doctest: +SKIP
        >>> h[:3] / h[3]  # doctest: +SKIP
        """
        from scipy.interpolate import BSpline

        _check_weights(self, homogeneous)
        return BSpline(self.knots.copy(), _coefficients(self, homogeneous), self.degree)


class Surface(_Spline):
    """A surface: a NURBS, or a function with exact derivatives.

    Call it with two parameters or with two arrays of one shape; what broadcasts, does.
    """

    __slots__ = ()

    def __call__(self, u: ArrayLike, v: ArrayLike) -> FloatArray:
        """Points: an array of the common shape of ``u`` and ``v`` with three columns more."""
        (us, vs), shape = _parameters(u, v)
        return self._held.surface_points(us, vs).reshape((*shape, 3))

    def derivatives(self, u: ArrayLike, v: ArrayLike, order: int = 1) -> FloatArray:
        """Derivatives up to ``order`` in all: ``[..., i, j, :]`` is that of order i in u and j in v.

        Where i + j is more than ``order`` it is NaN.
        """
        (us, vs), shape = _parameters(u, v)
        _check_order(order, len(us), 2)
        found = self._held.surface_derivatives(us, vs, order)
        return found.reshape((*shape, order + 1, order + 1, 3))

    def normal(self, u: ArrayLike, v: ArrayLike) -> FloatArray:
        """Unit vectors along Su × Sv."""
        (us, vs), shape = _parameters(u, v)
        return self._held.surface_normals(us, vs).reshape((*shape, 3))

    def curvatures(self, u: ArrayLike, v: ArrayLike) -> dict[str, FloatArray]:
        """Principal curvatures ``k1`` ≤ ``k2``, and ``gaussian`` and ``mean``, by name.

        Positive where the centre lies on the side of Su × Sv.
        """
        (us, vs), shape = _parameters(u, v)
        found = self._held.surface_curvatures(us, vs)
        names = ["k1", "k2", "gaussian", "mean"]
        return {name: found[:, i].reshape(shape) for i, name in enumerate(names)}

    def tessellate(
        self,
        tolerance: Quantity | None = None,
        angle: Quantity | None = None,
        max_edge: Quantity | None = None,
    ) -> Mesh:
        """A mesh no point of which is further away than the tolerance."""
        from . import _operations

        given = {"tolerance": tolerance, "angle": angle, "max_edge": max_edge}
        options: Any = {name: value for name, value in given.items() if value is not None}
        mesh = _operations.tessellate(self, **options)
        if not isinstance(mesh, Mesh):
            raise TypeError("the mesher gave no mesh")
        return mesh

    def area(self) -> float:
        """Its area, in the square of the document's unit."""
        return _called("area", (self,), {})  # type: ignore[no-any-return]

    def edge(self, side: str) -> Curve:
        """The curve along an edge: ``"u0"``, ``"u1"``, ``"v0"`` or ``"v1"``."""
        return _called("edge", (self, side), {})  # type: ignore[no-any-return]

    def split(self, u: float | None = None, v: float | None = None) -> list[Surface]:
        """The parts before and behind a parameter."""
        return _called("split", (self,), {"u": u, "v": v})  # type: ignore[no-any-return]

    def trim(
        self, u: tuple[float, float] | None = None, v: tuple[float, float] | None = None
    ) -> Surface:
        """The part between two parameters along u, along v, or both."""
        ranges = {name: None if ends is None else Range(*ends) for name, ends in {"u": u, "v": v}.items()}
        return _called("trim", (self,), ranges)  # type: ignore[no-any-return]

    def elevate(self, u: int | None = None, v: int | None = None) -> Surface:
        """The same surface of a higher degree."""
        return _called("elevate", (self,), {"u": u, "v": v})  # type: ignore[no-any-return]

    def insert_knot(self, u: float | None = None, v: float | None = None, times: int = 1) -> Surface:
        """The same surface with a knot more."""
        return _called("insert_knot", (self,), {"u": u, "v": v, "times": times})  # type: ignore[no-any-return]

    def swap_uv(self) -> Surface:
        """The same surface with u and v exchanged, which turns its normals."""
        return _called("swap_uv", (self,), {})  # type: ignore[no-any-return]

    @property
    def domain(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Where u begins and ends, and v."""
        return self._part("domain")  # type: ignore[no-any-return]

    @property
    def degree(self) -> tuple[int, int]:
        """Its degrees in u and in v."""
        return self._part("degree")  # type: ignore[no-any-return]

    @property
    def knots(self) -> tuple[FloatArray, FloatArray]:
        """Its knot vectors in u and in v."""
        return self._part("knots")  # type: ignore[no-any-return]

    @property
    def control_points(self) -> FloatArray:
        """Its control net: ``[i, j]`` is the point i along u and j along v."""
        points: FloatArray = self._part("control_points")
        return points.reshape((*self._part("shape"), 3))

    @property
    def weights(self) -> FloatArray:
        """The weight of each control point."""
        weights: FloatArray = self._part("weights")
        return weights.reshape(self._part("shape"))

    @property
    def rational(self) -> bool:
        """Whether the weights differ."""
        return self._part("rational")  # type: ignore[no-any-return]

    def to_scipy(self, homogeneous: bool = False) -> Any:
        """The same surface as a ``scipy.interpolate.NdBSpline``.

        SciPy has no rational splines. Of a surface with weights, ``homogeneous=True`` gives the spline of
        ``(w x, w y, w z, w)``, whose points divided by the last column are those of the surface.
        """
        from scipy.interpolate import NdBSpline

        _check_weights(self, homogeneous)
        u, v = self.knots
        return NdBSpline((u.copy(), v.copy()), _coefficients(self, homogeneous), self.degree)


class Region(Value):
    """A region of a plane: what lies inside its outer border and outside its holes."""

    __slots__ = ()

    @property
    def outer(self) -> Curve:
        """The border around it, counter-clockwise."""
        return self._part("borders")[0]  # type: ignore[no-any-return]

    @property
    def holes(self) -> list[Curve]:
        """The borders of its holes, clockwise."""
        return list(self._part("borders")[1:])


class Face(Value):
    """A part of a surface, within loops on it."""

    __slots__ = ()

    @property
    def surface(self) -> Surface:
        """The surface of which it is a part."""
        return self._part("surface")  # type: ignore[no-any-return]

    @property
    def edges(self) -> list[Curve]:
        """Its border from corner to corner, with the face to the left."""
        return list(self._part("edges"))

    @property
    def loops(self) -> list[Curve]:
        """One closed curve for each loop of its border."""
        return list(self._part("loops"))


class Solid(Value):
    """What faces enclose that close."""

    __slots__ = ()

    @property
    def faces(self) -> list[Face]:
        """Its faces, which look away from the inside."""
        return list(self._part("faces"))


class Mesh(Value):
    """A mesh of triangles, as arrays."""

    __slots__ = ()

    @property
    def points(self) -> FloatArray:
        """Its vertices, a row each."""
        return self._part("points")  # type: ignore[no-any-return]

    @property
    def triangles(self) -> NDArray[np.uint32]:
        """Three indices of vertices for each triangle."""
        return self._part("triangles")  # type: ignore[no-any-return]

    @property
    def normals(self) -> FloatArray:
        """A unit normal for each vertex; empty where there are none."""
        return self._part("normals")  # type: ignore[no-any-return]

    @property
    def uv(self) -> FloatArray:
        """The surface's parameters of each vertex; empty where there are none."""
        return self._part("uv")  # type: ignore[no-any-return]

    @property
    def cells(self) -> list[tuple[str, NDArray[np.uint32]]]:
        """The triangles as meshio takes them: ``meshio.Mesh(mesh.points, mesh.cells)``."""
        return [("triangle", self.triangles)]


class Table(Value):
    """A table of named columns.

    Libraries that speak Arrow (pandas 3, polars, pyarrow, DuckDB) take it as it is.
    """

    __slots__ = ()

    @property
    def columns(self) -> list[str]:
        """The names of the columns."""
        return list(self.to_dict())

    @property
    def units(self) -> dict[str, str]:
        """The units of the columns that have one."""
        return dict(self._part("units"))

    def __getitem__(self, name: str) -> Any:
        """A column: an array of numbers, or a list of texts."""
        try:
            return self.to_dict()[name]
        except KeyError:
            raise KeyError(f"the table has no column {name!r}; it has {self.columns}") from None

    def __len__(self) -> int:
        columns = self.to_dict()
        return len(next(iter(columns.values()))) if columns else 0

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a notebook shows: a table of the first rows, with units."""
        import html
        from itertools import islice

        columns = self.to_dict()
        titles = [f"{name} [{self.units[name]}]" if name in self.units else name for name in columns]
        lines = [[_cell(cell) for cell in row] for row in islice(zip(*columns.values()), _MOST_ROWS)]
        if _MOST_ROWS < len(self):
            lines.append(["…"] * len(titles))

        def row(cells: list[str], tag: str) -> str:
            return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"

        body = "".join(row(cells, "td") for cells in lines)
        count = f"{len(self)} rows × {len(titles)} columns"
        text = f"<table><thead>{row(titles, 'th')}</thead><tbody>{body}</tbody></table><p>{count}</p>"
        plain = "\n".join(["\t".join(cells) for cells in [titles, *lines]])
        return {"text/plain": f"{plain}\n{count}", "text/html": text}

    def to_dict(self) -> dict[str, Any]:
        """Columns by name."""
        # Lists of texts are copies, as they could be written to.
        columns: dict[str, Any] = self._part("columns")
        return {name: list(one) if isinstance(one, list) else one for name, one in columns.items()}

    def to_pandas(self) -> Any:
        """The table as a ``pandas.DataFrame``; units are in ``frame.attrs["units"]``."""
        import pandas as pd

        frame = pd.DataFrame(self.to_dict())
        frame.attrs["units"] = self.units
        return frame

    def to_arrow(self) -> Any:
        """The table as a ``pyarrow.Table``, units in the metadata of its fields."""
        import pyarrow as pa

        arrays, fields = [], []
        for name, column in self.to_dict().items():
            array = pa.array(column)
            unit = self.units.get(name)
            metadata = {"unit": unit} if unit else None
            arrays.append(array)
            fields.append(pa.field(name, array.type, metadata=metadata))
        return pa.table(arrays, schema=pa.schema(fields))

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """The table by the interface of Arrow; needs pyarrow."""
        return self.to_arrow().__arrow_c_stream__(requested_schema)


class Frame(Value):
    """A plane or a frame: a place and three directions."""

    __slots__ = ()

    @property
    def origin(self) -> FloatArray:
        """Its place."""
        return self._part("origin")  # type: ignore[no-any-return]

    @property
    def x(self) -> FloatArray:
        """Its first direction."""
        return self._part("x")  # type: ignore[no-any-return]

    @property
    def y(self) -> FloatArray:
        """Its second direction."""
        return self._part("y")  # type: ignore[no-any-return]

    @property
    def z(self) -> FloatArray:
        """Its third direction, the normal of a plane."""
        return self._part("z")  # type: ignore[no-any-return]


class Function(Value):
    """A function of the language, or a built-in. Call it with values."""

    __slots__ = ()

    def __call__(self, *args: Any, **named: Any) -> Any:
        from ._session import default_session

        return default_session()._call(self._held, args, named)


#: What can be a function: one of the language, or its text, ``"t => (t, t^2)"``.
FunctionLike = Function | str

_CLASSES: dict[str, Callable[[Any], Value]] = {
    "curve": Curve,
    "surface": Surface,
    "region": Region,
    "face": Face,
    "solid": Solid,
    "mesh": Mesh,
    "table": Table,
    "plane": Frame,
    "function": Function,
}


def _wrap(kind: str, held: Held) -> Value:
    return _CLASSES.get(kind, Value)(held)
