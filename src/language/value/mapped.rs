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
    IntoValue, Record, Value, Vector,
    affine::{Differences, HALVINGS},
    affine_packs::{Packed, Reach, Way},
    given_points::{GivenPoint, GivenPoints},
    numbers::{NumberPlaces, OTHER_NUMBER},
    packed::{Growth, Pack},
};
use crate::kernel::{
    Curve, PointFactors, PointMap, PointSlopes, Surface, VariedCurve, VariedSurface,
};

/// Fewer variables cost less by themselves.
const FEWEST: usize = 4;

/// How a matrix is looked for: the way that serves most often and costs least comes first.
const WAYS: [MapWay; 3] = [
    MapWay { steps: Way::Turned(Reach::Narrow), is_mixed: false },
    MapWay { steps: Way::TurnedApart, is_mixed: false },
    MapWay { steps: Way::AsTheyAre, is_mixed: true },
];

#[derive(Clone, Copy)]
struct MapWay {
    steps: Way,
    /// Whether coordinates mix, so that a point is moved along each of them.
    is_mixed: bool,
}

impl Differences<'_> {
    /// The answer with slopes through the matrix of its points by those given; none where something else moves, or the
    /// answer is not linear in them, or steps of variables cost less.
    pub(super) fn through_points(&mut self, n_variables: usize) -> Option<Value> {
        let given = GivenPoints::new(self.args, n_variables)?;
        let n_moving = given.n_variables();
        if n_moving < FEWEST {
            return None;
        }
        let answer = NumberPlaces::of([&self.base]);
        let mut was_in_part = false;
        for way in WAYS {
            let has_sense = match way.steps {
                Way::TurnedApart => was_in_part && given.places.has_lists(),
                _ => true,
            };
            if !has_sense {
                continue;
            }
            let Some((map, is_in_part)) = self.map((&given, n_moving), &answer, way) else {
                continue;
            };
            was_in_part |= is_in_part;
            // What grows with a product of points of several sets is linear in those of each.
            let n_sets = given.sets.len();
            let is_held_apart = |own: &mut Self| {
                1 < n_sets
                    && n_sets <= n_moving / FEWEST
                    && (0..n_sets).all(|set| own.is_held((&given, Some(set)), &map, &answer))
            };
            if self.is_held((&given, None), &map, &answer) || is_held_apart(self) {
                return Made { map, n_points: 0 }.value(&self.base);
            }
        }
        None
    }

    /// The matrix as one way tells it, and whether points were taken to reach a part of the answer each; none where that
    /// takes more steps than the variables.
    fn map(
        &mut self,
        (given, n_moving): (&GivenPoints, usize),
        answer: &NumberPlaces,
        way: MapWay,
    ) -> Option<(Arc<PointMap>, bool)> {
        let (mut is_in_part, mut n_steps) = (false, 0);
        let (mut alike, mut mixed) = (Vec::new(), Vec::new());
        for axis in if way.is_mixed { 0..3 } else { 0..1 } {
            let is_along = |own: &&GivenPoint| !way.is_mixed || own.is_along[axis];
            let points: Vec<GivenPoint> = given.moving.iter().filter(is_along).cloned().collect();
            if points.is_empty() {
                continue;
            }
            let mut moving = given.along(axis, &points);
            if matches!(way.steps, Way::TurnedApart) {
                moving = moving.apart();
            }
            let first = moving.first_ones();
            let Packed { known, packs, .. } = self.packed(&moving, &first, way.steps)?;
            is_in_part |= packs.iter().any(Pack::is_in_part);
            n_steps += known.len() + packs.len();
            if n_moving < n_steps {
                return None;
            }
            let measured = self.measured(&moving, &packs, answer)?;
            for Growth { variable, step, growth } in known.into_iter().chain(measured).flatten() {
                for (at, grown) in growth {
                    let (along, made) = answer.numbers[at];
                    let (point, slope) = (points[variable].point, grown / step);
                    if way.is_mixed && along != OTHER_NUMBER {
                        let mut own = DMat3::ZERO;
                        own.col_mut(axis)[along] = slope;
                        mixed.push((made, point, own));
                    } else if along == 0 {
                        alike.push((made, point, slope));
                    }
                }
            }
        }
        let factors = match way.is_mixed {
            true => PointFactors::Mixed(mixed),
            false => PointFactors::Alike(alike),
        };
        let map = PointMap::new(given.sets.clone(), answer.points.len(), factors).ok()?;
        Some((Arc::new(map), is_in_part))
    }

    /// Whether all points at once, or those of a set, each moved in its own way, make of the answer what a matrix says.
    fn is_held(
        &mut self,
        (given, set): (&GivenPoints, Option<usize>),
        map: &PointMap,
        answer: &NumberPlaces,
    ) -> bool {
        let Some((args, directions)) = given.at_once(set) else { return false };
        let mut at_once = Differences {
            args: &args,
            base: self.base.clone(),
            run: &mut *self.run,
            plain: self.plain.clone(),
        };
        // Of a set none of whose points stands for itself there is nothing to hold.
        let Some(unit) = at_once.unit_step(0) else { return set.is_some() };
        for halvings in &HALVINGS[2..] {
            let step = libm::ldexp(unit, -halvings);
            let Ok(found) = at_once.growth(&[(0, step)]) else { continue };
            let mut expected = vec![0.0; found.len()];
            let steps: Vec<DVec3> = directions.iter().map(|direction| *direction * step).collect();
            let grown = map.grown(&steps);
            for (expected, (axis, point)) in expected.iter_mut().zip(&answer.numbers) {
                if *axis != OTHER_NUMBER {
                    *expected = grown[*point][*axis];
                }
            }
            return at_once.is_near(&found, &expected);
        }
        false
    }
}

/// An answer whose points a matrix makes, one behind the other.
struct Made {
    map: Arc<PointMap>,
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
            Value::List(items) => {
                let items: Option<Vec<Value>> = items.values().map(|item| self.value(&item)).collect();
                Value::list(items?)
            }
            Value::Record(record) => {
                let field = |(label, value)| Some((Arc::from(label), self.value(value)?));
                let fields: Option<Vec<(Arc<str>, Value)>> = record.iter().map(field).collect();
                Value::Record(Arc::new(Record::new(fields?)))
            }
            other => {
                self.next(NumberPlaces::of([other]).points.len());
                other.clone()
            }
        })
    }
}
