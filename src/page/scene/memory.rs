//! What was made of definitions, by their identity: meshes, lines, boxes. What no state shows any
//! more is forgotten.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use super::{
    DefinitionItems, SceneDefinition,
    deferred::ItemSource,
    encode::{EncodedItem, Fineness},
    parts::{self, Piece},
};
use crate::kernel::Bounds;

/// A definition's identity and how finely it is drawn, as bits.
type ItemName = (u64, [u64; 3]);

/// Items of this state and the one before.
#[derive(Debug)]
pub(crate) struct ItemMemory {
    /// Tells keys of this process from those of others, which a browser may still know.
    process: u64,
    items: BTreeMap<ItemName, DefinitionItems>,
    bounds: BTreeMap<u64, Option<Bounds>>,
    /// What the scene in the making shows, and what the ones before it did.
    used: [BTreeSet<ItemName>; 2],
    known_bounds: BTreeSet<u64>,
}

fn named(identity: u64, fineness: &Fineness) -> ItemName {
    (identity, [fineness.chord, fineness.angle, fineness.weld].map(f64::to_bits))
}

impl ItemMemory {
    pub(crate) fn new(process: u64) -> Self {
        Self {
            process,
            items: BTreeMap::new(),
            bounds: BTreeMap::new(),
            used: Default::default(),
            known_bounds: BTreeSet::new(),
        }
    }

    /// The box around all definitions that are not hidden, or around all.
    pub(super) fn whole(&mut self, definitions: &[SceneDefinition<'_>]) -> Option<Bounds> {
        let bounds: Vec<(bool, Option<Bounds>)> = definitions
            .iter()
            .map(|definition| {
                let its = self.bounds.entry(definition.identity).or_insert_with(|| {
                    let pieces = parts::pieces(definition.value);
                    pieces.iter().filter_map(|piece| piece.shape.bounds()).reduce(Bounds::union)
                });
                (definition.defined.look.is_hidden, *its)
            })
            .collect();
        self.known_bounds = definitions.iter().map(|definition| definition.identity).collect();
        let whole = |with_hidden: bool| {
            let chosen = bounds.iter().filter(|(is_hidden, _)| with_hidden || !is_hidden);
            chosen.filter_map(|(_, bounds)| *bounds).reduce(Bounds::union)
        };
        whole(false).or_else(|| whole(true))
    }

    /// Whether the items of a definition are there, and made where they are shown.
    pub(super) fn knows(&self, identity: u64, fineness: &Fineness, is_shown: bool) -> bool {
        let found = self.items.get(&named(identity, fineness));
        found.is_some_and(|its| !(is_shown && its.is_deferred()))
    }

    pub(super) fn keep(&mut self, identity: u64, fineness: &Fineness, items: DefinitionItems) {
        self.items.insert(named(identity, fineness), items);
    }

    /// Adds a piece of a definition, or why it cannot be drawn.
    pub(super) fn add(
        &mut self,
        identity: u64,
        fineness: &Fineness,
        (number, piece): (usize, Piece),
        item: Result<EncodedItem, String>,
    ) {
        let Some(kept) = self.items.get_mut(&named(identity, fineness)) else { return };
        match item {
            Ok(item) => {
                let told = item.trouble.iter().map(|why| format!("{}`: {why}", piece.path));
                kept.troubles.extend(told);
                kept.items.push((number, piece, ItemSource::Made(Arc::new(item))));
            }
            Err(why) => kept.troubles.push(format!("{}` cannot be drawn: {why}", piece.path)),
        }
    }

    /// The items of a definition for the scene in the making, and what their keys begin with.
    pub(super) fn take(
        &mut self,
        identity: u64,
        fineness: &Fineness,
    ) -> Option<(String, DefinitionItems)> {
        let name = named(identity, fineness);
        self.used[0].insert(name);
        let (chord, weld) = (fineness.chord.to_bits(), fineness.weld.to_bits());
        let base = format!("{:x}-{identity:x}-{chord:x}-{weld:x}", self.process);
        Some((base, self.items.get(&name)?.clone()))
    }

    /// The scene is shown: what neither it nor the one before it shows is forgotten.
    pub(crate) fn settle(&mut self) {
        let [now, before] = &self.used;
        self.items.retain(|name, _| now.contains(name) || before.contains(name));
        self.bounds.retain(|identity, _| self.known_bounds.contains(identity));
        self.used.swap(0, 1);
        self.used[0].clear();
    }

    /// The scene is not shown: what was made for it alone may go with the next one.
    pub(crate) fn discard(&mut self) {
        self.used[0].clear();
    }
}

#[cfg(test)]
mod tests {
    use super::ItemMemory;
    use crate::{page::scene::Scene, session::Session, value::NoFiles};

    #[test]
    fn what_is_shown_no_more_is_forgotten() {
        let session = Session::default().incremental();
        let mut memory = ItemMemory::new(1);
        let mut keys = Vec::new();
        for i in 0..40 {
            let text =
                format!("surface s = sphere((0, 0), 8)\ncurve c = line((0, 0), (1, {i}/100))");
            let report = session.run("s", text.as_bytes(), &NoFiles, &[]);
            let scene = Scene::of(&report, &session, &mut memory).expect("nobody stops it");
            keys.extend(scene.items.iter().map(|item| item.key.clone()));
            memory.settle();
            assert!(memory.items.len() <= 4 && scene.items.len() == 2);
        }
        keys.sort();
        keys.dedup();
        assert_eq!(keys.len(), 41, "the sphere is made once");
    }
}
