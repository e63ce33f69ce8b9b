"""The recipes of docs/studies.md: each finds what is known otherwise."""

from __future__ import annotations

import os
import time
from pathlib import Path

import numpy as np
import pytest
import virote
from virote import optimize

STUDIES = Path(os.environ.get("VIROTE_STUDIES", Path(__file__).parents[2] / "docs/studies"))
BOTTLE, HULL = STUDIES / "bottle.geo", STUDIES / "hull.geo"


def test_problems_and_plans_are_those_of_the_script(tmp_path: Path) -> None:
    problem = optimize.salib_problem(HULL, ["length", "beam"])
    assert problem == {"num_vars": 2, "names": ["length", "beam"], "bounds": [[60, 140], [6, 18]]}
    assert optimize.salib_problem(BOTTLE)["names"] == ["body", "height", "shoulder"]
    script = tmp_path / "a.geo"
    script.write_text(
        'param a = 30deg in 0deg..90deg\nparam n: integer = 3 in 1..9\nparam r = 2mm in 1mm..3mm step 0.5mm\n'
        'param s = "x" in ["x", "y"]\nparam free = 1\n'
    )
    plan = optimize.plan_of(script, ["a", "n", "r"], np.array([[45, 3.4, 1.7], [90, 9.0, 3.0]]))
    assert plan == [{"a": "45.0deg", "n": 3, "r": "1.5mm"}, {"a": "90.0deg", "n": 9, "r": "3.0mm"}]
    assert virote.study(script, plan, workers=1, progress=False).errors == {}
    with pytest.raises(ValueError, match="no range"):
        optimize.salib_problem(script, ["free"])
    with pytest.raises(KeyError, match="no parameter 'nothing'"):
        optimize.salib_problem(script, ["nothing"])
    with pytest.raises(ValueError, match="2 numbers for 1"):
        optimize.plan_of(script, ["a"], [[1, 2]])


def test_truth_values_are_choices_and_what_has_none_is_told(tmp_path: Path) -> None:
    script = tmp_path / "a.geo"
    script.write_text(
        'param a = 30deg in 0deg..90deg\nparam on = true\nparam free = 1mm\nparam lean = 3deg\nparam n: integer = 3\n'
        'param word = "x"\nlet s = if on then a else 2 * a\n'
    )
    for name, told in [
        ("free", "`in 1mm..2mm`"), ("lean", "`in 1deg..2deg`"), ("n", "`in 1..2`"), ("word", 'in ["a", "b"]'),
    ]:  # fmt: skip
        with pytest.raises(ValueError, match=told.replace("[", r"\[")):
            optimize.salib_problem(script, [name])
        with pytest.raises(ValueError, match=told.replace("[", r"\[")):
            optimize.plan_of(script, [name], [[1]])
    for ask in (lambda: optimize.salib_problem(script, ["on"]), lambda: optimize.plan_of(script, ["on"], [[1]])):
        with pytest.raises(ValueError, match="'on' is a truth value, and"):
            ask()
    assert optimize.salib_problem(script)["names"] == ["a"]
    pytest.importorskip("optuna")
    from optuna.distributions import CategoricalDistribution
    from optuna.trial import FixedTrial

    found = optimize.optuna_distributions(script, ["a", "on"])
    assert found["on"] == CategoricalDistribution([False, True]) and list(found) == ["a", "on"]
    assert list(optimize.optuna_distributions(script, "on")) == ["on"]
    values = optimize.suggest(FixedTrial({"a": 45.0, "on": False}), script, ["a", "on"])
    assert values == {"a": "45.0deg", "on": False}
    assert virote.run(script, values)["s"] == pytest.approx(np.pi / 2)


def test_openmdao_refuses_truth_values(tmp_path: Path) -> None:
    om = pytest.importorskip("openmdao.api")
    script = tmp_path / "a.geo"
    script.write_text("param on = true\nlet s = if on then 1 else 2\n")
    problem = om.Problem(reports=False)
    component = optimize.Component(script=script, inputs=["on"], outputs=["s"])
    problem.model.add_subsystem("part", component)
    with pytest.raises(ValueError, match="'on' is a truth value.*by `params`"):
        problem.setup()


def test_sobol_indices_of_the_displacement() -> None:
    pytest.importorskip("SALib")
    from SALib.analyze import sobol as analyze
    from SALib.sample import sobol as sample

    names = ["length", "beam", "draught"]
    problem = optimize.salib_problem(HULL, names)
    samples = sample.sample(problem, 32, calc_second_order=False, seed=1)
    plan = optimize.plan_of(HULL, names, samples)
    rows = virote.study(HULL, plan, want=["displacement"], workers=2, progress=False)
    found = analyze.analyze(
        problem, np.array(rows.column("displacement [m^3]")), calc_second_order=False, seed=1
    )
    # Of a product of independent factors: S = c² / (Π(1 + c²) - 1), c the relative deviation of one.
    bounds = np.array(problem["bounds"])
    c2 = ((bounds[:, 1] - bounds[:, 0]) / np.sqrt(12) / bounds.mean(axis=1)) ** 2
    variance = np.prod(1 + c2) - 1
    assert np.allclose(found["S1"], c2 / variance, atol=0.1)
    others = np.array([np.prod(np.delete(1 + c2, i)) for i in range(3)])
    assert np.allclose(found["ST"], c2 * others / variance, atol=0.1)


def lightest() -> tuple[float, float]:
    """Body and height of the lightest bottle of 0.75 l, by OpenMDAO and SciPy."""
    om = pytest.importorskip("openmdao.api")
    problem = om.Problem(reports=False)
    component = optimize.Component(
        script=BOTTLE, inputs=["body", "height"], outputs=["litres", "grams"]
    )
    problem.model.add_subsystem("bottle", component, promotes=["*"])
    problem.model.add_design_var("body", lower=25, upper=70, ref=50)
    problem.model.add_design_var("height", lower=100, upper=350, ref=350)
    problem.model.add_constraint("litres", equals=0.75)
    problem.model.add_objective("grams", ref=400)
    problem.driver = om.ScipyOptimizeDriver(optimizer="SLSQP", tol=1e-9, disp=False)
    problem.setup()
    problem.run_driver()
    assert problem.get_val("litres")[0] == pytest.approx(0.75, abs=1e-6)
    return float(problem.get_val("body")[0]), float(problem.get_val("grams")[0])


def test_openmdao_and_optuna_find_the_lightest_bottle() -> None:
    body, grams = lightest()
    # No bottle of that volume beside it is lighter.
    session = virote.Session()
    for other in (0.97 * body, 1.03 * body):
        low, high = 100.0, 350.0
        for _ in range(40):
            height = 0.5 * (low + high)
            results = session.run(BOTTLE, {"body": other, "height": height})
            low, high = (height, high) if results["litres"] < 0.75 else (low, height)
        assert results["grams"] > grams
    optuna = pytest.importorskip("optuna")
    optuna.logging.set_verbosity(optuna.logging.WARNING)

    def objective(trial: "optuna.Trial") -> float:
        values = optimize.suggest(trial, BOTTLE, ["body", "height"])
        results = session.run(BOTTLE, values)
        # Two kilograms for each litre that is missing or too much.
        return results["grams"] + 2000 * abs(results["litres"] - 0.75)

    study = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=3))
    study.optimize(objective, n_trials=120)
    assert grams < study.best_value < 1.06 * grams
    distributions = optimize.optuna_distributions(BOTTLE)
    assert distributions["body"].high == 70 and set(distributions) == {"body", "height", "shoulder"}


def test_a_hull_is_faired_by_derivatives_eight_times_as_fast_as_by_differences() -> None:
    """The fifty unknowns of fairing.geo, and SciPy's differences around the same surface, in one run."""
    scipy_optimize = pytest.importorskip("scipy.optimize")
    script = STUDIES / "fairing.geo"
    session = virote.Session()
    offsets = np.array(session.run(script)["offsets"]).reshape(10, 5)
    i, j = np.meshgrid(np.arange(10.0), np.arange(5.0), indexing="ij")

    def burden(moves: np.ndarray) -> float:
        moved = offsets + moves.reshape(10, 5)
        hull = virote.bspline(np.stack([2 * i, moved, 0.5 * j], axis=-1), degree=3)
        bumps = (np.diff(moved, 2, axis=0) ** 2).sum() + (np.diff(moved, 2, axis=1) ** 2).sum()
        return float(virote.area(hull) + 3 * bumps + 20 * (moves**2).sum())

    # Of processors: other programs run beside. A session of its own has nothing evaluated.
    begin = time.process_time()
    least = virote.Session().run(script)["least"]
    by_derivatives = time.process_time() - begin
    begin = time.process_time()
    found = scipy_optimize.minimize(burden, np.zeros(50), method="BFGS")
    by_differences = time.process_time() - begin
    assert least == pytest.approx(found.fun, rel=1e-9)
    print(f"fairing: {by_derivatives:.2f} s by derivatives, {by_differences:.2f} s by differences, {found.nfev} values")
    assert by_differences > 8 * by_derivatives


def test_a_component_refuses_what_the_script_refuses() -> None:
    om = pytest.importorskip("openmdao.api")
    problem = om.Problem(reports=False)
    component = optimize.Component(script=BOTTLE, inputs=["body"], outputs=["litres"])
    problem.model.add_subsystem("bottle", component, promotes=["*"])
    problem.setup()
    problem.set_val("body", 7.0, units="cm")
    problem.run_model()
    derivative = problem.compute_totals(of=["litres"], wrt=["body"])["litres", "body"][0, 0]
    # At the end of its range the difference is that from inside.
    session = virote.Session()
    inside = session.run(BOTTLE, {"body": "69.99mm"})["litres"]
    assert derivative == pytest.approx((problem.get_val("litres")[0] - inside) / 0.01, rel=1e-3)
    problem.set_val("body", 99)
    with pytest.raises(om.AnalysisError, match="E0802"):
        problem.run_model()


STEPS = """
param n: integer = 4 in 2..8
param rise = 30mm in 10mm..50mm step 5mm
param x = 3mm in 1mm..9mm
param one = 3mm in 3mm..3mm
let f = n^2 * 30mm * (x / 1mm) + rise + one
"""


@pytest.mark.parametrize("mode", ["fwd", "rev"])
def test_a_component_has_no_derivative_by_what_goes_in_steps(tmp_path: Path, mode: str) -> None:
    om = pytest.importorskip("openmdao.api")
    script = tmp_path / "a.geo"
    script.write_text(STEPS)
    problem = om.Problem(reports=False)
    problem.model.add_subsystem("part", optimize.Component(script=script, outputs=["f"]), promotes=["*"])
    problem.setup(mode=mode)
    problem.run_model()
    # f = 30 n^2 x + rise + one
    assert problem.compute_totals(of=["f"], wrt=["x"])["f", "x"][0, 0] == pytest.approx(480)
    for name, why in [("n", "goes in steps"), ("rise", "goes in steps"), ("one", "has one value")]:
        with pytest.raises(ValueError, match=f"no derivative by the parameter '{name}', which {why}"):
            problem.compute_totals(of=["f"], wrt=["x", name])
    problem.set_val("n", 4.7)
    with pytest.raises(ValueError, match="'n' is a whole number, found 4.7"):
        problem.run_model()
    problem.set_val("n", 5)
    problem.run_model()
    assert problem.get_val("f")[0] == 30 * 25 * 3 + 33


VALUES = """
param b: integer = 3 in 0..<8
param odd: integer = 3 in 1..<9 step 2
param half: integer = 2 in 0.5..4 step 0.5
param q = 0.3 in 0..<0.7 step 0.1
param x = 3mm in 1mm..<9mm
param turned = 90deg in 0deg..<180deg
param t = 10deg in [10deg, 20deg]
param plate = 2mm^2 in [1mm^2, 2mm^2]
param holes: integer = 3 in [1, 3]
param word = "a" in ["a", "b"]
let sum = b + odd + half + q
"""


def test_values_are_those_that_the_script_takes(tmp_path: Path) -> None:
    script = tmp_path / "a.geo"
    script.write_text(VALUES)
    bounds = dict(zip(*(optimize.salib_problem(script)[key] for key in ("names", "bounds"))))
    assert bounds["b"] == [0, 7] and bounds["odd"] == [1, 7] and bounds["half"] == [1, 4]
    assert bounds["q"] == [0, 0.6] and 8.99999999 < bounds["x"][1] < 9
    names = list(bounds)
    plan = optimize.plan_of(script, names, [[-99] * 4 + [1, 0], [bounds[name][1] for name in names]])
    assert plan[0] == {"b": 0, "odd": 1, "half": 1, "q": 0.0, "x": "1.0mm", "turned": "0.0deg"}
    assert [plan[1][name] for name in names[:4]] == [7, 7, 4, 0.6]
    assert optimize.plan_of(script, ["b", "q"], [[7.6, 0.29]]) == [{"b": 7, "q": 0.3}]
    assert virote.study(script, plan, workers=1, progress=False).errors == {}
    for name in ("t", "word"):
        with pytest.raises(ValueError, match=f"'{name}' has choices, and SALib"):
            optimize.salib_problem(script, ["b", name])
        with pytest.raises(ValueError, match=f"'{name}' has choices, and samples"):
            optimize.plan_of(script, [name], [[1]])


def test_a_component_refuses_choices(tmp_path: Path) -> None:
    om = pytest.importorskip("openmdao.api")
    script = tmp_path / "a.geo"
    script.write_text(VALUES)
    problem = om.Problem(reports=False)
    component = optimize.Component(script=script, inputs=["b", "word"], outputs=["sum"])
    problem.model.add_subsystem("part", component)
    with pytest.raises(ValueError, match="'word' has choices.*`params`"):
        problem.setup()


def test_optuna_tries_what_the_script_takes(tmp_path: Path) -> None:
    optuna = pytest.importorskip("optuna")
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    script = tmp_path / "a.geo"
    script.write_text(VALUES)
    distributions = optimize.optuna_distributions(script)
    assert distributions["b"].high == 7 and distributions["q"].high == 0.6
    assert distributions["t"].choices == ("10.0deg", "20.0deg") and distributions["holes"].choices == (1, 3)
    study = optuna.create_study(sampler=optuna.samplers.RandomSampler(seed=1))
    study.optimize(lambda trial: virote.run(script, optimize.suggest(trial, script))["sum"], n_trials=60)
    assert len(study.trials) == 60


def test_outputs_have_the_units_of_their_definitions(tmp_path: Path) -> None:
    om = pytest.importorskip("openmdao.api")
    script = tmp_path / "a.geo"
    script.write_text(
        "param a = 2cm in 1cm..3cm\nlet area = a^2\nlet bend = 1 / a\nlet turned = 0.5turn\nlet bare = a / 1mm\n"
        "let root = sqrt(a)\n"
    )
    outputs = ["area", "bend", "turned", "bare", "root"]
    component = optimize.Component(script=script, inputs=["a"], outputs=outputs)
    problem = om.Problem(reports=False)
    problem.model.add_subsystem("part", component, promotes=["*"])
    problem.setup()
    problem.run_model()
    assert problem.get_val("area", units="cm**2")[0] == pytest.approx(4)
    assert problem.get_val("bend", units="1/m")[0] == pytest.approx(50)
    assert problem.get_val("turned", units="deg")[0] == pytest.approx(180)
    assert problem.get_val("bare")[0] == 20
    for name in ("bare", "root"):
        # What has no unit, or none that OpenMDAO knows.
        with pytest.raises((TypeError, ValueError), match="units"):
            problem.get_val(name, units="mm")


def test_the_notebook_runs_and_shows_the_bottle() -> None:
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    notebook = nbformat.read(STUDIES / "bottle.ipynb", as_version=4)
    nbclient.NotebookClient(
        notebook, timeout=120, resources={"metadata": {"path": str(STUDIES)}}
    ).execute()
    bundles = [
        output["data"]
        for cell in notebook.cells
        for output in cell.get("outputs", [])
        if "data" in output
    ]
    assert any("virote-data" in bundle.get("text/html", "") for bundle in bundles)
    assert any("image/png" in bundle for bundle in bundles)
