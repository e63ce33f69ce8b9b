//! What the shape of an expression says about how it is set.

use crate::syntax::ast::{BinaryOp, Expr, ExprKind, UnaryOp};

/// Whether an expression has brackets of its own to break.
pub(super) fn breaks_inside(expr: &Expr<'_>) -> bool {
    match &expr.kind {
        ExprKind::Lambda(_, body) => breaks_inside(body),
        ExprKind::Call(..)
        | ExprKind::List(_)
        | ExprKind::Record(_)
        | ExprKind::Comprehension(_)
        | ExprKind::Block(_)
        | ExprKind::Point(_)
        | ExprKind::Group(_) => true,
        _ => false,
    }
}

/// Whether an expression may stand beside an operator without spaces.
pub(super) fn is_tight_operand(expr: &Expr<'_>) -> bool {
    match &expr.kind {
        ExprKind::Unary(UnaryOp::Negate, operand) => is_tight_operand(operand),
        ExprKind::Binary(BinaryOp::Power, operands) => operands.iter().all(is_tight_operand),
        ExprKind::Number(..)
        | ExprKind::Name(_)
        | ExprKind::Group(_)
        | ExprKind::Call(..)
        | ExprKind::Field(..)
        | ExprKind::Index(_) => true,
        _ => false,
    }
}
