//! Where a surface is not regular: edges that are points, corners without a tangent plane, folds.

use glam::{DVec3, DVec4};

use crate::{
    Bounds, GeomError, Grid, Interval, KnotVector, Tolerance,
    ceiling::{BISECTIONS, DEFECT_HALVINGS, FOLD_PARTS, FOLDS_TOLD},
    frame::{norm, unit},
    numeric::bisection::try_bisected,
    surface::{
        Edge, NurbsSurface, Surface, intersection::level_set::SurfacePart,
        measurement::border::SurfaceBorder,
    },
    tolerance::{INSIDE_SHARE, SIDE_STEP, VANISHING_RELATIVE},
    work,
};

/// Places of each piece along a direction where the normal is looked at: fewer where the pieces
/// are many.
const PLACES: usize = 64;
const FEWEST: usize = 3;
const MOST: usize = 32;

/// Parts of a patch are halved this often before their corners tell a fold.
const LEAST_HALVINGS: usize = 10;

/// Where a surface is not regular.
///
/// The poles of a sphere are edges:
///
/// ```
/// use virote_kernel::{Edge, Frame, NurbsSurface, Surface, Tolerance};
///
/// let sphere = Surface::from(NurbsSurface::sphere(Frame::XY, 1.0)?);
/// let found = sphere.defects(Tolerance::DEFAULT)?;
/// assert_eq!(found.collapsed, [Edge::V0, Edge::V1]);
/// assert!(found.folds.is_empty());
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceDefects {
    /// Edges that are one point.
    pub collapsed: Vec<Edge>,
    /// Corners `[u, v]` where Su × Sv vanishes although no edge is collapsed.
    pub corners: Vec<[f64; 2]>,
    /// Places `[u, v]` where the normal turns over: the first few that are seen.
    pub folds: Vec<[f64; 2]>,
}

/// A place with the unit vector along Su × Sv, none where that vanishes.
struct NormalPlace {
    at: [f64; 2],
    normal: Option<DVec3>,
}

impl NurbsSurface {
    /// Whether its control points are not all on one line, nor those along u or along v all in one
    /// place: otherwise the surface is a curve or a point.
    #[must_use]
    pub fn has_area(&self) -> bool {
        if let Some((scaled, _)) = &self.scaled {
            return scaled.has_area();
        }
        let points = self.points();
        let largest = points.iter().map(|point| point.abs().max_element());
        let size = largest.filter(|size| size.is_finite()).fold(0.0, f64::max);
        let size = if 0.0 < size { size } else { 1.0 };
        let points = points.map(|point| *point / size);
        let first = points.get(0, 0);
        let away = |point: &&DVec3| norm(**point - first);
        let farthest = points.iter().max_by(|a, b| away(a).total_cmp(&away(b)));
        let Some(axis) = farthest.and_then(|point| unit(*point - first)) else { return false };
        let is_beside = |point: &DVec3| VANISHING_RELATIVE < axis.cross(*point - first).length();
        let plain = |point: &DVec4| (point.truncate() / size).extend(point.w);
        let net = self.control_points.map(plain);
        let largest = net.iter().map(|point| point.abs().max_element());
        let rounding = VANISHING_RELATIVE * largest.fold(0.0, f64::max);
        let is_still = |net: &Grid<DVec4>| {
            (0..net.n_rows()).all(|i| {
                let row = net.row(i);
                row.iter().all(|point| (*point - row[0]).abs().max_element() <= rounding)
            })
        };
        points.iter().any(is_beside) && !is_still(&net) && !is_still(&net.transposed())
    }
}

impl Surface {
    /// Where the surface is not regular: folds as far as a grid of some thousand places shows them,
    /// and where it shows none those that the normals' coefficients tell.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn defects(&self, tolerance: Tolerance) -> Result<SurfaceDefects, GeomError> {
        if let Some((scaled, scale)) = self.scaled() {
            return scaled.defects(tolerance.with_distance(tolerance.distance / scale));
        }
        let mut defects = SurfaceDefects::default();
        for edge in Edge::ALL {
            if self.is_collapsed(edge, tolerance)? {
                defects.collapsed.push(edge);
            }
        }
        let [[u0, u1], [v0, v1]] =
            [self.domain_u(), self.domain_v()].map(|domain| [domain.start(), domain.end()]);
        let corners = [
            ([u0, v0], [Edge::U0, Edge::V0]),
            ([u0, v1], [Edge::U0, Edge::V1]),
            ([u1, v0], [Edge::U1, Edge::V0]),
            ([u1, v1], [Edge::U1, Edge::V1]),
        ];
        for (at, edges) in corners {
            let is_known = edges.iter().any(|edge| defects.collapsed.contains(edge));
            if !is_known && self.unit_product(at)?.is_none() {
                defects.corners.push(at);
            }
        }
        defects.folds = self.folds()?;
        if let (Self::Nurbs(surface), true) = (self, defects.folds.is_empty()) {
            defects.folds = self.small_folds(surface)?;
        }
        Ok(defects)
    }

    fn is_collapsed(&self, edge: Edge, tolerance: Tolerance) -> Result<bool, GeomError> {
        let border = SurfaceBorder::edge(self, edge);
        let (us, vs) = (self.domain_u().steps(4), self.domain_v().steps(4));
        let whole = Bounds::of(self.points_on_grid(&us, &vs)?.into_values());
        let size = whole.map_or(0.0, Bounds::diagonal);
        Ok(border.length()? <= tolerance.distance_for(size))
    }

    /// Pairs of neighbours with opposite normals, each narrowed down to a place.
    fn folds(&self) -> Result<Vec<[f64; 2]>, GeomError> {
        let (us, vs) = self.spread_places();
        let mut folds = Vec::new();
        let mut last: Vec<Option<NormalPlace>> = Vec::new();
        for &(u, begins_u) in &us {
            let mut row = Vec::with_capacity(vs.len());
            for (j, &(v, begins_v)) in vs.iter().enumerate() {
                let here = NormalPlace { at: [u, v], normal: self.unit_product([u, v])? };
                let below = last.get(j).and_then(Option::as_ref).filter(|_| !begins_u);
                let before = row.last().and_then(Option::as_ref).filter(|_| !begins_v);
                for beside in [below, before].into_iter().flatten() {
                    if folds.len() < FOLDS_TOLD && are_opposite(beside, &here) {
                        folds.extend(self.turning_place(beside, &here)?);
                    }
                }
                row.push(Some(here));
            }
            last = row;
        }
        Ok(folds)
    }

    /// Places of folds that a grid misses: parts whose normals may be opposite are halved until they
    /// are not, or are at two of their corners.
    ///
    /// The coefficients of Su × Sv in Bernstein's form tell, within whose cone all normals are.
    /// Sederberg & Meyers, *Loop detection in surface patch intersections*, CAGD 5 (1988).
    fn small_folds(&self, surface: &NurbsSurface) -> Result<Vec<[f64; 2]>, GeomError> {
        let mut todo: Vec<(SurfacePart, usize)> =
            SurfacePart::all(surface).into_iter().map(|part| (part, 0)).collect();
        let (mut folds, mut n_parts) = (Vec::new(), 0);
        while work::goes_on(1)
            && let Some((part, n_halvings)) = todo.pop()
        {
            n_parts += 1;
            if FOLD_PARTS < n_parts || folds.len() == FOLDS_TOLD {
                break;
            }
            if part.is_regular() {
                continue;
            }
            match self.turned_corners(&part)? {
                Some([a, b]) if LEAST_HALVINGS <= n_halvings => {
                    folds.extend(self.turning_place(&a, &b)?);
                }
                _ if n_halvings < DEFECT_HALVINGS => {
                    todo.extend(part.halves().map(|half| (half, n_halvings + 1)));
                }
                _ => {}
            }
        }
        Ok(folds)
    }

    /// Two corners of a part whose normals are opposite.
    fn turned_corners(&self, part: &SurfacePart) -> Result<Option<[NormalPlace; 2]>, GeomError> {
        // Inside: at a knot the next patch would answer.
        let inside =
            |share: f64| [0, 1].map(|i| part.low[i] + (part.high[i] - part.low[i]) * share);
        let ([u0, v0], [u1, v1]) = (inside(INSIDE_SHARE), inside(1.0 - INSIDE_SHARE));
        let mut known: Vec<NormalPlace> = Vec::new();
        for at in [[u0, v0], [u1, v0], [u1, v1], [u0, v1]] {
            let here = NormalPlace { at, normal: self.unit_product(at)? };
            if let Some(i) = known.iter().position(|other| are_opposite(other, &here)) {
                return Ok(Some([known.swap_remove(i), here]));
            }
            known.push(here);
        }
        Ok(None)
    }

    /// Between two places with opposite normals, where it turns over; none where it only turns far.
    fn turning_place(
        &self,
        from: &NormalPlace,
        to: &NormalPlace,
    ) -> Result<Option<[f64; 2]>, GeomError> {
        let between = |f: f64| [0, 1].map(|i| from.at[i] * (1.0 - f) + to.at[i] * f);
        let is_like_first = |f: f64| {
            let normal = self.unit_product(between(f))?;
            Ok::<bool, GeomError>(normal.zip(from.normal).is_some_and(|(a, b)| 0.0 < a.dot(b)))
        };
        let [low, high] = try_bisected([0.0, 1.0], BISECTIONS, is_like_first)?;
        let [before, behind] = [low - SIDE_STEP, high + SIDE_STEP].map(between);
        let opposite = self.unit_product(before)?.zip(self.unit_product(behind)?);
        let is_fold = opposite.is_some_and(|(a, b)| a.dot(b) < 0.0);
        Ok(is_fold.then(|| between(0.5 * (low + high))))
    }

    fn unit_product(&self, [u, v]: [f64; 2]) -> Result<Option<DVec3>, GeomError> {
        let [_, along_u, along_v] = self.tangents_at(u, v)?;
        let product = along_u.cross(along_v);
        let [width_u, width_v] = self.widths_at(u, v);
        let is_regular = self.fold_area() < product.length() * width_u * width_v;
        Ok(unit(product).filter(|_| is_regular))
    }

    /// Parameters inside of the pieces, each with whether the surface may bend sharply before it.
    fn spread_places(&self) -> (Vec<(f64, bool)>, Vec<(f64, bool)>) {
        let inside =
            |piece: Interval, n: usize| (0..n).map(move |i| piece.at((i as f64 + 0.5) / n as f64));
        let of_knots = |knots: &KnotVector| -> Vec<(f64, bool)> {
            let spans: Vec<usize> = knots.spans().collect();
            let n = (PLACES / spans.len()).clamp(FEWEST, MOST);
            let places = spans.into_iter().flat_map(|span| {
                let piece = knots.span_interval(span);
                let is_corner = knots.degree() <= knots.exact_multiplicity(piece.start());
                inside(piece, n).enumerate().map(move |(i, t)| (t, i == 0 && is_corner))
            });
            places.collect()
        };
        match self {
            Self::Nurbs(surface) => (of_knots(surface.knots_u()), of_knots(surface.knots_v())),
            Self::Parametric(_) => {
                let places =
                    |domain| inside(domain, PLACES).map(|t| (t, false)).collect::<Vec<_>>();
                (places(self.domain_u()), places(self.domain_v()))
            }
        }
    }
}

fn are_opposite(a: &NormalPlace, b: &NormalPlace) -> bool {
    a.normal.zip(b.normal).is_some_and(|(a, b)| a.dot(b) < 0.0)
}
