//! DXF: splines exactly, circles and arcs as such, polygons, points, and triangles as 3D faces.
//!
//! Autodesk, *AutoCAD 2000 DXF Reference* (AC1015), the oldest version with true colours by 420 and
//! splines in a form that all readers know.

mod layers;
mod round;

use std::io::Write;

use glam::DVec3;

use self::{
    layers::{Layers, readable},
    round::{ArcPath, ObjectAxes, RoundCurve, round_curve},
};
use super::{
    ExportError, Format, Item, Job, Subject, Summary,
    exact::{Exact, exact},
    options::{ANGLE, DECIMALS, TOLERANCE},
    shape::{solids, tolerance},
    text::TextBuffer,
};
use crate::kernel::{Mesh, NurbsCurve};

pub(super) static FORMAT: Format = Format {
    ending: "dxf",
    aliases: &[],
    title: "DXF: exact splines, arcs, polylines and points, surfaces and meshes as 3D faces, a layer for each name",
    options: &[&TOLERANCE, &ANGLE, &DECIMALS],
    takes: |subject| {
        subject.is_geometry() && !matches!(subject, Subject::Region(_) | Subject::Face(_))
    },
    takes_data: false,
    is_of_meshes: false,
    wants: "points, curves, surfaces, regions, faces, solids and meshes",
    write,
};

/// Handles of what stands in every file; those of entities follow.
mod handle {
    pub(super) const PAPER: usize = 0x1B;
    pub(super) const MODEL: usize = 0x1F;
    pub(super) const FIRST: usize = 0x100;
    /// Beyond all entities that a file can have.
    pub(super) const SEED: usize = 0xFFFF_FFFF;
}

/// Of layers and of what has no colour: white on black, black on white.
const FOREGROUND: usize = 7;

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let mut solids = solids(job, tolerance(job)?)?.into_iter();
    let mut summary = Summary::default();
    let text = TextBuffer::rounded(job.options.decimals);
    let mut file =
        Dxf { text, next: handle::FIRST, layers: Layers::of(&job.items), precision: job.precision };
    file.head(job);
    file.tables();
    file.blocks();
    file.section("ENTITIES");
    for item in &job.items {
        match &item.subject {
            Subject::Point(_) | Subject::Curve(_) => {
                for part in exact(item, job)? {
                    match part {
                        Exact::Curve(curve) => file.curve(item, &curve),
                        Exact::Point(point) => file.point(item, point),
                        Exact::Surface(_) | Exact::Face(..) => {}
                    }
                }
                summary.count(&item.subject);
            }
            _ => {
                if let Some(solid) = solids.next() {
                    for corners in solid.mesh().into_iter().flat_map(Mesh::corners) {
                        file.face(item, corners);
                        file.text.flush_if_large(out)?;
                    }
                    summary.add(&solid);
                }
            }
        }
        file.text.flush_if_large(out)?;
    }
    file.end_section();
    file.objects();
    file.group(0, "EOF");
    file.text.flush(out)?;
    Ok(summary)
}

struct Dxf {
    text: TextBuffer,
    /// The next free handle.
    next: usize,
    layers: Layers,
    /// Ends so near one another are one point.
    precision: f64,
}

impl Dxf {
    /// A group: a code, and a value on the line after it.
    fn group(&mut self, code: usize, value: &str) -> &mut Self {
        self.text.count(code).push("\n").push(value).push("\n");
        self
    }

    fn count(&mut self, code: usize, value: usize) -> &mut Self {
        self.text.count(code).push("\n").count(value).push("\n");
        self
    }

    fn number(&mut self, code: usize, value: f64) -> &mut Self {
        self.text.count(code).push("\n").number(value).push("\n");
        self
    }

    /// A knot or weight, which are never rounded.
    fn exact(&mut self, code: usize, value: f64) -> &mut Self {
        self.text.count(code).push("\n").exact(value).push("\n");
        self
    }

    fn handle(&mut self, code: usize, handle: usize) -> &mut Self {
        self.group(code, &format!("{handle:X}"))
    }

    /// Coordinates under `code`, `code + 10` and `code + 20`.
    fn place(&mut self, code: usize, point: DVec3) -> &mut Self {
        self.number(code, point.x).number(code + 10, point.y).number(code + 20, point.z)
    }

    fn section(&mut self, name: &str) {
        self.group(0, "SECTION").group(2, name);
    }

    fn end_section(&mut self) {
        self.group(0, "ENDSEC");
    }

    fn head(&mut self, job: &Job) {
        // $INSUNITS: what a drawing unit is.
        let unit = match job.unit {
            "in" => 1,
            "ft" => 2,
            "mm" => 4,
            "cm" => 5,
            "m" => 6,
            "km" => 7,
            "um" => 13,
            _ => 0,
        };
        let is_metric = !matches!(job.unit, "in" | "ft");
        self.section("HEADER");
        self.group(9, "$ACADVER").group(1, "AC1015");
        self.group(9, "$DWGCODEPAGE").group(3, "ANSI_1252");
        self.group(9, "$HANDSEED").handle(5, handle::SEED);
        self.group(9, "$INSUNITS").count(70, unit);
        self.group(9, "$MEASUREMENT").count(70, usize::from(is_metric));
        self.end_section();
        self.section("CLASSES");
        self.end_section();
    }

    fn table(&mut self, name: &str, own: usize, n_entries: usize) {
        self.group(0, "TABLE").group(2, name).handle(5, own).handle(330, 0);
        self.group(100, "AcDbSymbolTable").count(70, n_entries);
        if name == "DIMSTYLE" {
            self.group(100, "AcDbDimStyleTable");
        }
    }

    fn record(&mut self, kind: &str, own: usize, table: usize, class: &str, name: &str) {
        let code = if kind == "DIMSTYLE" { 105 } else { 5 };
        self.group(0, kind).handle(code, own).handle(330, table);
        self.group(100, "AcDbSymbolTableRecord").group(100, class).group(2, name);
    }

    fn tables(&mut self) {
        self.section("TABLES");
        self.table("VPORT", 0x8, 0);
        self.group(0, "ENDTAB");
        self.table("LTYPE", 0x5, 3);
        for (own, name) in [(0x14, "ByBlock"), (0x15, "ByLayer"), (0x16, "Continuous")] {
            self.record("LTYPE", own, 0x5, "AcDbLinetypeTableRecord", name);
            self.count(70, 0).group(3, "").count(72, 65).count(73, 0).number(40, 0.0);
        }
        self.group(0, "ENDTAB");

        let layers: Vec<_> = self.layers.all().cloned().collect();
        self.table("LAYER", 0x2, layers.len());
        for (i, (name, color)) in layers.iter().enumerate() {
            let own = if i == 0 { 0x10 } else { self.handle_of_next() };
            self.record("LAYER", own, 0x2, "AcDbLayerTableRecord", name);
            self.count(70, 0).count(62, FOREGROUND);
            self.color(*color).group(6, "Continuous");
        }
        self.group(0, "ENDTAB");

        self.table("STYLE", 0x3, 1);
        self.record("STYLE", 0x11, 0x3, "AcDbTextStyleTableRecord", "Standard");
        self.count(70, 0).number(40, 0.0).number(41, 1.0).number(50, 0.0).count(71, 0);
        self.number(42, 2.5).group(3, "txt").group(4, "");
        self.group(0, "ENDTAB");
        for (name, own) in [("VIEW", 0x6), ("UCS", 0x7)] {
            self.table(name, own, 0);
            self.group(0, "ENDTAB");
        }
        self.table("APPID", 0x9, 2);
        for (own, name) in [(0x12, "ACAD"), (0x13, "VIROTE")] {
            self.record("APPID", own, 0x9, "AcDbRegAppTableRecord", name);
            self.count(70, 0);
        }
        self.group(0, "ENDTAB");
        self.table("DIMSTYLE", 0xA, 1);
        self.record("DIMSTYLE", 0x27, 0xA, "AcDbDimStyleTableRecord", "Standard");
        self.count(70, 0);
        self.group(0, "ENDTAB");
        self.table("BLOCK_RECORD", 0x1, 2);
        for (own, name) in [(handle::MODEL, "*Model_Space"), (handle::PAPER, "*Paper_Space")] {
            self.record("BLOCK_RECORD", own, 0x1, "AcDbBlockTableRecord", name);
        }
        self.group(0, "ENDTAB");
        self.end_section();
    }

    fn blocks(&mut self) {
        self.section("BLOCKS");
        let spaces = [(handle::MODEL, "*Model_Space", 0x20), (handle::PAPER, "*Paper_Space", 0x1C)];
        for (owner, name, own) in spaces {
            self.group(0, "BLOCK").handle(5, own).handle(330, owner).group(100, "AcDbEntity");
            self.group(8, "0").group(100, "AcDbBlockBegin").group(2, name).count(70, 0);
            self.place(10, DVec3::ZERO).group(3, name).group(1, "");
            self.group(0, "ENDBLK").handle(5, own + 1).handle(330, owner);
            self.group(100, "AcDbEntity").group(8, "0").group(100, "AcDbBlockEnd");
        }
        self.end_section();
    }

    fn objects(&mut self) {
        self.section("OBJECTS");
        self.group(0, "DICTIONARY").handle(5, 0xC).handle(330, 0).group(100, "AcDbDictionary");
        self.count(281, 1).group(3, "ACAD_GROUP").handle(350, 0xD);
        self.group(0, "DICTIONARY").handle(5, 0xD).handle(330, 0xC).group(100, "AcDbDictionary");
        self.count(281, 1);
        self.end_section();
    }

    fn handle_of_next(&mut self) -> usize {
        self.next += 1;
        self.next - 1
    }

    fn color(&mut self, color: Option<[u8; 3]>) -> &mut Self {
        if let Some([r, g, b]) = color {
            self.count(420, usize::from(r) << 16 | usize::from(g) << 8 | usize::from(b));
        }
        self
    }

    /// The beginning of an entity, up to the marks of its class.
    fn entity(&mut self, kind: &str, item: &Item, classes: &[&str]) {
        let own = self.handle_of_next();
        self.group(0, kind).handle(5, own).handle(330, handle::MODEL).group(100, "AcDbEntity");
        let layer = self.layers.name(item).to_owned();
        self.group(8, &layer).color(item.color);
        for class in classes {
            self.group(100, class);
        }
    }

    /// The name of an item, behind its entity.
    fn name(&mut self, item: &Item) {
        self.group(1001, "VIROTE").group(1000, &readable(&item.name));
    }

    fn point(&mut self, item: &Item, point: DVec3) {
        self.entity("POINT", item, &["AcDbPoint"]);
        self.place(10, point);
        self.name(item);
    }

    fn face(&mut self, item: &Item, [a, b, c]: [DVec3; 3]) {
        self.entity("3DFACE", item, &["AcDbFace"]);
        self.place(10, a).place(11, b).place(12, c).place(13, c);
    }

    fn curve(&mut self, item: &Item, curve: &NurbsCurve) {
        let points = curve.points();
        match (curve.is_rational() || 1 < curve.degree(), &points[..]) {
            (true, _) => match round_curve(curve, self.precision) {
                Some(round) => self.round(item, &round),
                None => self.spline(item, curve, &points),
            },
            (false, [a, b]) => {
                self.entity("LINE", item, &["AcDbLine"]);
                self.place(10, *a).place(11, *b);
                self.name(item);
            }
            (false, _) => self.polyline(item, &points),
        }
    }

    /// The direction that a circle, arc or path is seen from, to the last digit, since readers make axes of it; none
    /// is written for z.
    fn extrusion(&mut self, axes: &ObjectAxes) -> &mut Self {
        let [x, y, z] = axes.normal().to_array();
        match axes.normal() == DVec3::Z {
            true => self,
            false => self.exact(210, x).exact(220, y).exact(230, z),
        }
    }

    fn round(&mut self, item: &Item, round: &RoundCurve) {
        match round {
            RoundCurve::Circle { axes, center, radius } => {
                self.entity("CIRCLE", item, &["AcDbCircle"]);
                self.place(10, *center).number(40, *radius).extrusion(axes);
            }
            RoundCurve::Arc { axes, center, radius, angles: [from, to] } => {
                self.entity("ARC", item, &["AcDbCircle"]);
                self.place(10, *center).number(40, *radius).extrusion(axes);
                self.group(100, "AcDbArc").exact(50, *from).exact(51, *to);
            }
            RoundCurve::Path(path) => self.arc_path(item, path),
        }
        self.name(item);
    }

    fn arc_path(&mut self, item: &Item, ArcPath { axes, vertices, is_closed }: &ArcPath) {
        self.entity("LWPOLYLINE", item, &["AcDbPolyline"]);
        let height = vertices.first().map_or(0.0, |vertex| vertex.place.z);
        self.count(90, vertices.len()).count(70, usize::from(*is_closed)).number(38, height);
        for vertex in vertices {
            self.number(10, vertex.place.x).number(20, vertex.place.y).exact(42, vertex.bulge);
        }
        self.extrusion(axes);
    }

    fn spline(&mut self, item: &Item, curve: &NurbsCurve, points: &[DVec3]) {
        let knots = curve.knots().as_slice();
        self.entity("SPLINE", item, &["AcDbSpline"]);
        // 1: closed, 4: rational.
        let is_closed = curve.start().distance(curve.end()) <= self.precision;
        self.count(70, usize::from(is_closed) + 4 * usize::from(curve.is_rational()));
        self.count(71, curve.degree()).count(72, knots.len()).count(73, points.len()).count(74, 0);
        for &knot in knots {
            self.exact(40, knot);
        }
        if curve.is_rational() {
            for point in curve.control_points() {
                self.exact(41, point.w);
            }
        }
        for &point in points {
            self.place(10, point);
        }
        self.name(item);
    }

    fn polyline(&mut self, item: &Item, points: &[DVec3]) {
        let ends = points.first().zip(points.last());
        let is_closed = ends.is_some_and(|(a, b)| a.distance(*b) <= self.precision);
        let points = if is_closed { &points[1..] } else { points };
        self.entity("POLYLINE", item, &["AcDb3dPolyline"]);
        // 8: in space, 1: closed.
        self.count(66, 1).place(10, DVec3::ZERO).count(70, 8 + usize::from(is_closed));
        self.name(item);
        for &point in points {
            self.entity("VERTEX", item, &["AcDbVertex", "AcDb3dPolylineVertex"]);
            self.place(10, point).count(70, 32);
        }
        self.entity("SEQEND", item, &[]);
    }
}
