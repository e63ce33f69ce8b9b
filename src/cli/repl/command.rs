//! Commands of the prompt: what begins with a colon.

use std::path::Path;

use super::{
    super::{
        explain,
        reporter::{counted, pretty},
        standard_streams::say,
    },
    graph, options,
    prompt::Prompt,
    show,
};
use crate::{
    diag::nearest,
    docs,
    export::View,
    ide::{Outline, sized},
    syntax::StatementRole,
    value::Value,
};

/// A command.
pub(super) struct Command {
    pub(super) name: &'static str,
    /// What stands behind it.
    pub(super) takes: &'static str,
    pub(super) docs: &'static str,
    pub(super) takes_file: bool,
    run: fn(&mut Prompt, &str),
}

impl Command {
    /// All that there is to say of it.
    fn entry(&self) -> String {
        let head = format!(":{} {}", self.name, self.takes);
        format!("{}\n\n{}\n", head.trim_end(), self.docs)
    }
}

/// Every command, by name.
pub(super) const COMMANDS: &[Command] = &[
    command("export", "[EXPR to \"FILE\"]", "writes a file, or those of the document", export),
    command(
        "help",
        "[NAME]",
        "tells about a built-in, a definition, a code, a command; also `?NAME`",
        help,
    ),
    command("list", "", "lists the document's definitions", list),
    file_command("load", "FILE", "puts a script into the place of the document", |prompt, rest| {
        if rest.is_empty() {
            prompt.refuse("which file? `:load FILE`");
        } else {
            prompt.load(Path::new(rest));
        }
    }),
    command(
        "plot",
        "EXPR, ... [in A..B]",
        "plots functions, a curve, a list, a table",
        graph::plot,
    ),
    command("quit", "", "ends, as Ctrl-D does", |prompt, _| prompt.is_over = true),
    file_command("save", "[FILE]", "writes the document as a script", |prompt, rest| {
        prompt.save(rest, false);
    }),
    file_command("save!", "FILE", "the same in the place of another file", |prompt, rest| {
        prompt.save(rest, true);
    }),
    command(
        "set",
        "[NAME VALUE]",
        "tells the options of the session, or changes one",
        options::set,
    ),
    command("show", "EXPR [VIEW]", "tells all of a value and draws it, as seen from `front`", show),
    command("time", "EXPR", "evaluates and tells how long it took", time),
    command("type", "EXPR", "tells the kind of a value", kind),
    command("undo", "", "goes back to the document before", undo),
];

const fn command(
    name: &'static str,
    takes: &'static str,
    docs: &'static str,
    run: fn(&mut Prompt, &str),
) -> Command {
    Command { name, takes, docs, takes_file: false, run }
}

const fn file_command(
    name: &'static str,
    takes: &'static str,
    docs: &'static str,
    run: fn(&mut Prompt, &str),
) -> Command {
    Command { takes_file: true, ..command(name, takes, docs, run) }
}

/// Does what a command wants; an unknown one is told with the nearest.
pub(super) fn run(prompt: &mut Prompt, text: &str) {
    let text = text.trim();
    let (name, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    match known(name) {
        Some(Command { name, takes: "", .. }) if !rest.trim().is_empty() => {
            prompt
                .refuse(&format!("`:{name}` stands alone; found `{}`", show::cut(rest.trim(), 40)));
        }
        Some(command) => (command.run)(prompt, rest.trim()),
        None => prompt.refuse(&unknown(name)),
    }
}

/// The command of a name; the beginning of one name alone is that name: `:q`.
fn known(name: &str) -> Option<&'static Command> {
    let mut beginning =
        COMMANDS.iter().filter(|command| !name.is_empty() && command.name.starts_with(name));
    let exact = COMMANDS.iter().find(|command| command.name == name);
    exact.or_else(|| match (beginning.next(), beginning.next()) {
        (Some(only), None) => Some(only),
        _ => None,
    })
}

/// That there is no such command.
fn unknown(name: &str) -> String {
    let near = nearest(name, COMMANDS.iter().map(|command| command.name));
    let near = near.map_or_else(
        || "; `:help` lists them".to_owned(),
        |near| format!("; did you mean `:{near}`?"),
    );
    format!("there is no command `:{}`{near}", show::cut(name, 40))
}

fn help(prompt: &mut Prompt, name: &str) {
    if name.is_empty() {
        let mut text = String::from(
            "Statements join the document; a new definition takes the place of its namesake.\nExpressions are answered; `_` is the last value, as `f(_)` too; in `f(_, 2)` it makes a function.\n\n",
        );
        for command in COMMANDS {
            let head = format!(":{} {}", command.name, command.takes);
            text.push_str(&format!("  {:<26} {}\n", head.trim_end(), command.docs));
        }
        text.push_str("\n`virote doc` lists the built-ins.\n");
        return say(&text);
    }
    if let Some(command) = name.strip_prefix(':') {
        return match known(command) {
            Some(command) => say(&command.entry()),
            None => prompt.refuse(&unknown(command)),
        };
    }
    let own = prompt.values.value(name);
    if let Some(value) = own {
        let outline = Outline::of(prompt.engine.session(), &prompt.document.definitions());
        let docs = outline.of_file().find(|own| own.name == name).and_then(|own| own.docs.as_ref());
        let docs = docs.map(|docs| format!("\n{docs}\n")).unwrap_or_default();
        say(&format!("{}\n{docs}", show::line(name, value, prompt.unit)));
    }
    let registry = prompt.engine.session().registry();
    let code = explain::entry(name);
    let command = COMMANDS.iter().find(|command| command.name == name).map(Command::entry);
    let word = || docs::language::entry(name);
    match docs::entry(registry, name).or(code).or(command).or_else(word) {
        Some(text) => say(&text),
        None if own.is_some() => {}
        None => {
            let mut names: Vec<&str> = registry.names().collect();
            names.extend(prompt.defined().map(|(own, _)| own));
            docs::language::topics().for_each(|word| names.push(word));
            let near = nearest(name, names);
            let near = near.map(|near| format!("; did you mean `{near}`?")).unwrap_or_default();
            prompt.refuse(&format!("nothing is called `{}`{near}", show::cut(name, 40)));
        }
    }
}

fn list(prompt: &mut Prompt, _: &str) {
    if prompt.document.is_empty() {
        return prompt.voice.remark("(the document is empty)");
    }
    let text: String = prompt
        .defined()
        .map(|(name, value)| format!("{}\n", show::line(name, value, prompt.unit)))
        .collect();
    say(&text);
    let others = [
        (StatementRole::Check, "check"),
        (StatementRole::Export, "export"),
        (StatementRole::Test, "test"),
    ];
    let others: Vec<String> = others
        .into_iter()
        .map(|(role, noun)| (prompt.document.count(role), noun))
        .filter(|&(n, _)| n > 0)
        .map(|(n, noun)| counted(n, noun))
        .collect();
    if !others.is_empty() {
        say(&format!("({})\n", others.join(", ")));
    }
}

fn show(prompt: &mut Prompt, text: &str) {
    let (text, view) = seen_from(text);
    for value in prompt.asked("show", text).unwrap_or_default() {
        say(&show::whole(&value, prompt.unit, prompt.columns, view));
    }
}

/// An expression, and the view whose name stands behind it.
fn seen_from(text: &str) -> (&str, Option<View>) {
    let Some((expr, name)) = text.rsplit_once(char::is_whitespace) else { return (text, None) };
    let expr = expr.trim_end();
    // Behind an operator it is a name of the document.
    let last = expr.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default();
    let is_whole = expr.ends_with([')', ']', '}', '"'])
        || !last.is_empty()
            && !matches!(last, "and" | "or" | "not" | "if" | "then" | "else" | "in" | "within");
    match View::from_name(name).filter(|_| is_whole) {
        Some(view) => (expr, Some(view)),
        None => (text, None),
    }
}

fn kind(prompt: &mut Prompt, text: &str) {
    for value in prompt.asked("type", text).unwrap_or_default() {
        let phrase = match &value {
            Value::Function(function) => {
                format!("a function: {}", function.signatures().join("\nor: "))
            }
            Value::Curve(_)
            | Value::Surface(_)
            | Value::Region(_)
            | Value::Face(_)
            | Value::Solid(_)
            | Value::Mesh(_)
            | Value::Table(_) => {
                format!("a {value}")
            }
            Value::Record(_) => format!("a {}", sized(&value)),
            Value::Number(number) if number.dim.is_bare() => "a number".to_owned(),
            Value::Number(number) => number.dim.to_string(),
            Value::Bool(_) => "a truth value".to_owned(),
            Value::Text(_) => "a string".to_owned(),
            _ => value.phrase(),
        };
        say(&format!("{phrase}\n"));
    }
}

fn time(prompt: &mut Prompt, text: &str) {
    if text.is_empty() {
        return prompt.refuse("of what? `:time EXPR`");
    }
    if let Some((printed, time)) = prompt.ask(text) {
        printed.iter().for_each(|printed| prompt.answer(&printed.value));
        say(&format!("({})\n", pretty(time)));
    }
}

fn undo(prompt: &mut Prompt, _: &str) {
    let Some((document, last)) = prompt.undo.pop() else {
        return prompt.refuse("there is nothing to undo");
    };
    let text = document.text();
    let told = std::mem::take(&mut prompt.told);
    // What held before holds again, unless a file that it reads has changed.
    match prompt.evaluate("", '\n', &text, ["document", "document"]) {
        Some(ran) => {
            let mut gone: Vec<String> = prompt.defined().map(|(name, _)| name.to_owned()).collect();
            prompt.know(ran.report);
            prompt.document = document;
            // What was asked since may use what is gone.
            prompt.last = last;
            gone.retain(|name| prompt.values.value(name).is_none());
            let n = counted(prompt.defined().count(), "definition");
            let without = if gone.is_empty() { "" } else { ", without " };
            prompt.voice.remark(&format!("(back to {n}{without}{})", gone.join(", ")));
        }
        None => {
            prompt.told = told;
            prompt.undo.push(document, last);
        }
    }
}

fn export(prompt: &mut Prompt, text: &str) {
    let (base, input) = if text.is_empty() {
        if prompt.document.count(StatementRole::Export) == 0 {
            return prompt.refuse("the document exports nothing; `:export EXPR to \"FILE\"`");
        }
        (prompt.document.with_exports(), String::new())
    } else {
        (prompt.document.definitions(), format!("export {text}"))
    };
    if let Some(mut ran) = prompt.evaluate(&base, '\n', &input, ["document", "input"]) {
        ran.report.diagnostics.clear();
        prompt.act(&mut ran.report);
    }
}
