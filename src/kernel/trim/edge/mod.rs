//! The curves along which surfaces are cut: in space, and by the parameters of both surfaces.
//!
//! `even` knows parameters that are those of the curve, `place` finds the places that both surfaces have across a
//! curve, `lift` makes pieces of the curve and of its parameters of them, `piece` bounds what these miss, `certificate` proves that the surfaces cross beside them, and
//! `found` has all that two surfaces, or a surface and a plane, have in common. `reported` tells of a curve what is
//! known of it.

mod certificate;
mod even;
mod found;
mod lift;
mod piece;
mod place;
mod reported;
mod spline;

pub(super) use certificate::{SlopeRanges, slope_ranges};
pub(super) use piece::Carrier;

use crate::{GeomError, Interval, NurbsCurve};

/// What two surfaces do along a curve that they share.
///
/// ```
/// use virote_kernel::SurfaceCurveKind;
///
/// assert_eq!(SurfaceCurveKind::Crossing.word(), "crossing");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceCurveKind {
    /// They cross.
    Crossing,
    /// One of them ends there.
    Border,
    /// They touch.
    Contact,
}

impl SurfaceCurveKind {
    /// How scripts call it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Crossing => "crossing",
            Self::Border => "border",
            Self::Contact => "contact",
        }
    }
}

/// What an end of a curve on two surfaces is.
///
/// ```
/// use virote_kernel::CurveEnd;
///
/// assert_eq!(CurveEnd::Closed.word(), "closed");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveEnd {
    /// A surface ends there.
    Border,
    /// It meets other curves, or a surface has a tip there.
    Junction,
    /// It goes on where it begins.
    Closed,
    /// It goes on at the other side of a closed surface, or behind a pole.
    Seam,
}

impl CurveEnd {
    /// How scripts call it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Border => "border",
            Self::Junction => "junction",
            Self::Closed => "closed",
            Self::Seam => "seam",
        }
    }
}

/// A curve that two surfaces share, in space and by the parameters of both.
///
/// The cylinder x² + y² = 1 and the plane z = 1 share a circle:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, SurfaceCurve, SurfaceCurveKind, Tolerance, glam::DVec3};
///
/// let tube = NurbsSurface::cone(Frame::XY, [1.0, 1.0], 2.0)?;
/// let [x, y] = [DVec3::X * 2.0, DVec3::Y * 2.0];
/// let floor = NurbsSurface::bilinear(DVec3::Z - x - y, DVec3::Z - x + y, DVec3::Z + x - y, DVec3::Z + x + y)?;
/// let found = SurfaceCurve::all([&tube, &floor], Tolerance::DEFAULT)?;
/// let [circle] = &found[..] else { unreachable!("one circle") };
/// assert_eq!(circle.kind, SurfaceCurveKind::Crossing);
/// assert!(circle.is_proven && circle.radius.is_some_and(|radius| radius <= 1e-6));
/// for t in circle.curve.domain().steps(7) {
///     let uv = circle.on[0].point_at(t);
///     assert!(tube.point_at(uv.x, uv.y).distance(circle.curve.point_at(t)) <= circle.deviation);
/// }
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceCurve {
    /// In space.
    pub curve: NurbsCurve,
    /// By u and v of each surface, in the plane z = 0 over the parameter of the curve, within the domain of the
    /// surface. Where the curve leaves a domain through a seam or a pole it jumps, at a knot that stands four times.
    pub on: [NurbsCurve; 2],
    /// A bound of the distance between the curve and either surface at its parameters, model units. Not finite where
    /// there is none.
    pub deviation: f64,
    /// A bound of the distance between the curve and the one in which the surfaces cross, where that is proven.
    pub radius: Option<f64>,
    /// What the surfaces do along it.
    pub kind: SurfaceCurveKind,
    /// Whether it is proven: of a crossing that the surfaces cross in one smooth arc beside it all along,
    /// within the tolerance; of a border the deviation alone.
    pub is_proven: bool,
    /// What its start and its end are.
    pub between: [CurveEnd; 2],
}

impl SurfaceCurve {
    /// The parameters where one of the curves of parameters jumps.
    #[must_use]
    pub fn seams(&self) -> Vec<f64> {
        let domain = self.curve.domain();
        let mut seams: Vec<f64> = Vec::new();
        for on in &self.on {
            let knots = on.knots();
            let is_jump = |&(t, times): &(f64, usize)| {
                domain.start() < t && t < domain.end() && knots.degree() < times
            };
            seams.extend(knots.distinct().into_iter().filter(is_jump).map(|(t, _)| t));
        }
        seams.sort_by(f64::total_cmp);
        seams.dedup();
        seams
    }

    /// The parts between its seams, each with parameters without a jump.
    ///
    /// # Errors
    /// As [`NurbsCurve::trimmed`].
    pub fn parts(&self) -> Result<Vec<Self>, GeomError> {
        let domain = self.curve.domain();
        let seams = self.seams();
        if seams.is_empty() {
            return Ok(vec![self.clone()]);
        }
        let ends: Vec<f64> =
            [domain.start()].into_iter().chain(seams).chain([domain.end()]).collect();
        let part = |pair: &[f64]| {
            let interval = Interval::new(pair[0], pair[1])?;
            let mut part = self.clone();
            part.curve = self.curve.trimmed(interval)?;
            part.on = [self.on[0].trimmed(interval)?, self.on[1].trimmed(interval)?];
            let end = |own: CurveEnd, is_own: bool| match own {
                CurveEnd::Closed => CurveEnd::Seam,
                own if is_own => own,
                _ => CurveEnd::Seam,
            };
            part.between = [
                end(self.between[0], pair[0] <= domain.start()),
                end(self.between[1], domain.end() <= pair[1]),
            ];
            Ok(part)
        };
        ends.windows(2).map(part).collect()
    }
}
