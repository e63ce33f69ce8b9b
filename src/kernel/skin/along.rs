//! Ways from section to section: splines along v through control points.

use glam::{DVec3, DVec4};

use crate::{CountError, Ends, GeomError, InputError, Interpolator, KnotVector, NurbsCurve};

/// How the lines of control points run from section to section.
///
/// A line through each pair of points of two sections makes a ruled surface, a cubic through those of
/// four a smooth one:
///
/// ```
/// use virote_kernel::{Along, CompatibleSections, NurbsCurve, glam::DVec3};
///
/// let rung = |y: f64| NurbsCurve::line(DVec3::Y * y, DVec3::Y * y + DVec3::X + DVec3::Z * y * y);
/// let sections = CompatibleSections::new(&[rung(0.0)?, rung(1.0)?, rung(2.0)?])?;
/// let parabolas = Along::free(&[0.0, 0.5, 1.0], 2)?;
/// let surface = sections.skinned(&parabolas)?.surface;
/// assert!(surface.point_at(1.0, 0.25).distance(DVec3::new(1.0, 0.5, 0.25)) < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Along {
    knots: KnotVector,
    n_sections: usize,
    way: Lofting,
}

#[derive(Clone, Debug)]
enum Lofting {
    /// Through the sections, and nothing else; of a closed one round and round.
    Through(Interpolator),
    /// With the derivatives by v that are given at the ends, one a line.
    WithSlopes { fit: Interpolator, start: Option<Vec<DVec4>>, end: Option<Vec<DVec4>> },
    /// Along the tangents of a spine.
    Spine { fit: Interpolator, places: Vec<DVec3>, tangents: Vec<DVec3>, is_closed: bool },
    /// Without a swing beyond two neighbours.
    Monotone { parameters: Vec<f64>, is_closed: bool },
}

impl Along {
    /// Splines of the degree, or of the highest that so few sections determine, over averaged
    /// knots: Piegl & Tiller, *The NURBS Book*, §10.3.
    ///
    /// # Errors
    /// Those of [`Interpolator::new`].
    pub fn free(parameters: &[f64], degree: usize) -> Result<Self, GeomError> {
        let fit = Interpolator::new(parameters, degree, Ends::Averaged)?;
        let (knots, n_sections) = (fit.knots().clone(), parameters.len());
        Ok(Self { knots, n_sections, way: Lofting::Through(fit) })
    }

    /// Periodic splines; the last parameter is where the first section comes again.
    ///
    /// # Errors
    /// Those of [`Interpolator::periodic`].
    pub fn closed(parameters: &[f64], degree: usize) -> Result<Self, GeomError> {
        let fit = Interpolator::periodic(parameters, degree)?;
        let (knots, n_sections) = (fit.knots().clone(), parameters.len() - 1);
        Ok(Self { knots, n_sections, way: Lofting::Through(fit) })
    }

    /// As [`Self::free`], with homogeneous derivatives by v at one end or both.
    ///
    /// # Errors
    /// Those of [`Interpolator::with_end_slopes`].
    pub fn with_slopes(
        parameters: &[f64],
        degree: usize,
        [start, end]: [Option<Vec<DVec4>>; 2],
    ) -> Result<Self, GeomError> {
        let fit =
            Interpolator::with_end_slopes(parameters, degree, [start.is_some(), end.is_some()])?;
        let (knots, n_sections) = (fit.knots().clone(), parameters.len());
        Ok(Self { knots, n_sections, way: Lofting::WithSlopes { fit, start, end } })
    }

    /// Splines of degree 2 or 3 whose derivatives at every section point along the spine there,
    /// as long beside its own as the line is beside it.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (10.10) to (10.13). Of rational sections the weights
    /// stand still at the sections, which keeps the surface's own derivative along the spine.
    /// Of a closed skin the last parameter is where the first section comes again.
    ///
    /// # Errors
    /// Those of [`Interpolator::with_derivatives`]; [`InputError::CoincidentPoints`] for two
    /// neighbouring places of the spine that are one.
    pub fn spine(
        parameters: &[f64],
        degree: usize,
        spine: &NurbsCurve,
        is_closed: bool,
    ) -> Result<Self, GeomError> {
        let fit = Interpolator::with_derivatives(parameters, degree)?;
        let both = parameters.iter().map(|&t| {
            let derivatives = spine.derivatives_at(t, 1);
            (derivatives[0], derivatives[1])
        });
        let (places, tangents): (Vec<DVec3>, Vec<DVec3>) = both.unzip();
        if let Some(first) = places.windows(2).position(|pair| pair[0] == pair[1]) {
            return Err(InputError::CoincidentPoints { first, second: first + 1 }.into());
        }
        let (knots, n) = (fit.knots().clone(), parameters.len());
        let n_sections = n - usize::from(is_closed);
        Ok(Self { knots, n_sections, way: Lofting::Spine { fit, places, tangents, is_closed } })
    }

    /// C1 cubics of which each coordinate stays between its values at two neighbouring sections.
    ///
    /// Fritsch & Butland, *A method for constructing local monotone piecewise cubic
    /// interpolants*, SIAM J. Sci. Stat. Comput. 5 (1984), with the ends of Fritsch & Carlson (1980).
    ///
    /// # Errors
    /// [`CountError::TooFewPoints`] below two parameters, and those of [`KnotVector::new`].
    pub fn monotone(parameters: &[f64], is_closed: bool) -> Result<Self, GeomError> {
        let got = parameters.len();
        if got < 2 {
            return Err(CountError::TooFewPoints { got, needed: 2 }.into());
        }
        let (start, end) = (parameters[0], parameters[parameters.len() - 1]);
        let inner = parameters[1..parameters.len() - 1].iter().flat_map(|&t| [t, t]);
        let knots: Vec<f64> = [start; 4].into_iter().chain(inner).chain([end; 4]).collect();
        let knots = KnotVector::new(3, knots)?;
        let n_sections = parameters.len() - usize::from(is_closed);
        let way = Lofting::Monotone { parameters: parameters.to_vec(), is_closed };
        Ok(Self { knots, n_sections, way })
    }

    /// The knots along v.
    #[must_use]
    pub fn knots(&self) -> &KnotVector {
        &self.knots
    }

    /// The control points along v of a line, the `index`-th, through its points in all sections.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless there is one a section.
    pub(super) fn through(&self, index: usize, line: &[DVec4]) -> Result<Vec<DVec4>, GeomError> {
        let (got, needed) = (line.len(), self.n_sections);
        if got != needed {
            return Err(CountError::WrongCount { what: "sections", needed, got }.into());
        }
        match &self.way {
            Lofting::Through(fit) => fit.through(line),
            Lofting::WithSlopes { fit, start, end } => {
                let slope = |all: &Option<Vec<DVec4>>| all.as_ref().map(|slopes| slopes[index]);
                fit.with_slopes_at_ends(line, [slope(start), slope(end)])
            }
            Lofting::Spine { fit, places, tangents, is_closed } => {
                let mut line = line.to_vec();
                if *is_closed {
                    line.push(line[0]);
                }
                fit.with_slopes(&line, &along_spine(&line, places, tangents, *is_closed))
            }
            Lofting::Monotone { parameters, is_closed } => {
                let mut line = line.to_vec();
                if *is_closed {
                    line.push(line[0]);
                }
                Ok(monotone(parameters, &line, *is_closed))
            }
        }
    }
}

/// The spine's tangents, scaled for a line: (10.10) and (10.11).
fn along_spine(
    line: &[DVec4],
    places: &[DVec3],
    tangents: &[DVec3],
    is_closed: bool,
) -> Vec<DVec4> {
    let place = |k: usize| crate::homogeneous::place(line[k]);
    let steps = |k: usize| (place(k).distance(place(k + 1)), places[k].distance(places[k + 1]));
    let last = line.len() - 1;
    let scaled = |k: usize| {
        let before = match k {
            0 if is_closed => steps(last - 1),
            0 => (0.0, 0.0),
            k => steps(k - 1),
        };
        let behind = match k {
            k if k < last => steps(k),
            _ if is_closed => steps(0),
            _ => (0.0, 0.0),
        };
        let factor = (before.0 + behind.0) / (before.1 + behind.1);
        (tangents[k] * (factor * line[k].w)).extend(0.0)
    };
    (0..=last).map(scaled).collect()
}

/// The control points over double knots: of every piece the two between its ends.
fn monotone(parameters: &[f64], values: &[DVec4], is_closed: bool) -> Vec<DVec4> {
    let last = values.len() - 1;
    let widths: Vec<f64> = parameters.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let slopes: Vec<DVec4> = (0..last).map(|k| (values[k + 1] - values[k]) / widths[k]).collect();
    let inner = |before: usize, behind: usize| {
        let (h, g) = (widths[before], widths[behind]);
        each(slopes[before], slopes[behind], |a, b| {
            if a * b <= 0.0 {
                return 0.0;
            }
            3.0 * (h + g) / ((2.0 * g + h) / a + (g + 2.0 * h) / b)
        })
    };
    let end = |first: usize, second: usize| {
        let (h, g) = (widths[first], widths[second]);
        each(slopes[first], slopes[second], |a, b| {
            let tangent = ((2.0 * h + g) * a - h * b) / (h + g);
            if tangent * a <= 0.0 {
                0.0
            } else if a * b <= 0.0 && 3.0 * a.abs() < tangent.abs() {
                3.0 * a
            } else {
                tangent
            }
        })
    };
    let derivative = |k: usize| match k {
        0 if is_closed => inner(last - 1, 0),
        k if k == last && is_closed => inner(last - 1, 0),
        _ if last == 1 => slopes[0],
        0 => end(0, 1),
        k if k == last => end(last - 1, last - 2),
        k => inner(k - 1, k),
    };
    let mut points = vec![values[0]];
    for k in 0..last {
        let third = widths[k] / 3.0;
        points.push(values[k] + derivative(k) * third);
        points.push(values[k + 1] - derivative(k + 1) * third);
    }
    points.push(values[last]);
    points
}

fn each(a: DVec4, b: DVec4, f: impl Fn(f64, f64) -> f64) -> DVec4 {
    DVec4::from_array(std::array::from_fn(|i| f(a[i], b[i])))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn monotone_in_x(parameters: &[f64], values: &[f64], is_closed: bool) -> Vec<f64> {
        let values: Vec<DVec4> = values.iter().map(|&x| DVec4::new(x, 0.0, 0.0, 1.0)).collect();
        let points = monotone(parameters, &values, is_closed);
        assert!(points.iter().all(|point| (point.w - 1.0).abs() < 1e-15 && point.y.abs() < 1e-15));
        points.iter().map(|point| point.x).collect()
    }

    #[track_caller]
    fn check(found: &[f64], expected: &[f64]) {
        assert_eq!(found.len(), expected.len());
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
    }

    /// Derivatives by Moler, *Numerical Computing with MATLAB*, §3.4: 6/7 in the middle, and 2.5 and 0 at the ends.
    #[test]
    fn derivatives_are_weighted_harmonic_means() {
        let found = monotone_in_x(&[0.0, 1.0, 3.0], &[0.0, 2.0, 3.0], false);
        check(&found, &[0.0, 2.5 / 3.0, 2.0 - 2.0 / 7.0, 2.0 + 4.0 / 7.0, 3.0, 3.0]);
        // Around a ring the joint has the slopes 0.5 before and 2 behind it, of widths 2 and 1.
        let joint = 9.0 / (4.0 / 0.5 + 5.0 / 2.0);
        let found = monotone_in_x(&[0.0, 1.0, 3.0], &[0.0, 2.0, 3.0], true);
        let last = 3.0 - 2.0 * joint / 3.0;
        check(&found, &[0.0, joint / 3.0, 2.0 - 2.0 / 7.0, 2.0 + 4.0 / 7.0, last, 3.0]);
    }

    #[test]
    fn where_values_turn_the_line_rests_and_its_end_is_no_steeper_than_three_slopes() {
        let found = monotone_in_x(&[0.0, 1.0, 2.0], &[0.0, 1.0, -9.0], false);
        // At the end ((2 + 1)·(−10) − 1)/2.
        check(&found, &[0.0, 1.0, 1.0, 1.0, -9.0 + 15.5 / 3.0, -9.0]);
    }

    #[test]
    fn even_values_go_on_a_straight_line() {
        let found = monotone_in_x(&[0.0, 1.0, 3.0, 3.5], &[1.0, 3.0, 7.0, 8.0], false);
        let thirds = [0.0, 1.0 / 3.0, 2.0 / 3.0, 5.0 / 3.0, 7.0 / 3.0, 9.5 / 3.0, 10.0 / 3.0, 3.5];
        check(&found, &thirds.map(|t| 1.0 + 2.0 * t));
        check(&monotone_in_x(&[0.0, 2.0], &[1.0, 4.0], false), &[1.0, 2.0, 3.0, 4.0]);
    }
}
