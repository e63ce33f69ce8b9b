//! Exact curves and surfaces of OBJ: `cstype bspline`, with weights behind the coordinates.
//!
//! Wavefront, *Advanced Visualizer Manual*, appendix B1, "Free-form curve/surface attributes".

use super::{TextBuffer, WrittenCounts, vector};
use crate::kernel::{Interval, KnotVector, NurbsCurve, NurbsSurface};

/// Writes a curve behind its control points.
pub(super) fn curve(curve: &NurbsCurve, written: &mut WrittenCounts, text: &mut TextBuffer) {
    let first = written.vertices + 1;
    for (point, homogeneous) in curve.points().iter().zip(curve.control_points()) {
        if curve.is_rational() {
            vector(text, "v", &point.extend(homogeneous.w).to_array());
        } else {
            vector(text, "v", &point.to_array());
        }
    }
    written.vertices += curve.control_points().len();
    kind(curve.is_rational(), text);
    text.push("deg ").count(curve.degree()).push("\ncurv");
    domain(curve.domain(), text);
    for idx in first..=written.vertices {
        text.push(" ").count(idx);
    }
    parameters("u", curve.knots(), text);
    text.push("\nend\n");
}

/// Writes a surface behind its control points, which go along u first.
pub(super) fn surface(surface: &NurbsSurface, written: &mut WrittenCounts, text: &mut TextBuffer) {
    let first = written.vertices + 1;
    let (points, weights) = (surface.points().transposed(), surface.weights().transposed());
    for (point, &weight) in points.iter().zip(weights.iter()) {
        if surface.is_rational() {
            vector(text, "v", &point.extend(weight).to_array());
        } else {
            vector(text, "v", &point.to_array());
        }
    }
    written.vertices += points.as_slice().len();
    kind(surface.is_rational(), text);
    text.push("deg ").count(surface.degree_u()).push(" ").count(surface.degree_v());
    text.push("\nsurf");
    domain(surface.domain_u(), text);
    domain(surface.domain_v(), text);
    for idx in first..=written.vertices {
        text.push(" ").count(idx);
    }
    parameters("u", surface.knots_u(), text);
    parameters("v", surface.knots_v(), text);
    text.push("\nend\n");
}

fn kind(is_rational: bool, text: &mut TextBuffer) {
    text.push(if is_rational { "cstype rat bspline\n" } else { "cstype bspline\n" });
}

fn domain(domain: Interval, text: &mut TextBuffer) {
    text.push(" ").exact(domain.start()).push(" ").exact(domain.end());
}

fn parameters(name: &str, knots: &KnotVector, text: &mut TextBuffer) {
    text.push("\nparm ").push(name);
    for &knot in knots.as_slice() {
        text.push(" ").exact(knot);
    }
}
