//! Regions, faces, cuts and sections with closed forms, turned and moved at random, in three sizes, by `virote study`.

use std::fs;

use serde_json::Value as Json;

use crate::support::{Scratch, told, virote};

const CASES: &str = include_str!("../placements/cases.geo");
/// How far a measure may be from its closed form, as a share of it.
const BAR: f64 = 1e-9;

/// Numbers between -1 and 1, the same each time.
fn numbers() -> impl Iterator<Item = f64> {
    let mut state = 7_u64;
    std::iter::from_fn(move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        Some((state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
    })
}

/// `VIROTE_ORIENTATIONS` says how many placements are tried.
#[test]
fn measures_are_their_closed_forms_wherever_they_are_taken() {
    let n: usize = std::env::var("VIROTE_ORIENTATIONS").map_or(1, |n| n.parse().expect("a number"));
    let mut numbers = numbers();
    let mut next = |reach: f64| reach * numbers.next().expect("there is always another");
    let placements: Vec<[f64; 7]> =
        (0..n).map(|_| [180.0, 1.0, 1.0, 1.0, 3.0, 3.0, 3.0].map(&mut next)).collect();
    for size in [1.0, 1e-3, 1e3] {
        let scratch = Scratch::new(&format!("placements-{size}"));
        let tolerance = format!("tolerance {}", 1e-6 * size);
        assert!(CASES.contains("\ntolerance 1e-6\n"));
        scratch.file("cases.geo", CASES.replace("tolerance 1e-6", &tolerance));
        let rows = placements.iter().map(|row| row.map(|x| format!("{x},")).concat());
        let rows: String = rows.map(|row| format!("{row}{size}\n")).collect();
        scratch.file("plan.csv", format!("turn [deg],ax,ay,az,sx,sy,sz,size\n{rows}"));
        let study = ["study", "cases.geo", "plan.csv", "-o", "r.jsonl"];
        let output = virote(&scratch.0).args(study).output().expect("the command runs");
        let (_, err, code) = told(&output);
        assert_eq!((err.as_str(), code), ("", 0));
        let results = fs::read_to_string(scratch.0.join("r.jsonl")).expect("results");
        assert_eq!(results.lines().count(), n);
        for line in results.lines() {
            let row: Json = serde_json::from_str(line).expect("a row");
            assert!(row["code"].is_null(), "{line}");
            let is_case = |name: &str| name.contains('_');
            let found = row.as_object().expect("a record").iter().filter(|(name, _)| is_case(name));
            let mut n_cases = 0;
            for (name, off) in found {
                n_cases += 1;
                let off = off.as_f64().unwrap_or(f64::NAN);
                assert!(off.abs() <= BAR, "{name} is {off} off: {line}");
            }
            assert!(58 <= n_cases, "{n_cases}");
        }
    }
}
