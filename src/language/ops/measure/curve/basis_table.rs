//! `basis_table`: the functions that blend the control points of a curve.

use super::sample_parameters;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Curve, NamedColumn, Table},
    value::{At, Ctx, op},
};

op! {
    /// Table of the basis functions of a curve: `t`, and a column for each control point, `n0`,
    /// `n1` and so on.
    ///
    /// Of a rational curve the rational basis, so that the curve is always the sum of its points
    /// times their functions. Samples are evenly spaced in the parameter, both ends among them.
    /// Piegl & Tiller, *The NURBS Book*, (2.5) and (4.2).
    basis_table in Measure -> Table {
        /// The curve.
        c: Spanned<Curve>,
        /// How many rows, two or more.
        samples: Spanned<usize> = Spanned::unplaced(100),
    }
    example "basis_table(bezier((0, 0), (1, 2), (2, 0)), samples = 3).n1" => "[0, 0.5, 0]";
    refuses "basis_table(bezier((0, 0), (1, 2), (2, 0)), samples = 1)" => "E0601: a curve is sampled at 2 places or more, found 1";
    refuses "basis_table(parametric(t => (t, t^2), 0..2))" => "E0301: a parametric curve is a function and no NURBS";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Table> {
    let parameters = sample_parameters(&args.c.value, args.samples, ctx)?;
    let curve = args.c.value.nurbs().at(args.c.span)?;
    let (knots, weights) = (curve.knots(), curve.weights());
    let (n_cells, most) = (weights.len().saturating_mul(parameters.len()), ctx.limits.list_length);
    if most < n_cells {
        let message = format!("a table of {n_cells} cells; the ceiling is {most}");
        return Diagnostic::error(Code::TooLarge, args.samples.span_or(ctx.span), message).fail();
    }

    let mut functions = vec![vec![0.0; parameters.len()]; weights.len()];
    let mut values = vec![0.0; curve.degree() + 1];
    for (row, &t) in parameters.iter().enumerate() {
        let span = knots.span_at(t);
        knots.basis_at(span, t, &mut values);
        let denominator = curve.homogeneous_at(t).w;
        for (i, value) in knots.support(span).zip(&values) {
            functions[i][row] =
                if curve.is_rational() { value * weights[i] / denominator } else { *value };
        }
    }
    let function = |(i, cells)| NamedColumn::numbers(format!("n{i}"), cells);
    let columns = functions.into_iter().enumerate().map(function);
    let parameters = NamedColumn::numbers("t", parameters);
    Table::new([parameters].into_iter().chain(columns).collect()).at(ctx.span)
}
