//! Laws of meshes of surfaces side by side whose edges are shared only in part: they are closed where
//! the whole is, and open where it is open.

use glam::DVec3;
use proptest::{
    collection::vec,
    prelude::{ProptestConfig, Strategy, any},
    prop_assert, prop_assert_eq, proptest,
};
use virote_kernel::{
    DeviationReference, Direction, Frame, Grid, KnotVector, Mesh, MeshDistance, NurbsSurface,
    Surface, TessellationOptions, Tolerance, tessellate_all,
};

const MOST: usize = 1_000_000;

/// One mesh of all.
fn meshed(surfaces: &[NurbsSurface], tolerance: f64) -> Mesh {
    let surfaces: Vec<Surface> = surfaces.iter().cloned().map(Surface::from).collect();
    let meshes = tessellate_all(&surfaces, &TessellationOptions::within(tolerance), MOST).unwrap();
    Mesh::merged(&meshes, MOST).unwrap()
}

/// How far the mesh is from the surface, and the surface from the mesh.
fn deviations(surface: &NurbsSurface, mesh: &Mesh) -> [f64; 2] {
    let surface = Surface::from(surface.clone());
    let of_mesh =
        mesh.deviation_from(&DeviationReference::of_surface(&surface).unwrap()).unwrap().unwrap();
    let nearest = DeviationReference::Mesh(MeshDistance::new(mesh).unwrap());
    [of_mesh.max, surface.deviation_from(&nearest).unwrap().max]
}

/// The Euler number, the loops where it is open, the parts, and how many triangles have no area.
fn shape(mesh: &Mesh) -> (i64, usize, usize, usize) {
    let check = mesh.check(Tolerance::DEFAULT);
    assert!(check.is_manifold);
    (check.euler, check.boundaries, check.components, check.degenerate)
}

/// How a piece is cut and written anew.
#[derive(Clone, Debug)]
struct FocalPoint {
    /// Which piece is cut, where, and along which direction.
    piece: usize,
    fraction: f64,
    is_u: bool,
    /// How one of the halves is written.
    elevation: [usize; 2],
    knots: [f64; 2],
    reverses: [bool; 2],
    swaps: bool,
}

fn turn() -> impl Strategy<Value = FocalPoint> {
    let cut = (0..100usize, 0.03..0.97, any::<bool>());
    let form = ([0..3usize, 0..3usize], [0.1..0.9, 0.1..0.9], any::<[bool; 2]>(), any::<bool>());
    (cut, form).prop_map(|((piece, fraction, is_u), (elevation, knots, reverses, swaps))| {
        FocalPoint { piece, fraction, is_u, elevation, knots, reverses, swaps }
    })
}

/// The same surface with other degrees, knots and directions.
fn rewritten(mut surface: NurbsSurface, turn: &FocalPoint) -> NurbsSurface {
    for (i, along) in Direction::BOTH.into_iter().enumerate() {
        let degree = surface.knots(along).degree() + turn.elevation[i];
        surface = surface.elevate_degree(along, degree).unwrap();
        let knot = surface.domain(along).at(turn.knots[i]);
        surface = surface.insert_knots(along, &[knot]).unwrap();
        if turn.reverses[i] {
            surface = surface.reversed(along);
        }
    }
    if turn.swaps { surface.swapped() } else { surface }
}

/// The surface in pieces, each a rectangle of its parameters, which meet in parts of their edges.
fn in_pieces(surface: &NurbsSurface, turns: &[FocalPoint]) -> Vec<NurbsSurface> {
    let mut pieces = vec![surface.clone()];
    for turn in turns {
        let piece = pieces.swap_remove(turn.piece % pieces.len());
        let along = if turn.is_u { Direction::U } else { Direction::V };
        let t = piece.domain(along).at(turn.fraction);
        let [before, behind] = piece.split(along, t).unwrap();
        pieces.extend([rewritten(before, turn), behind]);
    }
    pieces
}

/// A patch with a noisy net and weights.
fn patch(noise: &[(f64, f64, f64, f64)]) -> NurbsSurface {
    let knots = KnotVector::uniform_clamped(3, 5, 1.0).unwrap();
    let net = Grid::from_fn(5, 5, |i, j| {
        let (x, y, z, _) = noise[5 * i + j];
        DVec3::new(i as f64 + x, j as f64 + y, z)
    });
    let weights = Grid::from_fn(5, 5, |i, j| noise[5 * i + j].3);
    NurbsSurface::rational(knots.clone(), knots, &net, &weights).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn pieces_of_a_surface_are_open_where_the_surface_is(
        kind in 0..4usize,
        noise in vec((-0.4..0.4, -0.4..0.4, -1.0..1.0, 0.4..2.5), 25),
        turns in vec(turn(), 1..7),
        tolerance in 0.02..0.2,
    ) {
        let surface = match kind {
            0 => NurbsSurface::sphere(Frame::XY, 3.0).unwrap(),
            1 => NurbsSurface::torus(Frame::XY, 3.0, 1.0).unwrap(),
            2 => NurbsSurface::cone(Frame::XY, [2.0, 1.0], 3.0).unwrap(),
            _ => patch(&noise),
        };
        let expected = [(2, 0, 1, 0), (0, 0, 1, 0), (0, 2, 1, 0), (1, 1, 1, 0)][kind];
        let mesh = meshed(&in_pieces(&surface, &turns), tolerance);
        prop_assert_eq!(shape(&mesh), expected);
        let found = deviations(&surface, &mesh);
        prop_assert!(found.iter().all(|found| *found <= tolerance), "{:?} at {}", found, tolerance);
        // Where it is open, there the surface ends.
        let whole = meshed(std::slice::from_ref(&surface), tolerance);
        let open = |mesh: &Mesh| -> f64 {
            let topology = mesh.topology(Tolerance::DEFAULT);
            let place = |vertex: u32| mesh.vertices()[vertex as usize];
            topology.boundary().iter().map(|&[a, b]| place(a).distance(place(b))).sum()
        };
        let [open, expected] = [open(&mesh), open(&whole)];
        prop_assert!((open - expected).abs() <= 0.05 * expected, "{} of {}", open, expected);
    }
}
