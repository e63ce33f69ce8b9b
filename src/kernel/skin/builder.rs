//! Skins from sections as one has them to one surface with its report: which way they run, where they stand, how the
//! surface goes from one to the next, and what happens to weights that do not stay positive.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{
    Along, CompatibleSections, SectionParameters, Skin,
    align::{Alignment, align},
    at_constant_speed,
};
use crate::{
    ConstructionError, ConstructionReport, CountError, Curve, FormError, GeomError, NurbsCurve,
    NurbsSurface, Tolerance, WeightError, check_parameters,
};

/// A surface through sections before it is made.
///
/// Unless told otherwise sections are turned around, and seams of closed ones moved, to run beside their neighbours, and
/// the surface is cubic from one to the next. Between circles whose radius grows evenly is a cone:
///
/// ```
/// use virote_kernel::{CircleForm, Frame, NurbsCurve, SkinBuilder, Tolerance, glam::DVec3};
///
/// let ring = |z: f64| {
///     let plane = Frame::XY.at(DVec3::Z * z);
///     NurbsCurve::ellipse(plane, [1.0 + z, 1.0 + z], CircleForm::NinePoint)
/// };
/// let rings = vec![ring(0.0)?, ring(1.0)?, ring(2.0)?];
/// let cone = SkinBuilder::new(rings, Tolerance::DEFAULT).build()?;
/// let p = cone.point_at(0.3, 0.7);
/// assert!((p.truncate().length() - (1.0 + p.z)).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
#[must_use]
pub struct SkinBuilder {
    sections: Vec<Curve>,
    tolerance: Tolerance,
    degree: usize,
    is_closed: bool,
    is_aligned: bool,
    places: Layout,
    way: LoftForm,
    has_even_speed: bool,
    within: Option<f64>,
}

/// Where along v the sections stand.
#[derive(Clone, Debug)]
enum Layout {
    By(SectionParameters),
    Listed(Vec<f64>),
}

/// How the surface goes from section to section.
#[derive(Clone, Debug)]
enum LoftForm {
    Free([Option<SectionSlope>; 2]),
    Spine(Curve, Vec<f64>),
    Monotone,
}

/// A derivative by v along a section.
///
/// Two level lines that the surface leaves and reaches upright are joined by a Hermite arch:
///
/// ```
/// use virote_kernel::{NurbsCurve, SectionSlope, SkinBuilder, Tolerance, glam::DVec3};
///
/// let line = |y: f64| NurbsCurve::line(DVec3::Y * y, DVec3::new(1.0, y, 0.0));
/// let arch = SkinBuilder::new(vec![line(0.0)?, line(1.0)?], Tolerance::DEFAULT)
///     .start_slope(SectionSlope::Vector(DVec3::Z))
///     .end_slope(SectionSlope::Vector(DVec3::NEG_Z))
///     .build()?;
/// assert!(arch.point_at(0.5, 0.5).distance(DVec3::new(0.5, 0.5, 0.25)) < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub enum SectionSlope {
    /// The same everywhere.
    Vector(DVec3),
    /// A curve of vectors, by fractions of its domain.
    Curve(Arc<NurbsCurve>),
}

/// What an error of a skin is about.
///
/// ```
/// use virote_kernel::{NurbsCurve, SkinBuilder, SkinInput, Tolerance, glam::DVec3};
///
/// let line = |y: f64| NurbsCurve::line(DVec3::Y * y, DVec3::new(1.0, y, 0.0));
/// let backward = vec![1.0, 0.0];
/// let sections = vec![line(0.0)?, line(1.0)?];
/// let found = SkinBuilder::new(sections, Tolerance::DEFAULT).parameters_at(backward).skin();
/// assert_eq!(found.err().map(|error| error.blamed), Some(SkinInput::Parameters));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SkinInput {
    /// The sections.
    Sections,
    /// The parameters at which they stand.
    Parameters,
    /// The spine.
    Spine,
    /// The parameters of the spine at the sections.
    At,
    /// The derivative along the first section.
    StartSlope,
    /// The derivative along the last section.
    EndSlope,
}

/// A skin that cannot be made, and what of it is to blame.
///
/// ```
/// use virote_kernel::{CountError, GeomError, NurbsCurve, SkinBuilder, SkinInput, Tolerance, glam::DVec3};
///
/// let only = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
/// let Err(found) = SkinBuilder::new(vec![only], Tolerance::DEFAULT).skin() else {
///     unreachable!("one section is too few");
/// };
/// assert_eq!(found.blamed, SkinInput::Sections);
/// assert_eq!(found.error, GeomError::Count(CountError::TooFewCurves { got: 1, needed: 2 }));
/// # Ok::<(), GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SkinError {
    /// What is to blame.
    pub blamed: SkinInput,
    /// What is wrong with it.
    pub error: GeomError,
}

impl From<SkinError> for GeomError {
    fn from(error: SkinError) -> Self {
        error.error
    }
}

/// A skin with all that one may want to know of it.
///
/// ```
/// use virote_kernel::{NurbsCurve, SkinBuilder, Tolerance, glam::DVec3};
///
/// // A section that runs the other way is turned around, and the report tells.
/// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// let sections = vec![NurbsCurve::line(o, x)?, NurbsCurve::line(x + y, y)?];
/// let made = SkinBuilder::new(sections, Tolerance::DEFAULT).skin()?;
/// assert_eq!(made.sections[1].start(), y);
/// assert!(made.surface.report().is_some() && made.unpaired.is_empty());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SkinnedSurface {
    /// u along the sections, v from one to the next; with its report.
    pub surface: NurbsSurface,
    /// The sections as the surface has them.
    pub sections: Vec<NurbsCurve>,
    /// Neighbours whose corners cannot be paired, with how many these are.
    pub unpaired: Vec<[(usize, usize); 2]>,
    /// The least weight of a control point that is not positive, by row and column; of rational sections that became
    /// splines that which there would have been.
    pub bad_weight: Option<(usize, usize, f64)>,
    /// Whether rational sections became splines within the tolerance, because weights would not have stayed positive.
    pub is_refitted: bool,
}

/// Tells what an error is about.
trait AboutSkinInput<T> {
    fn about(self, blamed: SkinInput) -> Result<T, SkinError>;
}

impl<T> AboutSkinInput<T> for Result<T, GeomError> {
    fn about(self, blamed: SkinInput) -> Result<T, SkinError> {
        self.map_err(|error| SkinError { blamed, error })
    }
}

impl SkinBuilder {
    /// The surface through the sections in this order; the first and the last may be points, curves of one control point.
    pub fn new<C: Into<Curve>>(sections: Vec<C>, tolerance: Tolerance) -> Self {
        Self {
            sections: sections.into_iter().map(Into::into).collect(),
            tolerance,
            degree: 3,
            is_closed: false,
            is_aligned: true,
            places: Layout::By(SectionParameters::Average),
            way: LoftForm::Free([None, None]),
            has_even_speed: false,
            within: None,
        }
    }

    /// The degree along v; fewer sections than degree + 1 lower it.
    pub fn degree(self, degree: usize) -> Self {
        Self { degree, ..self }
    }

    /// The surface goes on from the last section to the first.
    pub fn closed(self) -> Self {
        Self { is_closed: true, ..self }
    }

    /// The sections run as they are given.
    pub fn unaligned(self) -> Self {
        Self { is_aligned: false, ..self }
    }

    /// The rule by which the sections stand along v.
    pub fn parameters(self, rule: SectionParameters) -> Self {
        Self { places: Layout::By(rule), ..self }
    }

    /// Where along v the sections stand; of a closed skin also where the first one comes again.
    pub fn parameters_at(self, parameters: Vec<f64>) -> Self {
        Self { places: Layout::Listed(parameters), ..self }
    }

    /// The derivative by v along the first section.
    pub fn start_slope(self, slope: SectionSlope) -> Self {
        let end = if let LoftForm::Free([_, end]) = self.way { end } else { None };
        Self { way: LoftForm::Free([Some(slope), end]), ..self }
    }

    /// The derivative by v along the last section.
    pub fn end_slope(self, slope: SectionSlope) -> Self {
        let start = if let LoftForm::Free([start, _]) = self.way { start } else { None };
        Self { way: LoftForm::Free([start, Some(slope)]), ..self }
    }

    /// The surface has the spine's tangents at the sections, which stand at its parameters; of degree 2 or 3.
    pub fn along_spine(self, spine: impl Into<Curve>, at: Vec<f64>) -> Self {
        Self { way: LoftForm::Spine(spine.into(), at), ..self }
    }

    /// Each coordinate of the control points stays between its values at two neighbouring sections.
    pub fn monotone(self) -> Self {
        Self { way: LoftForm::Monotone, ..self }
    }

    /// Points of equal fraction of the length belong together, instead of those of equal parameter.
    pub fn by_length(self) -> Self {
        Self { has_even_speed: true, ..self }
    }

    /// How far sections may move so that the surface has fewer knots, and no weights that are not positive.
    pub fn within(self, tolerance: f64) -> Self {
        Self { within: Some(tolerance), ..self }
    }

    /// The surface, with its report.
    ///
    /// # Errors
    /// Those of [`Self::skin`].
    pub fn build(self) -> Result<NurbsSurface, GeomError> {
        Ok(self.skin()?.surface)
    }

    /// The surface with all that was found.
    ///
    /// # Errors
    /// [`CountError::TooFewCurves`], [`ConstructionError::PointBetween`], [`ConstructionError::OnlyPoints`],
    /// [`ConstructionError::MixedSections`], `InputError::CoincidentPoints` for sections at one place;
    /// [`FormError::RationalFor`] for slopes; those of [`Along`] and [`CompatibleSections`].
    pub fn skin(self) -> Result<SkinnedSurface, SkinError> {
        let distance = self.tolerance.distance;
        let within = self.within.unwrap_or(distance);
        let nurbs = |curve: &Curve| Ok(NurbsCurve::clone(&*curve.nurbs_within(distance)?));
        let curves: Result<Vec<NurbsCurve>, GeomError> = self.sections.iter().map(nurbs).collect();
        let mut curves = curves.about(SkinInput::Sections)?;
        if self.is_closed {
            drop_repeated(&mut curves, distance);
        }
        check_count(&curves, self.is_closed).about(SkinInput::Sections)?;
        let found = match self.is_aligned {
            true => align(&mut curves, distance).about(SkinInput::Sections)?,
            false => Alignment::default(),
        };
        if self.has_even_speed {
            curves = at_constant_speed(&curves, within).about(SkinInput::Sections)?;
        }
        let no_slopes = [None, None];
        let slopes = if let LoftForm::Free(slopes) = &self.way { slopes } else { &no_slopes };
        let (mut sections, slopes) = with_slopes(curves, slopes)?;
        let has_slopes = slopes.iter().any(Option::is_some);
        let as_given = sections.clone();
        // Tangents at the ends hold on to the knots that they share with the sections.
        if self.within.is_some() && !has_slopes {
            sections = sections.thinned(within);
        }

        let (along, parameters) = self.along(&sections, slopes)?;
        let made = match has_slopes {
            // They belong to the control points that there are.
            true => sections.skinned(&along).map(|skin| (skin, None)),
            false => positive([&sections, &as_given], &along, self.within.is_none(), within),
        };
        let (skin, refit) = made.about(SkinInput::Sections)?;
        let bad_weight = refit.as_ref().map_or(skin.bad_weight, |refit| refit.weight);
        let is_refitted = refit.is_some();
        let refitted = refit.map_or(Vec::new(), |refit| refit.sections);
        let unpaired = found.unpaired.clone();
        let surface = with_report(skin, parameters, found, refitted);
        let sections = sections.curves().to_vec();
        Ok(SkinnedSurface { surface, sections, unpaired, bad_weight, is_refitted })
    }

    /// How the surface goes from section to section, and where these stand.
    fn along(
        &self,
        sections: &CompatibleSections,
        slopes: [EndSlopes; 2],
    ) -> Result<(Along, Vec<f64>), SkinError> {
        let (degree, is_closed) = (self.degree, self.is_closed);
        let needed = sections.curves().len() + usize::from(is_closed);
        if let LoftForm::Spine(spine, at) = &self.way {
            check_parameters(at, needed).about(SkinInput::At)?;
            let curve = spine.nurbs_within(self.tolerance.distance).about(SkinInput::Spine)?;
            let inside = |&t: &f64| curve.domain().clamp_inside(t);
            let places: Result<Vec<f64>, _> = at.iter().map(inside).collect();
            let along = places.and_then(|places| Along::spine(&places, degree, &curve, is_closed));
            return Ok((along.about(SkinInput::At)?, at.clone()));
        }
        let parameters = match &self.places {
            Layout::Listed(listed) => {
                check_parameters(listed, needed).about(SkinInput::Parameters)?;
                listed.clone()
            }
            Layout::By(rule) => sections.parameters(*rule, is_closed).about(SkinInput::Sections)?,
        };
        let along = match (&self.way, is_closed) {
            (LoftForm::Monotone, is_closed) => Along::monotone(&parameters, is_closed),
            (_, true) => Along::closed(&parameters, degree),
            (_, false) if slopes.iter().all(Option::is_none) => Along::free(&parameters, degree),
            (_, false) => Along::with_slopes(&parameters, degree, slopes),
        };
        Ok((along.about(SkinInput::Sections)?, parameters))
    }
}

/// Takes away the last section where it is the first one again.
fn drop_repeated(curves: &mut Vec<NurbsCurve>, tolerance: f64) {
    let [first, .., last] = &curves[..] else { return };
    if first.deviation_from(&last.reparametrized(first.domain())) <= tolerance {
        curves.pop();
    }
}

/// Fails unless there are enough sections, and points only at the ends.
fn check_count(curves: &[NurbsCurve], is_closed: bool) -> Result<(), GeomError> {
    let (got, needed) = (curves.len(), if is_closed { 3 } else { 2 });
    if got < needed {
        return Err(CountError::TooFewCurves { got, needed }.into());
    }
    let mut inner = if is_closed { 0..got } else { 1..got - 1 };
    if let Some(index) = inner.find(|&i| curves[i].is_point()) {
        return Err(ConstructionError::PointBetween { index }.into());
    }
    if curves.iter().all(NurbsCurve::is_point) {
        return Err(ConstructionError::OnlyPoints.into());
    }
    Ok(())
}

/// The homogeneous derivatives by v along a section, one a control point.
type EndSlopes = Option<Vec<DVec4>>;

/// The sections on one basis, with derivatives along the first and the last.
fn with_slopes(
    mut curves: Vec<NurbsCurve>,
    slopes: &[Option<SectionSlope>; 2],
) -> Result<(CompatibleSections, [EndSlopes; 2]), SkinError> {
    let n_sections = curves.len();
    let domain = curves[0].domain();
    for (slope, blamed) in slopes.iter().zip([SkinInput::StartSlope, SkinInput::EndSlope]) {
        let Some(SectionSlope::Curve(vectors)) = slope else { continue };
        if vectors.is_rational() || curves.iter().any(NurbsCurve::is_rational) {
            let error = FormError::RationalFor { what: "a curve of tangents" };
            return Err(error.into()).about(blamed);
        }
        curves.push(vectors.reparametrized(domain));
    }
    let all = CompatibleSections::new(&curves).about(SkinInput::Sections)?;
    let mut vectors = all.curves()[n_sections..].iter();
    let sections = all.first(n_sections);
    let ends = [&sections.curves()[0], &sections.curves()[n_sections - 1]];
    let mut derivatives = [None, None];
    for ((slope, end), place) in slopes.iter().zip(ends).zip(&mut derivatives) {
        *place = match slope {
            None => None,
            Some(SectionSlope::Vector(v)) => {
                Some(end.control_points().iter().map(|p| (*v * p.w).extend(0.0)).collect())
            }
            Some(SectionSlope::Curve(_)) => vectors
                .next()
                .map(|curve| curve.points().into_iter().map(|v| v.extend(0.0)).collect()),
        };
    }
    Ok((sections, derivatives))
}

/// Rational sections that became splines.
struct Refit {
    sections: Vec<usize>,
    /// The weight that there would have been; none where weights would vanish.
    weight: Option<(usize, usize, f64)>,
}

/// The skin; where weights would vanish, or be negative and a tolerance is given, through
/// polynomial splines near the rational sections, whose indices are told.
fn positive(
    [sections, as_given]: [&CompatibleSections; 2],
    along: &Along,
    is_exact: bool,
    tolerance: f64,
) -> Result<(Skin, Option<Refit>), GeomError> {
    let weight = match sections.skinned(along) {
        Ok(skin) if is_exact || skin.bad_weight.is_none() => return Ok((skin, None)),
        Ok(skin) => skin.bad_weight,
        Err(GeomError::Weights(WeightError::VanishingWeightsAt { .. })) => None,
        Err(error) => return Err(error),
    };
    let is_rational = |&i: &usize| sections.curves()[i].is_rational();
    let rational: Vec<usize> = (0..sections.curves().len()).filter(is_rational).collect();
    let skin = as_given.polynomial(tolerance)?.skinned(along)?;
    Ok((skin, Some(Refit { sections: rational, weight })))
}

/// The surface with its report.
fn with_report(
    skin: Skin,
    parameters: Vec<f64>,
    found: Alignment,
    refitted: Vec<usize>,
) -> NurbsSurface {
    let Skin { surface, bad_weight } = skin;
    let seam = |&(section, at): &(usize, f64)| {
        ConstructionReport::default().with("section", section).with("at", at)
    };
    let net = surface.control_points();
    let both = |u: usize, v: usize| ConstructionReport::default().with("u", u).with("v", v);
    let report = ConstructionReport::of("skin")
        .with("parameters", parameters)
        .with("degree", both(surface.degree_u(), surface.degree_v()))
        .with("control_points", both(net.n_rows(), net.n_columns()))
        .with("reversed", found.reversed)
        .with("moved_seams", found.seams.iter().map(seam).collect::<Vec<_>>())
        .with("moved_corners", found.corners)
        .with("refitted", refitted)
        .with("least_weight", bad_weight.map(|(_, _, weight)| weight));
    surface.with_report(report)
}
