"""Writes ``virote/_operations.py``: a function for each operation of the registry.

``python generate.py`` writes it, ``python generate.py --check`` tells whether it is as it would be written.
"""

from __future__ import annotations

import builtins
import json
import keyword
import sys
import textwrap
from pathlib import Path
from typing import Any

HEAD = '''"""The operations of the language as functions of Python.

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

'''

RETURNS = {
    "curve": "Curve",
    "surface": "Surface",
    "mesh": "Mesh",
    "region": "Region",
    "face": "Face",
    "solid": "Solid",
    "table": "Table",
    "number": "float",
    "length": "float",
    "angle": "float",
    "area": "float",
    "volume": "float",
    "curvature": "float",
    "integer": "float",
    "bool": "bool",
    "string": "str",
    "point": "FloatArray",
    "plane": "Frame",
    "record": "dict[str, Any]",
    "none": "None",
}

#: The columns of the arrays that lists of these are.
COLUMNS = {"numbers": 1, "lengths": 1, "angles": 1, "points": 3}


def python_type(kind: str) -> str:
    """The type of a result as Python has it; ``Any`` where the registry does not say."""
    if kind in RETURNS:
        return RETURNS[kind]
    if kind.startswith('"'):
        return "str"
    if of := kind.removeprefix("list of ") if kind.startswith("list of ") else "":
        if of in COLUMNS:
            return "FloatArray"
        items = {python_type(one) for one in map(singular, of.split(" or "))}
        return "Any" if "Any" in items else f"list[{' | '.join(sorted(items))}]"
    kinds = [python_type(one) for one in kind.split(" | ")] if " | " in kind else ["Any"]
    return "Any" if "Any" in kinds else " | ".join(dict.fromkeys(kinds))


#: The types of arguments as Python has them.
ARGUMENTS = {
    "curve": "Curve",
    "surface": "Surface",
    "region": "Region",
    "face": "Face",
    "solid": "Solid",
    "mesh": "Mesh",
    "table": "Table",
    "plane": "Frame",
    "number": "Quantity",
    "length": "Quantity",
    "angle": "Quantity",
    "integer": "float",
    "point": "PointLike",
    "function": "FunctionLike",
    "range": "tuple[Quantity, Quantity]",
    "record": "dict[str, Any]",
    "bool": "bool",
}


def argument_type(parameter: dict[str, Any]) -> str:
    """The type of a parameter; ``Any`` where it takes lists of several kinds."""
    hint: str = parameter["hint"]
    if hint != "Any" or " | " not in parameter["type"]:
        return hint
    kinds = []
    for kind in parameter["type"].split(" | "):
        if kind.startswith("list of "):
            items = [ARGUMENTS.get(singular(one)) for one in kind[8:].replace(", ", " or ").split(" or ")]
            kinds.append("Any" if None in items else f"Sequence[{' | '.join(map(str, items))}]")
        else:
            kinds.append("str" if kind.startswith('"') else ARGUMENTS.get(kind, "Any"))
    return "Any" if "Any" in kinds else " | ".join(dict.fromkeys(kinds))


def singular(plural: str) -> str:
    """`curves` is `curve`, and `lists of points` a list of points."""
    if plural.startswith("lists "):
        return "list " + plural.removeprefix("lists ")
    return plural.removesuffix("s")


def python_name(name: str) -> str:
    return name + "_" if keyword.iskeyword(name) or hasattr(builtins, name) else name


def label(name: str) -> str:
    return name + "_" if keyword.iskeyword(name) else name


def signature(ops: list[dict[str, Any]]) -> tuple[str, str]:
    """The parameters of a function for all operations of a name, and the call that passes them on."""
    if len(ops) > 1 or any(parameter["spreads"] for parameter in ops[0]["parameters"]):
        names: dict[str, str] = {}
        for op in ops:
            for parameter in op["parameters"]:
                names.setdefault(label(parameter["name"]), "Any")
        named = "".join(f", {name}: Any = None" for name in names)
        passed = ", ".join(f'"{name}": {name}' for name in names)
        return f"*args: Any{named}", f"args, {{{passed}}}"
    parameters = ops[0]["parameters"]
    first = [one for one in parameters if one["by_position"] and not one["optional"]]
    spare = [one for one in parameters if one["by_position"] and one["optional"]]
    rest = [one for one in parameters if not one["by_position"]]
    parts = [f"{label(one['name'])}: {argument_type(one)}" for one in first]
    parts += [f"{label(one['name'])}: {argument_type(one)} | None = None" for one in spare]
    if rest:
        parts.append("*")
        parts += [f"{label(one['name'])}: {argument_type(one)} | None = None" for one in rest]
    parts = [part.replace("Any | None", "Any") for part in parts]
    named = ", ".join(f'"{label(one["name"])}": {label(one["name"])}' for one in parameters)
    return ", ".join(parts), f"(), {{{named}}}"


def documentation(ops: list[dict[str, Any]]) -> str:
    parts = []
    for op in ops:
        lines = [line.strip() for line in op["docs"].splitlines()]
        parts.append("\n".join(lines))
        for parameter in op["parameters"]:
            docs = " ".join(parameter["docs"].split())
            default = parameter["default"]
            tail = f" Default: ``{default}``." if default is not None else ""
            parts.append(f":param {label(parameter['name'])}: {docs}{tail}")
        parts.append(f"In scripts: ``{op['signature']}``")
    text = "\n\n".join(parts).replace("\\", "\\\\").replace('"""', '\\"""')
    # Parameters stand below one another.
    return text.replace("\n\n:param", "\n:param").replace("\n:param", "\n\n:param", 1)


#: What tells operations of one name apart.
SHAPES = {"Curve", "Surface", "Region", "Face", "Solid", "Mesh"}


def overloads(name: str, ops: list[dict[str, Any]]) -> str:
    """What operations of one name answer to the shapes that they take first, for checkers of types."""
    firsts = [argument_type(op["parameters"][0]) if op["parameters"] else "Any" for op in ops]
    told = [part for first in firsts for part in first.split(" | ")]
    if len(ops) == 1 or not set(told) <= SHAPES or len(set(told)) < len(told):
        return ""
    parts = ["if TYPE_CHECKING:\n"]
    for op in ops:
        parameters = signature([op])[0]
        kind = python_type(op["returns"])
        parts.append(f"\n    @overload\n    def {python_name(name)}({parameters}) -> {kind}: ...\n")
    return "".join([*parts, "\n\n"])


def function(name: str, ops: list[dict[str, Any]]) -> str:
    parameters, call = signature(ops)
    returned = {python_type(op["returns"]) for op in ops}
    kind = returned.pop() if len(returned) == 1 else "Any"
    before = overloads(name, ops) if kind == "Any" else ""
    docs = textwrap.indent(documentation(ops), "    ").strip()
    lists = {op["returns"].removeprefix("list of ") for op in ops}
    # A list without elements does not tell what they would be.
    columns = COLUMNS.get(lists.pop(), 0) if len(lists) == 1 and ops[0]["returns"] not in RETURNS else 0
    called = f'_called_for({columns}, "{name}", {call})' if columns else f'_called("{name}", {call})'
    ignore = "" if kind == "Any" else "  # type: ignore[no-any-return]"
    return (
        f"{before}def {python_name(name)}({parameters}) -> {kind}:\n"
        f'    """{docs}\n    """\n'
        f"    return {called}{ignore}\n"
    )


def module(operations: list[dict[str, Any]]) -> str:
    by_name: dict[str, list[dict[str, Any]]] = {}
    for op in operations:
        for name in [op["name"], *op["aliases"]]:
            by_name.setdefault(name, []).append(op)
    names = sorted(by_name)
    shadows = [name for name in names if python_name(name) != name]
    public = [name for name in names if name not in shadows]
    listed = lambda all: "".join(f'    "{name}",\n' for name in all)
    parts = [
        HEAD,
        f"__all__: list[str] = [\n{listed(public)}]\n\n",
        "#: Operations called like functions of Python; here they end in a stroke.\n",
        f"SHADOWS = [\n{listed(shadows)}]\n",
    ]
    parts += ["\n\n" + function(name, by_name[name]) for name in names]
    return "".join(parts)


def main() -> int:
    from virote import _virote

    text = module(json.loads(_virote.operations()))
    path = Path(__file__).parent / "virote" / "_operations.py"
    if "--check" not in sys.argv:
        path.write_text(text)
        return 0
    if path.read_text() != text:
        print("virote/_operations.py is out of date; `python generate.py` writes it", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
