//! Which conic section a rational curve of degree 2 is.

use glam::{DVec3, DVec4};

use crate::{
    FormError, GeomError, bezier,
    curve::NurbsCurve,
    homogeneous,
    tolerance::{EXACT_RELATIVE, VANISHING_RELATIVE},
};

/// The conic sections that are curved.
///
/// The weight in the middle decides: Piegl & Tiller, *The NURBS Book*, §7.3.
///
/// ```
/// use virote_kernel::{ConicKind, KnotVector, NurbsCurve, glam::DVec3};
///
/// let points = [DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0), DVec3::new(2.0, 0.0, 0.0)];
/// let kind = |w| NurbsCurve::rational(KnotVector::bezier(2)?, &points, &[1.0, w, 1.0])?.conic_kind();
/// assert_eq!(kind(0.5)?, ConicKind::Ellipse);
/// assert_eq!(kind(1.0)?, ConicKind::Parabola);
/// assert_eq!(kind(2.0)?, ConicKind::Hyperbola);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConicKind {
    /// An ellipse; circles are ellipses.
    Ellipse,
    /// A parabola.
    Parabola,
    /// A hyperbola.
    Hyperbola,
}

impl NurbsCurve {
    /// Which conic section all pieces of the curve are, by the shape factor w₁²/(w₀w₂).
    ///
    /// Piegl & Tiller, *The NURBS Book*, (7.22).
    ///
    /// # Errors
    /// [`FormError::DegreeTooHighFor`] above 2, `DegreeError::DegreeTooLow` below;
    /// [`FormError::NoConic`] where a piece is straight, [`FormError::MixedConics`].
    pub fn conic_kind(&self) -> Result<ConicKind, GeomError> {
        let degree = self.degree();
        if 2 < degree {
            return Err(FormError::DegreeTooHighFor { what: "a conic", degree, most: 2 }.into());
        }
        if degree < 2 {
            return Err(FormError::NoConic { parameter: self.domain().start() }.into());
        }
        let mut kinds = Vec::new();
        for span in self.knots.spans() {
            let piece = bezier::piece(&self.knots, &self.control_points, span);
            let parameter = self.knots.span_interval(span).start();
            kinds.push((
                parameter,
                kind_of(&piece).ok_or(GeomError::Form(FormError::NoConic { parameter }))?,
            ));
        }
        let (_, first) = kinds[0];
        match kinds.into_iter().find(|&(_, kind)| kind != first) {
            Some((parameter, _)) => Err(GeomError::Form(FormError::MixedConics { parameter })),
            None => Ok(first),
        }
    }
}

/// The kind of one Bézier piece; none for a straight one.
fn kind_of(piece: &[DVec4]) -> Option<ConicKind> {
    let [p0, p1, p2] = [piece[0], piece[1], piece[2]];
    let [a, b]: [DVec3; 2] = [p0, p2].map(homogeneous::project);
    // The middle point as it acts, with its weight: one of weight zero leaves a line.
    let (to_b, to_middle) = (b - a, p1.truncate() - a * p1.w);
    let area = to_b.cross(to_middle).length();
    if area
        <= VANISHING_RELATIVE * to_b.length() * (p1.truncate().length() + a.length() * p1.w.abs())
    {
        return None;
    }
    let (middle, ends) = (p1.w * p1.w, p0.w * p2.w);
    if (middle - ends).abs() <= EXACT_RELATIVE * ends {
        return Some(ConicKind::Parabola);
    }
    Some(if middle < ends { ConicKind::Ellipse } else { ConicKind::Hyperbola })
}
