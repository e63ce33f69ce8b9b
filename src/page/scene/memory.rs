//! What was made of definitions, by their identity: meshes, lines, boxes. What no state shows any
//! more is forgotten.
//!
//! A definition that was evaluated anew has another identity, but often the geometry that it had: then it
//! takes over what was made for its name. What is made has keys that go by its bytes; what waits until
//! somebody asks for it has keys that go by the identity under which it came in.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use super::{
    SceneDefinition,
    deferred::{DeferredItems, ItemSource},
    encode::{EncodedItem, Fineness},
    parts::{self, Piece},
};
use crate::kernel::Bounds;

/// A piece of a definition, with what was made of it.
#[derive(Clone, Debug)]
pub(super) struct KeptItem {
    /// The number of its piece among all of the definition.
    number: usize,
    pub(super) piece: Piece,
    pub(super) key: Arc<str>,
    pub(super) source: ItemSource,
}

/// The items of one definition.
#[derive(Clone, Debug, Default)]
pub(super) struct DefinitionItems {
    pub(super) items: Vec<KeptItem>,
    pub(super) troubles: Vec<String>,
    /// Keys that pieces have had since before they were made, by their numbers.
    promised: BTreeMap<usize, Arc<str>>,
}

impl DefinitionItems {
    fn is_deferred(&self) -> bool {
        self.items.iter().any(|item| matches!(item.source, ItemSource::Deferred(..)))
    }

    /// Whether all of it was made, or may be made, of these pieces.
    fn is_of(&self, pieces: &[Piece]) -> bool {
        self.items.iter().map(|item| &item.piece).eq(pieces)
    }
}

/// A definition's identity and how finely it is drawn, as bits.
type ItemName = (u64, [u64; 3]);

/// Items of this state and the one before.
#[derive(Debug)]
pub(crate) struct ItemMemory {
    /// Tells keys that go by an identity from those of other processes, which a browser may still know.
    process: u64,
    items: BTreeMap<ItemName, DefinitionItems>,
    bounds: BTreeMap<u64, Option<Bounds>>,
    /// What the scene in the making shows, and what the one before it did, by the names of definitions.
    used: [BTreeMap<String, ItemName>; 2],
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

    /// Gives a definition that is not known the items that its name had before, where these are of the
    /// same geometry.
    pub(super) fn inherit(&mut self, definition: &SceneDefinition<'_>, fineness: &Fineness) {
        let name = named(definition.identity, fineness);
        let before = self.used[1].get(&definition.defined.name).filter(|before| before.1 == name.1);
        if let Some(before) = before.and_then(|before| self.items.get(before))
            && !self.items.contains_key(&name)
            && before.is_of(&parts::pieces(definition.value))
        {
            self.items.insert(name, before.clone());
        }
    }

    /// Keeps pieces that are made when somebody asks for them.
    pub(super) fn defer(&mut self, identity: u64, fineness: &Fineness, pieces: Vec<Piece>) {
        let (chord, weld) = (fineness.chord.to_bits(), fineness.weld.to_bits());
        let base = format!("{:x}-{identity:x}-{chord:x}-{weld:x}", self.process);
        let all = Arc::new(DeferredItems::new(pieces, *fineness));
        let item = |(number, piece): (usize, &Piece)| KeptItem {
            number,
            piece: piece.clone(),
            key: format!("{base}-{number:x}").into(),
            source: ItemSource::Deferred(Arc::clone(&all), number),
        };
        let items = all.pieces.iter().enumerate().map(item).collect();
        let kept = DefinitionItems { items, ..DefinitionItems::default() };
        self.items.insert(named(identity, fineness), kept);
    }

    /// Begins to make the items of a definition; what waited has its keys already.
    pub(super) fn begin(&mut self, identity: u64, fineness: &Fineness) {
        let kept = self.items.entry(named(identity, fineness)).or_default();
        let waited = std::mem::take(kept).items.into_iter();
        kept.promised = waited.map(|item| (item.number, item.key)).collect();
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
                let key = kept.promised.get(&number).cloned().unwrap_or_else(|| item.key());
                let source = ItemSource::Made(Arc::new(item));
                kept.items.push(KeptItem { number, piece, key, source });
            }
            Err(why) => kept.troubles.push(format!("{}` cannot be drawn: {why}", piece.path)),
        }
    }

    /// The items of a definition for the scene in the making.
    pub(super) fn take(
        &mut self,
        definition: &SceneDefinition<'_>,
        fineness: &Fineness,
    ) -> Option<DefinitionItems> {
        let name = named(definition.identity, fineness);
        self.used[0].insert(definition.defined.name.clone(), name);
        self.items.get(&name).cloned()
    }

    /// The scene is shown: what neither it nor the one before it shows is forgotten.
    pub(crate) fn settle(&mut self) {
        let used: BTreeSet<&ItemName> = self.used.iter().flat_map(BTreeMap::values).collect();
        self.items.retain(|name, _| used.contains(name));
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

    #[test]
    fn what_is_evaluated_anew_without_another_geometry_is_kept_once() {
        let session = Session::default().incremental();
        let mut memory = ItemMemory::new(1);
        let mut keys = Vec::new();
        for i in 0..40 {
            let text = format!(
                "let r = 8 + {i} - {i}\nsurface s = sphere((0, 0), r)\n\
                 surface t = sphere((0, 0), r) with (hidden = true)"
            );
            let report = session.run("s", text.as_bytes(), &NoFiles, &[]);
            let scene = Scene::of(&report, &session, &mut memory).expect("nobody stops it");
            keys.extend(scene.items.iter().map(|item| item.key.clone()));
            memory.settle();
            assert!(memory.items.len() <= 4 && scene.items.len() == 2);
        }
        keys.sort();
        keys.dedup();
        assert_eq!(keys.len(), 2);
    }
}
