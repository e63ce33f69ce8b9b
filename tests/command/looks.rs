//! How `virote render` looks at geometry: cameras, lines, what stands beside, compared with closed forms.

use std::fs;

use crate::{
    pictures::{drawn, run},
    support::{Scratch, files_below},
};

fn is_red([r, g, b]: [u8; 3]) -> bool {
    150 < r && g < 60 && b < 60
}

fn is_blue([r, g, b]: [u8; 3]) -> bool {
    150 < b && r < 60 && g < 60
}

fn is_dark(color: [u8; 3]) -> bool {
    color.iter().all(|level| *level < 100)
}

#[test]
fn in_perspective_what_is_half_as_far_is_twice_as_large() {
    // From ten above, the circle at half the way covers the other one of twice its radius.
    let script = "curve far = circle((0, 0, 0), 2) with (color = \"#0000ff\")\n\
                  curve near = circle((0, 0, 5), 1) with (color = \"#ff0000\")";
    let args = ["--size", "400x400", "--camera", "0,0,10", "--look-at", "0,0,0"];
    let from_afar = drawn("from-afar", script, &args);
    assert!(!from_afar.places(is_blue).is_empty() && !from_afar.places(is_red).is_empty());
    let near = drawn("perspective", script, &[&args[..], &["--perspective"]].concat());
    assert!(near.places(is_blue).is_empty());
    let widths = near.places(is_red).into_iter().map(|[x, _]| x);
    let (least, most) = (widths.clone().min().expect("red"), widths.max().expect("red"));
    // The margins are a twentieth.
    assert!(least.abs_diff(20) <= 1 && most.abs_diff(379) <= 1, "{least} {most}");
}

#[test]
fn a_drawing_in_perspective_is_exact() {
    let scratch = Scratch::new("perspective-svg");
    scratch.file(
        "a.geo",
        "curve c = line((-1, 0, 5), (1, 0, 5))\n\
         export c to \"a.svg\" with (camera = (0, 0, 10), look_at = (0, 0, 0), perspective = true, \
         decimals = 3)",
    );
    assert_eq!(run(&scratch, &["run", "a.geo", "-q"]), (String::new(), String::new(), 0));
    let text = fs::read_to_string(scratch.0.join("a.svg")).expect("a drawing");
    assert!(text.contains("d=\"M-2 0L2 0\"") || text.contains("d=\"M-2 0H2\""), "{text}");
}

#[test]
fn an_oblique_view_takes_its_angle_and_ratio() {
    let scratch = Scratch::new("oblique-svg");
    scratch.file(
        "a.geo",
        "curve c = line((0, 0, 0), (0, 2, 0))\n\
         export c to \"a.svg\" with (view = \"oblique\", oblique_angle = 30deg, oblique_ratio = 1, \
         decimals = 3)",
    );
    assert_eq!(run(&scratch, &["run", "a.geo", "-q"]), (String::new(), String::new(), 0));
    let text = fs::read_to_string(scratch.0.join("a.svg")).expect("a drawing");
    // Two units at 30°: √3 to the right and 1 upward, which is downward in the file.
    assert!(text.contains("M0 0L1.732 -1"), "{text}");
}

#[test]
fn the_outline_of_a_sphere_is_whole_also_where_its_seam_lies_on_it() {
    // Seen from the back the seam is on the left, where the sphere is lit and its outline stands out.
    let script = "surface s = sphere((0, 0), 1) with (color = \"red\")";
    for view in ["front", "back", "isometric"] {
        let args = ["--size", "800x800", "--view", view, "--no-isocurves"];
        let pixels = drawn("whole-outline", script, &args);
        for y in 60..400 {
            let end = (0..800).find(|&x| pixels.at(x, y) != [255; 3]).expect("the sphere");
            // Within the next pixels of the rim is the dark red of its outline.
            let is_line = |[red, green, _]: [u8; 3]| red < 150 && green < 60;
            assert!((0..4).any(|i| is_line(pixels.at(end + i, y))), "{view}: row {y}");
        }
    }
}

#[test]
fn edges_and_isocurves_can_be_left_out_or_counted() {
    let script = "surface s = plane_patch((0, 0), (1, 0), (0, 1)) with (color = \"red\")";
    // Of a flat square that faces the viewer all but the lines is pure red.
    let n_dark = |args: &[&str]| {
        let size = ["--size", "200x200", "--view", "top"];
        let pixels = drawn("lines-left-out", script, &[&size[..], args].concat());
        let row = (0..200).map(|x| pixels.at(x, 105)).collect::<Vec<_>>();
        let is_line = |color: &[u8; 3]| color[0] < 240;
        row.windows(2).filter(|pair| !is_line(&pair[0]) && is_line(&pair[1])).count()
    };
    assert_eq!(n_dark(&["--no-edges", "--no-isocurves"]), 0);
    assert_eq!(n_dark(&["--no-isocurves"]), 2);
    assert_eq!(n_dark(&["--no-edges", "--isocurves", "3"]), 3);
    assert_eq!(n_dark(&[]), 9);
}

#[test]
fn as_many_stripes_as_are_asked_for() {
    // A sphere mirrors each direction once: along its middle row all stripes pass, half of the one
    // behind at each end.
    let script = "surface s = sphere((0, 0), 1)";
    for n_stripes in ["4", "8"] {
        let args = ["--size", "600x600", "--view", "front", "--no-edges", "--no-isocurves"];
        let stripes = ["--show", "stripes", "--stripes", n_stripes];
        let pixels = drawn("stripes-counted", script, &[&args[..], &stripes].concat());
        let row: Vec<bool> = (33..567).map(|x| is_dark(pixels.at(x, 300))).collect();
        let n_changes = row.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert_eq!(n_changes.to_string(), n_stripes);
    }
    // With the light from the right a light stripe is mirrored halfway between it and the viewer.
    let args = ["--size", "600x600", "--view", "front", "--no-edges", "--no-isocurves"];
    let lit = ["--show", "stripes", "--stripes", "4", "--light", "1,-1,0"];
    let pixels = drawn("stripes-lit", script, &[&args[..], &lit].concat());
    // The normal toward the light itself mirrors the middle of the first stripe.
    let x = 300 + (270.0 * std::f64::consts::FRAC_1_SQRT_2) as usize;
    assert!(!is_dark(pixels.at(x, 300)) && is_dark(pixels.at(300, 300)));
}

#[test]
fn helpers_of_what_is_exported_are_not_drawn() {
    let script = "curve helper = line((0, 0), (1, 1)) with (color = \"#0000ff\")\n\
                  curve shown = line((0, 1), (1, 0)) with (color = \"#ff0000\")\n\
                  print length(helper)\n";
    let exported = format!("{script}export translate(shown, (0, 0, 1)) to \"a.svg\"\n");
    let table = format!("{script}export table({{x: [1]}}) to \"a.csv\"\n");
    let has_blue = |script: &str, args: &[&str]| {
        let scratch = Scratch::new("helpers");
        scratch.file("a.geo", script);
        let all = [&["render", "a.geo", "-o", "a.svg", "-q"], args].concat();
        assert_eq!(run(&scratch, &all).2, 0);
        let text = fs::read_to_string(scratch.0.join("a.svg")).expect("a drawing");
        assert!(text.contains("#ff0000"), "{text}");
        text.contains("#0000ff")
    };
    assert!(has_blue(script, &[]) && has_blue(&table, &[]));
    assert!(!has_blue(&exported, &[]) && has_blue(&exported, &["--all"]));
}

#[test]
fn a_scale_is_as_long_as_it_says() {
    let script = "curve c = line((0, 0), (87, 0))";
    let args = ["--size", "800x400", "--show", "scale"];
    let pixels = drawn("scale", script, &args);
    // 87 mm are nine tenths of the picture's width less twice a twentieth of its height.
    let per_unit = (800.0 - 0.1 * 374.0) / 87.0;
    let run = |y: usize| (6..800).take_while(|&x| pixels.at(x, y) == [0; 3]).count();
    let longest = (380..400).map(run).max().expect("rows");
    let expected = (20.0_f64 * per_unit).round();
    assert!((longest as f64 - 1.0 - expected).abs() <= 1.0, "{longest}, not {expected}");
}

#[test]
fn labels_axes_and_nets_are_in_the_drawing() {
    let script = "curve arch = bezier((0, 0), (1, 2, 1), (2, 0))";
    let scratch = Scratch::new("labels");
    scratch.file("a.geo", script);
    let args = ["render", "a.geo", "-o", "a.svg", "-q", "--show", "labels", "--show", "axes"];
    let net = ["--show", "control", "--control-color", "crimson", "--control-size", "2"];
    let all = [&args[..], &net, &["--show", "scale"]].concat();
    assert_eq!(run(&scratch, &all), (String::new(), String::new(), 0));
    let text = fs::read_to_string(scratch.0.join("a.svg")).expect("a drawing");
    for part in [">arch</text>", ">x</text>", ">z</text>", "#dc143c", "class=\"scale\"", "0.5 mm<"]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn points_of_a_net_are_as_large_as_is_asked_for() {
    let script = "curve arch = bezier((0, 0), (1, 2), (2, 0))";
    let n_red = |size: &str| {
        let args = ["--size", "200x200", "--view", "top", "--show", "control"];
        let net = ["--control-color", "red", "--control-size", size];
        let pixels = drawn("net-size", script, &[&args[..], &net].concat());
        let all = (0..200).flat_map(|y| (0..200).map(move |x| (x, y)));
        all.filter(|&(x, y)| is_red(pixels.at(x, y))).count()
    };
    assert!(3 * n_red("2") < n_red("8"), "{} {}", n_red("2"), n_red("8"));
}

#[test]
fn a_picture_of_many_pixels_holds_the_whole_line() {
    let script = "curve c = line((0, 0), (1, 1)) with (color = \"red\")";
    let pixels = drawn("many-pixels", script, &["--size", "4000x4000", "--view", "top"]);
    let is_drawn = |y: usize| (0..4000).any(|x| is_red(pixels.at(x, y)));
    assert!((500..3500).all(is_drawn));
    assert!(!is_drawn(10) && !is_drawn(3990));
}

#[test]
fn looks_that_cannot_be_are_refused_in_a_sentence() {
    let cases: &[(&[&str], &str)] = &[
        (&["--camera", "1,2"], "write X,Y,Z in the document's unit, for example 300,-400,250"),
        (&["--camera", "nan,0,0"], "write X,Y,Z"),
        (&["--camera", "0.5,0.5,0"], "the camera looks at the place where it stands"),
        (&["--camera", "0.6,0.6,0", "--perspective"], "too near to it; ("),
        (&["--look-at", "1,2,3", "--view", "top"], "needs a camera or perspective"),
        (&["--view", "oblique", "--perspective"], "an oblique view is parallel"),
        (&["--oblique-ratio", "1"], "go with the view `oblique`"),
        (&["--view", "oblique", "--oblique-ratio", "3"], "above 0 and at most 2"),
        (&["--view", "oblique", "--oblique-angle", "much"], "for example 30deg"),
        (&["--isocurves", "2.5"], "a whole number from 0 to 1000"),
        (&["--show", "stripes", "--stripes", "7"], "an even number from 2 to 1000"),
        (&["--stripes", "8"], "`--stripes` goes with `--show stripes`"),
        (&["--show", "stripes", "--light", "0,0,0"], "(0, 0, 0) gives none"),
        (&["--control-color", "red"], "`--control-color` goes with `--show control`"),
        (&["--show", "control", "--control-color", "reddish"], "a name of CSS"),
        (&["--show", "control", "--control-size", "0"], "a number above 0"),
        (&["--show", "scale", "--perspective"], "a scale holds in parallel views alone"),
        (&["--camera", "1,2,3", "--view", "top"], "cannot be used with"),
    ];
    let scratch = Scratch::new("wrong-looks");
    scratch.file("a.geo", "curve c = line((0, 0), (1, 1))");
    for (args, expected) in cases {
        let all = [&["render", "a.geo", "-o", "a.png"], *args].concat();
        let (_, told, code) = run(&scratch, &all);
        assert!(told.contains(expected) && code == 3, "{args:?}: {told} ({code})");
        assert!(!scratch.0.join("a.png").exists(), "{args:?}");
    }
}

#[test]
fn a_drawing_that_is_asked_for_two_views_is_refused_at_its_export() {
    for (options, expected) in [
        ("camera = (1, 2, 3), view = \"top\"", "two places to look from"),
        ("oblique_ratio = 1", "go with the view `oblique`"),
        ("perspective = true, camera = (0.6, 0.6, 0)", "in the same direction is far enough"),
    ] {
        let scratch = Scratch::new("two-views");
        let script =
            format!("curve c = line((0, 0), (1, 1))\nexport c to \"a.svg\" with ({options})");
        scratch.file("a.geo", &script);
        let (_, told, code) = run(&scratch, &["run", "a.geo"]);
        assert!(
            told.contains(expected) && told.contains("E0705") && code == 2,
            "{options}: {told}"
        );
        assert!(!scratch.0.join("a.svg").exists(), "{options}");
    }
}

#[test]
fn a_drawing_that_crosses_a_ceiling_names_it_and_writes_nothing() {
    let scratch = Scratch::new("drawing-ceiling");
    scratch.file("a.geo", "surface s = sphere((0, 0), 1)\n");
    let args = ["render", "a.geo", "-o", "a.svg", "--limit", "steps=200"];
    let (_, told, code) = run(&scratch, &args);
    assert!(told.contains("more than 200 steps; `--limit steps=N` moves"), "{told}");
    assert_eq!(code, 2);
    assert_eq!(files_below(&scratch.0), ["a.geo"]);
}
