//! What kind of knots a vector has.

use super::KnotVector;
use crate::tolerance::KNOT_RELATIVE;

/// The kinds of knots that the field has names for; a vector can be of several.
///
/// ```
/// use virote_kernel::KnotVector;
///
/// assert!(KnotVector::bezier(3)?.class().is_bezier);
/// let even = KnotVector::uniform(2, 5)?.class();
/// assert!(even.is_uniform && !even.is_clamped);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KnotClass {
    /// Both ends of the domain stand degree + 1 times, so that the curve begins and ends at its
    /// outer control points. Also called open.
    pub is_clamped: bool,
    /// All spans of the domain are equally wide, and what is inside of it stands once.
    pub is_uniform: bool,
    /// The spans beyond the ends repeat those at the other end of the domain.
    pub is_periodic: bool,
    /// Clamped, and every inner knot stands degree times or more: each span has a Bézier polygon
    /// among the control points.
    pub is_bezier: bool,
}

impl KnotClass {
    /// The one word that says most: `bezier`, `clamped`, `periodic`, or `unclamped`; before the last
    /// three `uniform` where it is.
    #[must_use]
    pub fn word(self) -> &'static str {
        match (self.is_bezier, self.is_clamped, self.is_periodic, self.is_uniform) {
            (true, ..) => "bezier",
            (_, true, _, true) => "uniform clamped",
            (_, true, _, false) => "clamped",
            (_, _, true, true) => "uniform periodic",
            (_, _, true, false) => "periodic",
            (.., true) => "uniform unclamped",
            _ => "unclamped",
        }
    }
}

impl KnotVector {
    /// The kinds of knots that it has.
    ///
    /// Piegl & Tiller, *The NURBS Book*, §2.2 and §12.2.
    #[must_use]
    pub fn class(&self) -> KnotClass {
        let (p, domain) = (self.degree, self.domain());
        let near = KNOT_RELATIVE * domain.length();
        let [start, end] = [domain.start(), domain.end()];
        let is_clamped = [start, end].iter().all(|&t| p < self.exact_multiplicity(t));
        let inside: Vec<f64> = self.knots[p..=self.n_points()].to_vec();
        let width = domain.length() / (inside.len() - 1) as f64;
        let is_uniform = inside.windows(2).all(|pair| (pair[1] - pair[0] - width).abs() <= near);
        let n_spans = inside.len() - 1;
        let repeats = |i: usize| {
            let turned = self.knots[i] + domain.length();
            (self.knots[i + n_spans] - turned).abs() <= near
        };
        let is_periodic = !is_clamped && (0..self.knots.len() - n_spans).all(repeats);
        let mut inner = self.distinct().into_iter();
        let is_bezier = is_clamped && inner.all(|(t, times)| t <= start || end <= t || p <= times);
        KnotClass { is_clamped, is_uniform, is_periodic, is_bezier }
    }
}
