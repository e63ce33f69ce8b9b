//! Numbers as text, fast and the same everywhere.

/// Text under construction; numbers in the shortest form that reads back.
#[derive(Default)]
pub(super) struct Text {
    bytes: Vec<u8>,
}

impl Text {
    /// Adds text.
    pub(super) fn push(&mut self, text: &str) -> &mut Self {
        self.bytes.extend_from_slice(text.as_bytes());
        self
    }

    /// Adds a number.
    pub(super) fn number(&mut self, value: f64) -> &mut Self {
        let mut buffer = ryu::Buffer::new();
        // Zero has no sign.
        let text = buffer.format(value + 0.0);
        let text = text.strip_suffix(".0").unwrap_or(text);
        self.push(if text == "-0" { "0" } else { text })
    }

    /// Adds a whole number.
    pub(super) fn count(&mut self, mut n: usize) -> &mut Self {
        let mut digits = [0u8; 20];
        let mut start = digits.len();
        loop {
            start -= 1;
            digits[start] = b'0' + (n % 10) as u8;
            n /= 10;
            if n == 0 {
                break;
            }
        }
        self.bytes.extend_from_slice(&digits[start..]);
        self
    }

    /// Hands over what has gathered once it is worth a write.
    pub(super) fn flush_if_large(&mut self, out: &mut dyn std::io::Write) -> std::io::Result<()> {
        /// Bytes that make a write worth while.
        const LARGE: usize = 1 << 16;
        if self.bytes.len() < LARGE { Ok(()) } else { self.flush(out) }
    }

    /// Hands over all that has gathered.
    pub(super) fn flush(&mut self, out: &mut dyn std::io::Write) -> std::io::Result<()> {
        out.write_all(&self.bytes)?;
        self.bytes.clear();
        Ok(())
    }
}
