//! From the definitions of a script to a picture of them.

use std::collections::HashSet;

use super::{
    Event, Report, Session,
    extra::{self, ControlStyle, Extra},
    plan::GatheredItems,
};
use crate::{
    diag::{Span, Spanned, nearest},
    eval::{self, Defined},
    export::{
        DefinitionLabel, Format, Item, Job, Legend, Options, PNG, Picture, Stripes, View, whole,
    },
    kernel::Tolerance,
    limits::Limits,
    syntax::ast::{Kind, Unit},
    value::{Appearance, Value},
};

/// What a picture is to show, and how.
#[derive(Clone, Debug)]
pub struct PictureContent<'a> {
    /// The definitions that are drawn; with no name those that the script exports, or all where it
    /// exports no geometry.
    pub only: &'a [String],
    /// Whether all definitions are drawn that are geometry and not hidden, also those that the
    /// script does not export.
    pub with_helpers: bool,
    /// What is shown beside it.
    pub extras: &'a [Extra],
    /// How control polygons and nets are drawn.
    pub control: ControlStyle,
    /// How many stripes there are, and their light.
    pub stripes: Stripes,
    /// From where, and with which lines; without a view or a camera from above what is flat, and all
    /// else as an isometric drawing.
    pub options: Options,
    /// Width and height in pixels.
    pub size: [usize; 2],
}

impl<'a> PictureContent<'a> {
    /// What the script exports, or else defines, alone.
    #[must_use]
    pub fn new(size: [usize; 2]) -> Self {
        Self {
            only: &[],
            with_helpers: false,
            extras: &[],
            control: ControlStyle::default(),
            stripes: Stripes { n_stripes: extra::STRIPES, light: None },
            options: Options::default(),
            size,
        }
    }
}

/// Colours of definitions without one of their own, one after the other.
const PALETTE: [[u8; 3]; 10] = [
    [0x4e, 0x79, 0xa7],
    [0xf2, 0x8e, 0x2b],
    [0x59, 0xa1, 0x4f],
    [0xe1, 0x57, 0x59],
    [0x9a, 0x70, 0xb0],
    [0x49, 0x98, 0x94],
    [0x9d, 0x76, 0x60],
    [0xd3, 0x72, 0x95],
    [0xb6, 0x99, 0x2d],
    [0x79, 0x70, 0x6e],
];

impl Session {
    /// What `format` needs for a picture of the script of a report.
    ///
    /// Drawn are definitions that promise geometry, and those by `let` that are curves, surfaces or
    /// meshes, lists of them, or records with some, such as combs and maps of curvature. Points by `let` are as
    /// often directions, and drawn only by name.
    ///
    /// # Errors
    /// A sentence where there is nothing to draw, or a name of nothing that can be drawn.
    pub fn picture(
        &self,
        report: &Report,
        scene: &PictureContent<'_>,
        format: &'static Format,
    ) -> Result<Job, String> {
        let chosen = chosen(report, scene)?;
        let shows = |extra: Extra| scene.extras.contains(&extra);
        let mut gathering = GatheredItems::new(format);
        let (mut legends, mut labels) = (Vec::new(), Vec::new());
        for (idx, (defined, value)) in chosen.into_iter().enumerate() {
            let mut look = defined.look.clone();
            look.color = look.color.or(Some(PALETTE[idx % PALETTE.len()]));
            let value = Spanned::new(value.clone(), defined.span);
            let (name, identity) = (defined.name.clone(), defined.identity);
            let subject = eval::ExportSubject { name, value, look, identity };
            let first = gathering.items.len();
            if let Err(misfit) = gathering.add_all_of(&subject) {
                return Err(undrawable(&defined.name, &misfit.found));
            }
            if shows(Extra::Labels) {
                labels.extend(extra::label(&defined.name, &gathering.items[first..]));
            }
            legends.extend(legends_of(&defined.name, &subject.value.value));
        }
        let mut items = gathering.items;
        let mut options = scene.options.clone();
        let viewpoint = &mut options.viewpoint;
        if viewpoint.camera.is_none() && viewpoint.view.is_none() {
            viewpoint.view = Some(View::fitting(&items));
        }
        add_extras(&mut items, scene, &mut labels)?;
        let (unit, tolerance) = report.document;
        Ok(Job {
            unit: unit.name(),
            millimetres: unit.millimetres().unwrap_or(1.0),
            precision: tolerance.distance,
            options,
            picture: Some(Picture {
                legends,
                labels,
                stripes: shows(Extra::Stripes).then_some(scene.stripes),
                has_scale: shows(Extra::Scale),
                ..Picture::new(scene.size)
            }),
            limits: self.limits,
            n_threads: self.n_threads,
            meshes: report.meshes.clone(),
            ..Job::new(items)
        })
    }
}

/// How many times smaller than the whole is what the triangles of a small picture may lie beside a surface.
const FINENESS: f64 = 100.0;

/// A small picture of a value alone as a PNG, coarse and therefore quick; none where it cannot be drawn.
pub fn small_picture(
    value: &Value,
    (unit, tolerance): (Unit, Tolerance),
    limits: &Limits,
    size: [usize; 2],
) -> Option<Vec<u8>> {
    let subject = eval::ExportSubject {
        name: String::new(),
        value: Spanned::new(value.clone(), Span::default()),
        look: Appearance { color: Some(PALETTE[0]), ..Appearance::default() },
        identity: None,
    };
    let mut gathering = GatheredItems::new(&PNG);
    gathering.add_all_of(&subject).ok()?;
    let items = gathering.items;
    let mut options = Options { n_isocurves: 3, ..Options::default() };
    options.viewpoint.view = Some(View::fitting(&items));
    let extent = whole(&items)?.diagonal();
    options.tolerance = Some(extent / FINENESS).filter(|tolerance| 0.0 < *tolerance);
    let job = Job {
        unit: unit.name(),
        millimetres: unit.millimetres().unwrap_or(1.0),
        precision: tolerance.distance,
        options,
        picture: Some(Picture::new(size)),
        limits: *limits,
        n_threads: 1,
        ..Job::new(items)
    };
    let mut bytes = Vec::new();
    (PNG.write)(&job, &mut bytes).ok()?;
    Some(bytes)
}

/// Adds what is drawn beside the geometry.
fn add_extras(
    items: &mut Vec<Item>,
    scene: &PictureContent<'_>,
    labels: &mut Vec<DefinitionLabel>,
) -> Result<(), String> {
    let shows = |extra: Extra| scene.extras.contains(&extra);
    let mut added = Vec::new();
    if shows(Extra::Control) {
        added.extend(extra::control(items, scene.control));
    }
    if shows(Extra::Comb) {
        added.extend(extra::combs(items).map_err(|(name, err)| format!("{name}: {err}"))?);
    }
    if shows(Extra::Axes)
        && let Some(bounds) = whole(items)
    {
        let (axes, names) = extra::axes(bounds);
        added.extend(axes);
        labels.extend(names);
    }
    items.extend(added);
    Ok(())
}

fn undrawable(name: &str, found: &str) -> String {
    format!("`{name}` is {found}, which cannot be drawn")
}

/// The definitions that are drawn, with their values.
fn chosen<'a>(
    report: &'a Report,
    scene: &PictureContent<'_>,
) -> Result<Vec<(&'a Defined, &'a Value)>, String> {
    let (definitions, only) = (&report.definitions, scene.only);
    let valued = |defined: &'a Defined| Some((defined, defined.value.as_ref()?));
    if only.is_empty() {
        let mut shown: Vec<_> =
            drawable(report).filter(|(defined, _)| !defined.look.is_hidden).collect();
        if shown.is_empty() {
            return Err("the script defines no geometry that could be drawn".to_owned());
        }
        let exported = if scene.with_helpers { HashSet::new() } else { exported(report) };
        let is_exported = |defined: &Defined| exported.contains(defined.name.as_str());
        if shown.iter().any(|(defined, _)| is_exported(defined)) {
            shown.retain(|(defined, _)| is_exported(defined));
        }
        return Ok(shown);
    }
    let find = |name: &String| {
        let found = definitions.iter().filter_map(valued).find(|(its, _)| its.name == *name);
        let names = || definitions.iter().map(|defined| defined.name.as_str());
        match (found, nearest(name, names())) {
            (Some((_, value)), _) if !is_drawn(value, true) => {
                Err(undrawable(name, &value.phrase()))
            }
            (Some(found), _) => Ok(found),
            _ if names().any(|its| its == name) => {
                Err(format!("`{name}` has an error, and cannot be drawn"))
            }
            (None, Some(near)) => {
                Err(format!("the script defines no `{name}`; did you mean `{near}`?"))
            }
            (None, None) => Err(format!("the script defines no `{name}`")),
        }
    };
    only.iter().map(find).collect()
}

/// The definitions that a picture may show without being asked for them, hidden ones included, with
/// their values.
pub fn drawable(report: &Report) -> impl Iterator<Item = (&Defined, &Value)> {
    let valued = report.definitions.iter().filter_map(|its| Some((its, its.value.as_ref()?)));
    valued.filter(|(defined, value)| {
        let is_free = defined.kind == Some(Kind::Let);
        let promises = defined.kind.is_some_and(Kind::is_geometry);
        (promises || is_free) && is_drawn(value, !is_free)
    })
}

/// The names that exports of geometry name.
pub fn exported(report: &Report) -> HashSet<&str> {
    let files = report.events.iter().filter_map(|event| match event {
        Event::File(file) => Some(file),
        _ => None,
    });
    let of_geometry =
        files.filter(|file| file.job.items.iter().any(|item| item.subject.is_geometry()));
    of_geometry.flat_map(|file| file.names.iter().map(String::as_str)).collect()
}

/// Whether there is something to draw of a value; single points only where they are asked for.
fn is_drawn(value: &Value, with_points: bool) -> bool {
    match value {
        Value::Curve(_)
        | Value::Surface(_)
        | Value::Region(_)
        | Value::Face(_)
        | Value::Solid(_)
        | Value::Mesh(_) => true,
        Value::Point(_) => with_points,
        Value::List(items) => {
            !items.is_empty() && items.values().all(|item| is_drawn(&item, with_points))
        }
        Value::Record(record) => record.iter().any(|(_, member)| is_drawn(member, false)),
        _ => false,
    }
}

/// The legends of the coloured meshes in a value: of records with a mesh and a scale.
fn legends_of(name: &str, value: &Value) -> Vec<Legend> {
    match value {
        Value::List(items) => {
            let items = items.values().enumerate();
            items.flat_map(|(i, item)| legends_of(&format!("{name}[{i}]"), &item)).collect()
        }
        Value::Record(record) => match (record.get("mesh"), record.get("scale")) {
            (Some(Value::Mesh(_)), Some(Value::List(scale))) => {
                let stops: Option<_> = scale.values().map(|stop| stop_of(&stop)).collect();
                let title = match record.get("kind") {
                    Some(Value::Text(kind)) => format!("{name}: {kind}"),
                    _ => name.to_owned(),
                };
                let has =
                    |name| matches!(record.get(name), Some(Value::Number(n)) if 0.0 < n.value);
                let beyond = [has("below"), has("above")];
                stops.map(|stops| Legend { title, stops, beyond }).into_iter().collect()
            }
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

/// A value of a scale with its colour.
fn stop_of(stop: &Value) -> Option<(f64, glam::DVec3)> {
    let Value::Record(stop) = stop else { return None };
    match (stop.get("value"), stop.get("color")) {
        (Some(Value::Number(number)), Some(Value::Point(color))) => Some((number.value, *color)),
        _ => None,
    }
}
