//! Surfaces that a section leaves behind as it moves along a path.
//!
//! `builder` decides how it is made; `rails` hold the section; `frames` carry directions along the path, `columns` make splines of where control points go, `corner` takes it around corners, `folds` tells where
//! the surface crosses itself. This file places the section and measures how
//! near the surface is.

mod builder;
mod columns;
mod corner;
mod folds;
mod frames;
mod rails;

pub use builder::{SweepBuilder, SweepError, SweepInput, SweptLeg, SweptSurface};
pub use corner::{PathLeg, legs, mitred, overreaches};
pub use frames::{Axes, FrameRule, Frames};

use glam::{DVec3, DVec4};

use super::{
    FitError, GeomError, Grid, KnotVector, NurbsCurve, NurbsSurface, ceiling::PIECES, homogeneous,
    tolerance::KNOT_RELATIVE,
};

/// What happens to a section on its way, by the path's parameter.
///
/// A side that shrinks to its half on its way makes the fourth side of a trapezoid half as long as the
/// first:
///
/// ```
/// use virote_kernel::{
///     Columns, FrameRule, Frames, GeomError, Motion, NurbsCurve, SweepResolution, glam::DVec3, swept,
/// };
///
/// struct Taper;
///
/// impl Motion for Taper {
///     fn scale(&mut self, t: f64) -> Result<DVec3, GeomError> {
///         Ok(DVec3::splat(1.0 - 0.5 * t))
///     }
/// }
///
/// let path = NurbsCurve::line(DVec3::ZERO, DVec3::X * 3.0)?;
/// let side = NurbsCurve::line(DVec3::ZERO, DVec3::Z)?;
/// let frames = Frames::new(&path, FrameRule::Fixed, DVec3::Z, false)?;
/// let made = swept(&side, &path, &frames, &mut Taper, &[], SweepResolution::within(1e-6))?;
/// assert!(made.surface.point_at(1.0, 1.0).distance(DVec3::new(3.0, 0.0, 0.5)) < 1e-12);
/// # Ok::<(), GeomError>(())
/// ```
pub trait Motion {
    /// Factors along the section's axes; 1 unless told otherwise.
    ///
    /// # Errors
    /// Where a function of a script fails.
    fn scale(&mut self, t: f64) -> Result<DVec3, GeomError> {
        let _ = t;
        Ok(DVec3::ONE)
    }

    /// The turn about the path, radians; none unless told otherwise.
    ///
    /// # Errors
    /// Where a function of a script fails.
    fn twist(&mut self, t: f64) -> Result<f64, GeomError> {
        let _ = t;
        Ok(0.0)
    }

    /// Where z should point to instead of where the frame has it.
    ///
    /// # Errors
    /// Where there is no such direction.
    fn upwards(&mut self, t: f64, point: DVec3, x: DVec3) -> Result<Option<DVec3>, GeomError> {
        let _ = (t, point, x);
        Ok(None)
    }

    /// Where rails hold the section instead: what its axes become, and its origin from the path.
    ///
    /// # Errors
    /// Where there is no such place.
    fn held(&mut self, t: f64, point: DVec3, x: DVec3) -> Result<Option<PlacedAxes>, GeomError> {
        let _ = (t, point, x);
        Ok(None)
    }
}

/// Nothing happens on the way but what the frames do.
impl Motion for () {}

/// The section's axes, with their lengths, and its origin, from a point of the path.
pub type PlacedAxes = ([DVec3; 3], DVec3);

/// How fine a sweep is.
///
/// ```
/// use virote_kernel::{FrameRule, Frames, NurbsCurve, SweepResolution, glam::DVec3, swept};
///
/// let path = NurbsCurve::line(DVec3::ZERO, DVec3::X * 3.0)?;
/// let side = NurbsCurve::line(DVec3::ZERO, DVec3::Z)?;
/// let frames = Frames::new(&path, FrameRule::Fixed, DVec3::Z, false)?;
/// let five =
///     SweepResolution { n_sections: Some(5), keeps_path: false, ..SweepResolution::within(1e-6) };
/// let made = swept(&side, &path, &frames, &mut (), &[], five)?;
/// assert_eq!(made.placements, [0.0, 0.25, 0.5, 0.75, 1.0]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SweepResolution {
    /// Placements of the section; else as many as the tolerance needs.
    pub n_sections: Option<usize>,
    /// How far the surface may be from the true one.
    pub tolerance: f64,
    /// Whether the path itself is to be met exactly.
    pub keeps_path: bool,
    /// What the columns of control points are made of.
    pub columns: Columns,
}

impl SweepResolution {
    /// As many placements as the tolerance needs, and the path met.
    #[must_use]
    pub const fn within(tolerance: f64) -> Self {
        Self { n_sections: None, tolerance, keeps_path: true, columns: Columns::Through }
    }
}

/// What the columns of control points of a sweep are made of.
///
/// A circle along a circle is a torus, to within the tolerance, from either:
///
/// ```
/// use virote_kernel::{
///     CircleForm, Columns, Frame, FrameRule, Frames, NurbsCurve, SweepResolution, glam::DVec3, swept,
/// };
///
/// let ring = NurbsCurve::ellipse(Frame::XY, [4.0, 4.0], CircleForm::NinePoint)?;
/// let section = NurbsCurve::ellipse(Frame::YZ, [1.0, 1.0], CircleForm::NinePoint)?;
/// let frames = Frames::new(&ring, FrameRule::RotationMinimizing, DVec3::Z, true)?;
/// for columns in [Columns::Through, Columns::Offset] {
///     let fineness = SweepResolution { columns, ..SweepResolution::within(1e-4) };
///     let torus = swept(&section, &ring, &frames, &mut (), &[], fineness)?.surface;
///     let p = torus.point_at(0.2, 0.3);
///     assert!(((p.truncate().length() - 4.0).hypot(p.z) - 1.0).abs() < 1e-4);
/// }
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Columns {
    /// They are such that the surface passes through placements of the section.
    Through,
    /// Each is the section's control points about a control point of the path, with the axes of
    /// that one's node: Bloomenthal & Riesenfeld, *Approximation of sweep surfaces by tensor
    /// product NURBS*, SPIE 1610 (1991).
    Offset,
}

/// A swept surface, and what is to be said about it.
///
/// A section that reaches beyond the centre of its path's curvature folds the surface all the way:
///
/// ```
/// use virote_kernel::{
///     Frame, FrameRule, Frames, NurbsCurve, SweepResolution, glam::DVec3, swept,
/// };
///
/// let path = NurbsCurve::arc(Frame::XY, 1.0, 0.0, 2.0)?;
/// let frames = Frames::new(&path, FrameRule::RotationMinimizing, DVec3::Z, false)?;
/// let bar = |half: f64| NurbsCurve::line(DVec3::Y * -half, DVec3::Y * half);
/// let sweep =
///     |half| swept(&bar(half)?, &path, &frames, &mut (), &[], SweepResolution::within(1e-6));
/// assert!(sweep(0.5)?.folds.is_empty());
/// let [fold] = sweep(2.0)?.folds[..] else { unreachable!("one fold from end to end") };
/// assert_eq!(fold, [path.domain().start(), path.domain().end()]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sweep {
    /// u along the section, v along the path with the path's parameter.
    pub surface: NurbsSurface,
    /// How far control lines were found from where they should run, and where.
    pub deviation: (f64, f64),
    /// Between which parameters the section reaches beyond the path's centre of curvature.
    pub folds: Vec<[f64; 2]>,
    /// Where between the ends the section shrinks to a line or a point.
    pub collapses: Vec<f64>,
    /// The parameters of the placements.
    pub placements: Vec<f64>,
}

/// Places of a span at which the distance from the true surface is measured: while knots are
/// added, and to verify that no more are needed.
const N_PLACES: usize = 7;
const N_VERIFIED: usize = 36;

/// The degree along the path of a skin through placements.
const SKIN_DEGREE: usize = 3;

/// Part of the tolerance that may be used up at those places.
const SAFETY: f64 = 0.5;

/// The translation of one curve along another: control points are sums, weights products.
///
/// Piegl & Tiller, *The NURBS Book*, (10.17) to (10.19).
///
/// A parabola along another is the paraboloid z = x² + y²:
///
/// ```
/// use virote_kernel::{NurbsCurve, glam::DVec3, translated};
///
/// let along = |axis: DVec3| NurbsCurve::bezier(&[DVec3::Z - axis, -DVec3::Z, DVec3::Z + axis]);
/// let bowl = translated(&along(DVec3::X)?, &along(DVec3::Y)?)?;
/// assert_eq!(bowl.point_at(0.75, 1.0), DVec3::new(0.5, 1.0, 1.25));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
///
/// # Errors
/// `InputError::NotFinite`.
pub fn translated(section: &NurbsCurve, path: &NurbsCurve) -> Result<NurbsSurface, GeomError> {
    let (own, along) = (section.control_points(), path.control_points());
    let net = Grid::from_fn(own.len(), along.len(), |i, j| {
        let (q, t) = (own[i], along[j]);
        (q.truncate() * t.w + t.truncate() * q.w).extend(q.w * t.w)
    });
    NurbsSurface::new(section.knots().clone(), path.knots().clone(), net)
}

/// The surface that a section leaves behind: T(v) + A(v)·S(v)·C(u).
///
/// With the path kept, Piegl & Tiller, *The NURBS Book*, A10.1, on the path's knots with more
/// where the tolerance needs them; else A10.2: a skin through placements, at even parameters where
/// their number is given. With columns that are offsets the path's knots get more where the
/// tolerance needs them.
///
/// # Errors
/// [`FitError::ToleranceNotKept`] where [`PIECES`] columns do not suffice; where frames or the motion
/// fail.
pub fn swept(
    section: &NurbsCurve,
    path: &NurbsCurve,
    frames: &Frames,
    motion: &mut dyn Motion,
    breaks: &[f64],
    fineness: SweepResolution,
) -> Result<Sweep, GeomError> {
    let path = path.clamped();
    let keeps_weights = fineness.keeps_path;
    let mut moving = MovingSection { section, path: &path, frames, motion, keeps_weights };
    let breaks = [breaks, &frames.breaks()].concat();
    if let (Some(n), false) = (fineness.n_sections, fineness.keeps_path) {
        let fit = moving.skinned(n, fineness.tolerance)?;
        let (worst, _) = moving.deviations(&fit, fineness.tolerance, N_VERIFIED)?;
        return moving.with_defects(fit, worst);
    }
    let mut knots = moving.basis(&breaks, fineness)?;
    // On the path's own knots only simple motions are exact.
    let mut is_plain = fineness.keeps_path;
    loop {
        GeomError::go_on(knots.n_points())?;
        let mut fit = match fineness.columns {
            Columns::Through => moving.fitted(&knots)?,
            Columns::Offset => moving.offset(&knots)?,
        };
        if !is_plain && fineness.columns == Columns::Through {
            moving.joined(&mut fit)?;
        }
        let (mut worst, mut missed) =
            moving.deviations(&fit, SAFETY * fineness.tolerance, N_PLACES)?;
        if fineness.n_sections.is_some() || missed.is_empty() {
            (worst, missed) = moving.deviations(&fit, fineness.tolerance, N_VERIFIED)?;
        }
        if fineness.n_sections.is_some() || missed.is_empty() {
            return moving.with_defects(fit, worst);
        }
        let is_freed = is_plain && fineness.columns == Columns::Through;
        let next = if is_freed { freer(&knots)? } else { knots.with(&missed) };
        is_plain = false;
        if PIECES < next.n_points() {
            let tolerance = fineness.tolerance;
            return Err(FitError::ToleranceNotKept { tolerance, found: worst.0 }.into());
        }
        knots = next;
    }
}

/// A section on its way.
struct MovingSection<'a> {
    section: &'a NurbsCurve,
    path: &'a NurbsCurve,
    frames: &'a Frames,
    motion: &'a mut dyn Motion,
    /// Whether the weights of the path are those of the surface, as they are where it is met.
    keeps_weights: bool,
}

/// A surface through placements.
struct PlacementFit {
    surface: NurbsSurface,
    at: Vec<f64>,
}

impl MovingSection<'_> {
    /// The axes of the section, with its factors, at a parameter, and its origin from the path.
    fn axes(&mut self, t: f64) -> Result<PlacedAxes, GeomError> {
        let mut axes = self.frames.at(t)?;
        let point = self.path.point_at(t);
        if let Some(held) = self.motion.held(t, point, axes.x)? {
            return Ok(held);
        }
        if let Some(z) = self.motion.upwards(t, point, axes.x)? {
            axes = Axes { x: axes.x, y: z.cross(axes.x), z };
        }
        let twist = self.motion.twist(t)?;
        let (sine, cosine) = (libm::sin(twist), libm::cos(twist));
        let (y, z) = if twist.abs() <= 0.0 {
            (axes.y, axes.z)
        } else {
            (axes.y * cosine + axes.z * sine, axes.z * cosine - axes.y * sine)
        };
        let scale = self.motion.scale(t)?;
        let slid = |v: DVec3| v + axes.x * self.frames.slide(point, axes, v);
        Ok(([axes.x * scale.x, slid(y * scale.y), slid(z * scale.z)], DVec3::ZERO))
    }

    /// Where each control point of the section is.
    fn placed(&mut self, t: f64) -> Result<Vec<DVec4>, GeomError> {
        let origin = match self.keeps_weights {
            true => self.path.homogeneous_at(t),
            false => self.path.point_at(t).extend(1.0),
        };
        self.placed_about(origin, t)
    }

    /// Where each control point of the section is about a homogeneous point, with the axes of a
    /// parameter.
    fn placed_about(&mut self, origin: DVec4, t: f64) -> Result<Vec<DVec4>, GeomError> {
        let beside = self.beside(t)?;
        let place = |(p, moved): (&DVec4, DVec3)| {
            (origin.truncate() * p.w + moved * origin.w).extend(p.w * origin.w)
        };
        Ok(self.section.control_points().iter().zip(beside).map(place).collect())
    }

    /// Where each control point of the section is from the path, times its weight.
    fn beside(&mut self, t: f64) -> Result<Vec<DVec3>, GeomError> {
        let ([x, y, z], shift) = self.axes(t)?;
        let moved = |p: &DVec4| x * p.x + y * p.y + z * p.z + shift * p.w;
        Ok(self.section.control_points().iter().map(moved).collect())
    }

    /// The knots to begin with.
    fn basis(&self, breaks: &[f64], fineness: SweepResolution) -> Result<KnotVector, GeomError> {
        let own = self.path.knots();
        let domain = own.domain();
        let mut knots = if fineness.keeps_path {
            let mut knots = own.clone();
            while fineness.columns == Columns::Offset && knots.degree() < SKIN_DEGREE {
                knots = knots.elevated()?;
            }
            knots
        } else {
            let ends = [domain.start(), domain.end()].map(|t| vec![t; SKIN_DEGREE + 1]);
            let inner = own.breaks();
            KnotVector::new(SKIN_DEGREE, ends.concat())?.with(&inner[1..inner.len() - 1])
        };
        if let Some(n) = fineness.n_sections {
            while knots.n_points() < n {
                let mut widest = domain;
                let mut most = 0.0;
                for interval in knots.spans().map(|span| knots.span_interval(span)) {
                    if most * (1.0 + KNOT_RELATIVE) < interval.length() {
                        (widest, most) = (interval, interval.length());
                    }
                }
                knots = knots.with(&[widest.at(0.5)]);
            }
        } else {
            // A kink of the motion is one of the surface.
            for &t in breaks {
                let missing =
                    knots.degree().saturating_sub(knots.exact_multiplicity(knots.snapped(t)));
                knots = knots.with(&vec![knots.snapped(t); missing]);
            }
        }
        Ok(knots)
    }

    /// The surface with what is to be said about it.
    fn with_defects(
        &mut self,
        fit: PlacementFit,
        deviation: (f64, f64),
    ) -> Result<Sweep, GeomError> {
        let (folds, collapses) = self.folds()?;
        Ok(Sweep { surface: fit.surface, deviation, folds, collapses, placements: fit.at })
    }

    /// How far the lines of control points are from where they should run: the worst with its
    /// parameter, and the middles of the spans where it is more than allowed. The surface, a mean
    /// of the lines, is no further. Where the frame turns at once, in a cell of rounding width, there is nothing to
    /// be near to: there counts what is further than both sides of the cell are apart.
    fn deviations(
        &mut self,
        fit: &PlacementFit,
        allowed: f64,
        n_places: usize,
    ) -> Result<((f64, f64), Vec<f64>), GeomError> {
        let knots = fit.surface.knots_v().clone();
        let mut worst = (0.0_f64, knots.domain().start());
        let mut missed = Vec::new();
        for span in knots.spans() {
            let interval = knots.span_interval(span);
            let jump = match self.turning_about(interval) {
                Some([before, behind]) => Some(self.gap(before, behind)?),
                None => None,
            };
            let mut most = 0.0_f64;
            for k in 0..n_places {
                let t = interval.at((k as f64 + 0.5) / n_places as f64);
                let now = self.placed(t)?;
                let curve = fit.surface.isocurve_v(t);
                for (a, b) in now.iter().zip(curve.control_points()) {
                    let apart = homogeneous::place(*a).distance(homogeneous::place(*b));
                    let apart = (apart - jump.unwrap_or_default()).max(0.0);
                    most = most.max(apart);
                    if worst.0 < apart {
                        worst = (apart, t);
                    }
                }
            }
            if allowed < most && jump.is_none() {
                missed.push(interval.at(0.5));
            }
        }
        Ok((worst, missed))
    }
}

/// A degree of three or more, and one order of continuity less at the path's knots, as a frame
/// has.
fn freer(knots: &KnotVector) -> Result<KnotVector, GeomError> {
    let mut free = knots.clone();
    while free.degree() < 3 {
        free = free.elevated()?;
    }
    let domain = free.domain();
    let inner = |&(t, times): &(f64, usize)| {
        domain.start() < t && t < domain.end() && times < free.degree()
    };
    let more: Vec<f64> = free.distinct().into_iter().filter(inner).map(|(t, _)| t).collect();
    Ok(free.with(&more))
}
