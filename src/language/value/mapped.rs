//! Slopes of what an operation makes linearly of control points and lists of points: through the matrix that steps of
//! these tell.
//!
//! However many variables move the points, and however each does, a step of a point tells what it does to the answer; where
//! points reach different parts of that, or an operation does the same to each coordinate, one step tells of several. What
//! the variables do is found through the matrix when somebody asks. That an operation is linear in its points is supposed
//! only: a step of all of them at once, along all coordinates, must make of the answer what the matrix says.

use std::{ops::Range, sync::Arc};

use glam::{DMat3, DVec3};

use super::{
    IntoValue, List, Value, Vector,
    affine::{Differences, HALVINGS},
    affine_packs::{Packed, Reach, Way},
    given_points::{GivenPoint, GivenPoints},
    numbers::{NumberPlaces, OTHER_NUMBER},
    packed::{Growth, Pack},
};
use crate::kernel::{
    Curve, PointEntries, PointFactors, PointMap, PointSlopes, Surface, VariedCurve, VariedSurface,
};

/// Fewer variables cost less by themselves.
pub(super) const FEWEST: usize = 4;

/// How a matrix is looked for: the way that costs least comes first.
const WAYS: [MapWay; 6] = [
    MapWay::Told,
    MapWay::SameShape,
    MapWay::Selected,
    MapWay::Steps { steps: Way::Turned(Reach::Wide), is_mixed: false },
    MapWay::Steps { steps: Way::TurnedApart, is_mixed: false },
    MapWay::Steps { steps: Way::AsTheyAre, is_mixed: true },
];

#[derive(Clone, Copy)]
enum MapWay {
    /// The operation tells it.
    Told,
    /// Each curve or surface of the answer is one of the given ones, on other knots or a part of it.
    SameShape,
    /// Each point of the answer moves with one of the given points.
    Selected,
    /// By steps of points.
    Steps {
        steps: Way,
        /// Whether coordinates mix, so that a point is moved along each of them.
        is_mixed: bool,
    },
}

/// The places of an answer's numbers, and what it is made of.
pub(super) struct Question<'g> {
    pub(super) given: &'g GivenPoints,
    pub(super) answer: NumberPlaces,
    /// By how many variables points move.
    pub(super) n_moving: usize,
}

impl Differences<'_> {
    /// The answer with slopes through the matrix of its points by those given; none where something else moves, or the
    /// answer is not linear in them, or steps of variables cost less.
    pub(super) fn through_points(
        &mut self,
        n_variables: usize,
        told: Option<PointEntries>,
    ) -> Option<Value> {
        let given = &GivenPoints::new(self.args, n_variables, told.is_some())?;
        let n_moving = given.n_variables();
        if n_moving < FEWEST {
            return None;
        }
        let question = Question { given, answer: NumberPlaces::of([&self.base]), n_moving };
        let mut was_in_part = false;
        for way in WAYS {
            let steps = match way {
                // Variables that move a point each take no more steps themselves.
                MapWay::Steps { .. } if given.sets.iter().all(PointSlopes::move_one_each) => break,
                MapWay::Steps { steps: Way::TurnedApart, .. }
                    if !was_in_part || !given.held.places.has_lists() =>
                {
                    continue;
                }
                MapWay::Steps { steps, is_mixed } => self.factors(&question, steps, is_mixed),
                MapWay::Told => told.as_ref().map(|told| (given.of_sets(told), false)),
                MapWay::SameShape | MapWay::Selected if !given.has_splines => break,
                MapWay::SameShape => self.same_shape(&question).map(|factors| (factors, false)),
                MapWay::Selected => self.selected(&question).map(|factors| (factors, false)),
            };
            let Some((factors, is_in_part)) = steps else { continue };
            was_in_part |= is_in_part;
            let n_made = question.answer.points.len();
            let map = Arc::new(PointMap::new(given.sets.clone(), n_made, factors).ok()?);
            if self.is_borne_out(&question, &map) {
                return Made { map, is_finite: None, n_points: 0 }.value(&self.base);
            }
        }
        None
    }

    /// The matrix as steps of points tell it, and whether these were taken to reach a part of the answer each; none where
    /// that takes more steps than the variables.
    fn factors(
        &mut self,
        question: &Question<'_>,
        way: Way,
        is_mixed: bool,
    ) -> Option<(PointFactors, bool)> {
        let Question { given, answer, n_moving } = question;
        let (mut is_in_part, mut n_steps) = (false, 0);
        let mut entries = match is_mixed {
            true => PointFactors::Mixed(Vec::new()),
            false => PointFactors::Alike(Vec::new()),
        };
        let by_axis: Vec<(usize, Vec<GivenPoint>)> = (0..if is_mixed { 3 } else { 1 })
            .map(|axis| {
                let is_along = |own: &&GivenPoint| !is_mixed || own.is_along[axis];
                (axis, given.moving.iter().filter(is_along).cloned().collect::<Vec<GivenPoint>>())
            })
            .filter(|(_, points)| !points.is_empty())
            .collect();
        for (n_before, (axis, points)) in by_axis.iter().enumerate() {
            let axis = *axis;
            let mut moving = given.along(axis, points);
            if matches!(way, Way::TurnedApart) {
                moving = moving.apart();
            }
            let first = moving.first_ones();
            let Packed { known, packs, .. } = self.packed(&moving, &first, way)?;
            let is_own_in_part = packs.iter().any(Pack::is_in_part);
            is_in_part |= is_own_in_part;
            n_steps += known.len() + packs.len();
            // Before they are taken, and as if the other coordinates took as many.
            if n_moving * (n_before + 1) < n_steps * by_axis.len() {
                return None;
            }
            let place = (axis, &points[..]);
            known.iter().flatten().for_each(|own| add(&mut entries, own, place, answer));
            if !is_mixed && !is_own_in_part && !known.is_empty() {
                // What mixes coordinates seems to reach all where two are moved along others.
                let map = PointMap::new(given.sets.clone(), answer.points.len(), entries.clone());
                let firsts: Vec<usize> =
                    known.iter().flatten().map(|own| points[own.variable].point).collect();
                let is_first = |own: &GivenPoint| firsts.contains(&own.point);
                if !self.is_held(question, &map.ok()?, &is_first) {
                    return None;
                }
            }
            let measured = self.measured(&moving, &packs, answer)?;
            measured.iter().flatten().for_each(|own| add(&mut entries, own, place, answer));
        }
        Some((entries, is_in_part))
    }

    /// Whether points at once, each moved in its own way, make of the answer what a matrix says: all of them, or, as what
    /// grows with a product of points of several sets is linear in those of each, those of one set after the other.
    fn is_borne_out(&mut self, question: &Question<'_>, map: &PointMap) -> bool {
        let n_sets = question.given.sets.len();
        let are_few = 1 < n_sets && n_sets <= question.n_moving / FEWEST;
        self.is_held(question, map, &|_| true)
            || are_few && (0..n_sets).all(|set| self.is_held(question, map, &|own| own.set == set))
    }

    /// Whether some points at once, each moved in its own way, make of the answer what a matrix says.
    fn is_held(
        &mut self,
        Question { given, answer, .. }: &Question<'_>,
        map: &PointMap,
        is_wanted: &dyn Fn(&GivenPoint) -> bool,
    ) -> bool {
        if !given.moving.iter().any(is_wanted) {
            return true;
        }
        let of = |idx: usize, own: &GivenPoint| {
            if is_wanted(own) { own.own_step(idx) } else { DVec3::ZERO }
        };
        let (direction, directions) = given.at_once(of);
        let grown = self.grown_along(&given.held, &direction, (1.0, &HALVINGS[2..]));
        let Some((step, found)) = grown else { return false };
        let mut expected = vec![0.0; found.len()];
        let steps: Vec<DVec3> = directions.iter().map(|direction| *direction * step).collect();
        let grown = map.grown(&steps);
        for (expected, (axis, point)) in expected.iter_mut().zip(&answer.numbers) {
            if *axis != OTHER_NUMBER {
                *expected = grown[*point][*axis];
            }
        }
        self.is_near(&found, &expected)
    }
}

/// Adds what a step of a point along a coordinate tells to the entries of a matrix.
fn add(
    entries: &mut PointFactors,
    Growth { variable, step, growth }: &Growth,
    (axis, points): (usize, &[GivenPoint]),
    answer: &NumberPlaces,
) {
    let point = points[*variable].point;
    for (at, grown) in growth {
        let (along, made) = answer.numbers[*at];
        match entries {
            PointFactors::Mixed(all) if along != OTHER_NUMBER => {
                let mut entry = DMat3::ZERO;
                entry.col_mut(axis)[along] = grown / step;
                all.push((made, point, entry));
            }
            PointFactors::Alike(all) if along == 0 => all.push((made, point, grown / step)),
            _ => {}
        }
    }
}

/// An answer whose points a matrix makes, one behind the other.
struct Made {
    map: Arc<PointMap>,
    /// Whether all slopes are numbers, so that points need not be made to know that; where lists of them were met.
    is_finite: Option<bool>,
    /// How many points and other numbers have been told.
    n_points: usize,
}

impl Made {
    fn next(&mut self, n_points: usize) -> Range<usize> {
        let from = self.n_points;
        self.n_points += n_points;
        from..self.n_points
    }

    fn slopes(&mut self, n_points: usize) -> PointSlopes {
        let made = self.next(n_points);
        self.map.slopes_of(made)
    }

    fn has_finite_slopes(&mut self) -> bool {
        *self.is_finite.get_or_insert_with(|| self.map.has_finite_slopes())
    }

    /// Points with their slopes, each made when it is asked for.
    fn points(&mut self, items: &List) -> List {
        let (from, plain) = (self.next(items.len()).start, items.clone());
        let map = Arc::clone(&self.map);
        let point = move |idx: usize| match &plain[idx] {
            Value::Point(own) => match map.point(from + idx, *own) {
                Ok(Some(jets)) => Vector::Jets(Box::new(jets)).into_value(),
                Ok(None) => Value::Point(*own),
                Err(_) => unreachable!("slopes that are known to be finite"),
            },
            other => other.clone(),
        };
        List::made(items.len(), Box::new(point))
    }

    /// A value with the slopes of its points; none where they are no numbers.
    fn value(&mut self, value: &Value) -> Option<Value> {
        Some(match value {
            Value::Point(own) => {
                let made = self.next(1);
                match self.map.point(made.start, *own).ok()? {
                    Some(jets) => Vector::Jets(Box::new(jets)).into_value(),
                    None => value.clone(),
                }
            }
            Value::Curve(Curve::Nurbs(curve)) => {
                let slopes = self.slopes(curve.control_points().len());
                if slopes.is_fixed() {
                    return Some(value.clone());
                }
                Value::JetCurve(Arc::new(VariedCurve::new(Arc::clone(curve), slopes).ok()?))
            }
            Value::Surface(Surface::Nurbs(surface)) => {
                let slopes = self.slopes(surface.control_points().as_slice().len());
                if slopes.is_fixed() {
                    return Some(value.clone());
                }
                Value::JetSurface(Arc::new(VariedSurface::new(Arc::clone(surface), slopes).ok()?))
            }
            Value::List(items) if are_points(items) && self.has_finite_slopes() => {
                Value::List(self.points(items))
            }
            Value::List(items) => {
                let items: Option<Vec<Value>> =
                    items.values().map(|item| self.value(&item)).collect();
                Value::list(items?)
            }
            Value::Record(record) => {
                Value::Record(Arc::new(record.mapped(|value| self.value(value))?))
            }
            other => {
                self.next(NumberPlaces::of([other]).points.len());
                other.clone()
            }
        })
    }
}

fn are_points(items: &List) -> bool {
    items.iter().all(|item| matches!(item, Value::Point(_)))
}
