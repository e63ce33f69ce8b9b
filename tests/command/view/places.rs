//! Places that a click means, lines of equal parameter, and parameters that are known before a script is whole.

use serde_json::{Value as Json, json};

use super::client::{Item, View, key};

#[test]
fn clicks_are_drawn_to_ends_corners_and_vertices() {
    let script = "curve stem = line((0, 0, 1/3), (0, 0, 10))\n\
                  surface plate = bilinear((0, 0), (0, 4), (3, 0), (3, 4))\n\
                  surface ball = sphere((0, 0), 2)\n\
                  mesh tile = tessellate(bilinear((0, 0), (0, 4), (3, 0), (3, 1/3)))\n\
                  points cloud = [(1, 2, 3), (1/3, 0, 0)]\n";
    let view = View::of("snaps", script);
    let state = view.current();
    let header = |path: &str| view.item(&state, path).header;
    let stem = header("stem");
    assert_eq!([&stem["snaps"]["ends"], &stem["snaps"]["points"]["count"]], [&json!(2); 2]);
    let ask = |path: &str, place: Json| {
        let mut body = place;
        body["item"] = json!(key(&state, path));
        view.post("/api/ask", &body)
    };
    let end = stem["snaps"]["parameters"][0][0].clone();
    assert_eq!(ask("stem", json!({ "t": end })).json()["point"], json!([0.0, 0.0, 1.0 / 3.0]));
    let corners = header("plate")["snaps"]["parameters"].clone();
    assert_eq!(corners, json!([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]]));
    // A vertex is asked by its number, and has the coordinates of the script.
    let cloud = ask("cloud", json!({ "vertex": 1 }));
    assert_eq!(cloud.json()["point"], json!([1.0 / 3.0, 0.0, 0.0]));
    let vertices: Vec<Json> =
        (0..4).map(|i| ask("tile", json!({ "vertex": i })).json()["point"].clone()).collect();
    assert!(vertices.contains(&json!([3.0, 1.0 / 3.0, 0.0])), "{vertices:?}");
    for vertex in [json!(2), json!(-1), json!(0.5), json!("a"), json!(null)] {
        assert_eq!(ask("cloud", json!({ "vertex": vertex })).status, 400, "{vertex}");
    }
    // Where all directions are principal none is told.
    let facts = ask("ball", json!({ "u": 0.2, "v": 0.4 })).json()["facts"].to_string();
    assert!(facts.contains("every direction is principal") && !facts.contains("d1"), "{facts}");
}

#[test]
fn isocurves_are_as_many_as_are_asked_for() {
    let script = "surface plate = bilinear((0, 0), (0, 4), (3, 0), (3, 4))\n\
                  curve ring = circle((0, 0), 4)\n";
    let view = View::of("isocurves", script);
    let state = view.current();
    let ask = |path: &str, count: Json| {
        view.post("/api/isocurves", &json!({ "item": key(&state, path), "count": count }))
    };
    let lines = Item::of(ask("plate", json!(11)).body).header;
    for name in ["isocurves", "isocombs"] {
        assert_eq!(lines[name].as_array().map(Vec::len), Some(22), "{name}");
    }
    for (path, count) in
        [("plate", json!(0)), ("plate", json!(1e9)), ("plate", json!("a")), ("ring", json!(3))]
    {
        let reply = ask(path, count);
        assert!(reply.status == 400 && reply.json()["error"].is_string(), "{path}");
    }
}

#[test]
fn parameters_are_known_before_the_script_is_whole() {
    let script = "param width = 10mm in 5mm..20mm\nimport \"part.geo\" as part with (size = 2 * width)\n\
                  param lost = nothing\nsurface lid = sphere((0, 0), q)\n";
    let view = View::of("known", script);
    let first = view.until("run", |state| 0 < state["version"].as_u64().unwrap_or(0));
    let names = |state: &Json| -> Vec<String> {
        let all = state["parameters"].as_array().expect("a list").iter();
        all.map(|one| one["name"].as_str().expect("a name").to_owned()).collect()
    };
    assert_eq!(names(&first), ["width"]);
    assert_eq!([&first["parameters"][0]["least"], &first["imports"]], [&json!(5.0), &json!([])]);
    view.scratch
        .file("part.geo", "param size = 3mm in 1mm..30mm \"How large\"\nparam depth = 2mm\n");
    view.save("import \"part.geo\" as part with (size = 2 * width)\nparam width = 10mm\ncurve c = line((0, 0), (part.size, 0))\n");
    let whole = view.current();
    let part = &whole["imports"][0];
    assert_eq!([&part["path"], &part["line"]], [&json!("part.geo"), &json!(1)]);
    let [size, depth] = [0, 1].map(|i| &part["parameters"][i]);
    assert_eq!(
        [&size["name"], &size["label"], &size["given"]],
        ["size", "How large", "2 * width"].map(Json::from).each_ref()
    );
    assert_eq!(
        [&size["line"], &size["default"], &size["allowed"]],
        [&json!(1), &json!("3mm"), &json!("1mm..30mm")]
    );
    assert_eq!([&depth["given"], &depth["default"]], [&Json::Null, &json!("2mm")]);
}
