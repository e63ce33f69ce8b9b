//! A band of the picture: which triangle or line each sample shows, by depth.

use std::ops::Range;

use glam::{DVec2, DVec3};

use super::{
    light::Light,
    pixel::SIDE,
    scene::{PlacedMesh, RasterScene, Stroke},
};

/// No triangle.
const NONE: u32 = u32::MAX;

/// A line may lie this many samples behind a surface and counts as on it: the distances of
/// polygons and triangles from what they stand for, and some.
const SLACK: f64 = 3.0;

/// A line at the rim of a surface is looked at this many samples to its sides: where the surface turns
/// away, its depth changes within a sample by more than any slack.
const BESIDE: f64 = 2.0;

/// Of two surfaces that are no farther apart than this many samples, the first is seen.
const APART: f64 = 1.5;

/// The slack of what is seen at a slant grows with the slope, up to this one.
const STEEPEST: f64 = 12.0;

/// The colour of what nothing covers.
const PAPER: DVec3 = DVec3::ONE;
const PAPER_PIXEL: [u8; 3] = [255; 3];

/// Some rows of samples, with an apron of more above and below where only depth matters.
pub(super) struct RowBand {
    /// The row of the picture in the first line, which may lie above the picture.
    top: isize,
    /// Where the rows of the band begin and end among its lines.
    inner: [usize; 2],
    width: usize,
    height: usize,
    /// The columns in which anything is drawn; whatever the others hold is old.
    columns: Range<usize>,
    depths: Vec<f64>,
    /// The triangle that a sample shows, by its place in `faces`.
    owners: Vec<u32>,
    faces: Vec<VisibleTriangle>,
    /// Depth and stroke of lines.
    lines: Vec<(f64, u32)>,
}

/// A triangle that is seen from one of its sides.
struct VisibleTriangle {
    body: u32,
    idx: u32,
    corners: [DVec3; 3],
    /// Growth of the depth to the right and down.
    slope: DVec2,
}

impl VisibleTriangle {
    /// None for what is seen from the edge.
    fn new(scene: &RasterScene, [body, idx]: [u32; 2]) -> Option<Self> {
        let whole = &scene.bodies[body as usize];
        let corners =
            whole.mesh.triangles()[idx as usize].map(|corner| whole.places[corner as usize]);
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a);
        let slope = -normal.truncate() / normal.z;
        slope.is_finite().then_some(Self { body, idx, corners, slope })
    }

    fn depth_at(&self, place: DVec2) -> f64 {
        let [a, b, c] = self.corners.map(|corner| corner.z);
        let depth = a + self.slope.dot(place - self.corners[0].truncate());
        depth.clamp(a.min(b).min(c), a.max(b).max(c))
    }

    /// A distance from the triangle as a depth.
    fn deep(&self, distance: f64) -> f64 {
        distance * (1.0 + self.slope.length_squared().min(STEEPEST * STEEPEST)).sqrt()
    }

    /// The places along a row that it covers. Neighbours compute the end that they share alike,
    /// so that no sample falls between them.
    fn span(&self, y: f64) -> Option<[f64; 2]> {
        let mut span: Option<[f64; 2]> = None;
        for i in 0..3 {
            let (a, b) = (self.corners[i].truncate(), self.corners[(i + 1) % 3].truncate());
            let (a, b) = if (a.y, a.x) < (b.y, b.x) { (a, b) } else { (b, a) };
            if y < a.y || b.y < y {
                continue;
            }
            let x = if a.y < b.y { a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)) } else { a.x };
            let far = if a.y < b.y { x } else { b.x };
            let [low, high] = span.unwrap_or([x, far]);
            span = Some([low.min(x).min(far), high.max(x).max(far)]);
        }
        span
    }

    /// The parts of the corners in a place near it.
    fn parts(&self, place: DVec2) -> [f64; 3] {
        let [a, b, c] = self.corners.map(|corner| corner.truncate() - place);
        let parts = [b.perp_dot(c), c.perp_dot(a), a.perp_dot(b)];
        let whole: f64 = parts.iter().sum();
        let parts = parts.map(|part| (part / whole).max(0.0));
        let whole: f64 = parts.iter().sum();
        parts.map(|part| part / whole)
    }
}

impl Stroke {
    /// The places along a row, of those within bounds, outside of which nothing of it is.
    fn span(&self, y: f64, [low, high]: [f64; 2]) -> [f64; 2] {
        let [a, b] = self.ends;
        let along = (b - a).truncate();
        let half = self.radius * along.length() / along.y.abs();
        let middle = a.x + (y - a.y) * along.x / along.y;
        // Of a level stroke, or of a point, these are no numbers.
        match (middle - half).is_finite() {
            true => [low.max(middle - half), high.min(middle + half)],
            false => [low, high],
        }
    }
}

impl RowBand {
    /// Room for any band of a picture.
    pub(super) fn new(width: usize) -> Self {
        Self {
            top: 0,
            inner: [0, 0],
            width,
            height: 0,
            columns: 0..0,
            depths: Vec::new(),
            owners: Vec::new(),
            faces: Vec::new(),
            lines: Vec::new(),
        }
    }

    /// Draws what reaches into a band, and forgets what it held.
    pub(super) fn draw_all(&mut self, scene: &RasterScene, idx: usize) {
        let [from, to] = scene.rows(idx);
        self.top = from as isize - scene.apron as isize;
        self.inner = [scene.apron, scene.apron + to - from];
        self.height = to - from + 2 * scene.apron;
        self.faces.clear();
        let faces: Vec<VisibleTriangle> = scene.triangles_in[idx]
            .iter()
            .filter_map(|&triangle| VisibleTriangle::new(scene, triangle))
            .collect();
        let strokes: Vec<(u32, &Stroke)> = scene.strokes_in[idx]
            .iter()
            .map(|&name| (name, &scene.strokes[name as usize]))
            .collect();
        self.clear(&faces, &strokes);
        for face in faces {
            self.draw(face);
        }
        for (name, stroke) in strokes {
            self.trace(stroke, name);
        }
    }

    /// Empties the samples of the columns in which something will be drawn, whole pixels.
    fn clear(&mut self, faces: &[VisibleTriangle], strokes: &[(u32, &Stroke)]) {
        let of_faces =
            faces.iter().flat_map(|face| face.corners).map(|corner| [corner.x, corner.x]);
        let of_strokes = strokes.iter().flat_map(|(_, stroke)| {
            stroke.ends.map(|end| [end.x - stroke.radius, end.x + stroke.radius])
        });
        let [low, high] = of_faces
            .chain(of_strokes)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [from, to]| {
                [low.min(from), high.max(to)]
            });
        let end = ((high.max(-1.0) as usize).saturating_add(2)).next_multiple_of(SIDE);
        let first = low.max(0.0) as usize / SIDE * SIDE;
        self.columns = if low <= high { first.min(self.width)..end.min(self.width) } else { 0..0 };
        let n_samples = self.width * self.height;
        self.depths.resize(n_samples, f64::NEG_INFINITY);
        self.owners.resize(n_samples, NONE);
        self.lines.resize(n_samples, (f64::NEG_INFINITY, NONE));
        for line in 0..self.height {
            let samples =
                line * self.width + self.columns.start..line * self.width + self.columns.end;
            self.depths[samples.clone()].fill(f64::NEG_INFINITY);
            self.owners[samples.clone()].fill(NONE);
            self.lines[samples].fill((f64::NEG_INFINITY, NONE));
        }
    }

    /// The lines and columns of samples in a box, as far as they are here.
    fn samples(&self, low: DVec2, high: DVec2) -> [Range<usize>; 2] {
        let top = self.top as f64;
        let range = |low: f64, high: f64, n: usize| {
            let first = low.ceil().max(0.0) as usize;
            let end = (high.floor() + 1.0).clamp(0.0, n as f64) as usize;
            first..end.max(first)
        };
        [range(low.y - top, high.y - top, self.height), range(low.x, high.x, self.width)]
    }

    fn draw(&mut self, face: VisibleTriangle) {
        let name = self.faces.len() as u32;
        let [a, b, c] = face.corners.map(DVec3::truncate);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let apart = face.deep(APART);
        for line in self.samples(low, high)[0].clone() {
            let y = (self.top + line as isize) as f64;
            let Some([from, to]) = face.span(y) else { continue };
            let columns = self.samples(DVec2::new(from, y), DVec2::new(to, y))[1].clone();
            for column in columns {
                let place = line * self.width + column;
                let depth = face.depth_at(DVec2::new(column as f64, y));
                let before = self.depths[place];
                let is_nearer = match self.faces.get(self.owners[place] as usize) {
                    Some(owner) if owner.body != face.body => before + apart < depth,
                    _ => before < depth,
                };
                if is_nearer {
                    self.depths[place] = depth;
                    self.owners[place] = name;
                }
            }
        }
        self.faces.push(face);
    }

    /// Draws a straight piece of a line as wide as it is, where its middle is seen.
    fn trace(&mut self, stroke: &Stroke, name: u32) {
        let [a, b] = stroke.ends;
        let along = (b - a).truncate();
        let radius = DVec2::splat(stroke.radius);
        let (low, high) = (a.min(b).truncate() - radius, a.max(b).truncate() + radius);
        for line in self.samples(low, high)[0].clone() {
            let y = (self.top + line as isize) as f64;
            let [from, to] = stroke.span(y, [low.x, high.x]);
            for column in self.samples(DVec2::new(from, y), DVec2::new(to, y))[1].clone() {
                let sample = DVec2::new(column as f64, y);
                let part = (sample - a.truncate()).dot(along) / along.length_squared();
                // Of a point the part is no number.
                let part = if part.is_finite() { part.clamp(0.0, 1.0) } else { 0.0 };
                let middle = a.lerp(b, part);
                let is_inside =
                    sample.distance_squared(middle.truncate()) <= stroke.radius * stroke.radius;
                let place = line * self.width + column;
                let is_nearer = is_inside && self.lines[place].0 < middle.z;
                if is_nearer && self.shows(stroke, middle) {
                    self.lines[place] = (middle.z, name);
                }
            }
        }
    }

    /// Whether a stroke is seen where its middle has this place.
    fn shows(&self, stroke: &Stroke, middle: DVec3) -> bool {
        if self.is_seen(middle, stroke.body) {
            return true;
        }
        let aside = (stroke.ends[1] - stroke.ends[0]).truncate().perp().normalize_or_zero();
        let beside = BESIDE * aside.extend(0.0);
        stroke.is_rim && [middle + beside, middle - beside].iter().any(|&at| self.is_seen(at, None))
    }

    /// Whether no surface is before a place of a line, and none in the same place but its own.
    fn is_seen(&self, place: DVec3, body: Option<u32>) -> bool {
        let [line, column] = [place.y - self.top as f64, place.x].map(f64::round);
        let is_here =
            (0.0..self.height as f64).contains(&line) && (0.0..self.width as f64).contains(&column);
        if !(is_here && self.columns.contains(&(column as usize))) {
            return true;
        }
        let sample = line as usize * self.width + column as usize;
        match self.faces.get(self.owners[sample] as usize) {
            Some(face) if body.is_some_and(|body| body != face.body) => {
                self.depths[sample] + face.deep(SLACK) < place.z
            }
            Some(face) => self.depths[sample] <= place.z + face.deep(SLACK),
            None => true,
        }
    }

    /// Adds the pixels of the band.
    pub(super) fn resolve(&self, scene: &RasterScene, light: &Light<'_>, pixels: &mut Vec<u8>) {
        for first_line in (self.inner[0]..self.inner[1]).step_by(SIDE) {
            let blank = |columns: Range<usize>| columns.len().div_ceil(SIDE) * PAPER_PIXEL.len();
            pixels.resize(pixels.len() + blank(0..self.columns.start), PAPER_PIXEL[0]);
            for first_column in self.columns.clone().step_by(SIDE) {
                let color = self.pixel(scene, light, [first_line, first_column]);
                pixels.extend(color.to_array().map(|level| (255.0 * level).round() as u8));
            }
            pixels.resize(pixels.len() + blank(self.columns.end..self.width), PAPER_PIXEL[0]);
        }
    }

    /// The mean of the samples of a pixel. What a triangle shows is found once a pixel, in the
    /// middle of its samples.
    fn pixel(&self, scene: &RasterScene, light: &Light<'_>, [line, column]: [usize; 2]) -> DVec3 {
        let mut sum = DVec3::ZERO;
        // Triangles with how many samples they have, and the sum of their places.
        let mut shown: Vec<(u32, f64, DVec2)> = Vec::new();
        for line in line..line + SIDE {
            for column in column..column + SIDE {
                let sample = line * self.width + column;
                let (depth, stroke) = self.lines[sample];
                let owner = self.owners[sample];
                if depth > f64::NEG_INFINITY {
                    sum += scene.strokes[stroke as usize].color;
                } else if owner == NONE {
                    sum += PAPER;
                } else {
                    let place = DVec2::new(column as f64, (self.top + line as isize) as f64);
                    match shown.iter_mut().find(|(known, ..)| *known == owner && !light.is_sharp())
                    {
                        Some((_, n_samples, places)) => {
                            *n_samples += 1.0;
                            *places += place;
                        }
                        None => shown.push((owner, 1.0, place)),
                    }
                }
            }
        }
        for (owner, n_samples, places) in shown {
            let face = &self.faces[owner as usize];
            let body = &scene.bodies[face.body as usize];
            sum += n_samples * shaded(face, body, places / n_samples, light);
        }
        sum / (SIDE * SIDE) as f64
    }
}

/// The colour of a triangle in a place.
fn shaded(face: &VisibleTriangle, body: &PlacedMesh, place: DVec2, light: &Light<'_>) -> DVec3 {
    let corners = body.mesh.triangles()[face.idx as usize].map(|corner| corner as usize);
    let parts = face.parts(place);
    let mean = |values: &[DVec3]| -> DVec3 {
        corners.iter().zip(parts).map(|(&corner, part)| values[corner] * part).sum()
    };
    let [a, b, c] = corners.map(|corner| body.mesh.vertices()[corner]);
    let plane = (b - a).cross(c - a).normalize_or_zero();
    let normals = body.mesh.normals();
    let normal = if normals.is_empty() { plane } else { mean(normals).normalize_or(plane) };
    let at = mean(body.mesh.vertices());
    let colors = body.mesh.colors();
    let color = if colors.is_empty() { body.color } else { mean(colors) };
    light.shade(color, at, [normal, plane], !colors.is_empty())
}
