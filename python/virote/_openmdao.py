"""A script as a component of OpenMDAO."""

from __future__ import annotations

from typing import Any

import openmdao.api as om
from openmdao.utils.units import valid_units

from ._findings import GeoError
from ._session import Session
from .optimize import _bounds, _in_unit, _steps, _with_range

#: Units of the language that OpenMDAO calls otherwise.
_UNITS = {"in": "inch", "turn": "rev"}


def _unit(unit: str | None) -> str | None:
    """A unit such as ``mm^2`` as OpenMDAO writes it; none where it has no such unit."""
    if unit is None:
        return None
    parts = []
    for part in unit.split("·"):
        base, _, power = part.partition("^")
        name = _UNITS.get(base, base)
        parts.append(f"{name}**{power}" if power else name)
    text = "*".join(parts)
    try:
        return text if valid_units(text) else None
    except TypeError:
        # A root of a length.
        return None


class Component(om.ExplicitComponent):  # type: ignore[misc]
    """A script whose parameters are inputs, and whose named numbers are outputs.

    ``Component(script="bottle.geo", inputs=["body", "height"], outputs=["litres", "grams"])``

    Derivatives are differences, which the script answers quickly: a session remembers what a step does
    not touch. A variant that the script refuses raises ``AnalysisError``, upon which optimisers
    shorten their step. By a parameter that goes in steps, as whole numbers do, there is no derivative:
    it can be an input, and ``ValueError`` is raised where totals are taken by it.
    """

    def initialize(self) -> None:
        """Declares what a component is made of."""
        self.options.declare("script", desc="the script")
        self.options.declare("inputs", default=None, desc="parameters; by default all with a range")
        self.options.declare("outputs", types=list, desc="definitions that are numbers")
        self.options.declare("params", default={}, types=dict, desc="values of other parameters")
        self.options.declare("step", default=1e-6, desc="of differences, relative to the range")

    def setup(self) -> None:
        """Declares inputs with their defaults and units, and outputs with theirs."""
        why = "inputs of OpenMDAO are numbers of ranges: give it a value by `params`"
        chosen = _with_range(self.options["script"], self.options["inputs"], why)
        self._varied = {one["name"]: one for one in chosen}
        for name, one in self._varied.items():
            unit = _unit(one["unit"])
            self.add_input(name, val=float(one["default"]), units=unit, desc=one["label"] or "")
        self._scripts = Session()
        units = self._units()
        for name in self.options["outputs"]:
            self.add_output(name, units=units.get(name))

    def setup_partials(self) -> None:
        """All outputs depend on all inputs."""
        self.declare_partials("*", "*")

    def compute(self, inputs: Any, outputs: Any) -> None:
        """Runs the script."""
        for name, value in self._answers(self._place(inputs)).items():
            outputs[name] = value

    def compute_partials(self, inputs: Any, partials: Any) -> None:
        """Central differences; at an end of a range those from inside.

        :raises ValueError: where totals are taken by a parameter that has none.
        """
        at = self._place(inputs)
        for name, one in self._varied.items():
            if not self._is_asked(name):
                continue
            low, high = _bounds(one)
            if _steps(one) or not low < high:
                why = "goes in steps" if low < high else "has one value"
                raise ValueError(
                    f"there is no derivative by the parameter {name!r}, which {why}: leave it out of `wrt` "
                    "and of the design variables, or declare it in the script without a step, as a number "
                    "with a wider range"
                )
            step = self.options["step"] * (high - low)
            before, behind = max(at[name] - step, low), min(at[name] + step, high)
            left = self._answers({**at, name: before})
            right = self._answers({**at, name: behind})
            for output in self.options["outputs"]:
                partials[output, name] = (right[output] - left[output]) / (behind - before)

    def _units(self) -> dict[str, str | None]:
        """The units of the outputs, which the script tells when it is run; none where it cannot be."""
        try:
            results = self._scripts.run(self.options["script"], dict(self.options["params"]))
        except GeoError:
            return {}
        outputs = [name for name in self.options["outputs"] if name in results]
        return {name: _unit(results.unit(name)) for name in outputs}

    def _is_asked(self, name: str) -> bool:
        """Whether totals are taken by an input, or by what it comes from."""
        return bool(self._relevance.is_relevant(f"{self.pathname}.{name}"))

    def _place(self, inputs: Any) -> dict[str, float]:
        return {name: float(inputs[name][0]) for name in self._varied}

    def _answers(self, at: dict[str, float]) -> dict[str, float]:
        given = dict(self.options["params"])
        given.update({name: _in_unit(self._varied[name], value) for name, value in at.items()})
        try:
            results = self._scripts.run(self.options["script"], given)
        except GeoError as err:
            raise om.AnalysisError(str(err)) from err
        return {name: float(results[name]) for name in self.options["outputs"]}
