//! Lists that grow out of one that nobody asks for afterwards.

use super::super::ir::{Element, Expr, ExprKind};

/// The body of a function, in which a list that is its last value and begins with the elements of a value of its
/// frame, `[...before, x]`, may take the memory of that.
pub(super) fn growing(mut body: Expr) -> Expr {
    let mut todo = vec![&mut body];
    while let Some(last) = todo.pop() {
        match &mut last.kind {
            ExprKind::If(parts) => {
                let [_, yes, no] = &mut **parts;
                todo.extend([yes, no]);
            }
            ExprKind::Block(block) => todo.push(&mut block.value),
            ExprKind::List(elements) => {
                if let Some(first) = elements.first_mut()
                    && let Element::Spread(Expr { kind: ExprKind::Local(slot), span }) = first
                {
                    *first = Element::Grown { slot: *slot, span: *span };
                }
            }
            _ => {}
        }
    }
    body
}
