//! Numbers that fall into sets which have none in common.

/// Sets of numbers below a bound, each known by the least of its numbers.
#[derive(Clone, Debug)]
pub(crate) struct DisjointSets {
    /// For each number one of its set that is no larger; for the least itself.
    lesser: Vec<usize>,
}

impl DisjointSets {
    /// So many sets of one number each.
    pub(crate) fn new(n: usize) -> Self {
        Self { lesser: (0..n).collect() }
    }

    /// The least number of a set.
    pub(crate) fn least(&mut self, mut number: usize) -> usize {
        while self.lesser[number] != number {
            self.lesser[number] = self.lesser[self.lesser[number]];
            number = self.lesser[number];
        }
        number
    }

    /// Makes the sets of two numbers one.
    pub(crate) fn unite(&mut self, one: usize, other: usize) {
        let (a, b) = (self.least(one), self.least(other));
        self.lesser[a.max(b)] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::DisjointSets;

    #[test]
    fn sets_are_known_by_their_least_number() {
        let mut sets = DisjointSets::new(6);
        for [a, b] in [[4, 5], [1, 3], [5, 3]] {
            sets.unite(a, b);
        }
        let least: Vec<usize> = (0..6).map(|number| sets.least(number)).collect();
        assert_eq!(least, [0, 1, 2, 1, 1, 1]);
    }
}
