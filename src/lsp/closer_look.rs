//! Closer looks at geometry for hovers: made in a thread of their own, and waited for so long as nobody minds.

use std::{
    ops::Range,
    time::{Duration, Instant},
};

use crossbeam_channel::{Receiver, bounded};

use crate::{ide::CloserLook, limits::work::StopToken};

/// How long a hover waits.
const PATIENCE: Duration = Duration::from_millis(12);
/// Looks that are remembered.
const MOST_REMEMBERED: usize = 16;
/// Bytes of the stack of the thread.
const STACK: usize = 8 << 20;

/// What a look is at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct LookKey {
    /// The address of the document.
    pub(super) uri: String,
    /// Which of its texts.
    pub(super) serial: u64,
    /// Of which of its texts the values are.
    pub(super) values: u64,
    /// Where the name stands.
    pub(super) place: Range<usize>,
}

/// The looks that were taken, and the one under way.
#[derive(Debug, Default)]
pub(super) struct CloserLooks {
    /// The newest last.
    taken: Vec<(LookKey, CloserLook)>,
    under_way: Option<(LookKey, Receiver<CloserLook>, StopToken)>,
}

impl CloserLooks {
    /// What a look tells, if it is over soon; else it goes on, for whoever asks again.
    pub(super) fn of(
        &mut self,
        key: LookKey,
        look: impl FnOnce(&StopToken) -> CloserLook + Send + 'static,
    ) -> Option<CloserLook> {
        self.collect(Duration::ZERO);
        if let Some((_, known)) = self.taken.iter().find(|(known, _)| *known == key) {
            return Some(known.clone());
        }
        if self.under_way.as_ref().is_none_or(|(begun, ..)| *begun != key) {
            self.begin(key.clone(), look);
        }
        self.collect(PATIENCE);
        self.taken.iter().find(|(known, _)| *known == key).map(|(_, known)| known.clone())
    }

    fn begin(
        &mut self,
        key: LookKey,
        look: impl FnOnce(&StopToken) -> CloserLook + Send + 'static,
    ) {
        if let Some((.., stop)) = self.under_way.take() {
            stop.stop();
        }
        let (taken, is_taken) = bounded(1);
        let stop = StopToken::default();
        let own = stop.clone();
        let work = move || {
            // Nobody may be there any more.
            let _ = taken.send(look(&own));
        };
        if std::thread::Builder::new().stack_size(STACK).spawn(work).is_ok() {
            self.under_way = Some((key, is_taken, stop));
        }
    }

    /// Takes over what the look under way came to, waiting for it so long.
    fn collect(&mut self, patience: Duration) {
        let Some((key, is_taken, _)) = &self.under_way else { return };
        let Ok(look) = is_taken.recv_deadline(Instant::now() + patience) else { return };
        self.taken.push((key.clone(), look));
        self.under_way = None;
        if MOST_REMEMBERED < self.taken.len() {
            self.taken.remove(0);
        }
    }
}
