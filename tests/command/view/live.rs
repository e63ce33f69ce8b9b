//! The page while the script is written: saves, errors, parameters, stops, other windows.

use std::{
    fs,
    io::{BufRead, BufReader, Write},
    process::Command,
    time::{Duration, Instant},
};

use serde_json::json;

use super::client::{View, key, told};
use crate::support::{Scratch, told as said, virote};

const SCRIPT: &str = "param r = 10mm in 5mm..20mm step 0.5mm \"Radius\"\n\
                      surface ball = sphere((0, 0), r)\nprint r\n";

/// A script that takes longer than anybody waits.
const ENDLESS: &str = "fn deep(m) = sum([for i in 0..<m: if i < 0 then 1 else i % 7])\n\
                       let n = sum([for i in 0..<1000000: deep(1000000 + i)])\n";

/// Lets it go on.
const PATIENT: [&str; 2] = ["--limit", "steps=1_000_000_000_000"];

#[test]
fn an_error_leaves_the_last_model_and_goes_when_it_is_mended() {
    let view = View::of("error", SCRIPT);
    let good = view.current();
    view.save(&SCRIPT.replace("sphere((0, 0), r)", "sphere((0, 0), q)"));
    let bad = view.after(&good);
    assert_eq!(bad["isCurrent"], json!(false));
    assert_eq!(key(&bad, "ball"), key(&good, "ball"));
    let found = &bad["diagnostics"][0];
    assert_eq!([&found["severity"], &found["line"]], [&json!("error"), &json!(2)]);
    let text = found["text"].as_str().expect("a text");
    assert!(text.contains("sphere((0, 0), q)") && !text.contains('\u{1b}'), "{text}");
    assert_eq!(bad["parameters"].as_array().map(Vec::len), Some(1), "controls stay");
    assert_eq!(view.get(&format!("/api/item/{}", key(&bad, "ball"))).status, 200);
    view.save(SCRIPT);
    let mended = view.after(&bad);
    assert_eq!([&mended["isCurrent"], &mended["diagnostics"]], [&json!(true), &json!([])]);
    assert_eq!(key(&mended, "ball"), key(&good, "ball"), "nothing is made again");
}

#[test]
fn a_script_that_never_was_whole_shows_what_is() {
    let script = "surface ball = sphere((0, 0), 3)\nsurface lid = sphere((0, 0), q)\n\
                  curve rim = circle(lid.center, 2)\nlet n = 1 + \"a\"\n";
    let view = View::of("partial", script);
    let first = view.until("run", |state| 0 < state["version"].as_u64().unwrap_or(0));
    assert_eq!([&first["isCurrent"], &first["isPartial"]], [&json!(false), &json!(true)]);
    assert_eq!(first["items"].as_array().map(Vec::len), Some(1), "{first:#}");
    assert_eq!(told(&first, "ball")["bounds"][1], json!([3.0, 3.0, 3.0]));
    let errors = first["diagnostics"].as_array().expect("a list");
    assert_eq!(errors.iter().map(|one| &one["line"]).collect::<Vec<_>>(), [2, 4]);
    // Questions about it are answered, and files are not written.
    let ask = json!({ "item": key(&first, "ball"), "u": 0.1, "v": 0.2 });
    assert_eq!(view.post("/api/ask", &ask).json()["definition"], json!("ball"));
    assert_eq!(view.post("/api/export", &json!({ "what": "script" })).status, 400);
    // Until it is whole the newest counts.
    view.save(&script.replace("sphere((0, 0), q)", "sphere((9, 0), 1)"));
    let second = view.after(&first);
    assert_eq!([&second["isCurrent"], &second["isPartial"]], [&json!(false), &json!(true)]);
    assert_eq!(key(&second, "ball"), key(&first, "ball"));
    assert_eq!(told(&second, "lid")["bounds"][1], json!([10.0, 1.0, 1.0]));
    view.save("surface ball = sphere((0, 0), 3)\n");
    let whole = view.after(&second);
    assert_eq!([&whole["isCurrent"], &whole["isPartial"]], [&json!(true), &json!(false)]);
    assert_eq!(key(&whole, "ball"), key(&first, "ball"));
    // Then it stays, also where more of the next one is whole.
    view.save(&format!("surface more = sphere((0, 0), 4)\n{script}"));
    let broken = view.after(&whole);
    assert_eq!([&broken["isCurrent"], &broken["isPartial"]], [&json!(false), &json!(false)]);
    assert_eq!(broken["items"].as_array().map(Vec::len), Some(1));
    assert_eq!(told(&broken, "ball")["bounds"][1], json!([3.0, 3.0, 3.0]));
}

#[test]
fn a_check_that_fails_is_told_and_shown() {
    let view = View::of("check", "curve c = circle((0, 0), 1)\ncheck length(c) == 6 \"round\"\n");
    let state = view.current();
    let check = &state["checks"][0];
    assert_eq!([&check["verdict"], &check["line"]], [&json!("fail"), &json!(2)]);
    assert!(check["left"].as_str().expect("a side").starts_with("6.28"), "{check}");
    assert_eq!(state["diagnostics"][0]["severity"], json!("failure"));
}

#[test]
fn a_claim_that_fails_tells_the_places_that_it_names() {
    let view = View::of(
        "places",
        "point top = (1, 2, 3)\nlet flat = bilinear((0, 0), (0, 1), (1, 0), (1, 1))\n\
         let hill = bilinear((0, 0), (0, 1), (1, 0), (1, 1, 2))\n\
         check top.z < 3\n\
         check top ~= (1, 2, 4)\n\
         check deviation(hill, flat).max < 1\n\
         check [top, (0, 0, 9)] ~= [top, (0, 0, 8)]\n\
         check every([(0, 0), (5, 0, 1)], f = p => p.z == 0)\n\
         check top.z == 3\n\
         check norm(top) < 1\n",
    );
    let state = view.current();
    let places = |i: usize| state["checks"][i]["places"].clone();
    assert_eq!(places(0), json!([[1.0, 2.0, 3.0]]));
    assert_eq!(places(1), json!([[1.0, 2.0, 3.0], [1.0, 2.0, 4.0]]));
    assert_eq!(places(2), json!([[1.0, 1.0, 2.0]]));
    assert_eq!(places(3), json!([[0.0, 0.0, 9.0], [0.0, 0.0, 8.0]]));
    assert_eq!(places(4), json!([[5.0, 0.0, 1.0]]));
    assert_eq!([places(5), places(6)], [json!([]), json!([])]);
}

#[test]
fn parameters_are_set_refused_and_reset() {
    let view = View::of("set", SCRIPT);
    let first = view.current();
    assert_eq!(
        view.post("/api/set", &json!({ "values": { "r": "12.5" } })).json(),
        json!({ "accepted": true })
    );
    let second = view.after(&first);
    let r = &second["parameters"][0];
    assert_eq!(
        [&r["value"], &r["number"], &r["isSet"]],
        [&json!("12.5mm"), &json!(12.5), &json!(true)]
    );
    assert_eq!(told(&second, "ball")["bounds"], json!([[-12.5, -12.5, -12.5], [12.5, 12.5, 12.5]]));
    // A value that the script refuses leaves the model.
    view.post("/api/set", &json!({ "values": { "r": "99mm" } }));
    let third = view.after(&second);
    assert_eq!(third["isCurrent"], json!(false));
    assert_eq!(third["parameters"][0]["value"], json!("99mm"));
    assert_eq!(key(&third, "ball"), key(&second, "ball"));
    view.post("/api/set", &json!({ "values": { "r": null } }));
    let fourth = view.after(&third);
    assert_eq!(
        [&fourth["isCurrent"], &fourth["parameters"][0]["value"]],
        [&json!(true), &json!("10mm")]
    );
    view.post("/api/set", &json!({ "values": { "r": "7mm" } }));
    let fifth = view.after(&fourth);
    view.post("/api/set", &json!({ "reset": true }));
    assert_eq!(view.after(&fifth)["parameters"][0]["isSet"], json!(false));
    for bad in [
        json!({}),
        json!({ "values": 3 }),
        json!({ "values": { "q": "1" } }),
        json!({ "values": { "r": 7 } }),
    ] {
        let reply = view.post("/api/set", &bad);
        assert!(reply.status == 400 && reply.json()["error"].is_string(), "{bad}");
    }
}

#[test]
fn many_settings_end_with_the_last_one() {
    let view = View::of("drag", SCRIPT);
    view.current();
    for i in 0..40 {
        view.post(
            "/api/set",
            &json!({ "values": { "r": format!("{}mm", 5.0 + 0.25 * f64::from(i * 2 % 30)) } }),
        );
    }
    view.post("/api/set", &json!({ "values": { "r": "19.5mm" } }));
    view.until("the last one", |state| {
        state["parameters"][0]["value"] == "19.5mm"
            && told(state, "ball")["bounds"][1][2] == json!(19.5)
    });
}

#[test]
fn an_endless_run_is_stopped_by_the_button_and_by_the_next_save() {
    let scratch = Scratch::new("view-endless");
    scratch.file("model.geo", SCRIPT);
    let view = View::start(scratch, &PATIENT);
    let first = view.current();
    view.save(&format!("{SCRIPT}{ENDLESS}"));
    // It has begun when the stream says so.
    let mut events = Events::of(&view);
    events.until("event: busy");
    assert_eq!(view.post("/api/stop", &json!({})).json(), json!({ "stopped": true }));
    let stopped = view.after(&first);
    assert_eq!(stopped["isCurrent"], json!(false));
    assert_eq!(key(&stopped, "ball"), key(&first, "ball"));
    assert!(stopped["diagnostics"][0]["message"].as_str().expect("a text").contains("stopped"));
    view.save(&format!("{SCRIPT}// again\n{ENDLESS}"));
    events.until("event: busy");
    let begin = Instant::now();
    view.save(SCRIPT);
    view.until("mended", |state| state["isCurrent"] == json!(true));
    assert!(begin.elapsed() < Duration::from_secs(20), "it was not waited for");
}

#[test]
fn a_script_that_goes_and_comes_back_is_waited_for() {
    let view = View::of("gone", SCRIPT);
    let first = view.current();
    let path = view.scratch.0.join("model.geo");
    fs::remove_file(&path).expect("it goes");
    let gone = view.after(&first);
    assert_eq!(
        [&gone["isCurrent"], &gone["diagnostics"][0]["code"]],
        [&json!(false), &json!(null)]
    );
    assert_eq!(key(&gone, "ball"), key(&first, "ball"));
    fs::create_dir(&path).expect("a folder in its place");
    fs::remove_dir(&path).expect("it goes as well");
    view.save(SCRIPT);
    let back = view.until("back", |state| state["isCurrent"] == json!(true));
    assert_eq!(key(&back, "ball"), key(&first, "ball"));
}

#[test]
fn values_of_parameters_that_are_gone_are_forgotten() {
    let view = View::of("lost", SCRIPT);
    let first = view.current();
    assert_eq!(view.post("/api/set", &json!({ "values": { "r": "12mm" } })).status, 200);
    let set = view.after(&first);
    assert_eq!(set["parameters"][0]["value"], json!("12mm"));
    view.save(
        &SCRIPT.replace("param r", "param q").replace("r)", "q)").replace("print r", "print q"),
    );
    let renamed = view.after(&set);
    assert_eq!(renamed["isCurrent"], json!(true));
    let found = renamed["diagnostics"].as_array().expect("a list");
    assert_eq!(
        [&found[0]["severity"], &found[0]["message"]],
        [
            &json!("warning"),
            &json!("the script has no parameter `r` any more: its value, 12mm, is forgotten")
        ]
    );
    // It is said once, and what is set after it holds.
    let body = json!({ "values": { "r": null, "q": "13mm" } });
    assert_eq!(view.post("/api/set", &body).status, 200);
    let last = view.after(&renamed);
    assert_eq!(
        [&last["diagnostics"], &last["parameters"][0]["value"]],
        [&json!([]), &json!("13mm")]
    );
    assert_eq!(view.post("/api/set", &json!({ "values": { "r": "1mm" } })).status, 400);
}

#[test]
fn a_folder_in_the_place_of_the_script_is_told_as_one() {
    let view = View::of("folder", SCRIPT);
    let path = view.scratch.0.join("model.geo");
    view.current();
    fs::remove_file(&path).expect("it goes");
    let says = |state: &serde_json::Value, text: &str| {
        state["diagnostics"][0]["message"].as_str().is_some_and(|told| told.contains(text))
    };
    view.until("gone", |state| says(state, "there is no such file"));
    fs::create_dir(&path).expect("a folder in its place");
    view.until("a folder", |state| says(state, "is a folder, not a script"));
    fs::remove_dir(&path).expect("it goes as well");
    view.until("gone again", |state| says(state, "there is no such file"));
    view.save(SCRIPT);
    view.until("back", |state| state["isCurrent"] == json!(true));
}

#[test]
fn files_that_the_script_reads_are_followed() {
    let scratch = Scratch::new("view-import");
    scratch.file("part.geo", "let size = 3\n");
    scratch
        .file("model.geo", "import \"part.geo\" as part\nsurface s = sphere((0, 0), part.size)\n");
    let view = View::start(scratch, &[]);
    let first = view.current();
    view.scratch.file("part.geo", "let size = 4\n");
    let second = view.after(&first);
    assert_eq!(told(&second, "s")["bounds"][1], json!([4.0, 4.0, 4.0]));
}

/// The stream of events.
struct Events(BufReader<std::net::TcpStream>);

impl Events {
    fn of(view: &View) -> Self {
        Self::asked(view, "")
    }

    fn asked(view: &View, more: &str) -> Self {
        let mut stream = view.connect();
        let text = format!(
            "GET /api/events?token={}{more} HTTP/1.1\r\nHost: {}\r\n\r\n",
            view.token, view.host
        );
        stream.write_all(text.as_bytes()).expect("it is sent");
        Self(BufReader::new(stream))
    }

    /// Reads up to a line; the one behind it.
    fn until(&mut self, wanted: &str) -> String {
        let mut line = String::new();
        while line.trim() != wanted {
            line.clear();
            assert_ne!(self.0.read_line(&mut line).expect("an event"), 0, "no {wanted}");
        }
        line.clear();
        self.0.read_line(&mut line).expect("its data");
        line.trim().to_owned()
    }
}

#[test]
fn two_windows_hear_the_same() {
    let view = View::of("windows", SCRIPT);
    let first = view.current();
    let mut windows = [Events::of(&view), Events::of(&view)];
    for window in &mut windows {
        assert_eq!(
            window.until("event: state"),
            format!("data: {{\"version\":{}}}", first["version"])
        );
    }
    view.save(&SCRIPT.replace("10mm in", "11mm in"));
    for window in &mut windows {
        assert_eq!(window.until("event: state"), "data: {\"version\":2}");
    }
    let [gone, mut stays] = windows;
    drop(gone);
    view.save(SCRIPT);
    assert_eq!(stays.until("event: state"), "data: {\"version\":3}");
}

#[test]
fn a_stream_brings_states_whole_where_they_are_wanted_so() {
    let view = View::of("whole", SCRIPT);
    let state = view.current();
    let mut events = Events::asked(&view, "&states=whole");
    let line = events.until("event: state");
    let told: serde_json::Value =
        serde_json::from_str(line.strip_prefix("data: ").expect("data")).expect("JSON");
    assert_eq!([&told["version"], &told["state"]], [&state["version"], &state]);
}

#[test]
fn a_port_that_is_taken_is_told_with_another() {
    let view = View::of("port", SCRIPT);
    let port = view.host.split(':').nth(1).expect("a port");
    let output = virote(&view.scratch.0)
        .args(["view", "model.geo", "--no-open", "--port", port])
        .output()
        .expect("it runs");
    let (_, err, code) = said(&output);
    assert!(code == 3 && err.contains(&format!("port {port} is in use; `--port ")), "{err}");
}

#[test]
fn what_is_no_script_is_told_as_by_other_commands() {
    let scratch = Scratch::new("view-missing");
    for (name, part) in
        [("none.geo", "cannot read `none.geo`"), (".", "is a folder"), ("-", "cannot be watched")]
    {
        let output =
            virote(&scratch.0).args(["view", "--no-open", name]).output().expect("it runs");
        let (_, err, code) = said(&output);
        assert!(code == 3 && err.contains(part), "{err}");
    }
}

#[test]
fn ctrl_c_ends_it_also_while_it_evaluates() {
    let scratch = Scratch::new("view-interrupt");
    scratch.file("model.geo", ENDLESS);
    let mut view = View::start(scratch, &PATIENT);
    let sent = Command::new("kill").args(["-INT", &view.child.id().to_string()]).status();
    assert!(sent.expect("a signal").success());
    assert_eq!(view.child.wait().expect("it ends").code(), Some(0));
}
