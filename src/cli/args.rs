//! The arguments of the command, as clap reads them.

use std::path::PathBuf;

use clap::{Parser, Subcommand};

use super::{
    looks::PictureArgs,
    lsp,
    run_args::{OutputArgs, RunArgs},
    study, test, view, watch,
};

/// Exact freeform curves and surfaces from a declarative language.
#[derive(Debug, Parser)]
#[command(name = "virote", version, about, after_help = EXAMPLES, max_term_width = 100)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub(super) verb: CliCommand,
}

const EXAMPLES: &str = "\
Examples:
  virote run bottle.geo                        evaluate, check, print, export
  virote run bottle.geo --set neck=15mm        the same with another parameter
  virote run bottle.geo --out build --dry-run  tell what would be written to build/
  virote check *.geo                           everything but the files
  virote test                                  the tests and checks of all scripts below
  virote view bottle.geo                       see it in the browser while it is written
  virote watch bottle.geo                      evaluate it whenever it is saved
  virote repl bottle.geo                       questions about it
  virote lsp                                   help while writing, for editors
  virote render bottle.geo -o bottle.png       a picture of it
  virote study bottle.geo plan.csv -o r.csv    a row of results for each row of values
  virote params bottle.geo                     its parameters
  virote graph bottle.geo                      what depends on what, for Graphviz
  virote fmt bottle.geo                        rewrite it in canonical form
  virote doc bezier                            how a built-in is used
  virote explain E0602                         what a message means
  echo 'print 1 + 1' | virote run -            a script from standard input

Exit codes: 0 all well; 1 a check or test failed; 2 an error in the script; 3 usage, files; 130 Ctrl-C.";

#[derive(Debug, Subcommand)]
pub(super) enum CliCommand {
    /// Evaluates a script, then does its checks, prints and exports
    #[command(after_help = "\
Examples:
  virote run bottle.geo --set neck=15mm --out build
  virote run bottle.geo --params small.json    {\"neck\": \"10mm\", \"height\": 150}
  virote run bottle.geo --only wall            the files of `wall`, and all checks and prints
  virote run bottle.geo --limit steps=1_000_000")]
    Run {
        /// The script; `-` is standard input
        file: PathBuf,
        /// The folder for exported files [default: the script's own]
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Writes only the exports that name this definition, or `all` of a file with it; may be
        /// given several times
        #[arg(long, value_name = "NAME")]
        only: Vec<String>,
        /// Writes no file, but tells what it would write
        #[arg(long)]
        dry_run: bool,
        #[command(flatten)]
        common: RunArgs,
    },
    /// Does everything but writing files
    #[command(after_help = "Example: virote check *.geo --message-format json")]
    Check {
        /// The scripts; `-` is standard input
        #[arg(required = true)]
        files: Vec<PathBuf>,
        #[command(flatten)]
        common: RunArgs,
    },
    /// Runs the tests and checks of scripts
    ///
    /// `test "name" { ... }` in a script holds definitions, checks, prints and expected errors that
    /// nothing but this verb evaluates. A test that fails stops no other. No exported file is written.
    ///
    /// What a script outside of its tests prints and exports, and what it is warned of, is compared
    /// with the folder `NAME.golden/` beside it, if there is one: numbers within the tolerance of
    /// `golden.json` in it, tables column by column, meshes by counts, bounds, area, volume and
    /// deviation.
    #[command(after_help = "\
Examples:
  virote test                               every *.geo here and in the folders below
  virote test bottle.geo parts/
  virote test --filter neck                 the tests whose names contain \"neck\", no checks
  virote test --filter neck --exact         the test that is called \"neck\"
  virote test --bless bottle.geo            writes bottle.golden/, or tells what changed in it
  virote test --junit results.xml           the results for CI
  virote test --message-format json")]
    Test(test::TestOptions),
    /// Answers questions and takes statements, one by one
    ///
    /// Statements join a document, expressions are answered, and commands begin with a colon:
    /// `:help` lists them. Without a terminal, entries come from standard input and only answers are
    /// written.
    #[command(after_help = "\
Examples:
  virote repl                         an empty document
  virote repl bottle.geo              the definitions of a script to begin with
  echo 'length(circle((0, 0), 1))' | virote repl")]
    Repl {
        /// A script to begin with
        file: Option<PathBuf>,
        /// The folder for exported files [default: the script's own]
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        #[command(flatten)]
        common: RunArgs,
    },
    /// Draws the geometry of a script
    ///
    /// The picture shows every definition that is geometry and not hidden, in its colour or in one of
    /// a palette. Files that the script exports are not written.
    #[command(after_help = "\
Examples:
  virote render bottle.geo -o bottle.png
  virote render bottle.geo -o bottle.svg --view front --only profile
  virote render bottle.geo -o bottle.png --size 1600x1200 --set neck=15mm
  virote render bottle.geo -o bottle.png --only profile --show comb --show control
  virote render bottle.geo -o bottle.png --camera 300,-400,250 --perspective
  virote render bottle.geo -o bottle.png --show stripes --stripes 40 --no-edges --no-isocurves")]
    Render {
        /// The script; `-` is standard input
        file: PathBuf,
        /// The picture; its ending chooses the format: `.png` is shaded, `.svg` made of lines
        #[arg(long, short, value_name = "PICTURE")]
        out: PathBuf,
        #[command(flatten)]
        drawn: Box<PictureArgs>,
        #[command(flatten)]
        common: RunArgs,
    },
    /// Evaluates a script with many values of its parameters, and writes a row of results for each
    ///
    /// A row has the parameters, every number, text and truth value that the script gives a name, each
    /// check with its margin, the first error, and the time. A variant that fails is a row like all
    /// others. On all processors, in the order of the plan; a study that was ended goes on where it was
    /// when the same command is given again. Files that the script exports are not written.
    #[command(after_help = "\
Examples:
  virote study bottle.geo plan.csv -o results.parquet
  virote study bottle.geo --vary neck=10mm..20mm:11 --vary body=30mm,35mm -o results.csv
  virote study bottle.geo plan.csv -o results.csv --want glass --time-limit 10s
  virote study bottle.geo plan.csv -o results.csv --render pictures --size 400x300")]
    Study(study::StudyOptions),
    /// Tells the parameters of a script: kind, default, what is allowed, label, documentation
    ///
    /// Only the parameters are evaluated, and what they use. In JSON, numbers are in the
    /// document's unit and angles in degrees; the member `unit` names which.
    #[command(after_help = "\
Examples:
  virote params bottle.geo           a table
  virote params bottle.geo --json    {\"parameters\": [{\"name\": \"neck\", \"kind\": \"length\", ...}]}")]
    Params {
        /// The script; `-` is standard input
        file: PathBuf,
        /// Writes JSON
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        talk: OutputArgs,
    },
    /// Tells what depends on what, for Graphviz
    ///
    /// Definitions and effects in the order of the source, with an arrow from each to what it
    /// uses. Nothing is evaluated.
    #[command(after_help = "\
Examples:
  virote graph bottle.geo | dot -Tsvg -o bottle.svg
  virote graph bottle.geo --json    {\"nodes\": [{\"name\": \"neck\", \"kind\": \"param\", \"uses\": []}]}")]
    Graph {
        /// The script; `-` is standard input
        file: PathBuf,
        /// Writes JSON
        #[arg(long)]
        json: bool,
        #[command(flatten)]
        talk: OutputArgs,
    },
    /// Rewrites scripts in canonical form
    ///
    /// The meaning stays, and so do comments and blank lines. A script with a syntax error is left
    /// as it is. A file is rewritten whole or not at all, and only if that changes it.
    #[command(after_help = "\
Examples:
  virote fmt bottle.geo           rewrites the file
  virote fmt --check *.geo        tells which files are not in canonical form; exit code 1 if any
  virote fmt - < a.geo > b.geo    from standard input to standard output")]
    Fmt {
        /// The scripts; `-` is standard input, which is written to standard output
        #[arg(required = true)]
        files: Vec<PathBuf>,
        /// Writes nothing, but lists the files that would change
        #[arg(long)]
        check: bool,
        #[command(flatten)]
        talk: OutputArgs,
    },
    /// Carries a script out again whenever it is saved, or a file that it reads
    ///
    /// Only what the change touched is evaluated again. Ctrl-C ends.
    #[command(after_help = "\
Examples:
  virote watch bottle.geo --out build
  virote watch bottle.geo --check          writes no file")]
    Watch(watch::WatchOptions),
    /// Serves an editor, which starts it by itself (language server protocol over standard input)
    ///
    /// docs/editors.md says how editors are told of it.
    Lsp(lsp::LspOptions),
    /// Shows a script in the browser, and keeps the picture current while it is written
    ///
    /// Serves a page on this machine alone, prints its address and opens the browser. The page turns the
    /// model, has a control for each parameter, and answers questions about any point. No file is
    /// written unless the page is asked to. Ctrl-C ends.
    #[command(after_help = "\
Examples:
  virote view bottle.geo
  virote view bottle.geo --set neck=15mm --port 8123 --no-open
  virote view bottle.geo --export bottle.html   one file that shows the model anywhere")]
    View(view::ViewOptions),
    /// Explains a built-in, lists a chapter or all of them, or searches
    #[command(after_help = "\
Examples:
  virote doc                     every built-in, by chapter
  virote doc circle              one of them
  virote doc surfaces            a chapter
  virote doc param               a word of the language; `virote doc language` is all of it
  virote doc closest surface     those that are about both words, the best first
  virote doc --search length     those that are about a word that is a name itself")]
    Doc {
        /// A built-in, a chapter, or words to search for
        #[arg(value_name = "WORD")]
        words: Vec<String>,
        /// Searches for the words, whatever their names
        #[arg(long, requires = "words")]
        search: bool,
    },
    /// Explains the code of a message
    #[command(after_help = "Example: virote explain E0602")]
    Explain {
        /// The code, such as E0602; without one all codes are listed
        code: Option<String>,
    },
    /// Writes the completions of a shell to standard output
    #[command(after_help = "\
Examples:
  virote completions bash > ~/.local/share/bash-completion/completions/virote
  virote completions zsh > ~/.zfunc/_virote
  virote completions fish > ~/.config/fish/completions/virote.fish")]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Writes a manual page to standard output
    #[command(after_help = "\
Examples:
  virote man > ~/.local/share/man/man1/virote.1
  virote man run | man -l -")]
    Man {
        /// A verb of the command
        verb: Option<String>,
    },
}
