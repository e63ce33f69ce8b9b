//! Data files of a study: each is read once, and every variant sees what it held then.

use std::{
    collections::BTreeMap,
    sync::{Mutex, PoisonError},
};

use super::checksum::checksum;
use crate::value::Files;

/// Files as they were when they were asked for first.
#[derive(Debug)]
pub struct KeptFiles<'a> {
    from: &'a dyn Files,
    /// Sums that they must have, because rows that are kept came from those.
    expected: BTreeMap<String, String>,
    read: Mutex<ReadFiles>,
}

#[derive(Debug, Default)]
struct ReadFiles {
    /// By path and ceiling.
    contents: BTreeMap<(String, usize), Result<Vec<u8>, String>>,
    /// Sums that nobody has taken yet.
    news: Vec<(String, String)>,
    /// The first file that is not what it was.
    changed: Option<String>,
}

impl<'a> KeptFiles<'a> {
    /// Files that are read through `from`; those of `expected` must have these sums.
    #[must_use]
    pub fn new(from: &'a dyn Files, expected: BTreeMap<String, String>) -> Self {
        Self { from, expected, read: Mutex::default() }
    }

    /// Files that were read since the last call, with their sums.
    pub fn take_news(&self) -> Vec<(String, String)> {
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut read.news)
    }

    /// A file that is not what it was for the rows that are kept.
    #[must_use]
    pub fn changed(&self) -> Option<String> {
        self.read.lock().unwrap_or_else(PoisonError::into_inner).changed.clone()
    }
}

impl Files for KeptFiles<'_> {
    fn read(&self, path: &str, most: usize) -> Result<Vec<u8>, String> {
        let mut read = self.read.lock().unwrap_or_else(PoisonError::into_inner);
        let key = (path.to_owned(), most);
        if let Some(content) = read.contents.get(&key) {
            return content.clone();
        }
        let content = self.from.read(path, most);
        let sum = match &content {
            Ok(bytes) => checksum(bytes),
            Err(why) => checksum(why.as_bytes()),
        };
        match self.expected.get(path) {
            Some(expected) if *expected != sum => {
                read.changed.get_or_insert_with(|| path.to_owned());
            }
            Some(_) => {}
            None => read.news.push((path.to_owned(), sum)),
        }
        read.contents.insert(key, content.clone());
        content
    }

    fn beside(&self, path: &str) -> Vec<String> {
        self.from.beside(path)
    }
}
