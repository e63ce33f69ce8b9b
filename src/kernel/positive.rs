//! Whether a denominator stays positive, so that every parameter has a point.
//!
//! Weights that are all positive need no look. Otherwise each Bézier piece is halved until its
//! own weights tell: none negative and the corners positive is enough.

use glam::DVec4;

use super::{
    Direction, GeomError, Grid, Interval, KnotVector, WeightError, bezier, ceiling::PIECES,
};

/// A Bézier net over a rectangle of parameters.
struct BezierNet {
    net: Grid<DVec4>,
    u: Interval,
    v: Interval,
}

/// # Errors
/// [`WeightError::VanishingWeights`] unless `Σ wᵢNᵢ` is positive on the whole domain.
pub(crate) fn check_curve(knots: &KnotVector, points: &[DVec4]) -> Result<(), GeomError> {
    if points.iter().all(|point| 0.0 < point.w) {
        return Ok(());
    }
    for span in knots.spans() {
        let net = bezier::piece(knots, points, span);
        let piece = BezierNet {
            net: Grid::new(1, net.len(), net)?,
            u: Interval::UNIT,
            v: knots.span_interval(span),
        };
        check_piece(piece).map_err(|[_, parameter]| {
            GeomError::Weights(WeightError::VanishingWeights { parameter })
        })?;
    }
    Ok(())
}

/// # Errors
/// [`WeightError::VanishingWeightsAt`] unless `Σ wᵢⱼNᵢNⱼ` is positive on the whole domain.
pub(crate) fn check_surface(
    knots: [&KnotVector; 2],
    points: &Grid<DVec4>,
) -> Result<(), GeomError> {
    if points.iter().all(|point| 0.0 < point.w) {
        return Ok(());
    }
    for span_u in knots[0].spans() {
        for span_v in knots[1].spans() {
            let piece = BezierNet {
                net: bezier::patch(knots, points, span_u, span_v),
                u: knots[0].span_interval(span_u),
                v: knots[1].span_interval(span_v),
            };
            check_piece(piece)
                .map_err(|[u, v]| GeomError::Weights(WeightError::VanishingWeightsAt { u, v }))?;
        }
    }
    Ok(())
}

/// # Errors
/// The parameters of a place where the denominator is not positive.
fn check_piece(piece: BezierNet) -> Result<(), [f64; 2]> {
    let mut todo = vec![piece];
    for _ in 0..PIECES {
        let Some(piece) = todo.pop() else { return Ok(()) };
        let (last_row, last_column) = (piece.net.n_rows() - 1, piece.net.n_columns() - 1);
        for (i, u) in [(0, piece.u.start()), (last_row, piece.u.end())] {
            for (j, v) in [(0, piece.v.start()), (last_column, piece.v.end())] {
                if piece.net.get(i, j).w <= 0.0 {
                    return Err([u, v]);
                }
            }
        }
        if piece.net.iter().any(|point| point.w < 0.0) {
            todo.extend(quarters(&piece));
        }
    }
    todo.pop().map_or(Ok(()), |piece| Err([piece.u.start(), piece.v.start()]))
}

/// The piece halved in both directions, or along v where it is constant along u.
fn quarters(piece: &BezierNet) -> Vec<BezierNet> {
    let rows: Vec<(Grid<DVec4>, Interval)> = if piece.net.n_rows() == 1 {
        vec![(piece.net.clone(), piece.u)]
    } else {
        bezier::halves(&piece.net, Direction::U).into_iter().zip(piece.u.halves()).collect()
    };
    let both = |(net, u): (Grid<DVec4>, Interval)| {
        let nets = bezier::halves(&net, Direction::V).into_iter();
        nets.zip(piece.v.halves()).map(move |(net, v)| BezierNet { net, u, v })
    };
    rows.into_iter().flat_map(both).collect()
}
