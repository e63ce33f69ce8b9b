//! What changes too fast to be measured is refused, by each measure in its own words.

use std::sync::Arc;

use virote::{
    diag::Code,
    kernel::{
        FunctionFailure, Grid, Interval, ParametricSurface, Surface, SurfaceFunction, Tolerance,
        glam::DVec3,
    },
    session::{Arguments, Session},
    syntax::ast::Unit,
    value::{NoFiles, Value},
};

/// (u, v, sin(1/(u + 1e-5))), whose waves come ever closer towards u = 0: 16000 of them.
#[derive(Debug)]
struct Ripples;

impl SurfaceFunction for Ripples {
    fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, FunctionFailure> {
        let inverse = 1.0 / (u + 1e-5);
        let (sine, cosine) = (libm::sin(inverse), libm::cos(inverse));
        let slope = -inverse * inverse;
        let values = [
            DVec3::new(u, v, sine),
            DVec3::new(1.0, 0.0, cosine * slope),
            DVec3::Z * (2.0 * inverse * inverse * inverse * cosine - slope * slope * sine),
        ];
        let n = order + 1;
        let mut all = vec![DVec3::ZERO; n * n];
        for (k, value) in values.into_iter().enumerate().take(n) {
            all[k * n] = value;
        }
        if 1 < n {
            all[1] = DVec3::Y;
        }
        Ok(Grid::new(n, n, all).expect("as many as it holds"))
    }
}

#[test]
fn areas_and_centroids_of_ripples_are_refused() {
    let unit = Interval::new(0.0, 1.0).expect("an interval");
    let surface = ParametricSurface::new(unit, unit, Arc::new(Ripples)).expect("a surface");
    let surface = Value::Surface(Surface::from(surface));
    let session = Session::default();
    for (measure, of) in [("area", None), ("centroid", Some("area"))] {
        let of = of.map(|of: &str| ("of".to_owned(), Value::Text(of.into())));
        let arguments =
            Arguments { positional: vec![surface.clone()], named: of.into_iter().collect() };
        let function = session.builtin(measure).expect("it is built in");
        let document = (Unit::Mm, Tolerance::DEFAULT);
        let (answer, _) = session.call(&function, arguments, document, &NoFiles);
        let found = answer.expect_err("it cannot be told");
        let message =
            format!("the {measure} cannot be told: the surface changes too fast somewhere");
        assert_eq!((found.code, &found.message), (Code::Degenerate, &message));
    }
}
