//! Many parameters evaluated block by block: other threads of Python run meanwhile, and Ctrl-C ends it
//! between two blocks. What a place gives does not depend on the block it is in.

use std::{
    ops::Range,
    time::{Duration, Instant},
};

use pyo3::{exceptions::PyMemoryError, prelude::*};
use virote::kernel::{GeomError, glam::DVec3};

use crate::errors::geom_error;

/// How long is evaluated from one look for signals to the next: Ctrl-C is answered at once for whoever
/// presses it, and Python's lock, for which other threads may let one wait some milliseconds, is asked for
/// seldom.
const TICK: Duration = Duration::from_millis(50);

/// Places from one look at the clock to the next: it costs a thousandth of evaluating so many points.
const BLOCK: usize = 256;

/// What `evaluate` adds to a flat array for each range of places, all of them one after the other;
/// `n_each` numbers for each place.
pub(crate) fn flat_array(
    py: Python<'_>,
    n_places: usize,
    n_each: usize,
    evaluate: impl Fn(Range<usize>, &mut Vec<f64>) -> Result<(), GeomError> + Send + Sync,
) -> PyResult<Vec<f64>> {
    let mut flat = Vec::new();
    flat.try_reserve_exact(n_places.saturating_mul(n_each)).map_err(|_| {
        PyMemoryError::new_err(format!("no memory for {n_each} numbers at {n_places} parameters"))
    })?;
    let mut done = 0;
    while done < n_places {
        let told = py.detach(|| {
            let begun = Instant::now();
            while done < n_places && begun.elapsed() < TICK {
                let end = n_places.min(done + BLOCK);
                evaluate(done..end, &mut flat)?;
                done = end;
            }
            Ok(())
        });
        told.map_err(|err| geom_error(py, err))?;
        py.check_signals()?;
    }
    Ok(flat)
}

/// The same of one place after the other.
pub(crate) fn each_flat<P: Sync>(
    py: Python<'_>,
    places: &[P],
    n_each: usize,
    evaluate: impl Fn(&P, &mut Vec<f64>) -> Result<(), GeomError> + Send + Sync,
) -> PyResult<Vec<f64>> {
    flat_array(py, places.len(), n_each, |range, flat| {
        places[range].iter().try_for_each(|place| evaluate(place, flat))
    })
}

/// Adds the coordinates of a point.
#[inline]
pub(crate) fn add(flat: &mut Vec<f64>, point: DVec3) {
    flat.extend_from_slice(&point.to_array());
}
