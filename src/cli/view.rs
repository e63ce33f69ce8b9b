//! `virote view`: shows a script in the browser.

use std::{
    io::{self, Write},
    net::Ipv4Addr,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    thread,
    time::Duration,
};

use clap::Args;

use super::{
    exit_status::ExitStatus,
    interrupt::{self, INTERRUPTED},
    reporter::Reporter,
    run_args::RunArgs,
    settings,
    standard_streams::say,
};
use crate::{
    disk::{OutputTarget, Script, TargetRefusal, replace},
    export::io_reason,
    limits::work::StopToken,
    view::{OutsideAddress, SinglePage, ViewedScript, Viewer},
};

/// How often it is asked whether Ctrl-C was pressed.
const TICK: Duration = Duration::from_millis(50);

/// What `virote view` is asked for.
#[derive(Debug, Args)]
pub(super) struct ViewOptions {
    /// The script
    file: PathBuf,
    /// The port of the page; 0 takes a free one
    #[arg(long, value_name = "N", default_value_t = 0)]
    port: u16,
    /// Where the browser finds the page, if a proxy or a forwarded port stands between
    #[arg(long, value_name = "URL")]
    origin: Option<OutsideAddress>,
    /// Opens no browser
    #[arg(long)]
    no_open: bool,
    /// Writes a page that shows the model anywhere, without evaluation, and serves nothing
    #[arg(long, value_name = "PAGE.html", conflicts_with_all = ["port", "origin", "out"])]
    export: Option<PathBuf>,
    /// The folder for exported files [default: the script's own]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    common: RunArgs,
}

/// `virote view FILE`: until Ctrl-C.
pub(super) fn run(asked: &ViewOptions) -> ExitStatus {
    let limits = asked.common.ceilings();
    let voice = Reporter::new(&asked.common.talk, limits.diagnostics);
    let settings = match settings::given(&asked.common, limits.input_bytes, &voice) {
        Ok(settings) => settings,
        Err(ending) => return ending,
    };
    if asked.file.as_os_str() == "-" {
        voice.trouble("standard input cannot be watched");
        return ExitStatus::Usage;
    }
    // A name that was mistyped is not waited for.
    let folder = match Script::read(&asked.file, limits.source_bytes) {
        Ok(script) => script.folder,
        Err(message) => {
            voice.trouble(&message);
            return ExitStatus::Usage;
        }
    };
    let session = |stop: StopToken| asked.common.session().stopped_by(stop);
    let script = ViewedScript {
        path: asked.file.clone(),
        out: asked.out.clone().unwrap_or(folder),
        settings,
        session: &session,
    };
    if let Some(page) = &asked.export {
        if let Some(why) = no_page(page) {
            voice.trouble(&format!("cannot write `{}`: {why}", page.display()));
            return ExitStatus::Usage;
        }
        return export(&script, page, &voice);
    }
    interrupt::listen_once();
    let viewer = match Viewer::start(&script, asked.port, asked.origin.as_ref()) {
        Ok(viewer) => viewer,
        Err(err) => {
            voice.trouble(&unserved(asked.port, &err));
            return ExitStatus::Usage;
        }
    };
    say(&format!("{}\n", viewer.address()));
    if !asked.no_open {
        open(viewer.address());
    }
    while !INTERRUPTED.is_stopped() {
        thread::sleep(TICK);
    }
    ExitStatus::Well
}

/// Why a page cannot be written there, whatever is in it.
fn no_page(path: &Path) -> Option<&'static str> {
    if path.is_dir() {
        return Some("it is a folder; name the page, such as `model.html`");
    }
    let is_dash = path.as_os_str() == "-";
    is_dash.then_some("a page goes into a file, such as `model.html`, not to standard output")
}

/// Writes the page as one file.
fn export(script: &ViewedScript<'_>, path: &Path, voice: &Reporter) -> ExitStatus {
    let page = SinglePage::of(script);
    let Some(report) = &page.report else { return ExitStatus::Usage };
    voice.findings(&report.diagnostics, &report.sources);
    if !report.unknown_settings.is_empty() {
        report.unknown_settings.iter().for_each(|text| voice.trouble(text));
        return ExitStatus::Usage;
    }
    let Some(text) = page.text else {
        voice.remark("no page was written, because the script has errors");
        return ExitStatus::of(report).max(ExitStatus::Wrong);
    };
    let mut inputs = page.inputs;
    inputs.push(script.path.clone());
    match written(path, &text, &inputs) {
        Ok(()) => {
            let size = text.len();
            voice.page(&path.display().to_string(), size);
            ExitStatus::of(report)
        }
        Err(why) => {
            voice.trouble(&format!("cannot write `{}`: {why}", path.display()));
            ExitStatus::Usage
        }
    }
}

/// Puts the page into its place, unless that is the script's or one of its inputs'.
fn written(path: &Path, text: &str, inputs: &[PathBuf]) -> Result<(), String> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let target = OutputTarget::new(folder.unwrap_or(Path::new(".")), &name, inputs);
    target.map_err(|refusal| match refusal {
        TargetRefusal::Forbidden(why) | TargetRefusal::System(why) => why,
    })?;
    let write = |out: &mut dyn Write| out.write_all(text.as_bytes());
    replace(path, None, write).map_err(|err| io_reason(&err))
}

/// Why a port is not served, and what to do.
fn unserved(port: u16, err: &io::Error) -> String {
    if err.kind() != io::ErrorKind::AddrInUse {
        return format!("cannot serve at port {port}: {}", io_reason(err));
    }
    let free = std::net::TcpListener::bind((Ipv4Addr::LOCALHOST, 0));
    let free = free.and_then(|listener| listener.local_addr()).map_or(0, |address| address.port());
    format!("port {port} is in use; `--port {free}` is free, and `--port 0` takes any that is")
}

/// Opens the browser, where there is one.
fn open(address: &str) {
    let (program, before): (&str, &[&str]) = if cfg!(windows) {
        ("cmd", &["/C", "start", ""])
    } else if cfg!(target_os = "macos") {
        ("open", &[])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command.args(before).arg(address);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    if let Ok(mut child) = command.spawn() {
        // Whoever does not wait for it leaves a dead process behind.
        let _ = thread::Builder::new().spawn(move || child.wait());
    }
}
