//! A last look at a function between the places at which its integral asked it.

use super::integral_piece::{IntegrationInterval, piece};

/// Where in its share of the interval a place is, lest it meets nodes.
const LOOK_SHARE: f64 = 0.618_033_988_749_894_9;

/// So many places, evenly spread, and how far they are from one another.
pub(super) fn places_between([start, end]: [f64; 2], n: usize) -> (Vec<f64>, f64) {
    let width = (end - start) / n as f64;
    ((0..n).map(|look| start + (look as f64 + LOOK_SHARE) * width).collect(), width)
}

/// Cuts out of pieces, in order, what lies around those places at which the function is not what its piece says, by so
/// much that it counts over their distance; whether there are any. Where it fails it is not asked again.
pub(super) fn is_cut_at<E>(
    function: &mut dyn FnMut(f64) -> Result<(Vec<f64>, f64), E>,
    pieces: &mut Vec<IntegrationInterval>,
    (places, width): (Vec<f64>, f64),
    allowed: f64,
) -> Result<bool, E> {
    let mut cuts: Vec<f64> = Vec::new();
    let mut next = pieces.iter().peekable();
    for at in places {
        while next.next_if(|piece| piece.interval[1] <= at).is_some() {}
        let Some(piece) = next.peek() else { break };
        // What lies between places that are nearer is looked at by the piece itself.
        if piece.interval[1] - piece.interval[0] <= width {
            continue;
        }
        if let Ok((value, _)) = function(at)
            && allowed < piece.samples.distance_at(at, &value) * width
        {
            cuts.extend([at - width, at, at + width]);
        }
    }
    let is_cut = !cuts.is_empty();
    for at in cuts {
        let is_around = |one: &IntegrationInterval| one.interval[0] < at && at < one.interval[1];
        let Some(index) = pieces.iter().position(is_around) else { continue };
        let [from, to] = pieces[index].interval;
        let parts = [piece(function, [from, at])?, piece(function, [at, to])?];
        pieces.splice(index..=index, parts);
    }
    Ok(is_cut)
}
