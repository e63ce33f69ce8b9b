//! Bytes as text. RFC 4648, §4.

use std::io::{self, Write};

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Encodes what is written to it; [`Base64::finish`] writes the end.
pub(super) struct Base64<'a> {
    out: &'a mut dyn Write,
    /// Up to two bytes that wait for a third.
    rest: Vec<u8>,
    text: Vec<u8>,
}

impl<'a> Base64<'a> {
    pub(super) fn new(out: &'a mut dyn Write) -> Self {
        Self { out, rest: Vec::new(), text: Vec::new() }
    }

    /// Encodes the last bytes.
    pub(super) fn finish(mut self) -> io::Result<()> {
        let n_rest = self.rest.len();
        if n_rest != 0 {
            self.rest.resize(3, 0);
            let mut digits = digits([self.rest[0], self.rest[1], self.rest[2]]);
            digits[n_rest + 1..].fill(b'=');
            self.text.extend_from_slice(&digits);
        }
        self.out.write_all(&self.text)
    }
}

/// Bytes as text.
pub fn base64(bytes: &[u8]) -> String {
    let mut text = Vec::with_capacity(bytes.len().div_ceil(3) * 4);
    let mut out = Base64::new(&mut text);
    // A vector takes everything.
    let _ = out.write_all(bytes).and_then(|()| out.finish());
    String::from_utf8(text).unwrap_or_default()
}

impl Write for Base64<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        /// Bytes that make a write worth while.
        const LARGE: usize = 1 << 16;
        for &byte in bytes {
            self.rest.push(byte);
            if let [a, b, c] = self.rest[..] {
                self.text.extend_from_slice(&digits([a, b, c]));
                self.rest.clear();
            }
        }
        if LARGE <= self.text.len() {
            self.out.write_all(&self.text)?;
            self.text.clear();
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

fn digits([a, b, c]: [u8; 3]) -> [u8; 4] {
    let bits = u32::from(a) << 16 | u32::from(b) << 8 | u32::from(c);
    [18, 12, 6, 0].map(|shift| DIGITS[(bits >> shift & 63) as usize])
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::Base64;

    /// The test vectors of RFC 4648, §10.
    #[test]
    fn the_vectors_of_the_standard_come_out() {
        let pairs = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ];
        for (plain, expected) in pairs {
            let mut out = Vec::new();
            let mut encoder = Base64::new(&mut out);
            encoder.write_all(plain.as_bytes()).expect("memory");
            encoder.finish().expect("memory");
            assert_eq!(String::from_utf8_lossy(&out), expected);
        }
    }
}
