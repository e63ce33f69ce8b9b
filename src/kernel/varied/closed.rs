//! Whether surfaces that close go on to do so where they vary.

use crate::{
    Bounds, GeomError, Surface, Tolerance, VariedSurface,
    surface::are_closed,
    tolerance::{APART_RELATIVE, APART_STEP_RELATIVE},
};

/// Whether surfaces that close still do so when all variables have moved a little: an edge that leaves its
/// neighbour behind opens by a share of the step, one that glides along it by the square.
///
/// # Errors
/// As [`Surface::point_at`].
pub fn stay_closed(
    surfaces: &[(Surface, Option<&VariedSurface>)],
    tolerance: Tolerance,
) -> Result<bool, GeomError> {
    let varied = || surfaces.iter().filter_map(|(_, varied)| *varied);
    let n_variables = varied().map(|varied| varied.slopes().n_variables()).max().unwrap_or(0);
    let places = varied().flat_map(|varied| varied.surface().points().into_values());
    let size = Bounds::of(places).map_or(0.0, Bounds::diagonal);
    let mut fastest = vec![0.0_f64; n_variables];
    for (variable, slopes) in varied().flat_map(|varied| varied.slopes().by_variable()) {
        let speed = slopes.iter().map(|slope| slope.length()).fold(0.0, f64::max);
        fastest[*variable] = fastest[*variable].max(speed);
    }
    let n_moving = fastest.iter().filter(|speed| 0.0 < **speed).count().max(1) as f64;
    let reach = APART_STEP_RELATIVE * size / n_moving.sqrt();
    let step = |(variable, speed): (usize, &f64)| {
        let golden = (variable + 1) as f64 * 0.618_033_988_749_894_9;
        (0.0 < *speed).then(|| (variable, (0.5 + 0.5 * golden.fract()) * reach / speed))
    };
    let steps: Vec<(usize, f64)> = fastest.iter().enumerate().filter_map(step).collect();
    let mut moved = Vec::with_capacity(surfaces.len());
    for (surface, varied) in surfaces {
        moved.push(match varied {
            Some(varied) => varied.moved(&steps)?.into(),
            None => surface.clone(),
        });
    }
    let allowed = tolerance.distance + APART_RELATIVE * size;
    are_closed(&moved, tolerance.with_distance(allowed))
}
