//! Sweeps from what one gives to one surface with its report: which construction serves, what happens at corners and
//! at the seam, and how the tolerance is shared out.

use std::{fmt, sync::Arc};

use glam::{DVec2, DVec3};

use super::{
    Columns, FrameRule, Frames, Motion, PathLeg, Sweep, SweepResolution, legs, mitred, overreaches,
    rails::RailedMotion, swept, translated,
};
use crate::{
    ConstructionError, ConstructionReport, Curve, GeomError, Grid, NurbsCurve, NurbsSurface,
    ReportEntry, Side, Tolerance, join_patches, tolerance::TURN_RELATIVE,
};

/// Points of the section that are looked at.
const N_POINTS: usize = 257;

/// A sweep before it is made: a section, its path, and how the one goes along the other.
///
/// The section's x lies along the path, its y and z across it, its origin on it. Unless told otherwise it does not turn
/// about the path, begins with z as near to upward as can be, and the path has no corners.
///
/// A circle of radius 1 along one of radius 4 is a torus:
///
/// ```
/// use virote_kernel::{CircleForm, Frame, NurbsCurve, SweepBuilder, Tolerance, glam::DVec3};
///
/// let circle = |plane, r| NurbsCurve::ellipse(plane, [r, r], CircleForm::NinePoint);
/// let (section, path) = (circle(Frame::YZ, 1.0)?, circle(Frame::XY, 4.0)?);
/// let torus = SweepBuilder::new(section, path, Tolerance::DEFAULT).within(1e-5).build()?;
/// let p = torus.point_at(0.2, 0.3);
/// assert!(((p.truncate().length() - 4.0).hypot(p.z) - 1.0).abs() < 1e-5);
/// assert!(torus.is_closed_v(1e-9) && torus.report().is_some());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[must_use]
pub struct SweepBuilder<'a> {
    section: Curve,
    path: Curve,
    tolerance: Tolerance,
    /// None where the section is only moved.
    frames: Option<FrameRule>,
    up: Option<DVec3>,
    has_mitres: bool,
    motion: Option<&'a mut dyn Motion>,
    kinks: Vec<f64>,
    rails: Vec<Curve>,
    fineness: SweepResolution,
}

/// What an error of a sweep is about.
///
/// ```
/// use virote_kernel::{NurbsCurve, SweepBuilder, SweepInput, Tolerance, glam::DVec3};
///
/// let point = NurbsCurve::bezier(&[DVec3::Y])?;
/// let path = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
/// let found = SweepBuilder::new(point, path, Tolerance::DEFAULT).sweep();
/// assert_eq!(found.err().map(|error| error.blamed), Some(SweepInput::Section));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SweepInput {
    /// The section.
    Section,
    /// The path.
    Path,
    /// The frames, which begin with the direction up.
    Up,
    /// The rails.
    Rails,
    /// All of it together.
    Whole,
}

/// A sweep that cannot be made, and which of the things that it is made of is to blame.
///
/// ```
/// use virote_kernel::{NurbsCurve, SweepBuilder, SweepInput, Tolerance, glam::DVec3};
///
/// let side = NurbsCurve::line(DVec3::ZERO, DVec3::Z)?;
/// let corner = NurbsCurve::polyline(&[DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y])?;
/// let builder = || SweepBuilder::new(side.clone(), corner.clone(), Tolerance::DEFAULT);
/// let refused = builder().sweep().err().map(|error| error.blamed);
/// assert_eq!(refused, Some(SweepInput::Path));
/// assert!(builder().with_mitres().sweep().is_ok());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SweepError {
    /// What is to blame.
    pub blamed: SweepInput,
    /// What is wrong with it.
    pub error: GeomError,
}

impl From<SweepError> for GeomError {
    fn from(error: SweepError) -> Self {
        error.error
    }
}

/// A swept surface with all that one may want to know of it.
///
/// A square frame around a square of side 4 has a mitre at each corner, the last at the seam:
///
/// ```
/// use virote_kernel::{NurbsCurve, SweepBuilder, Tolerance, glam::DVec3};
///
/// let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0)];
/// let path = NurbsCurve::polyline(&corners.map(|(x, y)| DVec3::new(x, y, 0.0)))?;
/// let lath = NurbsCurve::line(DVec3::ZERO, DVec3::NEG_Y)?;
/// let made = SweepBuilder::new(lath, path, Tolerance::DEFAULT).with_mitres().sweep()?;
/// assert!(made.surface.point_at(1.0, 0.0).distance(DVec3::new(-1.0, -1.0, 0.0)) < 1e-14);
/// assert!(made.short_legs.iter().all(|&(over, _)| over <= 1.0));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SweptSurface {
    /// u along the section, v along the path; with its report.
    pub surface: NurbsSurface,
    /// The section as it was swept.
    pub section: Arc<NurbsCurve>,
    /// The path as it was followed.
    pub path: Arc<NurbsCurve>,
    /// What was found on each part of the path between mitres; nothing where all is exact.
    pub legs: Vec<SweptLeg>,
    /// By how much the parts between these parameters are shortened by mitres, over the length that there is for it:
    /// above 1 the surface crosses itself.
    pub short_legs: Vec<(f64, [f64; 2])>,
}

/// Where a sweep is not what one may expect, on a part of the path.
///
/// A bar that reaches beyond the centre of an arc folds over all along it:
///
/// ```
/// use virote_kernel::{Frame, NurbsCurve, SweepBuilder, Tolerance, glam::DVec3};
///
/// let arc = NurbsCurve::arc(Frame::XY, 1.0, 0.0, 2.0)?;
/// let bar = NurbsCurve::line(DVec3::Y * -2.0, DVec3::Y * 2.0)?;
/// let made = SweepBuilder::new(bar, arc.clone(), Tolerance::DEFAULT).sweep()?;
/// assert_eq!(made.legs[0].folds, [[arc.domain().start(), arc.domain().end()]]);
/// assert!(made.legs[0].flips.is_empty() && made.legs[0].collapses.is_empty());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SweptLeg {
    /// Between which parameters the frame turns at once.
    pub flips: Vec<[f64; 2]>,
    /// Between which parameters the section reaches beyond the path's centre of curvature.
    pub folds: Vec<[f64; 2]>,
    /// Where between the ends the section shrinks to a line or a point.
    pub collapses: Vec<f64>,
}

/// Tells what an error is about.
trait AboutSweepInput<T> {
    fn about(self, blamed: SweepInput) -> Result<T, SweepError>;
}

impl<T> AboutSweepInput<T> for Result<T, GeomError> {
    fn about(self, blamed: SweepInput) -> Result<T, SweepError> {
        self.map_err(|error| SweepError { blamed, error })
    }
}

impl fmt::Debug for SweepBuilder<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SweepBuilder")
            .field("section", &self.section)
            .field("path", &self.path)
            .field("frames", &self.frames)
            .field("fineness", &self.fineness)
            .finish_non_exhaustive()
    }
}

impl<'a> SweepBuilder<'a> {
    /// The section along the path, within the tolerance's distance of the true surface.
    pub fn new(section: impl Into<Curve>, path: impl Into<Curve>, tolerance: Tolerance) -> Self {
        Self {
            section: section.into(),
            path: path.into(),
            tolerance,
            frames: Some(FrameRule::RotationMinimizing),
            up: None,
            has_mitres: false,
            motion: None,
            kinks: Vec::new(),
            rails: Vec::new(),
            fineness: SweepResolution::within(tolerance.distance),
        }
    }

    /// The section is moved and never turned: exact, and nothing else of what moves it counts.
    pub fn translated(self) -> Self {
        Self { frames: None, ..self }
    }

    /// How the section turns with its path.
    pub fn frames(self, rule: FrameRule) -> Self {
        Self { frames: Some(rule), ..self }
    }

    /// Where z is to point at the start, or, fixed, everywhere; else to (0, 0, 1), or to (1, 0, 0) where the path runs
    /// there.
    pub fn up(self, up: DVec3) -> Self {
        Self { up: Some(up), ..self }
    }

    /// At corners both sides meet in the plane that halves the angle, instead of an error.
    pub fn with_mitres(self) -> Self {
        Self { has_mitres: true, ..self }
    }

    /// What else happens to the section on its way, and at which parameters of the path that has kinks.
    pub fn moved(self, motion: &'a mut dyn Motion, kinks: Vec<f64>) -> Self {
        Self { motion: Some(motion), kinks, ..self }
    }

    /// z points to this curve at equal fractions of the domains.
    pub fn along_rail(self, rail: impl Into<Curve>) -> Self {
        Self { rails: vec![rail.into()], ..self }
    }

    /// The section's ends run along these curves, at equal fractions of the domains.
    pub fn between_rails(self, rails: [Curve; 2]) -> Self {
        Self { rails: rails.to_vec(), ..self }
    }

    /// The path is followed within the tolerance only, with weights only where the section has some.
    pub fn beside_path(self) -> Self {
        Self { fineness: SweepResolution { keeps_path: false, ..self.fineness }, ..self }
    }

    /// How many placements of the section make the surface, instead of a tolerance.
    pub fn sections(self, n_sections: usize) -> Self {
        let n_sections = Some(n_sections);
        Self { fineness: SweepResolution { n_sections, ..self.fineness }, ..self }
    }

    /// What the columns of control points are made of; those that are offsets meet the path.
    pub fn columns(self, columns: Columns) -> Self {
        Self { fineness: SweepResolution { columns, ..self.fineness }, ..self }
    }

    /// How far the surface may be from the true one, instead of the document's distance.
    pub fn within(self, tolerance: f64) -> Self {
        Self { fineness: SweepResolution { tolerance, ..self.fineness }, ..self }
    }

    /// The surface, with its report.
    ///
    /// # Errors
    /// Those of [`Self::sweep`].
    pub fn build(self) -> Result<NurbsSurface, GeomError> {
        Ok(self.sweep()?.surface)
    }

    /// The surface with all that was found.
    ///
    /// Half of the tolerance is kept for section and path where they are functions.
    ///
    /// # Errors
    /// [`ConstructionError::PointSection`], [`ConstructionError::PointPath`]; [`GeomError::Jump`],
    /// [`ConstructionError::PathCusp`], and, without mitres, [`ConstructionError::PathCorners`] of the path;
    /// [`ConstructionError::ClosedBetweenRails`]; those of [`Frames::new`], [`swept`] and [`mitred`].
    pub fn sweep(self) -> Result<SweptSurface, SweepError> {
        let share = 0.5 * self.fineness.tolerance;
        let section = self.section.nurbs_within(share).about(SweepInput::Section)?;
        let path = self.path.nurbs_within(share).about(SweepInput::Path)?;
        if section.is_point() {
            return Err(ConstructionError::PointSection.into()).about(SweepInput::Section);
        }
        let corners = self.corners(&path).about(SweepInput::Path)?;
        let Some(rule) = self.frames else {
            let report =
                ConstructionReport::of("sweep").with("frame", "translate").with("exact", true);
            let surface = translated(&section, &path).about(SweepInput::Path)?.with_report(report);
            return Ok(SweptSurface::exact(surface, [section, path], Vec::new()));
        };

        // How it begins, and whether it comes back.
        let start = path.tangent_at(path.domain().start(), Side::Right).about(SweepInput::Path)?;
        let is_along = start.cross(DVec3::Z).length() <= self.tolerance.angle;
        let up = self.up.unwrap_or(if is_along { DVec3::X } else { DVec3::Z });
        let is_ring = path.is_closed(self.tolerance.distance);
        let is_smooth = is_ring && is_smooth_at_seam(&path).about(SweepInput::Path)?;
        let is_moved = self.motion.is_some() || !self.rails.is_empty();
        let is_polygon = path.degree() == 1 && !path.is_rational();
        if !corners.is_empty() && is_polygon && !is_moved && rule == FrameRule::RotationMinimizing {
            let report =
                ConstructionReport::of("sweep").with("corners", corners).with("exact", true);
            let surface = mitred(&section, &path, up, is_ring).about(SweepInput::Up)?;
            let short_legs = overreaches(&surface, &path);
            let surface = surface.with_report(report);
            return Ok(SweptSurface::exact(surface, [section, path], short_legs));
        }

        let has_corner_at_seam = is_ring && !is_smooth && self.has_mitres;
        let reach = reach(&section);
        let legs = if corners.is_empty() && !has_corner_at_seam {
            let frames = Frames::new(&path, rule, up, is_smooth).about(SweepInput::Up)?;
            vec![(NurbsCurve::clone(&path), frames)]
        } else {
            legs(&path, &corners, rule, up, has_corner_at_seam, reach).about(SweepInput::Up)?
        };
        self.along([section, path], &legs, (corners, reach))
    }

    /// The sweep along each part of the path, joined.
    fn along(
        self,
        [section, path]: [Arc<NurbsCurve>; 2],
        legs: &[PathLeg],
        (corners, reach): (Vec<f64>, f64),
    ) -> Result<SweptSurface, SweepError> {
        let rails = self.rails_for(&section).about(SweepInput::Rails)?;
        let Self { motion, kinks, fineness, tolerance, .. } = self;
        let mut still = ();
        let ends = [section.start(), section.end()];
        let motion = motion.unwrap_or(&mut still);
        let mut motion = RailedMotion { motion, rails, ends, domain: path.domain() };
        let keeps_path = fineness.keeps_path || fineness.columns == Columns::Offset;
        let tolerance_left = 0.5 * fineness.tolerance;
        let fineness = SweepResolution { tolerance: tolerance_left, keeps_path, ..fineness };
        let mut sweeps = Vec::with_capacity(legs.len());
        for (part, frames) in legs {
            let domain = part.domain();
            let is_inside = |t: &f64| domain.start() < *t && *t < domain.end();
            let kinks: Vec<f64> = kinks.iter().copied().filter(is_inside).collect();
            let made = swept(&section, part, frames, &mut motion, &kinks, fineness);
            sweeps.push(made.about(SweepInput::Whole)?);
        }

        let told = sweeps.iter().zip(legs).map(|(sweep, (_, frames))| SweptLeg {
            flips: frames.flips().to_vec(),
            folds: sweep.folds.clone(),
            collapses: sweep.collapses.clone(),
        });
        let told: Vec<SweptLeg> = told.collect();
        let over = legs.iter().map(|(part, frames)| {
            let domain = part.domain();
            (frames.overreach(reach), [domain.start(), domain.end()])
        });
        let short_legs = over.collect();
        let surface = joined(sweeps, legs, corners, tolerance).about(SweepInput::Whole)?;
        Ok(SweptSurface { surface, section, path, legs: told, short_legs })
    }

    /// The corners of the path, if they are to be mitred.
    fn corners(&self, path: &NurbsCurve) -> Result<Vec<f64>, GeomError> {
        if path.is_point() {
            return Err(ConstructionError::PointPath.into());
        }
        path.check_connected()?;
        if let Some(&parameter) = path.cusps(self.tolerance).first() {
            return Err(ConstructionError::PathCusp { parameter }.into());
        }
        let parameters = path.corners(self.tolerance);
        if !(self.has_mitres || parameters.is_empty()) {
            return Err(ConstructionError::PathCorners { parameters }.into());
        }
        Ok(parameters)
    }

    /// The rails as NURBS; a section between two has two ends.
    fn rails_for(&self, section: &NurbsCurve) -> Result<Vec<Arc<NurbsCurve>>, GeomError> {
        let tolerance = self.fineness.tolerance;
        if self.rails.len() == 2 && section.is_closed(tolerance) {
            return Err(ConstructionError::ClosedBetweenRails.into());
        }
        self.rails.iter().map(|rail| rail.nurbs_within(tolerance)).collect()
    }
}

impl SweptSurface {
    /// One that is no approximation, and needs nothing said of its parts but of their mitres.
    fn exact(
        surface: NurbsSurface,
        [section, path]: [Arc<NurbsCurve>; 2],
        short_legs: Vec<(f64, [f64; 2])>,
    ) -> Self {
        Self { surface, section, path, legs: Vec::new(), short_legs }
    }
}

/// How far the section reaches from the path.
fn reach(section: &NurbsCurve) -> f64 {
    section.sample(N_POINTS).iter().map(|p| DVec2::new(p.y, p.z).length()).fold(0.0, f64::max)
}

/// Whether a closed path arrives in the direction in which it left.
fn is_smooth_at_seam(path: &NurbsCurve) -> Result<bool, GeomError> {
    let domain = path.domain();
    let start = path.tangent_at(domain.start(), Side::Right)?;
    let end = path.tangent_at(domain.end(), Side::Left)?;
    Ok(start.distance(end) <= TURN_RELATIVE)
}

/// The surface of all parts with its report.
fn joined(
    sweeps: Vec<Sweep>,
    legs: &[PathLeg],
    corners: Vec<f64>,
    tolerance: Tolerance,
) -> Result<NurbsSurface, GeomError> {
    let (mut deviation, mut at) = (0.0, sweeps[0].deviation.1);
    let mut placements: Vec<f64> = Vec::new();
    let mut folds: Vec<Vec<f64>> = Vec::new();
    let mut collapses: Vec<f64> = Vec::new();
    for sweep in &sweeps {
        if deviation < sweep.deviation.0 {
            (deviation, at) = sweep.deviation;
        }
        placements.extend(&sweep.placements);
        folds.extend(sweep.folds.iter().map(|ends| ends.to_vec()));
        collapses.extend(&sweep.collapses);
    }
    let surfaces: Vec<NurbsSurface> = sweeps.into_iter().map(|sweep| sweep.surface).collect();
    let surface = match &surfaces[..] {
        [only] => only.clone(),
        _ => join_patches(&Grid::from_rows(vec![surfaces])?, tolerance.distance)?,
    };
    let net = surface.control_points();
    let both = |u: usize, v: usize| ConstructionReport::default().with("u", u).with("v", v);
    let frames = || legs.iter().map(|(_, frames)| frames);
    let flips: Vec<f64> = frames().flat_map(Frames::flips).map(|[a, b]| 0.5 * (a + b)).collect();
    let closing = frames().map(Frames::closing).sum::<f64>();
    let report = ConstructionReport::of("sweep")
        .with("placements", placements)
        .with(
            "deviation",
            ConstructionReport::default()
                .with("max", ReportEntry::Length(deviation))
                .with("at", at),
        )
        .with("closing_angle", ReportEntry::Angle(closing))
        .with("corners", corners)
        .with("flips", flips)
        .with("folds", folds)
        .with("collapses", collapses)
        .with("degree", both(surface.degree_u(), surface.degree_v()))
        .with("control_points", both(net.n_rows(), net.n_columns()));
    Ok(surface.with_report(report))
}
