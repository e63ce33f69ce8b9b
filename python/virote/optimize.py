"""The parameters of a script as SALib, Optuna and OpenMDAO want them.

Nothing here samples or optimises: that is the trade of those libraries. Ranges, steps and choices are those
that the script declares, as ``virote params --json`` tells them.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Union

from ._session import ParameterValue, Session

__all__ = ["Component", "optuna_distributions", "plan_of", "salib_problem", "suggest"]

Script = Union[str, "os.PathLike[str]"]


def _parameters(script: Script, names: Iterable[str] | None) -> list[dict[str, Any]]:
    """The parameters that are asked for, or all that have a range or choices."""
    parameters = {one["name"]: one for one in Session().parameters(script)}
    if names is None:
        chosen = [one for one in parameters.values() if one["range"] or one["choices"]]
        if not chosen:
            raise ValueError(f"no parameter of {Path(script).name} has a range or choices")
        return chosen
    found = []
    for name in names:
        if name not in parameters:
            raise KeyError(f"the script has no parameter {name!r}; it has {list(parameters)}")
        if not parameters[name]["range"] and not parameters[name]["choices"]:
            raise ValueError(f"the parameter {name!r} has no range: write `in 1mm..2mm` in the script")
        found.append(parameters[name])
    return found


def _in_unit(parameter: Mapping[str, Any], value: float) -> ParameterValue:
    """A number as the script reads it: with the unit in which its range is told."""
    number = int(value) if parameter["kind"] == "integer" else float(value)
    unit = parameter["unit"]
    return f"{number!r}{unit}" if unit else number


def _snapped(parameter: Mapping[str, Any], value: float) -> float:
    """The value on the steps of the parameter that is nearest to one."""
    step, start = parameter["step"], parameter["range"]["start"]
    if parameter["kind"] == "integer":
        step = step or 1
    if not step:
        return float(value)
    # As many steps as fit.
    most = int((parameter["range"]["end"] - start) / step + 1e-9)
    return float(start + step * min(max(round((value - start) / step), 0), most))


def salib_problem(script: Script, names: Iterable[str] | None = None) -> dict[str, Any]:
    """The ``problem`` of SALib: names and bounds of the parameters that have a range."""
    chosen = [one for one in _parameters(script, names) if one["range"]]
    return {
        "num_vars": len(chosen),
        "names": [one["name"] for one in chosen],
        "bounds": [[one["range"]["start"], one["range"]["end"]] for one in chosen],
    }


def plan_of(
    script: Script, names: Sequence[str], samples: Iterable[Iterable[float]]
) -> list[dict[str, ParameterValue]]:
    """Rows of numbers, such as a sampler of SALib or SciPy gives, as a plan for :func:`virote.study`.

    Numbers are in the unit of the parameter's range; one with a step goes to the nearest.
    """
    parameters = _parameters(script, names)
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
    """Distributions of Optuna by name."""
    from optuna.distributions import CategoricalDistribution, FloatDistribution, IntDistribution

    found: dict[str, Any] = {}
    for one in _parameters(script, names):
        if one["choices"]:
            found[one["name"]] = CategoricalDistribution(one["choices"])
            continue
        low, high, step = one["range"]["start"], one["range"]["end"], one["step"]
        if one["kind"] == "integer":
            found[one["name"]] = IntDistribution(int(low), int(high), step=int(step or 1))
        else:
            found[one["name"]] = FloatDistribution(float(low), float(high), step=step)
    return found


def suggest(
    trial: Any, script: Script, names: Iterable[str] | None = None
) -> dict[str, ParameterValue]:
    """What a trial of Optuna tries, as values for :meth:`virote.Session.run`."""
    values: dict[str, ParameterValue] = {}
    for one in _parameters(script, names):
        name = one["name"]
        if one["choices"]:
            values[name] = trial.suggest_categorical(name, one["choices"])
            continue
        low, high, step = one["range"]["start"], one["range"]["end"], one["step"]
        if one["kind"] == "integer":
            values[name] = trial.suggest_int(name, int(low), int(high), step=int(step or 1))
        else:
            values[name] = _in_unit(one, trial.suggest_float(name, low, high, step=step))
    return values


def __getattr__(name: str) -> Any:
    """OpenMDAO takes seconds to load, and only who asks for a component needs it."""
    if name == "Component":
        from ._openmdao import Component

        return Component
    raise AttributeError(f"module 'virote.optimize' has no attribute {name!r}")
