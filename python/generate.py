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

from collections.abc import Sequence
from typing import Any

from ._geometry import (
    Curve,
    Face,
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
from ._session import _called

'''

RETURNS = {
    "curve": "Curve",
    "surface": "Surface",
    "mesh": "Mesh",
    "region": "Region",
    "face": "Face",
    "table": "Table",
    "number": "float",
    "length": "float",
    "angle": "float",
    "integer": "float",
    "bool": "bool",
    "string": "str",
    "plane": "Frame",
    "record": "dict[str, Any]",
}


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
    parts = [f"{label(one['name'])}: {one['hint']}" for one in first]
    parts += [f"{label(one['name'])}: {one['hint']} | None = None" for one in spare]
    if rest:
        parts.append("*")
        parts += [f"{label(one['name'])}: {one['hint']} | None = None" for one in rest]
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


def function(name: str, ops: list[dict[str, Any]]) -> str:
    parameters, call = signature(ops)
    returned = {RETURNS.get(op["returns"], "Any") for op in ops}
    kind = returned.pop() if len(returned) == 1 else "Any"
    docs = textwrap.indent(documentation(ops), "    ").strip()
    ignore = "" if kind == "Any" else "  # type: ignore[no-any-return]"
    return (
        f"def {python_name(name)}({parameters}) -> {kind}:\n"
        f'    """{docs}\n    """\n'
        f'    return _called("{name}", {call}){ignore}\n'
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
        f"__all__ = [\n{listed(public)}]\n\n",
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
