//! Values that stay in the library, and curves and surfaces over arrays of parameters.

use std::{
    hash::{DefaultHasher, Hash, Hasher},
    sync::Arc,
};

use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1,
    ndarray::{Array1, Array2},
};
use pyo3::{
    exceptions::{PyTypeError, PyValueError},
    prelude::*,
    types::PyDict,
};
use virote::{
    kernel::{
        Column, Curve, Face, Grid, Interval, KnotVector, Mesh, NurbsCurve, NurbsSurface, Surface,
        Tolerance,
        glam::{DVec3, DVec4},
    },
    value::Value,
};

use crate::{
    arrays,
    blocks::{add, each_flat, flat_array},
    convert,
    errors::geom_error,
    picture,
};

/// A value that stays in the library.
#[pyclass(frozen, module = "virote._virote")]
pub(crate) struct Held {
    pub(crate) value: Value,
}

/// Parameters as they come from Python: a flat array.
type Parameters<'py> = PyReadonlyArray1<'py, f64>;

/// A spline as Python has it: degrees, knot vectors, and the numbers of its homogeneous control points.
type PlainSpline = (Vec<usize>, Vec<Vec<f64>>, Vec<f64>);

/// The curve of one knot vector, or the surface of two, that [`Held::spline`] told of.
#[pyfunction]
pub(crate) fn spline(
    py: Python<'_>,
    degrees: Vec<usize>,
    knots: Vec<Vec<f64>>,
    points: Vec<f64>,
) -> PyResult<Held> {
    let knots =
        degrees.into_iter().zip(knots).map(|(degree, knots)| KnotVector::new(degree, knots));
    let knots = knots.collect::<Result<Vec<_>, _>>().map_err(|err| geom_error(py, err))?;
    let points: Vec<DVec4> = points.as_chunks().0.iter().map(|&point| DVec4::from(point)).collect();
    let made = match <[KnotVector; 2]>::try_from(knots) {
        Ok([u, v]) => {
            let [n_rows, n_columns] =
                [&u, &v].map(|knots| knots.as_slice().len() - knots.degree() - 1);
            Grid::new(n_rows, n_columns, points)
                .and_then(|points| NurbsSurface::new(u, v, points))
                .map(|surface| Value::Surface(surface.into()))
        }
        Err(mut knots) => {
            let wrong = || PyValueError::new_err("a spline has one or two knot vectors");
            let knots = knots.pop().filter(|_| knots.is_empty()).ok_or_else(wrong)?;
            NurbsCurve::new(knots, points).map(|curve| Value::Curve(curve.into()))
        }
    };
    let value = made.map_err(|err| geom_error(py, err))?;
    Ok(Held { value })
}

/// Points as an array of three columns.
fn points_array<'py>(py: Python<'py>, points: &[DVec3]) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let flat: Vec<f64> = points.iter().flat_map(|point| point.to_array()).collect();
    array2(py, points.len(), 3, flat)
}

fn array2(
    py: Python<'_>,
    n_rows: usize,
    n_columns: usize,
    flat: Vec<f64>,
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let array = Array2::from_shape_vec((n_rows, n_columns), flat);
    Ok(array.map_err(|err| PyValueError::new_err(err.to_string()))?.into_pyarray(py))
}

/// Parameters that lie inside the domain, those within rounding of an end at the end.
fn inside(domain: Interval, name: &str, given: &Parameters<'_>) -> PyResult<Vec<f64>> {
    let all = given.as_array();
    let parameters = all.iter().enumerate().map(|(i, &t)| {
        domain.clamp_inside(t).map_err(|_| {
            let (start, end) = (domain.start(), domain.end());
            let place = if all.len() == 1 { String::new() } else { format!(" at index {i}") };
            PyValueError::new_err(format!(
                "{name} = {t}{place} is outside the domain {start}..{end}"
            ))
        })
    });
    parameters.collect()
}

impl Held {
    fn curve(&self) -> PyResult<&Curve> {
        match &self.value {
            Value::Curve(curve) => Ok(curve),
            other => Err(PyTypeError::new_err(format!("{} is no curve", other.phrase()))),
        }
    }

    fn surface(&self) -> PyResult<&Surface> {
        match &self.value {
            Value::Surface(surface) => Ok(surface),
            other => Err(PyTypeError::new_err(format!("{} is no surface", other.phrase()))),
        }
    }

    fn mesh(&self) -> PyResult<&Mesh> {
        match &self.value {
            Value::Mesh(mesh) => Ok(mesh),
            other => Err(PyTypeError::new_err(format!("{} is no mesh", other.phrase()))),
        }
    }

    /// Parameters of a surface, pair by pair.
    fn pairs(&self, u: &Parameters<'_>, v: &Parameters<'_>) -> PyResult<Vec<[f64; 2]>> {
        let surface = self.surface()?;
        let us = inside(surface.domain_u(), "u", u)?;
        let vs = inside(surface.domain_v(), "v", v)?;
        Ok(us.into_iter().zip(vs).map(|(u, v)| [u, v]).collect())
    }
}

#[pymethods]
impl Held {
    /// The kind of value, in the words of the language.
    fn kind(&self) -> &'static str {
        self.value.kind()
    }

    /// The value as `print` would show it.
    fn text(&self) -> String {
        self.value.to_string()
    }

    /// Points of a curve.
    fn curve_points<'py>(
        &self,
        py: Python<'py>,
        t: Parameters<'py>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let curve = self.curve()?;
        let parameters = inside(curve.domain(), "t", &t)?;
        let flat = match curve {
            Curve::Nurbs(curve) => {
                let evaluator = py.detach(|| curve.evaluator());
                flat_array(py, parameters.len(), 3, |range, flat| {
                    evaluator.each_point(&parameters[range], |point| add(flat, point));
                    Ok(())
                })?
            }
            Curve::Parametric(curve) => each_flat(py, &parameters, 3, |&t, flat| {
                add(flat, curve.point_at(t)?);
                Ok(())
            })?,
        };
        array2(py, parameters.len(), 3, flat)
    }

    /// Point and derivatives of a curve: a row for each parameter, three columns for each order.
    fn curve_derivatives<'py>(
        &self,
        py: Python<'py>,
        t: Parameters<'py>,
        order: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let curve = self.curve()?;
        let parameters = inside(curve.domain(), "t", &t)?;
        let n_each = 3 * (order + 1);
        let flat = each_flat(py, &parameters, n_each, |&t, flat| {
            curve.derivatives_at(t, order)?.into_iter().for_each(|vector| add(flat, vector));
            Ok(())
        })?;
        array2(py, parameters.len(), n_each, flat)
    }

    /// Points of a surface.
    fn surface_points<'py>(
        &self,
        py: Python<'py>,
        u: Parameters<'py>,
        v: Parameters<'py>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let pairs = self.pairs(&u, &v)?;
        let flat = match self.surface()? {
            Surface::Nurbs(surface) => {
                let evaluator = py.detach(|| surface.evaluator());
                flat_array(py, pairs.len(), 3, |range, flat| {
                    evaluator.each_point(&pairs[range], |point| add(flat, point));
                    Ok(())
                })?
            }
            surface => each_flat(py, &pairs, 3, |&[u, v], flat| {
                add(flat, surface.point_at(u, v)?);
                Ok(())
            })?,
        };
        array2(py, pairs.len(), 3, flat)
    }

    /// Derivatives of a surface up to an order: a row for each place; for each pair of orders, those
    /// in u slowest, three columns.
    fn surface_derivatives<'py>(
        &self,
        py: Python<'py>,
        u: Parameters<'py>,
        v: Parameters<'py>,
        order: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (pairs, surface) = (self.pairs(&u, &v)?, self.surface()?);
        let n_each = 3 * (order + 1) * (order + 1);
        let flat = each_flat(py, &pairs, n_each, |&[u, v], flat| {
            let grid = surface.derivatives_at(u, v, order)?;
            for (i, j) in (0..=order).flat_map(|i| (0..=order).map(move |j| (i, j))) {
                add(flat, if i + j <= order { grid.get(i, j) } else { DVec3::NAN });
            }
            Ok(())
        })?;
        array2(py, pairs.len(), n_each, flat)
    }

    /// Unit normals of a surface.
    fn surface_normals<'py>(
        &self,
        py: Python<'py>,
        u: Parameters<'py>,
        v: Parameters<'py>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (pairs, surface) = (self.pairs(&u, &v)?, self.surface()?);
        let flat = each_flat(py, &pairs, 3, |&[u, v], flat| {
            add(flat, surface.normal_at(u, v)?);
            Ok(())
        })?;
        array2(py, pairs.len(), 3, flat)
    }

    /// Curvatures of a surface: columns k1, k2, Gaussian and mean.
    fn surface_curvatures<'py>(
        &self,
        py: Python<'py>,
        u: Parameters<'py>,
        v: Parameters<'py>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (pairs, surface) = (self.pairs(&u, &v)?, self.surface()?);
        let flat = each_flat(py, &pairs, 4, |&[u, v], flat| {
            let shape = surface.shape_at(u, v)?;
            let [k1, k2] = shape.curvatures();
            flat.extend([k1, k2, shape.gaussian(), shape.mean()]);
            Ok(())
        })?;
        array2(py, pairs.len(), 4, flat)
    }

    /// Whether both are splines of the same numbers.
    fn same(&self, other: &Self) -> bool {
        match (&self.value, &other.value) {
            (Value::Curve(Curve::Nurbs(a)), Value::Curve(Curve::Nurbs(b))) => {
                a.knots() == b.knots() && a.control_points() == b.control_points()
            }
            (Value::Surface(Surface::Nurbs(a)), Value::Surface(Surface::Nurbs(b))) => {
                [a.knots_u(), a.knots_v()] == [b.knots_u(), b.knots_v()]
                    && a.control_points() == b.control_points()
            }
            _ => false,
        }
    }

    /// A number that splines of the same numbers share; none of other values.
    fn key(&self) -> Option<u64> {
        let (degrees, knots, points) = self.spline()?;
        let mut hasher = DefaultHasher::new();
        degrees.hash(&mut hasher);
        for number in knots.iter().flatten().chain(&points) {
            // Zeros of both signs are the same.
            (number + 0.0).to_bits().hash(&mut hasher);
        }
        Some(hasher.finish())
    }

    /// Degrees, knot vectors and homogeneous control points one behind the other, of which [`spline`] makes the
    /// same curve or surface again; none of what is no spline.
    fn spline(&self) -> Option<PlainSpline> {
        let flat = |points: &[DVec4]| points.iter().flat_map(DVec4::to_array).collect();
        match &self.value {
            Value::Curve(Curve::Nurbs(curve)) => {
                let knots = vec![curve.knots().as_slice().to_vec()];
                Some((vec![curve.degree()], knots, flat(curve.control_points())))
            }
            Value::Surface(Surface::Nurbs(surface)) => {
                let knots = [surface.knots_u(), surface.knots_v()];
                let knots = knots.map(|knots| knots.as_slice().to_vec()).into();
                let degrees = vec![surface.degree_u(), surface.degree_v()];
                Some((degrees, knots, flat(surface.control_points().as_slice())))
            }
            _ => None,
        }
    }

    /// A shaded picture in PNG; nothing where there is nothing to draw.
    #[pyo3(signature = (size, view = None))]
    fn picture(
        &self,
        py: Python<'_>,
        size: [usize; 2],
        view: Option<String>,
    ) -> PyResult<Option<Vec<u8>>> {
        picture::of_value(py, &self.value, size, view.as_deref())
    }

    /// What a curve, surface, mesh or table is made of, by name.
    fn parts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        arrays::load(py)?;
        let parts = PyDict::new(py);
        match &self.value {
            Value::Curve(curve) => curve_parts(py, curve, &parts)?,
            Value::Surface(surface) => surface_parts(py, surface, &parts)?,
            Value::Mesh(_) => mesh_parts(py, self.mesh()?, &parts)?,
            Value::Table(table) => {
                let (columns, units) = (PyDict::new(py), PyDict::new(py));
                for column in table.columns() {
                    match &column.column {
                        Column::Numbers(numbers) => {
                            columns.set_item(&column.name, PyArray1::from_slice(py, numbers))?;
                        }
                        Column::Texts(texts) => columns.set_item(&column.name, texts)?,
                    }
                    if let Some(unit) = &column.unit {
                        units.set_item(&column.name, unit)?;
                    }
                }
                parts.set_item("columns", columns)?;
                parts.set_item("units", units)?;
            }
            Value::Region(region) => {
                let borders = py.detach(|| region.borders()).map_err(|err| geom_error(py, err))?;
                let borders = borders
                    .into_iter()
                    .map(|border| convert::to_python(py, &Value::Curve(border.into())));
                parts.set_item("borders", borders.collect::<PyResult<Vec<_>>>()?)?;
            }
            Value::Face(face) => self.face_parts(py, face, &parts)?,
            Value::Solid(solid) => {
                let faces = solid.faces().iter().map(|face| {
                    let face = Value::Face(Arc::new(face.clone()));
                    convert::to_python(py, &face)
                });
                parts.set_item("faces", faces.collect::<PyResult<Vec<_>>>()?)?;
            }
            Value::Frame(frame) => {
                let vectors = [
                    ("origin", frame.origin()),
                    ("x", frame.x()),
                    ("y", frame.y()),
                    ("z", frame.z()),
                ];
                for (name, vector) in vectors {
                    parts.set_item(name, convert::point(py, vector))?;
                }
            }
            _ => {}
        }
        Ok(parts)
    }
}

impl Held {
    fn face_parts(
        &self,
        py: Python<'_>,
        face: &Arc<Face>,
        parts: &Bound<'_, PyDict>,
    ) -> PyResult<()> {
        let curves = |curves: Vec<NurbsCurve>| {
            let curves =
                curves.into_iter().map(|curve| convert::to_python(py, &Value::Curve(curve.into())));
            curves.collect::<PyResult<Vec<_>>>()
        };
        let tolerance = Tolerance::DEFAULT;
        let edges = py.detach(|| face.edges(tolerance)).map_err(|err| geom_error(py, err))?;
        let loops = py.detach(|| face.loops(tolerance)).map_err(|err| geom_error(py, err))?;
        let surface = Value::Surface(Surface::Nurbs(Arc::clone(face.surface())));
        parts.set_item("surface", convert::to_python(py, &surface)?)?;
        parts.set_item("edges", curves(edges)?)?;
        parts.set_item("loops", curves(loops)?)
    }
}

/// The points and weights of homogeneous control points; those of weight zero stay as they are.
fn control_points<'py>(
    py: Python<'py>,
    homogeneous: &[DVec4],
    parts: &Bound<'py, PyDict>,
) -> PyResult<()> {
    let point = |h: &DVec4| if h.w > 0.0 { h.truncate() / h.w } else { h.truncate() };
    let points: Vec<DVec3> = homogeneous.iter().map(point).collect();
    parts.set_item("control_points", points_array(py, &points)?)?;
    let weights: Array1<f64> = homogeneous.iter().map(|h| h.w).collect();
    parts.set_item("weights", weights.into_pyarray(py))
}

fn curve_parts<'py>(py: Python<'py>, curve: &Curve, parts: &Bound<'py, PyDict>) -> PyResult<()> {
    let domain = curve.domain();
    parts.set_item("domain", (domain.start(), domain.end()))?;
    let Curve::Nurbs(curve) = curve else { return Ok(()) };
    parts.set_item("degree", curve.degree())?;
    parts.set_item("knots", PyArray1::from_slice(py, curve.knots().as_slice()))?;
    parts.set_item("rational", curve.is_rational())?;
    control_points(py, curve.control_points(), parts)
}

fn surface_parts<'py>(
    py: Python<'py>,
    surface: &Surface,
    parts: &Bound<'py, PyDict>,
) -> PyResult<()> {
    let (u, v) = (surface.domain_u(), surface.domain_v());
    parts.set_item("domain", ((u.start(), u.end()), (v.start(), v.end())))?;
    let Surface::Nurbs(surface) = surface else { return Ok(()) };
    parts.set_item("degree", (surface.degree_u(), surface.degree_v()))?;
    let knots = [surface.knots_u(), surface.knots_v()];
    let [u, v] = knots.map(|knots| PyArray1::from_slice(py, knots.as_slice()));
    parts.set_item("knots", (u, v))?;
    parts.set_item("rational", surface.is_rational())?;
    let net = surface.control_points();
    parts.set_item("shape", (net.n_rows(), net.n_columns()))?;
    control_points(py, net.as_slice(), parts)
}

fn mesh_parts<'py>(py: Python<'py>, mesh: &Mesh, parts: &Bound<'py, PyDict>) -> PyResult<()> {
    parts.set_item("points", points_array(py, mesh.vertices())?)?;
    parts.set_item("normals", points_array(py, mesh.normals())?)?;
    let uvs: Vec<f64> = mesh.uvs().iter().flat_map(|uv| uv.to_array()).collect();
    parts.set_item("uv", array2(py, mesh.uvs().len(), 2, uvs)?)?;
    let corners: Vec<u32> = mesh.triangles().iter().flatten().copied().collect();
    let triangles = PyArray1::from_vec(py, corners).reshape([mesh.n_triangles(), 3])?;
    parts.set_item("triangles", triangles)
}
