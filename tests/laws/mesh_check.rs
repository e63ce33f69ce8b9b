//! How the triangles of meshes hang together: bodies and bands whose answers are known.

use glam::{DAffine3, DVec3};
use virote_kernel::{
    CountError, GeomError, MeasureError, Mesh, MeshCheck, MeshError, MeshGroup, Tolerance,
    facing_inward,
};

const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

fn places(places: &[[f64; 3]]) -> Vec<DVec3> {
    places.iter().map(|&place| DVec3::from(place)).collect()
}

fn mesh(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> Mesh {
    Mesh::new(places(vertices), Vec::new(), Vec::new(), triangles.to_vec()).unwrap()
}

fn tetrahedron() -> Mesh {
    mesh(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], &TETRAHEDRON)
}

fn check(mesh: &Mesh) -> MeshCheck {
    mesh.check(Tolerance::DEFAULT)
}

const SPHERE: MeshCheck = MeshCheck {
    is_closed: true,
    is_manifold: true,
    is_oriented: true,
    degenerate: 0,
    euler: 2,
    boundaries: 0,
    components: 1,
    counts: [4, 6, 4],
};

#[test]
fn a_tetrahedron_is_a_sphere() {
    let mesh = tetrahedron();
    assert_eq!(check(&mesh), SPHERE);
    assert!((mesh.volume() - 1.0 / 6.0).abs() < 1e-15);
    assert!((mesh.area() - (1.5 + 0.75_f64.sqrt())).abs() < 1e-15);
    assert!(mesh.volume_centroid().unwrap().distance(DVec3::splat(0.25)) < 1e-15);
}

#[test]
fn triangles_over_vertices_of_their_own_hang_together_by_place() {
    let soup: Vec<DVec3> = tetrahedron().corners().flatten().collect();
    let triangles = (0..4).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = Mesh::new(soup, Vec::new(), Vec::new(), triangles).unwrap();
    assert_eq!(check(&mesh), SPHERE);
}

#[test]
fn a_mesh_without_a_triangle_has_a_hole_around_it() {
    let open = mesh(
        &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        &TETRAHEDRON[..3],
    );
    let found = check(&open);
    assert_eq!((found.is_closed, found.boundaries, found.euler), (false, 1, 1));
    let topology = open.topology(Tolerance::DEFAULT);
    // Against the triangle that is missing.
    assert_eq!(topology.boundary_lines(), [[0, 2, 3, 0]]);
    let solid = open.check_solid(Tolerance::DEFAULT);
    assert!(matches!(solid, Err(GeomError::Mesh(MeshError::Open { edges: 3, loops: 1, .. }))));
}

#[test]
fn a_turned_triangle_has_no_inside() {
    let mut triangles = TETRAHEDRON;
    triangles[3].swap(0, 1);
    let vertices = tetrahedron().vertices().to_vec();
    let turned = Mesh::new(vertices, Vec::new(), Vec::new(), triangles.to_vec()).unwrap();
    assert_eq!(check(&turned), MeshCheck { is_oriented: false, ..SPHERE });
    let solid = turned.check_solid(Tolerance::DEFAULT);
    assert!(matches!(solid, Err(GeomError::Mesh(MeshError::Unoriented { .. }))));
}

#[test]
fn two_bodies_that_touch_in_a_corner_are_no_manifold() {
    let mirrored = tetrahedron().transformed(&DAffine3::from_scale(DVec3::NEG_ONE));
    let both = Mesh::merged(&[tetrahedron(), mirrored.clone()], 100).unwrap();
    let found = check(&both);
    assert!(found.is_closed && found.is_oriented && !found.is_manifold);
    assert_eq!((found.euler, found.components, found.counts), (3, 1, [7, 12, 8]));

    let apart = mirrored.transformed(&DAffine3::from_translation(DVec3::NEG_X));
    let both = Mesh::merged(&[tetrahedron(), apart], 100).unwrap();
    let found = check(&both);
    assert_eq!((found.is_manifold, found.euler, found.components), (true, 4, 2));
}

#[test]
fn three_triangles_at_an_edge_are_no_manifold() {
    let vertices =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]];
    let found = check(&mesh(&vertices, &[[0, 1, 2], [0, 1, 3], [0, 1, 4]]));
    assert!(!found.is_manifold && !found.is_closed);
}

#[test]
fn two_triangles_that_touch_in_a_corner_have_two_borders() {
    let vertices =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [-1.0, -1.0, 0.0]];
    let found = check(&mesh(&vertices, &[[0, 1, 2], [0, 3, 4]]));
    assert_eq!((found.boundaries, found.is_manifold, found.components), (2, false, 1));
}

#[test]
fn a_moebius_strip_has_one_side_and_one_border() {
    let n = 24;
    let mut vertices = Vec::new();
    for i in 0..n {
        let angle = std::f64::consts::TAU * f64::from(i) / f64::from(n);
        let (up, out) = libm::sincos(0.5 * angle);
        let around = |r: f64| [r * libm::cos(angle), r * libm::sin(angle)];
        for side in [-0.3, 0.3] {
            let [x, y] = around(1.0 + side * out);
            vertices.push([x, y, side * up]);
        }
    }
    let mut triangles = Vec::new();
    for i in 0..n as u32 {
        let (a, b) = (2 * i, 2 * i + 1);
        // Behind the last pair comes the first, turned over.
        let (c, d) = if i + 1 == n as u32 { (1, 0) } else { (a + 2, b + 2) };
        triangles.extend([[a, c, d], [a, d, b]]);
    }
    let found = check(&mesh(&vertices, &triangles));
    assert_eq!((found.euler, found.boundaries, found.components), (0, 1, 1));
    assert!(found.is_manifold && !found.is_oriented && !found.is_closed);
}

#[test]
fn triangles_without_area_count_apart() {
    let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, 0.0]];
    let found = check(&mesh(&vertices, &[[0, 1, 2], [0, 3, 1], [1, 1, 2]]));
    assert_eq!((found.degenerate, found.counts), (2, [3, 3, 1]));
}

#[test]
fn nothing_hangs_together_in_an_empty_mesh() {
    let found = check(&Mesh::default());
    assert_eq!((found.euler, found.components, found.counts), (0, 0, [0, 0, 0]));
    assert!(matches!(
        Mesh::default().area_centroid(),
        Err(GeomError::Measure(MeasureError::NothingThere { .. }))
    ));
}

#[test]
fn colours_and_groups_stay_with_their_triangles() {
    let red = vec![DVec3::X; 4];
    let colored = tetrahedron().with_colors(red).unwrap().in_group("red");
    let both = Mesh::merged(&[tetrahedron(), colored], 100).unwrap();
    assert_eq!((both.colors()[0], both.colors()[7]), (DVec3::ONE, DVec3::X));
    let group = |name: &str| MeshGroup { name: name.to_owned(), n_triangles: 4 };
    assert_eq!(both.groups(), [group(""), group("red")]);

    let few = tetrahedron().with_colors(vec![DVec3::X; 3]);
    assert!(matches!(
        few,
        Err(GeomError::Count(CountError::AttributeCount { vertices: 4, got: 3, .. }))
    ));
    let bright = tetrahedron().with_colors(vec![DVec3::X, DVec3::X * 2.0, DVec3::X, DVec3::X]);
    assert!(matches!(bright, Err(GeomError::Mesh(MeshError::BadColor { index: 1, .. }))));
    assert!(matches!(
        tetrahedron().with_groups(vec![group("a"); 2]),
        Err(GeomError::Count(CountError::WrongCount { .. }))
    ));
}

/// The triangles that face outward, those of `turned` turned over, in two meshes.
fn in_two(vertices: &[[f64; 3]], triangles: &[[u32; 3]], turned: usize) -> [Mesh; 2] {
    let way = |(i, &[a, b, c]): (usize, &[u32; 3])| {
        if turned >> i & 1 == 1 { [a, c, b] } else { [a, b, c] }
    };
    let triangles: Vec<[u32; 3]> = triangles.iter().enumerate().map(way).collect();
    let (first, second) = triangles.split_at(triangles.len() / 2);
    [first, second].map(|part| mesh(vertices, part))
}

fn facing_outward(meshes: &[Mesh]) -> Mesh {
    let borrowed: Vec<&Mesh> = meshes.iter().collect();
    let turns = facing_inward(&borrowed);
    let parts: Vec<Mesh> =
        meshes.iter().zip(turns).map(|(mesh, turns)| mesh.with_turned(&turns)).collect();
    Mesh::merged(&parts, 1000).unwrap()
}

#[test]
fn a_closed_body_faces_outward_whichever_triangles_were_turned() {
    let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // Far away and tiny, where a sum of volumes about the origin would lose its sign.
    for (size, shift) in [(1.0, 0.0), (1e-3, 1e4), (1e150, 0.0), (1e-150, 0.0)] {
        let vertices = vertices.map(|place| place.map(|x| shift + size * x));
        for turned in 0..16 {
            let whole = facing_outward(&in_two(&vertices, &TETRAHEDRON, turned));
            let outward = Mesh::merged(&in_two(&vertices, &TETRAHEDRON, 0), 1000).unwrap();
            assert_eq!(whole.triangles(), outward.triangles(), "{turned} at {size}");
        }
    }
}

#[test]
fn bodies_that_share_an_edge_face_outward_each() {
    let vertices = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, -1.0],
    ];
    let other: [[u32; 3]; 4] = [[0, 4, 1], [0, 1, 5], [1, 4, 5], [0, 5, 4]];
    let both: Vec<[u32; 3]> = TETRAHEDRON.into_iter().chain(other).collect();
    for turned in 0..256 {
        let whole = facing_outward(&in_two(&vertices, &both, turned));
        assert!((whole.volume() - 1.0 / 3.0).abs() < 1e-15, "{turned}");
    }
}

#[test]
fn what_has_no_outside_stays_as_it_is() {
    let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // Without one of its triangles a body is open.
    let [first, second] = in_two(&vertices, &TETRAHEDRON[..3], 2);
    assert_eq!(facing_inward(&[&first, &second]), [vec![false], vec![false, false]]);
    // Two triangles back to back enclose nothing, but can face alike.
    let flat = mesh(&vertices, &[[0, 1, 2], [0, 1, 2]]);
    assert_eq!(facing_inward(&[&flat]), [[false, true]]);
    // A cavity faces inward.
    let large = vertices.map(|place| place.map(|x| 100.0 * x - 20.0));
    let [a, b] = in_two(&large, &TETRAHEDRON, 0);
    let [c, d] = in_two(&vertices, &TETRAHEDRON, 15);
    assert!(facing_inward(&[&a, &b, &c, &d]).into_iter().flatten().all(|turns| !turns));
    assert_eq!(facing_inward(&[&c, &d]), [[true; 2]; 2]);
}

#[test]
fn a_turned_vertex_with_a_normal_turns_its_normal() {
    let places_of = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let normals = vec![DVec3::Z; 4];
    let quad = Mesh::new(places(&places_of), normals, Vec::new(), vec![[0, 1, 2], [2, 1, 3]]);
    let turned = quad.unwrap().with_turned(&[false, true]);
    // The vertices on the common edge are there twice.
    assert_eq!((turned.n_vertices(), turned.triangles()[0]), (6, [0, 1, 2]));
    for (corners, normal) in turned.triangles().iter().zip([DVec3::Z, -DVec3::Z]) {
        let [a, b, c] = corners.map(|i| turned.vertices()[i as usize]);
        assert!((b - a).cross(c - a).dot(normal) > 0.0);
        assert!(corners.iter().all(|&i| turned.normals()[i as usize] == normal));
    }
}

#[test]
fn plates_balance_in_the_mean_of_their_middles_weighed_by_area() {
    // Two plates of areas 3 and 2 with their middles in (11/3, 2, 2) and (10, 2/3, 2/3).
    let vertices = [
        [3.0, 1.0, 2.0],
        [5.0, 1.0, 2.0],
        [3.0, 4.0, 2.0],
        [10.0, 0.0, 0.0],
        [10.0, 2.0, 0.0],
        [10.0, 0.0, 2.0],
    ];
    let expected = DVec3::new(31.0, 22.0 / 3.0, 22.0 / 3.0) / 5.0;
    for (size, shift) in [(1.0, 0.0), (1e-3, 1e3), (1e200, 0.0), (1e-200, 0.0)] {
        let vertices = vertices.map(|place| place.map(|x| shift + size * x));
        let plates = mesh(&vertices, &[[0, 1, 2], [3, 4, 5]]);
        let found = (plates.area_centroid().unwrap() - shift) / size;
        assert!(found.distance(expected) < 1e-9, "{found} at {size}");
    }
}

/// A cube of two triangles a side, which faces outward.
fn cube() -> Mesh {
    let corner = |i: usize| [i & 1, i >> 1 & 1, i >> 2].map(|x| x as f64);
    let vertices: Vec<[f64; 3]> = (0..8).map(corner).collect();
    let sides =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles: Vec<[u32; 3]> =
        sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    mesh(&vertices, &triangles)
}

#[test]
fn a_cube_has_twelve_edges_and_eighteen_with_its_diagonals() {
    assert!((cube().volume() - 1.0).abs() < 1e-15);
    let lengths = |mesh: &Mesh| -> Vec<usize> {
        let squared = |[a, b]: [u32; 2]| {
            let [a, b] = [a, b].map(|idx| mesh.vertices()[idx as usize]);
            a.distance_squared(b) as usize
        };
        mesh.face_edges().into_iter().map(squared).collect()
    };
    assert_eq!(lengths(&cube().with_faces(vec![2; 6]).unwrap()), [1; 12]);
    let all = lengths(&cube());
    assert_eq!([1, 2].map(|of| all.iter().filter(|&&squared| squared == of).count()), [12, 6]);
}

#[test]
fn a_face_that_is_turned_as_a_whole_stays_one() {
    let squares = cube().with_faces(vec![2; 6]).unwrap();
    let sizes = |mesh: &Mesh| -> Vec<usize> { mesh.faces().map(|corners| corners.len()).collect() };
    for side in 0..6 {
        let of_side = |i: usize| i / 2 == side;
        let turned = squares.with_turned(&(0..12).map(of_side).collect::<Vec<bool>>());
        assert_eq!(sizes(&turned), [4; 6], "{side}");
        assert_eq!(turned.face_edges(), squares.face_edges(), "{side}");
        // A cube without a side, with as much taken away as the side's pyramid about the origin.
        let pyramid = if side % 2 == 1 { 1.0 / 3.0 } else { 0.0 };
        assert!((turned.volume() - (1.0 - 2.0 * pyramid)).abs() < 1e-15, "{side}");
        // One triangle turned leaves two faces.
        let torn = squares.with_turned(&(0..12).map(|i| i == 2 * side).collect::<Vec<bool>>());
        let expected: Vec<usize> =
            (0..6).flat_map(|i| if i == side { vec![3, 3] } else { vec![4] }).collect();
        assert_eq!(sizes(&torn), expected, "{side}");
    }
}
