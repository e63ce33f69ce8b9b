//! Things that come again and again, each kept once, in the order in which they came first.

use std::{borrow::Borrow, collections::HashMap, hash::Hash};

/// Values by their keys. The order is that of the first coming, so that it does not depend on hashes.
pub(super) struct UniqueValues<K, V> {
    places: HashMap<K, usize>,
    pairs: Vec<(K, V)>,
}

impl<K, V> Default for UniqueValues<K, V> {
    fn default() -> Self {
        Self { places: HashMap::new(), pairs: Vec::new() }
    }
}

impl<K: Clone + Eq + Hash, V> UniqueValues<K, V> {
    /// The place of a key and its value, which `make` makes at the first time.
    pub(super) fn entry<Q: Eq + Hash + ToOwned<Owned = K> + ?Sized>(
        &mut self,
        key: &Q,
        make: impl FnOnce() -> V,
    ) -> (usize, &mut V)
    where
        K: Borrow<Q>,
    {
        let place = match self.places.get(key) {
            Some(&place) => place,
            None => {
                let place = self.pairs.len();
                self.places.insert(key.to_owned(), place);
                self.pairs.push((key.to_owned(), make()));
                place
            }
        };
        (place, &mut self.pairs[place].1)
    }

    /// The value of a key that has come.
    pub(super) fn get<Q: Eq + Hash + ?Sized>(&self, key: &Q) -> Option<&V>
    where
        K: Borrow<Q>,
    {
        self.places.get(key).map(|&place| &self.pairs[place].1)
    }

    /// Keys and values in their order.
    pub(super) fn pairs(&self) -> &[(K, V)] {
        &self.pairs
    }
}

#[cfg(test)]
mod tests {
    use super::UniqueValues;

    #[test]
    fn what_comes_again_is_where_it_was() {
        let mut kept: UniqueValues<String, Vec<usize>> = UniqueValues::default();
        for (i, name) in ["b", "a", "b", "c", "a"].into_iter().enumerate() {
            kept.entry(name, Vec::new).1.push(i);
        }
        let found: Vec<(&str, &[usize])> =
            kept.pairs().iter().map(|(name, its)| (name.as_str(), its.as_slice())).collect();
        assert_eq!(found, [("b", &[0, 2][..]), ("a", &[1, 4]), ("c", &[3])]);
        assert_eq!(kept.entry("c", Vec::new).0, 2);
    }
}
