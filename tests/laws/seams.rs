//! Laws of meshes of surfaces and faces side by side whose edges are shared only in part: they are closed where
//! the whole is, and open where it is open.

use std::{f64::consts::TAU, sync::Arc};

use glam::DVec3;
use proptest::{
    collection::vec,
    prelude::{ProptestConfig, Strategy, any},
    prop_assert, prop_assert_eq, proptest,
};
use virote_kernel::{
    CircleForm, Cutter, DeviationReference, Direction, Face, Frame, Grid, KnotVector, Mesh,
    MeshDistance, NurbsCurve, NurbsSurface, Region, Surface, SurfacePiece, TessellationOptions,
    Tolerance, pieces_facing_unlike, tessellate_all, tessellate_together,
};

use crate::some::motion;

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
    #![proptest_config(ProptestConfig::with_cases(16))]

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

/// Surfaces and faces in one list.
#[derive(Default)]
struct Pieces {
    surfaces: Vec<Surface>,
    faces: Vec<Face>,
}

impl Pieces {
    fn all(&self) -> Vec<SurfacePiece<'_>> {
        let surfaces = self.surfaces.iter().map(SurfacePiece::Whole);
        surfaces.chain(self.faces.iter().map(SurfacePiece::Part)).collect()
    }

    fn meshed(&self, tolerance: f64) -> Mesh {
        let options = TessellationOptions::within(tolerance);
        Mesh::merged(&tessellate_together(&self.all(), &options, MOST).unwrap(), MOST).unwrap()
    }

    /// All with their fronts outward.
    fn oriented(mut self) -> Self {
        let turns = pieces_facing_unlike(&self.all(), Tolerance::DEFAULT).unwrap();
        let (of_surfaces, of_faces) = turns.split_at(self.surfaces.len());
        for (surface, _) in self.surfaces.iter_mut().zip(of_surfaces).filter(|(_, turns)| **turns) {
            *surface = surface.reversed(Direction::V).unwrap();
        }
        for (face, _) in self.faces.iter_mut().zip(of_faces).filter(|(_, turns)| **turns) {
            *face = face.reversed();
        }
        self
    }
}

/// A prism whose top is turned against its bottom, so that its walls are twisted: each a surface in pieces, between
/// two faces. With each corner comes its distance from the axis, where the wall from it is cut along its length, and
/// where its halves are cut across.
fn twisted_prism(corners: &[(f64, f64, [f64; 2])], twist: f64) -> Pieces {
    let n = corners.len();
    let place = |i: usize, turn: f64, z: f64| {
        let angle = TAU * (i % n) as f64 / n as f64 + turn;
        corners[i % n].0 * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0) + DVec3::Z * z
    };
    let ends = [(0.0, -1.0), (twist, 1.5)].map(|(turn, z)| move |i: usize| place(i, turn, z));
    let mut pieces = Pieces::default();
    for (i, &(_, along, across)) in corners.iter().enumerate() {
        let [a, b] = ends.each_ref().map(|end| [end(i), end(i + 1)]);
        let wall = NurbsSurface::bilinear(a[0], b[0], a[1], b[1]).unwrap();
        for (half, at) in wall.split(Direction::U, along).unwrap().into_iter().zip(across) {
            pieces.surfaces.extend(half.split(Direction::V, at).unwrap().map(Surface::from));
        }
    }
    for end in &ends {
        let corners: Vec<DVec3> = (0..=n).map(end).collect();
        let rim = NurbsCurve::polyline(&corners).unwrap();
        let region = Region::new(&rim, &[], Tolerance::DEFAULT).unwrap();
        pieces.faces.push(Face::of_region(&region, Tolerance::DEFAULT).unwrap());
    }
    pieces
}

/// A ball over a cone over a disc: the part of the sphere is a face, the cone a surface, and the disc a face again.
fn capped_cone(height: f64, foot: f64) -> Pieces {
    let rim = (1.0 - height * height).sqrt();
    let floor = Frame::XY.at(DVec3::Z * (height - 1.5));
    let sphere =
        Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0).unwrap()), Tolerance::DEFAULT)
            .unwrap();
    let cut = Cutter::Plane(Frame::XY.at(DVec3::Z * height));
    let dome = sphere.part_at(&[cut], DVec3::Z, Tolerance::DEFAULT).unwrap();
    let cone = NurbsSurface::cone(floor, [foot, rim], 1.5).unwrap();
    let circle = NurbsCurve::ellipse(floor, [foot; 2], CircleForm::NinePoint).unwrap();
    let disc = Region::new(&circle, &[], Tolerance::DEFAULT).unwrap();
    let disc = Face::of_region(&disc, Tolerance::DEFAULT).unwrap();
    Pieces { surfaces: vec![cone.into()], faces: vec![dome, disc] }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn walls_in_pieces_close_with_faces_however_all_is_turned(
        corners in vec((0.6..1.4, 0.1..0.9, [0.1..0.9, 0.1..0.9]), 3..7),
        twist in -0.5..0.5,
        motion in motion(),
        tolerance in 0.005..0.1,
        flips in any::<u32>(),
    ) {
        let mut pieces = twisted_prism(&corners, twist);
        for (i, surface) in pieces.surfaces.iter_mut().enumerate() {
            *surface = surface.transformed(&motion).unwrap();
            if flips >> (i % 32) & 1 == 1 {
                *surface = surface.reversed(Direction::U).unwrap();
            }
        }
        pieces.faces = pieces.faces.iter().map(|face| face.transformed(&motion).unwrap()).collect();
        let pieces = pieces.oriented();
        let mesh = pieces.meshed(tolerance);
        prop_assert_eq!(shape(&mesh), (2, 0, 1, 0));
        prop_assert!(mesh.check_solid(Tolerance::DEFAULT).is_ok());
        prop_assert!(0.0 < mesh.volume());
    }

    #[test]
    fn a_part_of_a_sphere_closes_with_a_cone_and_that_with_a_disc(
        height in -0.8..0.8,
        foot in 0.3..2.0,
        motion in motion(),
        tolerance in 0.002..0.05,
    ) {
        let mut pieces = capped_cone(height, foot);
        pieces.surfaces[0] = pieces.surfaces[0].transformed(&motion).unwrap();
        pieces.faces = pieces.faces.iter().map(|face| face.transformed(&motion).unwrap()).collect();
        let pieces = pieces.oriented();
        let mesh = pieces.meshed(tolerance);
        prop_assert_eq!(shape(&mesh), (2, 0, 1, 0));
        prop_assert!(mesh.check_solid(Tolerance::DEFAULT).is_ok());
        // The cap of a ball, and the frustum of a cone.
        let (rim2, h) = (1.0 - height * height, 1.0 - height);
        let cap = TAU / 6.0 * h * h * (3.0 - h);
        let frustum = TAU / 6.0 * 1.5 * (rim2 + rim2.sqrt() * foot + foot * foot);
        let area = mesh.area();
        prop_assert!((mesh.volume() - cap - frustum).abs() <= tolerance * area);
    }
}
