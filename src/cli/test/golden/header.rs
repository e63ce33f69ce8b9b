//! The header of a golden folder: which edition of its form it has, and how it is compared.

use serde_json::{Value as Json, json};

use crate::{diag::nearest, kernel::tolerance::SAME_RESULT};

/// The edition of the form of golden folders that is written here; older ones are read too.
const EDITION: u64 = 2;
/// The first edition that keeps warnings.
const WITH_WARNINGS: u64 = 2;

/// How the contents of a folder are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Header {
    /// By how much numbers may differ, as a fraction of the larger one or of 1.
    pub(super) tolerance: f64,
    /// Whether files are compared by bytes.
    pub(super) by_bytes: bool,
    /// Whether warnings are kept.
    pub(super) has_warnings: bool,
}

impl Default for Header {
    fn default() -> Self {
        Self { tolerance: SAME_RESULT, by_bytes: false, has_warnings: true }
    }
}

impl Header {
    /// Reads it.
    ///
    /// # Errors
    /// What is wrong with the text.
    pub(super) fn read(bytes: &[u8]) -> Result<Self, String> {
        let json: Json = serde_json::from_slice(bytes).map_err(|err| err.to_string())?;
        let Json::Object(members) = &json else {
            return Err(format!("must be an object such as {}", Self::default().json()));
        };
        let edition = match members.get("edition").map(Json::as_u64) {
            Some(Some(edition @ 1..=EDITION)) => edition,
            Some(_) => {
                let found = &members["edition"];
                return Err(format!(
                    "is of edition {found}; this program reads editions 1 to {EDITION}"
                ));
            }
            None => return Err("has no `edition`".to_owned()),
        };
        let mut header = Self { has_warnings: WITH_WARNINGS <= edition, ..Self::default() };
        for (name, value) in members {
            match name.as_str() {
                "edition" => {}
                "tolerance" => {
                    let number = value.as_f64().filter(|number| (0.0..=1.0).contains(number));
                    header.tolerance = number.ok_or_else(|| {
                        format!("`tolerance` must be a number from 0 to 1, found {value}")
                    })?;
                }
                "bytes" => {
                    header.by_bytes = value
                        .as_bool()
                        .ok_or_else(|| format!("`bytes` must be true or false, found {value}"))?;
                }
                _ => {
                    let near = nearest(name, ["edition", "tolerance", "bytes"]);
                    let near = near.map(|near| format!("; did you mean `{near}`?"));
                    return Err(format!("has no member `{name}`{}", near.unwrap_or_default()));
                }
            }
        }
        Ok(header)
    }

    /// The same in the edition that is written here.
    pub(super) fn newest(self) -> Self {
        Self { has_warnings: true, ..self }
    }

    /// The text of the header, in the edition that is written here.
    pub(super) fn text(self) -> String {
        format!("{:#}\n", self.json())
    }

    fn json(self) -> Json {
        json!({ "edition": EDITION, "tolerance": self.tolerance, "bytes": self.by_bytes })
    }
}

#[cfg(test)]
mod tests {
    use super::Header;

    #[test]
    fn what_is_written_is_read() {
        let header = Header { tolerance: 0.25, by_bytes: true, ..Header::default() };
        assert_eq!(Header::read(header.text().as_bytes()), Ok(header));
        assert_eq!(Header::read(b"{\"edition\": 2}"), Ok(Header::default()));
    }

    #[test]
    fn the_first_edition_has_no_warnings() {
        let old = Header { has_warnings: false, ..Header::default() };
        assert_eq!(Header::read(b"{\"edition\": 1}"), Ok(old));
        assert_eq!(Header::read(old.newest().text().as_bytes()), Ok(Header::default()));
    }

    #[test]
    fn what_is_wrong_is_told() {
        for (text, part) in [
            ("", "EOF"),
            ("\u{0}", "expected value"),
            ("3", "must be an object"),
            ("{}", "has no `edition`"),
            ("{\"edition\": 0}", "is of edition 0"),
            ("{\"edition\": 3}", "is of edition 3; this program reads editions 1 to 2"),
            ("{\"edition\": \"one\"}", "is of edition \"one\""),
            ("{\"edition\": 1, \"tolerance\": -1}", "a number from 0 to 1, found -1"),
            ("{\"edition\": 1, \"tolerance\": \"small\"}", "found \"small\""),
            ("{\"edition\": 1, \"bytes\": 1}", "true or false, found 1"),
            ("{\"edition\": 1, \"tolerence\": 0.1}", "did you mean `tolerance`?"),
        ] {
            let found = Header::read(text.as_bytes());
            assert!(matches!(&found, Err(message) if message.contains(part)), "{text}: {found:?}");
        }
    }
}
