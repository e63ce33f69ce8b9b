//! The same curve in another basis: fewer knots, Coons, Hermite; only where nothing is lost.

use glam::{DVec3, DVec4};

use crate::{
    FormError, GeomError, KnotVector, Side, bezier,
    curve::NurbsCurve,
    sorting::sort_by,
    tolerance::{EXACT_RELATIVE, KNOT_RELATIVE},
};

impl NurbsCurve {
    /// The curve of Bézier pieces over the intervals between breaks, with the multiplicity that
    /// each inner break is to have; where the pieces do not allow that, as many as they need.
    ///
    /// # Errors
    /// `DegreeError::DegreeTooHigh`, `InputError::NotFinite`, `WeightError::VanishingWeights`.
    pub(in crate::curve) fn of_pieces(
        breaks: &[f64],
        pieces: Vec<Vec<DVec4>>,
        multiplicities: &[usize],
    ) -> Result<Self, GeomError> {
        let degree = pieces.first().map_or(0, |piece| piece.len() - 1);
        let knots = |multiplicity: &dyn Fn(usize) -> usize| {
            let run = |(i, &t): (usize, &f64)| vec![t; multiplicity(i)];
            KnotVector::new(degree, breaks.iter().enumerate().flat_map(run).collect())
        };
        let chain = Self::new(knots(&|_| degree + 1)?, pieces.concat())?;
        let is_inner = |i: usize| 0 < i && i < breaks.len() - 1;
        let wanted = knots(&|i| {
            if is_inner(i) { multiplicities[i - 1].min(degree + 1) } else { degree + 1 }
        });
        Ok(chain.on_basis(wanted?).unwrap_or_else(|| chain.without_needless_knots()))
    }

    /// The same curve on other knots of the same degree over the same domain; none where the
    /// curve is not smooth enough for them.
    ///
    /// A control point is the blossom at p consecutive knots of any piece in its support.
    /// Ramshaw, *Blossoms are polar forms*, §6.
    pub(in crate::curve) fn on_basis(&self, knots: KnotVector) -> Option<Self> {
        let p = self.degree();
        let point = |i: usize| {
            let support = i.max(p)..=(i + p).min(knots.n_points() - 1);
            let is_wide = |span: &usize| knots.as_slice()[*span] < knots.as_slice()[span + 1];
            // Any piece has the same blossom; that of the middle rounds least.
            let span = support.filter(is_wide).min_by_key(|span| (2 * span).abs_diff(2 * i + p))?;
            let middle = knots.span_interval(span).at(0.5);
            let mut arguments = knots.as_slice()[i + 1..=i + p].to_vec();
            sort_by(&mut arguments, |a, b| (b - middle).abs().total_cmp(&(a - middle).abs()));
            let span = self.knots.span_at(middle);
            Some(bezier::blossom(&self.knots, &self.control_points, span, &arguments))
        };
        let points: Option<Vec<DVec4>> = (0..knots.n_points()).map(point).collect();
        let other = Self::new_unchecked(knots, points?);
        self.is_same(&other).then_some(other)
    }

    /// Whether both curves of one degree have the same homogeneous points, to rounding.
    fn is_same(&self, other: &Self) -> bool {
        let p = self.degree();
        let accuracy = self.rounding_of_points();
        self.knots.spans().all(|span| {
            let span = self.knots.span_interval(span);
            (0..=p).all(|k| {
                let t = span.at((k as f64 + 0.5) / (p + 1) as f64);
                let difference = self.homogeneous_at(t) - other.homogeneous_at(t);
                difference.abs().cmple(accuracy).all()
            })
        })
    }

    /// How far two homogeneous points of the curve may be apart that are the same.
    fn rounding_of_points(&self) -> DVec4 {
        let largest = self.control_points.iter().fold(DVec4::ZERO, |most, p| most.max(p.abs()));
        DVec3::splat(largest.truncate().max_element()).extend(largest.w) * EXACT_RELATIVE
    }

    /// The same curve, clamped, with every inner knot only as often as its smoothness there needs.
    #[must_use]
    pub fn without_needless_knots(&self) -> Self {
        let curve = self.clamped();
        let (p, domain) = (curve.degree(), curve.domain());
        let needed = |(t, times): (f64, usize)| {
            let is_inner = domain.start() < t && t < domain.end();
            vec![t; if is_inner { curve.multiplicity_needed(t, times) } else { times }]
        };
        let knots: Vec<f64> = curve.knots.distinct().into_iter().flat_map(needed).collect();
        if knots.len() == curve.knots.as_slice().len() {
            return curve;
        }
        let fewer = KnotVector::new(p, knots).ok().and_then(|knots| curve.on_basis(knots));
        fewer.unwrap_or(curve)
    }

    /// How often the inner knot `t`, which stands so many times, has to stand.
    fn multiplicity_needed(&self, t: f64, times: usize) -> usize {
        let p = self.degree();
        let spans = [Side::Left, Side::Right].map(|side| self.knots.span_beside(t, side));
        let widths = spans.map(|span| self.knots.span_interval(span).length());
        let [left, right] = spans.map(|span| self.homogeneous_derivatives(span, t, p));
        let (width, accuracy) = (widths[0].min(widths[1]), self.rounding_of_points());
        // The k-th derivative over one span is p!/(p − k)! times the k-th difference of points.
        let mut scale = 1.0;
        for k in 0..=p {
            let jump = (right[k] - left[k]).abs() * scale;
            if p < times + k && !jump.cmple(accuracy).all() {
                return p + 1 - k;
            }
            scale *= width / (p - k).max(1) as f64;
        }
        0
    }

    /// The same curve as a uniform cubic B-spline that is not clamped, on the same domain.
    ///
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, (2.51) and (2.53).
    ///
    /// # Errors
    /// [`FormError::RationalFor`], [`FormError::DegreeTooHighFor`], [`FormError::UnevenSegments`],
    /// [`FormError::TooRough`]: why that is not possible.
    pub fn to_coons(&self) -> Result<Self, GeomError> {
        let what = "a Coons B-spline";
        let (curve, n_segments) = self.cubic_chain(what, 2)?;
        let domain = curve.domain();
        let knot = |i: usize| domain.at((i as f64 - 3.0) / n_segments as f64);
        let knots = KnotVector::new(3, (0..n_segments + 7).map(knot).collect())?;
        curve.on_basis(knots).ok_or(GeomError::Form(FormError::TooRough {
            what,
            parameter: domain.start(),
            order: 1,
            needed: 2,
        }))
    }

    /// Points and derivatives at the joints of a cubic, one unit of parameter a segment: what
    /// [`Self::hermite`] makes the same curve of, up to a linear change of parameter.
    ///
    /// # Errors
    /// [`FormError::RationalFor`], [`FormError::DegreeTooHighFor`], [`FormError::UnevenSegments`],
    /// [`FormError::TooRough`]: why that is not possible.
    pub fn to_hermite(&self) -> Result<[Vec<DVec3>; 2], GeomError> {
        let (curve, n_segments) = self.cubic_chain("a Hermite chain", 1)?;
        let width = curve.domain().length() / n_segments as f64;
        let data = curve.knots.breaks().into_iter().map(|t| {
            let derivatives = curve.derivatives_at(t, 1);
            (derivatives[0], derivatives[1] * width)
        });
        let (points, tangents) = data.unzip();
        Ok([points, tangents])
    }

    /// The same curve as a clamped cubic of segments of one width that is C-`needed` at its
    /// joints, and the number of its segments.
    fn cubic_chain(&self, what: &'static str, needed: usize) -> Result<(Self, usize), GeomError> {
        if self.is_rational {
            return Err(FormError::RationalFor { what }.into());
        }
        let curve = self.without_needless_knots();
        let degree = curve.degree();
        if 3 < degree {
            return Err(FormError::DegreeTooHighFor { what, degree, most: 3 }.into());
        }
        let curve = curve.elevate_degree(3)?;
        let domain = curve.domain();
        for (t, times) in curve.knots.distinct() {
            if domain.start() < t && t < domain.end() && 3 < times + needed {
                // A break of the curve has no order.
                let order = 3 - times.min(3);
                return Err(FormError::TooRough { what, parameter: t, order, needed }.into());
            }
        }
        let widths: Vec<f64> =
            curve.knots.spans().map(|span| curve.knots.span_interval(span).length()).collect();
        let same = KNOT_RELATIVE * domain.length();
        if let Some(&other) = widths.iter().find(|&&width| same < (width - widths[0]).abs()) {
            return Err(FormError::UnevenSegments { what, width: widths[0], other }.into());
        }
        Ok((curve, widths.len()))
    }
}
