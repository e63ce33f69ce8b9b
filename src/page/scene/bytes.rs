//! The bytes of an item: a header of JSON, then numbers, little-endian, at the places that it names.

use std::hash::{DefaultHasher, Hasher};

use glam::DVec3;
use serde_json::{Map, Value as Json, json};

/// Where the numbers begin, and each run of them after the other, is a multiple of this.
const ALIGNMENT: usize = 8;

/// What not every item has.
const OPTIONAL: &[&str] = &[
    "positions",
    "normals",
    "parameters",
    "curvatures",
    "colors",
    "triangles",
    "segments",
    "control",
    "knots",
    "comb",
    "snaps",
];

/// Lists of polylines, which may be empty.
const LINES: &[&str] = &["edges", "isocurves", "isocombs"];

/// An item in the making.
#[derive(Debug, Default)]
pub(super) struct ItemWriter {
    header: Map<String, Json>,
    numbers: Vec<u8>,
    center: DVec3,
}

impl ItemWriter {
    /// An item of a kind, whose places are written relative to `center`.
    pub(super) fn new(kind: &str, center: DVec3) -> Self {
        let mut header = Map::new();
        header.insert("kind".to_owned(), json!(kind));
        header.insert("center".to_owned(), json!(center.to_array()));
        // What an item does not have is told as well, so that the page need not guess.
        for name in OPTIONAL {
            header.insert((*name).to_owned(), Json::Null);
        }
        for name in LINES {
            header.insert((*name).to_owned(), json!([]));
        }
        Self { header, numbers: Vec::new(), center }
    }

    /// Sets a member of the header.
    pub(super) fn set(&mut self, name: &str, value: Json) {
        self.header.insert(name.to_owned(), value);
    }

    /// Puts bytes behind those that are there; where they are, with how many things they hold.
    fn put(&mut self, count: usize, bytes: impl IntoIterator<Item = [u8; 4]>) -> Json {
        let offset = self.numbers.len();
        bytes.into_iter().for_each(|four| self.numbers.extend_from_slice(&four));
        self.numbers.resize(self.numbers.len().next_multiple_of(ALIGNMENT), 0);
        json!({ "offset": offset, "count": count })
    }

    /// Places, relative to the item's centre.
    pub(super) fn places(&mut self, places: &[DVec3]) -> Json {
        let center = self.center;
        self.triples(places.len(), places.iter().map(|place| *place - center))
    }

    /// Vectors as they are.
    pub(super) fn vectors(&mut self, vectors: &[DVec3]) -> Json {
        self.triples(vectors.len(), vectors.iter().copied())
    }

    fn triples(&mut self, count: usize, triples: impl Iterator<Item = DVec3>) -> Json {
        self.put(count, triples.flat_map(|triple| triple.to_array().map(single)))
    }

    /// Numbers, of which `size` belong together.
    pub(super) fn numbers(&mut self, size: usize, numbers: &[f64]) -> Json {
        self.put(numbers.len() / size, numbers.iter().map(|&number| single(number)))
    }

    /// Triples of vertices.
    pub(super) fn triangles(&mut self, triangles: &[[u32; 3]]) -> Json {
        self.put(triangles.len(), triangles.iter().flatten().map(|corner| corner.to_le_bytes()))
    }

    /// Opaque colours with levels on 0..1.
    pub(super) fn colors(&mut self, colors: &[DVec3]) -> Json {
        let level = |level: f64| (level * 255.0).round() as u8;
        let bytes =
            colors.iter().map(|color| [level(color.x), level(color.y), level(color.z), 255]);
        self.put(colors.len(), bytes)
    }

    /// All of it.
    pub(super) fn finish(self) -> Vec<u8> {
        let mut header = Json::Object(self.header);
        // The places move by the length of the header, which their digits change a little.
        let n_places = count_places(&header);
        let slack = n_places * u32::MAX.to_string().len();
        let start = (4 + header.to_string().len() + slack).next_multiple_of(ALIGNMENT);
        move_places(&mut header, start);
        let mut text = header.to_string().into_bytes();
        text.resize(start - 4, b' ');
        let mut bytes = Vec::with_capacity(start + self.numbers.len());
        bytes.extend(((start - 4) as u32).to_le_bytes());
        bytes.extend(text);
        bytes.extend(self.numbers);
        bytes
    }
}

/// The numbers that a member of an item's header names, of which `size` belong together; none where it has
/// no such member.
pub(super) fn numbers_of(bytes: &[u8], name: &str, size: usize) -> Option<Vec<f64>> {
    let n_header = u32::from_le_bytes(bytes.get(..4)?.try_into().ok()?) as usize;
    let header: Json = serde_json::from_slice(bytes.get(4..4 + n_header)?).ok()?;
    let place = &header[name];
    let start = place["offset"].as_u64()? as usize;
    let length = 4 * size * place["count"].as_u64()? as usize;
    let numbers = bytes.get(start..start + length)?.chunks_exact(4);
    let number = |four: &[u8]| four.try_into().map(f32::from_le_bytes).map(f64::from).ok();
    numbers.map(number).collect()
}

/// A number that stands for these bytes: others have another one, of the same length but for a chance of 2⁻⁶⁴.
pub(super) fn digest(bytes: &[u8]) -> u128 {
    let mut hasher = DefaultHasher::new();
    hasher.write(bytes);
    (bytes.len() as u128) << u64::BITS | u128::from(hasher.finish())
}

fn single(number: f64) -> [u8; 4] {
    (number as f32).to_le_bytes()
}

/// How many places of numbers a header names.
fn count_places(header: &Json) -> usize {
    match header {
        Json::Object(members) => {
            usize::from(members.contains_key("offset"))
                + members.values().map(count_places).sum::<usize>()
        }
        Json::Array(items) => items.iter().map(count_places).sum(),
        _ => 0,
    }
}

/// Moves the places of numbers that a header names.
fn move_places(header: &mut Json, by: usize) {
    match header {
        Json::Object(members) => {
            for (name, member) in members.iter_mut() {
                match member.as_u64().filter(|_| name == "offset") {
                    Some(offset) => *member = json!(offset as usize + by),
                    None => move_places(member, by),
                }
            }
        }
        Json::Array(items) => items.iter_mut().for_each(|item| move_places(item, by)),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::{DVec3, ItemWriter, Json, digest};

    #[test]
    fn bytes_that_differ_anywhere_have_another_digest() {
        let bytes: Vec<u8> = (0..100).collect();
        let mut digests = vec![digest(&bytes), digest(&[]), digest(&[0])];
        digests.extend((0..100).map(|n| digest(&bytes[..n])).skip(2));
        for i in 0..bytes.len() {
            for bit in 0..8 {
                let mut other = bytes.clone();
                other[i] ^= 1 << bit;
                digests.push(digest(&other));
            }
        }
        let n = digests.len();
        digests.sort_unstable();
        digests.dedup();
        assert_eq!(digests.len(), n);
        assert_eq!(digest(&bytes), digest(&bytes.clone()));
    }

    #[test]
    fn numbers_stand_where_the_header_says() {
        let mut item = ItemWriter::new("points", DVec3::new(1.0, 2.0, 3.0));
        let edges: Vec<Json> = (0..50).map(|_| item.places(&[DVec3::ZERO])).collect();
        item.set("edges", edges.into());
        let numbers = item.numbers(1, &[0.5, 0.25]);
        item.set("numbers", numbers);
        let bytes = item.finish();
        let n = u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
        assert_eq!((4 + n) % 8, 0);
        let header: Json = serde_json::from_slice(&bytes[4..4 + n]).unwrap();
        let at = |place: &Json, i: usize| {
            let start = place["offset"].as_u64().unwrap() as usize + 4 * i;
            f32::from_le_bytes(bytes[start..start + 4].try_into().unwrap())
        };
        let numbers = [at(&header["numbers"], 0), at(&header["numbers"], 1)];
        assert_eq!(numbers.map(f32::to_bits), [0.5_f32, 0.25].map(f32::to_bits));
        let edge = [0, 1, 2].map(|i| at(&header["edges"][49], i));
        assert_eq!(edge.map(f32::to_bits), [-1.0_f32, -2.0, -3.0].map(f32::to_bits));
    }
}
