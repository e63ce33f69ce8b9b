//! Splines through nodes that tell a curve's derivatives as well: Hermite interpolation.
//!
//! With derivatives up to order m at every node the spline has degree 2m + 1 and is C^m. Each
//! control point is the blossom of the Taylor polynomial of the node that its knots surround, so
//! that nothing is solved: with the differences δ of those knots from the node it is
//! Σ eₖ(δ)·(n − k)!/n!·C⁽ᵏ⁾, where eₖ is the k-th elementary symmetric polynomial. Ramshaw,
//! *Blossoms are polar forms* (1989).

use glam::DVec3;

use crate::{GeomError, KnotVector, curve::NurbsCurve, frame::norm};

/// A parameter with the derivatives of a curve there, by order.
#[derive(Clone, Debug)]
pub(in crate::curve) struct HermiteNode {
    pub(in crate::curve) parameter: f64,
    pub(in crate::curve) derivatives: Vec<DVec3>,
}

impl HermiteNode {
    /// The order m to which derivatives are known.
    pub(in crate::curve) fn order(&self) -> usize {
        self.derivatives.len() - 1
    }

    /// The same point with the derivatives of the chord to another node.
    pub(in crate::curve) fn towards(&self, other: &Self) -> Self {
        let mut derivatives = vec![DVec3::ZERO; self.derivatives.len()];
        let chord = other.derivatives[0] - self.derivatives[0];
        derivatives[0] = self.derivatives[0];
        derivatives[1] = chord / (other.parameter - self.parameter);
        Self { parameter: self.parameter, derivatives }
    }

    /// The largest difference of derivatives from another node's, as lengths over a width.
    pub(in crate::curve) fn jump(&self, other: &Self, width: f64) -> f64 {
        let mut power = 1.0;
        let mut largest: f64 = 0.0;
        for (k, (a, b)) in self.derivatives.iter().zip(&other.derivatives).enumerate().skip(1) {
            power *= width / k as f64;
            largest = largest.max(norm(*a - *b) * power);
        }
        largest
    }

    /// The control points that belong to the node, between the parameters of its neighbours.
    fn control_points(&self, previous: f64, next: f64) -> impl Iterator<Item = DVec3> {
        let order = self.order();
        let weights = blossom_weights(previous - self.parameter, next - self.parameter, order);
        weights.into_iter().map(|weights| {
            weights.iter().zip(&self.derivatives).map(|(&weight, &d)| d * weight).sum()
        })
    }
}

/// What the derivatives up to `order` at a node count in each of its control points, with the
/// differences of its neighbours' parameters from its own.
pub(crate) fn blossom_weights(before: f64, behind: f64, order: usize) -> Vec<Vec<f64>> {
    let degree = 2 * order + 1;
    let weights = |n_behind: usize| {
        let elementary = elementary_symmetric(before, order - n_behind, behind, n_behind);
        let mut falling = 1.0;
        let weight = |(k, e): (usize, f64)| {
            if 0 < k {
                falling *= (degree + 1 - k) as f64;
            }
            e / falling
        };
        elementary.into_iter().enumerate().map(weight).collect()
    };
    (0..=order).map(weights).collect()
}

/// The elementary symmetric polynomials of `p` times a and `q` times b, by degree: the
/// coefficients of (1 + ax)ᵖ(1 + bx)^q.
fn elementary_symmetric(a: f64, p: usize, b: f64, q: usize) -> Vec<f64> {
    let mut product = vec![1.0];
    for root in std::iter::repeat_n(a, p).chain(std::iter::repeat_n(b, q)) {
        product.push(0.0);
        for k in (1..product.len()).rev() {
            product[k] += root * product[k - 1];
        }
    }
    product
}

/// The control points of the one Bézier piece between two nodes.
pub(in crate::curve) fn piece(start: &HermiteNode, end: &HermiteNode) -> Vec<DVec3> {
    let (a, b) = (start.parameter, end.parameter);
    start.control_points(a, b).chain(end.control_points(a, b)).collect()
}

/// The point of a Bézier piece at a fraction of it.
pub(in crate::curve) fn point_of(piece: &[DVec3], fraction: f64) -> DVec3 {
    let mut row = piece.to_vec();
    for n_left in (1..row.len()).rev() {
        for i in 0..n_left {
            row[i] = row[i].lerp(row[i + 1], fraction);
        }
    }
    row[0]
}

/// The spline through stretches of nodes, all of one order; each stretch has two or more and
/// begins at the parameter where the one before ends, where the spline is only continuous. Points
/// that differ there meet halfway.
///
/// # Errors
/// `KnotError::TooFewKnots` for no stretch, `KnotError::KnotMultiplicity` where nodes count as
/// one parameter, `InputError::NotFinite`.
pub(in crate::curve) fn spline(stretches: &[Vec<HermiteNode>]) -> Result<NurbsCurve, GeomError> {
    let order = stretches.iter().flatten().map(HermiteNode::order).next().unwrap_or(0);
    let degree = 2 * order + 1;
    let (mut knots, mut points) = (Vec::new(), Vec::<DVec3>::new());
    for stretch in stretches {
        let last = stretch.len() - 1;
        for (i, node) in stretch.iter().enumerate() {
            let times = if i == 0 || i == last { degree } else { order + 1 };
            // A break between stretches is told by the one before it.
            if 0 < i || knots.is_empty() {
                knots.extend(std::iter::repeat_n(node.parameter, times));
            }
            let previous = stretch[i.saturating_sub(1)].parameter;
            let next = stretch[(i + 1).min(last)].parameter;
            let mut own = node.control_points(previous, next);
            if let (0, Some(joint)) = (i, points.last_mut()) {
                *joint = joint.midpoint(own.next().unwrap_or(*joint));
            }
            points.extend(own);
        }
    }
    let ends = knots.first().copied().zip(knots.last().copied());
    if let Some((start, end)) = ends {
        knots.insert(0, start);
        knots.push(end);
    }
    NurbsCurve::polynomial(KnotVector::new(degree, knots)?, &points)
}

/// How far apart the ends of two stretches are where they should meet.
pub(in crate::curve) fn gap(before: &[HermiteNode], behind: &[HermiteNode]) -> f64 {
    match (before.last(), behind.first()) {
        (Some(a), Some(b)) => norm(a.derivatives[0] - b.derivatives[0]),
        _ => 0.0,
    }
}
