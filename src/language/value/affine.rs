//! Derivatives through operations that are affine in what they are made of, as a Bézier curve is in its
//! control points: from the operation itself, run at the arguments and a step away from them.
//!
//! Where a result lies on a straight line, or on a parabola, along the slopes of the arguments, its
//! differences are its derivatives but for rounding, whatever the length of the steps. Whether it does is
//! seen at one more place; what bends otherwise is refused, so that no difference is ever taken for a
//! derivative that it is not.

use super::{
    CARRIES_DERIVATIVES, Value,
    held_numbers::{HeldNumbers, unit_step},
    numbers::{NumberSlopes, SparseNumbers, numbers},
    packed::Growth,
    variation::{
        Steps, Variables, are_alike, has_moving_knots, looked_at, moved, sizes, with_form_of,
    },
};
use crate::{
    diag::Result,
    kernel::{PointEntries, tolerance::AFFINE_RELATIVE},
    limits::work,
};

/// Steps that are tried, as the size of what moves halved so many times: the first may leave what the
/// operation takes.
pub(super) const HALVINGS: [i32; 4] = [2, 3, 6, 12];

/// Why an answer has no derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoDerivative {
    /// Derivatives of an order above the first are wanted.
    HigherOrder,
    /// Knots or the number of points change with the arguments.
    OtherForm,
    /// Knots of the arguments move, and the answer depends on more than their shape.
    MovingKnots,
    /// The answer bends.
    Uneven,
    /// There is no answer beside the place.
    NoAnswer,
}

impl NoDerivative {
    /// What is to be said of the operation, behind its name.
    #[must_use]
    pub fn message(self) -> &'static str {
        match self {
            Self::HigherOrder => {
                "only first derivatives pass through here, and higher ones are wanted"
            }
            Self::OtherForm => {
                "its knots or its number of points change with what is differentiated, so that no derivative passes through"
            }
            Self::MovingKnots => {
                "it depends on knots that move with what is differentiated, so that no derivative passes through"
            }
            Self::Uneven => {
                "it does not grow evenly with what is differentiated, so that no derivative passes through"
            }
            Self::NoAnswer => "it has no answer beside this place, so that it has no derivative",
        }
    }

    /// What to do.
    #[must_use]
    pub fn hint(self) -> &'static str {
        match self {
            Self::HigherOrder => {
                "make the geometry outside of the function, of fixed numbers, and ask for its places inside"
            }
            Self::OtherForm | Self::MovingKnots => {
                "where `parameters` or knots can be listed, they stay as they are: `interpolate(p, parameters = [0, 1, 2])`"
            }
            Self::Uneven | Self::NoAnswer => CARRIES_DERIVATIVES,
        }
    }
}

/// Whether a value carries derivatives, at whatever depth.
#[must_use]
pub fn varies(value: &Value) -> bool {
    Variables::of(value) != Variables::None
}

/// What an operation answers to arguments that carry derivatives, with the derivatives of its answer; or why
/// it has none.
///
/// # Errors
/// Those of the operation at the plain arguments.
pub fn through_affine(
    args: &[Value],
    run: &mut dyn FnMut(&[Value]) -> Result<Value>,
) -> Result<std::result::Result<Value, NoDerivative>> {
    through_told(args, run, &|| None)
}

/// [`through_affine`] of an operation that may tell, when it has answered once, how its answer is made of points: see
/// [`Ctx::made_by`](super::Ctx::made_by).
///
/// # Errors
/// Those of the operation at the plain arguments.
pub fn through_told(
    args: &[Value],
    run: &mut dyn FnMut(&[Value]) -> Result<Value>,
    told: &dyn Fn() -> Option<PointEntries>,
) -> Result<std::result::Result<Value, NoDerivative>> {
    if args.iter().any(has_moving_knots) {
        return Ok(Err(NoDerivative::MovingKnots));
    }
    let Some(held) = all_moved(args, &[]) else { return Ok(Err(NoDerivative::NoAnswer)) };
    let base = run(&held)?;
    Ok(differences(args, base, run, told()))
}

/// [`through_affine`] of an operation whose answer depends on the shape of its arguments alone: their knots
/// may move, since the same shapes on knots that do not move give the same answer.
///
/// # Errors
/// Those of the operation at the plain arguments.
pub fn through_shape(
    args: &[Value],
    run: &mut dyn FnMut(&[Value]) -> Result<Value>,
) -> Result<std::result::Result<Value, NoDerivative>> {
    if !args.iter().any(has_moving_knots) {
        return through_affine(args, run);
    }
    let given: Vec<Value> = args.iter().map(looked_at).collect();
    let answer = run(&given)?;
    let held = all_moved(args, &[]);
    let Some(base) = held.and_then(|held| run(&held).ok()) else {
        return Ok(Err(NoDerivative::NoAnswer));
    };
    Ok(differences(args, base, run, None)
        .and_then(|found| with_form_of(&found, &answer).ok_or(NoDerivative::MovingKnots)))
}

/// All values with their variables moved by some steps.
pub(super) fn all_moved(args: &[Value], steps: Steps<'_>) -> Option<Vec<Value>> {
    args.iter().map(|arg| moved(arg, steps)).collect()
}

/// An answer with its derivatives, from those beside it.
fn differences(
    args: &[Value],
    base: Value,
    run: &mut dyn FnMut(&[Value]) -> Result<Value>,
    told: Option<PointEntries>,
) -> std::result::Result<Value, NoDerivative> {
    let variables = args.iter().map(Variables::of).find(|found| *found != Variables::None);
    match variables.unwrap_or(Variables::None) {
        Variables::None => Ok(base),
        Variables::HigherOrder => Err(NoDerivative::HigherOrder),
        Variables::FirstOrder(n_variables) => {
            Differences::new(args, base, run).slopes(n_variables, told)
        }
    }
}

/// The numbers of the answer beside the place.
pub(super) struct Differences<'a> {
    pub(super) args: &'a [Value],
    pub(super) base: Value,
    run: &'a mut dyn FnMut(&[Value]) -> Result<Value>,
    plain: Vec<f64>,
}

/// The slopes along the growths, by variable.
fn along(lines: impl IntoIterator<Item = Growth>) -> Vec<(usize, SparseNumbers)> {
    let slope = |Growth { variable, step, mut growth }: Growth| {
        growth.iter_mut().for_each(|(_, growth)| *growth /= step);
        (variable, growth)
    };
    let mut found: Vec<(usize, SparseNumbers)> = lines.into_iter().map(slope).collect();
    found.sort_by_key(|(variable, _)| *variable);
    found
}

/// How much all numbers grow over a step of a variable.
struct Line {
    variable: usize,
    step: f64,
    growth: Vec<f64>,
}

impl Line {
    fn grown(&self) -> Growth {
        Growth { variable: self.variable, step: self.step, growth: sparse(&self.growth) }
    }
}

fn sparse(numbers: &[f64]) -> SparseNumbers {
    numbers.iter().copied().enumerate().filter(|(_, number)| *number != 0.0).collect()
}

impl<'a> Differences<'a> {
    fn new(
        args: &'a [Value],
        base: Value,
        run: &'a mut dyn FnMut(&[Value]) -> Result<Value>,
    ) -> Self {
        let mut plain = Vec::new();
        numbers(&base, &mut plain);
        Self { args, base, run, plain }
    }

    /// By how much the numbers grow over some steps; none where there is no answer, and some error where
    /// it has another form.
    fn growth(&mut self, steps: Steps<'_>) -> std::result::Result<Vec<f64>, NoDerivative> {
        self.growth_to(all_moved(self.args, steps))
    }

    /// The same to other arguments.
    fn growth_to(
        &mut self,
        args: Option<Vec<Value>>,
    ) -> std::result::Result<Vec<f64>, NoDerivative> {
        let there = args.and_then(|args| (self.run)(&args).ok()).ok_or(NoDerivative::NoAnswer)?;
        if !are_alike(&self.base, &there) {
            return Err(NoDerivative::OtherForm);
        }
        let mut found = Vec::with_capacity(self.plain.len());
        numbers(&there, &mut found);
        found.iter_mut().zip(&self.plain).for_each(|(there, here)| *there -= here);
        Ok(found)
    }

    /// The first of some steps of plain arguments along a direction, or against it, after which there is an answer, and the
    /// growth over it; none where nothing moves.
    pub(super) fn grown_along(
        &mut self,
        held: &HeldNumbers,
        direction: &SparseNumbers,
        (sign, halvings): (f64, &[i32]),
    ) -> Option<(f64, Vec<f64>)> {
        // The slopes of all variables by all others may be more than there is room for.
        if !work::goes_on(1 + self.plain.len() as u64 / work::PARTS_A_STEP) {
            return None;
        }
        let unit = held.unit_step(direction)?;
        halvings.iter().find_map(|halvings| {
            let step = libm::ldexp(sign * unit, -halvings);
            let growth = self.growth_to(held.moved(direction, step));
            Some((step, growth.ok()?))
        })
    }

    /// The step over which what moves with a variable moves by its own size; none where nothing does.
    fn unit_step(&self, variable: usize) -> Option<f64> {
        let all = self.args.iter().map(|arg| sizes(arg, variable));
        let [slope, size] = all.fold([0.0_f64; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
        if slope == 0.0 {
            return None;
        }
        Some(unit_step(slope, size))
    }

    /// The growths over the first steps of a variable that have any.
    fn growths(
        &mut self,
        variable: usize,
        n_wanted: usize,
    ) -> std::result::Result<Vec<Line>, NoDerivative> {
        let Some(unit) = self.unit_step(variable) else { return Ok(Vec::new()) };
        let (mut found, mut missing) = (Vec::new(), NoDerivative::NoAnswer);
        let signed = |halvings: i32| [1.0, -1.0].map(|sign| libm::ldexp(sign * unit, -halvings));
        for step in HALVINGS.into_iter().flat_map(signed) {
            match self.growth(&[(variable, step)]) {
                Ok(growth) => found.push(Line { variable, step, growth }),
                Err(reason) => missing = reason,
            }
            if found.len() == n_wanted {
                return Ok(found);
            }
        }
        Err(missing)
    }

    /// The answer with its derivatives: first as on straight lines, then as on parabolas.
    fn slopes(
        mut self,
        n_variables: usize,
        told: Option<PointEntries>,
    ) -> std::result::Result<Value, NoDerivative> {
        if let Some(found) = self.through_points(n_variables, told) {
            return Ok(found);
        }
        let by_variable = match self.together(n_variables) {
            Some(lines) => along(lines),
            None => self.each_by_itself(n_variables)?,
        };
        let mut slopes = NumberSlopes::new(n_variables, &by_variable);
        slopes.value(&self.base).ok_or(NoDerivative::NoAnswer)
    }

    /// The slopes by each variable, moved by itself.
    fn each_by_itself(
        &mut self,
        n_variables: usize,
    ) -> std::result::Result<Vec<(usize, SparseNumbers)>, NoDerivative> {
        let lines: Vec<Growth> = self.lines(n_variables)?.iter().map(Line::grown).collect();
        if self.are_straight(lines.iter()) {
            return Ok(along(lines));
        }
        let mut all = Vec::new();
        for line in lines {
            let growths = self.growths(line.variable, 3)?;
            let slopes = self.parabola(&growths).ok_or(NoDerivative::Uneven)?;
            all.push((line.variable, sparse(&slopes)));
        }
        Ok(all)
    }

    /// The growth over a step of each variable.
    fn lines(&mut self, n_variables: usize) -> std::result::Result<Vec<Line>, NoDerivative> {
        let mut lines = Vec::new();
        for variable in 0..n_variables {
            // The slopes of all variables by all others may be more than there is room for.
            if !work::goes_on(1 + self.plain.len() as u64 / work::PARTS_A_STEP) {
                return Err(NoDerivative::NoAnswer);
            }
            lines.extend(self.growths(variable, 1)?);
        }
        Ok(lines)
    }

    /// Whether the growths over all steps together, each shortened in its own way, are the sum of theirs.
    pub(super) fn are_straight<'l>(
        &mut self,
        lines: impl Iterator<Item = &'l Growth> + Clone,
    ) -> bool {
        let n = lines.clone().count() as f64;
        let shortened = |idx: usize| {
            let golden = (idx + 1) as f64 * 0.618_033_988_749_894_9;
            -(0.5 + 0.5 * golden.fract()) / n
        };
        let factors = (0..).map(shortened);
        let steps: Vec<(usize, f64)> = lines
            .clone()
            .zip(factors.clone())
            .map(|(line, factor)| (line.variable, factor * line.step))
            .collect();
        let Ok(found) = self.growth(&steps) else { return false };
        let mut expected = vec![0.0; found.len()];
        for (line, factor) in lines.zip(factors) {
            line.growth.iter().for_each(|(at, growth)| expected[*at] += factor * growth);
        }
        self.is_near(&found, &expected)
    }

    /// The slopes at the place of the parabolas through two growths, which must go through the third.
    fn parabola(&self, growths: &[Line]) -> Option<Vec<f64>> {
        let [a, b, c] = growths else {
            return growths.is_empty().then(|| vec![0.0; self.plain.len()]);
        };
        let (mut slopes, mut expected) = (Vec::new(), Vec::new());
        for (at_a, at_b) in a.growth.iter().zip(&b.growth) {
            let (chord_a, chord_b) = (at_a / a.step, at_b / b.step);
            let bend = (chord_b - chord_a) / (b.step - a.step);
            let slope = chord_a - bend * a.step;
            slopes.push(slope);
            expected.push((slope + bend * c.step) * c.step);
        }
        self.is_near(&c.growth, &expected).then_some(slopes)
    }

    pub(super) fn is_near(&self, found: &[f64], expected: &[f64]) -> bool {
        let size = |all: &[f64]| all.iter().fold(0.0, |most: f64, number| most.max(number.abs()));
        let size = size(&self.plain).max(size(expected));
        found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= AFFINE_RELATIVE * size)
    }
}
