//! Sums by which a journal knows its script, its plan and its files again.

/// A hash of what comes in, by which a change is noticed. Fowler, Noll and Vo, *FNV-1a* of 128 bits (RFC
/// 9923).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Checksum(u128);

impl Default for Checksum {
    fn default() -> Self {
        Self(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d)
    }
}

impl Checksum {
    pub(super) fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u128::from(byte)).wrapping_mul(0x0100_0000_0000_0000_0000_013b);
        }
    }

    /// Adds a text with its length, so that no two rows of texts are one.
    pub(super) fn add_text(&mut self, text: &str) {
        self.add(format!("{}:", text.len()).as_bytes());
        self.add(text.as_bytes());
    }

    pub(super) fn text(self) -> String {
        format!("{:032x}", self.0)
    }
}

/// The sum of some bytes as text.
#[must_use]
pub fn checksum(bytes: &[u8]) -> String {
    let mut sum = Checksum::default();
    sum.add(bytes);
    sum.text()
}

#[cfg(test)]
mod tests {
    use super::checksum;

    #[test]
    fn the_sum_is_that_of_the_source() {
        // Test vectors of RFC 9923, C.4.
        assert_eq!(checksum(b""), "6c62272e07bb014262b821756295c58d");
        assert_eq!(checksum(b"a"), "d228cb696f1a8caf78912b704e4a8964");
        assert_eq!(checksum(b"foobar"), "343e1662793c64bf6f0d3597ba446f18");
    }
}
