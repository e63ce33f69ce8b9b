//! Bytes of data files as text: UTF-8, or UTF-16 that begins with its byte-order mark.
//!
//! All else is told with its place and what to do about it. What a byte of another encoding would mean
//! is not guessed: the same byte is another letter in each of them.

use std::borrow::Cow;

use crate::limits::work;

/// How files begin that no reader can read as they are, what they are, and what to do.
const STRANGERS: &[(&[u8], &str)] = &[
    (&[0x1f, 0x8b], "the file is packed by gzip; unpack it first, as with `gunzip`"),
    (b"BZh", "the file is packed by bzip2; unpack it first, as with `bunzip2`"),
    (
        &[0xfd, b'7', b'z', b'X', b'Z', 0],
        "the file is packed by xz; unpack it first, as with `unxz`",
    ),
    (&[0x28, 0xb5, 0x2f, 0xfd], "the file is packed by zstd; unpack it first, as with `unzstd`"),
    (&[b'P', b'K', 3, 4], "the file is a zip archive; unpack it first, as with `unzip`"),
    (&[0xff, 0xfe, 0, 0], "the file is text in UTF-32; save it as UTF-8"),
    (&[0, 0, 0xfe, 0xff], "the file is text in UTF-32; save it as UTF-8"),
];

/// The text of a data file, without its byte-order mark.
///
/// # Errors
/// A sentence on what the bytes are instead, and what to do.
pub fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, String> {
    if let Some((_, what)) = STRANGERS.iter().find(|(start, _)| bytes.starts_with(start)) {
        return Err((*what).to_owned());
    }
    let text = match bytes {
        [0xff, 0xfe, units @ ..] => Cow::Owned(utf16(units, u16::from_le_bytes)?),
        [0xfe, 0xff, units @ ..] => Cow::Owned(utf16(units, u16::from_be_bytes)?),
        [0xef, 0xbb, 0xbf, rest @ ..] => Cow::Borrowed(utf8(rest)?),
        _ => Cow::Borrowed(utf8(bytes)?),
    };
    match text.find('\0') {
        None => Ok(text),
        Some(at) => Err(format!(
            "{}: a byte of zero, which no text holds; save a file of UTF-16 as UTF-8, or with its byte-order mark",
            place(text[..at].chars())
        )),
    }
}

/// What a file is that is no UTF-8, if its first bytes tell, and what to do.
#[must_use]
pub fn stranger(bytes: &[u8]) -> Option<&'static str> {
    let utf16 = [
        (&[0xff, 0xfe][..], "the file is text in UTF-16; save it as UTF-8"),
        (&[0xfe, 0xff], "the file is text in UTF-16; save it as UTF-8"),
    ];
    let known = STRANGERS.iter().chain(&utf16);
    known.copied().find(|(start, _)| bytes.starts_with(start)).map(|(_, what)| what)
}

/// The text of a script, whose places are bytes of UTF-8.
///
/// # Errors
/// A sentence on what the bytes are instead, and what to do.
pub fn script_text(bytes: &[u8]) -> Result<&str, String> {
    std::str::from_utf8(bytes).or_else(|_| match stranger(bytes) {
        Some(what) => Err(what.to_owned()),
        None => utf8(bytes),
    })
}

fn utf8(bytes: &[u8]) -> Result<&str, String> {
    std::str::from_utf8(bytes).map_err(|err| {
        let (before, rest) = bytes.split_at(err.valid_up_to());
        let (before, byte) = (String::from_utf8_lossy(before), rest[0]);
        let latin = if 0xa0 <= byte { char::from(byte).to_string() } else { String::new() };
        let latin = if latin.is_empty() { latin } else { format!(" (`{latin}` in Latin-1)") };
        format!(
            "{}: the byte {byte:#04x}{latin} is not UTF-8; save the file as UTF-8",
            place(before.chars())
        )
    })
}

/// Text of two bytes a unit.
fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, String> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let mut text = String::new();
    // Two bytes become three at most.
    if !work::has_room(bytes.len() / 2 * 3) {
        return Err("there is no room for its text".to_owned());
    }
    for unit in char::decode_utf16(pairs.iter().map(|&pair| unit(pair))) {
        match unit {
            Ok(c) => text.push(c),
            Err(half) => {
                return Err(format!(
                    "{}: {:#06x} is half of a character of UTF-16; save the file as UTF-8",
                    place(text.chars()),
                    half.unpaired_surrogate()
                ));
            }
        }
    }
    if rest.is_empty() {
        Ok(text)
    } else {
        let place = place(text.chars());
        Err(format!("{place}: the file ends within a character of UTF-16: is all of it there?"))
    }
}

/// The line and the column after a text. A line ends with `\n`, `\r\n` or `\r`.
fn place(before: impl Iterator<Item = char>) -> String {
    let (mut line, mut column, mut last) = (1_usize, 1_usize, ' ');
    for c in before {
        match c {
            '\n' if last == '\r' => {}
            '\n' | '\r' => (line, column) = (line + 1, 1),
            _ => column += 1,
        }
        last = c;
    }
    format!("line {line}, column {column}")
}

#[cfg(test)]
mod tests {
    use super::decode;

    #[track_caller]
    fn check(bytes: &[u8], expected: Result<&str, &str>) {
        match (decode(bytes), expected) {
            (Ok(text), Ok(expected)) => assert_eq!(text, expected),
            (Err(message), Err(part)) => assert!(message.contains(part), "{message}"),
            (found, _) => panic!("{bytes:?} gives {found:?}"),
        }
    }

    fn units(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
        format!("\u{feff}{text}").encode_utf16().flat_map(bytes).collect()
    }

    #[test]
    fn text_is_read_in_either_order_of_its_bytes() {
        let text = "x;é\n🦆\r\n";
        check(text.as_bytes(), Ok(text));
        check(format!("\u{feff}{text}").as_bytes(), Ok(text));
        check(&units(text, u16::to_le_bytes), Ok(text));
        check(&units(text, u16::to_be_bytes), Ok(text));
        check(b"", Ok(""));
        check(&[0xff, 0xfe], Ok(""));
    }

    #[test]
    fn what_is_no_text_is_told_with_its_place_and_what_to_do() {
        check(
            b"a\r\nb\xe9\n",
            Err("line 2, column 2: the byte 0xe9 (`é` in Latin-1) is not UTF-8"),
        );
        check(b"a\rb\n\x80", Err("line 3, column 1: the byte 0x80 is not UTF-8; save the file"));
        check(b"\xa0", Err("the byte 0xa0 (`\u{a0}` in Latin-1) is not UTF-8"));
        check(b"\x9f", Err("the byte 0x9f is not UTF-8"));
        check(&[0xff, 0xfe, 0x61, 0, 0x00, 0xd8, 0x62, 0], Err("line 1, column 2: 0xd800 is half"));
        check(&[0xfe, 0xff, 0, 0x61, 0], Err("line 1, column 2: the file ends within"));
        check(b"a\0b\0", Err("line 1, column 2: a byte of zero"));
        check(&[0xff, 0xfe, 0, 0, 0x61, 0, 0, 0], Err("UTF-32"));
        check(&[0x1f, 0x8b, 8, 0], Err("packed by gzip; unpack it first"));
        check(b"PK\x03\x04", Err("unpack it first"));
    }
}
