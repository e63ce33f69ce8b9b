//! "Did you mean": the nearest of some words.

/// The word of `among` that is most likely meant by `word`, if one is near enough.
///
/// Optimal string alignment distance (a swap of neighbours counts once), upper and lower case
/// alike: one mistake in words of up to two letters, two up to five, three beyond. Of equally
/// near words the first is taken.
pub fn nearest<'a>(word: &str, among: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    let n_chars = word.chars().count();
    let most = match n_chars {
        0..=2 => 1,
        3..=5 => 2,
        _ => 3,
    };
    among
        .into_iter()
        // The distance is at least the difference in length.
        .filter(|candidate| candidate.chars().count().abs_diff(n_chars) <= most)
        .map(|candidate| (strsim::osa_distance(&lower, &candidate.to_lowercase()), candidate))
        .filter(|&(distance, candidate)| distance <= most && distance < candidate.chars().count())
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_swap_is_one_mistake() {
        assert_eq!(nearest("bezeir", ["line", "bezier", "nurbs"]), Some("bezier"));
    }

    #[test]
    fn a_stranger_has_no_neighbour() {
        assert_eq!(nearest("qqq", ["line", "bezier"]), None);
        assert_eq!(nearest("ab", ["x", "cd"]), None);
    }
}
