//! JSON from text, counted while it is made.
//!
//! A few bytes of text make a value of many. What is made is told to whoever counts the memory of the
//! run ([`work`]) element by element, and reading ends when there is no more of it.

use std::fmt::{Formatter, Result as Written};

use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Value as Json};

use crate::limits::work;

/// The value that a text is.
///
/// # Errors
/// What is wrong with the text, with its line and column.
pub fn read_json(text: &str) -> Result<Json, String> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let json = Counted.deserialize(&mut reader).map_err(|err| err.to_string())?;
    reader.end().map_err(|err| err.to_string())?;
    Ok(json)
}

/// Makes a value, and counts it.
#[derive(Clone, Copy)]
struct Counted;

/// The sentence where reading was ended; whoever ended it says why.
pub const ENDED: &str = "reading was ended";

/// Whether an object of so many members, before the next comes, has room to grow.
fn can_grow(n_members: usize) -> bool {
    /// What a member takes besides the texts: its name, its value, its hash and its place.
    const MEMBER: usize = size_of::<String>() + size_of::<Json>() + 2 * size_of::<usize>();
    // It doubles at powers of two or nearby.
    n_members < 64 || !n_members.is_power_of_two() || work::has_room(n_members * MEMBER)
}

impl<'de> DeserializeSeed<'de> for Counted {
    type Value = Json;

    fn deserialize<D: Deserializer<'de>>(self, reader: D) -> Result<Json, D::Error> {
        reader.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Counted {
    type Value = Json;

    fn expecting(&self, f: &mut Formatter<'_>) -> Written {
        f.write_str("JSON")
    }

    fn visit_unit<E>(self) -> Result<Json, E> {
        Ok(Json::Null)
    }

    fn visit_bool<E>(self, truth: bool) -> Result<Json, E> {
        Ok(Json::Bool(truth))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Json, E> {
        Ok(number.into())
    }

    fn visit_u64<E>(self, number: u64) -> Result<Json, E> {
        Ok(number.into())
    }

    fn visit_f64<E>(self, number: f64) -> Result<Json, E> {
        Ok(number.into())
    }

    fn visit_str<E>(self, text: &str) -> Result<Json, E> {
        Ok(text.into())
    }

    fn visit_string<E>(self, text: String) -> Result<Json, E> {
        Ok(text.into())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<Json, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = elements.next_element_seed(self)? {
            if !work::push(&mut items, item) {
                return Err(A::Error::custom(ENDED));
            }
        }
        Ok(Json::Array(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut members: A) -> Result<Json, A::Error> {
        let mut object = Map::new();
        while let Some(name) = members.next_key::<String>()? {
            if object.contains_key(&name) {
                return Err(A::Error::custom(format!("`{name}` stands twice in one object")));
            }
            let value = members.next_value_seed(self)?;
            if !can_grow(object.len()) || !work::goes_on(1) {
                return Err(A::Error::custom(ENDED));
            }
            object.insert(name, value);
        }
        Ok(Json::Object(object))
    }
}

#[cfg(test)]
mod tests {
    use super::read_json;

    #[test]
    fn any_text_gives_what_the_library_makes_of_it() {
        for text in [
            "null",
            "true",
            "-0",
            "1e400",
            "12345678901234567890",
            "0.1",
            "\"\\u00e9\"",
            "[]",
            "{}",
            " [1, [2.5, -3], {\"b\": null, \"a\": [{}]}] ",
            "[1,]",
            "",
            "[] []",
            "{\"a\" 1}",
            "[\n1,\n x]",
        ] {
            let expected = serde_json::from_str(text).map_err(|err| err.to_string());
            assert_eq!(read_json(text), expected, "{text}");
        }
    }

    #[test]
    fn a_name_that_stands_twice_is_told_with_its_line() {
        let found = read_json("{\"a\": 1,\n\"a\": 2}").expect_err("it stands twice");
        assert!(found.starts_with("`a` stands twice in one object at line 2"), "{found}");
    }
}
