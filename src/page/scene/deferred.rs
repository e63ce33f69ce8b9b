//! Items that nobody sees yet: their triangles are made when somebody asks for them.

use std::sync::{Arc, OnceLock};

use serde_json::{Map, Value as Json};

use super::{
    encode::{self, EncodedItem, Fineness},
    meshes,
    parts::Piece,
};
use crate::{
    kernel::{Bounds, Mesh},
    limits::stack,
    page::ceilings::within_ceilings,
    session::Session,
};

/// The surfaces of a definition that the script does not show.
#[derive(Debug)]
pub(crate) struct DeferredItems {
    pub(super) pieces: Vec<Piece>,
    fineness: Fineness,
    made: OnceLock<Vec<Arc<EncodedItem>>>,
}

impl DeferredItems {
    pub(super) fn new(pieces: Vec<Piece>, fineness: Fineness) -> Self {
        Self { pieces, fineness, made: OnceLock::new() }
    }

    /// The item of a piece, made with those of all others; whoever comes meanwhile waits. Of what cannot
    /// be drawn it is empty.
    fn item(&self, number: usize, session: &Session) -> Arc<EncodedItem> {
        // Functions of the script need the stack of an evaluation.
        let all = || stack::with(session.limits().stack_bytes, |_| self.all(session));
        Arc::clone(&self.made.get_or_init(all)[number])
    }

    fn all(&self, session: &Session) -> Vec<Arc<EncodedItem>> {
        let meshes = meshes::meshes(&self.pieces, session, &self.fineness);
        let encoded = |(piece, mesh): (&Piece, Result<Option<Mesh>, String>)| {
            let made = mesh.and_then(|mesh| {
                within_ceilings(session, || encode::encoded(&piece.shape, mesh, &self.fineness))
            });
            Arc::new(made.unwrap_or_else(|why| encode::empty(&piece.shape, &why)))
        };
        self.pieces.iter().zip(meshes).map(encoded).collect()
    }
}

/// An item that is there, or one that can be made.
#[derive(Clone, Debug)]
pub(crate) enum ItemSource {
    Made(Arc<EncodedItem>),
    /// The piece of this number.
    Deferred(Arc<DeferredItems>, usize),
}

impl ItemSource {
    /// The item itself.
    pub(crate) fn item(&self, session: &Session) -> Arc<EncodedItem> {
        match self {
            Self::Made(item) => Arc::clone(item),
            Self::Deferred(items, number) => items.item(*number, session),
        }
    }

    /// What there is to tell about it, as far as it is known.
    pub(crate) fn facts(&self) -> Map<String, Json> {
        match self {
            Self::Made(item) => item.facts.clone(),
            Self::Deferred(items, number) => {
                let known = || encode::facts_of(&items.pieces[*number].shape);
                items.made.get().map_or_else(known, |made| made[*number].facts.clone())
            }
        }
    }

    /// The box around it, if it has an end.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        match self {
            Self::Made(item) => item.bounds,
            Self::Deferred(items, number) => items.pieces[*number].shape.bounds(),
        }
    }
}
