//! Viewers of scripts, which run beside the server.

use std::{
    io::{BufRead, BufReader},
    path::PathBuf,
    process::{Child, Command, Stdio},
};

/// A viewer that was started; it ends with the server.
#[derive(Debug)]
pub(super) struct StartedViewer {
    child: Child,
    pub(super) path: PathBuf,
    pub(super) address: String,
}

impl Drop for StartedViewer {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl StartedViewer {
    pub(super) fn start(path: PathBuf) -> Result<Self, String> {
        let program = std::env::current_exe().map_err(|err| err.to_string())?;
        let mut command = Command::new(program);
        command.arg("view").arg("--no-open").arg(&path);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut child =
            command.spawn().map_err(|err| format!("the viewer does not start: {err}"))?;
        let mut address = String::new();
        if let Some(output) = child.stdout.take() {
            let _ = BufReader::new(output).read_line(&mut address);
        }
        let started = Self { child, path, address: address.trim().to_owned() };
        if started.address.is_empty() {
            return Err(
                "the viewer does not start; `virote view` in a terminal tells why".to_owned()
            );
        }
        Ok(started)
    }
}
