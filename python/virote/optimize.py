"""The parameters of a script as SALib, Optuna and OpenMDAO want them.

Nothing here samples or optimises: that is the trade of those libraries. Ranges, steps and choices are those
that the script declares, as ``virote params --json`` tells them.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from math import ceil, floor, ulp
from pathlib import Path
from typing import Any, NamedTuple, Union

from ._session import ParameterValue, Session

__all__ = ["Component", "optuna_distributions", "plan_of", "salib_problem", "suggest"]

Script = Union[str, "os.PathLike[str]"]


def _parameters(script: Script, names: Iterable[str] | None) -> list[dict[str, Any]]:
    """The parameters that are asked for, or all that have a range or choices, as truth values do."""
    parameters = {one["name"]: one for one in Session().parameters(script)}
    for one in parameters.values():
        if one["kind"] == "bool" and not one["choices"]:
            one["choices"] = [False, True]
    if names is None:
        chosen = [one for one in parameters.values() if one["range"] or one["choices"]]
        if not chosen:
            raise ValueError(f"no parameter of {Path(script).name} has a range or choices")
        return chosen
    found = []
    for name in [names] if isinstance(names, str) else names:
        if name not in parameters:
            raise KeyError(f"the script has no parameter {name!r}; it has {list(parameters)}")
        if not parameters[name]["range"] and not parameters[name]["choices"]:
            raise ValueError(_without_range(parameters[name]))
        found.append(parameters[name])
    return found


def _without_range(parameter: Mapping[str, Any]) -> str:
    """What to write for a parameter that may be anything."""
    name, kind, unit = parameter["name"], parameter["kind"], parameter["unit"] or ""
    if kind == "string":
        return f'the parameter {name!r} may be any text: write its choices in the script, `in ["a", "b"]`'
    return f"the parameter {name!r} has no range: write one in the script, `in 1{unit}..2{unit}`"


def _with_range(script: Script, names: Iterable[str] | None, why: str) -> list[dict[str, Any]]:
    """The same of parameters whose values are numbers of a range; ``why`` says who takes no others."""
    chosen = _parameters(script, names)
    if names is not None:
        for one in chosen:
            if not one["range"]:
                what = "is a truth value" if one["kind"] == "bool" else "has choices"
                raise ValueError(f"the parameter {one['name']!r} {what}, and {why}")
    chosen = [one for one in chosen if one["range"]]
    if not chosen:
        raise ValueError(f"no parameter of {Path(script).name} has a range, and {why}")
    return chosen


def _in_unit(parameter: Mapping[str, Any], value: float) -> ParameterValue:
    """A number as the script reads it: with the unit in which its range and its choices are told."""
    number = float(value)
    if parameter["kind"] == "integer":
        if not number.is_integer():
            raise ValueError(f"the parameter {parameter['name']!r} is a whole number, found {number!r}")
        number = int(number)
    unit = parameter["unit"]
    return f"{number!r}{unit}" if unit else number


def _choices(parameter: Mapping[str, Any]) -> list[ParameterValue]:
    """The choices as the script reads them."""
    def read(choice: Any) -> ParameterValue:
        is_number = isinstance(choice, (int, float)) and not isinstance(choice, bool)
        return _in_unit(parameter, choice) if is_number else choice

    return [read(choice) for choice in parameter["choices"]]


class _Steps(NamedTuple):
    """The values of a parameter that goes in steps: the first, and so many more at a distance."""

    first: Fraction
    step: Fraction
    n_more: int

    def value(self, idx: int) -> float:
        return float(self.first + self.step * idx)


def _steps(parameter: Mapping[str, Any]) -> _Steps | None:
    """The values of a parameter that goes in steps, as whole numbers do; ``None`` of one that may be any number."""
    ends, is_integer = parameter["range"], parameter["kind"] == "integer"
    if not is_integer and not parameter["step"]:
        return None
    # The decimals that are told, so that steps of 0.1 from 0 come to 0.3.
    start, end, step = (Fraction(str(one)) for one in (ends["start"], ends["end"], parameter["step"] or 1))
    if is_integer:
        at = start if parameter["step"] else Fraction(ceil(start))
        firsts = (at + step * i for i in range(step.denominator * at.denominator))
        first = next((one for one in firsts if one.denominator == 1), None)
        if first is None:
            raise ValueError(f"no step of the parameter {parameter['name']!r} comes to a whole number")
        # The least multiple of the step that is whole.
        start, step = first, Fraction(step.numerator)
    # An end that was computed may lie a rounding beside the last step.
    rounding = Fraction(1, 10**9)
    most = floor((end - start) / step + rounding)
    if not ends["closed"] and end <= start + (most + rounding) * step:
        most -= 1
    return _Steps(start, step, max(most, 0))


def _bounds(parameter: Mapping[str, Any]) -> tuple[float, float]:
    """The least and the largest number that a parameter may be."""
    if steps := _steps(parameter):
        return steps.value(0), steps.value(steps.n_more)
    ends = parameter["range"]
    low, high = float(ends["start"]), float(ends["end"])
    # What is left out is no value; so near to it the script may read another number as the end.
    return low, high if ends["closed"] else high - 4 * ulp(max(abs(low), abs(high)))


def _snapped(parameter: Mapping[str, Any], value: float) -> float:
    """The value on the steps of the parameter that is nearest to one."""
    steps = _steps(parameter)
    if steps is None:
        return float(value)
    idx = round((value - float(steps.first)) / float(steps.step))
    return steps.value(min(max(idx, 0), steps.n_more))


def salib_problem(script: Script, names: Iterable[str] | None = None) -> dict[str, Any]:
    """The ``problem`` of SALib: names and bounds of the parameters that have a range.

    :raises ValueError: for a name whose parameter has choices or is a truth value, of which SALib knows nothing.
    """
    chosen = _with_range(
        script, names, "SALib samples numbers of ranges: make a study for each choice, or leave it out"
    )
    return {
        "num_vars": len(chosen),
        "names": [one["name"] for one in chosen],
        "bounds": [list(_bounds(one)) for one in chosen],
    }


def plan_of(
    script: Script, names: Sequence[str], samples: Iterable[Iterable[float]]
) -> list[dict[str, ParameterValue]]:
    """Rows of numbers, such as a sampler of SALib or SciPy gives, as a plan for :func:`virote.study`.

    Numbers are in the unit of the parameter's range; one with a step, or a whole one, goes to the nearest.

    :raises ValueError: for a name whose parameter has choices or is a truth value, and for rows of another length
        than ``names``.
    """
    parameters = _with_range(script, names, "samples are numbers of ranges: leave it out")
    plan = []
    for sample in samples:
        row = [float(value) for value in sample]
        if len(row) != len(parameters):
            raise ValueError(f"a sample has {len(row)} numbers for {len(parameters)} parameters")
        plan.append(
            {one["name"]: _in_unit(one, _snapped(one, value)) for one, value in zip(parameters, row)}
        )
    return plan


def optuna_distributions(script: Script, names: Iterable[str] | None = None) -> dict[str, Any]:
    """Distributions of Optuna by name; choices that have a unit are texts with it, ``"10deg"``.

    A parameter that is a truth value has the choices ``False`` and ``True``.
    """
    from optuna.distributions import CategoricalDistribution, FloatDistribution, IntDistribution

    found: dict[str, Any] = {}
    for one in _parameters(script, names):
        if one["choices"]:
            found[one["name"]] = CategoricalDistribution(_choices(one))
            continue
        (low, high), steps = _bounds(one), _steps(one)
        if one["kind"] == "integer":
            found[one["name"]] = IntDistribution(int(low), int(high), step=int(steps.step if steps else 1))
        else:
            found[one["name"]] = FloatDistribution(low, high, step=float(steps.step) if steps else None)
    return found


def suggest(
    trial: Any, script: Script, names: Iterable[str] | None = None
) -> dict[str, ParameterValue]:
    """What a trial of Optuna tries, as values for :meth:`virote.Session.run`."""
    values: dict[str, ParameterValue] = {}
    for one in _parameters(script, names):
        name = one["name"]
        if one["choices"]:
            values[name] = trial.suggest_categorical(name, _choices(one))
            continue
        (low, high), steps = _bounds(one), _steps(one)
        if one["kind"] == "integer":
            whole = int(steps.step if steps else 1)
            values[name] = trial.suggest_int(name, int(low), int(high), step=whole)
        else:
            tried = trial.suggest_float(name, low, high, step=float(steps.step) if steps else None)
            values[name] = _in_unit(one, _snapped(one, tried))
    return values


def __getattr__(name: str) -> Any:
    """OpenMDAO takes seconds to load, and only who asks for a component needs it."""
    if name == "Component":
        from ._openmdao import Component

        return Component
    raise AttributeError(f"module 'virote.optimize' has no attribute {name!r}")
