//! Slopes of what is affine, from steps of several variables at once.

use super::{
    affine::{Differences, HALVINGS, all_moved},
    numbers::NumberPlaces,
    packed::{Growth, MovingNumbers, Pack},
    reach::{Moved, PointReach},
};

/// How many times fewer steps variables have to take that are moved as they are, before that is tried.
const FEWER_AS_THEY_ARE: usize = 4;

/// The same of those that are moved beside others that reach other points.
const FEWER_IN_PART: usize = 5;

/// By how many control points more is reached than told beside where a curve is cut.
const WIDER: f64 = 3.0;

/// How variables are moved together.
#[derive(Clone, Copy)]
pub(super) enum Way {
    /// Each along a coordinate that is free.
    Turned(Reach),
    /// The same, with what each curve or surface of a list reaches told by its own control points.
    TurnedApart,
    /// Each as it is, beside those that reach other points.
    AsTheyAre,
}

/// Which points of an answer a control point may reach.
#[derive(Clone, Copy)]
pub(super) enum Reach {
    /// Those that the first ones tell.
    Narrow,
    /// A few more.
    Wide,
    Any,
}

impl Way {
    /// The way that serves most often and costs least comes first.
    const ALL: [Self; 5] = [
        Self::Turned(Reach::Narrow),
        Self::TurnedApart,
        Self::AsTheyAre,
        Self::Turned(Reach::Wide),
        Self::Turned(Reach::Any),
    ];
}

/// Variables by those that are moved together.
pub(super) struct Packed {
    pub(super) answer: NumberPlaces,
    /// What those do that were moved first.
    pub(super) known: Vec<Vec<Growth>>,
    /// The others.
    pub(super) packs: Vec<Pack>,
}

impl Differences<'_> {
    /// The same from steps of several variables at once; none where they do not go together.
    pub(super) fn together(&mut self, n_variables: usize) -> Option<Vec<Growth>> {
        let moving = MovingNumbers::new(self.args, all_moved(self.args, &[])?, n_variables)?;
        let first = moving.first_ones();
        let (mut has_parts, mut has_wholes) = (false, false);
        for way in Way::ALL {
            let has_sense = match way {
                Way::Turned(Reach::Any) => !has_wholes,
                Way::Turned(Reach::Wide) => has_parts,
                Way::TurnedApart => has_parts && moving.has_lists(),
                Way::Turned(Reach::Narrow) | Way::AsTheyAre => !first.is_empty(),
            };
            if !has_sense {
                continue;
            }
            let packed = match way {
                Way::TurnedApart => {
                    let apart = moving.apart();
                    self.packed(&apart, &apart.first_ones(), way)
                }
                _ => self.packed(&moving, &first, way),
            };
            if let Some(packed) = packed {
                let is_turning = !matches!(way, Way::AsTheyAre);
                let is_in_part = packed.packs.iter().any(Pack::is_in_part);
                has_parts |= is_in_part;
                has_wholes |= !is_in_part;
                // What mixes coordinates seems to reach all where two are moved along others.
                let is_mixed = is_turning
                    && !is_in_part
                    && packed
                        .known
                        .iter()
                        .any(|own| 1 < own.len() && !self.are_straight(own.iter()));
                if !is_mixed && let Some(lines) = self.lines_of(&moving, packed) {
                    return Some(lines);
                }
            }
        }
        None
    }

    /// Variables by those that are moved together, the first ones moved; none where hardly any go together.
    pub(super) fn packed(
        &mut self,
        moving: &MovingNumbers,
        first: &[[Moved; 2]],
        way: Way,
    ) -> Option<Packed> {
        let answer = NumberPlaces::of([&self.base]);
        let is_turning = !matches!(way, Way::AsTheyAre);
        let margin = match way {
            Way::Turned(Reach::Any) => None,
            Way::Turned(Reach::Wide) => Some(WIDER),
            Way::Turned(Reach::Narrow) | Way::TurnedApart | Way::AsTheyAre => Some(0.0),
        };
        let first = if margin.is_some() { first } else { &[] };
        let moved_first: Vec<usize> = first.iter().flatten().map(|moved| moved.variable).collect();
        let packs = moving.packs(&moved_first, &[], &answer, is_turning);
        let known = self.measured(moving, &packs, &answer)?;
        let grown =
            |moved: Moved| known.iter().flatten().find(|line| line.variable == moved.variable);
        let reach = |pair: &[Moved; 2]| {
            let [a, b] = [grown(pair[0])?, grown(pair[1])?];
            let reach = PointReach::new(pair, [&a.growth, &b.growth], (&answer, margin?));
            Some((pair[0], reach))
        };
        let reaches = first.iter().map(reach).collect::<Option<Vec<_>>>()?;
        let mut others = moving.variables();
        others.retain(|variable| !moved_first.contains(variable));
        let packs = moving.packs(&others, &reaches, &answer, is_turning);
        let fewer = match packs.iter().any(Pack::is_in_part) {
            true => FEWER_IN_PART,
            false if is_turning => 1,
            false => FEWER_AS_THEY_ARE,
        };
        let is_fewer = fewer * packs.len() < others.len();
        is_fewer.then_some(Packed { answer, known, packs })
    }

    /// The growths of variables by steps of packs of them, each held against these.
    pub(super) fn measured(
        &mut self,
        moving: &MovingNumbers,
        packs: &[Pack],
        answer: &NumberPlaces,
    ) -> Option<Vec<Vec<Growth>>> {
        let mut apart = |pack: &Pack| {
            let direction = moving.direction(pack);
            if direction.is_empty() {
                return Some(Vec::new());
            }
            let mut grown = |sign| self.grown_along(moving.held(), &direction, (sign, &HALVINGS));
            let (step, growth) = grown(1.0).or_else(|| grown(-1.0))?;
            Some(pack.taken_apart((step, &growth), answer))
        };
        packs.iter().map(&mut apart).collect()
    }

    /// The growths by all variables; none where they do not go together, which those that do not bend one another tell.
    fn lines_of(&mut self, moving: &MovingNumbers, packed: Packed) -> Option<Vec<Growth>> {
        let Packed { answer, known: mut by_pack, packs } = packed;
        by_pack.extend(self.measured(moving, &packs, &answer)?);
        if !self.are_straight(by_pack.iter().flatten()) {
            for own in &by_pack {
                if !self.are_straight(own.iter()) {
                    return None;
                }
            }
        }
        Some(by_pack.into_iter().flatten().collect())
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::super::{NoDerivative, Value, through_affine};
    use crate::kernel::Jet;

    /// Rows of a matrix, by the columns in which they are not zero.
    type Rows = Vec<Vec<(usize, f64)>>;

    /// Points each of whose coordinates is a variable, in lists of so many.
    fn varying(sizes: &[usize]) -> Vec<Value> {
        let n_variables = 3 * sizes.iter().sum::<usize>();
        let mut variable = 0;
        let mut coordinate = || {
            let value = libm::sin(1.7 * variable as f64 * variable as f64 + 0.3);
            variable += 1;
            Jet::one_of(variable - 1, n_variables, value)
        };
        let mut point = || Value::JetPoint([coordinate(), coordinate(), coordinate()].into());
        sizes.iter().map(|&n| Value::list((0..n).map(|_| point()).collect())).collect()
    }

    /// All points of a value, in order.
    fn points(value: &Value, all: &mut Vec<Value>) {
        match value {
            Value::List(items) => items.values().for_each(|item| points(&item, all)),
            point => all.push(point.clone()),
        }
    }

    fn plain_points(args: &[Value]) -> Vec<DVec3> {
        let mut all = Vec::new();
        args.iter().for_each(|arg| points(arg, &mut all));
        let plain = all.iter().map(|point| match point {
            Value::Point(own) => *own,
            other => unreachable!("operations are run at plain points, not {other:?}"),
        });
        plain.collect()
    }

    /// The slopes of a coordinate by all variables.
    fn slopes(point: &Value, axis: usize, n_variables: usize) -> Vec<f64> {
        match point {
            Value::JetPoint(jets) => {
                let own = jets[axis].slopes();
                (0..n_variables).map(|idx| own.get(idx).copied().unwrap_or(0.0)).collect()
            }
            _ => vec![0.0; n_variables],
        }
    }

    /// Differentiates points that a matrix makes of given ones, turned by another one, and compares the slopes with its
    /// entries; how often it was asked for points.
    #[track_caller]
    fn runs(given: Vec<Value>, rows: &Rows, turn: DMat3, in_lists_of: usize) -> usize {
        let mut n_runs = 0;
        let mut run = |args: &[Value]| {
            n_runs += 1;
            let from = plain_points(args);
            let made = |row: &Vec<(usize, f64)>| {
                turn * row.iter().map(|(at, share)| from[*at] * *share).sum::<DVec3>()
            };
            let made: Vec<Value> = rows.iter().map(|row| Value::Point(made(row))).collect();
            let mut lists: Vec<Value> =
                made.chunks(in_lists_of).map(|own| Value::list(own.to_vec())).collect();
            Ok(if lists.len() == 1 { lists.remove(0) } else { Value::list(lists) })
        };
        let found = through_affine(&given, &mut run).expect("an answer").expect("slopes");
        let (mut inputs, mut outputs) = (Vec::new(), Vec::new());
        given.iter().for_each(|own| points(own, &mut inputs));
        points(&found, &mut outputs);
        assert_eq!(outputs.len(), rows.len());
        let n_variables = 3 * inputs.len();
        for (output, row) in outputs.iter().zip(rows) {
            for axis in 0..3 {
                let mut expected = vec![0.0; n_variables];
                for (at, share) in row {
                    for (along, column) in
                        [turn.x_axis, turn.y_axis, turn.z_axis].iter().enumerate()
                    {
                        expected[3 * at + along] += share * column[axis];
                    }
                }
                let found = slopes(output, axis, n_variables);
                for (variable, (found, expected)) in found.iter().zip(&expected).enumerate() {
                    assert!((found - expected).abs() < 1e-9, "{variable}: {found}, not {expected}");
                }
            }
        }
        n_runs
    }

    /// Weights that look like no others.
    fn weight(row: usize, column: usize) -> f64 {
        1.25 + libm::sin(3.1 * row as f64 + 0.7 * column as f64)
    }

    /// A matrix each of whose rows has so many entries from a column on.
    fn banded(
        n_rows: usize,
        n_columns: usize,
        first: impl Fn(usize) -> usize,
        width: usize,
    ) -> Rows {
        let row = |row: usize| {
            let columns = (first(row)..first(row) + width).filter(|&column| column < n_columns);
            columns.map(|column| (column, weight(row, column))).collect()
        };
        (0..n_rows).map(row).collect()
    }

    #[test]
    fn points_that_reach_a_few_beside_them_are_moved_together() {
        let n = runs(varying(&[40]), &banded(40, 40, |row| row, 4), DMat3::IDENTITY, 40);
        assert!(n <= 30, "{n} runs for 120 variables");
    }

    #[test]
    fn points_that_reach_twice_as_many_as_they_are_are_moved_together() {
        let n = runs(varying(&[30]), &banded(58, 30, |row| row / 2, 2), DMat3::IDENTITY, 58);
        assert!(n <= 45, "{n} runs for 90 variables");
    }

    #[test]
    fn points_that_reach_half_as_many_as_they_are_are_moved_together() {
        let n = runs(varying(&[60]), &banded(30, 60, |row| 2 * row, 3), DMat3::IDENTITY, 30);
        assert!(n <= 60, "{n} runs for 180 variables");
    }

    #[test]
    fn points_that_come_back_in_reverse_are_moved_together() {
        let n = runs(varying(&[40]), &banded(38, 40, |row| 37 - row, 3), DMat3::IDENTITY, 38);
        assert!(n <= 30, "{n} runs for 120 variables");
    }

    #[test]
    fn points_of_which_all_is_made_are_moved_along_three_coordinates() {
        let n = runs(varying(&[20]), &banded(7, 20, |_| 0, 20), DMat3::IDENTITY, 7);
        assert!(n <= 30, "{n} runs for 60 variables");
    }

    #[test]
    fn points_that_are_turned_are_moved_as_they_are() {
        let turn = DMat3::from_euler(glam::EulerRot::XYZ, 0.4, 1.1, -0.8);
        let n = runs(varying(&[60]), &banded(60, 60, |row| row, 2), turn, 60);
        assert!(n <= 60, "{n} runs for 180 variables");
    }

    #[test]
    fn a_point_that_reaches_far_alone_is_not_mistaken_for_its_neighbours() {
        let mut rows = banded(40, 40, |row| row, 3);
        rows[35].push((2, 0.75));
        rows[3].push((38, -0.5));
        runs(varying(&[40]), &rows, DMat3::IDENTITY, 40);
    }

    #[test]
    fn lists_of_points_that_reach_lists_of_their_own_have_the_slopes_of_each() {
        let both = [24, 24];
        let mut rows = banded(24, 24, |row| row, 3);
        let other = banded(24, 24, |row| row + 1, 3);
        rows.extend(other.iter().map(|row| row.iter().map(|(at, w)| (at + 24, *w)).collect()));
        let n = runs(varying(&both), &rows, DMat3::IDENTITY, 24);
        assert!(n <= 60, "{n} runs for 144 variables");
        let one = vec![Value::list(varying(&both))];
        let n = runs(one, &rows, DMat3::IDENTITY, 24);
        assert!(n <= 60, "{n} runs for 144 variables");
    }

    /// What an operation on one coordinate, in which it bends, has for slopes.
    #[track_caller]
    fn slopes_of(bend: impl Fn(f64, f64) -> f64) -> Result<[f64; 2], NoDerivative> {
        let number = |idx: usize, value: f64| Jet::one_of(idx, 2, value);
        let point =
            Value::JetPoint([number(0, 3.0), number(1, -1.5), number(0, 0.0).same(0.0)].into());
        let mut run = |args: &[Value]| {
            let from = plain_points(args)[0];
            Ok(Value::Point(DVec3::new(bend(from.x, from.y), 0.0, 0.0)))
        };
        let found = through_affine(&[point], &mut run).expect("an answer")?;
        let own = slopes(&found, 0, 2);
        Ok([own[0], own[1]])
    }

    #[test]
    fn a_parabola_has_its_slope_and_a_cubic_none() {
        let found = slopes_of(|x, y| x * x - 2.0 * x + y * y).expect("slopes");
        assert!((found[0] - 4.0).abs() < 1e-9 && (found[1] + 3.0).abs() < 1e-9, "{found:?}");
        for size in [1e-6, 1.0, 1e6] {
            let cubic = slopes_of(|x, y| size * (x * x * x + y));
            assert_eq!(cubic, Err(NoDerivative::Uneven), "{size}");
            let even = slopes_of(|x, y| size * (x / 3.0 + 0.7 * y)).expect("slopes");
            let misses = [even[0] / size - 1.0 / 3.0, even[1] / size - 0.7];
            assert!(misses.iter().all(|miss| miss.abs() < 1e-12), "{even:?} of {size}");
        }
        assert_eq!(slopes_of(|x, y| x + y.abs() * y), Ok([1.0, 3.0]));
    }
}
