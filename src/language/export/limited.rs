//! Files that keep to a ceiling of bytes, and to that of the work on them.

use std::io::{self, Write};

use super::{ExportError, Summary};
use crate::limits::work;

/// Bytes that count as one step.
const BYTES_A_STEP: u64 = 4096;

/// Writes no more than `most` bytes into `out`; tells `progress` how many there are.
pub fn capped(
    out: &mut dyn Write,
    most: u64,
    progress: &dyn Fn(u64),
    write: impl FnOnce(&mut dyn Write) -> Result<Summary, ExportError>,
) -> Result<Summary, ExportError> {
    let mut out = LimitedWriter { out, most, n_left: most, is_full: false, progress };
    let written = write(&mut out);
    if out.is_full { Err(ExportError::TooLarge { most }) } else { written }
}

/// Takes so many bytes and no more.
struct LimitedWriter<'a> {
    out: &'a mut dyn Write,
    most: u64,
    n_left: u64,
    is_full: bool,
    progress: &'a dyn Fn(u64),
}

impl Write for LimitedWriter<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.n_left < bytes.len() as u64 {
            self.is_full = true;
            return Err(io::ErrorKind::FileTooLarge.into());
        }
        let n_taken = self.out.write(bytes)?;
        let n_steps = |n_left: u64| (self.most - n_left) / BYTES_A_STEP;
        let n_before = n_steps(self.n_left);
        let n_left = self.n_left - n_taken as u64;
        if !work::goes_on(n_steps(n_left) - n_before) {
            return Err(io::ErrorKind::TimedOut.into());
        }
        self.n_left = n_left;
        (self.progress)(self.most - self.n_left);
        Ok(n_taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
