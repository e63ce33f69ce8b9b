//! How smoothly one piece of curve goes on in the next.

use glam::{DAffine3, DVec3, DVec4};

use crate::{
    GeomError, JointTolerance, Side,
    curve::{Curve, EvaluationPlace, LocalGeometry, evaluation::series},
    frame::{angle_between, norm},
    joint_tolerance::Agreement,
    scale::needed_scale,
    tolerance::{EXACT_RELATIVE, PLACE_RELATIVE},
};

/// The highest order that is compared.
const MAX_ORDER: usize = 3;

/// Where along its domain a function is asked for its size.
const PROBES: [f64; 4] = [0.0, 0.3, 0.7, 1.0];

/// How two pieces of curve meet; of several joints the worst of each.
///
/// Orders are the largest up to 3 that hold, −1 where the pieces are apart.
///
/// A unit circle goes on where a line arrives, but the curvature leaps from 0 to 1:
///
/// ```
/// use virote_kernel::{Curve, Frame, NurbsCurve, Tolerance, glam::DVec3};
///
/// let line = Curve::from(NurbsCurve::line(DVec3::new(1.0, -1.0, 0.0), DVec3::X)?);
/// let arc = Curve::from(NurbsCurve::arc(Frame::XY, 1.0, 0.0, 2.0)?);
/// let joint = line.continuity_with(&arc, Tolerance::DEFAULT)?;
/// assert_eq!(joint.g, 1);
/// assert!(joint.curvature_gap.is_some_and(|gap| (gap - 1.0).abs() < 1e-12));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Continuity {
    /// Equal derivatives by the parameter.
    pub c: i32,
    /// Equal derivatives by arc length: 1 the same direction, 2 the same curvature vector, 3 the
    /// same change of it. That is what the constraints with β₁, β₂, β₃ say without naming a
    /// parametrization.
    pub g: i32,
    /// Distance of the points.
    pub gap: f64,
    /// Angle of the tangents, in radians.
    pub angle: f64,
    /// Distance of the curvature vectors; `None` where one of them has no bound.
    pub curvature_gap: Option<f64>,
    /// Equal derivatives of the homogeneous curves, which is more than equal ones in space.
    pub c_homogeneous: i32,
}

/// One side of a joint.
struct JointSide {
    around: EvaluationPlace,
    local: LocalGeometry,
    derivatives: Vec<DVec3>,
    homogeneous: Vec<DVec4>,
}

impl Curve {
    /// How `next` goes on where this curve ends.
    ///
    /// Points are compared by the document's distance, directions and all that is higher by its
    /// angle, relative to the size of the pieces. Where a distance, an angle or a curvature gap is
    /// asked for, it decides in their place on points, directions and curvature vectors, and the
    /// orders by the parameter are no higher than the geometric one. Barsky & DeRose, *Geometric
    /// continuity of parametric curves*.
    ///
    /// # Errors
    /// `LocalError::VanishingTangent` where one of the curves stays at one point, and as
    /// [`Self::point_at`].
    pub fn continuity_with(
        &self,
        next: &Self,
        tolerance: impl Into<JointTolerance>,
    ) -> Result<Continuity, GeomError> {
        let tolerance = tolerance.into();
        if let Some(scale) = needed_scale(self.probed()?.max(next.probed()?)) {
            let [this, next] = [self, next].map(|curve| curve.divided_by(scale));
            let joint = this.continuity_with(&next, tolerance.divided_by(scale))?;
            return Ok(joint.multiplied_by(scale));
        }
        let end = self.ending(self.domain().end(), Side::Left)?;
        Ok(joint(&end, &next.ending(next.domain().start(), Side::Right)?, tolerance))
    }

    /// The worst continuity of the inner knots, of the seam of a closed curve, and of the places
    /// inside a piece where its derivative vanishes: derivatives by the parameter agree there, but
    /// at a cusp the direction turns back, and where it does not the curvature may be without bound.
    /// Of a function the places where its derivatives jump are joints.
    ///
    /// # Errors
    /// `LocalError::VanishingTangent` where a piece stays at one point, and as
    /// [`Self::spline`].
    pub fn continuity(
        &self,
        tolerance: impl Into<JointTolerance>,
    ) -> Result<Continuity, GeomError> {
        let tolerance = tolerance.into();
        if let Some(scale) = needed_scale(self.probed()?) {
            let joint = self.divided_by(scale).continuity(tolerance.divided_by(scale))?;
            return Ok(joint.multiplied_by(scale));
        }
        let domain = self.domain();
        let mut worst = Continuity::PERFECT;
        let sides = [Side::Left, Side::Right];
        let (breaks, standstills) = match self {
            Self::Nurbs(curve) => (curve.knots().breaks(), curve.standstills()),
            Self::Parametric(curve) => {
                let spline = curve.nurbs_approximation()?;
                if !spline.breaks().is_empty() {
                    return Self::Nurbs(spline).continuity(tolerance);
                }
                (Vec::new(), curve.standing(spline.standstills())?)
            }
        };
        for t in breaks {
            if domain.start() < t && t < domain.end() {
                let [before, after] = sides.map(|side| self.ending(t, side));
                worst = worst.or_worse(joint(&before?, &after?, tolerance));
            }
        }
        for t in standstills {
            let [before, after] = sides.map(|side| self.ending_near(t, side));
            worst = worst.or_worse(joint(&before?, &after?, tolerance));
        }
        if self.is_closed(tolerance.closed_within()) {
            worst = worst.or_worse(self.continuity_with(self, tolerance)?);
        }
        Ok(worst)
    }

    /// The largest coordinate of some places.
    fn probed(&self) -> Result<f64, GeomError> {
        if let Self::Nurbs(curve) = self {
            return Ok(curve.magnitude());
        }
        let places = PROBES.iter().map(|&fraction| self.point_at(self.domain().at(fraction)));
        places
            .map(|place| place.map(|place| place.abs().max_element()))
            .try_fold(0.0, |largest: f64, place| place.map(|place| largest.max(place)))
    }

    fn divided_by(&self, scale: f64) -> Self {
        self.transformed(&DAffine3::from_scale(DVec3::splat(scale.recip())))
    }

    fn ending(&self, t: f64, side: Side) -> Result<JointSide, GeomError> {
        self.ending_around(self.neighbourhood(t, side)?)
    }

    /// The same where a singular place is known but for the rounding of its parameter.
    fn ending_near(&self, t: f64, side: Side) -> Result<JointSide, GeomError> {
        let around = self.neighbourhood(t, side)?;
        self.ending_around(EvaluationPlace { slack: PLACE_RELATIVE, ..around })
    }

    fn ending_around(&self, around: EvaluationPlace) -> Result<JointSide, GeomError> {
        let derivatives = self.derivatives_around(&around, MAX_ORDER)?;
        let homogeneous = match self {
            Self::Nurbs(curve) => {
                let span = curve.knots().span_beside(around.parameter, around.side);
                curve.homogeneous_derivatives(span, around.parameter, MAX_ORDER).into_vec()
            }
            // Weight one, which does not change.
            Self::Parametric(_) => {
                let weights = [1.0, 0.0, 0.0, 0.0];
                derivatives.iter().zip(weights).map(|(d, weight)| d.extend(weight)).collect()
            }
        };
        Ok(JointSide { local: self.local_around(around)?, around, derivatives, homogeneous })
    }
}

impl Continuity {
    /// Nothing to see.
    const PERFECT: Self = Self {
        c: MAX_ORDER as i32,
        g: MAX_ORDER as i32,
        gap: 0.0,
        angle: 0.0,
        curvature_gap: Some(0.0),
        c_homogeneous: MAX_ORDER as i32,
    };

    /// That of curves that are larger by a factor.
    fn multiplied_by(self, factor: f64) -> Self {
        Self {
            gap: self.gap * factor,
            curvature_gap: self.curvature_gap.map(|gap| gap / factor),
            ..self
        }
    }

    /// The worse of each.
    fn or_worse(self, other: Self) -> Self {
        Self {
            c: self.c.min(other.c),
            g: self.g.min(other.g),
            gap: self.gap.max(other.gap),
            angle: self.angle.max(other.angle),
            curvature_gap: self.curvature_gap.zip(other.curvature_gap).map(|(a, b)| a.max(b)),
            c_homogeneous: self.c_homogeneous.min(other.c_homogeneous),
        }
    }
}

fn joint(before: &JointSide, after: &JointSide, tolerance: JointTolerance) -> Continuity {
    let (k_before, k_after) = (before.local.curvature_vector(), after.local.curvature_vector());
    let spatial = |ending: &JointSide| -> Vec<DVec4> {
        ending.derivatives.iter().map(|derivative| derivative.extend(0.0)).collect()
    };
    let farthest = before.local.point().abs().max(after.local.point().abs()).max_element();
    let size = farthest + before.local.extent().max(after.local.extent());
    // The weight becomes a length, so that it counts like the others.
    let scaled = |ending: &JointSide| -> Vec<DVec4> {
        let to_length = DVec3::ONE.extend(size);
        ending.homogeneous.iter().map(|&derivative| derivative * to_length).collect()
    };
    let bounds = CurveJointTolerance::new(before, after, tolerance);
    let gap = before.local.point().distance(after.local.point());
    let by_parameter = bounds.order([&spatial(before), &spatial(after)], 1.0);
    let homogeneous = bounds.order([&scaled(before), &scaled(after)], before.homogeneous[0].w);
    // Where the curve moves, what agrees by the parameter agrees by arc length.
    let moves = bounds.moves([before, after]);
    let known = if moves { usize::try_from(by_parameter).unwrap_or(0) } else { 0 };
    let g = match bounds.distance < gap {
        true => -1,
        false => geometric(before, after, &bounds).order(known) as i32,
    };
    let no_more = |order: i32| if moves { order.min(g) } else { order };
    Continuity {
        c: no_more(by_parameter),
        g,
        gap,
        angle: angle_between(before.local.tangent(), after.local.tangent()),
        curvature_gap: k_before.zip(k_after).map(|(a, b)| norm(a - b)),
        c_homogeneous: no_more(homogeneous),
    }
}

/// What counts as equal at a joint.
struct CurveJointTolerance<'a> {
    sides: [&'a EvaluationPlace; 2],
    /// The parameter step over which derivatives are compared: the shorter reach.
    step: f64,
    distance: f64,
    /// By how far two ways to write one curve differ.
    exact: f64,
    /// Of anything else, relative to its size.
    relative: f64,
    asked: JointTolerance,
}

impl<'a> CurveJointTolerance<'a> {
    fn new(before: &'a JointSide, after: &'a JointSide, tolerance: JointTolerance) -> Self {
        let extent = before.local.extent().max(after.local.extent());
        let points = [before, after].map(|ending| ending.local.point().abs().max_element());
        let exact = EXACT_RELATIVE * (points[0].max(points[1]) + extent);
        let (before, after) = (&before.around, &after.around);
        Self {
            exact,
            sides: [before, after],
            step: before.reach.min(after.reach),
            distance: tolerance.distance_for(extent, before.rounding.max(after.rounding)),
            relative: tolerance.document.angle,
            asked: tolerance,
        }
    }

    /// What rounding leaves in the terms of an order.
    fn rounding(&self, order: usize) -> f64 {
        self.sides.map(|side| side.rounding_of(order)).into_iter().fold(0.0, f64::max)
    }

    /// Whether the first derivatives are more than what counts as none.
    fn moves(&self, endings: [&JointSide; 2]) -> bool {
        endings.iter().all(|ending| {
            let terms = ending.derivatives.iter().zip(series::powers(self.step)).skip(1);
            let sizes: Vec<f64> = terms.map(|(&d, power)| norm(d * power)).collect();
            let largest = sizes.iter().copied().fold(0.0, f64::max);
            sizes
                .first()
                .is_some_and(|&first| (PLACE_RELATIVE * largest).max(self.rounding(1)) < first)
        })
    }

    /// The highest order up to which all derivatives agree, −1 where the points do not; `weight`
    /// multiplies what is in space.
    fn order(&self, derivatives: [&[DVec4]; 2], weight: f64) -> i32 {
        let terms = derivatives.map(|derivatives| -> Vec<DVec4> {
            derivatives.iter().zip(series::powers(self.step)).map(|(&d, power)| d * power).collect()
        });
        let size = terms.iter().flat_map(|terms| &terms[1..]).map(|term| term.length());
        let relative = self.relative * size.fold(0.0, f64::max);
        let differs = |k: usize| {
            let allowed = if k == 0 {
                self.distance * weight
            } else {
                relative.max(self.rounding(k).max(self.exact) * weight)
            };
            allowed < (terms[0][k] - terms[1][k]).length()
        };
        let first = (0..=MAX_ORDER).find(|&k| differs(k)).unwrap_or(MAX_ORDER + 1);
        first as i32 - 1
    }
}

/// Which derivatives by arc length agree, where the points do.
fn geometric(
    before: &JointSide,
    after: &JointSide,
    bounds: &CurveJointTolerance<'_>,
) -> Agreement<MAX_ORDER> {
    let (a, b) = (&before.local, &after.local);
    // Derivatives by arc length, and by how far they part the pieces over the shorter one.
    let extent = a.extent().min(b.extent());
    let unseen = |apart: f64, order: usize| {
        let factorial: f64 = (2..=order).map(|k| k as f64).product();
        factorial * apart / libm::pow(extent, order as f64)
    };
    let agree = |a: DVec3, b: DVec3, order: usize| {
        let size = norm(a).max(norm(b)).max(unseen(extent, order));
        let apart = unseen(bounds.rounding(order).max(bounds.exact), order);
        norm(a - b) <= (bounds.relative * size).max(apart)
    };
    // What was asked for counts down to the rounding.
    let within = |found: f64, asked: f64, order: usize| {
        found <= asked.max(unseen(bounds.rounding(order), order))
    };
    let turn = angle_between(a.tangent(), b.tangent());
    let direction = match bounds.asked.angle {
        Some(asked) => within(turn, asked, 1),
        None => turn <= bounds.relative,
    };
    let curvatures = a.curvature_vector().zip(b.curvature_vector());
    let curvature = curvatures.is_some_and(|(a, b)| match bounds.asked.curvature_gap {
        Some(asked) => within(norm(a - b), asked, 2),
        None => agree(a, b, 2),
    });
    let slopes = a.curvature_slope().zip(b.curvature_slope());
    Agreement {
        orders: [
            (direction, bounds.asked.angle.is_some()),
            (curvature, bounds.asked.curvature_gap.is_some()),
            (slopes.is_some_and(|(a, b)| agree(a, b, 3)), false),
        ],
    }
}
