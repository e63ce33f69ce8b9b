//! What the page is sent: the state, and items whose numbers come from closed forms.

use serde_json::json;

use super::client::{View, key, told};
use crate::support::{Scratch, folder};

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn the_state_of_an_example_tells_all_that_it_says() {
    let scratch = Scratch::new("view-example");
    std::fs::copy(folder("examples/bottle.geo"), scratch.0.join("model.geo")).expect("a copy");
    let view = View::start(scratch, &["--set", "neck=15mm"]);
    let state = view.current();
    assert_eq!([&state["unit"], &state["script"]], [&json!("mm"), &json!("model.geo")]);
    let of = |name: &str| state[name].as_array().expect("a list").len();
    assert_eq!(
        ["parameters", "checks", "prints", "exports", "diagnostics"].map(of),
        [3, 13, 4, 2, 0]
    );
    let neck = &state["parameters"][2];
    assert_eq!(neck["name"], json!("neck"));
    assert_eq!([&neck["value"], &neck["default"]], [&json!("15mm"), &json!("13mm")]);
    assert_eq!(
        [&neck["least"], &neck["most"], &neck["step"]],
        [&json!(8.0), &json!(20.0), &json!(0.5)]
    );
    assert_eq!([&neck["kind"], &neck["isSet"]], [&json!("length"), &json!(true)]);
    assert!(state["checks"].as_array().expect("checks").iter().all(|its| its["verdict"] == "pass"));
    assert_eq!(told(&state, "wall")["kind"], json!("surface"));
    assert_eq!(told(&state, "wall")["facts"]["degree"], json!("2 x 3"));
    assert_eq!(told(&state, "profile")["kind"], json!("curve"));
    let page = view.get("/");
    assert!(
        page.status == 200 && page.head.contains("Content-Security-Policy: default-src 'self'")
    );
    assert!(view.get("/app.js").head.contains("Content-Encoding: gzip"));
}

#[test]
fn points_normals_and_curvatures_of_a_sphere_are_those_of_the_sphere() {
    let view = View::of("sphere", "surface ball = sphere((1000, 0, 5), 10)\n");
    let state = view.current();
    let item = view.item(&state, "ball");
    let places = item.places(&item.header["positions"]);
    let normals = item.numbers::<3>(&item.header["normals"]);
    let bends = item.numbers::<2>(&item.header["curvatures"]);
    let parameters = item.numbers::<2>(&item.header["parameters"]);
    assert!(places.len() > 500 && normals.len() == places.len());
    assert_eq!([bends.len(), parameters.len()], [places.len(); 2]);
    let mut n_bent = 0;
    for ((place, normal), bend) in places.iter().zip(&normals).zip(&bends) {
        let arm = [place[0] - 1000.0, place[1], place[2] - 5.0];
        assert!((length(arm) - 10.0).abs() < 2e-6, "vertices are points of the surface: {arm:?}");
        let off = [0, 1, 2].map(|i| normal[i] - arm[i] / 10.0);
        assert!(length(off) < 1e-6, "normals are those of the surface: {off:?}");
        if bend.iter().all(|k| k.is_finite()) {
            n_bent += 1;
            assert!(bend.iter().all(|k| (k.abs() - 0.1).abs() < 1e-7), "{bend:?}");
        }
    }
    assert!(places.len() - n_bent < 200, "only poles have none");
    for corners in item.triangles() {
        let [a, b, c] = corners.map(|i| places[i as usize]);
        let middle = [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0);
        let middle = [middle[0] - 1000.0, middle[1], middle[2] - 5.0];
        assert!((length(middle) - 10.0).abs() < 0.04, "within the tolerance");
        let [a, b, c] = corners.map(|i| normals[i as usize]);
        for (p, q) in [(a, b), (b, c), (c, a)] {
            let cosine: f64 = (0..3).map(|i| p[i] * q[i]).sum();
            assert!(libm::acos(cosine.min(1.0)) < 0.09, "normals turn 5 degrees at most");
        }
    }
}

#[test]
fn a_curve_comes_with_its_parameters_and_its_comb() {
    let view =
        View::of("curve", "curve ring = circle((0, 0), 4)\ncurve leg = line((0, 0), (3, 4))\n");
    let state = view.current();
    let ring = view.item(&state, "ring");
    let places = ring.places(&ring.header["edges"][0]);
    let comb = ring.numbers::<3>(&ring.header["comb"]);
    let parameters = ring.numbers::<1>(&ring.header["parameters"]);
    assert!(90 < places.len() && comb.len() == places.len() && parameters.len() == places.len());
    for (place, bend) in places.iter().zip(&comb) {
        assert!((length(*place) - 4.0).abs() < 1e-6);
        let off = [0, 1, 2].map(|i| bend[i] + place[i] / 16.0);
        assert!(length(off) < 1e-6, "towards the centre, 1/4 long: {bend:?}");
    }
    assert_eq!(ring.header["control"]["size"].as_array().expect("a size").len(), 1);
    let leg = view.item(&state, "leg");
    assert_eq!(leg.header["edges"][0]["count"], json!(2), "a line needs no more");
}

#[test]
fn lists_unfold_and_a_closed_surface_has_no_edge_at_its_seam() {
    let script = "surfaces pair = [sphere((0, 0), 1), plane_patch((0, 0), (1, 0), (0, 1))]\n\
                  points dots = [(1, 2), (3, 4)]\n\
                  curve aside = line((0, 0), (1, 0)) with (hidden = true, color = \"#102030\", layer = \"x\")\n";
    let view = View::of("lists", script);
    let state = view.current();
    let edges = |path: &str| view.item(&state, path).header["edges"].as_array().map(Vec::len);
    assert_eq!([edges("pair[0]"), edges("pair[1]")], [Some(0), Some(4)]);
    let dots = view.item(&state, "dots");
    assert_eq!(dots.places(&dots.header["positions"]), [[1.0, 2.0, 0.0], [3.0, 4.0, 0.0]]);
    let aside = told(&state, "aside");
    assert_eq!(aside["color"], json!([16, 32, 48]));
    assert_eq!([&aside["isHidden"], &aside["layer"]], [&json!(true), &json!("x")]);
}

#[test]
fn an_edit_changes_only_the_keys_of_what_it_touches() {
    let script = "surface a = sphere((0, 0), 10)\nsurface b = sphere((30, 0), 5)\nlet n = 1\n";
    let view = View::of("edit", script);
    let first = view.current();
    view.save(&format!(
        "// A remark moves everything.\n{}",
        script.replace("(30, 0), 5", "(30, 0), 6")
    ));
    let second = view.after(&first);
    assert_eq!(key(&second, "a"), key(&first, "a"));
    assert_ne!(key(&second, "b"), key(&first, "b"));
    assert_eq!(second["definitions"]["evaluated"], json!(1));
    // The page may still be fetching the state before; two later it is forgotten.
    let old = format!("/api/item/{}", key(&first, "b"));
    assert_eq!(view.get(&old).status, 200);
    view.save(&script.replace("(30, 0), 5", "(30, 0), 7"));
    view.after(&second);
    assert_eq!(view.get(&old).status, 404);
}

/// A script of every kind of item, with a number that they follow from, and of which one is exported.
fn of_all_kinds(size: &str) -> String {
    format!(
        "param r = {size}\n\
         surface ball = sphere((0, 0), r)\n\
         surface wave = parametric((u, v) => (u * r, v, sin(u)), 0..1, 0..1)\n\
         curve ring = circle((0, 0), r)\n\
         curve spiral = parametric(t => (r * cos(t), sin(t), t), 0..6)\n\
         mesh low = tessellate(ball)\n\
         points dots = [(r, 0), (0, r)]\n\
         surfaces row = [sphere((20, 0), r), sphere((40, 0), r / 2)]\n\
         surface aside = sphere((0, 20), r) with (hidden = true)\n"
    )
}

fn keys(state: &serde_json::Value) -> Vec<(String, String)> {
    let items = state["items"].as_array().expect("items");
    let text = |its: &serde_json::Value| its.as_str().expect("a text").to_owned();
    items.iter().map(|item| (text(&item["path"]), text(&item["key"]))).collect()
}

#[test]
fn an_edit_that_leaves_the_geometry_leaves_the_keys() {
    let view = View::of("same", &of_all_kinds("4"));
    let first = view.current();
    assert_eq!(keys(&first).len(), 9);
    // Somebody looks at what waits for that.
    let aside = view.item(&first, "aside").triangles();
    let mut last = first.clone();
    let renamed =
        of_all_kinds("4").replace("param r =", "param q = 4\nlet r = q +").replace("+ 4", "+ 0");
    for text in [
        of_all_kinds("2 + 2"),
        of_all_kinds("8 / 2 \"a label\""),
        renamed,
        of_all_kinds("4 // what it is")
            .replace("tessellate(ball)", "tessellate(sphere((0, 0), r))"),
    ] {
        view.save(&text);
        last = view.after(&last);
        assert_eq!(last["isCurrent"], json!(true), "{last:#}");
        assert_ne!(last["definitions"]["evaluated"], json!(0));
        assert_eq!(keys(&last), keys(&first), "{text}");
    }
    assert_eq!(view.item(&last, "aside").triangles(), aside);
    // Of a list only the part that is another one is sent.
    view.save(&of_all_kinds("4").replace("r / 2)", "r / 4)"));
    let part = view.after(&last);
    assert_eq!(key(&part, "row[0]"), key(&first, "row[0]"));
    assert_ne!(key(&part, "row[1]"), key(&first, "row[1]"));
    // What changes and changes back has the key that it had, which a page may still know.
    view.save(&of_all_kinds("5"));
    let other = view.after(&part);
    let is_old =
        |(path, key): &(String, String)| keys(&first).contains(&(path.clone(), key.clone()));
    assert!(!keys(&other).iter().any(is_old), "{other:#}");
    view.save(&of_all_kinds("4"));
    let back = view.after(&other);
    for path in ["ball", "wave", "ring", "spiral", "low", "dots", "row[1]"] {
        assert_eq!(key(&back, path), key(&first, path), "{path}");
    }
}

#[test]
fn what_waited_until_it_was_shown_keeps_its_key() {
    let script = "surface ball = sphere((0, 0), 2)\nmesh low = tessellate(ball)\n";
    let view = View::of("waited", &format!("{script}export low to \"low.stl\"\n"));
    let first = view.current();
    view.save(script);
    let shown = view.after(&first);
    assert_eq!(told(&shown, "ball")["isShown"], json!(true));
    assert_eq!(keys(&shown), keys(&first));
}

#[test]
fn definitions_with_one_text_are_items_of_their_own() {
    let view = View::of("twins", "surface a = sphere((0, 0), 2)\nsurface b = sphere((0, 0), 2)\n");
    let state = view.current();
    let keys = keys(&state);
    assert_eq!(keys.iter().map(|(path, _)| path.as_str()).collect::<Vec<_>>(), ["a", "b"]);
    assert_ne!(keys[0].1, keys[1].1);
    assert_eq!(view.item(&state, "a").triangles(), view.item(&state, "b").triangles());
    for path in ["a", "b"] {
        let ask = json!({ "item": key(&state, path), "u": 0.1, "v": 0.2 });
        assert_eq!(view.post("/api/ask", &ask).json()["definition"], json!(path));
    }
}

#[test]
fn what_cannot_be_drawn_is_told_and_the_rest_is_drawn() {
    let script =
        "let p = (1, 1)\nsurface spot = bilinear(p, p, p, p)\nsurface ball = sphere((0, 0), 1)\n";
    let view = View::of("spot", script);
    let state = view.until("run", |state| 0 < state["version"].as_u64().unwrap_or(0));
    assert!(state["items"].as_array().expect("items").iter().any(|item| item["path"] == "ball"));
    let empty = View::of("empty", "");
    let state = empty.current();
    assert_eq!([&state["items"], &state["bounds"]], [&json!([]), &json!(null)]);
}

#[test]
fn of_very_many_definitions_the_first_are_drawn_and_the_rest_is_told() {
    let script = (0..20_010).map(|i| format!("point p{i} = ({i}, 0, 0)\n")).collect::<String>();
    let view = View::of("many", &script);
    let state = view.current();
    let items = state["items"].as_array().expect("a list");
    assert_eq!(items.len(), 20_000);
    assert_eq!(items.last().expect("items")["path"], json!("p19999"));
    let found = state["diagnostics"].as_array().expect("a list");
    let told = found.iter().map(|one| (&one["line"], &one["message"])).collect::<Vec<_>>();
    let text = json!("the scene has more than 20000 items; the rest is not drawn");
    assert_eq!(told, [(&json!(20_001), &text)]);
    // What is looked at is as large as what is drawn.
    assert!(state["bounds"][1][0].as_f64().expect("bounds") <= 20_001.0, "{}", state["bounds"]);
    view.save(&script.lines().take(20_000).collect::<Vec<_>>().join("\n"));
    let whole = view.after(&state);
    assert_eq!(
        [&whole["diagnostics"], &json!(whole["items"] == state["items"])],
        [&json!([]), &json!(true)]
    );
}

#[test]
fn a_surface_with_very_many_bends_is_drawn_with_as_many_triangles_as_a_screen_can_bear() {
    // Normals that turn 5 degrees at most would take 388,000 vertices.
    let view = View::of(
        "many-bends",
        "surface s = revolve(bspline([for i in 0..300: (20 + i % 2, 0, i / 2)]))\n",
    );
    let state = view.current();
    assert_eq!(state["diagnostics"], json!([]));
    let n_points = told(&state, "s")["facts"]["points"].as_u64().expect("a number");
    assert!((10_000..150_000).contains(&n_points), "{n_points}");
}

#[test]
fn what_the_script_does_not_show_is_meshed_when_somebody_asks() {
    let script = "surface ball = sphere((0, 0), 2)\nmesh low = tessellate(ball)\n\
                  surfaces two = [sphere((9, 0), 1), bilinear((0, 0), (0, 1), (1, 0), (1, 1))]\n\
                  export low to \"low.stl\"\n";
    let view = View::of("deferred", script);
    let state = view.current();
    assert_eq!([&told(&state, "ball")["isShown"], &told(&state, "low")["isShown"]], [false, true]);
    let facts = &told(&state, "ball")["facts"];
    assert_eq!([&facts["degree"], &facts["triangles"]], [&json!("2 x 2"), &json!(null)]);
    let ball = view.item(&state, "ball");
    assert!(100 < ball.triangles().len());
    let radius = |place: [f64; 3]| place.iter().map(|x| x * x).sum::<f64>().sqrt();
    let places = ball.places(&ball.header["positions"]);
    assert!(places.into_iter().all(|place| (radius(place) - 2.0).abs() < 1e-6));
    assert_eq!(view.item(&state, "two[1]").triangles().len(), 2);
    // The next script shows it: what was made for nobody is in sight.
    view.save(&script.replace("export low to \"low.stl\"\n", ""));
    let shown = view.after(&state);
    assert_eq!(told(&shown, "ball")["isShown"], json!(true));
    assert_eq!(view.item(&shown, "ball").triangles(), ball.triangles());
}

#[test]
fn a_face_is_drawn_also_where_a_line_on_it_cannot_be_found() {
    let view = View::of(
        "far-face",
        "surface ball = sphere((1e6, -2e6, 5e5), 3)\n\
         face f = trim(ball, by = plane((1e6, -2e6, 500001), (0, 0, 1)), keep = \"above\")\n",
    );
    let item = view.item(&view.current(), "f");
    assert!(!item.places(&item.header["positions"]).is_empty(), "{:?}", item.header);
}
