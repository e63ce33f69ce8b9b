//! Where an integral begins: with the whole interval, or with parts of it where its nodes see nothing.

use super::integral_piece::{IntegrationInterval, piece};

/// Times that one part is looked at more closely.
pub(super) const MOST_LOOKS: usize = 4;

/// Places towards each end at which a function is asked that is zero at all nodes.
const END_LOOKS: usize = 32;

/// The whole interval; or, where a function is zero at all nodes, such as exp(−x) far out, what lies between places
/// at which it is not, nearer and nearer to the ends and to zero.
pub(super) fn first_pieces<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    ends: [f64; 2],
    most_looks: usize,
) -> Result<Vec<IntegrationInterval>, E> {
    let whole = piece(function, ends)?;
    if 0.0 < whole.size || !whole.error.is_finite() || most_looks == 0 {
        return Ok(vec![whole]);
    }
    // The ends of parts, and whether the function is zero there; of a stretch of zeros the first and the last place.
    let mut places: Vec<(f64, bool)> = vec![(ends[0], true)];
    for place in looks(ends) {
        // Where it fails so near to an end it is not asked again.
        let is_zero = !function(place).is_ok_and(|(_, size)| 0.0 < size);
        if let [.., (_, true), last @ (_, true)] = &mut places[..]
            && is_zero
        {
            *last = (place, true);
        } else {
            places.push((place, is_zero));
        }
    }
    if places.iter().all(|(_, is_zero)| *is_zero) {
        return Ok(vec![whole]);
    }
    places.push((ends[1], true));
    let mut pieces = Vec::new();
    for pair in places.windows(2) {
        let [(from, is_zero), (to, is_zero_behind)] = [pair[0], pair[1]];
        let n_looks = if is_zero && is_zero_behind { 0 } else { most_looks - 1 };
        pieces.extend(first_pieces(function, [from, to], n_looks)?);
    }
    Ok(pieces)
}

/// Places in an interval, nearer and nearer to its ends and to zero, in order: by equal factors, down to where numbers end.
fn looks([start, end]: [f64; 2]) -> Vec<f64> {
    let (width, mut places) = (end - start, Vec::with_capacity(4 * END_LOOKS));
    // What decays does so towards the ends or from zero on.
    for (from, way) in [(start, 1.0), (end, -1.0), (0.0, 1.0), (0.0, -1.0)] {
        let spacing = (from.abs().next_up() - from.abs()).max(f64::MIN_POSITIVE);
        let (widest, narrowest) = (libm::log2(width), libm::log2(spacing));
        let step = (narrowest - widest) / END_LOOKS as f64;
        let distance = |k: usize| libm::exp2(widest + step * k as f64);
        places.extend((1..END_LOOKS).map(|k| from + way * distance(k)));
    }
    places.retain(|&place| start < place && place < end);
    places.sort_by(f64::total_cmp);
    places.dedup_by_key(|place| place.to_bits());
    places
}
