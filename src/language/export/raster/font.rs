//! Letters as strokes: the Roman simplex of the Hershey fonts.
//!
//! The Hershey Fonts were originally created by Dr. A. V. Hershey while working at the U. S. National
//! Bureau of Standards; they are free to use and to pass on in any form but that of the National
//! Technical Information Service. The format of the data that `letters.txt` was made from was
//! originally created by James Hurt, Cognition, Inc. The signs ≤, ≥ and ≠ are ours.
//! Hershey, *Calligraphy for computers*, NWL Report 2101 (1967).

use glam::DVec2;

/// A line a letter: the letter, how far the next one is, and strokes as points, y upward from the
/// line that the letters stand on.
const LETTERS: &str = include_str!("letters.txt");
/// Height of capitals.
pub(super) const CAPITAL: f64 = 21.0;

/// The width of a line of text.
pub(super) fn width(text: &str) -> f64 {
    let of = |c: char| letter(c).or_else(|| letter('?')).map_or(0.0, |(width, _)| width);
    text.chars().map(of).sum()
}

/// The strokes of a line of text, leg by leg, as far as they are not wider than `most`.
///
/// A letter that the alphabet does not have is a question mark.
pub(super) fn legs(text: &str, most: f64) -> Vec<[DVec2; 2]> {
    let mut legs = Vec::new();
    let mut pen = 0.0;
    for c in text.chars() {
        let Some((width, strokes)) = letter(c).or_else(|| letter('?')) else { break };
        if most < pen + width {
            break;
        }
        let moved = |place: DVec2| place + DVec2::new(pen, 0.0);
        legs.extend(strokes.into_iter().map(|leg| leg.map(moved)));
        pen += width;
    }
    legs
}

/// How far the next letter is, and the legs of the strokes.
fn letter(c: char) -> Option<(f64, Vec<[DVec2; 2]>)> {
    let line = LETTERS.lines().find(|line| line.starts_with(c))?;
    let data = line[c.len_utf8()..].trim_start();
    let (width, strokes) = data.split_once(' ').unwrap_or((data, ""));
    let mut legs = Vec::new();
    for stroke in strokes.split('|') {
        let points: Vec<DVec2> = stroke.split_whitespace().filter_map(point).collect();
        legs.extend(points.windows(2).map(|leg| [leg[0], leg[1]]));
    }
    Some((width.parse().ok()?, legs))
}

fn point(text: &str) -> Option<DVec2> {
    let (x, y) = text.split_once(',')?;
    Some(DVec2::new(x.parse().ok()?, y.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::{CAPITAL, legs, letter};

    #[test]
    fn the_alphabet_has_all_that_legends_say() {
        for c in (' '..='~').chain("≤≥≠".chars()) {
            let (width, legs) = letter(c).unwrap();
            assert!(0.0 < width && (c == ' ') == legs.is_empty(), "{c}");
            for place in legs.into_iter().flatten() {
                assert!((0.0..=width).contains(&place.x), "{c}: {place}");
                assert!((-8.0..=CAPITAL + 4.0).contains(&place.y), "{c}: {place}");
            }
        }
    }

    #[test]
    fn digits_are_equally_wide() {
        assert!(('0'..='9').all(|digit| letter(digit).map(|(width, _)| width) == Some(20.0)));
    }

    #[test]
    fn a_line_ends_before_it_is_too_wide() {
        assert_eq!(legs("0000", 60.0), legs("000", 60.0));
        assert_eq!(legs("ß", 60.0), legs("?", 60.0));
    }
}
