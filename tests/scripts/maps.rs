//! Laws of the colours by which meshes show curvature.

use proptest::{prop_assert, proptest};
use virote::{
    session::{Event, Session},
    value::NoFiles,
};

proptest! {
    #[test]
    fn a_map_of_curvature_has_the_closed_form_of_a_torus(
        major in 2.0..5.0, minor in 0.2..1.5, kind in 0..5usize,
    ) {
        // By the distance ρ from the axis, with cos v = (ρ − R)/r.
        let (word, formula) = [
            ("gaussian", "k1*k2"), ("k1", "k1"), ("k2", "k2"), ("difference", "k2 - k1"),
            ("min_radius", "1/max(abs(k1), abs(k2))"),
        ][kind];
        let script = format!(
            "let major = {major}\nlet minor = {minor}\n\
             let map = curvature_map(torus((0, 0), major, minor), \"{word}\")\n\
             fn expected(p) = {{ let rho = hypot(p.x, p.y); let k1 = -1/minor; let k2 = -(rho - major)/minor/rho; {formula} }}\n\
             let vertices = map.mesh.vertices\nlet values = map.values\n\
             let wrong = max([for i in 0..<len(vertices): abs(values[i] - expected(vertices[i]))])\n\
             check len(values) == len(vertices)\n\
             check wrong < 1e-9\n\
             check map.min ~= min(values)\ncheck map.max ~= max(values)\n\
             check len(map.scale) == 9\n\
             check map.scale[0].value == map.min\ncheck map.scale[8].value == map.max\n"
        );
        let report = Session::default().run("law", script.as_bytes(), &NoFiles, &[]);
        let told: Vec<&String> = report.diagnostics.iter().map(|found| &found.message).collect();
        prop_assert!(told.is_empty(), "{told:?}");
        let checks = report.events.iter().filter(|event| matches!(event, Event::Checked(_)));
        prop_assert!(checks.count() == 7);
    }
}
