//! Places of a shape that a click near them means: the ends of a curve, the corners of a surface, the
//! vertices of a face, and knots, each with its parameters.

use glam::DVec3;
use serde_json::json;

use super::{encode::EncodingItem, parts::Shape};
use crate::kernel::{Curve, Face, NurbsCurve, Surface};

/// Places of one item; of an item with more knots there are its ends or corners alone.
const MOST_SNAPS: usize = 1024;
/// Ends of the curves of a list that is one item; a longer list has none. Each is looked at when the pointer moves.
const MOST_LIST_ENDS: usize = 1 << 15;

/// Such places, ends before knots.
#[derive(Default)]
struct SnapPlaces {
    /// t of a curve; u and v of a surface; none of the curves of a list.
    parameters: Vec<Vec<f64>>,
    points: Vec<DVec3>,
    n_ends: usize,
}

impl SnapPlaces {
    fn add(&mut self, parameters: Vec<f64>, point: Option<DVec3>) {
        if let Some(point) = point {
            self.parameters.push(parameters);
            self.points.push(point);
        }
    }

    fn of_curve(curve: &Curve) -> Self {
        let domain = curve.domain();
        let ends = [domain.start(), domain.end()];
        let mut knots = match curve {
            Curve::Nurbs(spline) => spline.knots().breaks(),
            Curve::Parametric(_) => Vec::new(),
        };
        knots.retain(|knot| !ends.contains(knot));
        Self::together(ends.map(|t| [t]).into(), knots.into_iter().map(|t| [t]).collect(), |[t]| {
            curve.point_at(t).ok()
        })
    }

    /// The ends of the curves of a list. Their parameters would not tell which curve they are of.
    fn of_curves(curves: &[Curve]) -> Self {
        let mut places = Self::default();
        if 2 * curves.len() <= MOST_LIST_ENDS {
            for curve in curves {
                let domain = curve.domain();
                for t in [domain.start(), domain.end()] {
                    places.add(Vec::new(), curve.point_at(t).ok());
                }
            }
        }
        places.n_ends = places.points.len();
        places
    }

    fn of_surface(surface: &Surface) -> Self {
        let ends = [surface.domain_u(), surface.domain_v()].map(|its| [its.start(), its.end()]);
        let pairs = |us: &[f64], vs: &[f64]| -> Vec<[f64; 2]> {
            us.iter().flat_map(|&u| vs.iter().map(move |&v| [u, v])).collect()
        };
        let corners = pairs(&ends[0], &ends[1]);
        let mut knots = Vec::new();
        if let Surface::Nurbs(spline) = surface {
            let [us, vs] = [spline.knots_u().breaks(), spline.knots_v().breaks()];
            if us.len().saturating_mul(vs.len()) <= MOST_SNAPS {
                knots = pairs(&us, &vs);
                knots.retain(|pair| !corners.contains(pair));
            }
        }
        Self::together(corners, knots, |[u, v]| surface.point_at(u, v).ok())
    }

    /// The ends of the arcs of its border.
    fn of_face(face: &Face) -> Self {
        let parts = face.parts();
        let arcs = parts.iter().flat_map(|part| part.loops.iter().flatten());
        let vertex = |arc: &NurbsCurve| {
            let start = arc.start();
            [start.x, start.y]
        };
        let vertices = arcs.map(vertex).collect();
        Self::together(vertices, Vec::new(), |[u, v]| Some(face.surface().point_at(u, v)))
    }

    fn together<const N: usize>(
        ends: Vec<[f64; N]>,
        knots: Vec<[f64; N]>,
        point: impl Fn([f64; N]) -> Option<DVec3>,
    ) -> Self {
        let mut places = Self::default();
        for end in ends.into_iter().take(MOST_SNAPS) {
            places.add(end.to_vec(), point(end));
        }
        places.n_ends = places.points.len();
        if places.n_ends + knots.len() <= MOST_SNAPS {
            for knot in knots {
                places.add(knot.to_vec(), point(knot));
            }
        }
        places
    }
}

impl EncodingItem {
    /// The places of a curve, a surface or a face that a click near them means.
    pub(super) fn add_snaps(&mut self, shape: &Shape) {
        let places = match shape {
            Shape::Curve(curve) => SnapPlaces::of_curve(curve),
            Shape::Curves(curves) => SnapPlaces::of_curves(curves),
            Shape::Surface(surface) => SnapPlaces::of_surface(surface),
            Shape::Face(face) => SnapPlaces::of_face(face),
            // What has no parameters has vertices, which are there already.
            _ => return,
        };
        let SnapPlaces { parameters, points, n_ends } = places;
        let points = self.writer.places(&points);
        let snaps = json!({ "parameters": parameters, "points": points, "ends": n_ends });
        self.writer.set("snaps", snaps);
    }
}
