//! "Did you mean": the nearest of some words.

use crate::limits::work;

/// The word of `among` that is most likely meant by `word`, if one is near enough.
///
/// Optimal string alignment distance (a swap of neighbours counts once), upper and lower case
/// alike: one mistake in words of up to five letters, two in those of up to eight, three beyond; of two letters one must
/// be right as it is written, or both change places. Of equally near words the first is taken. In time O(letters) each.
pub fn nearest<'a>(word: &str, among: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower: Vec<char> = word.to_lowercase().chars().collect();
    let n_chars = word.chars().count();
    let most = match n_chars {
        // Any letter is one mistake from any other.
        0..=1 => 0,
        2..=5 => 1,
        6..=8 => 2,
        _ => 3,
    };
    among
        .into_iter()
        .filter_map(|candidate| {
            let n_of_candidate = candidate.chars().count();
            // The distance is at least the difference in length.
            if most < n_of_candidate.abs_diff(n_chars) {
                return None;
            }
            let letters: Vec<char> = candidate.to_lowercase().chars().collect();
            let distance = distance_within(&lower, &letters, most)?;
            // Of two letters one must be right as it is written: `zz` is no slip for `YZ`.
            let is_likely = || {
                let mut pairs = word.chars().zip(candidate.chars());
                n_of_candidate != 2
                    || pairs.any(|(a, b)| a == b)
                    || lower.iter().eq(letters.iter().rev())
            };
            if n_chars == 2 && 0 < distance && !is_likely() {
                return None;
            }
            (distance < n_of_candidate).then_some((distance, candidate))
        })
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// The optimal string alignment distance of two words, if it is no more than `most`: O(n · most).
///
/// Of the table only the band about the diagonal is filled: further away each entry is more than
/// `most`. Ukkonen, *Algorithms for approximate string matching*, Information and Control 64 (1985).
fn distance_within(a: &[char], b: &[char], most: usize) -> Option<usize> {
    if most < a.len().abs_diff(b.len()) {
        return None;
    }
    let beyond = most + 1;
    // The row, the one before it, and the one before that.
    let mut rows =
        [vec![beyond; b.len() + 1], vec![beyond; b.len() + 1], vec![beyond; b.len() + 1]];
    for (j, entry) in rows[1].iter_mut().enumerate().take(beyond) {
        *entry = j;
    }
    for i in 1..=a.len() {
        work::count(1);
        let [row, last, before] = &mut rows;
        let (first, end) = (i.saturating_sub(most).max(1), (i + most).min(b.len()));
        row[first - 1] = if first == 1 { i.min(beyond) } else { beyond };
        for j in first..=end {
            let is_same = a[i - 1] == b[j - 1];
            let above = if j < i + most { last[j] } else { beyond };
            let mut least =
                (last[j - 1] + usize::from(!is_same)).min(row[j - 1] + 1).min(above + 1);
            if 1 < i && 1 < j && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(before[j - 2] + 1);
            }
            row[j] = least.min(beyond);
        }
        rows.rotate_right(1);
    }
    rows[1].last().copied().filter(|&distance| distance <= most)
}

#[cfg(test)]
mod tests {
    use super::{distance_within, nearest};

    /// The whole table, as the definition says.
    fn distance(a: &[char], b: &[char]) -> usize {
        let mut table = vec![vec![0; b.len() + 1]; a.len() + 1];
        for i in 0..=a.len() {
            for j in 0..=b.len() {
                table[i][j] = if i == 0 || j == 0 {
                    i + j
                } else {
                    let change = table[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                    let mut least = change.min(table[i - 1][j] + 1).min(table[i][j - 1] + 1);
                    if 1 < i && 1 < j && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                        least = least.min(table[i - 2][j - 2] + 1);
                    }
                    least
                };
            }
        }
        table[a.len()][b.len()]
    }

    #[test]
    fn the_band_tells_what_the_whole_table_tells() {
        let word = |mut seed: usize, n: usize| -> Vec<char> {
            let letter = |_| {
                seed = (seed * 1_103_515_245 + 12_345) % (1 << 31);
                char::from(b'a' + (seed >> 16) as u8 % 3)
            };
            (0..n).map(letter).collect()
        };
        for seed in 0..2000 {
            let (a, b) = (word(seed, seed % 9), word(seed + 7, seed / 9 % 9));
            for most in 1..=3 {
                let expected = Some(distance(&a, &b)).filter(|&distance| distance <= most);
                assert_eq!(distance_within(&a, &b, most), expected, "{a:?} {b:?} {most}");
            }
        }
    }

    #[test]
    fn a_swap_is_one_mistake() {
        assert_eq!(nearest("bezeir", ["line", "bezier", "nurbs"]), Some("bezier"));
    }

    #[test]
    fn a_stranger_has_no_neighbour() {
        assert_eq!(nearest("qqq", ["line", "bezier"]), None);
        assert_eq!(nearest("ab", ["x", "cd"]), None);
        assert_eq!(nearest("x", ["XY", "y"]), None);
        assert_eq!(nearest("math", ["map"]), None);
        assert_eq!(nearest("region", ["refine"]), None);
        assert_eq!(nearest("xy", ["XY"]), Some("XY"));
    }
}
