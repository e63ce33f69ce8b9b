//! The scene: what of a script's definitions is seen, each item with a key and its bytes.

mod bytes;
mod deferred;
mod encode;
mod face_lines;
mod isolines;
mod memory;
mod meshes;
mod parts;
mod snaps;

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use serde_json::json;

pub(crate) use self::{
    deferred::ItemSource,
    encode::{EncodedItem, Fineness},
    isolines::isolines,
    memory::ItemMemory,
    parts::{Piece, Shape},
};
use super::{ceilings::within_ceilings, threads::side_by_side};
use crate::{
    diag::Span,
    eval::Defined,
    kernel::{
        Bounds, Mesh,
        tolerance::{DEFAULT_CHORD_RELATIVE, VIEW_ANGLE},
    },
    session::{Report, Session, drawable, exported},
    value::Value,
};

/// Items of one scene; what comes behind them is not drawn, but told.
const MOST_ITEMS: usize = 20_000;

/// An item with what it was made from.
#[derive(Debug)]
pub(crate) struct SceneItem {
    pub(crate) key: Arc<str>,
    /// The definition among those of the report.
    pub(crate) definition: usize,
    pub(crate) piece: Piece,
    pub(crate) is_exported: bool,
    pub(crate) is_shown: bool,
    pub(crate) source: ItemSource,
}

/// The items of a script, as far as it has no errors.
#[derive(Debug, Default)]
pub(crate) struct Scene {
    pub(crate) items: Vec<SceneItem>,
    /// What could not be drawn, each a sentence with the place of its definition.
    pub(crate) troubles: Vec<(Span, String)>,
    pub(crate) bounds: Option<Bounds>,
}

/// A definition on its way into the scene.
struct SceneDefinition<'a> {
    number: usize,
    defined: &'a Defined,
    value: &'a Value,
    /// Its identity; one that no other has where the session gives none.
    identity: u64,
    is_exported: bool,
    is_shown: bool,
}

impl Scene {
    /// The item of a key.
    pub(crate) fn item(&self, key: &str) -> Option<&SceneItem> {
        self.items.iter().find(|item| *item.key == *key)
    }

    /// The scene of a report; `None` where nobody wants it any more.
    pub(crate) fn of(report: &Report, session: &Session, memory: &mut ItemMemory) -> Option<Self> {
        let mut definitions = definitions(report);
        let behind = cut(&mut definitions);
        let mut scene = Self { bounds: memory.whole(&definitions), ..Self::default() };
        let fineness = fineness(report, session, scene.bounds);
        definitions.iter().for_each(|its| memory.inherit(its, &fineness));
        let missing: Vec<&SceneDefinition<'_>> = definitions
            .iter()
            .filter(|its| !memory.knows(its.identity, &fineness, its.is_shown))
            .collect();
        let missing = deferred(missing, memory, &fineness);
        let made = side_by_side(&missing, session, |definition| {
            let pieces = parts::pieces(definition.value);
            (pieces.clone(), meshes::meshes(&pieces, session, &fineness))
        })?;
        let parts = made.into_iter().zip(&missing).flat_map(|((pieces, meshes), definition)| {
            let parts = pieces.into_iter().enumerate().zip(meshes);
            parts.map(|(piece, mesh)| (definition.identity, piece, mesh)).collect::<Vec<_>>()
        });
        let parts: Vec<(u64, (usize, Piece), Result<Option<Mesh>, String>)> = parts.collect();
        let encoded = side_by_side(&parts, session, |(_, (_, piece), mesh)| {
            let mesh = mesh.clone()?;
            within_ceilings(session, || encode::encoded(&piece.shape, mesh, &fineness))
        })?;
        for definition in &missing {
            memory.begin(definition.identity, &fineness);
        }
        for ((identity, piece, _), item) in parts.into_iter().zip(encoded) {
            memory.add(identity, &fineness, piece, item);
        }
        if let Some(span) = scene.fill(&definitions, memory, &fineness).or(behind) {
            let text = format!("the scene has more than {MOST_ITEMS} items; the rest is not drawn");
            scene.troubles.push((span, text));
        }
        Some(scene)
    }

    /// Takes the items of all definitions from the memory; the place of one for which there is no room.
    fn fill(
        &mut self,
        definitions: &[SceneDefinition<'_>],
        memory: &mut ItemMemory,
        fineness: &Fineness,
    ) -> Option<Span> {
        let mut n_alike: BTreeMap<Arc<str>, usize> = BTreeMap::new();
        for definition in definitions {
            let Some(kept) = memory.take(definition, fineness) else { continue };
            let name = &definition.defined.name;
            let span = definition.defined.span;
            let troubles = kept.troubles.iter().map(|text| format!("`{name}{text}"));
            self.troubles.extend(troubles.map(|text| (span, text)));
            for item in kept.items {
                if MOST_ITEMS <= self.items.len() {
                    return Some(span);
                }
                // Whoever asks for one of two alike means that one.
                let n_before = n_alike.entry(Arc::clone(&item.key)).or_default();
                let key = match *n_before {
                    0 => item.key,
                    n => format!("{}-{n}", item.key).into(),
                };
                *n_before += 1;
                self.items.push(SceneItem {
                    key,
                    definition: definition.number,
                    piece: item.piece,
                    is_exported: definition.is_exported,
                    is_shown: definition.is_shown,
                    source: item.source,
                });
            }
        }
        None
    }
}

/// Leaves out the definitions for which a scene has no room, before anything is made of them; the place of the first.
fn cut(definitions: &mut Vec<SceneDefinition<'_>>) -> Option<Span> {
    if definitions.len() <= MOST_ITEMS {
        return None;
    }
    let mut n_items = 0;
    let n_seen = definitions.iter().take_while(|its| {
        let has_room = n_items <= MOST_ITEMS;
        n_items += parts::pieces(its.value).len();
        has_room
    });
    let n_seen = n_seen.count();
    let span = definitions.get(n_seen).map(|its| its.defined.span);
    definitions.truncate(n_seen);
    span
}

/// The definitions that are seen, those that are hidden included.
fn definitions(report: &Report) -> Vec<SceneDefinition<'_>> {
    // `drawable` goes through the definitions in their order.
    let mut numbers = (0..report.definitions.len()).peekable();
    let mut found = Vec::new();
    let exports = exported(report);
    for (defined, value) in drawable(report) {
        let is_it = |&number: &usize| std::ptr::eq(&raw const report.definitions[number], defined);
        let Some(number) = numbers.by_ref().find(is_it) else { break };
        let identity = defined.identity.unwrap_or(u64::MAX - number as u64);
        let is_exported = exports.contains(defined.name.as_str());
        let is_shown = !defined.look.is_hidden;
        found.push(SceneDefinition { number, defined, value, identity, is_exported, is_shown });
    }
    // As a picture of the script shows what it exports, if it exports geometry.
    if found.iter().any(|its| its.is_shown && its.is_exported) {
        found.iter_mut().for_each(|its| its.is_shown &= its.is_exported);
    }
    found
}

/// Those whose items are made now; surfaces that are not shown wait in the memory.
fn deferred<'a, 'd>(
    missing: Vec<&'d SceneDefinition<'a>>,
    memory: &mut ItemMemory,
    fineness: &Fineness,
) -> Vec<&'d SceneDefinition<'a>> {
    let now = |definition: &&SceneDefinition<'_>| {
        if definition.is_shown {
            return true;
        }
        let pieces = parts::pieces(definition.value);
        if !pieces.iter().any(|piece| piece.shape.is_tessellated()) {
            return true;
        }
        memory.defer(definition.identity, fineness, pieces);
        false
    };
    let mut now: Vec<_> = missing.into_iter().filter(now).collect();
    // Definitions with one text have one identity.
    let mut known = BTreeSet::new();
    now.retain(|definition| known.insert(definition.identity));
    now
}

/// How fine a scene of this size is drawn. The size is a power of two, so that what grows a little
/// leaves all else as it is.
pub(crate) fn fineness(report: &Report, session: &Session, bounds: Option<Bounds>) -> Fineness {
    let size = bounds.map_or(0.0, Bounds::diagonal);
    let size = if 0.0 < size && size.is_finite() { size } else { 1.0 };
    let step = libm::exp2(libm::floor(libm::log2(size)));
    Fineness {
        chord: DEFAULT_CHORD_RELATIVE * step,
        angle: VIEW_ANGLE,
        weld: report.document.1.distance,
        most: session.limits().mesh_vertices,
    }
}

/// What is told of an item in the state.
pub(crate) fn bounds_json(bounds: Option<Bounds>) -> serde_json::Value {
    bounds.map_or(serde_json::Value::Null, |its| json!([its.min.to_array(), its.max.to_array()]))
}
