//! The texts that spans point into, laid end to end.

use std::sync::{Arc, OnceLock};

use super::Span;

/// One text with its name.
#[derive(Clone, Debug)]
pub struct Source {
    /// What messages call it: a path, or `<stdin>`.
    pub name: String,
    /// Its text.
    pub text: Arc<str>,
    /// The place of its first byte among all sources.
    pub base: u32,
    /// The bytes at which its lines begin, once somebody asked.
    line_starts: OnceLock<Vec<u32>>,
}

impl Source {
    /// A place counted from the start of this text, clamped to it and to whole characters.
    #[must_use]
    pub fn local(&self, span: Span) -> std::ops::Range<usize> {
        let clamp = |at: u32| {
            let at = at.saturating_sub(self.base) as usize;
            self.text.floor_char_boundary(at.min(self.text.len()))
        };
        let (start, end) = (clamp(span.start), clamp(span.end));
        start..end.max(start)
    }

    /// Line and column of a place, both from 1; the column counts characters. The lines are counted once, for the
    /// first place that is asked for; after that a place costs no more than its line is long.
    #[must_use]
    pub fn line_column(&self, at: u32) -> (usize, usize) {
        let at = self.local(Span::new(at, at)).start;
        let starts = self.line_starts.get_or_init(|| {
            let ends = self.text.bytes().zip(1..).filter(|&(byte, _)| byte == b'\n');
            std::iter::once(0).chain(ends.map(|(_, behind)| behind)).collect()
        });
        let line = starts.partition_point(|&start| start as usize <= at);
        let line_start = starts[line - 1] as usize;
        (line, 1 + self.text[line_start..at].chars().count())
    }
}

/// All sources of a run.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    sources: Vec<Source>,
}

impl Sources {
    /// Adds a text; its place among all sources. A byte is left between two texts, so that the
    /// end of one is not the start of the next.
    pub fn add(&mut self, name: impl Into<String>, text: Arc<str>) -> u32 {
        let base = self.sources.last().map_or(0, |last| last.base + last.text.len() as u32 + 1);
        self.sources.push(Source { name: name.into(), text, base, line_starts: OnceLock::new() });
        base
    }

    /// The source in which a place lies.
    #[must_use]
    pub fn at(&self, span: Span) -> Option<&Source> {
        let idx = self.sources.partition_point(|source| source.base <= span.start);
        self.sources.get(idx.checked_sub(1)?)
    }

    /// Every source.
    pub fn iter(&self) -> impl Iterator<Item = &Source> {
        self.sources.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::{Sources, Span};

    #[test]
    fn a_place_finds_its_source() {
        let mut sources = Sources::default();
        sources.add("a", "let x = 1".into());
        let base = sources.add("b", "größe\nzwei".into());
        let place = Span::new(base + 8, base + 12);
        let source = sources.at(place).unwrap();
        assert_eq!((source.name.as_str(), source.line_column(place.start)), ("b", (2, 1)));
        assert_eq!(&source.text[source.local(place)], "zwei");
    }

    #[test]
    fn places_are_told_by_line_and_column() {
        let mut sources = Sources::default();
        let base = sources.add("a", "ä\n\nbc\n".into());
        let source = sources.iter().next().unwrap();
        let told: Vec<(usize, usize)> =
            [0, 1, 2, 3, 4, 5, 6, 7, 99].map(|at| source.line_column(base + at)).into();
        let expected = [(1, 1), (1, 1), (1, 2), (2, 1), (3, 1), (3, 2), (3, 3), (4, 1), (4, 1)];
        assert_eq!(told, expected);
    }
}
