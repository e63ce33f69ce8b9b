//! Lists that grow out of one that nobody asks for afterwards.

use super::super::ir::{Block, CallExpr, Element, Expr, ExprKind};

/// Expressions that are looked at behind an argument, and names that are found there: more than anybody writes, and
/// few enough that no call takes long.
const MOST_LOOKED_AT: usize = 64;

/// An expression that is evaluated last of those of its frame, but for some.
struct LastExpr<'e> {
    expr: &'e mut Expr,
    /// The values of the frame that those behind it name.
    named: Vec<usize>,
    /// The values of the frame that are lists made in it.
    made: Vec<usize>,
}

/// The body of a function, in which a list that begins with the elements of a value of its frame, `[...before, x]`,
/// may take the memory of that: where it is the last value, a definition of the block whose value is the last, or an
/// argument of the call that is, behind which nothing of the frame names that value. What is so defined and given to that
/// call, and named no more, is handed over.
pub(super) fn growing(mut body: Expr) -> Expr {
    let mut todo = vec![LastExpr { expr: &mut body, named: Vec::new(), made: Vec::new() }];
    while let Some(LastExpr { expr, named, mut made }) = todo.pop() {
        match &mut expr.kind {
            ExprKind::If(parts) => {
                let [_, yes, no] = &mut **parts;
                todo.push(LastExpr { expr: yes, named: named.clone(), made: made.clone() });
                todo.push(LastExpr { expr: no, named, made });
            }
            ExprKind::Block(block) => {
                grow_definitions(block, &named, &mut made);
                todo.push(LastExpr { expr: &mut block.value, named, made });
            }
            ExprKind::List(elements) => grow(elements, &named),
            ExprKind::Call(call) => todo.extend(arguments(call, named, &made)),
            _ => {}
        }
    }
    body
}

/// Lets a list grow out of the value that it begins with, unless that is named behind it.
fn grow(elements: &mut [Element], named: &[usize]) {
    if let Some(first) = elements.first_mut()
        && let Element::Spread(Expr { kind: ExprKind::Local(slot), span }) = first
        && !named.contains(slot)
    {
        *first = Element::Grown { slot: *slot, span: *span };
    }
}

/// Lets the lists that a block defines grow, from the last definition on, as far as it is plain what is named behind them.
/// `named` is what is named behind the block, and those lists are added to `made`.
fn grow_definitions(block: &mut Block, named: &[usize], made: &mut Vec<usize>) {
    let mut named = named.to_vec();
    let mut is_plain = add_named(&block.value, &mut named);
    for (slot, expr) in block.definitions.iter_mut().rev() {
        if !is_plain {
            break;
        }
        let list = match &mut expr.kind {
            ExprKind::Promise(inner, ..) => &mut inner.kind,
            kind => kind,
        };
        if let ExprKind::List(elements) = list {
            grow(elements, &named);
            made.push(*slot);
        }
        is_plain = add_named(expr, &mut named);
    }
}

/// The arguments of a call from the last one on, as far as it is plain what those behind them name; with these names.
fn arguments<'e>(
    call: &'e mut CallExpr,
    mut named: Vec<usize>,
    made: &[usize],
) -> Vec<LastExpr<'e>> {
    let mut found = Vec::new();
    // What is left open is called later.
    if call.is_partial {
        return found;
    }
    for arg in call.args.iter_mut().rev() {
        let Some(expr) = arg.value.as_mut() else { continue };
        let before = named.clone();
        let is_plain = add_named(expr, &mut named);
        match expr.kind {
            ExprKind::Local(slot) if made.contains(&slot) && !before.contains(&slot) => {
                arg.taken = Some(slot);
            }
            _ => found.push(LastExpr { expr, named: before, made: made.to_vec() }),
        }
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
            ExprKind::Field(subject, ..) | ExprKind::Promise(subject, ..) => todo.push(subject),
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
