//! How far vectors reach: along a normal, across it, and in any direction.
//!
//! Several are measured at once, which the compiler makes instructions on pairs of numbers of.

use glam::DVec3;

/// So many vectors are measured at once.
const LANES: usize = 4;

/// Vectors by their coordinates.
pub(super) type VectorLanes = [[f64; LANES]; 3];

/// The reach of vectors that are all divided by one scale.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    normal: DVec3,
    scale: f64,
    length_squared: [f64; LANES],
    across_squared: [f64; LANES],
    /// Least and most along the normal.
    lift: [[f64; LANES]; 2],
}

/// Vectors in lanes, the last of them as often as fills these: once more it reaches no further.
pub(super) fn in_lanes(vectors: &[DVec3]) -> impl Iterator<Item = VectorLanes> {
    vectors.chunks(LANES).map(|some| {
        let vectors: [DVec3; LANES] = std::array::from_fn(|i| some[i.min(some.len() - 1)]);
        [vectors.map(|v| v.x), vectors.map(|v| v.y), vectors.map(|v| v.z)]
    })
}

/// The same vectors times a factor.
pub(super) fn times(vectors: VectorLanes, factor: f64) -> VectorLanes {
    vectors.map(|values| values.map(|value| value * factor))
}

/// The same vectors, each with one more added.
pub(super) fn plus(vectors: VectorLanes, other: DVec3) -> VectorLanes {
    let [x, y, z] = vectors;
    [x.map(|x| other.x + x), y.map(|y| other.y + y), z.map(|z| other.z + z)]
}

/// Unlike `f64::max` one instruction; a new value that is no number is left out as well.
fn larger(most: f64, value: f64) -> f64 {
    if most < value { value } else { most }
}

fn smaller(least: f64, value: f64) -> f64 {
    if value < least { value } else { least }
}

impl Reach {
    /// That of no vector.
    pub(super) fn new(normal: DVec3, scale: f64) -> Self {
        let lift = [[f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]];
        Self { normal, scale, length_squared: [0.0; LANES], across_squared: [0.0; LANES], lift }
    }

    #[inline]
    pub(super) fn add(&mut self, vectors: VectorLanes) {
        let [x, y, z] = vectors.map(|values| values.map(|value| value / self.scale));
        let n = self.normal;
        let along: [f64; LANES] = std::array::from_fn(|i| n.x * x[i] + n.y * y[i] + n.z * z[i]);
        for i in 0..LANES {
            let out = [x[i] - n.x * along[i], y[i] - n.y * along[i], z[i] - n.z * along[i]];
            let across_squared = out[0] * out[0] + out[1] * out[1] + out[2] * out[2];
            let length_squared = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
            self.across_squared[i] = larger(self.across_squared[i], across_squared);
            self.length_squared[i] = larger(self.length_squared[i], length_squared);
            self.lift[0][i] = smaller(self.lift[0][i], along[i]);
            self.lift[1][i] = larger(self.lift[1][i], along[i]);
        }
    }

    /// The length of the longest.
    pub(super) fn length(&self) -> f64 {
        self.length_squared.into_iter().fold(0.0, larger).sqrt()
    }

    /// The most across the normal.
    pub(super) fn across(&self) -> f64 {
        self.across_squared.into_iter().fold(0.0, larger).sqrt()
    }

    /// The least and the most along the normal.
    pub(super) fn lift(&self) -> [f64; 2] {
        let [low, high] = self.lift;
        [
            low.into_iter().fold(f64::INFINITY, smaller),
            high.into_iter().fold(f64::NEG_INFINITY, larger),
        ]
    }
}
