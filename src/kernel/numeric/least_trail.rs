//! How a function fell on the way of a search that went far away.

use crate::tolerance::FAR_SHRINKAGE;

/// By how many times farther away the value is kept again.
const FARTHER: f64 = 2.0;

/// Values on the way of a search, each with the logarithm of how many times the unknowns' sizes away it was.
#[derive(Default)]
pub(super) struct LeastTrail {
    legs: Vec<[f64; 2]>,
}

impl LeastTrail {
    /// Keeps the value so far away, if that is clearly farther than before.
    pub(super) fn keep(&mut self, distance: f64, value: f64) {
        let far = libm::log(distance.max(1.0));
        if self.legs.last().is_none_or(|[last, _]| last + libm::log(FARTHER) <= far) {
            self.legs.push([far, value]);
        }
    }

    /// Whether the function fell by less over the last third of the way than over the second, all measured by powers of
    /// the distance.
    pub(super) fn falls_ever_less(&self) -> bool {
        let [Some([from, _]), Some([to, _])] = [self.legs.first(), self.legs.last()] else {
            return false;
        };
        let [second, third, end] =
            [1.0, 2.0, 3.0].map(|share| self.value_at(from + (to - from) * share / 3.0));
        third - end < FAR_SHRINKAGE * (second - third)
    }

    /// The value between those that were kept.
    fn value_at(&self, far: f64) -> f64 {
        let leg = self.legs.windows(2).find(|pair| far <= pair[1][0]);
        let last = self.legs.last().map_or(f64::NAN, |[_, value]| *value);
        leg.map_or(last, |pair| {
            let [[from, before], [to, behind]] = [pair[0], pair[1]];
            before + (behind - before) * (far - from) / (to - from)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::LeastTrail;

    #[test]
    fn what_tends_to_a_value_falls_ever_less() {
        let falls_less = |function: fn(f64) -> f64| {
            let mut trail = LeastTrail::default();
            (0..20).for_each(|k| {
                let distance = libm::pow(3.0, f64::from(k));
                trail.keep(distance, function(distance));
            });
            trail.falls_ever_less()
        };
        for function in [|x: f64| 1.0 / x, |x| -libm::atan(x), |x| 1.0 / libm::log(x + 2.0)] {
            assert!(falls_less(function));
        }
        for function in [|x: f64| -x, |x: f64| -x.sqrt(), |x| -libm::log(x), |x| 1e6 - x * x] {
            assert!(!falls_less(function));
        }
    }

    #[test]
    fn a_way_of_one_step_tells_nothing() {
        let mut trail = LeastTrail::default();
        assert!(!trail.falls_ever_less());
        trail.keep(1e9, -1e9);
        assert!(!trail.falls_ever_less());
    }
}
