//! Messages over two streams. What cannot be read is mended or passed over, and never ends the server.

use std::{
    io::{self, BufRead, Write},
    thread::{self, JoinHandle},
};

use crossbeam_channel::{Sender, bounded, unbounded};
use lsp_server::{Connection, Message, RequestId, Response};

/// The longest message that is read.
const MOST_BYTES: usize = 1 << 28;

/// What is told to a client.
pub(super) enum Outgoing {
    Message(Message),
    /// The result of a request as JSON. Of a large document it may be large, and as a tree of values thirty times as large.
    Answer(RequestId, String),
}

impl Outgoing {
    /// The same as the crate of the protocol has it.
    pub(super) fn message(self) -> Message {
        match self {
            Self::Message(message) => message,
            Self::Answer(id, result) => {
                let result: serde_json::Value = serde_json::from_str(&result).unwrap_or_default();
                Response::new_ok(id, result).into()
            }
        }
    }

    fn write(self, output: &mut impl Write) -> io::Result<()> {
        match self {
            Self::Message(message) => message.write(output),
            Self::Answer(id, result) => {
                let id = serde_json::to_string(&id)?;
                let head = format!("{{\"jsonrpc\":\"2.0\",\"id\":{id},\"result\":");
                let length = head.len() + result.len() + 1;
                write!(output, "Content-Length: {length}\r\n\r\n{head}{result}}}")?;
                output.flush()
            }
        }
    }
}

/// A connection over two streams for the greeting, where to put what is told behind that, and the thread that writes to the
/// second stream; it ends when both are dropped.
pub(super) fn connect(
    mut input: impl BufRead + Send + 'static,
    mut output: impl Write + Send + 'static,
) -> (Connection, Sender<Outgoing>, JoinHandle<io::Result<()>>) {
    let (sender, greeting) = unbounded::<Message>();
    let (told, outgoing) = unbounded::<Outgoing>();
    let (incoming, receiver) = bounded(0);
    let writer = thread::spawn(move || {
        greeting.into_iter().try_for_each(|message| message.write(&mut output))?;
        outgoing.into_iter().try_for_each(|told| told.write(&mut output))
    });
    // It waits for input until the process ends.
    thread::spawn(move || {
        while let Ok(Some(bytes)) = read(&mut input) {
            let Some(message) = message(&bytes) else { continue };
            let is_exit = matches!(&message, Message::Notification(told) if told.method == "exit");
            if incoming.send(message).is_err() || is_exit {
                return;
            }
        }
    });
    (Connection { sender, receiver }, told, writer)
}

/// The body of the next message; none at the end.
fn read(input: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        if input.read_until(b'\n', &mut line)? == 0 {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line);
        let line = line.trim_end();
        if line.is_empty() {
            match length.take() {
                Some(length) if length <= MOST_BYTES => {
                    let mut bytes = vec![0; length];
                    input.read_exact(&mut bytes)?;
                    return Ok(Some(bytes));
                }
                // Nobody holds that much: it is let through without a look.
                Some(length) => {
                    io::copy(&mut io::Read::take(&mut *input, length as u64), &mut io::sink())?;
                }
                None => {}
            }
        } else if let Some((name, value)) = line.split_once(':')
            && name.eq_ignore_ascii_case("content-length")
        {
            length = value.trim().parse().ok();
        }
    }
}

/// The message of a body. Halves of surrogate pairs and bytes that are no UTF-8 become the sign of
/// replacement.
fn message(bytes: &[u8]) -> Option<Message> {
    serde_json::from_slice(bytes)
        .or_else(|_| serde_json::from_str(&mended(&String::from_utf8_lossy(bytes))))
        .ok()
}

/// A text of JSON without escapes of lone halves of surrogate pairs.
fn mended(json: &str) -> String {
    let unit = |at: usize| -> Option<u16> {
        let digits = json.get(at..at + 6)?.strip_prefix("\\u")?;
        u16::from_str_radix(digits, 16).ok()
    };
    let (mut out, mut at) = (String::with_capacity(json.len()), 0);
    while let Some(character) = json[at..].chars().next() {
        let (length, is_lone) = match unit(at) {
            _ if character != '\\' => (character.len_utf8(), false),
            Some(0xd800..0xdc00) if matches!(unit(at + 6), Some(0xdc00..0xe000)) => (12, false),
            Some(0xd800..0xe000) => (6, true),
            Some(_) => (6, false),
            // Another escape, of which the second sign may be a backslash.
            None => (1 + json[at + 1..].chars().next().map_or(0, char::len_utf8), false),
        };
        out.push_str(if is_lone { "\u{fffd}" } else { &json[at..at + length] });
        at += length;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{Outgoing, mended, read};

    #[test]
    fn lone_halves_are_replaced_and_pairs_are_kept() {
        assert_eq!(mended(r#""\ud83e""#), "\"\u{fffd}\"");
        assert_eq!(mended(r#""\ud83e\uddd0 \udc00x""#), "\"\\ud83e\\uddd0 \u{fffd}x\"");
        assert_eq!(mended(r#""\\ud83e \n ü""#), r#""\\ud83e \n ü""#);
    }

    #[test]
    fn an_answer_is_the_message_of_its_result() {
        let told = || Outgoing::Answer("ü".to_owned().into(), r#"[{"a":1.5}]"#.to_owned());
        let [mut own, mut theirs] = [Vec::new(), Vec::new()];
        told().write(&mut own).unwrap();
        told().message().write(&mut theirs).unwrap();
        assert_eq!(String::from_utf8(own).unwrap(), String::from_utf8(theirs).unwrap());
    }

    #[test]
    fn bodies_are_found_by_their_length() {
        let mut input =
            &b"Content-Length: 2\r\nContent-Type: x\r\n\r\n{}junk\r\n\r\ncontent-length: 1\n\n7"[..];
        assert_eq!(read(&mut input).unwrap().unwrap(), b"{}");
        assert_eq!(read(&mut input).unwrap().unwrap(), b"7");
        assert!(read(&mut input).unwrap().is_none());
    }
}
