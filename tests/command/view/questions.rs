//! Questions and wishes of the page: exact answers, defaults written, files exported.

use std::{collections::BTreeSet, fs};

use serde_json::{Value as Json, json};

use super::client::{Reply, View, key};
use crate::support::{Scratch, files_below, told as said, virote};

const SCRIPT: &str = "// größe\nparam r = 2mm in 1mm..9mm // here\nparam word = \"a\"\n\
                      surface ball = sphere((0, 0), r)\n\
                      surface tube = extrude(circle((0, 0), 4), (0, 0, 3))\n\
                      curve ring = circle((0, 0), 4)\n\
                      export ball to \"ball.stl\"\n";

#[track_caller]
fn near(found: &Json, expected: f64) {
    let found = found.as_f64().expect("a number");
    assert!((found - expected).abs() < 1e-9, "{found} is not {expected}");
}

/// The value of a fact.
#[track_caller]
fn fact<'j>(answer: &'j Json, name: &str) -> &'j Json {
    assert!(answer["facts"].is_array(), "{answer:#}");
    let facts = answer["facts"].as_array().expect("facts");
    &facts.iter().find(|fact| fact["name"] == json!(name)).expect("it is told")["value"]
}

#[test]
fn places_are_asked_of_the_kernel() {
    let view = View::of("ask", SCRIPT);
    let state = view.current();
    let ask = |path: &str, more: Json| {
        let mut body = more;
        body["item"] = json!(key(&state, path));
        view.post("/api/ask", &body).json()
    };
    let ball = ask("ball", json!({ "u": 0.2, "v": 0.4 }));
    assert_eq!(
        [&ball["definition"], &ball["expression"]],
        [&json!("ball"), &json!("ball(0.2, 0.4)")]
    );
    near(fact(&ball, "gauss"), 0.25);
    near(&json!(fact(&ball, "mean").as_f64().expect("a number").abs()), 0.5);
    let length = |v: &Json| {
        (0..3).map(|i| v[i].as_f64().expect("a number")).map(|x| x * x).sum::<f64>().sqrt()
    };
    near(&json!(length(&ball["point"])), 2.0);
    near(&json!(length(&ball["normal"])), 1.0);
    let tube = ask("tube", json!({ "u": 0.2, "v": 0.4 }));
    near(fact(&tube, "gauss"), 0.0);
    let bends = ["k1", "k2"].map(|name| fact(&tube, name).as_f64().expect("a number").abs());
    near(&json!(bends[0].max(bends[1])), 0.25);
    let ring = ask("ring", json!({ "t": 0.3 }));
    near(fact(&ring, "curvature"), 0.25);
    near(fact(&ring, "radius"), 4.0);
    near(fact(&ring, "torsion"), 0.0);
    assert_eq!(ring["expression"], json!("ring(0.3)"));
    // The expression is one that the script understands, and its answer is the same.
    view.save(&format!("{SCRIPT}print {}\n", ring["expression"].as_str().expect("a text")));
    let point = &ring["point"];
    let written = |i: usize| point[i].as_f64().expect("a number");
    let expected = format!("({}, {}, {})", written(0), written(1), written(2));
    let state = view.after(&state);
    assert_eq!(state["prints"][0]["value"], json!(expected));
}

/// What an address answers with numbers.
fn numbers(reply: &[u8]) -> Vec<f32> {
    let number = |four: &[u8]| f32::from_le_bytes(four.try_into().expect("four bytes"));
    reply.chunks_exact(4).map(number).collect()
}

#[test]
fn a_deviation_is_measured_at_each_vertex_with_its_side() {
    let view = View::of(
        "deviation",
        "surface ball = sphere((0, 0), 3)\nsurface core = sphere((0, 0), 2)\n\
         surface shape = parametric((u, v) => (u, v, 5), 0..1, 0..1)\n\
         surface floor = bilinear((0, 0, 1), (0, 1, 1), (1, 0, 1), (1, 1, 1))\n\
         mesh low = tessellate(bilinear((0, 0), (0, 1), (1, 0), (1, 1)))\n\
         curve c = circle((0, 0), 1)\n",
    );
    let state = view.current();
    let ask = |item: &str, from: &[&str]| {
        let from: Vec<String> = from.iter().map(|path| key(&state, path)).collect();
        view.post("/api/deviation", &json!({ "item": key(&state, item), "from": from }))
    };
    let all = |item: &str, from: &[&str], expected: f32| {
        let reply = ask(item, from);
        assert_eq!(reply.status, 200);
        let found = numbers(&reply.body);
        let n_vertices = view.item(&state, item).header["positions"]["count"].as_u64();
        assert_eq!(Some(found.len() as u64), n_vertices);
        let is_near = |value: &f32| (value - expected).abs() < 1e-6;
        assert!(found.iter().all(is_near), "{item} from {from:?}: {found:?}");
    };
    all("ball", &["core"], 1.0);
    all("core", &["ball"], -1.0);
    all("ball", &["ball"], 0.0);
    all("shape", &["floor"], 4.0);
    all("floor", &["shape"], -4.0);
    all("floor", &["low"], 1.0);
    all("low", &["floor", "shape"], -1.0);
    for (item, from, why) in [("c", "ball", "curve"), ("ball", "c", "from a surface or a mesh")] {
        let reply = ask(item, &[from]);
        assert_eq!(reply.status, 400);
        assert!(reply.json()["error"].as_str().expect("a reason").contains(why));
    }
    assert_eq!(ask("ball", &[]).status, 400);
}

#[test]
fn borders_of_stripes_are_where_closed_forms_have_them() {
    let view = View::of(
        "stripes",
        "surface ball = sphere((1, 2, 0), 3)\n\
         surface shape = parametric((u, v) => (u, v, 1 - u^2 - v^2), -1..1, -1..1)\n\
         mesh low = tessellate(ball)\ncurve c = circle((0, 0), 1)\n",
    );
    let state = view.current();
    let ask = |item: &str, more: Json| {
        let mut body = json!({ "item": key(&state, item), "light": [0, 0, 2], "axis": [1, 0, 0], "stripes": 2 });
        let more = more.as_object().expect("members").clone();
        body.as_object_mut().expect("members").extend(more);
        view.post("/api/stripes", &body)
    };
    let places = |reply: &Reply| -> Vec<[f64; 3]> {
        assert_eq!(reply.status, 200);
        let all = numbers(&reply.body);
        all.chunks(3).map(|p| [f64::from(p[0]), f64::from(p[1]), f64::from(p[2])]).collect()
    };

    // Circles where the normal stands at odd multiples of 11.25 degrees to the light.
    let found = places(&ask("ball", json!({ "kind": "isophotes" })));
    let steps: Vec<f64> =
        found.iter().map(|p| libm::acos(p[2] / 3.0).to_degrees() / 11.25).collect();
    assert!(steps.iter().all(|step| (step - step.round()).abs() < 1e-2), "{steps:?}");
    let circles: BTreeSet<i64> = steps.iter().map(|step| step.round() as i64).collect();
    assert_eq!(circles, (1..16).step_by(2).collect());

    // Eight sectors about x: the mirrored ray of a normal is twice as far from the light.
    let found = places(&ask("ball", json!({ "kind": "zebra" })));
    assert!(100 < found.len());
    for [x, y, z] in found {
        let n = [x / 3.0, y / 3.0, z / 3.0];
        let (aside, along) = (2.0 * n[2] * n[1], 2.0 * n[2] * n[2] - 1.0);
        // At a pole of the sectors all of them meet.
        if 0.05 < aside.abs().max(along.abs()) {
            let step = libm::atan2(aside, along).to_degrees() / 22.5;
            assert!((step - step.round()).abs() < 2e-2 && step.round() as i64 % 2 != 0, "{step}");
        }
    }
    // The slope of a paraboloid is twice the distance from its axis.
    let found = places(&ask("shape", json!({ "kind": "isophotes", "stripes": 1 })));
    let first = 0.5 * libm::tan(22.5_f64.to_radians());
    let radius = |p: &[f64; 3]| (p[0] * p[0] + p[1] * p[1]).sqrt();
    assert!(found.iter().any(|p| (radius(p) - first).abs() < 1e-3), "{found:?}");

    for (item, more, why) in [
        ("low", json!({}), "a mesh has no exact stripes"),
        ("c", json!({}), "a curve has no exact stripes"),
        ("ball", json!({ "stripes": 0 }), "from 1 to 100"),
        ("ball", json!({ "light": [0, 1] }), "three numbers"),
        ("ball", json!({ "light": [0, 0, 0] }), "the light"),
        ("ball", json!({ "kind": "zebra", "axis": [0, 0, 1] }), "the axis across the light"),
    ] {
        let reply = ask(item, more);
        assert_eq!(reply.status, 400);
        let told = reply.json()["error"].as_str().expect("a reason").to_owned();
        assert!(told.contains(why), "{told}");
    }
}

#[test]
fn many_items_come_in_one_answer() {
    let view = View::of("items", SCRIPT);
    let state = view.current();
    let keys = [key(&state, "ball"), "unknown".to_owned(), key(&state, "ring")];
    let reply = view.post("/api/items", &json!({ "items": keys }));
    assert_eq!(reply.status, 200);
    let word = |i: usize| {
        let four = reply.body[4 * i..4 * i + 4].try_into().expect("four bytes");
        u32::from_le_bytes(four) as usize
    };
    assert_eq!([word(0), word(2)], [3, 0]);
    let mut at = (4 * 4_usize).next_multiple_of(8);
    for (i, key) in keys.iter().enumerate().filter(|(i, _)| *i != 1) {
        let alone = view.get(&format!("/api/item/{key}")).body;
        assert_eq!(reply.body[at..at + word(1 + i)], alone);
        at = (at + word(1 + i)).next_multiple_of(8);
    }
    assert_eq!(reply.body.len(), at);
    assert_eq!(view.post("/api/items", &json!({ "items": [1] })).status, 400);
}

#[test]
fn questions_without_an_answer_say_why() {
    let view = View::of("ask-wrong", SCRIPT);
    let state = view.current();
    for body in [
        json!({}),
        json!({ "item": "none", "u": 0, "v": 0 }),
        json!({ "item": key(&state, "ball") }),
        json!({ "item": key(&state, "ball"), "u": 7.0, "v": 0.0 }),
        json!({ "item": key(&state, "ring"), "t": "a" }),
    ] {
        let reply = view.post("/api/ask", &body);
        assert!(reply.status == 400 && reply.json()["error"].is_string(), "{body}");
    }
}

#[test]
fn lengths_areas_and_volumes_are_exact() {
    let view = View::of("measure", SCRIPT);
    let state = view.current();
    let measure = |kind: &str, path: &str| {
        view.post("/api/measure", &json!({ "kind": kind, "items": [key(&state, path)] }))
    };
    let pi = std::f64::consts::PI;
    let length = measure("length", "ring").json();
    near(&length["value"], 8.0 * pi);
    assert_eq!(length["text"], json!("25.1327 mm"));
    near(&measure("area", "tube").json()["value"], 24.0 * pi);
    let volume = measure("volume", "ball").json();
    near(&volume["value"], 32.0 / 3.0 * pi);
    assert!(volume["text"].as_str().expect("a text").ends_with("mm³"));
    assert_eq!([measure("volume", "tube").status, measure("length", "ball").status], [400; 2]);
    assert_eq!(measure("colour", "ball").status, 400);
}

#[test]
fn the_area_of_a_region_is_that_of_its_borders() {
    let script = "let whole = region(circle((0, 0), 4))\n\
                  region plate = difference(whole, region(circle((1, 1), 1)))[0]\n";
    let view = View::of("region", script);
    let state = view.current();
    let measure = |kind: &str| {
        view.post("/api/measure", &json!({ "kind": kind, "items": [key(&state, "plate")] }))
    };
    near(&measure("area").json()["value"], 15.0 * std::f64::consts::PI);
    assert_eq!(measure("volume").json()["error"], json!("a region encloses no volume"));
}

#[test]
fn a_default_is_written_and_nothing_else() {
    let view = View::of("write", SCRIPT);
    let state = view.current();
    view.post("/api/set", &json!({ "values": { "r": "5" } }));
    let state = view.after(&state);
    let written = view.post("/api/write", &json!({ "values": { "r": "5", "word": "b \"c\"" } }));
    assert_eq!(written.json()["written"].as_array().map(Vec::len), Some(2));
    let expected = SCRIPT.replace("r = 2mm", "r = 5mm").replace("\"a\"", r#""b \"c\"""#);
    assert_eq!(view.script(), expected);
    let state = view.until("written", |new| {
        new["version"].as_u64() > state["version"].as_u64()
            && new["parameters"][0]["isSet"] == json!(false)
    });
    assert_eq!(state["parameters"][0]["value"], json!("5mm"));
    for value in ["99mm", "1 + ", "2mm\nprint 1", ""] {
        assert_eq!(
            view.post("/api/write", &json!({ "values": { "r": value } })).status,
            400,
            "{value}"
        );
    }
    assert_eq!(view.script(), expected, "what is refused changes nothing");
    assert_eq!(files_below(&view.scratch.0), ["model.geo"], "no file is left beside it");
}

#[test]
fn files_are_exported_as_by_run_or_as_chosen() {
    let view = View::of("export", SCRIPT);
    view.current();
    let files = view.post("/api/export", &json!({ "what": "script" })).json();
    assert_eq!(files, json!({ "files": ["ball.stl"] }));
    let here = fs::read(view.scratch.0.join("ball.stl")).expect("it is written");
    let out = Scratch::new("view-export-run");
    let run = virote(&view.scratch.0).args(["run", "model.geo", "--out"]).arg(&out.0).output();
    assert_eq!(said(&run.expect("it runs")).2, 0);
    assert!(here == fs::read(out.0.join("ball.stl")).expect("it is written"), "the same bytes");
    let chosen = json!({ "items": ["tube", "ring"], "file": "parts/some.glb" });
    assert_eq!(view.post("/api/export", &chosen).json(), json!({ "files": ["parts/some.glb"] }));
    for bad in [
        json!({ "items": ["tube"], "file": "../out.stl" }),
        json!({ "items": ["tube"], "file": "model.geo" }),
        json!({ "items": ["tube"], "file": "x.doc" }),
        json!({ "items": ["none"], "file": "x.stl" }),
        json!({ "items": [], "file": "x.stl" }),
        json!({}),
    ] {
        assert_eq!(view.post("/api/export", &bad).status, 400, "{bad}");
    }
    assert_eq!(files_below(&view.scratch.0), ["ball.stl", "model.geo", "parts/some.glb"]);
}

#[test]
fn a_page_of_its_own_holds_the_model() {
    let scratch = Scratch::new("view-page");
    scratch.file("model.geo", format!("{SCRIPT}print \"</script><b>\"\n"));
    let export = |file: &str| {
        let args = ["view", "model.geo", "--no-open", "--export", file];
        let output = virote(&scratch.0).args(args).output();
        said(&output.expect("it runs"))
    };
    let (out, err, code) = export("page.html");
    assert!(code == 0 && out.contains("wrote page.html"), "{err}");
    let page = fs::read_to_string(scratch.0.join("page.html")).expect("it is written");
    let start = page.find("id=\"virote-data\">").expect("its data") + "id=\"virote-data\">".len();
    let data = page[start..].split("</script>").next().expect("its end");
    let data: Json = serde_json::from_str(data).expect("JSON");
    assert_eq!(data["state"]["prints"][0]["text"], json!("</script><b>"));
    let items = data["state"]["items"].as_array().expect("items");
    assert!(
        items.iter().all(|item| data["items"][item["key"].as_str().expect("a key")].is_string())
    );
    assert!(
        ["href=\"app.css\"", "src=\"app.js\"", "begin.js"].iter().all(|one| !page.contains(one))
    );
    assert_eq!(export("model.geo").2, 3, "not over the script");
    for (file, why) in [(".", "it is a folder"), ("-", "not to standard output")] {
        let (_, err, code) = export(file);
        assert!(code == 3 && err.contains(why), "{file}: {err}");
    }
    scratch.file("model.geo", "let a = b\n");
    assert_eq!(export("other.html").2, 2);
    assert_eq!(files_below(&scratch.0), ["model.geo", "page.html"]);
}
