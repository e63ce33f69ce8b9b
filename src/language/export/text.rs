//! Numbers as text, fast and the same everywhere.

/// Digits after the point beyond which a number is written as it is.
const MOST_DECIMALS: usize = 17;

/// Text under construction; numbers in the shortest form that reads back, or rounded.
#[derive(Default)]
pub(super) struct TextBuffer {
    bytes: Vec<u8>,
    /// Digits after the point; without a count as many as a number has.
    decimals: Option<usize>,
}

impl TextBuffer {
    /// Text whose numbers have at most so many digits after the point.
    pub(super) fn rounded(decimals: Option<usize>) -> Self {
        Self { bytes: Vec::new(), decimals }
    }

    /// Adds text.
    pub(super) fn push(&mut self, text: &str) -> &mut Self {
        self.bytes.extend_from_slice(text.as_bytes());
        self
    }

    /// Adds a number.
    pub(super) fn number(&mut self, value: f64) -> &mut Self {
        match self.decimals {
            Some(decimals) => self.fixed(value, decimals),
            None => self.exact(value),
        }
    }

    /// Adds a number in the shortest form that reads back.
    pub(super) fn exact(&mut self, value: f64) -> &mut Self {
        let mut buffer = ryu::Buffer::new();
        // Zero has no sign.
        let text = buffer.format(value + 0.0);
        let text = text.strip_suffix(".0").unwrap_or(text);
        self.push(if text == "-0" { "0" } else { text })
    }

    /// Adds a number rounded to so many digits after the point, without zeros at the end.
    fn fixed(&mut self, value: f64, decimals: usize) -> &mut Self {
        /// Whole numbers up to here are exact.
        const MOST: f64 = (1_u64 << 53) as f64;
        // Powers of ten that an f64 holds exactly, and more digits than it has.
        let scale = 10_u64.pow(decimals.min(MOST_DECIMALS) as u32) as f64;
        let scaled = (value * scale).round();
        if MOST <= scaled.abs() || !scaled.is_finite() {
            return self.exact(value);
        }
        let (mut digits, mut n_decimals) = (scaled.abs() as u64, decimals.min(MOST_DECIMALS));
        while 0 < n_decimals && digits.is_multiple_of(10) {
            digits /= 10;
            n_decimals -= 1;
        }
        if digits == 0 {
            return self.push("0");
        }
        if scaled < 0.0 {
            self.push("-");
        }
        let power = 10_u64.pow(n_decimals as u32);
        self.count((digits / power) as usize);
        if 0 < n_decimals {
            self.push(".");
            let fraction = digits % power;
            let mut place = power / 10;
            while 0 < place {
                self.bytes.push(b'0' + (fraction / place % 10) as u8);
                place /= 10;
            }
        }
        self
    }

    /// Adds a number with a decimal point in the shortest form that reads back, its power of ten
    /// behind `exponent`: `3.`, `1.5E-7`.
    pub(super) fn pointed(&mut self, value: f64, exponent: &str) -> &mut Self {
        let mut buffer = ryu::Buffer::new();
        // Zero has no sign.
        let text = buffer.format(value + 0.0);
        let (digits, power) = text.split_once('e').unwrap_or((text, ""));
        let digits = digits.strip_suffix(".0").unwrap_or(digits);
        self.push(digits).push(if digits.contains('.') { "" } else { "." });
        if power.is_empty() { self } else { self.push(exponent).push(power) }
    }

    /// Ends a line, without the space at its end.
    pub(super) fn end_line(&mut self) -> &mut Self {
        if self.bytes.last() == Some(&b' ') {
            self.bytes.pop();
        }
        self.push("\n")
    }

    /// All that has gathered.
    pub(super) fn into_string(self) -> String {
        String::from_utf8(self.bytes).unwrap_or_default()
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

    /// Whether nothing has gathered.
    pub(super) fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    /// Adds what has gathered elsewhere.
    pub(super) fn append(&mut self, other: &Self) -> &mut Self {
        self.bytes.extend_from_slice(&other.bytes);
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

#[cfg(test)]
mod tests {
    use super::TextBuffer;

    #[track_caller]
    fn check(value: f64, decimals: Option<usize>, expected: &str) {
        let mut text = TextBuffer::rounded(decimals);
        text.number(value);
        assert_eq!(String::from_utf8_lossy(&text.bytes), expected);
    }

    #[test]
    fn numbers_are_as_short_as_they_read_back() {
        check(0.1, None, "0.1");
        check(-0.0, None, "0");
        check(3.0, None, "3");
        check(1.0 / 3.0, None, "0.3333333333333333");
    }

    #[test]
    fn rounded_numbers_have_no_needless_zeros() {
        check(1.0 / 3.0, Some(3), "0.333");
        check(-2.0 / 3.0, Some(3), "-0.667");
        check(1.25, Some(0), "1");
        check(-0.0004, Some(3), "0");
        check(10.0, Some(3), "10");
        check(100.05, Some(3), "100.05");
        check(1e300, Some(3), "1e300");
    }
}
