//! The files of a script that go, come back, and have others in their place, while it is shown.

use std::{fs, path::Path};

use serde_json::{Value as Json, json};

use super::client::{View, key, told};
use crate::support::Scratch;

/// A script with an import and data, each in a folder.
const SCRIPT: &str = "import \"lib/part.geo\" as part\nlet rows = load(\"data/sizes.csv\")\n\
                      surface ball = sphere((0, 0), part.size)\npoint end = (max(rows.x), 0)\n";
const PART: &str = "let size = 3\n";
const SIZES: &str = "x\n1\n5\n";

fn view(name: &str) -> View {
    let scratch = Scratch::new(&format!("view-{name}"));
    for folder in ["lib", "data"] {
        fs::create_dir(scratch.0.join(folder)).expect("a folder");
    }
    scratch.file("lib/part.geo", PART);
    scratch.file("data/sizes.csv", SIZES);
    scratch.file("model.geo", SCRIPT);
    View::start(scratch, &[])
}

fn says(state: &Json, text: &str) -> bool {
    let told = state["diagnostics"].as_array().expect("a list");
    state["isCurrent"] == json!(false)
        && told.iter().any(|one| one["message"].as_str().is_some_and(|its| its.contains(text)))
}

#[track_caller]
fn until_it_says(view: &View, model: &Json, text: &str) {
    let state = view.until(text, |state| says(state, text));
    assert_eq!(key(&state, "ball"), key(model, "ball"), "the model stays");
}

/// What becomes of a file, and of the folder that it is in.
#[track_caller]
fn goes_and_comes_back(view: &View, path: &Path, text: &str, messages: [&str; 2]) {
    let [gone, folder] = messages;
    let model = view.current();
    let back = |what: &str| {
        let state = view.until(what, |state| state["isCurrent"] == json!(true));
        assert_eq!(key(&state, "ball"), key(&model, "ball"), "{what}");
    };
    fs::remove_file(path).expect("it goes");
    until_it_says(view, &model, gone);
    fs::create_dir(path).expect("a folder in its place");
    until_it_says(view, &model, folder);
    fs::remove_dir(path).expect("the folder goes");
    until_it_says(view, &model, gone);
    fs::write(path, text).expect("it is back");
    back("back");
    // All at once, and back as it was.
    let aside = path.with_extension("aside");
    fs::rename(path, &aside).expect("it is moved");
    fs::create_dir(path).expect("a folder in its place");
    until_it_says(view, &model, folder);
    fs::remove_dir(path).expect("the folder goes");
    fs::rename(&aside, path).expect("it is moved back");
    back("moved back");
    let parent = path.parent().expect("a folder");
    let aside = parent.with_extension("aside");
    fs::rename(parent, &aside).expect("its folder goes");
    until_it_says(view, &model, gone);
    fs::rename(&aside, parent).expect("its folder is back");
    back("its folder back");
}

#[test]
fn data_that_go_and_come_back_are_told() {
    let view = view("data-gone");
    let path = view.scratch.0.join("data/sizes.csv");
    let messages = ["cannot read `data/sizes.csv`", "`data/sizes.csv` is a folder"];
    goes_and_comes_back(&view, &path, SIZES, messages);
    view.scratch.file("data/sizes.csv", "x\n1\n7\n");
    view.until("other data", |state| {
        state["isCurrent"] == json!(true)
            && told(state, "end")["bounds"][0] == json!([7.0, 0.0, 0.0])
    });
}

#[test]
fn an_import_that_goes_and_comes_back_is_told() {
    let view = view("import-gone");
    let path = view.scratch.0.join("lib/part.geo");
    let messages = ["cannot read `lib/part.geo`", "`lib/part.geo` is a folder"];
    goes_and_comes_back(&view, &path, PART, messages);
    view.scratch.file("lib/part.geo", "let size = 4\n");
    view.until("another part", |state| {
        state["isCurrent"] == json!(true)
            && told(state, "ball")["bounds"][1] == json!([4.0, 4.0, 4.0])
    });
}

#[test]
fn a_script_whose_folder_goes_and_comes_back_is_told() {
    let scratch = Scratch::new("view-folder-gone");
    fs::create_dir(scratch.0.join("work")).expect("a folder");
    scratch.file("work/model.geo", "surface ball = sphere((0, 0), 2)\n");
    let view = View::of_file(scratch, "work/model.geo", &[]);
    let path = view.scratch.0.join("work/model.geo");
    let text = "surface ball = sphere((0, 0), 2)\n";
    goes_and_comes_back(&view, &path, text, ["cannot read", "is a folder, not a script"]);
}

#[cfg(unix)]
#[test]
fn a_pipe_in_the_place_of_a_file_is_told() {
    let view = view("pipe");
    let model = view.current();
    let path = view.scratch.0.join("data/sizes.csv");
    fs::remove_file(&path).expect("it goes");
    until_it_says(&view, &model, "cannot read `data/sizes.csv`");
    let made = std::process::Command::new("mkfifo").arg(&path).status();
    assert!(made.expect("a pipe").success());
    until_it_says(&view, &model, "is a pipe or a device");
}
