//! Runs a script from memory: asks for its values, and writes its exports into memory.
//!
//! `cargo run --example run_a_script`

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "an example says what it found")]

use std::error::Error;

use virote::{
    diag::Severity,
    session::{Event, Session},
    value::{MemoryFiles, Value},
};

const SCRIPT: &str = "
    import \"profile.geo\"
    surface bowl = revolve(profile.side)
    print area(bowl)
    check area(bowl) > 0
    export bowl to \"bowl.obj\" with (tolerance = 0.05)
";

fn main() -> Result<(), Box<dyn Error>> {
    let profile = "curve side = bezier((1, 0, 0), (3, 0, 1), (3, 0, 4))";
    let files = MemoryFiles::from([("profile.geo", profile)]);
    let report = Session::default().run("bowl.geo", SCRIPT.as_bytes(), &files, &[]);
    for found in &report.diagnostics {
        eprintln!("{}: {}", found.code.id(), found.message);
    }
    if report.count(Severity::Error) > 0 {
        return Err("the script has errors".into());
    }
    if let Some(Value::Surface(bowl)) = report.value("bowl") {
        println!("the middle of the bowl lies at {}", bowl.point_at(0.5, 0.5)?);
    }
    for event in &report.events {
        match event {
            Event::Printed(line) => println!("{} = {}", line.source, line.value),
            Event::Checked(claim) => println!("{}: {}", claim.source, claim.verdict.holds),
            Event::File(file) => {
                let mut bytes = Vec::new();
                let summary = file.write(&mut bytes).map_err(|found| found.message)?;
                println!("{}: {summary}, {} bytes", file.path, bytes.len());
            }
            Event::Expected(_) => {}
        }
    }
    Ok(())
}
