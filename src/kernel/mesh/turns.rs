//! How far the normal turns over the pieces of a surface.

use std::array::from_fn;

use glam::DVec3;

use super::{alike::AlikePieces, form::ParameterBoxes};
use crate::{Direction, Grid, NurbsSurface, tolerance::END_LOOK};

/// Places along a piece at which its normals are compared, as fractions of it.
const PLACES: [f64; 3] = [END_LOOK, 0.5, 1.0 - END_LOOK];

/// The square of the distance between unit normals over a box, by their differences between
/// places of each piece.
pub(super) fn turns(
    surface: &NurbsSurface,
    ends: &[Vec<f64>; 2],
    alike: &AlikePieces,
    n_threads: usize,
) -> Grid<ParameterBoxes> {
    const N: usize = PLACES.len();
    // One piece of each kind has its places there.
    let [us, vs] = Direction::BOTH.map(|along| -> Vec<f64> {
        let at = |&piece: &usize| {
            let [start, end] = [ends[along][piece], ends[along][piece + 1]];
            PLACES.map(|place| start + (end - start) * place)
        };
        alike.firsts(along).iter().flat_map(at).collect()
    });
    let normals = surface.samples_on_grid(&us, &vs, n_threads).normals;
    let [rows, columns] = Direction::BOTH.map(|along| alike.kinds(along));
    alike.grid(|i, j| {
        let (i, j) = (rows[i], columns[j]);
        let at: [[DVec3; N]; N] = from_fn(|k| from_fn(|l| normals.row(i * N + k)[j * N + l]));
        let (us, vs) = (&us[i * N..][..N], &vs[j * N..][..N]);
        // Between places one behind the other along u, at each of those along v; and the other way round.
        let turns_u: [[DVec3; N]; N - 1] =
            from_fn(|k| from_fn(|l| (at[k + 1][l] - at[k][l]) / (us[k + 1] - us[k])));
        let turns_v: [[DVec3; N - 1]; N] =
            from_fn(|k| from_fn(|l| (at[k][l + 1] - at[k][l]) / (vs[l + 1] - vs[l])));
        let longest =
            |turns: &[DVec3]| turns.iter().map(|turn| turn.length_squared()).fold(0.0, f64::max);
        let mut most = ParameterBoxes {
            uu: longest(turns_u.as_flattened()),
            uv: 0.0,
            vv: longest(turns_v.as_flattened()),
        };
        for k in 0..N - 1 {
            for l in 0..N - 1 {
                for turn_u in [turns_u[k][l], turns_u[k][l + 1]] {
                    for turn_v in [turns_v[k][l], turns_v[k + 1][l]] {
                        most.uv = most.uv.max(turn_u.dot(turn_v).abs());
                    }
                }
            }
        }
        most
    })
}
