//! The spans of a spline along one direction, with what makes Bézier points of control points.

use crate::{KnotVector, knots::convert_to_bezier};

/// The spans of one direction.
#[derive(Debug)]
pub(super) struct DirectionSpans {
    pub(super) degree: usize,
    pub(super) spans: Vec<KnotSpan>,
    /// For each span the (p + 1)² factors that make Bézier points of control points, row by row.
    pub(super) to_bezier: Vec<f64>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct KnotSpan {
    pub(super) start: f64,
    pub(super) end: f64,
    /// The first control point that acts on it.
    pub(super) first: usize,
}

impl DirectionSpans {
    pub(super) fn new(knots: &KnotVector) -> Self {
        let n = knots.degree() + 1;
        let (mut spans, mut to_bezier) = (Vec::new(), Vec::new());
        let mut points = vec![0.0; n];
        for span in knots.spans() {
            let interval = knots.span_interval(span);
            spans.push(KnotSpan {
                start: interval.start(),
                end: interval.end(),
                first: *knots.support(span).start(),
            });
            let start = to_bezier.len();
            to_bezier.resize(start + n * n, 0.0);
            for j in 0..n {
                points.fill(0.0);
                points[j] = 1.0;
                convert_to_bezier(knots, span, &mut points);
                for (row, &factor) in to_bezier[start..].chunks_exact_mut(n).zip(&points) {
                    row[j] = factor;
                }
            }
        }
        Self { degree: n - 1, spans, to_bezier }
    }

    /// The only span of a direction that a curve does not have.
    pub(super) fn single() -> Self {
        let span = KnotSpan { start: 0.0, end: 0.0, first: 0 };
        Self { degree: 0, spans: vec![span], to_bezier: vec![1.0] }
    }

    pub(super) fn to_bezier(&self, span: usize) -> &[f64] {
        let size = (self.degree + 1) * (self.degree + 1);
        &self.to_bezier[span * size..][..size]
    }
}
