//! What the gradient of a model with fifty parameters costs beside its value.
//!
//! Each is asked for at several places of one script, so that the start of the interpreter does not count.

use divan::Bencher;
use virote::{session::Session, value::NoFiles};

fn main() {
    divan::main();
}

/// A function of fifty parameters, and how often it is asked.
#[derive(Clone, Copy)]
struct Model {
    name: &'static str,
    function: &'static str,
    n_places: usize,
}

impl std::fmt::Display for Model {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

const fn model(name: &'static str, n_places: usize, function: &'static str) -> Model {
    Model { name, function, n_places }
}

const MODELS: [Model; 15] = [
    model("sum of squares", 200, "x => sum([for i in 0..49: x[i]^2*sin(x[i])])"),
    model(
        "point of a spline by control points",
        200,
        "x => bspline([for i in 0..49: (i, x[i])], degree = 3)(0.3).y",
    ),
    model(
        "point of a spline through points",
        200,
        "x => interpolate([for i in 0..49: (i, x[i])])(0.3).y",
    ),
    model(
        "fifty curvatures of one",
        50,
        "x => { let c = interpolate([for i in 0..49: (i, x[i])])\n sum([for k in 0..49: curvature(c, k/49)^2]) }",
    ),
    model(
        "length of a spline by control points",
        50,
        "x => length(bspline([for i in 0..49: (i, x[i])], degree = 3))",
    ),
    model(
        "length of a spline through points",
        50,
        "x => length(interpolate([for i in 0..49: (i, x[i])]))",
    ),
    model(
        "nearest point of a spline",
        50,
        "x => closest(interpolate([for i in 0..49: (i, x[i])]), (20, 5)).distance",
    ),
    model(
        "area within a closed spline",
        20,
        "x => area(region(interpolate([for i in 0..50: polar(5 + x[if i == 50 then 0 else i], i/50*1turn)])))",
    ),
    model(
        "point of a surface through a grid",
        50,
        "x => interpolate([for i in 0..4: [for j in 0..9: (i, j, x[10*i + j])]])(0.3, 0.4).z",
    ),
    model(
        "area of a surface through a grid",
        2,
        "x => area(interpolate([for i in 0..4: [for j in 0..9: (i, j, x[10*i + j])]]))",
    ),
    model(
        "area of a surface by control points",
        5,
        "x => area(bspline([for i in 0..4: [for j in 0..9: (i, j, x[10*i + j])]], degree = 3))",
    ),
    model(
        "point of a skin",
        50,
        "x => skin([for i in 0..9: bspline([for j in 0..4: (i, j, x[5*i + j])], degree = 3)])(0.3, 0.4).z",
    ),
    model(
        "point of a skin at listed parameters",
        50,
        "x => skin([for i in 0..9: bspline([for j in 0..4: (i, j, x[5*i + j])], degree = 3)], parameters = [for i in 0..9: i/9])(0.3, 0.4).z",
    ),
    model(
        "area of a skin",
        5,
        "x => area(skin([for i in 0..9: bspline([for j in 0..4: (i, j, x[5*i + j])], degree = 3)]))",
    ),
    model(
        "point of a Coons patch",
        20,
        "x => coons(u = [bspline([for j in 0..12: (j, 0, x[j])], degree = 3), bspline([for j in 0..12: (j, 9, x[13 + j])], degree = 3)], v = [bspline([for j in 0..12: (0, j*0.75, if j == 0 then x[0] else if j == 12 then x[13] else x[25 + j])], degree = 3), bspline([for j in 0..12: (12, j*0.75, if j == 0 then x[12] else if j == 12 then x[25] else x[37 + j])], degree = 3)])(0.3, 0.4).z",
    ),
];

/// Asks for something at places that are nowhere special.
fn ask(bencher: Bencher<'_, '_>, model: Model, what: &str) {
    let Model { function, n_places, .. } = model;
    let script = format!(
        "let f = {function}\nlet places = [for k in 1..{n_places}: [for i in 0..49: sin(i) + 2 + k/1000]]\nprint sum([for at in places: {what}])\n"
    );
    let ran = |script: &str| Session::default().run("bench.geo", script.as_bytes(), &NoFiles, &[]);
    assert!(ran(&script).diagnostics.is_empty(), "{}", model.name);
    bencher.counter(divan::counter::ItemsCount::new(n_places)).bench(|| ran(&script));
}

#[divan::bench(args = MODELS)]
fn value(bencher: Bencher<'_, '_>, model: Model) {
    ask(bencher, model, "f(at)");
}

#[divan::bench(args = MODELS)]
fn gradient(bencher: Bencher<'_, '_>, model: Model) {
    ask(bencher, model, "gradient(f, at)[0]");
}
