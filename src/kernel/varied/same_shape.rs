//! How control points of the same curve or surface on other knots, or of a part of it, are made of its own.
//!
//! A control point is the blossom of a piece at the p knots behind its own: whoever cuts, refines, reverses or
//! reparametrizes makes all of them so. Ramshaw, *Blossoms are polar forms* (1989).

use glam::DVec4;

use super::PointEntries;

use crate::{
    Direction, Interval, KnotVector, NurbsCurve, NurbsSurface, bezier::blossom_factors,
    tolerance::EXACT_RELATIVE,
};

/// Of a control point over knots, the first one over others that it is made of, and by how much of each.
pub(crate) type PointRow = (usize, Vec<f64>);

/// By how much each control point of a curve counts in those of another one: of the one that is made and of the one that
/// it is made of, with the factor. None unless the other one is the same curve, or a part of it, of the same degree or a higher one, with
/// its parameter as it is, or stretched over the whole domain in either direction.
///
/// The first half of a parabola:
///
/// ```
/// use virote_kernel::{NurbsCurve, factors_of_same_curve, glam::DVec3};
///
/// let curve = NurbsCurve::bezier(&[DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0), DVec3::X * 2.0])?;
/// let [half, _] = curve.split(0.5)?;
/// let factors = factors_of_same_curve(&curve, &half).expect("a part");
/// assert_eq!(factors, [(0, 0, 1.0), (1, 0, 0.5), (1, 1, 0.5), (2, 0, 0.25), (2, 1, 0.5), (2, 2, 0.25)]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[must_use]
pub fn factors_of_same_curve(given: &NurbsCurve, made: &NurbsCurve) -> Option<PointEntries> {
    let maps = ParameterMap::all(given.knots(), made.knots()).into_iter().flatten();
    let rows = maps.filter_map(|map| curve_rows(given, made, map)).next()?;
    let entries = rows.iter().enumerate().flat_map(|(i, (first, factors))| {
        factors.iter().enumerate().map(move |(k, &factor)| (i, first + k, factor))
    });
    Some(entries.filter(|entry| entry.2 != 0.0).collect())
}

/// Whether a curve is another one with the same parameter, and of the same degree, as far as control points tell.
pub(super) fn is_same_curve(given: &NurbsCurve, made: &NurbsCurve) -> bool {
    given.domain() == made.domain()
        && given.degree() == made.degree()
        && curve_rows(given, made, ParameterMap::SAME).is_some()
}

/// The same of surfaces.
pub(super) fn is_same_surface(given: &NurbsSurface, made: &NurbsSurface) -> bool {
    let pairs = [Direction::U, Direction::V].map(|along| [given.knots(along), made.knots(along)]);
    let is_on = |[given, made]: &[&KnotVector; 2]| {
        given.domain() == made.domain() && given.degree() == made.degree()
    };
    let rows = pairs.map(|[given, made]| all_rows(given, made, ParameterMap::SAME));
    let [Some(us), Some(vs)] = rows else { return false };
    pairs.iter().all(is_on) && surface_entries(given, made, [&us, &vs]).is_some()
}

/// The control points of a curve by those of another one; none unless they make them.
fn curve_rows(given: &NurbsCurve, made: &NurbsCurve, map: ParameterMap) -> Option<Vec<PointRow>> {
    let (points, wanted) = (given.control_points(), made.control_points());
    let allowed = EXACT_RELATIVE * size(points);
    let is_made = |i: usize, (first, factors): &PointRow| {
        let sum: DVec4 = points[*first..].iter().zip(factors).map(|(&own, &n)| own * n).sum();
        (sum - wanted[i]).abs().max_element() <= allowed
    };
    let row =
        |i: usize| point_row(given.knots(), made.knots(), i, map).filter(|row| is_made(i, row));
    (0..wanted.len()).map(row).collect()
}

fn all_rows(given: &KnotVector, made: &KnotVector, map: ParameterMap) -> Option<Vec<PointRow>> {
    (0..made.n_points()).map(|i| point_row(given, made, i, map)).collect()
}

/// The same of surfaces, whose control points are counted row by row.
///
/// The half of a bilinear surface along u:
///
/// ```
/// use virote_kernel::{Direction, Grid, NurbsSurface, factors_of_same_surface, glam::DVec3};
///
/// let net = Grid::from_fn(2, 2, |i, j| DVec3::new(i as f64, j as f64, (i * j) as f64));
/// let surface = NurbsSurface::bezier(&net)?;
/// let [half, _] = surface.split(Direction::U, 0.5)?;
/// let factors = factors_of_same_surface(&surface, &half).expect("a part");
/// let last: Vec<_> = factors.into_iter().filter(|entry| entry.0 == 3).collect();
/// assert_eq!(last, [(3, 1, 0.5), (3, 3, 0.5)]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[must_use]
pub fn factors_of_same_surface(given: &NurbsSurface, made: &NurbsSurface) -> Option<PointEntries> {
    let rows_of = |along: Direction| -> Vec<Vec<PointRow>> {
        let (given, made) = (given.knots(along), made.knots(along));
        let maps = ParameterMap::all(given, made).into_iter().flatten();
        maps.filter_map(|map| all_rows(given, made, map)).collect()
    };
    let [all_u, all_v] = [Direction::U, Direction::V].map(rows_of);
    let mut pairs = all_u.iter().flat_map(|us| all_v.iter().map(move |vs| [&us[..], &vs[..]]));
    pairs.find_map(|rows| surface_entries(given, made, rows))
}

/// The control points of a surface by those of another one; none unless they make them.
fn surface_entries(
    given: &NurbsSurface,
    made: &NurbsSurface,
    [us, vs]: [&[PointRow]; 2],
) -> Option<PointEntries> {
    let (points, wanted) = (given.control_points(), made.control_points());
    let allowed = EXACT_RELATIVE * size(points.as_slice());
    let mut entries = PointEntries::new();
    for (i, (first_u, by_u)) in us.iter().enumerate() {
        for (j, (first_v, by_v)) in vs.iter().enumerate() {
            let (at, mut sum) = (i * wanted.n_columns() + j, DVec4::ZERO);
            for (k, of_u) in by_u.iter().enumerate() {
                for (l, of_v) in by_v.iter().enumerate() {
                    let (row, column, factor) = (first_u + k, first_v + l, of_u * of_v);
                    if factor != 0.0 {
                        sum += points.get(row, column) * factor;
                        entries.push((at, row * points.n_columns() + column, factor));
                    }
                }
            }
            if allowed < (sum - wanted.get(i, j)).abs().max_element() {
                return None;
            }
        }
    }
    Some(entries)
}

fn size(points: &[DVec4]) -> f64 {
    points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max)
}

/// The parameter of one curve by that of another, which is the same curve or a part of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ParameterMap {
    /// Where the domain of the other goes; none where the parameter stays.
    onto: Option<(Interval, [f64; 2])>,
}

impl ParameterMap {
    /// The parameter as it is.
    pub(crate) const SAME: Self = Self { onto: None };

    /// Those that there may be: the parameter as it is, and the other domain stretched over the whole one.
    fn all(given: &KnotVector, made: &KnotVector) -> [Option<Self>; 3] {
        let (whole, own) = (given.domain(), made.domain());
        let is_inside = [own.start(), own.end()].map(|end| whole.contains(given.snapped(end)));
        let over = |ends| Some(Self { onto: Some((own, ends)) });
        if made.degree() < given.degree() {
            return [None; 3];
        }
        [
            (is_inside == [true; 2]).then_some(Self::SAME),
            if own == whole { None } else { over([whole.start(), whole.end()]) },
            over([whole.end(), whole.start()]),
        ]
    }

    fn at(self, t: f64) -> f64 {
        match self.onto {
            None => t,
            Some((own, [start, end])) => {
                let fraction = own.fraction_of(t);
                start * (1.0 - fraction) + end * fraction
            }
        }
    }
}

/// Of a control point over knots, the first one over those of the whole that it is made of, and by how much of each: the
/// blossom at its p knots. None where no piece of it has a length.
pub(crate) fn point_row(
    given: &KnotVector,
    made: &KnotVector,
    i: usize,
    map: ParameterMap,
) -> Option<PointRow> {
    let (all, q) = (made.as_slice(), made.degree());
    let is_wide = |span: &usize| all[*span] < all[span + 1];
    let support = (i.max(q)..=(i + q).min(made.n_points() - 1)).filter(is_wide);
    let middle = support.min_by_key(|span| (2 * span).abs_diff(2 * i + q))?;
    let center = map.at(made.span_interval(middle).at(0.5));
    let span = given.span_at(center);
    let argument = |&t: &f64| if map.onto.is_none() { t } else { given.snapped(map.at(t)) };
    let mut arguments: Vec<f64> = all[i + 1..=i + q].iter().map(argument).collect();
    let factors = if q == given.degree() {
        // At the ends of the span one point goes on alone, which costs least where that is done first.
        let ends = [given.as_slice()[span], given.as_slice()[span + 1]];
        arguments.sort_by_key(|t| ends.contains(t));
        blossom_factors(given, span, &arguments)
    } else {
        elevated_factors(given, (span, center), &arguments)
    };
    Some((span - given.degree(), factors))
}

/// By how much each of the control points that act over a span counts in the blossom of the piece as one of a higher degree
/// q, at as many arguments: Σₖ eₖ(δ)/(q choose k)·C⁽ᵏ⁾/k!, where eₖ is the k-th elementary symmetric polynomial of their
/// distances from a place.
///
/// Ramshaw, *Blossoms are polar forms* (1989).
fn elevated_factors(knots: &KnotVector, (span, at): (usize, f64), arguments: &[f64]) -> Vec<f64> {
    let p = knots.degree();
    let mut symmetric = vec![0.0; p + 1];
    symmetric[0] = 1.0;
    for argument in arguments {
        for k in (1..=p).rev() {
            symmetric[k] += (argument - at) * symmetric[k - 1];
        }
    }
    let derivatives = knots.basis_derivatives_on(span, at, p);
    let mut factors = vec![0.0; p + 1];
    // k!·(q choose k) = q·(q − 1)⋯(q − k + 1).
    let mut falling = 1.0;
    for (k, sum) in symmetric.into_iter().enumerate() {
        let share = sum / falling;
        factors.iter_mut().zip(derivatives.row(k)).for_each(|(own, n)| *own += share * n);
        falling *= (arguments.len() - k) as f64;
    }
    factors
}

#[cfg(test)]
mod tests {
    use glam::DVec4;

    use super::{factors_of_same_curve, factors_of_same_surface, is_same_curve};
    use crate::{
        Direction, Grid, Interval, KnotVector, NurbsCurve, NurbsSurface, PointEntries,
        make_compatible,
    };

    fn point(i: usize, shift: f64) -> DVec4 {
        let t = i as f64 + shift;
        DVec4::new(libm::sin(3.0 * t), libm::cos(2.0 * t), t, 1.0 + 0.2 * libm::sin(t))
    }

    fn curve(shift: f64) -> NurbsCurve {
        let knots = vec![0.0, 0.0, 0.0, 0.0, 0.3, 0.5, 0.5, 0.9, 1.0, 1.0, 1.0, 1.0];
        let knots = KnotVector::new(3, knots).unwrap();
        NurbsCurve::new(knots, (0..8).map(|i| point(i, shift)).collect()).unwrap()
    }

    /// The entries, found at one curve or surface, must make of another one on its knots what the operation does.
    #[track_caller]
    fn check(entries: Option<PointEntries>, given: &[DVec4], made: &[DVec4]) {
        let mut sums = vec![DVec4::ZERO; made.len()];
        for (i, j, factor) in entries.expect("the same shape") {
            sums[i] += given[j] * factor;
        }
        for (sum, made) in sums.iter().zip(made) {
            assert!((sum - made).abs().max_element() < 1e-12, "{sum} is not {made}");
        }
    }

    #[test]
    fn what_is_made_of_one_curve_tells_what_is_made_of_others() {
        let interval = |start, end| Interval::new(start, end).unwrap();
        let edits: [&dyn Fn(&NurbsCurve) -> NurbsCurve; 7] = [
            &|own| own.insert_knots(&[0.2, 0.5, 0.7]).unwrap(),
            &|own| own.split(0.4).unwrap()[0].clone(),
            &|own| own.split(0.5).unwrap()[1].clone(),
            &|own| own.trimmed(interval(0.1, 0.95)).unwrap(),
            &NurbsCurve::reversed,
            &|own| own.reparametrized(interval(-2.0, 7.0)),
            &|own| own.elevate_degree(5).unwrap(),
        ];
        let (one, other) = (curve(0.0), curve(0.4));
        for edit in edits {
            let entries = factors_of_same_curve(&one, &edit(&one));
            check(entries, other.control_points(), edit(&other).control_points());
        }
        let flat = NurbsCurve::new(
            KnotVector::uniform(3, 8).unwrap(),
            (0..8).map(|i| point(i, 0.0)).collect(),
        );
        let flat = flat.unwrap();
        check(
            factors_of_same_curve(&flat, &flat.clamped()),
            flat.control_points(),
            flat.clamped().control_points(),
        );
    }

    #[test]
    fn what_is_no_such_part_has_no_entries() {
        let (one, other) = (curve(0.0), curve(0.4));
        assert!(factors_of_same_curve(&one, &other).is_none());
        assert!(factors_of_same_curve(&one.elevate_degree(4).unwrap(), &one).is_none());
        assert!(is_same_curve(&one, &one.insert_knots(&[0.6]).unwrap()));
        assert!(!is_same_curve(&one, &one.reversed()));
        assert!(!is_same_curve(&one, &one.split(0.5).unwrap()[0]));
        let both = make_compatible(&[one.clone(), other]).unwrap();
        assert!(factors_of_same_curve(&both[0], &both[1]).is_none());
    }

    #[test]
    fn surfaces_are_edited_along_both_directions() {
        let surface = |shift: f64| {
            let net = Grid::from_fn(8, 4, |i, j| point(4 * i + j, shift));
            let knots = KnotVector::bezier(3).unwrap();
            NurbsSurface::new(curve(0.0).knots().clone(), knots, net).unwrap()
        };
        let edit = |own: &NurbsSurface| {
            let [_, half] = own.split(Direction::U, 0.4).unwrap();
            half.elevate_degree(Direction::V, 4).unwrap().reversed(Direction::U)
        };
        let (one, other) = (surface(0.0), surface(0.4));
        let half = |own: &NurbsSurface| own.split(Direction::V, 0.3).unwrap()[1].clone();
        check(
            factors_of_same_surface(&one, &half(&one)),
            other.control_points().as_slice(),
            half(&other).control_points().as_slice(),
        );
        // A part that is turned around is neither the surface as it is nor all of it.
        assert!(factors_of_same_surface(&one, &edit(&one)).is_none());
        assert!(factors_of_same_surface(&one, &other).is_none());
    }
}
