//! `virote render`: pictures compared with closed forms pixel by pixel, and what it refuses.

use std::{env, fs, io::BufReader};

use virote::{
    diag::Severity,
    docs::{Illustration, illustrations},
    export::{Format, PICTURES},
    ops,
    session::{Extra, PictureContent, Session},
    value::{ExamplePicture, NoFiles, Type},
};

use crate::support::{Scratch, files_below, told, virote};

/// A picture as rows of red, green and blue.
pub(crate) struct Pixels {
    pub(crate) width: usize,
    pub(crate) height: usize,
    bytes: Vec<u8>,
}

impl Pixels {
    fn read(scratch: &Scratch, name: &str) -> Self {
        let file = fs::File::open(scratch.0.join(name)).expect("a picture");
        let mut reader = png::Decoder::new(BufReader::new(file)).read_info().expect("a PNG");
        let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
        let info = reader.next_frame(&mut bytes).expect("pixels");
        assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgb, png::BitDepth::Eight));
        Self { width: info.width as usize, height: info.height as usize, bytes }
    }

    pub(crate) fn at(&self, x: usize, y: usize) -> [u8; 3] {
        let place = 3 * (y * self.width + x);
        [self.bytes[place], self.bytes[place + 1], self.bytes[place + 2]]
    }

    /// The places whose pixels are so.
    pub(crate) fn places(&self, is_so: impl Fn([u8; 3]) -> bool) -> Vec<[usize; 2]> {
        let all = (0..self.height).flat_map(|y| (0..self.width).map(move |x| [x, y]));
        all.filter(|&[x, y]| is_so(self.at(x, y))).collect()
    }
}

const WHITE: [u8; 3] = [255; 3];
const RED: [u8; 3] = [255, 0, 0];
const BLUE: [u8; 3] = [0, 0, 255];

/// Runs the command in the folder; standard output, standard error, exit code.
pub(crate) fn run(scratch: &Scratch, args: &[&str]) -> (String, String, i32) {
    told(&virote(&scratch.0).args(args).output().expect("the command runs"))
}

/// The picture of a script, drawn with these arguments.
#[track_caller]
pub(crate) fn drawn(situation: &str, script: &str, args: &[&str]) -> Pixels {
    let scratch = Scratch::new(situation);
    scratch.file("a.geo", script);
    let all = [&["render", "a.geo", "-o", "a.png", "-q"], args].concat();
    assert_eq!(run(&scratch, &all), (String::new(), String::new(), 0));
    Pixels::read(&scratch, "a.png")
}

/// The picture of the reference that shows a call, as bytes of a PNG.
fn illustration(picture: &Illustration) -> Vec<u8> {
    let session = Session::default();
    let script = picture.script();
    let report = session.run(picture.op.name, script.as_bytes(), &NoFiles, &[]);
    assert_eq!(report.count(Severity::Error), 0, "{script}{:#?}", report.diagnostics);
    let is_one =
        |text: &str| text.starts_with(picture.op.name) && matches!(picture.op.returns, Type::Curve);
    let is_curve = matches!(picture.picture, ExamplePicture::Value(text) if is_one(text));
    let extras: &[Extra] = if is_curve { &[Extra::Control] } else { &[] };
    let scene = PictureContent { extras, ..PictureContent::new([320, 240]) };
    let format = Format::among(PICTURES, &picture.file).expect("a format");
    let job = session.picture(&report, &scene, format).expect("geometry");
    let mut bytes = Vec::new();
    (format.write)(&job, &mut bytes).expect("a picture");
    bytes
}

#[test]
fn the_pictures_of_the_reference_are_up_to_date() {
    let folder = crate::support::folder("docs").join("pictures");
    let pictures = illustrations(&ops::registry());
    assert!(100 < pictures.len(), "{}", pictures.len());
    let files: Vec<String> = pictures.iter().map(|picture| picture.file.clone()).collect();
    if env::var_os("VIROTE_BLESS").is_some() {
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder");
        for picture in &pictures {
            fs::write(folder.join(&picture.file), illustration(picture)).expect("a file");
        }
    }
    let mut expected = files.clone();
    expected.sort();
    assert_eq!(files_below(&folder), expected, "VIROTE_BLESS=1 draws them anew");
    for picture in &pictures {
        let found = fs::read(folder.join(&picture.file)).expect("a picture");
        assert!(found == illustration(picture), "{}: VIROTE_BLESS=1 draws it anew", picture.file);
    }
}

#[test]
fn a_red_square_fills_the_pixels_that_it_should() {
    let script = "surface s = plane_patch((0, 0), (1, 0), (0, 1)) with (color = \"red\")";
    let pixels = drawn("red-square", script, &["--size", "200x200"]);
    assert_eq!((pixels.width, pixels.height), (200, 200));
    // A margin of a twentieth; lines are half a pixel wide there.
    for y in 0..200 {
        for x in 0..200 {
            let (inside, outside) = (11..189, 9..191);
            let color = pixels.at(x, y);
            if inside.contains(&x) && inside.contains(&y) {
                assert!(color[1] == 0 && color[2] == 0 && 100 < color[0], "({x}, {y}): {color:?}");
            } else if !(outside.contains(&x) && outside.contains(&y)) {
                assert_eq!(color, WHITE, "({x}, {y})");
            }
        }
    }
    // What faces the viewer has its own colour between the lines, 22.5 pixels apart.
    for i in 0..8 {
        let between = 10 + (22.5 * (f64::from(i) + 0.5)) as usize;
        assert_eq!(pixels.at(between, between), RED);
    }
}

#[test]
fn the_silhouette_of_a_sphere_is_a_disc() {
    let script = "surface s = sphere((3, -2), 0.25) with (color = \"black\")";
    for view in ["top", "front", "right", "isometric"] {
        let pixels = drawn("sphere", script, &["--size", "300x200", "--view", view]);
        let dark = pixels.places(|color| color[0] < 128);
        // Half of a line's width lies outside: 0.001 of the diagonal of the picture.
        let radius = 90.0 + 0.001 * libm::hypot(300.0, 200.0);
        let area = std::f64::consts::PI * radius * radius;
        let off = (dark.len() as f64 - area).abs() / area;
        assert!(off < 0.005, "{view}: {} pixels, not {area}", dark.len());
        let farthest = dark.iter().map(|&[x, y]| libm::hypot(x as f64 - 149.5, y as f64 - 99.5));
        let farthest = farthest.fold(0.0, f64::max);
        assert!((farthest - radius).abs() < 1.0, "{view}: {farthest}");
    }
}

#[test]
fn nearer_covers_farther_in_whatever_order() {
    let low =
        "surface low = plane_patch((0, 0, 0), (2, 0, 0), (0, 2, 0)) with (color = \"blue\")\n";
    let high = |z: &str| {
        format!(
            "surface high = plane_patch((1, 0, {z}), (2, 0, 0), (0, 2, 0)) with (color = \"red\")\n"
        )
    };
    let orders = [("1", RED), ("-1", BLUE)];
    for (z, seen) in orders {
        for script in [low.to_owned() + &high(z), high(z) + low] {
            let pixels = drawn("covers", &script, &["--size", "320x220", "--view", "top"]);
            // Three units are as wide as 298 pixels; the squares overlap in the second.
            let unit = 298.0 / 3.0;
            let at =
                |x: f64, y: f64| pixels.at((11.0 + unit * x) as usize, (110.0 + unit * y) as usize);
            assert_eq!([at(0.4, 0.1), at(1.6, 0.1), at(2.6, 0.1)], [BLUE, seen, RED], "{z}");
        }
    }
}

#[test]
fn each_view_looks_from_its_side() {
    // A plate of 4 by 1 in the plane of x and z.
    let script = "surface s = plane_patch((0, 0, 0), (4, 0, 0), (0, 0, 1)) with (color = \"red\")";
    let pixels = drawn("views", script, &["--size", "200x200", "--view", "front"]);
    let shown = pixels.places(|color| color != WHITE);
    let is_inside = |&[x, y]: &[usize; 2]| (9..191).contains(&x) && (76..124).contains(&y);
    assert!(shown.iter().all(is_inside));
    assert!((180 * 45..183 * 48).contains(&shown.len()), "{}", shown.len());
    // From above, from below and from the sides it is a line.
    for view in ["top", "bottom", "right", "left"] {
        let n_long = 180;
        let pixels = drawn("views", script, &["--size", "200x200", "--view", view]);
        let shown = pixels.places(|color| color != WHITE);
        assert!((n_long..3 * n_long).contains(&shown.len()), "{view}: {}", shown.len());
    }
}

#[test]
fn a_flat_script_is_seen_from_above_and_any_other_at_a_slant() {
    let square = "curve c = polyline((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))\n";
    let flat = drawn("flat", square, &["--size", "100x100"]);
    assert_eq!(flat.bytes, drawn("flat", square, &["--size", "100x100", "--view", "top"]).bytes);
    let space = format!("{square}point p = (0, 0, 1)");
    let slant = drawn("slant", &space, &["--size", "100x100"]);
    let isometric = drawn("slant", &space, &["--size", "100x100", "--view", "isometric"]);
    assert_eq!(slant.bytes, isometric.bytes);
}

#[test]
fn views_from_opposite_sides_show_opposite_faces() {
    // Six plates around a box: each view shows the one that is nearest to it alone.
    let script =
        "surface t = plane_patch((0, 0, 5), (4, 0, 0), (0, 4, 0)) with (color = \"#ff0000\")
        surface b = plane_patch((0, 0, -1), (4, 0, 0), (0, 4, 0)) with (color = \"#0000ff\")
        surface r = plane_patch((5, 0, 0), (0, 4, 0), (0, 0, 4)) with (color = \"#00ff00\")
        surface l = plane_patch((-1, 0, 0), (0, 4, 0), (0, 0, 4)) with (color = \"#ffff00\")
        surface f = plane_patch((0, -1, 0), (4, 0, 0), (0, 0, 4)) with (color = \"#ff00ff\")
        surface k = plane_patch((0, 5, 0), (4, 0, 0), (0, 0, 4)) with (color = \"#00ffff\")";
    let sides = [
        ("top", RED),
        ("bottom", BLUE),
        ("right", [0, 255, 0]),
        ("left", [255, 255, 0]),
        ("front", [255, 0, 255]),
        ("back", [0, 255, 255]),
    ];
    for (view, nearest) in sides {
        let pixels = drawn("sides", script, &["--size", "200x200", "--view", view]);
        // Two of three pixels and more are between the lines.
        let inside = pixels.places(|color| color == nearest);
        assert!(4000 < inside.len(), "{view}: {}", inside.len());
        for (_, other) in sides.iter().filter(|(_, other)| *other != nearest) {
            assert!(pixels.places(|color| color == *other).is_empty(), "{view}: {other:?}");
        }
    }
}

#[test]
fn lines_behind_a_surface_are_not_seen() {
    let script = |z: &str| {
        format!(
            "surface s = plane_patch((0, 0, 0), (8, 0, 0), (0, 8, 0)) with (color = \"yellow\")
             curve c = line((0.5, 4.5, {z}), (7.5, 4.5, {z})) with (color = \"blue\")"
        )
    };
    let is_blue = |[red, _, blue]: [u8; 3]| red < 100 && 100 < blue;
    let n_blue = |z: &str| {
        let size = ["--size", "600x600", "--view", "top"];
        drawn("behind", &script(z), &size).places(is_blue).len()
    };
    // Above, and on the surface itself, each of its 472 columns shows it.
    for z in ["1", "0"] {
        assert!((450..1500).contains(&n_blue(z)), "{z}: {}", n_blue(z));
    }
    assert_eq!(n_blue("-1"), 0);
}

#[test]
fn surfaces_in_one_place_are_seen_as_the_first_of_them() {
    let script = "surface s = sphere((0, 0), 1) with (color = \"red\")
                  mesh m = tessellate(s, tolerance = 0.001) with (color = \"blue\")";
    let pixels = drawn("one-place", script, &["--size", "300x300"]);
    let n_blue = pixels.places(|[red, _, blue]| red < blue).len();
    let n_red = pixels.places(|[red, _, blue]| blue < red).len();
    assert!(100 * n_blue < n_red, "{n_blue} and {n_red}");
}

#[test]
fn vertices_give_their_colours_and_the_legend_explains_them() {
    // cos v / (4 + cos v): from −1/3 inside to 1/5 outside, and zero on the circles in between.
    let script = "let map = curvature_map(torus((0, 0), 4, 1), \"gaussian\")";
    let pixels = drawn("legend", script, &["--size", "500x300", "--view", "top"]);
    // The bar stands 110 pixels from the right: red above, white at zero, blue below.
    let column: Vec<[u8; 3]> = (0..300).map(|y| pixels.at(500 - 105, y)).collect();
    let is_strong = |color: &[u8; 3]| 100 < color[0].abs_diff(color[2]);
    let first = column.iter().position(is_strong).expect("a bar");
    let last = column.iter().rposition(is_strong).expect("a bar");
    let bar = &column[first..=last];
    assert!(180 < bar.len(), "{}", bar.len());
    for (end, most) in [(bar[0], [204, 26, 26]), (bar[bar.len() - 1], [26, 51, 204])] {
        assert!(end.iter().zip(most).all(|(level, most)| level.abs_diff(most) < 3), "{end:?}");
    }
    let white = bar.iter().position(|color| color.iter().all(|level| 245 < *level));
    let share = 1.0 - white.expect("zero has a colour") as f64 / bar.len() as f64;
    assert!((share - (1.0 / 3.0) / (1.0 / 3.0 + 1.0 / 5.0)).abs() < 0.02, "{share}");
    // Marks at the round values −0.3, −0.2, ... 0.2, and smooth letters beside them.
    let is_dark = |color: [u8; 3]| color.iter().all(|level| *level < 60);
    let marks: Vec<usize> = (0..300).filter(|&y| is_dark(pixels.at(500 - 110 + 17, y))).collect();
    let expected = [0.2, 0.1, 0.0, -0.1, -0.2, -0.3].map(|value| {
        let share = (value + 1.0 / 3.0) / (1.0 / 5.0 + 1.0 / 3.0);
        first as f64 + (1.0 - share) * bar.len() as f64
    });
    assert_eq!(marks.len(), expected.len(), "{marks:?}");
    for (mark, expected) in marks.iter().zip(expected) {
        assert!((*mark as f64 + 0.5 - expected).abs() < 3.0, "{mark} and {expected}");
    }
    let letters = (0..300).flat_map(|y| (500 - 85..500).map(move |x| [x, y]));
    let greys = letters.filter(|&[x, y]| (60..230).contains(&pixels.at(x, y)[0])).count();
    assert!(100 < greys, "{greys}");
    // The torus is red outside and blue inside.
    let [middle, edge] = [(500 - 110) / 2, 150];
    assert_eq!(pixels.at(middle, edge), WHITE, "the hole");
    let ring: Vec<[u8; 3]> = (0..middle).map(|x| pixels.at(x, edge)).collect();
    let first = ring.iter().position(|color| *color != WHITE).expect("the outside");
    let last = ring.iter().rposition(|color| *color != WHITE).expect("the inside");
    let [outside, inside] = [ring[first + 4], ring[last - 4]];
    assert!(outside[2] < outside[0] && inside[0] < inside[2], "{outside:?} {inside:?}");
}

#[test]
fn the_same_bytes_on_any_number_of_threads() {
    let scratch = Scratch::new("threads");
    scratch.file(
        "a.geo",
        "surfaces s = [for k in 0..5: sphere((k, 0, 0), 0.6)]\ncurve c = helix((0, 0), 1, 1, 3)\n\
         let map = curvature_map(torus((0, 3), 1, 0.3), \"mean\")",
    );
    for ending in ["png", "svg"] {
        let bytes = ["1", "2", "4"].map(|n_threads| {
            let out = format!("{n_threads}.{ending}");
            let args = ["render", "a.geo", "-o", &out, "-q", "--threads", n_threads];
            assert_eq!(run(&scratch, &args), (String::new(), String::new(), 0));
            fs::read(scratch.0.join(out)).expect("a picture")
        });
        assert!(bytes[0] == bytes[1] && bytes[1] == bytes[2], "{ending}");
    }
}

#[test]
fn a_drawing_has_the_size_the_colours_and_the_legend() {
    let scratch = Scratch::new("drawing");
    scratch.file(
        "a.geo",
        "curve c = line((0, 0), (1, 1)) with (color = \"#123456\")\nlet map = curvature_map(sphere((0, 0), 2), \"mean\")",
    );
    let (out, err, code) =
        run(&scratch, &["render", "a.geo", "-o", "sub/a.svg", "--size", "320x240"]);
    assert_eq!((err.as_str(), code), ("", 0));
    assert!(out.starts_with("wrote sub/a.svg: "), "{out}");
    let text = fs::read_to_string(scratch.0.join("sub/a.svg")).expect("a drawing");
    for part in [" width=\"320\" height=\"240\"", "stroke=\"#123456\"", ">map: mean</text>"] {
        assert!(text.contains(part), "{part}");
    }
}

#[test]
fn a_control_polygon_and_a_comb_stand_beside_the_curve() {
    // The middle control point is as high above the line of the others as the margin leaves.
    let script = "curve c = bezier((0, 0), (1, 2), (2, 0)) with (color = \"red\")";
    let size = ["--size", "400x400"];
    let shown = |what: &str| drawn("beside", script, &[&size[..], &["--show", what]].concat());
    let control = shown("control");
    // The triangle of the control points is 360 pixels wide and high, and grey.
    let grey = control.places(|[r, g, b]| r == g && g == b && r < 140);
    for corner in [[20, 380], [200, 20], [380, 380]] {
        let is_near = |&[x, y]: &[usize; 2]| x.abs_diff(corner[0]) + y.abs_diff(corner[1]) < 6;
        assert!(grey.iter().any(is_near), "{corner:?}");
    }
    // The parabola peaks at half the height of its middle point: half of the line's width, 0.57
    // pixels, covers each of the rows beside.
    assert!([199, 200].iter().all(|&y| control.at(200, y)[1] < 150));
    // Curvature is largest at the top, where the comb stands upright.
    let comb = shown("comb");
    let red = |pixels: &Pixels| pixels.places(|[_, green, _]| green < 128);
    let (comb, plain) = (red(&comb), red(&drawn("beside", script, &size)));
    let top = comb[0][1];
    let row: Vec<usize> = comb.iter().filter(|[_, y]| *y == top).map(|[x, _]| *x).collect();
    let middle = row.iter().sum::<usize>() as f64 / row.len() as f64;
    assert!((middle - 199.5).abs() < 2.0 && row.len() < 30, "{row:?}");
    assert!(2 * plain.len() < comb.len(), "{} and {}", plain.len(), comb.len());
}

#[test]
fn stripes_are_those_of_the_zebra() {
    // About the axis of a cylinder that is seen from the side, the normal at x = sin a mirrors the
    // direction 2a: 24 stripes are 15 degrees wide, and change at a = 3.75, 11.25, ... degrees.
    let script = "surface s = cylinder((0, 0, -1), 1, 2) with (color = \"red\")";
    let args = ["--size", "600x600", "--view", "front", "--show", "stripes"];
    let pixels = drawn("stripes", script, &args);
    let row = |x: f64| pixels.at((300.0 + 270.0 * x) as usize, 280);
    for k in 0..8 {
        let middle = libm::sin((7.5 * f64::from(k)).to_radians());
        let wanted: u8 = if k % 2 == 0 { 242 } else { 26 };
        for x in [middle, -middle] {
            // Beside the lines of the surface.
            let near = [row(x - 0.012)[0], row(x + 0.012)[0]];
            assert!(near.iter().any(|level| level.abs_diff(wanted) < 2), "{k}: {near:?}");
        }
    }
    let scratch = Scratch::new("stripes-svg");
    scratch.file("a.geo", script);
    for (name, more) in [("plain.svg", &[][..]), ("stripes.svg", &["--show", "stripes"])] {
        let all = [&["render", "a.geo", "-o", name, "-q", "--view", "front"], more].concat();
        assert_eq!(run(&scratch, &all), (String::new(), String::new(), 0));
    }
    let length = |name: &str| fs::metadata(scratch.0.join(name)).expect("a drawing").len();
    assert!(length("plain.svg") + 500 < length("stripes.svg"));
}

#[test]
fn only_what_is_named_is_drawn() {
    let script = "surface s = plane_patch((0, 0), (1, 0), (0, 1)) with (color = \"red\")
                  surface t = plane_patch((1, 0), (1, 0), (0, 1)) with (color = \"blue\", hidden = true)
                  let p = (3, 3)";
    let all = drawn("only", script, &["--size", "100x100"]);
    let t = drawn("only", script, &["--size", "100x100", "--only", "t"]);
    assert_eq!((all.at(16, 16), t.at(16, 16)), (RED, BLUE), "what is hidden is drawn by name");
    let p = drawn("only", script, &["--size", "100x100", "--only", "p"]);
    let dot = p.places(|color| color != WHITE);
    assert!((1..16).contains(&dot.len()) && dot.contains(&[50, 50]), "{dot:?}");
}

#[test]
fn what_cannot_be_drawn_is_said_and_nothing_is_written() {
    let scratch = Scratch::new("refused");
    scratch
        .file("a.geo", "curve arch = line((0, 0), (1, 1))\nlet n = 3\ntable t = table([{a: 1}])");
    scratch.file("none.geo", "let n = 3\nprint n");
    scratch.file("wrong.geo", "curve c = line((0, 0), (0, 0)) + 1\ncurve d = bezier(1)");
    let before = files_below(&scratch.0);
    let cases: &[(&[&str], &str, i32)] = &[
        (&["none.geo", "-o", "a.png"], "the script defines no geometry that could be drawn", 3),
        (&["a.geo", "-o", "a.jpg"], "a picture ends in `.png` or `.svg`, and `a.jpg` in `.jpg`", 3),
        (&["a.geo", "-o", "a"], "a picture ends in `.png` or `.svg`, and `a` in neither", 3),
        (
            &["a.geo", "-o", "a.png", "--view", "frint"],
            "there is no view `frint`; did you mean `front`?",
            3,
        ),
        (
            &["a.geo", "-o", "a.png", "--view", "7"],
            "views are top, front, right, bottom, back, left, isometric, oblique",
            3,
        ),
        (
            &["a.geo", "-o", "a.png", "--size", "0x5"],
            "a picture has at least one pixel on each side",
            3,
        ),
        (
            &["a.geo", "-o", "a.png", "--size", "5"],
            "write WIDTHxHEIGHT in pixels, for example 800x600",
            3,
        ),
        (&["a.geo", "-o", "a.png", "--size", "100000x100000"], "the ceiling is 33554432 pixels", 3),
        (&["a.geo", "-o", "a.png", "--size", "18446744073709551615x2"], "the ceiling is", 3),
        (
            &["a.geo", "-o", "a.png", "--only", "arhc"],
            "the script defines no `arhc`; did you mean `arch`?",
            3,
        ),
        (&["a.geo", "-o", "a.png", "--only", "n"], "`n` is the number 3, which cannot be drawn", 3),
        (&["a.geo", "-o", "a.png", "--only", "t"], "which cannot be drawn", 3),
        (&["a.geo", "-o", "a.png", "--set", "q=1"], "`q`", 3),
        (
            &["a.geo", "-o", "a.png", "--show", "combs"],
            "`combs` cannot be shown; did you mean `comb`?",
            3,
        ),
        (&["no.geo", "-o", "a.png"], "cannot read `no.geo`: there is no such file", 3),
        (&["wrong.geo", "-o", "a.png"], "the script defines no geometry that could be drawn", 2),
        (&["a.geo", "-o", "none.geo/a.png"], "`none.geo` is a file, not a folder", 3),
    ];
    for (args, message, code) in cases {
        let (out, err, ended) = run(&scratch, &[&["render"], *args].concat());
        assert!(err.contains(message), "{args:?}: {err}");
        assert_eq!((out.as_str(), ended), ("", *code), "{args:?}");
        assert_eq!(files_below(&scratch.0), before, "{args:?}");
    }
    let (_, err, _) = run(&scratch, &["render", "wrong.geo", "-o", "a.png"]);
    assert!(err.contains("wrong.geo:1:") && err.contains("wrong.geo:2:"), "each error: {err}");
}

#[test]
fn a_picture_keeps_the_old_one_if_the_new_one_cannot_be() {
    let scratch = Scratch::new("kept");
    scratch.file("a.png", "old");
    scratch.file("wrong.geo", "curve c = bezier(1)");
    assert_eq!(run(&scratch, &["render", "wrong.geo", "-o", "a.png", "-q"]).2, 2);
    assert_eq!(fs::read(scratch.0.join("a.png")).expect("a file"), b"old");
}

#[test]
fn boxes_without_size_and_beyond_all_bounds() {
    for ending in ["png", "svg"] {
        let scratch = Scratch::new("boxes");
        let out = format!("a.{ending}");
        let draw = |script: &str| {
            scratch.file("a.geo", script);
            run(&scratch, &["render", "a.geo", "-o", &out, "--size", "64x48", "-q"])
        };
        for small in [
            "point p = (1, 2, 3)",
            "curve c = line((1, 1), (1 + 1e-15, 1))",
            "curve c = line((0, 0), (1e-320, 0))",
            "curve c = line((0, 0), (5, 0))",
            "surface s = sphere((1e6, 0), 1e-6)",
        ] {
            assert_eq!(draw(small), (String::new(), String::new(), 0), "{small}");
        }
        for large in [
            "curve c = line((-1e308, 0), (1e308, 0))",
            "surface s = sphere((0, 0), 1e200)",
            "surface s = plane_patch((-1e308, 0), (1e308, 0), (0, 1e308))",
        ] {
            let (out, err, code) = draw(large);
            assert_eq!((out.as_str(), code), ("", 2), "{large}");
            assert_eq!(err, "virote: the geometry reaches farther than can be measured\n");
        }
    }
}

#[test]
fn a_failed_check_is_told_and_the_picture_drawn() {
    let scratch = Scratch::new("failed-check");
    scratch.file("a.geo", "curve c = line((0, 0), (1, 1))\ncheck length(c) ~= 1\nprint 1");
    let (out, err, code) = run(&scratch, &["render", "a.geo", "-o", "a.png"]);
    assert_eq!((out.as_str(), code), ("wrote a.png: 1 curve\n", 1));
    assert!(err.contains("check failed"), "{err}");
}

#[test]
fn what_cannot_be_drawn_is_told_at_its_place() {
    let scratch = Scratch::new("undrawable");
    let script = "surface s = parametric((u, v) => (u, v, abs(u - 1)), 0..2, 0..1)\n";
    scratch.file("a.geo", script);
    let (_, err, code) = run(&scratch, &["render", "a.geo", "-o", "a.png"]);
    assert_eq!(code, 2, "{err}");
    for part in ["[E0503]", "a.geo:1:41", "at u = 1", "asked from here"] {
        assert!(err.contains(part), "{part}: {err}");
    }
    assert!(!scratch.0.join("a.png").exists());
}

/// Bytes that were written as text. RFC 4648, §4.
fn from_base64(text: &str) -> Vec<u8> {
    let digit = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        other => unreachable!("no digit: {other}"),
    };
    let digits: Vec<u8> = text.trim_end_matches('=').bytes().map(digit).collect();
    let of_group = |group: &[u8]| {
        let bits = group.iter().fold(0_u32, |bits, &digit| bits << 6 | u32::from(digit));
        let bits = bits << (6 * (4 - group.len()));
        bits.to_be_bytes()[1..group.len()].to_vec()
    };
    digits.chunks(4).flat_map(of_group).collect()
}

#[test]
fn the_picture_in_a_report_is_the_one_that_is_rendered() {
    let scratch = Scratch::new("report-picture");
    let script = r#"
        surface dome = sphere((0, 0), 2) with (color = "red")
        curve helper = line((0, 0), (9, 9))
        export dome to "dome.stl"
        export report to "review.html" with (view = "front", isocurves = 2)
        export report to "review.md" with (view = "front", isocurves = 2)
    "#;
    scratch.file("a.geo", script);
    let render = [
        "render",
        "a.geo",
        "-o",
        "a.png",
        "-q",
        "--size",
        "1200x800",
        "--view",
        "front",
        "--isocurves",
        "2",
    ];
    assert_eq!(run(&scratch, &render), (String::new(), String::new(), 0));
    let (said, err, code) = run(&scratch, &["run", "a.geo"]);
    assert_eq!((code, err.as_str()), (0, ""), "{said}");
    let rendered = fs::read(scratch.0.join("a.png")).expect("a picture");
    for name in ["review.html", "review.md"] {
        let text = fs::read_to_string(scratch.0.join(name)).expect("a report");
        let (_, behind) = text.split_once("data:image/png;base64,").expect("a picture");
        let data = behind.split(['"', '\n']).next().expect("its end");
        assert!(from_base64(data) == rendered, "{name}");
    }
}
