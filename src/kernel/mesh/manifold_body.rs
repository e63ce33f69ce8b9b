//! A closed mesh as the library of booleans has it, what two of them make together, and the mesh that comes of it.

use std::collections::{BTreeMap, HashSet};

use glam::DVec3;
use manifold_rust::{
    cancel::CancelToken,
    linalg::Vec3,
    manifold::Manifold,
    progress::ProgressReporter,
    types::{BooleanEngine, Error, MeshGLP, OpType, WindingRule},
};

use super::{
    Mesh,
    coincident::{CoincidentFrame, coincident_triangles},
    fault::MeshError,
    flattened::flattened,
    nesting::check_nesting,
    topology::weld_distance,
    weld::welded,
};
use crate::{Bounds, CountError, GeomError, Tolerance, tolerance::BOOLEAN_RELATIVE, work};

/// What several meshes make together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Combination {
    Union,
    Intersection,
    Difference,
}

/// A closed mesh as the guest has it.
#[derive(Clone)]
pub(super) struct ManifoldBody {
    manifold: Manifold,
    volume: f64,
    area: f64,
    /// Whether it was made of bodies whose faces coincide, but for rounding.
    is_of_coincident: bool,
}

/// How far vertices may move beyond rounding, and what a volume may differ by for each unit of area.
#[derive(Clone, Copy)]
pub(super) struct BooleanTolerance {
    pub(super) merged: f64,
    pub(super) allowed: f64,
}

impl ManifoldBody {
    fn new(manifold: Manifold) -> Result<Self, GeomError> {
        match manifold.status() {
            Error::NoError => {
                let (volume, area) = (manifold.volume(), manifold.surface_area());
                Ok(Self { manifold, volume, area, is_of_coincident: false })
            }
            Error::Cancelled => Err(GeomError::Ended),
            Error::ResultTooLarge => {
                let most = i32::MAX as usize;
                Err(CountError::TooManyVertices { got: most + 1, most }.into())
            }
            // What hangs together as it should is taken in.
            _ => Err(MeshError::Unproven { excess: f64::INFINITY, allowed: 0.0 }.into()),
        }
    }

    fn of(
        vertices: &[DVec3],
        triangles: impl Iterator<Item = [u32; 3]>,
    ) -> Result<Self, GeomError> {
        Self::new(Manifold::from_mesh_glp(&MeshGLP::<f64, u32> {
            num_prop: 3,
            vert_properties: vertices.iter().flat_map(DVec3::to_array).collect(),
            tri_verts: triangles.flatten().collect(),
            ..MeshGLP::default()
        }))
    }

    /// The body of a mesh that encloses each place once or not at all.
    pub(super) fn checked(
        mesh: &Mesh,
        tolerance: Tolerance,
        distance: f64,
    ) -> Result<Self, GeomError> {
        let topology = mesh.check_solid(tolerance).map(|()| mesh.topology(tolerance))?;
        if let Some(vertex) = topology.pinched_vertex() {
            return Err(MeshError::Pinched { at: mesh.vertices[vertex as usize] }.into());
        }
        let mut names: BTreeMap<u32, u32> = BTreeMap::new();
        for &corner in topology.triangles().iter().flatten() {
            let next = names.len() as u32;
            names.entry(corner).or_insert(next);
        }
        let mut vertices = vec![DVec3::ZERO; names.len()];
        names.iter().for_each(|(&corner, &name)| {
            vertices[name as usize] = mesh.vertices[corner as usize];
        });
        let triangles = topology.triangles().iter().map(|corners| corners.map(|i| names[&i]));
        GeomError::go_on(topology.triangles().len())?;
        let body = Self::of(&vertices, triangles)?;
        body.check_crossings(&vertices, distance)?;

        let parts = topology.parts();
        let mut by_part: BTreeMap<u32, Vec<[DVec3; 3]>> = BTreeMap::new();
        for corners in topology.triangles() {
            let part = by_part.entry(parts[corners[0] as usize]).or_default();
            part.push(corners.map(|corner| mesh.vertices[corner as usize]));
        }
        check_nesting(&by_part.into_values().collect::<Vec<_>>())?;
        Ok(body)
    }

    /// Refuses a mesh that crosses or covers itself by more than the distance: where triangles meet
    /// at all, the places that it goes around must have the volume that its triangles tell.
    fn check_crossings(&self, vertices: &[DVec3], distance: f64) -> Result<(), GeomError> {
        if !self.manifold.has_self_intersections() {
            return Ok(());
        }
        for rule in [WindingRule::Positive, WindingRule::Nonzero] {
            GeomError::go_on(self.manifold.num_tri())?;
            let rebuilt = Self::new(self.manifold.rebuild_solid(rule))?;
            if self.area * distance < (rebuilt.volume - self.volume).abs() {
                let bits = |place: DVec3| place.to_array().map(|x| (x + 0.0).to_bits());
                let known: HashSet<[u64; 3]> = vertices.iter().map(|&place| bits(place)).collect();
                let new = rebuilt.vertices().find(|&place| !known.contains(&bits(place)));
                return Err(MeshError::CrossesItself { at: new.unwrap_or(vertices[0]) }.into());
            }
        }
        Ok(())
    }

    /// The same, so that edges that it gets may be merged up to a length.
    pub(super) fn merging(&self, length: f64) -> Self {
        if length == 0.0 {
            return self.clone();
        }
        let mut manifold = self.manifold.clone().into_impl();
        manifold.tolerance = length.max(manifold.epsilon);
        Self { manifold: Manifold::from_impl(manifold), ..self.clone() }
    }

    /// What it makes with another one. The other operation is carried out beside it, for the proof.
    pub(super) fn with(
        &self,
        other: &Self,
        combination: Combination,
        slack: BooleanTolerance,
    ) -> Result<Self, GeomError> {
        // Where faces coincide, in coordinates in which they do so to the last bit.
        let meshes = [self, other].map(Self::raw_mesh);
        let bounds = meshes.iter().filter_map(Mesh::bounds).reduce(Bounds::union);
        let rounding = BOOLEAN_RELATIVE * bounds.map_or(0.0, Bounds::magnitude);
        let coincident = coincident_triangles(&meshes[0], &meshes[1], rounding)?;
        let frame = CoincidentFrame::of(&coincident, meshes.each_ref(), rounding);
        let is_of_coincident =
            !coincident.is_empty() || self.is_of_coincident || other.is_of_coincident;
        let done = |operation| {
            let body = match &frame {
                None => self.by_guest(other, operation)?,
                Some((frame, [one, other])) => {
                    let [one, other] = [one, other].map(|mesh| {
                        let body = Self::of(&mesh.vertices, mesh.triangles.iter().copied());
                        body.map(|body| body.merging(slack.merged))
                    });
                    let made = frame.without(one?.by_guest(&other?, operation)?.raw_mesh());
                    let body = Self::of(&made.vertices, made.triangles.iter().copied())?;
                    body.merging(slack.merged)
                }
            };
            Ok::<_, GeomError>(Self { is_of_coincident, ..body })
        };
        let common = done(OpType::Intersect)?;
        let (rest, whole) = match combination {
            Combination::Difference => (done(OpType::Subtract)?, self.volume),
            _ => (done(OpType::Add)?, self.volume + other.volume),
        };
        let excess = (rest.volume + common.volume - whole).abs();
        let allowed = (self.area + other.area) * slack.allowed;
        if allowed < excess {
            return Err(MeshError::Unproven { excess, allowed }.into());
        }
        Ok(if combination == Combination::Intersection { common } else { rest })
    }

    fn by_guest(&self, other: &Self, operation: OpType) -> Result<Self, GeomError> {
        GeomError::go_on(self.manifold.num_tri() + other.manifold.num_tri())?;
        let token = CancelToken::new();
        let ends = token.clone();
        let reporter = ProgressReporter::new(move |_, _| {
            if !work::goes_on(1) {
                ends.cancel();
            }
        });
        Self::new(self.manifold.boolean_with_engine_and_progress(
            &other.manifold,
            operation,
            BooleanEngine::Auto,
            Some(&token),
            Some(&reporter),
        ))
    }

    fn vertices(&self) -> impl Iterator<Item = DVec3> {
        let places = &self.manifold.as_impl().vert_pos;
        places.iter().map(|&Vec3 { x, y, z }| DVec3::new(x, y, z))
    }

    fn raw_mesh(&self) -> Mesh {
        let out: MeshGLP<f64, u32> = self.manifold.get_mesh_glp(-1);
        let width = out.num_prop as usize;
        let vertices = out.vert_properties.chunks_exact(width.max(3));
        Mesh {
            vertices: vertices.map(|place| DVec3::new(place[0], place[1], place[2])).collect(),
            triangles: out.tri_verts.as_chunks().0.to_vec(),
            ..Mesh::default()
        }
    }

    /// Its mesh; none where it holds nothing.
    ///
    /// Where it does not hang together as a body does, or faces coincided and lie on one another still, what has no thickness
    /// is taken away: that must leave the volume as it was.
    pub(super) fn mesh(&self, tolerance: Tolerance) -> Result<Option<Mesh>, GeomError> {
        let mesh = self.raw_mesh();
        let bounds = mesh.bounds();
        let rounding = BOOLEAN_RELATIVE * bounds.map_or(0.0, Bounds::magnitude);
        let checked = |mesh: Mesh| {
            if !self.is_of_coincident {
                return Ok(body(mesh, tolerance)?);
            }
            let mesh = mesh.without_crumbs(tolerance, rounding);
            match mesh.sheet(rounding)? {
                Some(at) => Err(MeshError::TouchesItself { at }.into()),
                None => Ok(body(mesh, tolerance)?),
            }
        };
        let touches = match checked(mesh.clone()) {
            Err(GeomError::Mesh(touches)) => touches,
            found => return found,
        };
        let distance = weld_distance(bounds, tolerance).max(rounding);
        for thickness in [rounding, distance] {
            GeomError::go_on(mesh.n_triangles())?;
            let Some(flat) = mesh.flattened(thickness) else { continue };
            let is_whole = (flat.volume() - self.volume).abs() <= self.area * thickness;
            if is_whole && let Ok(found) = checked(flat) {
                return Ok(found);
            }
        }
        Err(touches.into())
    }
}

impl Mesh {
    /// A place where two triangles lie on one another and face opposite ways, with nothing between.
    fn sheet(&self, rounding: f64) -> Result<Option<DVec3>, GeomError> {
        let pairs = coincident_triangles(self, self, rounding)?;
        Ok(pairs.iter().find(|pair| !pair.faces_alike).map(|pair| pair.at))
    }

    /// A closed mesh without parts that hold nothing.
    fn without_crumbs(&self, tolerance: Tolerance, rounding: f64) -> Self {
        let topology = self.topology(tolerance);
        let parts = topology.parts();
        let mut by_part: BTreeMap<u32, Vec<[u32; 3]>> = BTreeMap::new();
        for &corners in topology.triangles() {
            by_part.entry(parts[corners[0] as usize]).or_default().push(corners);
        }
        let is_body = |triangles: &[[u32; 3]]| {
            let corner = |corner: u32| self.vertices[corner as usize];
            let origin = corner(triangles[0][0]);
            let sides = triangles.iter().map(|corners| corners.map(|of| corner(of) - origin));
            let sums = sides.map(|[a, b, c]| (a.dot(b.cross(c)), (b - a).cross(c - a).length()));
            let (volume, area) = sums.fold((0.0, 0.0), |sum, own| (sum.0 + own.0, sum.1 + own.1));
            rounding * area / 2.0 < f64::abs(volume) / 6.0
        };
        let n_parts = by_part.len();
        let kept: Vec<Vec<[u32; 3]>> =
            by_part.into_values().filter(|triangles| is_body(triangles)).collect();
        if kept.len() == n_parts {
            return self.clone();
        }
        let triangles = kept.into_iter().flatten().collect();
        Self { vertices: self.vertices.clone(), triangles, ..Self::default() }.without_strays()
    }

    /// A closed mesh without what is thinner; none where that cannot be told.
    fn flattened(&self, thickness: f64) -> Option<Self> {
        let first = welded(&self.vertices, thickness);
        let named = |corners: &[u32; 3]| corners.map(|corner| first[corner as usize]);
        let triangles: Vec<[u32; 3]> = self.triangles.iter().map(named).collect();
        let (vertices, triangles) = flattened(self.vertices.clone(), &triangles, thickness)?;
        Some(Self { vertices, triangles, ..Self::default() }.without_strays())
    }
}

/// A mesh that has one inside around each place; none without triangles.
fn body(mesh: Mesh, tolerance: Tolerance) -> Result<Option<Mesh>, MeshError> {
    let topology = mesh.topology(tolerance);
    if topology.triangles().is_empty() {
        return Ok(None);
    }
    let ends = topology.boundary().first().map(|side| side[0]);
    let turned = || topology.turned_edge().map(|edge| edge[0]);
    match ends.or_else(turned).or_else(|| topology.pinched_vertex()) {
        Some(vertex) => Err(MeshError::TouchesItself { at: mesh.vertices[vertex as usize] }),
        None => Ok(Some(mesh)),
    }
}
