//! Entries from a pipe or a file, without a terminal.

use std::io::{self, BufRead, Read};

use super::{
    super::{exit_status::ExitStatus, standard_streams::is_closed},
    prompt::Prompt,
};
use crate::syntax::is_complete;

impl Prompt {
    /// Entries from standard input, each as many lines as it takes.
    pub(super) fn listen(&mut self) -> ExitStatus {
        let most = self.limits().source_bytes;
        let mut input = io::stdin().lock();
        let (mut text, mut is_skipping) = (String::new(), false);
        while !self.is_over && !is_closed() {
            let mut line = Vec::new();
            let read = (&mut input).take(most as u64 + 1).read_until(b'\n', &mut line);
            let is_end = !matches!(read, Ok(n) if n > 0);
            let is_cut = line.len() > most;
            if is_cut || is_skipping {
                // The rest of a line beyond the ceiling is no entry of its own.
                if !is_skipping {
                    self.refuse(&format!("a line of more than {most} bytes is left out"));
                }
                is_skipping = is_cut && line.last() != Some(&b'\n');
                text.clear();
            } else {
                match std::str::from_utf8(&line) {
                    Ok(line) => text.push_str(line),
                    Err(err) => {
                        let at = err.valid_up_to() + 1;
                        self.refuse(&format!("byte {at} of the line is not UTF-8 text"));
                        text.clear();
                    }
                }
                let is_command = text.trim_start().starts_with(':');
                if is_end || is_command || is_complete(&text, self.limits()) {
                    self.take(&std::mem::take(&mut text));
                }
            }
            if is_end {
                break;
            }
        }
        self.worst
    }
}
