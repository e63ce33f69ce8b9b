//! Skins of polynomial sections that move: how much sums of their control points grow with those of the sections.
//!
//! Each line of control points from section to section is the spline through a control point of each, and all of them
//! stand at the same parameters. Whoever asks for a place of the skin asks for few control points, which the transposed
//! equations of these splines tell, as for [curves](super::growth).

use std::sync::{Arc, OnceLock};

use glam::{DVec3, DVec4};

use super::{
    Ends, Interpolator, growth::PointGrowths, moving::MovingSpline, moving_surface::are_near,
    section_steps::SectionSteps,
};
use crate::{
    GeomError, Grid, KnotVector, NurbsCurve, NurbsSurface, PointFactors, PointMap, PointSlopes,
    SectionParameters, VariedCurve, VariedSurface, factors_of_same_curve, make_compatible,
    varied::{
        SlopeWays,
        knots::{simple_inner, with_knots_twice},
    },
};

impl VariedSurface {
    /// A skin of this degree along v whose sections stand at parameters, with the slopes that it has by its sections: by
    /// a rule these move with them, by none they stay. None where the skin is not made so of them: of sections that are
    /// rational, or by a rule on other knots; and where all slopes cost less at once.
    ///
    /// # Errors
    /// As for [`Interpolator::new`].
    ///
    /// ```
    /// use std::sync::Arc;
    /// use virote_kernel::{Jet, NurbsCurve, PointSlopes, SectionParameters, SkinBuilder, Tolerance, VariedCurve, VariedSurface, glam::{DVec3, DVec4}};
    ///
    /// // Of three level lines the middle one rises, with one unknown for each end.
    /// let line = |y: f64| NurbsCurve::line(DVec3::Y * y, DVec3::new(1.0, y, 0.0));
    /// let lines = vec![line(0.0)?, line(1.0)?, line(2.0)?];
    /// let rule = SectionParameters::Average;
    /// let skin = SkinBuilder::new(lines.clone(), Tolerance::DEFAULT).parameters(rule).build()?;
    /// let mut sections = Vec::new();
    /// for (idx, line) in lines.into_iter().enumerate() {
    ///     let ends = vec![(0, vec![DVec4::Z, DVec4::ZERO]), (1, vec![DVec4::ZERO, DVec4::Z])];
    ///     let slopes = PointSlopes::new(2, 2, if idx == 1 { ends } else { Vec::new() })?;
    ///     sections.push(Arc::new(VariedCurve::new(Arc::new(line), slopes)?));
    /// }
    /// let at = (2, &[0.0, 0.5, 1.0][..], Some(rule));
    /// let varied = VariedSurface::through_sections(&Arc::new(skin), at, &sections)?.expect("slopes");
    /// let [u, v] = [Jet::with_slopes(0.25, &[0.0; 2])?, Jet::with_slopes(0.5, &[0.0; 2])?];
    /// let place = varied.derivatives_at([&u, &v], 0)?;
    /// assert_eq!(place[0][0][2].slopes(), [0.75, 0.25]);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    pub fn through_sections(
        skin: &Arc<NurbsSurface>,
        (degree, parameters, rule): (usize, &[f64], Option<SectionParameters>),
        sections: &[Arc<VariedCurve>],
    ) -> Result<Option<Self>, GeomError> {
        let fit = Interpolator::new(parameters, degree, Ends::Averaged)?;
        let Some(given) = GivenSections::new(sections, skin) else {
            return match rule {
                None => through_refined(skin, fit, parameters, sections),
                Some(_) => Ok(None),
            };
        };
        if !given.are_asked_rather(sections.len()) {
            return Ok(None);
        }
        Self::through_given(skin, (fit, parameters, rule), given)
    }

    /// The same of sections on the knots of the skin.
    fn through_given(
        skin: &Arc<NurbsSurface>,
        (fit, parameters, rule): (Interpolator, &[f64], Option<SectionParameters>),
        given: GivenSections,
    ) -> Result<Option<Self>, GeomError> {
        let knots = skin.knots_v();
        if fit.knots() != knots || !given.are_at(parameters, skin) {
            return Ok(None);
        }
        let steps = match rule {
            None => None,
            Some(rule) => {
                let steps = SectionSteps::new(rule, given.lines.clone());
                let steps = steps.filter(|steps| steps.are_of(parameters) && given.part_at(steps));
                let Some(steps) = steps else { return Ok(None) };
                Some(steps)
            }
        };
        let fixed = match &steps {
            None => Some(Arc::clone(skin)),
            Some(_) => on_knots_twice(skin)?.map(Arc::new),
        };
        let Some(surface) = fixed else { return Ok(None) };
        let n_points = surface.control_points().as_slice().len();
        let (n_variables, variables) = (given.n_variables, given.variables());
        let growths = SkinGrowths {
            fit,
            parameters: parameters.to_vec(),
            steps,
            splines: given.lines.iter().map(|_| OnceLock::new()).collect(),
            n_columns: surface.control_points().n_columns(),
            given,
        };
        let sums = move |factors: &[f64]| growths.slopes(factors);
        let ways = SlopeWays { sums: Box::new(sums), all: Box::new(|| None) };
        let slopes = PointSlopes::asked(n_variables, n_points, variables, ways);
        Ok(Some(Self::new(surface, slopes)?.known_of_moving_knots(Arc::clone(skin))))
    }
}

/// A skin whose sections stand at parameters that stay, each on knots of its own, which may move: through the same sections
/// on common knots that do not. None where that is another surface, or sections are rational.
fn through_refined(
    skin: &Arc<NurbsSurface>,
    fit: Interpolator,
    parameters: &[f64],
    sections: &[Arc<VariedCurve>],
) -> Result<Option<VariedSurface>, GeomError> {
    if skin.is_rational() || sections.iter().any(|section| section.curve().is_rational()) {
        return Ok(None);
    }
    let curves: Vec<NurbsCurve> =
        sections.iter().map(|section| NurbsCurve::clone(section.curve())).collect();
    let mut refined = Vec::with_capacity(sections.len());
    let mut lines = Vec::with_capacity(sections.len());
    for (section, curve) in sections.iter().zip(make_compatible(&curves)?) {
        let curve = NurbsCurve::polynomial(curve.knots().clone(), &curve.points())?;
        let Some(entries) = factors_of_same_curve(section.curve(), &curve) else {
            return Ok(None);
        };
        let n_points = curve.control_points().len();
        let given = vec![section.slopes().clone()];
        let map = Arc::new(PointMap::new(given, n_points, PointFactors::Alike(entries))?);
        lines.push(curve.control_points().to_vec());
        refined.push(Arc::new(VariedCurve::new(Arc::new(curve), map.slopes_of(0..n_points))?));
    }
    let Some(first) = refined.first() else { return Ok(None) };
    let knots = first.curve().knots().clone();
    let line = |i: usize| {
        let values: Vec<DVec4> = lines.iter().map(|points| points[i]).collect();
        fit.through(&values)
    };
    let net: Vec<Vec<DVec4>> = (0..knots.n_points()).map(line).collect::<Result<_, _>>()?;
    let polynomial = |line: Vec<DVec4>| -> Vec<DVec4> {
        line.into_iter().map(|point| point.truncate().extend(1.0)).collect()
    };
    let net = Grid::from_rows(net.into_iter().map(polynomial).collect())?;
    let own = Arc::new(NurbsSurface::new(knots, fit.knots().clone(), net)?);
    let Some(given) = GivenSections::new(&refined, &own) else { return Ok(None) };
    let varied = VariedSurface::through_given(&own, (fit, parameters, None), given)?;
    Ok(varied.and_then(|varied| varied.of_moving_knots(Arc::clone(skin))))
}

/// The skin with each inner knot along v twice; none where these do not stand once.
fn on_knots_twice(skin: &NurbsSurface) -> Result<Option<NurbsSurface>, GeomError> {
    let (knots, net) = (skin.knots_v(), skin.control_points());
    let Some(inner) = simple_inner(knots) else { return Ok(None) };
    let lines = (0..net.n_rows()).map(|line| net.row(line).to_vec()).collect();
    let lines = with_knots_twice(knots, lines)?;
    let polynomial = |line: Vec<DVec4>| -> Vec<DVec4> {
        line.into_iter().map(|point| point.truncate().extend(1.0)).collect()
    };
    let net = Grid::from_rows(lines.into_iter().map(polynomial).collect())?;
    NurbsSurface::new(skin.knots_u().clone(), knots.with(inner), net).map(Some)
}

/// The control points of polynomial sections on one knot vector, and how they move.
#[derive(Debug)]
struct GivenSections {
    n_variables: usize,
    /// One of each section, for each line.
    lines: Vec<Vec<DVec4>>,
    /// Those that move with each of some variables, in order of these: line, section and speed.
    moving: Vec<(usize, Vec<(usize, usize, DVec3)>)>,
}

impl GivenSections {
    /// None unless all are on the knots of a skin along u, and polynomial as it is.
    fn new(sections: &[Arc<VariedCurve>], skin: &NurbsSurface) -> Option<Self> {
        let n_variables = sections.first()?.slopes().n_variables();
        let n_lines = skin.control_points().n_rows();
        let mut moving: Vec<Vec<(usize, usize, DVec3)>> = vec![Vec::new(); n_variables];
        for (idx, section) in sections.iter().enumerate() {
            let (curve, slopes) = (section.curve(), section.slopes());
            let is_polynomial =
                curve.control_points().iter().all(|point| point.w.total_cmp(&1.0).is_eq());
            let is_on_knots = !section.has_moving_knots() && curve.knots() == skin.knots_u();
            if !is_polynomial || !is_on_knots || slopes.n_variables() != n_variables {
                return None;
            }
            for (variable, range, slopes) in slopes.moving() {
                for line in range.filter(|&line| slopes[line] != DVec4::ZERO) {
                    if slopes[line].w != 0.0 {
                        return None;
                    }
                    moving[variable].push((line, idx, slopes[line].truncate()));
                }
            }
        }
        let moving: Vec<_> =
            moving.into_iter().enumerate().filter(|(_, own)| !own.is_empty()).collect();
        let point =
            |section: &Arc<VariedCurve>, line: usize| section.curve().control_points()[line];
        let line = |line: usize| sections.iter().map(|section| point(section, line)).collect();
        Some(Self { n_variables, lines: (0..n_lines).map(line).collect(), moving })
    }

    /// Whether slopes of the lines through so many sections cost less one by one.
    fn are_asked_rather(&self, n_sections: usize) -> bool {
        PointSlopes::are_asked_of(self.lines.len() * n_sections, self.moving.len())
    }

    fn variables(&self) -> Vec<usize> {
        self.moving.iter().map(|(variable, _)| *variable).collect()
    }

    /// Whether the lines of the skin go through them at the parameters.
    fn are_at(&self, parameters: &[f64], skin: &NurbsSurface) -> bool {
        let (knots, net): (&KnotVector, _) = (skin.knots_v(), skin.control_points());
        let places: Vec<(usize, Vec<f64>)> = parameters
            .iter()
            .map(|&t| knots.with_basis(t, |span, basis| (span - knots.degree(), basis.to_vec())))
            .collect();
        let is_through = |(idx, line): (usize, &Vec<DVec4>)| {
            let at = |(first, basis): &(usize, Vec<f64>)| -> DVec4 {
                net.row(idx)[*first..].iter().zip(basis).map(|(&point, &n)| point * n).sum()
            };
            let found: Vec<DVec4> = places.iter().map(at).collect();
            line.len() == found.len() && are_near(&found, line)
        };
        !skin.is_rational() && self.lines.iter().enumerate().all(is_through)
    }

    /// Whether points that are at the place of a neighbour stay there, as what a rule says has no slope where they part.
    fn part_at(&self, steps: &SectionSteps) -> bool {
        steps.without_length().all(|(line, section)| {
            self.moving.iter().all(|(_, own)| {
                let speed = |section: usize| {
                    let found = own.iter().find(|own| (own.0, own.1) == (line, section));
                    found.map_or(DVec3::ZERO, |own| own.2)
                };
                speed(section) == speed(section + 1)
            })
        })
    }
}

/// What tells how sums of the control points of a skin grow with those of its sections.
#[derive(Debug)]
struct SkinGrowths {
    fit: Interpolator,
    parameters: Vec<f64>,
    /// By which the parameters move, if they do.
    steps: Option<SectionSteps>,
    /// Where they do the lines, as they are asked for.
    splines: Vec<OnceLock<Option<MovingSpline<'static>>>>,
    /// Control points of a line.
    n_columns: usize,
    given: GivenSections,
}

impl SkinGrowths {
    /// The slopes of a sum of control points with these factors, by each variable that moves any.
    fn slopes(&self, factors: &[f64]) -> Vec<DVec3> {
        let n_sections = self.parameters.len();
        let mut lines = vec![PointGrowths::default(); self.given.lines.len()];
        let mut by_parameter = vec![DVec3::ZERO; n_sections];
        let acting = factors.chunks_exact(self.n_columns).enumerate();
        for (line, own) in acting.filter(|(_, own)| own.iter().any(|factor| *factor != 0.0)) {
            lines[line].by_value = match (&self.steps, self.spline(line)) {
                (None, _) => self.fit.transposed(own.to_vec()).0,
                (Some(_), Some(spline)) => {
                    let (by_value, own) = spline.growths(own);
                    let pairs = by_parameter.iter_mut().zip(own);
                    pairs.for_each(|(sum, own)| *sum += own.truncate());
                    by_value
                }
                // No numbers are no derivatives.
                (Some(_), None) => vec![f64::NAN; n_sections],
            };
        }
        if let Some(steps) = &self.steps {
            for (line, growths) in lines.iter_mut().enumerate() {
                growths.steps = steps.growths(line, &by_parameter);
            }
        }
        let slope = |(_, own): &(usize, Vec<(usize, usize, DVec3)>)| {
            own.iter().map(|&(line, section, speed)| lines[line].with(section, speed)).sum()
        };
        self.given.moving.iter().map(slope).collect()
    }

    /// A line as its parameters move.
    fn spline(&self, line: usize) -> Option<&MovingSpline<'static>> {
        let made = || {
            let (fit, values) = ((&self.fit, Ends::Averaged), &self.given.lines[line]);
            let spline = MovingSpline::new(fit, &self.parameters, values, [DVec4::ZERO; 2]);
            spline.ok().flatten().map(MovingSpline::into_owned)
        };
        self.splines.get(line)?.get_or_init(made).as_ref()
    }
}
