//! Sorting by a comparison or a key, with one sort for all that is sorted.
//!
//! `slice::sort_by` is built anew for every closure, some two thousand instructions each time. Here the places of
//! items are sorted, through a pointer, and the items moved there by exchanges.

use std::cmp::Ordering;

/// Sorts by a comparison; items that it calls equal keep their order.
///
/// ```
/// use virote_kernel::sorting::sort_by;
///
/// let mut ends = [(2.0_f64, "b"), (-1.0, "c"), (2.0, "a")];
/// sort_by(&mut ends, |a, b| a.0.total_cmp(&b.0));
/// assert_eq!(ends.map(|(_, name)| name), ["c", "b", "a"]);
/// ```
pub fn sort_by<T>(items: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    if 1 < items.len() {
        let places = sorted_places(items.len(), &|a, b| compare(&items[a], &items[b]));
        move_from(items, places);
    }
}

/// Sorts by a key; items of equal keys keep their order.
///
/// ```
/// use virote_kernel::sorting::sort_by_key;
///
/// let mut names = ["knots", "arc", "weights"];
/// sort_by_key(&mut names, |name| name.len());
/// assert_eq!(names, ["arc", "knots", "weights"]);
/// ```
pub fn sort_by_key<T, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    sort_by(items, |a, b| key(a).cmp(&key(b)));
}

/// The numbers below `n` in order.
fn sorted_places(n: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut places: Vec<usize> = (0..n).collect();
    places.sort_by(|&a, &b| compare(a, b));
    places
}

/// Moves the items so that each place holds what stood where `places` tells for it: round by round of those that
/// follow one another.
fn move_from<T>(items: &mut [T], mut places: Vec<usize>) {
    for start in 0..items.len() {
        let mut to = start;
        loop {
            let from = std::mem::replace(&mut places[to], to);
            if from == start {
                break;
            }
            items.swap(to, from);
            to = from;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_order_is_reached_and_equal_items_keep_theirs() {
        for n in 0..40_u64 {
            for seed in 0..20_u64 {
                let mixed = |i: u64| (i * 7919 + seed * 104_729) % 13;
                let mut items: Vec<(u64, u64)> = (0..n).map(|i| (mixed(i), i)).collect();
                let mut expected = items.clone();
                expected.sort_by_key(|item| item.0);
                sort_by_key(&mut items, |item| item.0);
                assert_eq!(items, expected);
            }
        }
    }
}
