//! The lines of an OBJ file, as the library reads them.
//!
//! The file's lines end in any way and may go on after a `\`. The library gets those alone that make
//! triangles, one after another; it takes a polyline for a polygon otherwise, and colours that only some
//! vertices have for a mistake. On the way each corner is looked at and what is made of it is counted. A
//! corner that stands twice is one, and a face that has no area, whatever the places of its vertices, is left out.

use std::{
    borrow::Cow,
    io::{self, BufRead, Read},
};

use super::lines::lines;
use crate::{limits::work, value::ENDED};

/// Bytes that the library makes of a corner, and of each that is not like one before.
const CORNER: usize = 24;
const DISTINCT: usize = 200;

/// Bytes that are made of each byte of a line until it is read, and the length from which they count: a
/// corner of two bytes becomes a word of 16 and three numbers of 24.
const BYTE: usize = 24;
const LONG: usize = 1 << 12;

/// Lines with their numbers; one that goes on after a `\` has that of its beginning.
pub(super) fn whole_lines(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut numbered = lines(text).enumerate();
    std::iter::from_fn(move || {
        let (idx, first) = numbered.next()?;
        let goes_on = |part: &str| part.trim_end().ends_with('\\');
        let mut whole = Cow::Borrowed(first);
        let mut part = first;
        while goes_on(part) {
            let whole = whole.to_mut();
            whole.truncate(whole.trim_end().len() - 1);
            whole.push(' ');
            part = numbered.next().map_or("", |(_, next)| next);
            whole.push_str(part);
        }
        Some((idx + 1, whole))
    })
}

/// Faces that name too few vertices to have an area: where the first stands, and how many there are.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FacesWithoutArea {
    line: usize,
    n_faces: usize,
}

impl FacesWithoutArea {
    fn add(&mut self, line: usize) {
        if self.n_faces == 0 {
            self.line = line;
        }
        self.n_faces += 1;
    }

    /// What is to be said of them, if there are any.
    pub(super) fn message(&self) -> Option<String> {
        let more = match self.n_faces {
            0 => return None,
            1 => String::new(),
            n => format!(", and {} more with it", n - 1),
        };
        let line = self.line;
        Some(format!(
            "line {line}: the face names a vertex twice and has no area; it is left out{more}"
        ))
    }
}

/// What the library reads.
pub(super) struct ObjLines<I> {
    lines: I,
    /// The line under way, and how much of it was taken.
    line: Vec<u8>,
    n_taken: usize,
    /// Vertices, texture coordinates and normals so far.
    n_before: [i64; 3],
    /// Corners since the last group, and whether they name more than their vertex.
    n_corners: usize,
    has_parts: bool,
    /// Faces that were left out.
    pub(super) without_area: FacesWithoutArea,
    /// What is wrong with the line that was read last.
    pub(super) mistake: Option<String>,
}

impl<'t, I: Iterator<Item = (usize, Cow<'t, str>)>> ObjLines<I> {
    pub(super) fn new(lines: I) -> Self {
        Self {
            lines,
            line: Vec::new(),
            n_taken: 0,
            n_before: [0; 3],
            n_corners: 0,
            has_parts: false,
            without_area: FacesWithoutArea::default(),
            mistake: None,
        }
    }

    /// Goes on to the next line that counts; at the end there is none.
    fn advance(&mut self) -> Result<(), String> {
        self.line.clear();
        self.n_taken = 0;
        loop {
            let Some((number, line)) = self.lines.next() else { return self.group() };
            let n_bytes = if line.len() < LONG { 0 } else { BYTE * line.len() };
            if !work::goes_on(1) || !work::has_room(n_bytes) {
                return Err(ENDED.to_owned());
            }
            let mut words = line.split_whitespace();
            let Some(keyword) = words.next() else { continue };
            if matches!(keyword, "o" | "g") {
                self.group()?;
                self.keep([line.trim()]);
                return Ok(());
            }
            let words = words.take_while(|word| !word.starts_with('#'));
            let words: Vec<&str> = words.flat_map(|word| word.split('#').next()).collect();
            let told = |what| format!("line {number}: {what}");
            match keyword {
                "v" | "vt" | "vn" => {
                    let kind = ["v", "vt", "vn"].iter().position(|kind| *kind == keyword);
                    self.n_before[kind.unwrap_or_default()] += 1;
                    // A colour of three numbers may follow the place or its weight.
                    let n_kept = match (keyword, words.len()) {
                        ("v", n @ (6 | 7)) => n - 3,
                        (_, n) => n,
                    };
                    self.keep([keyword].into_iter().chain(words[..n_kept].iter().copied()));
                }
                "f" => {
                    if words.len() < 3 {
                        let n = words.len();
                        return Err(told(format!("a face needs 3 corners or more, found {n}")));
                    }
                    let wrong =
                        words.iter().find_map(|corner| corner_mistake(corner, self.n_before));
                    if let Some(what) = wrong {
                        return Err(told(what));
                    }
                    let words = apart(words, self.n_before[0]);
                    if !has_area(&words, self.n_before[0]) {
                        self.without_area.add(number);
                        continue;
                    }
                    self.n_corners += words.len();
                    self.has_parts |= words[0].contains('/');
                    self.keep([keyword].into_iter().chain(words));
                }
                _ => continue,
            }
            return Ok(());
        }
    }

    fn keep<'w>(&mut self, words: impl IntoIterator<Item = &'w str>) {
        for word in words {
            self.line.extend_from_slice(word.as_bytes());
            self.line.push(b' ');
        }
        self.line.push(b'\n');
    }

    /// The library makes the mesh of a group at its end, all at once.
    fn group(&mut self) -> Result<(), String> {
        let [n_vertices, n_uvs, n_normals] = self.n_before.map(|n| n.unsigned_abs() as usize);
        // A vertex comes again where its neighbours see another side of it.
        let n_distinct =
            if self.has_parts { 2 * (n_vertices + n_uvs + n_normals) } else { n_vertices };
        let n_distinct = n_distinct.min(self.n_corners);
        let n_bytes = CORNER * self.n_corners + DISTINCT * n_distinct;
        (self.n_corners, self.has_parts) = (0, false);
        if work::has_room(n_bytes) { Ok(()) } else { Err(ENDED.to_owned()) }
    }
}

/// The number of the vertex of a corner, when so many came before.
fn vertex(corner: &str, n_before: i64) -> Option<i64> {
    let number: i64 = corner.split('/').next()?.parse().ok()?;
    Some(if number < 0 { n_before + 1 + number } else { number })
}

/// Corners without those that name the vertex of the one before them, around the face.
fn apart(mut corners: Vec<&str>, n_before: i64) -> Vec<&str> {
    corners.dedup_by_key(|corner| vertex(corner, n_before));
    let ends = [corners.first(), corners.last()].map(|end| vertex(end?, n_before));
    if 1 < corners.len() && ends[0] == ends[1] {
        corners.pop();
    }
    corners
}

/// Whether something is left of a face without its ways there and back.
fn has_area(corners: &[&str], n_before: i64) -> bool {
    let mut left: Vec<Option<i64>> = Vec::with_capacity(corners.len());
    for corner in corners {
        let next = vertex(corner, n_before);
        match left.len().checked_sub(2) {
            Some(before) if left[before] == next => {
                left.pop();
            }
            _ => left.push(next),
        }
    }
    2 < left.len()
}

/// What is wrong with a corner such as `7/1/-3` when so many vertices, texture coordinates and normals
/// came before. What comes later may be named too.
fn corner_mistake(corner: &str, n_before: [i64; 3]) -> Option<String> {
    let kinds = ["vertex", "texture coordinate", "normal"];
    if kinds.len() < corner.split('/').count() {
        return Some(format!(
            "a corner names a vertex, a texture coordinate and a normal, found `{corner}`"
        ));
    }
    for ((part, kind), n_before) in corner.split('/').zip(kinds).zip(n_before) {
        if part.is_empty() && kind != "vertex" {
            continue;
        }
        match part.parse::<i64>() {
            Err(_) => {
                return Some(format!("a corner must be the number of a {kind}, found `{corner}`"));
            }
            Ok(idx) if idx == 0 || idx < -n_before || i64::from(u32::MAX) < idx => {
                return Some(format!("{kind} {idx} does not exist; {n_before} came before"));
            }
            Ok(_) => {}
        }
    }
    None
}

impl<'t, I: Iterator<Item = (usize, Cow<'t, str>)>> Read for ObjLines<I> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let n_taken = self.fill_buf()?.read(bytes)?;
        self.consume(n_taken);
        Ok(n_taken)
    }
}

impl<'t, I: Iterator<Item = (usize, Cow<'t, str>)>> BufRead for ObjLines<I> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.n_taken == self.line.len()
            && let Err(mistake) = self.advance()
        {
            self.mistake = Some(mistake);
            return Err(io::ErrorKind::InvalidData.into());
        }
        Ok(&self.line[self.n_taken..])
    }

    fn consume(&mut self, n_taken: usize) {
        self.n_taken += n_taken;
    }
}
