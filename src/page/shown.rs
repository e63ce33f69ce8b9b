//! What is shown, and what questions may be about.

use std::{collections::BTreeMap, path::PathBuf, sync::Arc};

use super::scene::{ItemSource, Scene, SceneItem};
use crate::session::{Report, Session};

/// A state as the page has it, with what it was made from.
#[derive(Debug)]
pub(crate) struct Shown {
    pub(crate) version: u64,
    pub(crate) is_current: bool,
    /// The state as JSON.
    pub(crate) state: Vec<u8>,
    pub(crate) scene: Arc<Scene>,
    /// The report that the scene is of.
    pub(crate) report: Option<Arc<Report>>,
    /// The names of the parameters.
    pub(crate) parameters: Vec<String>,
    /// Parameters that are set and that the script has no more: what sets them is to be forgotten.
    pub(crate) lost: Vec<String>,
    /// Files that were read for it, of a script on a disk.
    #[cfg_attr(not(feature = "cli"), expect(dead_code, reason = "a page has no disk"))]
    pub(crate) inputs: Vec<PathBuf>,
}

impl Shown {
    /// The report whose files may be written.
    ///
    /// # Errors
    /// A sentence where there is none, or where the script has errors by now.
    pub(crate) fn to_export(&self) -> Result<&Arc<Report>, String> {
        let report = self.report.as_ref().ok_or("there is no model yet")?;
        let error = || "the script has errors; nothing is written".to_owned();
        self.is_current.then_some(report).ok_or_else(error)
    }
}

/// The items of the state that is shown, and of the one before, which a page may still show.
#[derive(Clone, Debug)]
pub(crate) struct Known {
    pub(crate) shown: Arc<Shown>,
    pub(crate) before: Arc<Shown>,
}

impl Known {
    /// The item of a key, with the report that it is of.
    pub(crate) fn item(&self, key: &str) -> Option<(&SceneItem, Option<&Arc<Report>>)> {
        let states = [&self.shown, &self.before];
        states.into_iter().find_map(|shown| Some((shown.scene.item(key)?, shown.report.as_ref())))
    }

    /// The bytes of these items, in their order; none of one that is not known any more.
    pub(crate) fn bytes(&self, keys: &[&str], session: &Session) -> Vec<Arc<Vec<u8>>> {
        let items = [&self.before, &self.shown].into_iter().flat_map(|shown| &shown.scene.items);
        let sources: BTreeMap<&str, &ItemSource> =
            items.map(|item| (&*item.key, &item.source)).collect();
        let bytes = |source: &&ItemSource| Arc::clone(&source.item(session).bytes);
        keys.iter().map(|key| sources.get(key).map(bytes).unwrap_or_default()).collect()
    }
}
