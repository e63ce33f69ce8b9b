//! The form of messages: JSON, and attachments behind it.

use std::sync::Arc;

use serde_json::{Value as Json, json};

/// Attachments begin at multiples of this, so that numbers in them can be read where they are.
const ALIGNMENT: usize = 8;

/// A message that came in.
pub(super) struct Message<'m> {
    pub(super) head: Json,
    pub(super) parts: Vec<&'m [u8]>,
}

impl<'m> Message<'m> {
    /// Reads a message.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn read(message: &'m [u8]) -> Result<Self, String> {
        let bad = || "the message has another length than it says".to_owned();
        let (length, rest) = message.split_first_chunk::<4>().ok_or_else(bad)?;
        let head = rest.get(..u32::from_le_bytes(*length) as usize).ok_or_else(bad)?;
        let mut at = 4 + head.len();
        let head: Json = serde_json::from_slice(head).map_err(|_| "the message is no JSON")?;
        let mut parts = Vec::new();
        for length in head["parts"].as_array().into_iter().flatten() {
            let length = length.as_u64().and_then(|length| usize::try_from(length).ok());
            let start = at.next_multiple_of(ALIGNMENT);
            let end = length.and_then(|length| start.checked_add(length)).ok_or_else(bad)?;
            parts.push(message.get(start..end).ok_or_else(bad)?);
            at = end;
        }
        Ok(Self { head, parts })
    }
}

/// A message as bytes; `head` is told the lengths of the attachments.
pub(super) fn written(head: &mut Json, parts: &[Arc<Vec<u8>>]) -> Vec<u8> {
    if !parts.is_empty() {
        head["parts"] = parts.iter().map(|part| json!(part.len())).collect();
    }
    let head = head.to_string();
    let mut bytes = (head.len() as u32).to_le_bytes().to_vec();
    bytes.extend_from_slice(head.as_bytes());
    for part in parts {
        bytes.resize(bytes.len().next_multiple_of(ALIGNMENT), 0);
        bytes.extend_from_slice(part);
    }
    bytes
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use serde_json::json;

    use super::{Message, written};

    #[test]
    fn messages_go_there_and_back() {
        let parts = [b"".to_vec(), b"abc".to_vec(), vec![7; 30]].map(Arc::new);
        let bytes = written(&mut json!({ "call": "größe" }), &parts);
        let message = Message::read(&bytes).expect("it is whole");
        assert_eq!(message.head["call"], "größe");
        assert!(message.parts.iter().zip(&parts).all(|(read, part)| *read == &part[..]));
        assert_eq!(message.parts.len(), 3);
    }

    #[test]
    fn a_message_that_is_cut_short_is_refused() {
        let bytes = written(&mut json!({}), &[Arc::new(vec![1; 9])]);
        for length in 0..bytes.len() {
            assert!(Message::read(&bytes[..length]).is_err(), "{length}");
        }
        assert!(Message::read(b"\xff\xff\xff\xff{}").is_err());
        let odd = br#"{"parts":[18446744073709551615]}"#;
        let odd = [&(odd.len() as u32).to_le_bytes()[..], odd].concat();
        assert!(Message::read(&odd).is_err());
    }
}
