//! Sheets whose edge dips twice towards a plate, of which it may reach that in the second dip alone.
//!
//! The edge is at height K t² (1 − t)² + a + (b − a) (3 t² − 2 t³) over the plate: in its dips at t = 0 and t = 1 it is
//! at heights a and b, between them and beside them beyond the tolerance. The sheet climbs from it by a slope.

use std::sync::Arc;

use virote_kernel::{
    FunctionFailure, GeomError, Grid, Interval, LevelSet, NurbsCurve, NurbsSurface,
    ParametricSurface, PictureError, Surface, SurfaceFunction, Tolerance,
    glam::{DAffine3, DVec3},
};

use crate::crossing_turned::{fractions, orientations, turn};

const TOLERANCE: Tolerance = Tolerance::DEFAULT;

/// K: more than a tolerance above both dips in the middle, and within it over an eighth of the edge about each.
const STEEPNESS: f64 = 2e-5;

/// Where the dips are along the edge; the second between all places that are looked at.
const DIPS: [f64; 2] = [0.25, 0.765];

/// How far over the plate the edge is in the first dip, within the tolerance.
const HOVERING: f64 = 5e-7;

#[derive(Clone, Copy, Debug)]
struct WavySheet {
    /// Of the height by powers of t.
    coefficients: [f64; 5],
    slope: f64,
    /// Whether the edge runs from the second dip to the first.
    is_reversed: bool,
    place: DAffine3,
}

impl WavySheet {
    fn new(n: u64, level: f64) -> Self {
        let [slope, x, y, z] = fractions(n);
        let (rise, k) = (level - HOVERING, STEEPNESS);
        Self {
            coefficients: [HOVERING, 0.0, k + 3.0 * rise, -2.0 * (k + rise), k],
            slope: libm::pow(10.0, -4.0 * slope),
            is_reversed: !n.is_multiple_of(2),
            place: DAffine3::from_translation(DVec3::new(x, -2.0 * y, z)) * turn(n),
        }
    }

    /// t by the part v of the edge: its value and its slope.
    fn t(&self, v: f64) -> [f64; 2] {
        let [first, second] = DIPS;
        let (v, sense) = if self.is_reversed { (1.0 - v, -1.0) } else { (v, 1.0) };
        [(v - first) / (second - first), sense / (second - first)]
    }

    /// A derivative of the height by v.
    fn height(&self, v: f64, order: usize) -> f64 {
        let [t, dt] = self.t(v);
        let mut coefficients = self.coefficients.to_vec();
        for _ in 0..order {
            let next = coefficients.iter().enumerate().skip(1);
            coefficients = next.map(|(power, c)| power as f64 * c * dt).collect();
        }
        coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c)
    }

    /// As a Bézier surface: the polar form of the height at the ends of the edge.
    fn spline(&self) -> NurbsSurface {
        let ends = [0.0, 1.0].map(|v| self.t(v)[0]);
        let points: Vec<DVec3> = (0..=4)
            .map(|j| {
                let arguments: Vec<f64> = (0..4).map(|i| ends[usize::from(i < j)]).collect();
                let height = polar(&self.coefficients, &arguments);
                DVec3::new(0.0, j as f64 / 4.0, height)
            })
            .collect();
        let edge = NurbsCurve::bezier(&points).unwrap();
        let sheet = NurbsSurface::extruded(&edge, DVec3::new(1.0, 0.0, self.slope)).unwrap();
        sheet.transformed(&self.place)
    }

    fn function(&self) -> Surface {
        let unit = Interval::UNIT;
        ParametricSurface::new(unit, unit, Arc::new(*self)).unwrap().into()
    }

    fn plate(&self) -> Surface {
        let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        let [a, b, c, d] = [at(-3.0, -3.0), at(-3.0, 3.0), at(3.0, -3.0), at(3.0, 3.0)];
        NurbsSurface::bilinear(a, b, c, d).unwrap().transformed(&self.place).into()
    }

    /// The parts of the edge at which places are told, in its first direction.
    fn dips_of(&self, places: &[DVec3]) -> Vec<f64> {
        let along = |&place: &DVec3| self.place.inverse().transform_point3(place).y;
        places.iter().map(along).map(|y| if self.is_reversed { 1.0 - y } else { y }).collect()
    }

    fn crossing(&self, surface: &Surface) -> Result<LevelSet, GeomError> {
        surface.intersections(&self.plate(), TOLERANCE)
    }
}

/// The polar form of a polynomial of degree 4: of each power the mean of all products of so many arguments.
fn polar(coefficients: &[f64; 5], arguments: &[f64]) -> f64 {
    let mut sums = [1.0, 0.0, 0.0, 0.0, 0.0];
    for argument in arguments {
        for power in (1..5).rev() {
            sums[power] += argument * sums[power - 1];
        }
    }
    let n_products = [1.0, 4.0, 6.0, 4.0, 1.0];
    (0..5).map(|power| coefficients[power] * sums[power] / n_products[power]).sum()
}

impl SurfaceFunction for WavySheet {
    fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, FunctionFailure> {
        Ok(Grid::from_fn(order + 1, order + 1, |k, l| match (k, l) {
            (0, 0) => {
                let height = self.height(v, 0) + self.slope * u;
                self.place.transform_point3(DVec3::new(u, v, height))
            }
            (1, 0) => self.place.transform_vector3(DVec3::new(1.0, 0.0, self.slope)),
            (0, l) => {
                let along = if l == 1 { 1.0 } else { 0.0 };
                self.place.transform_vector3(DVec3::new(0.0, along, self.height(v, l)))
            }
            _ => DVec3::ZERO,
        }))
    }
}

#[test]
fn an_edge_that_hovers_twice_is_told_twice() {
    for n in 0..orientations() {
        for level in [2e-8, 2e-7, 5e-7] {
            let sheet = WavySheet::new(n, level);
            for surface in [sheet.spline().into(), sheet.function()] {
                let found = sheet.crossing(&surface).unwrap();
                assert!(found.curves.is_empty() && found.touches.is_empty(), "{n}: {found:?}");
                let mut dips = sheet.dips_of(&found.contacts);
                dips.sort_by(f64::total_cmp);
                let is_there = |(dip, wanted): (&f64, f64)| (dip - wanted).abs() < 0.125;
                assert!(dips.len() == 2 && dips.iter().zip(DIPS).all(is_there), "{n}: {dips:?}");
            }
        }
    }
}

/// Where a spline stands in for the function, it may end beside the plate in the dip in which that reaches it, or cross
/// it several times.
#[test]
fn an_edge_that_reaches_further_on_is_told_by_its_curve_or_refused() {
    for n in 0..orientations() {
        for level in [5e-9, 0.0, -3e-9, -2e-8, -5e-7] {
            let sheet = WavySheet::new(n, level);
            match sheet.crossing(&sheet.function()) {
                Ok(found) => assert!(!found.curves.is_empty(), "{n}, {level}: {found:?}"),
                Err(GeomError::Picture(PictureError::EdgeLost { point })) => {
                    let [dip] = sheet.dips_of(&[point])[..] else { unreachable!("of one place") };
                    assert!((dip - DIPS[1]).abs() < 0.02, "{n}, {level}: {dip}");
                }
                Err(other) => panic!("{n}, {level}: {other}"),
            }
            if level < 0.0 {
                let found = sheet.crossing(&sheet.spline().into()).unwrap();
                assert_eq!(found.curves.len(), 1, "{n}, {level}: {found:?}");
                let dips = sheet.dips_of(&found.contacts);
                assert!(dips.iter().any(|dip| (dip - DIPS[0]).abs() < 0.125), "{n}: {dips:?}");
            }
        }
    }
}
