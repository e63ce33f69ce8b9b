//! The triangles of a sheet: a grid inside, and strips between it and the vertices of the edges.
//!
//! A strip is laid by going along both of its sides and taking each time the one whose next vertex
//! comes first: no triangle of it reaches over more parameters than a step of one of the sides.
//! Along lines where the normal jumps there are two rows of vertices, one for each side.

use glam::{DVec2, DVec3};

use super::{Mesh, seam::Vertices, surface_patch::Cells, surface_patch::SurfacePatch};
use crate::{
    Bounds, CountError, Direction, GeomError, Interval, Side,
    tolerance::{PLACE_RELATIVE, VANISHING_RELATIVE},
};

/// A line of the grid, seen from one side.
#[derive(Clone, Copy, Debug)]
struct GridLine {
    at: f64,
    side: Side,
}

/// A vertex on a side of a strip.
#[derive(Clone, Copy, Debug)]
pub(super) struct StripVertex {
    at: f64,
    side: Side,
    vertex: u32,
}

impl StripVertex {
    /// One that has no crease beside it.
    pub(super) fn new(at: f64, vertex: u32) -> Self {
        Self { at, side: Side::Right, vertex }
    }

    /// The number of the vertex.
    pub(super) fn number(self) -> u32 {
        self.vertex
    }

    /// The same by its place along another direction.
    pub(super) fn moved(self, at: f64) -> Self {
        Self { at, ..self }
    }
}

/// A mesh in the making.
pub(super) struct Stitcher<'a, 's> {
    pub(super) sheet: &'a SurfacePatch<'s>,
    pub(super) mesh: Mesh,
    /// Lines inside along u and along v.
    lines: [Vec<GridLine>; 2],
    /// A length that is rounding.
    rounding: f64,
}

/// The mesh of a sheet whose edges have these vertices, as a grid.
///
/// # Errors
/// Those of [`SurfacePatch::point_at`]; [`CountError::TooManyVertices`].
pub(super) fn stitched(
    sheet: &SurfacePatch<'_>,
    cells: &Cells,
    edges: &[Vertices; 4],
    most: usize,
) -> Result<Mesh, GeomError> {
    let mut lines = Direction::BOTH.map(|along| inner_lines(sheet, &cells.lines[along], along));
    // Where no line runs inside, two edges face one another.
    let [is_open_u, is_open_v] = Direction::BOTH.map(|along| {
        let ends = [[2, 3], [0, 1]][along];
        lines[along].is_empty() && ends.iter().all(|&edge| edges[edge].len() == 2)
    });
    if !is_open_u && !is_open_v {
        for (along, domain) in Direction::BOTH.into_iter().zip(sheet.domains()) {
            if lines[along].is_empty() {
                lines[along].push(GridLine { at: domain.at(0.5), side: Side::Right });
            }
        }
    }
    let got = lines[0].len().saturating_mul(lines[1].len());
    if most.min(u32::MAX as usize) < got {
        return Err(CountError::TooManyVertices { got, most }.into());
    }
    let mut stitcher = Stitcher { lines, ..Stitcher::new(sheet, rounding_of(edges)) };
    if is_open_u || is_open_v {
        stitcher.bridge(if is_open_u { Direction::U } else { Direction::V }, edges);
    } else {
        stitcher.grid()?;
        stitcher.strips(edges);
    }
    Ok(stitcher.mesh.without_strays())
}

/// A length that is rounding where edges have these vertices.
pub(super) fn rounding_of(edges: &[Vertices; 4]) -> f64 {
    let corners = edges.iter().flatten().map(|&(_, point)| point);
    VANISHING_RELATIVE * Bounds::of(corners).map_or(0.0, Bounds::magnitude)
}

/// Along which direction an edge runs: the first two run along v, at the start and the end of u.
fn edge_direction(number: usize) -> Direction {
    if number < 2 { Direction::V } else { Direction::U }
}

/// The lines between the first and the last; where there is a crease, two.
fn inner_lines(sheet: &SurfacePatch<'_>, lines: &[f64], along: Direction) -> Vec<GridLine> {
    let mut creases = sheet.breaks[along].iter().filter(|line| line.is_crease).peekable();
    let mut all = Vec::with_capacity(lines.len());
    for &at in &lines[1..lines.len() - 1] {
        if creases.next_if(|crease| crease.at <= at).is_some() {
            all.push(GridLine { at, side: Side::Left });
        }
        all.push(GridLine { at, side: Side::Right });
    }
    all
}

impl<'a, 's> Stitcher<'a, 's> {
    pub(super) fn new(sheet: &'a SurfacePatch<'s>, rounding: f64) -> Self {
        Self { sheet, mesh: Mesh::default(), lines: Default::default(), rounding }
    }
}

impl Stitcher<'_, '_> {
    pub(super) fn add(&mut self, [u, v]: [f64; 2], point: DVec3, normal: DVec3) -> u32 {
        let vertex = self.mesh.vertices.len() as u32;
        self.mesh.vertices.push(point);
        self.mesh.normals.push(normal);
        self.mesh.uvs.push(DVec2::new(u, v));
        vertex
    }

    /// Adds a triangle, turned round for an odd edge, unless two of its corners are one place.
    pub(super) fn triangle(&mut self, [a, b, c]: [u32; 3], turns: bool) {
        let place = |vertex: u32| self.mesh.vertices[vertex as usize];
        let sides = [(a, b), (b, c), (c, a)];
        if sides.iter().all(|&(a, b)| self.rounding < place(a).distance(place(b))) {
            self.mesh.triangles.push(if turns { [a, c, b] } else { [a, b, c] });
        }
    }

    /// The vertices inside and the triangles between them.
    fn grid(&mut self) -> Result<(), GeomError> {
        let [us, vs] = self
            .lines
            .each_ref()
            .map(|lines| -> Vec<f64> { lines.iter().map(|line| line.at).collect() });
        let samples = self.sheet.spline.samples_on_grid(&us, &vs, 1);
        self.mesh.vertices = samples.points.into_values();
        self.mesh.normals = samples.normals.into_values();
        for &u in &us {
            self.mesh.uvs.extend(vs.iter().map(|&v| DVec2::new(u, v)));
        }
        for i in 0..us.len() {
            GeomError::go_on(1)?;
            for j in 0..vs.len() {
                let (u, v) = (self.lines[0][i], self.lines[1][j]);
                let vertex = i * vs.len() + j;
                if u.side == Side::Left || v.side == Side::Left {
                    let (point, normal) =
                        self.sheet.spline.sample_beside([u.at, v.at], [u.side, v.side]);
                    (self.mesh.vertices[vertex], self.mesh.normals[vertex]) = (point, normal);
                }
                if self.sheet.is_function() {
                    self.mesh.vertices[vertex] = self.sheet.point_at(u.at, v.at)?;
                }
            }
        }
        let is_gap = |lines: &[GridLine], i: usize| {
            lines[i].side == Side::Left && lines[i + 1].side == Side::Right
        };
        let n = vs.len() as u32;
        self.mesh.triangles.reserve(2 * us.len() * vs.len());
        for i in 0..us.len() - 1 {
            GeomError::go_on(1)?;
            for j in 0..vs.len() - 1 {
                if is_gap(&self.lines[0], i) || is_gap(&self.lines[1], j) {
                    continue;
                }
                let a = i as u32 * n + j as u32;
                let (b, d) = (a + n, a + 1);
                self.mesh.triangles.extend([[a, b, b + 1], [a, b + 1, d]]);
            }
        }
        Ok(())
    }

    /// The strips along the four edges.
    fn strips(&mut self, edges: &[Vertices; 4]) {
        let counts = [self.lines[0].len(), self.lines[1].len()];
        let lines = self.lines.clone();
        self.strips_to(edges, |number| {
            let along = edge_direction(number);
            let fixed = if number % 2 == 1 { counts[along.other()] - 1 } else { 0 };
            (0..counts[along])
                .map(|k| {
                    let [i, j] = along.pair(k, fixed);
                    let vertex = i * counts[1] + j;
                    let GridLine { at, side } = lines[along][k];
                    StripVertex { at, side, vertex: vertex as u32 }
                })
                .collect()
        });
    }

    /// The strips between the four edges and what is beside each of them inside. Two that meet share the side from the
    /// corner to the nearest vertex inside.
    pub(super) fn strips_to(
        &mut self,
        edges: &[Vertices; 4],
        inner: impl Fn(usize) -> Vec<StripVertex>,
    ) {
        let mut corners = [[None; 2]; 2];
        for (number, vertices) in edges.iter().enumerate() {
            let inner = inner(number);
            let outer = self.outer(number, (vertices, &inner), &mut corners);
            self.strip(&outer, &inner, number == 0 || number == 3);
        }
    }

    /// One strip between two edges that face one another, across u or across v.
    fn bridge(&mut self, across: Direction, edges: &[Vertices; 4]) {
        let mut corners = [[None; 2]; 2];
        let first = [0, 2][across];
        let sides = [first, first + 1]
            .map(|number| self.outer(number, (&edges[number], &[]), &mut corners));
        self.strip(&sides[0], &sides[1], across == Direction::U);
    }

    /// The vertices of an edge, those of its corners shared with the edges beside it; of one that is a point as many as
    /// beside it inside.
    fn outer(
        &mut self,
        number: usize,
        (vertices, inner): (&Vertices, &[StripVertex]),
        corners: &mut [[Option<u32>; 2]; 2],
    ) -> Vec<StripVertex> {
        let along = edge_direction(number);
        let is_last = number % 2;
        let across = self.sheet.domains()[along.other()];
        let fixed = if is_last == 1 { across.end() } else { across.start() };
        let domain = self.sheet.domains()[along];
        let vertices = self.spread(vertices, inner, domain);
        let creases = self.creases_among(&vertices, along);
        let mut knots = Vec::with_capacity(vertices.len() + creases.len());
        for (k, &(at, point)) in vertices.iter().enumerate() {
            let end = [(k == 0).then_some(0), (k + 1 == vertices.len()).then_some(1)];
            let corner = end.into_iter().flatten().next();
            let corner = corner.map(|end| along.pair(end, is_last));
            if let Some([i, j]) = corner {
                let place = along.pair(at, fixed);
                let vertex = corners[i][j].unwrap_or_else(|| {
                    let normal = self.sheet.spline.shade_at(place[0], place[1]);
                    self.add(place, point, normal)
                });
                corners[i][j] = Some(vertex);
                knots.push(StripVertex { at, side: Side::Right, vertex });
                continue;
            }
            let crease = creases.iter().find(|crease| crease.0 == k).map(|crease| crease.1);
            let at = crease.unwrap_or(at);
            let place = along.pair(at, fixed);
            let sides =
                if crease.is_some() { &[Side::Left, Side::Right][..] } else { &[Side::Right] };
            for &side in sides {
                let normal = match side {
                    Side::Right => self.sheet.spline.shade_at(place[0], place[1]),
                    Side::Left => {
                        let mut sides = [Side::Right; 2];
                        sides[along] = Side::Left;
                        self.sheet.spline.sample_beside(place, sides).1
                    }
                };
                let vertex = self.add(place, point, normal);
                knots.push(StripVertex { at, side, vertex });
            }
        }
        knots
    }

    /// The vertices inside an edge at which a crease ends, by index, with the knot there.
    fn creases_among(&self, vertices: &Vertices, along: Direction) -> Vec<(usize, f64)> {
        let creases = self.sheet.breaks[along].iter().filter(|line| line.is_crease);
        let nearest = |at: f64| {
            let behind = vertices.partition_point(|vertex| vertex.0 < at);
            let inside = behind.saturating_sub(1).max(1)..(behind + 1).min(vertices.len() - 1);
            let distance = |&i: &usize| (vertices[i].0 - at).abs();
            inside.min_by(|a, b| distance(a).total_cmp(&distance(b)))
        };
        creases.filter_map(|line| nearest(line.at).map(|i| (i, line.at))).collect()
    }

    /// The vertices of an edge that is one point at every line that comes there: each has a normal
    /// of its own.
    fn spread(&self, vertices: &Vertices, inner: &[StripVertex], domain: Interval) -> Vertices {
        match vertices[..] {
            [(start, a), (end, b)] if a.distance(b) <= self.rounding => {
                let mut lines: Vec<f64> = inner.iter().map(|vertex| vertex.at).collect();
                lines.dedup_by(|a, b| (*a - *b).abs() <= PLACE_RELATIVE * domain.length());
                let inner = lines.into_iter().map(|at| (at, a));
                [(start, a)].into_iter().chain(inner).chain([(end, b)]).collect()
            }
            _ => vertices.clone(),
        }
    }

    /// Triangles between two sides that run alike; `turns` if the first is to the right of the other.
    fn strip(&mut self, first: &[StripVertex], second: &[StripVertex], turns: bool) {
        let sections = |side: &[StripVertex]| -> Vec<usize> {
            let gaps = (1..side.len()).filter(|&i| side[i - 1].side == Side::Left);
            [0].into_iter().chain(gaps).chain([side.len()]).collect()
        };
        let (cuts, other_cuts) = (sections(first), sections(second));
        if cuts.len() != other_cuts.len() {
            // Creases nearer to one another than vertices are: there is no telling them apart.
            return self.zip(first, second, turns);
        }
        for (cut, other) in cuts.windows(2).zip(other_cuts.windows(2)) {
            self.zip(&first[cut[0]..cut[1]], &second[other[0]..other[1]], turns);
        }
    }

    pub(super) fn zip(&mut self, first: &[StripVertex], second: &[StripVertex], turns: bool) {
        let (mut i, mut j) = (0, 0);
        loop {
            let (next, other) = (first.get(i + 1), second.get(j + 1));
            let (a, b) = (first[i].vertex, second[j].vertex);
            match (next, other) {
                (None, None) => break,
                (Some(next), Some(other)) if other.at <= next.at => {
                    self.triangle([a, other.vertex, b], turns);
                    j += 1;
                }
                (Some(next), _) => {
                    self.triangle([a, next.vertex, b], turns);
                    i += 1;
                }
                (None, Some(other)) => {
                    self.triangle([a, other.vertex, b], turns);
                    j += 1;
                }
            }
        }
    }
}
