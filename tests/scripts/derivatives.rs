//! The law of derivatives: of every operation through which they pass as a whole, against central
//! differences. The registry tells which operations those are, and their documented uses how to call them;
//! the coordinates in such a use are what varies.

use virote::{
    diag::{Code, Severity},
    ops,
    session::{Event, Report, Session},
    value::{ExamplePicture, NoFiles, Op, Type, Value},
};

/// Half the distance between the places of a central difference.
const STEP: f64 = 1e-5;

/// Of the size of a slope.
const NEAR: f64 = 1e-7;

/// Places around the documented one.
const N_PLACES: usize = 3;

fn run(script: &str) -> Report {
    Session::default().run("law.geo", script.as_bytes(), &NoFiles, &[])
}

/// Where the bracket at `open` closes.
fn closing(code: &str, open: usize) -> Option<usize> {
    let (mut depth, mut is_text) = (0, false);
    for (at, byte) in code.bytes().enumerate().skip(open) {
        match byte {
            b'"' => is_text = !is_text,
            b'(' | b'[' | b'{' if !is_text => depth += 1,
            b')' | b']' | b'}' if !is_text => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// The first call of a name in a piece of a script, up to its closing bracket.
fn call_of<'c>(code: &'c str, name: &str) -> Option<&'c str> {
    let start = code.match_indices(name).map(|(at, _)| at).find(|&at| {
        let before = code[..at].chars().next_back();
        let is_word = before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '.');
        !is_word && code[at + name.len()..].starts_with('(')
    })?;
    closing(code, start + name.len()).map(|end| &code[start..=end])
}

/// A call whose coordinates have what `d` says added, and how many different ones those are: the same points
/// move alike, so that what hangs together stays so. So have the lengths that the operation takes. Coordinates of zero may stay, for what lies in a plane.
fn varied(call: &str, op: &Op, with_zeros: bool) -> (String, usize) {
    let takes_number = |idx: usize| {
        let is_first = op.params.first().is_none_or(|param| !param.spreads);
        is_first
            && op
                .params
                .get(idx)
                .is_some_and(|param| matches!(param.ty, Type::Length | Type::Number))
    };
    let (mut depth, mut n_args) = (0_usize, 0);
    let mut out = String::new();
    let mut indices: Vec<(String, usize)> = Vec::new();
    let mut at = 0;
    while let Some(c) = call[at..].chars().next() {
        // A length among the arguments of the call itself.
        let number = call[at..].split([',', ')']).next().unwrap_or_default();
        if depth == 1
            && out.ends_with(['(', ' '])
            && takes_number(n_args)
            && number.parse::<f64>().is_ok_and(|number| with_zeros || 0.0 < number.abs())
        {
            out.push_str(&format!("({number} + d[{}])", indices.len()));
            indices.push((format!("argument {n_args}"), 0));
            at += number.len();
            continue;
        }
        let before = out.chars().next_back().unwrap_or(' ');
        let is_call = before.is_alphanumeric() || "_])".contains(before);
        let end = closing(call, at).filter(|_| c == '(' && !is_call);
        let inside = end.map(|end| &call[at + 1..end]);
        let is_point = |inside: &&str| {
            inside.contains(',') && !inside.contains(['(', '[', '{', ':', '=', '"'])
        };
        let Some(point) = inside.filter(is_point) else {
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth -= 1,
                ',' if depth == 1 => n_args += 1,
                _ => {}
            }
            out.push(c);
            at += c.len_utf8();
            continue;
        };
        out.push_str(&varied_point(point, &mut indices, with_zeros));
        at += point.len() + 2;
    }
    (out, indices.len())
}

/// A point's coordinates, each with what `d` at its index adds. `indices` says which coordinate of which point has
/// which index, and takes up new ones.
fn varied_point(point: &str, indices: &mut Vec<(String, usize)>, with_zeros: bool) -> String {
    let mut coordinates = Vec::new();
    for (axis, text) in point.split(',').map(str::trim).enumerate() {
        let number = text.parse::<f64>();
        if !with_zeros && number.as_ref().is_ok_and(|number| number.abs() <= 0.0) {
            coordinates.push(text.to_owned());
            continue;
        }
        let key = (point.to_owned(), axis);
        let idx = indices.iter().position(|known| *known == key).unwrap_or(indices.len());
        if idx == indices.len() {
            indices.push(key);
        }
        coordinates.push(match number {
            Ok(_) => format!("({text} + d[{idx}])"),
            // Of the points of a comprehension each moves in its own way.
            Err(_) => format!("({text}) * (1 + d[{idx}])"),
        });
    }
    format!("({})", coordinates.join(", "))
}

/// One number out of all that a value of a type is.
fn asked(of: Type, value: &str) -> Option<String> {
    Some(match of {
        Type::Curve => format!(
            "(x => dot(x(0.7 * x.domain.start + 0.3 * x.domain.end), (1, 2, -0.5)) + length(x) / 1mm)({value})"
        ),
        Type::Surface => format!(
            "(x => dot(x(0.7 * x.domain_u.start + 0.3 * x.domain_u.end, 0.4 * x.domain_v.start + 0.6 * x.domain_v.end), (1, 2, -0.5)) + area(x) / 1mm^2)({value})"
        ),
        Type::Point => format!("dot({value}, (1, 2, -0.5))"),
        Type::Number | Type::Ratio => value.to_owned(),
        Type::List(of, _) => {
            format!("sum([for x in {value}: {}])", asked(*of, "x")?)
        }
        _ => return None,
    })
}

/// The type of what a call yields, where its operation leaves it open.
fn type_of(call: &str) -> Option<Type> {
    let report = run(&format!("print {call}"));
    let [Event::Printed(printed)] = &report.events[..] else { return None };
    match &printed.value {
        Value::Point(_) => Some(Type::Point),
        Value::Curve(_) => Some(Type::Curve),
        Value::Surface(_) => Some(Type::Surface),
        _ => None,
    }
}

/// Offsets that are nowhere special, of the size of a twentieth.
fn place(seed: usize, n: usize) -> Vec<f64> {
    let golden = |idx: usize| ((seed * 131 + idx + 1) as f64 * 0.618_033_988_749_894_9).fract();
    (0..n).map(|idx| 0.1 * (golden(idx) - 0.5)).collect()
}

/// What a use of an operation says of its slopes: whether they are right, or nothing where it has none.
fn verdict(call: &str, op: &Op, of: Type, with_zeros: bool) -> Option<Result<(), String>> {
    let (varied, n) = varied(call, op, with_zeros);
    if n == 0 {
        return None;
    }
    let question = asked(of, &varied)?;
    for seed in 0..N_PLACES {
        let at: Vec<String> = place(seed, n).iter().map(f64::to_string).collect();
        let plain = format!(
            "let f = d => {question}\nlet at = [{}]\nlet moved = (i, h) => f([for k in 0..<{n}: at[k] + (if k == i then h else 0)])\n\
             let expected = [for i in 0..<{n}: (moved(i, {STEP}) - moved(i, -{STEP})) / (2 * {STEP})]\n",
            at.join(", ")
        );
        let script = format!(
            "{plain}let found = gradient(f, at)\nprint [for i in 0..<{n}: (found[i] - expected[i]) / (1 + abs(f(at)) + abs(expected[i]))]\n"
        );
        let report = run(&script);
        let is_none = |report: &Report| {
            report.diagnostics.iter().any(|found| found.code == Code::NoDerivative)
        };
        // What cannot be moved so says nothing of slopes.
        if is_none(&report)
            || run(&plain).diagnostics.iter().any(|found| found.severity == Severity::Error)
        {
            return None;
        }
        let [Event::Printed(printed)] = &report.events[..] else {
            let told: Vec<&str> = report.diagnostics.iter().map(|d| d.message.as_str()).collect();
            return Some(Err(format!("{}\n{script}", told.join("; "))));
        };
        let Value::List(errors) = &printed.value else { return None };
        let is_near = |error: Value| match error {
            Value::Number(number) => number.value.abs() < NEAR,
            _ => false,
        };
        if !errors.values().all(is_near) {
            return Some(Err(format!("misses by {}\n{script}", printed.value)));
        }
    }
    Some(Ok(()))
}

/// Whether derivatives pass through an operation as its documentation uses it.
fn law(op: &Op) -> Result<(), String> {
    let names: Vec<&str> = std::iter::once(op.name).chain(op.aliases.iter().copied()).collect();
    let pictures = op.picture.and_then(|picture| match picture {
        ExamplePicture::Value(code) => Some(code),
        ExamplePicture::Scene(_) => None,
    });
    let uses = op.examples.iter().map(|example| example.code).chain(pictures);
    let mut n_right = 0;
    for call in uses.flat_map(|code| names.iter().filter_map(move |name| call_of(code, name))) {
        let Some(of) = (match op.returns {
            Type::Geometry | Type::Any => type_of(call),
            of => Some(of),
        }) else {
            continue;
        };
        match verdict(call, op, of, true).or_else(|| verdict(call, op, of, false)) {
            Some(Ok(())) => n_right += 1,
            Some(Err(wrong)) => return Err(format!("{}: {wrong}", op.name)),
            None => {}
        }
    }
    match n_right {
        0 => Err(format!("{}: no derivative passes through any of its examples", op.name)),
        _ => Ok(()),
    }
}

#[test]
fn derivatives_through_whole_operations_agree_with_central_differences() {
    let registry = ops::registry();
    let affine: Vec<&Op> = registry.iter().filter(|op| op.is_affine).collect();
    assert!(10 < affine.len());
    let wrong: Vec<String> = affine.iter().filter_map(|op| law(op).err()).collect();
    assert!(wrong.is_empty(), "{}\n({} of {})", wrong.join("\n"), wrong.len(), affine.len());
}

/// Models of several operations, as functions of a place, and the place.
const MODELS: &[(&str, &str)] = &[
    // Of many control points, so that those move together that reach other parts of what is made.
    (
        "x => trim(bspline([for i in 0..29: (i, x[i], x[i]^2)], degree = 3), 0.13..0.61)(0.3).y + trim(bspline([for i in 0..29: (i, x[i])], degree = 3), 0.13..0.61)(0.14).y",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => split(bspline([for i in 0..29: (i, x[i])], degree = 3), 0.47)[1](0.5).y",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => rotate(reversed(bspline([for i in 0..29: (i, x[i])], degree = 3)), 30deg)(0.1).x",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => rotate(interpolate([for i in 0..29: (i, x[i])], parameters = [for i in 0..29: i]), 30deg, about = (1, 1, 1))(4.2).z",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => elevate(bspline([for i in 0..29: (i, x[i])], degree = 3), 5)(0.37).y",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => insert_knot(bspline([for i in 0..29: (i, x[i])], degree = 3), 0.371)(0.37).y",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => decompose(bspline([for i in 0..29: (i, x[i])], degree = 3))[4](0.16).y",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => revolve(bspline([for i in 0..29: (9 + x[i], 0, i)], degree = 3))(0.3, 0.4).x",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => revolve(interpolate([for i in 0..29: (9 + x[i], 0, i)]))(0.3, 0.4).x",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => extrude(interpolate([for i in 0..29: (i, x[i])]), (1, 0, 5))(0.3, 0.4).y",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => swung(bspline([for i in 0..14: (9 + x[i], 0, i)], degree = 3), bspline([for i in 0..14: (cos(i*3deg)*(5 + x[15 + i]), sin(i*3deg), 0)], degree = 3))(0.3, 0.4).x",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => ruled(bspline([for i in 0..14: (i, 0, x[i])], degree = 3), bspline([for i in 0..14: (i, 5, x[15 + i])], degree = 4))(0.3, 0.4).z",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => hermite([for i in 0..14: (i, x[i])], [for i in 0..14: (1, x[15 + i])])(0.3).y",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => insert_knot(bspline([for i in 0..4: [for j in 0..5: (i, j, x[6*i + j])]], degree = 3), v = 0.31)(0.3, 0.4).z",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => coons(u = [bspline([for j in 0..7: (j, 0, x[j])], degree = 3), bspline([for j in 0..7: (j, 7, x[8 + j])], degree = 3)], v = [bspline([for j in 0..7: (0, j, if j == 0 then x[0] else if j == 7 then x[8] else x[15 + j])], degree = 3), bspline([for j in 0..7: (7, j, if j == 0 then x[7] else if j == 7 then x[15] else x[21 + j])], degree = 3)])(0.3, 0.4).z",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => edge_surface([bspline([for j in 0..7: (j, 0, x[j])], degree = 3), bspline([for j in 0..7: (7, j, if j == 0 then x[7] else if j == 7 then x[15] else x[21 + j])], degree = 3), bspline([for j in 0..7: (j, 7, x[8 + j])], degree = 3), bspline([for j in 0..7: (0, j, if j == 0 then x[0] else if j == 7 then x[8] else x[15 + j])], degree = 3)])(0.3, 0.4).z",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => gordon(u = [for j in [0, 5]: interpolate([for i in 0..4: (i, j, x[5*j + i])], parameters = [for i in 0..4: i/4])], v = [for i in [0, 4]: interpolate([for j in 0..5: (i, j, x[5*j + i])], parameters = [for j in 0..5: j/5])])(0.3, 0.4).z",
        "[for i in 0..29: sin(i)]",
    ),
    // Of control points that many variables move each, through the matrix of what is made of them.
    (
        "x => trim(reversed(interpolate([for i in 0..29: (i, x[i])])), 0.2..0.8)(0.3).y + elevate(split(interpolate([for i in 0..29: (i, x[i])]), 0.5)[1], 4)(0.7).y",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => edge(interpolate([for i in 0..4: [for j in 0..5: (i, j, x[6*i + j])]]), \"u0\")(0.3).z + edges(rotate(interpolate([for i in 0..4: [for j in 0..5: (i, j, x[6*i + j])]]), 30deg, axis = (1, 1, 1)))[2](0.3).z",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => rotate(scale(interpolate([for i in 0..14: (x[i], x[15 + i], i)]), (1, 2, 3)), 40deg, axis = (1, 2, 3))(0.3).z",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => swung(interpolate([for i in 0..14: (9 + x[i], 0, i)], parameters = [for i in 0..14: i]), interpolate([for i in 0..14: (cos(i*3deg)*(5 + x[15 + i]), sin(i*3deg), 0)], parameters = [for i in 0..14: i]))(3.3, 4.4).x",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => coons(u = [interpolate([for j in 0..7: (j, 0, x[j])], parameters = [for j in 0..7: j/7]), interpolate([for j in 0..7: (j, 7, x[8 + j])], parameters = [for j in 0..7: j/7])], v = [interpolate([for j in 0..7: (0, j, if j == 0 then x[0] else if j == 7 then x[8] else x[15 + j])], parameters = [for j in 0..7: j/7]), interpolate([for j in 0..7: (7, j, if j == 0 then x[7] else if j == 7 then x[15] else x[21 + j])], parameters = [for j in 0..7: j/7])])(0.3, 0.4).z",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => edit_points(bspline([for i in 0..14: (i, x[i], x[15 + i])]))[7].z + de_casteljau(bezier([for i in 0..14: (i, x[i], x[15 + i])]), 0.3)[9][2].y + control_net(bspline([for i in 0..4: [for j in 0..5: (i, j, x[6*i + j])]]))[7](0.3).z",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => corner_surface((0, x[0]), (1, x[1]), (1, 1 + x[2]), (x[3], 1, x[4]))(0.3, 0.4).y + length(translate(bspline([for i in 0..24: (i, x[5 + i])]), (x[3], x[4])))",
        "[for i in 0..29: sin(i)]",
    ),
    (
        "x => rotate(nurbs([for i in 0..14: (i, x[i], x[15 + i])], weights = [for i in 0..14: 1 + i % 3]), 30deg, axis = (1, 1, 1))(0.4).y + curvature(elevate(nurbs([for i in 0..14: (i, x[i], x[15 + i])], weights = [for i in 0..14: 1 + i % 3]), 4), 0.4)",
        "[for i in 0..29: sin(i)]",
    ),
    ("p => length(interpolate([(0, 0), p, (4, 0)]))", "(2, 1)"),
    (
        "p => length(interpolate([(0, 0), p, (4, 0), (6, 1), (8, -1)], parameters = \"centripetal\"))",
        "(2, 1)",
    ),
    ("p => curvature(interpolate([(0, 0), p, (4, 0), (6, 1), (8, -1)]), 0.37) * 1mm", "(2, 1)"),
    ("p => closest(interpolate([(0, 0), p, (4, 0), (6, 1), (8, -1)]), (3, 3)).distance", "(2, 1)"),
    ("p => area(extrude(interpolate([(0, 0), p, (4, 0), (6, 1)]), (0, 0, 3)))", "(2, 1)"),
    (
        "p => length(trim(reversed(elevate(interpolate([(0, 0), p, (4, 0), (6, 1)]), 5)), 0.2..0.7))",
        "(2, 1)",
    ),
    (
        "p => length(rotate(join([interpolate([(0, 0), p, (4, 0), (6, 1)]), line((6, 1), (9, 9))]), 30deg))",
        "(2, 1)",
    ),
    (
        "p => area(ruled(interpolate([(0, 0), p, (4, 0), (6, 1)]), line((0, 0, 3), (6, 1, 3))))",
        "(2, 1)",
    ),
    (
        "p => area(skin([line((0, 0), (4, 0)), line((0, 2, 1), p), line((0, 5), (4, 5))]))",
        "(4, 2, 1)",
    ),
    (
        "p => area(skin([for i in 0..4: bezier((0, 0, i), p + (0, i, i^2), (4, i, 0))], parameters = \"centripetal\"))",
        "(2, 1)",
    ),
    (
        "p => area(skin([for i in 0..3: interpolate([(0, 0, i), p + (0, i, i), (4, i, i), (6, 1, i)])], parameters = [0, 1, 2, 3]))",
        "(2, 1)",
    ),
    (
        "p => area(interpolate([[(0, 0), (0, 2), (0, 4)], [(2, 0), p, (2, 4)], [(4, 0), (4, 2), (4, 4)]]))",
        "(2.1, 2, 1)",
    ),
    (
        "p => area(region([interpolate([(0, 0), (2, p), (4, 0), (6, 1)]), line((6, 1), (3, -4)), line((3, -4), (0, 0))]))",
        "1",
    ),
    ("p => inertia(region(polyline([(0, 0), p, (1, 4)], closed = true))).moments[0]", "(3, 1)"),
    ("r => length(region(circle((0, 0), 3), holes = [circle((1, 0), r)]))", "1.5"),
    ("r => volume(extrude(region(circle((0, 0), r)), (0, 1, 2 * r)))", "2"),
    ("r => area(extrude(region(circle((0, 0), r)), (0, 1, 2 * r)))", "2"),
    ("r => centroid(extrude(region(circle((r, 0), r)), (0, 1, 2 * r))).z", "2"),
    ("a => volume(revolve(region(circle((5, 0), 2)), axis = (0, 1, 0), angle = a))", "60deg"),
    (
        "x => centroid(revolve(region(polyline([(1, 0), (x, 1), (1, 4)], closed = true)), axis = (0, 1, 0))).y",
        "3",
    ),
    ("y => intersect(bezier((0, 0), (2, y), (4, 0)), circle((2, 0), 1.8))[0].point.x", "3"),
    ("y => intersect(line((0, 0, 0), (5, y, 1)), sphere((0, 0), 2))[0].point.y", "3"),
    ("y => intersect(line((0, 0, 0), (5, y, 1)), sphere((0, 0), 2))[0].u", "3"),
    ("r => intersect(sphere((0, 0), r), line((1, 1, -9), (1, 1.5, 9)))[1].t", "4"),
    (
        "z => intersect(bezier((1, 2, -50), (3, 1, z), (1.5, 1.2, 50)), bspline([for i in 0..3: [for j in 0..3: (i, j, z * i * j)]]))[0].v",
        "0.3",
    ),
    (
        "h => area(gordon([for j in 0..2: bezier((0, j), (1, j, h[j]), (2, j))], [line((0, 0), (0, 2)), line((2, 0), (2, 2))], at_u = [0, 1], at_v = [0, 0.5, 1]))",
        "[1, 2, 0.5]",
    ),
    (
        "h => area(skin([for i in 0..3: bezier((0, 0, i), (2, h[i], i), (4, i, 0))]))",
        "[1, 2, 0.5, 0.7]",
    ),
    (
        "h => area(skin([for i in 0..3: bezier((0, h[i], i), (1 + h[i] / 2, 3, i), (4, i, h[0]))], parameters = \"uniform\"))",
        "[1, 2, 0.5, 0.7]",
    ),
    ("h => area(cylinder((h[0], h[1]), h[2], h[3] + h[0]))", "[1, 2, 0.5, 0.7]"),
    ("h => area(torus((h[0], h[1], h[2]), 3, 1))", "[1, 2, 0.5]"),
    (
        "h => length(interpolate([for i in 0..4: (i, h[i])], parameters = [0, 1, 2.5, 3, 4]))",
        "[1, 2, 0.5, 0.7, 1.2]",
    ),
    (
        "h => length(interpolate([for i in 0..4: (i, h[i])], parameters = \"uniform\", ends = \"natural\"))",
        "[1, 2, 0.5, 0.7, 1.2]",
    ),
    (
        "h => length(interpolate([for i in 0..4: polar(1 + h[i], i * 72deg)], parameters = [0, 1, 2, 3, 4, 5], degree = 4, closed = true))",
        "[1, 2, 0.5, 0.7, 1.2]",
    ),
    (
        "h => curvature(bspline([for i in 0..5: (i, h[i])], closed = true), 0.37) * 1mm",
        "[1, 2, 0.5, 0.7, 1.2, -1]",
    ),
    (
        "h => mean(bspline([for i in 0..4: [for j in 0..3: (i, j, h[i] * j)]]), 0.3, 0.6) * 1mm",
        "[1, 2, 0.5, 0.7, 1.2]",
    ),
    (
        "h => gaussian(nurbs([for i in 0..3: [for j in 0..3: (i, j + h[j] / 9, h[i] * j)]], weights = [for i in 0..3: [for j in 0..3: 1 + i * j / 4]]), 0.3, 0.6) * 1mm^2",
        "[1, 2, 0.5, 0.7]",
    ),
    ("h => nurbs([for i in 0..3: (i, h[i])], weights = h)(0.3).y", "[1, 2, 0.5, 0.7]"),
    (
        "h => derivative(coons_bspline([for i in 0..3: [for j in 0..3: (i, j, h[i] * j)]], closed = {u: true, v: false}), 0.3, 0.6, du = 1, dv = 1).z",
        "[1, 2, 0.5, 0.7]",
    ),
];

#[test]
fn derivatives_through_models_agree_with_differences() {
    let disagrees = |(model, at): &(&str, &str)| {
        let script = format!(
            "unit mm\nlet f = {model}\ncheck gradient(f, {at}) ~= gradient(f, {at}, differences = true) within 1e-6\n"
        );
        let report = run(&script);
        let told: Vec<&str> = report.diagnostics.iter().map(|found| &*found.message).collect();
        (!told.is_empty()).then(|| format!("{model}: {}", told.join("; ")))
    };
    let wrong: Vec<String> = MODELS.iter().filter_map(disagrees).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
