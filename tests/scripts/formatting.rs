//! Formatting a part of a script: whatever the lines, nothing is lost and nothing comes twice.

use std::fs;

use virote::{
    ide::{applied, formatted_lines},
    session::Session,
};

use crate::support::{folder, programs};

/// Numbers that look random, the same in each run.
struct Dice(u64);

impl Dice {
    /// A number below `n`.
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % n as u64).expect("it is small")
    }
}

/// The script with some of its lines joined, and others far apart.
fn dressed(script: &str, dice: &mut Dice) -> String {
    let mut text = String::new();
    for line in script.lines() {
        text.push_str(line);
        text.push_str(match dice.below(6) {
            0 | 1 if !line.contains("//") => " ",
            0 if line.contains("//") => "\n\n\n",
            2 if !line.contains("//") && line.ends_with(')') => " ;",
            3 => "\n\n\n\n",
            _ => "\n",
        });
    }
    text
}

/// Spaces count as one: columns are those of the lines that are formatted together.
fn words(text: &str) -> Vec<Vec<&str>> {
    text.lines().map(|line| line.split_whitespace().collect()).collect()
}

#[track_caller]
fn check_lines(session: &Session, text: &str, whole: &str, lines: &std::ops::Range<usize>) {
    let part = applied(text, &formatted_lines(session, text, lines));
    let again = session.format("", part.as_bytes()).map_err(|_| ()).expect("it can still be read");
    assert_eq!(words(&again), words(whole), "lines {lines:?} of\n{text}\nare\n{part}");
}

#[test]
fn formatting_lines_and_then_the_whole_is_formatting_the_whole() {
    let session = Session::default();
    let mut dice = Dice(0x5EED);
    let mut n_tried = 0;
    for name in programs(&folder("examples")) {
        let script = fs::read_to_string(folder("examples").join(format!("{name}.geo")))
            .expect("it is there");
        for _ in 0..6 {
            let text = dressed(&script, &mut dice);
            let Ok(whole) = session.format("", text.as_bytes()) else { continue };
            n_tried += 1;
            let n_lines = text.lines().count() + 1;
            for _ in 0..8 {
                let start = dice.below(n_lines);
                check_lines(&session, &text, &whole, &(start..start + 1 + dice.below(4)));
            }
        }
    }
    assert!(60 < n_tried, "{n_tried}");
}

#[test]
fn every_range_of_a_crowded_script_keeps_all_of_it() {
    let session = Session::default();
    let text = "// a\n\n\n;geo 1 unit mm\nlet a=1 let b=2 let c=3\n\n\n\n/// d\nlet d=[1,\n2] // e\nlet e=1 ;let f=2 /* x */; let g=3 // y\n\
                fn h(x)={\nlet y=x let z=y\n\n\n// in\nz}\n;\n/* one\ntwo */ let k=1\n\n\ncheck a==1 \"a\"\n// end\n\n";
    let whole = session.format("", text.as_bytes()).map_err(|_| ()).expect("it can be read");
    let n_lines = text.lines().count() + 2;
    for start in 0..n_lines {
        for end in start + 1..=n_lines {
            check_lines(&session, text, &whole, &(start..end));
        }
    }
}
