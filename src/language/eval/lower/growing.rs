//! Lists that grow out of one that nobody asks for afterwards.

use super::super::ir::{CallExpr, Element, Expr, ExprKind};

/// Expressions that are looked at behind an argument, and names that are found there: more than anybody writes, and
/// few enough that no call takes long.
const MOST_LOOKED_AT: usize = 64;

/// The body of a function, in which a list that begins with the elements of a value of its frame, `[...before, x]`,
/// may take the memory of that: where it is the last value, or an argument of the call that is, behind which nothing
/// of the frame names that value.
pub(super) fn growing(mut body: Expr) -> Expr {
    // Each with the values of the frame that are named behind it.
    let mut todo = vec![(&mut body, Vec::new())];
    while let Some((last, named)) = todo.pop() {
        match &mut last.kind {
            ExprKind::If(parts) => {
                let [_, yes, no] = &mut **parts;
                todo.extend([(yes, named.clone()), (no, named)]);
            }
            ExprKind::Block(block) => todo.push((&mut block.value, named)),
            ExprKind::List(elements) => {
                if let Some(first) = elements.first_mut()
                    && let Element::Spread(Expr { kind: ExprKind::Local(slot), span }) = first
                    && !named.contains(slot)
                {
                    *first = Element::Grown { slot: *slot, span: *span };
                }
            }
            ExprKind::Call(call) => todo.extend(arguments(call, named)),
            _ => {}
        }
    }
    body
}

/// The arguments of a call from the last one on, as far as it is plain what those behind them name; with these names.
fn arguments(call: &mut CallExpr, mut named: Vec<usize>) -> Vec<(&mut Expr, Vec<usize>)> {
    let mut found = Vec::new();
    // What is left open is called later.
    if call.is_partial {
        return found;
    }
    for expr in call.args.iter_mut().rev().filter_map(|arg| arg.value.as_mut()) {
        let before = named.clone();
        let is_plain = add_named(expr, &mut named);
        found.push((expr, before));
        if !is_plain {
            break;
        }
    }
    found
}

/// Adds the values of the frame that an expression names; whether it is plain which these are.
fn add_named(expr: &Expr, named: &mut Vec<usize>) -> bool {
    let (mut todo, mut n_seen) = (vec![expr], named.len());
    while let Some(expr) = todo.pop() {
        n_seen += 1;
        if MOST_LOOKED_AT < n_seen + todo.len() {
            return false;
        }
        match &expr.kind {
            ExprKind::Local(slot) => named.push(*slot),
            ExprKind::Constant(_)
            | ExprKind::Captured(_)
            | ExprKind::Sibling(_)
            | ExprKind::Global(_) => {}
            ExprKind::Point(parts) => todo.extend(&**parts),
            ExprKind::Unary(_, operand) => todo.push(operand),
            ExprKind::Binary(_, sides) => todo.extend(&**sides),
            ExprKind::Index(parts) => todo.extend(&**parts),
            ExprKind::Field(subject, ..) => todo.push(subject),
            ExprKind::If(parts) => todo.extend(&**parts),
            ExprKind::Call(call) => {
                todo.push(&call.callee);
                todo.extend(call.args.iter().filter_map(|arg| arg.value.as_ref()));
            }
            ExprKind::List(elements) => {
                for element in elements {
                    match element {
                        Element::Item(item) | Element::Spread(item) => todo.push(item),
                        Element::Grown { slot, .. } => named.push(*slot),
                    }
                }
            }
            _ => return false,
        }
    }
    true
}
