//! What the gradient of a model with fifty parameters costs beside its value.

use divan::Bencher;
use virote::session::Session;

fn main() {
    divan::main();
}

/// A surface of five by ten control points whose heights are the parameters: its area.
const AREA: &str = "let f = x => area(bspline([for i in 0..4: [for j in 0..9: (i, j, x[10*i + j])]], degree = 3))\n";

/// Ten sections of five points each, skinned: its area.
const SKIN: &str = "let f = x => area(skin([for i in 0..9: bspline([for j in 0..4: (i, j, x[5*i + j])], degree = 3)], parameters = [for i in 0..9: i/9]))\n";

/// A curve of fifty control points: its length.
const LENGTH: &str = "let f = x => length(bspline([for i in 0..49: (i, x[i])], degree = 3))\n";

/// A spline through fifty points, its knots by their distances: its length.
const THROUGH: &str = "let f = x => length(interpolate([for i in 0..49: (i, x[i])]))\n";

/// As `SKIN`, the parameters of the sections by their distances.
const LOFT: &str = "let f = x => area(skin([for i in 0..9: bspline([for j in 0..4: (i, j, x[5*i + j])], degree = 3)]))\n";

/// A surface through five by ten points, its knots by their distances: its area.
const GRID: &str =
    "let f = x => area(interpolate([for i in 0..4: [for j in 0..9: (i, j, x[10*i + j])]]))\n";

/// What is within a spline through fifty points: its area.
const REGION: &str = "let f = x => area(region(interpolate([for i in 0..50: polar(5 + x[if i == 50 then 0 else i], i/50*1turn)])))\n";

/// Runs a script that asks for something at a place that is nowhere special.
fn ask(bencher: Bencher<'_, '_>, model: &str, what: &str) {
    let script = format!("{model}let at = [for i in 0..49: sin(i) + 2]\nprint {what}\n");
    bencher.bench(|| {
        Session::default().run("bench.geo", script.as_bytes(), &virote::value::NoFiles, &[])
    });
}

#[divan::bench]
fn area_value(bencher: Bencher<'_, '_>) {
    ask(bencher, AREA, "f(at)");
}

#[divan::bench]
fn area_gradient(bencher: Bencher<'_, '_>) {
    ask(bencher, AREA, "gradient(f, at)");
}

#[divan::bench]
fn skin_value(bencher: Bencher<'_, '_>) {
    ask(bencher, SKIN, "f(at)");
}

#[divan::bench]
fn skin_gradient(bencher: Bencher<'_, '_>) {
    ask(bencher, SKIN, "gradient(f, at)");
}

#[divan::bench]
fn length_value(bencher: Bencher<'_, '_>) {
    ask(bencher, LENGTH, "f(at)");
}

#[divan::bench]
fn length_gradient(bencher: Bencher<'_, '_>) {
    ask(bencher, LENGTH, "gradient(f, at)");
}

#[divan::bench]
fn through_value(bencher: Bencher<'_, '_>) {
    ask(bencher, THROUGH, "f(at)");
}

#[divan::bench]
fn through_gradient(bencher: Bencher<'_, '_>) {
    ask(bencher, THROUGH, "gradient(f, at)");
}

#[divan::bench]
fn loft_value(bencher: Bencher<'_, '_>) {
    ask(bencher, LOFT, "f(at)");
}

#[divan::bench]
fn loft_gradient(bencher: Bencher<'_, '_>) {
    ask(bencher, LOFT, "gradient(f, at)");
}

#[divan::bench]
fn grid_value(bencher: Bencher<'_, '_>) {
    ask(bencher, GRID, "f(at)");
}

#[divan::bench]
fn grid_gradient(bencher: Bencher<'_, '_>) {
    ask(bencher, GRID, "gradient(f, at)");
}

#[divan::bench]
fn region_value(bencher: Bencher<'_, '_>) {
    ask(bencher, REGION, "f(at)");
}

#[divan::bench]
fn region_gradient(bencher: Bencher<'_, '_>) {
    ask(bencher, REGION, "gradient(f, at)");
}
