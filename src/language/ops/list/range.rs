//! `range`: numbers at a step.

use super::check_length;
use crate::{
    diag::{Result, Spanned},
    kernel::tolerance::STEP_RELATIVE,
    ops::math::{common_dim, outside},
    value::{Ctx, Number, Real, op},
};

op! {
    /// Numbers from `a` towards `b` at a step; `b` is included when it is reached.
    ///
    /// Each number is a + i*step, so that no error adds up.
    range in List -> Vec<Number<Real>> {
        /// The first number.
        a: Number<Real>,
        /// Where it ends.
        b: Number<Real>,
        /// The step; negative to go down.
        step: Spanned<Number<Real>>,
    }
    example "range(0, 1, 0.25)" => "[0, 0.25, 0.5, 0.75, 1]";
    example "range(3, 1, -1)" => "[3, 2, 1]";
    example "range(1, 0, 0.5)" => "[]";
    refuses "range(0, 1, 0)" => "E0502: a step of zero never arrives";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Number<Real>>> {
    let Args { a, b, step } = args;
    let [from, to, by] = [a.looked_at(), b.looked_at(), step.value.looked_at()];
    let dim = common_dim([from, to, by].into_iter(), ctx.span)?;
    if by.value == 0.0 {
        return outside(step.span, "a step of zero never arrives".to_owned());
    }
    // The last number may miss `b` by the rounding of the division.
    let steps = ((to.value - from.value) / by.value).clamp(-1e300, 1e300);
    let n_steps = (steps + STEP_RELATIVE * steps.abs().max(1.0)).floor();
    if n_steps < 0.0 {
        return Ok(Vec::new());
    }
    check_length(n_steps + 1.0, ctx)?;
    let number = |i: usize| Number { value: a.value.plus(&step.value.value.scaled(i as f64)), dim };
    Ok((0..=n_steps as usize).map(number).collect())
}
