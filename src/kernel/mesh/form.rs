//! Limits of the cells that a mesh divides the parameters into.

/// The boxes of parameters that a triangle may have: those of widths a along u and b along v with
/// `uu·a² + 2·uv·ab + vv·b² ≤ 1`. No coefficient is negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ParameterBoxes {
    pub(super) uu: f64,
    pub(super) uv: f64,
    pub(super) vv: f64,
}

/// How much of the room that a twist leaves goes to making cells as long as wide, where nothing
/// else decides it.
const ROUNDNESS: f64 = 0.1;

impl ParameterBoxes {
    /// The limit that allows everything.
    pub(super) const NONE: Self = Self { uu: 0.0, uv: 0.0, vv: 0.0 };

    pub(super) fn new([uu, uv, vv]: [f64; 3]) -> Self {
        Self { uu, uv, vv }
    }

    pub(super) fn scaled(self, factor: f64) -> Self {
        Self { uu: factor * self.uu, uv: factor * self.uv, vv: factor * self.vv }
    }

    /// What both together use up.
    pub(super) fn and(self, other: Self) -> Self {
        Self { uu: self.uu + other.uu, uv: self.uv + other.uv, vv: self.vv + other.vv }
    }

    /// The limit over a place where this one holds and one where the other does.
    pub(super) fn joined(self, other: Self) -> Self {
        Self { uu: self.uu.max(other.uu), uv: self.uv.max(other.uv), vv: self.vv.max(other.vv) }
    }

    /// Whether the other limit leaves no room that this one does not.
    pub(super) fn is_within(self, other: Self) -> bool {
        self.uu <= other.uu && self.uv <= other.uv && self.vv <= other.vv
    }

    /// What of the limit a box uses up; no less for larger coefficients, rounding included.
    pub(super) fn share(self, [a, b]: [f64; 2]) -> f64 {
        self.uu * a * a + 2.0 * self.uv * a * b + self.vv * b * b
    }

    /// What a box uses up at most if the limit is one that each place may have another of: all of
    /// them are kept where this is no more than 1 for each.
    ///
    /// By widths the limit is a matrix, of which the larger eigenvalue bounds what bends in any
    /// direction; the squares of the distances from a place of a triangle to its corners are in
    /// the mean no more than a quarter of that of the box's diagonal.
    pub(super) fn round_share(self, [a, b]: [f64; 2]) -> f64 {
        let (uu, uv, vv) = (self.uu * a * a, self.uv * a * b, self.vv * b * b);
        let (sum, difference) = (uu + vv, uu - vv);
        sum + (difference * difference + 4.0 * uv * uv).sqrt()
    }

    /// The same with u and v exchanged.
    pub(super) fn swapped(self) -> Self {
        Self { uu: self.vv, vv: self.uu, ..self }
    }

    /// The largest a for a given b; nothing where b alone is too much.
    pub(super) fn widest(self, b: f64) -> f64 {
        if self == Self::NONE {
            return f64::INFINITY;
        }
        let left = 1.0 - self.vv * b * b;
        if left <= 0.0 {
            return 0.0;
        }
        let twist = self.uv * b;
        left / (twist + (twist * twist + self.uu * left).sqrt())
    }

    /// The widths of the largest box: along both directions it bends alike. `ratio` is how many
    /// times longer a step along u is than one along v.
    pub(super) fn largest(self, ratio: f64) -> [f64; 2] {
        if self == Self::NONE {
            return [f64::INFINITY; 2];
        }
        if !(self.uu + self.uv + self.vv).is_finite() {
            return [0.0; 2];
        }
        let round = ROUNDNESS * self.uv;
        let (uu, vv) = (self.uu.max(round * ratio), self.vv.max(round / ratio));
        let part = |of: f64, whole: f64| if 0.0 < whole { of / whole } else { 0.0 };
        let sum =
            part(self.uu, uu) + part(self.vv, vv) + 2.0 * part(self.uv, uu.sqrt() * vv.sqrt());
        [uu, vv].map(|bend| 1.0 / (bend * sum).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::ParameterBoxes;

    #[track_caller]
    fn check(form: ParameterBoxes, ratio: f64) {
        let [a, b] = form.largest(ratio);
        assert!((form.share([a, b]) - 1.0).abs() < 1e-12, "{a} × {b}");
        assert!((form.widest(b) / a - 1.0).abs() < 1e-9, "{a} × {b}");
        assert!((form.swapped().widest(a) / b - 1.0).abs() < 1e-9, "{a} × {b}");
    }

    #[test]
    fn the_largest_box_uses_the_limit_up() {
        check(ParameterBoxes { uu: 3.0, uv: 1.0, vv: 2.0 }, 1.0);
        check(ParameterBoxes { uu: 0.0, uv: 4.0, vv: 0.0 }, 7.0);
        check(ParameterBoxes { uu: 5.0, uv: 0.5, vv: 0.0 }, 0.1);
    }

    #[test]
    fn without_bends_a_box_has_no_limit() {
        assert!(ParameterBoxes::NONE.largest(1.0).into_iter().all(f64::is_infinite));
        assert!(ParameterBoxes::NONE.widest(1e9).is_infinite());
        let [a, b] = ParameterBoxes { uu: 4.0, uv: 0.0, vv: 0.0 }.largest(1.0);
        assert!((a - 0.5).abs() < 1e-15 && b.is_infinite());
    }
}
