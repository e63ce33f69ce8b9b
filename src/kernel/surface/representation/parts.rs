//! What a surface's form is made of: its net, its border, the levels of corner cutting.

use glam::{DVec3, DVec4};

use crate::{
    Bounds, GeomError, Grid, NurbsCurve, bezier::blend, homogeneous, join, surface::NurbsSurface,
};

impl NurbsSurface {
    /// The polylines through the control points: those along u, then those along v. Points of
    /// weight zero are left out, and so are lines of fewer than two points.
    ///
    /// # Errors
    /// Those of [`NurbsCurve::polyline`].
    pub fn control_net(&self) -> Result<Vec<NurbsCurve>, GeomError> {
        let net = &self.control_points;
        let columns = (0..net.n_columns()).map(|j| net.column(j));
        let rows = (0..net.n_rows()).map(|i| net.row(i).to_vec());
        let places = |line: Vec<DVec4>| -> Vec<DVec3> {
            let are_there = line.into_iter().filter(|point| point.w != 0.0);
            are_there.map(homogeneous::place).collect()
        };
        let lines = columns.chain(rows).map(places).filter(|line| 1 < line.len());
        lines.map(|line| NurbsCurve::polyline(&line)).collect()
    }

    /// The boundary as one closed curve, counter-clockwise about the normal from the first corner:
    /// along v = start, u = end, back along v = end, u = start. Edges that are one point, up to
    /// the distance, are left out.
    ///
    /// # Errors
    /// Those of [`join`]; `CountError::TooFewCurves` where one edge or none is left.
    pub fn border(&self, distance: f64) -> Result<NurbsCurve, GeomError> {
        let [u0, u1, v0, v1] = self.edges();
        let is_wide = |edge: &NurbsCurve| {
            let places = edge.points();
            Bounds::of(places).is_some_and(|bounds| distance < bounds.diagonal())
        };
        let around = [v0, u1, v1.reversed(), u0.reversed()];
        let edges: Vec<NurbsCurve> = around.into_iter().filter(is_wide).collect();
        join(&edges, distance)
    }

    /// The levels of de Casteljau's algorithm: from the net, each the bilinear cuts of the cells of
    /// the one before, to the point at `(u, v)`; none unless the surface is one Bézier patch.
    /// Where one direction is used up the other goes on alone.
    ///
    /// Farin, *Curves and Surfaces for CAGD*, §16.1 (direct de Casteljau algorithm).
    #[must_use]
    pub fn de_casteljau(&self, u: f64, v: f64) -> Option<Vec<Grid<DVec3>>> {
        let is_bezier = [&self.knots_u, &self.knots_v].into_iter().all(|knots| {
            let (domain, order) = (knots.domain(), knots.degree() + 1);
            let ends = [domain.start(), domain.end()];
            knots.n_points() == order
                && ends.iter().all(|&end| knots.exact_multiplicity(end) == order)
        });
        if !is_bezier {
            return None;
        }
        let (f, g) = (self.domain_u().fraction_of(u), self.domain_v().fraction_of(v));
        let mut level = self.control_points.clone();
        let mut levels = vec![level.map(|&point| homogeneous::place(point))];
        for _ in 0..self.degree_u().max(self.degree_v()) {
            let (n, m) = (level.n_rows(), level.n_columns());
            let (is_u, is_v) = (1 < n, 1 < m);
            let along_u = |i: usize, j: usize| match is_u {
                true => blend(level.get(i, j), level.get(i + 1, j), f),
                false => level.get(i, j),
            };
            level =
                Grid::from_fn(n - usize::from(is_u), m - usize::from(is_v), |i, j| match is_v {
                    true => blend(along_u(i, j), along_u(i, j + 1), g),
                    false => along_u(i, j),
                });
            levels.push(level.map(|&point| homogeneous::place(point)));
        }
        Some(levels)
    }
}
