//! Meshes of parts of a surface, within the tolerance by bounds.
//!
//! The lines of the whole surface's grid make its parameters a plane of even cells. There the border's
//! arcs become polygons whose legs keep to the limits of cells; between them and the corners of the grid
//! that are not too near runs a constrained Delaunay triangulation, and a triangle that breaks a limit
//! gets a vertex in its middle. A triangle within a box that the limits allow is near the surface at
//! equal parameters (`cell_bounds`), and the parameters beside a leg are near those on it.

use std::{borrow::Cow, collections::BTreeMap};

use glam::{DVec2, DVec3};

use super::{
    Mesh, TessellationOptions,
    arc_places::{BorderVertex, SharedLine, at, between},
    cell_bounds::CellBounds,
    even_plane::{EvenPlane, lines_through},
    grid_core::GridCore,
    pinched::{crossing_sides, with_common_places, without_folds},
    surface_patch::{Cells, SurfacePatch},
    tessellate::{ANGLE_MARGIN, LEAST_GAIN, MAX_GROWTH, check_rounding, widest_turn},
    triangulation::{BorderPolygon, triangles_with},
};
use crate::{
    Bounds, CountError, Direction, GeomError, Interval, NurbsCurve, NurbsSurface, RegionError,
    Side,
    ceiling::TESSELLATION_ROUNDS,
    tolerance::{LEG_SHARE, PARAMETER_RELATIVE, VANISHING_RELATIVE},
};

/// What parts of a surface are together that have limits of their own, by the parameters of the box around them: less
/// than this of the whole.
const SMALL_SHARE: f64 = 0.75;

/// Rounds of vertices in the middle of triangles; each leaves a third of the way to a leg.
const MIDDLE_ROUNDS: usize = 24;

/// Within how many distances of welding of a vertex the surface is between parameters that are its place.
const WITHIN_PLACE: f64 = 4.0;

/// Loops of one part, the outer one first; each by its arcs in the plane z = 0 of u and v.
pub(crate) type PartLoops = Vec<Vec<NurbsCurve>>;

/// Parts of a surface that become triangles.
pub(crate) struct PartsTessellation<'a> {
    pub(super) sheet: SurfacePatch<'a>,
    parts: &'a [PartLoops],
    pub(super) is_closed: [bool; 2],
    /// What of the sheet is around all parts, where that is little of it: cells are those of its limits.
    around: Option<SurfacePatch<'a>>,
    /// The limits of cells as they were given.
    pub(super) limits: CellBounds,
    /// The limits of triangles.
    pub(super) cells: Cells,
    /// What legs may leave out.
    pub(super) leg_tolerance: f64,
    /// Within which distance places are one.
    weld: f64,
    pub(super) most: usize,
    /// Whether a mesh showed that the cells keep to all limits.
    is_settled: bool,
    /// How many times nearer the limits are than they were given.
    sharpness: f64,
    /// How many times further than they may the normals of the last mesh turned.
    last_excess: f64,
    n_rounds: usize,
}

/// The mesh of parts of a surface, none of which goes over a line along which its derivative jumps;
/// `is_closed` tells which pairs of its edges are one.
///
/// # Errors
/// Those of [`PartsTessellation::settled`]; [`RegionError::Unclear`] where arcs come too near one another.
pub(crate) fn tessellate_parts(
    surface: &NurbsSurface,
    parts: &[PartLoops],
    is_closed: [bool; 2],
    options: &TessellationOptions,
    most: usize,
) -> Result<Mesh, GeomError> {
    PartsTessellation::settled(surface, parts, is_closed, options, most)?.1
}

/// The part of a surface around parts of it, where that is little of its parameters.
fn around(surface: &NurbsSurface, parts: &[PartLoops]) -> Option<NurbsSurface> {
    let arcs = parts.iter().flatten().flatten();
    let bounds = arcs.map(NurbsCurve::bounds).reduce(Bounds::union)?;
    let domains = Direction::BOTH.map(|along| surface.domain(along));
    let [u, v] = [0, 1].map(|i| {
        let (low, high) =
            (bounds.min[i].max(domains[i].start()), bounds.max[i].min(domains[i].end()));
        Interval::new(low, high)
    });
    let (u, v) = (u.ok()?, v.ok()?);
    let share = (u.length() / domains[0].length()) * (v.length() / domains[1].length());
    let part = (share < SMALL_SHARE).then(|| surface.trimmed(Direction::U, u).ok())??;
    part.trimmed(Direction::V, v).ok()
}

impl<'a> PartsTessellation<'a> {
    /// With cells that keep to all limits, and the mesh that shows it; or as far as is known without neighbours,
    /// and [`RegionError::Unclear`] where arcs come too near one another.
    ///
    /// # Errors
    /// [`crate::InputError::NotPositive`] for a limit that allows nothing; [`CountError::TooManyVertices`];
    /// [`crate::MeshError::BelowRounding`].
    pub(crate) fn settled(
        surface: &'a NurbsSurface,
        parts: &'a [PartLoops],
        is_closed: [bool; 2],
        options: &TessellationOptions,
        most: usize,
    ) -> Result<(Self, Result<Mesh, GeomError>), GeomError> {
        options.check()?;
        check_rounding(options.tolerance, surface.bounds().magnitude())?;
        // What legs leave out, and what triangles do.
        let leg_tolerance = LEG_SHARE * options.tolerance;
        let triangles = (1.0 - LEG_SHARE) * options.tolerance;
        let sheet = SurfacePatch::of_spline(surface, triangles);
        let around =
            around(surface, parts).map(|around| SurfacePatch::of(Cow::Owned(around), triangles));
        let patch = around.as_ref().unwrap_or(&sheet);
        let limits = patch.limits(options);
        let cells = patch.cells(limits.clone(), most)?;
        let mut own = Self {
            sheet,
            parts,
            is_closed,
            around,
            limits,
            cells,
            leg_tolerance,
            weld: options.weld,
            most,
            is_settled: false,
            sharpness: 1.0,
            last_excess: f64::INFINITY,
            n_rounds: 0,
        };
        loop {
            GeomError::go_on(1)?;
            let mesh = match own.mesh() {
                // Vertices of neighbours may keep the legs apart.
                Err(error @ GeomError::Region(RegionError::Unclear { .. })) => {
                    return Ok((own, Err(error)));
                }
                mesh => mesh?,
            };
            if !own.sharpen(&mesh, options)? {
                own.is_settled = true;
                return Ok((own, Ok(mesh)));
            }
        }
    }

    /// Whether a mesh showed that its cells keep to all limits.
    pub(crate) const fn is_settled(&self) -> bool {
        self.is_settled
    }

    /// Makes cells smaller for a mesh in which normals turn further than they may; false where they are small
    /// enough, or smaller ones gain nothing.
    ///
    /// # Errors
    /// [`CountError::TooManyVertices`].
    pub(crate) fn sharpen(
        &mut self,
        mesh: &Mesh,
        options: &TessellationOptions,
    ) -> Result<bool, GeomError> {
        self.n_rounds += 1;
        let excess = widest_turn(mesh, options.tolerance) / options.angle;
        let is_done =
            !options.limits_angle() || excess <= 1.0 || LEAST_GAIN * self.last_excess <= excess;
        if is_done || TESSELLATION_ROUNDS <= self.n_rounds {
            return Ok(false);
        }
        self.sharpness *= (ANGLE_MARGIN * excess).min(MAX_GROWTH);
        let patch = self.around.as_ref().unwrap_or(&self.sheet);
        self.cells = patch.cells(self.limits.sharpened(self.sharpness), self.most)?;
        self.last_excess = excess;
        Ok(true)
    }

    /// The arcs of all loops.
    fn arcs(&self) -> impl Iterator<Item = &'a NurbsCurve> {
        self.parts.iter().flatten().flatten()
    }

    fn mesh(&self) -> Result<Mesh, GeomError> {
        let mut shared: BTreeMap<SharedLine, Vec<f64>> = BTreeMap::new();
        let mut stops = Vec::new();
        for arc in self.arcs() {
            let places = self.stops(arc)?;
            if let Some(line) = self.shared_line(arc) {
                let along = 1 - line.0;
                shared.entry(line).or_default().extend(places.iter().map(|&t| at(arc, t)[along]));
            }
            stops.push(places);
        }
        // Arcs that meet there from both sides end within rounding of one another.
        let slack = self.sheet.domains().map(|domain| PARAMETER_RELATIVE * domain.length());
        for (line, places) in &mut shared {
            places.sort_by(f64::total_cmp);
            places.dedup_by(|a, b| *a - *b <= slack[1 - line.0]);
        }
        let polygons = self.arcs().zip(&stops).map(|(arc, stops)| match self.shared_line(arc) {
            Some(line) => between(arc, 1 - line.0, &shared[&line], slack[1 - line.0]),
            None => stops[..stops.len() - 1].iter().map(|&t| at(arc, t)).collect(),
        });
        let vertex = |parameters| self.vertex_at(parameters);
        self.mesh_within(polygons.map(|polygon| polygon.into_iter().map(vertex).collect()))
    }

    /// The mesh whose border has these vertices along each arc, that at its end left out.
    ///
    /// # Errors
    /// [`CountError::TooManyVertices`]; [`RegionError::Unclear`] where arcs come too near one another.
    pub(crate) fn mesh_within(
        &self,
        mut along_arcs: impl Iterator<Item = Vec<BorderVertex>>,
    ) -> Result<Mesh, GeomError> {
        let mut mesh = Mesh::default();
        for part in self.parts {
            let loops: Vec<Vec<BorderVertex>> = part
                .iter()
                .map(|arcs| along_arcs.by_ref().take(arcs.len()).flatten().collect())
                .collect();
            let loops = without_folds(self.with_common_places(loops));
            self.add(&loops, &mut mesh)?;
        }
        Ok(mesh.without_strays())
    }

    /// The pairs of legs that cross, where the border has these vertices along each arc, that at its end left out:
    /// for each the number of its arc and its own along that.
    pub(crate) fn crossing_legs(
        &self,
        mut along_arcs: impl Iterator<Item = Vec<BorderVertex>>,
    ) -> Vec<[(usize, usize); 2]> {
        let net = EvenPlane { lines: &self.cells.lines };
        let (mut pairs, mut n_arcs) = (Vec::new(), 0);
        for part in self.parts {
            let (mut loops, mut legs) = (Vec::new(), Vec::new());
            for arcs in part {
                let mut polygon = Vec::new();
                for vertices in along_arcs.by_ref().take(arcs.len()) {
                    legs.extend((0..vertices.len()).map(|leg| (n_arcs, leg)));
                    polygon.extend(vertices);
                    n_arcs += 1;
                }
                loops.push(polygon);
            }
            let place = |vertex: &BorderVertex| net.place(vertex.parameters);
            let polygons: Vec<Vec<DVec2>> = self
                .with_common_places(loops)
                .iter()
                .map(|polygon| polygon.iter().map(place).collect())
                .collect();
            pairs.extend(crossing_sides(&polygons).into_iter().map(|pair| pair.map(|k| legs[k])));
        }
        pairs
    }

    /// Vertices at one point of space get one place, unless a seam is between them.
    fn with_common_places(&self, mut loops: Vec<Vec<BorderVertex>>) -> Vec<Vec<BorderVertex>> {
        let is_one = |[one, other]: [DVec2; 2], point: DVec3| {
            let is_near = |share: f64| {
                let between = self.point(one.lerp(other, share));
                between.distance(point) <= WITHIN_PLACE * self.weld
            };
            [0.25, 0.5, 0.75].into_iter().all(is_near)
        };
        with_common_places(&mut loops, self.weld, is_one);
        loops
    }

    /// Where the vertices along each arc stand that keep to the limits: its parameters, its ends among them.
    ///
    /// # Errors
    /// [`CountError::TooManyVertices`].
    pub(crate) fn all_stops(&self) -> Result<Vec<Vec<f64>>, GeomError> {
        self.arcs().map(|arc| self.stops(arc)).collect()
    }

    /// The vertex at parameters of the surface.
    pub(crate) fn vertex_at(&self, parameters: DVec2) -> BorderVertex {
        BorderVertex { parameters, point: self.point(parameters) }
    }

    /// Adds the triangles of one part, whose loops are polygons.
    fn add(&self, loops: &[Vec<BorderVertex>], mesh: &mut Mesh) -> Result<(), GeomError> {
        if loops.is_empty() {
            return Ok(());
        }
        let (cells, most) = (&self.cells, self.most);
        let net = EvenPlane { lines: &cells.lines };
        let mut rings: Vec<BorderPolygon> = Vec::new();
        let mut first = 0;
        for polygon in loops {
            let places: Vec<DVec2> =
                polygon.iter().map(|vertex| net.place(vertex.parameters)).collect();
            let n = places.len();
            rings.push(BorderPolygon { places, first });
            first += n;
        }
        let got = mesh.n_vertices() + first;
        let inside = net.corners_inside(&rings, most.saturating_sub(got))?;
        let is_fine = |corners: [DVec2; 3]| {
            let [a, b, c] = corners.map(|corner| net.parameters(corner));
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            cells.allow([[low.x, high.x], [low.y, high.y]])
        };
        let limits = [MIDDLE_ROUNDS, most.saturating_sub(got)];
        let mut core = GridCore::of(&inside, &rings)?;
        let n_shared = core.shared.len();
        let given = (std::mem::take(&mut core.shared), &core.sides[..]);
        let (mut triangles, inside) =
            triangles_with(&rings, given, is_fine, limits).map_err(|vertex| {
                let vertex = loops.iter().flatten().nth(vertex);
                let point = vertex.map_or(DVec3::ZERO, |vertex| vertex.point);
                RegionError::Unclear { point }
            })?;
        triangles.extend(core.triangles(first, first + inside.len()));
        let offset = mesh.n_vertices();
        let (shared, between) = inside.split_at(n_shared);
        self.add_vertices(loops, [shared, between, &core.deep], mesh)?;
        let rounding = VANISHING_RELATIVE * self.sheet.spline.bounds().magnitude();
        for corners in triangles {
            let corners = corners.map(|corner| corner + offset as u32);
            let [a, b, c] = corners.map(|corner| mesh.vertices[corner as usize]);
            if [(a, b), (b, c), (c, a)].iter().all(|(a, b)| rounding < a.distance(*b)) {
                mesh.triangles.push(corners);
            }
        }
        Ok(())
    }

    /// Adds the vertices of the border of one part, of the corners of whole cells that other triangles have too, of what
    /// is inside of no cell, and of all other corners, in this order.
    ///
    /// # Errors
    /// [`CountError::TooManyVertices`]; `GeomError::Ended`.
    fn add_vertices(
        &self,
        loops: &[Vec<BorderVertex>],
        [shared, between, deep]: [&[DVec2]; 3],
        mesh: &mut Mesh,
    ) -> Result<(), GeomError> {
        let border = || loops.iter().flatten();
        let n_own = border().count() + shared.len() + between.len() + deep.len();
        let (got, most) = (mesh.n_vertices() + n_own, self.most);
        if most.min(u32::MAX as usize) < got {
            return Err(CountError::TooManyVertices { got, most }.into());
        }
        let places = || border().map(|vertex| vertex.parameters);
        let (low, high) = (places().reduce(DVec2::min), places().reduce(DVec2::max));
        let middle = low.zip(high).map_or(DVec2::ZERO, |(low, high)| low.midpoint(high));
        let crossings: Vec<[usize; 2]> =
            shared.iter().chain(deep).map(|&corner| lines_through(corner)).collect();
        let net = EvenPlane { lines: &self.cells.lines };
        let [us, vs] = net.lines;
        let samples = self.sheet.spline.samples_at_crossings([us, vs], &crossings)?;
        let at_crossings =
            crossings.iter().map(|&[i, j]| DVec2::new(us[i], vs[j])).zip(samples.iter().copied());
        let n_shared = shared.len();
        let (shared, deep) = (at_crossings.clone().take(n_shared), at_crossings.skip(n_shared));
        let border = border().map(|&BorderVertex { parameters, point }| {
            (parameters, (point, self.sample(parameters, middle).1))
        });
        let between = between.iter().map(|&place| {
            let parameters = net.parameters(place);
            (parameters, self.sample(parameters, middle))
        });
        for (parameters, (point, normal)) in border.chain(shared).chain(between).chain(deep) {
            mesh.vertices.push(point);
            mesh.normals.push(normal);
            mesh.uvs.push(parameters);
        }
        Ok(())
    }

    /// The point at parameters; of a seam the same at both of its ends.
    fn point(&self, place: DVec2) -> DVec3 {
        let domains = self.sheet.domains();
        let [u, v] = [0, 1].map(|i| {
            let (domain, t) = (domains[i], place[i]);
            if self.is_closed[i] && domain.end() <= t { domain.start() } else { t }
        });
        self.sheet.spline.point_at(u, v)
    }

    /// The point and the normal at parameters, on the side where the part is.
    fn sample(&self, place: DVec2, middle: DVec2) -> (DVec3, DVec3) {
        let sides = [0, 1].map(|i| if place[i] <= middle[i] { Side::Right } else { Side::Left });
        self.sheet.spline.sample_beside(place.to_array(), sides)
    }
}
