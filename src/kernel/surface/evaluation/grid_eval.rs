//! Many points at once: all pairs of a list of u and a list of v.
//!
//! The basis functions of each u and each v are computed once. A row of points contracts the net
//! along u into a strip with one homogeneous sum a column, and every point of the row contracts
//! the strip along v: p + q + 2 terms a point instead of (p + 1)(q + 1), and no basis.

use bytemuck::zeroed_vec;
use glam::{DVec3, DVec4};

use crate::{
    GeomError, Grid, KnotVector, homogeneous,
    side_by_side::{self, RowBlock},
    surface::NurbsSurface,
    work,
};

/// Points and unit normals at all pairs of parameters; row i for the i-th u.
///
/// The normals of a unit sphere are its points:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface};
///
/// let sphere = NurbsSurface::sphere(Frame::XY, 1.0)?;
/// let found = sphere.samples_on_grid(&[0.1, 0.2, 0.3], &[0.4, 0.6], 1);
/// for (point, normal) in found.points.iter().zip(found.normals.iter()) {
///     assert!(point.distance(*normal) < 1e-14);
/// }
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GridSamples {
    /// Points on the surface.
    pub points: Grid<DVec3>,
    /// Unit normals Su × Sv; where there is none, that of the nearest place which has one.
    pub normals: Grid<DVec3>,
}

/// Basis functions at each of a list of parameters.
struct BasisTable {
    n_functions: usize,
    spans: Vec<ActiveSpan>,
    /// For each parameter the values with the derivatives, `[N, N′]`.
    functions: Vec<[f64; 2]>,
}

/// Where the functions of a parameter act.
#[derive(Clone, Copy, PartialEq)]
struct ActiveSpan {
    /// First control point that acts.
    first: usize,
    /// Width in the parameter.
    width: f64,
}

impl BasisTable {
    fn new(knots: &KnotVector, parameters: &[f64]) -> Self {
        let n_functions = knots.degree() + 1;
        let mut functions = Vec::with_capacity(parameters.len() * n_functions);
        let mut spans = Vec::with_capacity(parameters.len());
        for &t in parameters {
            let span = knots.span_at(t);
            knots.with_slopes(span, t, |values, slopes| {
                functions.extend(values.iter().zip(slopes).map(|(&n, &dn)| [n, dn]));
            });
            let width = knots.span_interval(span).length();
            spans.push(ActiveSpan { first: span - knots.degree(), width });
        }
        Self { n_functions, spans, functions }
    }

    fn at(&self, number: usize) -> (ActiveSpan, &[[f64; 2]]) {
        let n = self.n_functions;
        (self.spans[number], &self.functions[n * number..][..n])
    }

    fn rows(&self) -> impl Iterator<Item = (ActiveSpan, &[[f64; 2]])> {
        self.spans.iter().copied().zip(self.functions.chunks_exact(self.n_functions))
    }
}

/// Homogeneous sums of one column of the net at one u.
#[derive(Clone, Copy)]
struct ColumnSum {
    value: DVec4,
    along_u: DVec4,
}

impl NurbsSurface {
    /// Points at all pairs of the parameters, row i for the i-th u.
    #[must_use]
    pub fn points_on_grid(&self, us: &[f64], vs: &[f64]) -> Grid<DVec3> {
        let (table_u, table_v) =
            (BasisTable::new(&self.knots_u, us), BasisTable::new(&self.knots_v, vs));
        let mut strip = Vec::with_capacity(self.control_points.n_columns());
        let mut points = Vec::with_capacity(us.len() * vs.len());
        for (span, functions) in table_u.rows() {
            self.contract(span.first, functions, &mut strip);
            points.extend(table_v.rows().map(|(span, functions)| {
                let sums = &strip[span.first..][..functions.len()];
                let mut sum = DVec4::ZERO;
                for (column, [n, _]) in sums.iter().zip(functions) {
                    sum += column.value * *n;
                }
                homogeneous::project(sum)
            }));
        }
        Grid::from_rows_of(vs.len(), points)
    }

    /// Points and unit normals at all pairs of the parameters, row i for the i-th u, by up to
    /// `n_threads` threads.
    #[must_use]
    pub fn samples_on_grid(&self, us: &[f64], vs: &[f64], n_threads: usize) -> GridSamples {
        let tables = [BasisTable::new(&self.knots_u, us), BasisTable::new(&self.knots_v, vs)];
        // Memory that nobody has touched yet: whoever fills a part of it lets the system find it.
        let mut points: Vec<DVec3> = zeroed_vec(us.len() * vs.len());
        let mut normals: Vec<DVec3> = zeroed_vec(us.len() * vs.len());
        let parts = side_by_side::parts(&mut points, vs.len(), n_threads)
            .into_iter()
            .zip(side_by_side::parts(&mut normals, vs.len(), n_threads));
        side_by_side::each(parts.collect(), |(points, normals)| {
            self.sample_rows(&tables, [us, vs], points, normals.values);
        });
        let (points, normals) =
            (Grid::from_rows_of(vs.len(), points), Grid::from_rows_of(vs.len(), normals));
        GridSamples { points, normals }
    }

    /// Some rows of points and normals.
    fn sample_rows(
        &self,
        [table_u, table_v]: &[BasisTable; 2],
        [us, vs]: [&[f64]; 2],
        points: RowBlock<'_, DVec3>,
        normals: &mut [DVec3],
    ) {
        let mut strip = Vec::with_capacity(self.control_points.n_columns());
        let rows_u = us.iter().zip(table_u.rows()).skip(points.first);
        let rows = points.values.chunks_mut(vs.len()).zip(normals.chunks_mut(vs.len()));
        for ((points, normals), (&u, (span_u, functions_u))) in rows.zip(rows_u) {
            // What is left at zero is thrown away with all else.
            if !work::goes_on(1) {
                return;
            }
            self.contract(span_u.first, functions_u, &mut strip);
            let fold = self.fold_area / span_u.width;
            let places = points.iter_mut().zip(normals);
            for ((place, facing), (&v, along_v)) in places.zip(vs.iter().zip(table_v.rows())) {
                (*place, *facing) = self.sample_of_strip(&strip, along_v, [u, v], fold);
            }
        }
    }

    /// Points and unit normals at some of the crossings of lines of constant u and of constant v, told by the numbers of
    /// both lines: those on one line of constant u behind one another, or each such line is gone along once more.
    ///
    /// # Errors
    /// `GeomError::Ended`.
    pub(crate) fn samples_at_crossings(
        &self,
        [us, vs]: [&[f64]; 2],
        crossings: &[[usize; 2]],
    ) -> Result<Vec<(DVec3, DVec3)>, GeomError> {
        let [table_u, table_v] =
            [BasisTable::new(&self.knots_u, us), BasisTable::new(&self.knots_v, vs)];
        let mut strip = Vec::with_capacity(self.control_points.n_columns());
        let mut samples = Vec::with_capacity(crossings.len());
        for on_line in crossings.chunk_by(|a, b| a[0] == b[0]) {
            GeomError::go_on(1)?;
            let i = on_line[0][0];
            let (span, functions) = table_u.at(i);
            self.contract(span.first, functions, &mut strip);
            let fold = self.fold_area / span.width;
            let sample = |&[_, j]: &[usize; 2]| {
                self.sample_of_strip(&strip, table_v.at(j), [us[i], vs[j]], fold)
            };
            samples.extend(on_line.iter().map(sample));
        }
        Ok(samples)
    }

    /// The point and the unit normal where a line of constant u, by the sums along it, comes to a v; `fold` is the least
    /// area that a normal has, for each of the span along u.
    #[inline]
    fn sample_of_strip(
        &self,
        strip: &[ColumnSum],
        (span, functions): (ActiveSpan, &[[f64; 2]]),
        [u, v]: [f64; 2],
        fold: f64,
    ) -> (DVec3, DVec3) {
        let sums = HomogeneousSums::over(&strip[span.first..], functions);
        let (point, normal) = sums.point_and_normal();
        let length = normal.length_squared().sqrt();
        let is_regular = fold * (sums.value.w * sums.value.w) < length * span.width;
        let normal = if is_regular { normal * (1.0 / length) } else { self.shading_normal(u, v) };
        (point, normal)
    }

    /// Sums every column of the net over the rows from `first` on into the strip.
    fn contract(&self, first: usize, functions: &[[f64; 2]], strip: &mut Vec<ColumnSum>) {
        let empty = ColumnSum { value: DVec4::ZERO, along_u: DVec4::ZERO };
        strip.clear();
        strip.resize(self.control_points.n_columns(), empty);
        for (i, [n, dn]) in functions.iter().enumerate() {
            for (sum, &point) in strip.iter_mut().zip(self.control_points.row(first + i)) {
                sum.value += point * *n;
                sum.along_u += point * *dn;
            }
        }
    }
}

/// The homogeneous point with its first derivatives.
struct HomogeneousSums {
    value: DVec4,
    along_u: DVec4,
    along_v: DVec4,
}

impl HomogeneousSums {
    /// Contracts the columns at the head of the strip, as many as there are functions.
    fn over(strip: &[ColumnSum], functions: &[[f64; 2]]) -> Self {
        // Lengths known to the compiler unroll the loop.
        match functions.len() {
            2 => Self::over_array::<2>(strip, functions),
            3 => Self::over_array::<3>(strip, functions),
            4 => Self::over_array::<4>(strip, functions),
            _ => Self::over_slice(strip, functions),
        }
    }

    #[inline]
    fn over_array<const N: usize>(strip: &[ColumnSum], functions: &[[f64; 2]]) -> Self {
        match (strip.first_chunk::<N>(), functions.first_chunk::<N>()) {
            (Some(strip), Some(functions)) => Self::over_slice(strip, functions),
            _ => Self::over_slice(strip, functions),
        }
    }

    #[inline]
    fn over_slice(strip: &[ColumnSum], functions: &[[f64; 2]]) -> Self {
        let mut sums = Self { value: DVec4::ZERO, along_u: DVec4::ZERO, along_v: DVec4::ZERO };
        for (column, [n, dn]) in strip.iter().zip(functions) {
            sums.value += column.value * *n;
            sums.along_u += column.along_u * *n;
            sums.along_v += column.value * *dn;
        }
        sums
    }

    /// The point, and Su × Sv times the square of the weight.
    fn point_and_normal(&self) -> (DVec3, DVec3) {
        let point = self.value.truncate() * (1.0 / self.value.w);
        let tangent_u = self.along_u.truncate() - point * self.along_u.w;
        let tangent_v = self.along_v.truncate() - point * self.along_v.w;
        (point, tangent_u.cross(tangent_v))
    }
}
