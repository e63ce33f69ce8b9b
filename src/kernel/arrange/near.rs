//! Pairs of arcs that may meet.
//!
//! The boxes of arcs that lie around one another, such as circles about one centre, all meet. Arcs are therefore halved until their
//! pieces bend little, and pairs are told by a tree of the pieces' boxes and by whether a line parts them.

use crate::{
    Bounds, GeomError, NurbsCurve,
    box_tree::BoxTree,
    curve::part::{CurvePart, parts},
    tolerance::{BENT_SHARE, LAST_BIT},
};

/// Halvings of a Bézier piece at most.
const HALVINGS: usize = 2;

/// Last bits of a coordinate within which pieces are not told apart.
const NEAR_ROUNDINGS: f64 = 64.0;

/// Pairs of arcs that may be within the tolerance of one another, each with itself too, of those that are wanted;
/// in order.
///
/// # Errors
/// Those of a search that was ended.
pub(super) fn near_pairs(
    arcs: &[NurbsCurve],
    is_wanted: impl Fn(usize, usize) -> bool,
    tolerance: f64,
) -> Result<Vec<[usize; 2]>, GeomError> {
    let mut pieces = Vec::new();
    for (arc, curve) in arcs.iter().enumerate() {
        GeomError::go_on(1)?;
        parts(curve).into_iter().for_each(|part| add_pieces(arc, part, HALVINGS, &mut pieces));
    }
    let whole = arcs.iter().map(NurbsCurve::bounds).reduce(Bounds::union);
    let rounding = LAST_BIT * whole.map_or(0.0, Bounds::magnitude);
    let distance = tolerance.max(NEAR_ROUNDINGS * rounding);
    let tree = BoxTree::new(pieces.iter().map(|(_, part)| part.bounds).collect());
    // The arc for which each arc was found last.
    let mut found_for = vec![usize::MAX; arcs.len()];
    let mut pairs: Vec<[usize; 2]> =
        (0..arcs.len()).filter(|&i| is_wanted(i, i)).map(|i| [i, i]).collect();
    for (i, part) in &pieces {
        let mut n_near = 0;
        tree.visit_near(part.bounds, distance, |number| {
            let (j, other) = &pieces[number];
            n_near += 1;
            if i < j && found_for[*j] != *i && is_wanted(*i, *j) && part.may_meet(other, distance) {
                found_for[*j] = *i;
                pairs.push([*i, *j]);
            }
        });
        GeomError::go_on(1 + n_near)?;
    }
    pairs.sort_unstable();
    Ok(pairs)
}

/// Adds the pieces of an arc's piece that bend little.
fn add_pieces(
    arc: usize,
    part: CurvePart,
    n_halvings: usize,
    pieces: &mut Vec<(usize, CurvePart)>,
) {
    if n_halvings == 0 || part.deviation_from_chord() <= BENT_SHARE * part.bounds.diagonal() {
        pieces.push((arc, part));
        return;
    }
    for half in part.halves() {
        add_pieces(arc, half, n_halvings - 1, pieces);
    }
}
